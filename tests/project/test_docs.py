"""Pages of the documentation say what the files, the solver and the library say."""

import io
import pydoc
import re
import runpy
from contextlib import redirect_stdout
from pathlib import Path

import numpy as np
import pandas as pd
import pytest
import yaml
from matplotlib.pyplot import imread

import thirdbody
from thirdbody.core.regimes import WITHOUT_VALUES
from thirdbody.plotting.styles import level_styles
from thirdbody.variables import FLAGS, STATUS_MEANINGS

ROOT = Path(__file__).parents[2]
DOCS = ROOT / "docs"
TOOL = runpy.run_path(DOCS / "readme_numbers.py")
README = (ROOT / "README.md").read_text(encoding="utf-8")
MODEL = (DOCS / "model.md").read_text(encoding="utf-8")


def test_the_readme_has_what_its_example_prints():
    """The digits shown: a number of the page is the one computed, rounded."""
    (code,) = re.findall(r"```python\n(.*?)```", README, re.DOTALL)
    (printed,) = re.findall(r"<!-- library -->\n```text\n(.*?)```", README, re.DOTALL)
    with redirect_stdout(io.StringIO()) as precise, pd.option_context("display.precision", 15):
        exec(code, {})
    shown, computed = printed.split(), precise.getvalue().split()
    assert len(shown) == len(computed)
    for text, value in zip(shown, computed):
        if "." not in text:
            assert text == value
        else:
            half = 0.5 * 10.0 ** -len(text.partition(".")[2])
            assert abs(float(text) - float(value)) <= half + 1e-9 * abs(float(value))


@pytest.mark.parametrize(
    ("page", "runs", "same"),
    [
        ("0.125 of 3", ["0.125 of 3"] * 3, True),
        ("0.12 of 3", ["0.12 of 3", "0.13 of 3", "0.13 of 3"], True),  # computed 0.125: an edge
        ("0.13 of 3", ["0.12 of 3"] * 3, False),
        ("0.12 of 4", ["0.12 of 3", "0.13 of 3", "0.13 of 3"], False),
        ("0.12 or 3", ["0.12 of 3"] * 3, False),
    ],
)
def test_a_page_shows_the_digits_of_the_run(page, runs, same):
    assert TOOL["show_the_same"](page, runs) == same


def test_a_number_at_an_edge_is_rounded_both_ways():
    page = "<!-- share -->\nold\n<!-- /share -->\n"
    down, up, new = TOOL["at_edges"](page, {"share": lambda move: f"{0.125 * (1.0 + move):.2f}"})
    assert [text.split()[3] for text in (down, up, new)] == ["0.12", "0.13", "0.12"]


def shifted(picture):
    """One column of pixels is moved by one."""
    return np.concatenate([picture[:, :900], picture[:, 899:-1]], axis=1)


def without_a_curve(picture):
    """All in the colour of one of the oils is white."""
    colour = level_styles(6)[4]["color"][:3]
    curve = np.abs(picture[..., :3] - colour).max(axis=-1) < 0.1
    assert curve.any()
    return np.where(curve[..., np.newaxis], 1.0, picture)


def with_other_shades(picture):
    """Three pixels differ by one step of 255."""
    changed = picture.copy()
    changed[100:103, 200, :3] -= 1.0 / 255.0
    return changed


@pytest.mark.parametrize(
    ("change", "same"), [(shifted, False), (without_a_curve, False), (with_other_shades, True)]
)
def test_a_picture_is_the_same_up_to_a_few_shades(change, same):
    picture = imread(DOCS / "figure11.png")
    assert TOOL["look_the_same"](picture, picture)
    assert TOOL["look_the_same"](picture, change(picture)) == same


def test_help_has_the_sections_and_indents_of_numpydoc():
    """In all versions of Python: 3.13 takes the indents of docstrings away, others keep them."""
    text = pydoc.plain(pydoc.render_doc(thirdbody.solve))
    assert "\n    Parameters\n    ----------\n    load, load_N : array_like\n        The " in text
    assert "\n    rtol : float\n        Requested" in text
    lines = [line for line in text.splitlines() if line.strip()]
    assert {len(line) - len(line.lstrip()) for line in lines} == {0, 4, 8}
    sections = re.findall(r"^    (\w+)\n    (-+)$", text, re.MULTILINE)
    assert [name for name, _ in sections][:3] == ["Parameters", "Returns", "Raises"]
    assert all(len(name) == len(line) for name, line in sections)


def test_each_key_of_the_configuration_is_explained():
    reference = runpy.run_path(DOCS / "configuration_reference.py")
    rows = [line.strip("| \n").split(" | ") for line in reference["configuration"]().splitlines()]
    table = {row[0].strip("`"): row[1:] for row in rows[2:]}
    settings = yaml.safe_load((ROOT / "config/config.yaml").read_text(encoding="utf-8"))
    assert {*settings} <= {*table} and all(len(row) == 2 and all(row) for row in table.values())
    assert table["scenes.NAME.curves[].viscosity_cSt"] == [
        "kinematic viscosity nu [cSt], 0 when dry",
        "list of 1 or more: number from 0 to 100000; 0, or 0.3 or more; different values",
    ]
    assert table["windows.particle_density_per_m2"][1] == "number from 0 to 1e+15; above 0"
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
    names = {*thirdbody.__all__} - {"__version__"}
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
