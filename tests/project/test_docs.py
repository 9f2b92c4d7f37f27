"""Pages of the documentation say what the files, the solver and the library say."""

import re
import runpy
from pathlib import Path

import pytest

import thirdbody
from thirdbody.core.regimes import WITHOUT_VALUES
from thirdbody.variables import FLAGS, STATUS_MEANINGS

ROOT = Path(__file__).parents[2]
DOCS = ROOT / "docs"
TOOL = runpy.run_path(DOCS / "readme_numbers.py")
MODEL = (DOCS / "model.md").read_text(encoding="utf-8")


def test_the_first_page_has_what_its_example_prints():
    text = (ROOT / "README.md").read_text(encoding="utf-8")
    assert TOOL["BLOCKS"]["library"]() in text


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
