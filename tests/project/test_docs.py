"""Pages of the documentation say what the files, the solver and the library say."""

import re
import runpy
from pathlib import Path

import pytest
import yaml

import thirdbody
from thirdbody.core.regimes import WITHOUT_VALUES
from thirdbody.variables import FLAGS, STATUS_MEANINGS

ROOT = Path(__file__).parents[2]
DOCS = ROOT / "docs"
TOOL = runpy.run_path(DOCS / "readme_numbers.py")
MODEL = (DOCS / "model.md").read_text(encoding="utf-8")


@pytest.mark.parametrize(
    ("page", "block"), [("README.md", "library"), ("docs/model.md", "variables")]
)
def test_a_page_has_what_its_command_prints(page, block):
    text = (ROOT / page).read_text(encoding="utf-8")
    assert TOOL["BLOCKS"][block]() in text


def test_each_key_of_the_configuration_is_explained():
    reference = runpy.run_path(DOCS / "configuration_reference.py")
    rows = [line.strip("| \n").split(" | ") for line in reference["configuration"]().splitlines()]
    table = {row[0].strip("`"): row[1:] for row in rows[2:]}
    settings = yaml.safe_load((ROOT / "config/config.yaml").read_text(encoding="utf-8"))
    assert {*settings} <= {*table} and all(len(row) == 2 and all(row) for row in table.values())
    assert table["scenes.NAME.curves[].viscosity_cSt"] == [
        "kinematic viscosity nu [cSt], 0 when dry",
        "list of 1 or more: 0, or number from 0.3 to 100000",
    ]
    assert table["windows.particle_density_per_m2"][1] == "number from 1e+06 to 1e+15"
    assert "| `plastic_interference_ratio` | ω₂/ω₁ | 1 | assumed |" in reference["inputs"]()


def test_the_page_and_the_files_explain_each_status_once_and_alike():
    row = r"^\| `(\w+)` \| ([^|]+) \| (given|nan; regime and mode -1) \|$"
    rows = re.findall(row, MODEL, re.M)
    assert [(name, text) for name, text, _ in rows] == list(STATUS_MEANINGS.items())
    assert tuple(name for name, _, values in rows if values != "given") == WITHOUT_VALUES
    flag = FLAGS["solution_status"]
    assert flag.meanings == tuple(STATUS_MEANINGS)
    assert flag.comment.split("; ") == [": ".join(row[:2]) for row in rows]


def test_the_reference_has_each_public_name_once():
    documented = re.findall(r"^   thirdbody\.([\w.]+)$", (DOCS / "api.md").read_text("utf-8"), re.M)
    names = {*thirdbody.__all__} - {"__version__", "lab"}
    names |= {f"lab.{name}" for name in thirdbody.lab.__all__}
    assert sorted(documented) == sorted(names)


def test_the_measurements_are_what_their_generator_writes(tmp_path):
    source = (DOCS / "examples" / "make_measured.py").read_text(encoding="utf-8")
    exec(compile(source, "make", "exec"), {"__file__": str(tmp_path / "make_measured.py")})
    written = (tmp_path / "measured.csv").read_text(encoding="utf-8")
    assert written == (DOCS / "examples" / "measured.csv").read_text(encoding="utf-8")


@pytest.mark.parametrize(
    ("page", "run", "same"),
    [
        ("takes 1.2 µs", "takes  3.5 µs", True),
        ("takes 1.2 µs", "takes 3.7 µs", False),
        ("takes 1.2 µs", "took 1.2 µs", False),
        ("1e-05 of 0", "1e-05 of 1", False),
        ("1 and 2", "1 and", False),
    ],
)
def test_measured_numbers_agree_up_to_a_factor(page, run, same):
    assert TOOL["agree"](page, run) == same
