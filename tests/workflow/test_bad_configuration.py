"""Bad configuration is refused in one line, before any job starts, and harms nothing."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from functools import partial
from pathlib import Path

from workspace import ABSENT, ROOT, run_side_by_side, with_value

from thirdbody.configuration.plain_yaml import read_yaml

CONFIG = "config/config.yaml"
SCENES = "config/scenes.yaml"
INPUTS = "config/inputs.yaml"
ACCURACY = "config/accuracy.yaml"
ATLAS = "config/atlas.yaml"
CALIBRATION = "config/calibration.yaml"
SENSITIVITY = "config/sensitivity.yaml"
SECOND = "config/second.yaml"
CALIBRATED = read_yaml(ROOT / CONFIG)["calibrated"]


@dataclass(frozen=True)
class Case:
    """A spoilt configuration and what the one line must say: key or file, value, allowed."""

    name: str
    spoil: Callable[[Path], None]
    words: tuple[str, ...]
    arguments: tuple[str, ...] = ()


def put(name, file, key, value, *words):
    """Another value of a key, or none."""

    def spoil(root):
        path = root / file
        path.write_text(with_value(path.read_text(encoding="utf-8"), key, value), encoding="utf-8")

    return Case(name, spoil, words)


def text(name, file, content, *words):
    """A file with other content, or with more where ``content`` begins with a line break."""

    def spoil(root):
        path = root / file
        before = path.read_bytes() if content.startswith(b"\n") else b""
        path.write_bytes(before + content)

    return Case(name, spoil, words)


def second(name, content, *words):
    """A file given with --configfile."""
    made = text(name, SECOND, content, *words)
    return Case(made.name, made.spoil, words, ("--configfile", SECOND))


def given(name, argument, *words):
    """A key given with --config."""
    return Case(name, lambda root: None, words, ("--config", argument))


def changes(name, content, *words):
    """A file of changes given with --config changes=."""
    made = text(name, "mine.yaml", content, *words)
    return Case(made.name, made.spoil, words, ("--config", "changes=mine.yaml"))


def without(name, file):
    return Case(name, lambda root: (root / file).unlink(), (file, "allowed"))


CASES = [
    put("unknown key", CONFIG, "colour", "red", "'colour'", "inputs, load_axis"),
    put("misspelt key", SCENES, "load_axis/cuont", 9, "load_axis", "'cuont'", "count"),
    changes("inputs outside config", b"inputs: soft.yaml\n", "inputs", "'soft.yaml'", "in config/"),
    changes(
        "inputs that a surface cannot have in the ensemble",
        b"inputs: {summit_offset: true, summit_parameter: 0.02906}\n",
        "inputs in member ",
        "of config/calibrated/",
        "summit_parameter is 0.0",
        "allowed: above 0.019",
    ),
    put(
        "calibrated, of none", CALIBRATED, "interpretation", "mine", CALIBRATED, "'mine'", "allowed"
    ),
    put("no such entry", INPUTS, "truncation", ABSENT, INPUTS, "truncation", "allowed"),
    put("no such formula", "config/paper_tables.yaml", "table1/0/recompute", "x", "table1", "'x'"),
    text("damaged calibration", CALIBRATION, b"\na: [\n", "calibration.yaml", "line"),
    put("unknown of no kind", CALIBRATION, "always/0", "gap", CALIBRATION, "always[0]", "'gap'"),
    put("reversed loads", SENSITIVITY, "load_N", [80, 1], SENSITIVITY, "load_N", "below"),
    put("accuracy of a bad rtol", ACCURACY, "rtol", [1], ACCURACY, "rtol[0]", "1", "at most 0.01"),
    put("no accuracy file", CONFIG, "accuracy", "config/none.yaml", "config/none.yaml", "allowed"),
    put("atlas of idle jobs", ATLAS, "chunks", 26, ATLAS, "chunks", "26", "at most 25"),
    without("missing atlas", ATLAS),
    text("key twice", CONFIG, b"\nrtol: 1.0e-8\n", CONFIG, "'rtol' stands twice"),
    text("template", CONFIG, b"\n__use_yte__: true\n", "unknown key '__use_yte__'", "allowed"),
    text("not UTF-8", CONFIG, b"\nrtol: \xff\n", CONFIG, "UTF-8"),
    text("empty file", CONFIG, b"", CONFIG, "keys with values"),
    without("missing configuration", CONFIG),
    second("second file: value", b"rtol: 3\n", "rtol", "3", "at most 0.01"),
    second("second file: alias", b"a: &a [1]\nb: *a\n", SECOND, "anchor a", "plain values"),
    second("second file: scene", b"scenes: {fig03: {curves: []}}\n", "fig03.curves", "[]"),
    given("value on the command line", "rtol=much", "rtol", "'much'", "a number"),
    given("run that is no word", "run=../soft", "run is '../soft'", "a plain word"),
    given("run called like a folder of products", "run=figures", "run is 'figures'", "no folder"),
    given(
        "number in braces", "inputs={truncation: 2.5}", "inputs.truncation is '2.5'", "in braces"
    ),
    given("changes that are not there", "changes=none.yaml", "none.yaml", "a readable YAML file"),
    given("changes that are a number", "changes=3", "changes is 3", "the path of a YAML file"),
]


def spoilt(case: Case, root: Path) -> None:
    """The configuration of ``case``, in a repository with something made before."""
    kept = root / "results/datasets/fig03.nc"
    kept.parent.mkdir(parents=True)
    kept.write_bytes(b"made before")
    case.spoil(root)


def test_each_is_refused_in_one_line_that_names_key_value_and_what_is_allowed(sources, tmp_path):
    runs = [(partial(spoilt, case), case.arguments) for case in CASES]
    faults = []
    for case, (code, said, harmless) in zip(
        CASES, run_side_by_side(sources, tmp_path, runs), strict=True
    ):
        line = said[0] if len(said) == 1 else ""
        if not (code and harmless and line and all(word in line for word in case.words)):
            faults.append(f"{case.name}: {case.words} in {said}, exit code {code}, {harmless=}")
    assert not faults, "\n".join(faults)
