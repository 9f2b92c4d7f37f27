"""Bad configuration is refused in one line, before any job starts, and harms nothing."""

from __future__ import annotations

import os
from collections.abc import Callable
from concurrent.futures import Future, ProcessPoolExecutor
from dataclasses import dataclass
from multiprocessing import get_context
from pathlib import Path

import pytest
from workspace import ABSENT, Workspace, run_here, with_value

CONFIG = "config/config.yaml"
SCENES = "config/scenes.yaml"
INPUTS = "config/inputs.yaml"
ACCURACY = "config/accuracy.yaml"
ATLAS = "config/atlas.yaml"
CALIBRATION = "config/calibration.yaml"
SENSITIVITY = "config/sensitivity.yaml"
SECOND = "config/second.yaml"
# what a run makes that ought to be refused and is not
CHEAP = "results/extracted/table1/all.csv"
# what Snakemake says about its own settings before it reads the workflow
ANNOUNCEMENTS = ("Using workflow specific profile", "Config file config/")


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


def inputs(name, content, *words):
    """Inputs of one's own, in place of those of the repository."""

    def spoil(root):
        (root / "config/mine.yaml").write_bytes(content)
        put(name, CONFIG, "inputs", "config/mine.yaml").spoil(root)

    return Case(name, spoil, words)


def calibrated(name, old, new, *words):
    """A calibrated file of one's own, in which ``old`` text is ``new``."""

    def spoil(root):
        shipped = root / "config/calibrated/uncentred_surface_wide_full.yaml"
        changed = shipped.read_text(encoding="utf-8").replace(old, new)
        (root / "config/own.yaml").write_text(changed, encoding="utf-8")
        put(name, CONFIG, "calibrated", "config/own.yaml").spoil(root)

    return Case(name, spoil, words)


def changes(name, content, *words):
    """A file of changes given with --config changes=."""
    made = text(name, "mine.yaml", content, *words)
    return Case(made.name, made.spoil, words, ("--config", "changes=mine.yaml"))


def without(name, file):
    return Case(name, lambda root: (root / file).unlink(), (file, "allowed"))


GROUP = "scenes/fig10/curves/0"
GROUP_SHOWN = "scenes.fig10.curves[0]"
CASES = [
    # keys
    put("unknown key", CONFIG, "colour", "red", "'colour'", "inputs, load_axis"),
    put("misspelt key", SCENES, "load_axis/cuont", 9, "load_axis", "'cuont'", "count"),
    put("wrong unit", SCENES, f"{GROUP}/viscosity_Pas", [0], GROUP_SHOWN, "'viscosity_Pas'", "cSt"),
    put("missing scene", SCENES, "scenes/fig09", ABSENT, "scenes", "'fig09' is missing"),
    put("scene with a figure's name", SCENES, "scenes/fig14", {}, "'fig14'", "small letters"),
    put("scene with a product's name", SCENES, "scenes/claims", {}, "'claims'", "small letters"),
    put(
        "number that YAML takes for text",
        SCENES,
        "scenes/fig03/curves/0/particle_density_per_m2",
        ["1e11"],
        "'1e11'",
        "reads from 1.0e+11",
    ),
    put("scene of a bad name", SCENES, "scenes/Fig 3", {}, "scenes", "'Fig 3'", "allowed"),
    put("scene without curves", SCENES, "scenes/fig03/curves", ABSENT, "fig03", "'curves'"),
    put("scene with no group", SCENES, "scenes/fig03/curves", [], "scenes.fig03.curves", "[]", "1"),
    put("scene without title", SCENES, "scenes/fig03/title", ABSENT, "scenes.fig03", "'title'"),
    put("curves without viscosity", SCENES, f"{GROUP}/viscosity_cSt", ABSENT, GROUP_SHOWN, "cSt"),
    put("curves without density", SCENES, f"{GROUP}/particle_density_per_m2", ABSENT, GROUP_SHOWN),
    put("two sizes", SCENES, f"{GROUP}/particle_diameter_nm", [1], GROUP_SHOWN, "either"),
    put(
        "no size", SCENES, f"{GROUP}/particle_diameter_per_roughness", ABSENT, GROUP_SHOWN, "either"
    ),
    put("no drawing", CONFIG, "schematics/fig02", ABSENT, "schematics", "'fig02' is missing"),
    # types
    put(
        "count is a word", SCENES, "load_axis/count", "many", "load_axis.count", "'many'", "integer"
    ),
    put(
        "count is a fraction", SCENES, "load_axis/count", 24.5, "load_axis.count", "24.5", "integer"
    ),
    put("number in quotes", SCENES, f"{GROUP}/roughness_nm", ["100"], "roughness_nm[0]", "number"),
    put("number for a list", SCENES, f"{GROUP}/roughness_nm", 100, "roughness_nm", "100", "list"),
    put("list for a number", CONFIG, "rtol", [1e-9], "rtol", "[1e-09]", "a number"),
    put("nothing for a number", CONFIG, "rtol", None, "rtol", "None", "a number"),
    put("truth for a number", CONFIG, "rtol", True, "rtol", "True", "a number"),
    put("list of scenes", SCENES, "scenes", [], "scenes", "[]", "keys with values"),
    put("number for a title", SCENES, "scenes/fig03/title", 3, "scenes.fig03.title", "3", "a word"),
    # meaning
    put("negative load", SCENES, "load_axis/load_N", [-0.04, 80], "load_N[0]", "-0.04", "above 0"),
    put("no load", SCENES, "load_axis/load_N", [0, 80], "load_axis.load_N[0]", "0", "above 0"),
    put("reversed loads", SCENES, "load_axis/load_N", [80, 0.04], "load_axis.load_N", "[80, 0.04]"),
    put("equal loads", SCENES, "load_axis/load_N", [1, 1], "load_axis.load_N", "[1, 1]", "below"),
    put("three ends", SCENES, "load_axis/load_N", [1, 2, 3], "load_axis.load_N", "at most 2"),
    put("no counts", SCENES, "load_axis/count", 0, "load_axis.count", "0", "at least 5"),
    put(
        "negative viscosity", SCENES, f"{GROUP}/viscosity_cSt", [-1], "viscosity_cSt[0]", "-1", "0"
    ),
    put("no roughness", SCENES, f"{GROUP}/roughness_nm", [0], "roughness_nm[0]", "0", "at least 1"),
    put("empty list", SCENES, f"{GROUP}/roughness_nm", [], "roughness_nm", "[]", "at least 1"),
    put("value twice", SCENES, f"{GROUP}/roughness_nm", [9, 9], "roughness_nm", "[9, 9]", "twice"),
    put("named load above 1", SCENES, "scenes/fig03/named_loads", [2], "named_loads[0]", "2", "1"),
    put(
        "coverage above 1",
        SCENES,
        "scenes/fig03/curves/0/particle_density_per_m2",
        [2e12],
        "scenes.fig03.curves[0]",
        "2e+12",
        "at most 1",
    ),
    put(
        "coverage above 1 by ratio",
        SCENES,
        f"{GROUP}/particle_diameter_per_roughness",
        [8],
        GROUP_SHOWN,
        "4000 nm",
        "at most 1",
    ),
    put(
        "coverage above 1 in a drawing",
        CONFIG,
        "schematics/fig02/0/particle_diameter_nm",
        4000,
        "schematics.fig02[0]",
        "4000 nm",
        "at most 1",
    ),
    put("rtol of zero", CONFIG, "rtol", 0, "rtol", "0", "at least 1e-11"),
    put("rtol above its range", CONFIG, "rtol", 0.1, "rtol", "0.1", "at most 0.01"),
    put(
        "rtol of a scene", SCENES, "scenes/fig04/rtol", 1e-12, "scenes.fig04.rtol", "1e-12", "1e-11"
    ),
    put("not a number", CONFIG, "rtol", float("nan"), "rtol", "nan", "finite"),
    put("infinite", SCENES, "load_axis/load_N", [1, float("inf")], "load_N[1]", "inf", "finite"),
    put("too few windows", CONFIG, "windows/count", 2, "windows.count", "2", "at least 10"),
    put(
        "reversed windows",
        CONFIG,
        "windows/particle_diameter_per_roughness",
        [2.5, 0.3],
        "windows.particle_diameter_per_roughness",
        "[2.5, 0.3]",
    ),
    put(
        "four panels", CONFIG, "schematics/fig02", [{}, {}, {}, {}], "schematics.fig02", "at most 3"
    ),
    put(
        "line break in a title", SCENES, "scenes/fig03/title", "a\nb", "scenes.fig03.title", "a\\nb"
    ),
    put("line break in a name", SCENES, "scenes/fig03\n", {}, "scenes", "fig03\\n", "allowed"),
    # files named by the configuration
    put("path upwards", CONFIG, "inputs", "config/../../x.yaml", "inputs", "config/../../x.yaml"),
    put("path of the system", CONFIG, "inputs", "/etc/passwd", "inputs", "/etc/passwd", "allowed"),
    put("command for a path", CONFIG, "inputs", "config/$(id).yaml", "inputs", "$(id)", "allowed"),
    put("line break in a path", CONFIG, "inputs", "config/inputs.yaml\n", "inputs", "allowed"),
    put("missing inputs", CONFIG, "inputs", "config/none.yaml", "config/none.yaml", "allowed"),
    changes("inputs outside config", b"inputs: soft.yaml\n", "inputs", "'soft.yaml'", "in config/"),
    changes("inputs of another folder", b"inputs: /tmp/a.yaml\n", "'/tmp/a.yaml'", "in config/"),
    changes("a number as inputs", b"inputs: 3\n", "inputs is 3", "with their values, or the path"),
    changes("inputs without a folder", b"inputs: config/\n", "'config/'", "YAML file in config/"),
    calibrated(
        "calibrated file of no reading",
        "reading: uncentred_surface_wide_full",
        "reading: mine",
        "config/own.yaml: reading is 'mine'",
        "uncentred_summit_wide_full",
    ),
    changes(
        "inputs that a surface cannot have",
        b"inputs: {summit_offset: true, summit_parameter: 0.0195, summit_parameter_exponent: -0.1}\n",
        "inputs: summit_parameter is 0.0",
        "at roughness 4e-07 m",
        "allowed: above 0.019",
    ),
    changes(
        "inputs that a surface cannot have in the ensemble",
        b"inputs: {summit_offset: true, summit_parameter_exponent: 1.6}\n",
        "inputs in member ",
        "of config/calibrated/",
        "summit_parameter is 0.0",
        "allowed: above 0.019",
    ),
    # inputs of the model
    inputs("unknown input", b"colour: 3\n", "config/mine.yaml", "'colour'", "allowed"),
    inputs("input out of bounds", b"truncation: 99.0\n", "truncation", "99.0", "0.5 to 10"),
    inputs("input is not a number", b"truncation: .nan\n", "truncation", "nan", "0.5 to 10"),
    inputs("input is a word", b"truncation: wide\n", "truncation", "'wide'", "a number"),
    inputs("unknown reading", b"film_load: both\n", "film_load", "'both'", "fluid, total"),
    inputs(
        "word for a truth",
        b"summit_offset: 'true'\n",
        "summit_offset",
        "'true'",
        "True, as_rough, False",
    ),
    put("single input out of bounds", CONFIG, "inputs/truncation", 99, "inputs.truncation", "99"),
    put("single input unknown", CONFIG, "inputs/colour", 3, "inputs", "'colour'", "allowed"),
    inputs("damaged inputs", b"truncation: [", "config/mine.yaml", "line 2"),
    put("entry without value", INPUTS, "truncation/value", ABSENT, INPUTS, "truncation", "allowed"),
    put("entry with bounds", INPUTS, "truncation/bounds", [0, 9], INPUTS, "'bounds'", "allowed"),
    put("entry without unit", INPUTS, "truncation/unit", ABSENT, INPUTS, "truncation", "'unit'"),
    put("entry out of its bounds", INPUTS, "truncation/value", 99, INPUTS, "truncation", "99"),
    put("entry of no source", INPUTS, "truncation/source", "hearsay", INPUTS, "source", "assumed"),
    put("bare number as entry", INPUTS, "truncation", 2.5, INPUTS, "truncation", "allowed"),
    put("no such entry", INPUTS, "truncation", ABSENT, INPUTS, "truncation", "allowed"),
    put("one more entry", INPUTS, "colour", {"value": 1.0}, INPUTS, "'colour'"),
    put(
        "reading of no kind", INPUTS, "film_load/value", "both", INPUTS, "film_load", "fluid, total"
    ),
    # printed tables
    put("no printed table", "config/paper_tables.yaml", "table1", ABSENT, "table1", "allowed"),
    put("printed word", "config/paper_tables.yaml", "table1/0/printed", "x", "table1", "allowed"),
    put("no such formula", "config/paper_tables.yaml", "table1/0/recompute", "x", "table1", "'x'"),
    # settings of the calibration
    text("damaged calibration", CALIBRATION, b"\na: [\n", "calibration.yaml", "line"),
    without("missing calibration", CALIBRATION),
    put(
        "reading that fixes too much",
        CALIBRATION,
        "readings/uncentred_summit_wide_full/fixed/participation",
        2.0,
        CALIBRATION,
        "readings.uncentred_summit_wide_full.fixed.participation",
        "2.0",
        "1e-06 to 1",
    ),
    put(
        "unknown of no kind",
        CALIBRATION,
        "always/0",
        "gap_ration",
        CALIBRATION,
        "always[0]",
        "'gap_ration'",
        "gap_ratio, ",
    ),
    put(
        "reversed loads of a study", SENSITIVITY, "load_N", [80, 1], SENSITIVITY, "load_N", "below"
    ),
    put("no timings", ACCURACY, "rounds", 0, ACCURACY, "rounds", "0", "at least 1"),
    put("accuracy of a bad rtol", ACCURACY, "rtol", [1], ACCURACY, "rtol[0]", "1", "at most 0.01"),
    put("no accuracy file", CONFIG, "accuracy", "config/none.yaml", "config/none.yaml", "allowed"),
    without("missing accuracy", ACCURACY),
    put("atlas of idle jobs", ATLAS, "chunks", 26, ATLAS, "chunks", "26", "at most 25"),
    put(
        "axis that falls", ATLAS, "axes/load_N/from", 90, ATLAS, "axes.load_N.from", "less than 80"
    ),
    put("chart off the axes", ATLAS, "charts/load_N/0", 0.2, ATLAS, "charts.load_N[0]", "0.2"),
    put(
        "atlas of a flag", ATLAS, "variables/0", "contact_mode", ATLAS, "variables[0]", "separation"
    ),
    without("missing atlas", ATLAS),
    # YAML
    second("number without a point", b"rtol: 1e-9\n", "rtol", "'1e-9'", "a number"),
    text("key twice", CONFIG, b"\nrtol: 1.0e-8\n", CONFIG, "'rtol' stands twice"),
    text("not YAML", CONFIG, b"\nrtol: [1\n", CONFIG, "line"),
    text("tab", CONFIG, b"\nwindows:\n\tcount: 3\n", CONFIG, "line"),
    text("tag", CONFIG, b"\na: !!python/object/apply:os.getcwd []\n", CONFIG, "tag", "plain"),
    text("alias", CONFIG, b"\na: &a [1]\nb: *a\n", CONFIG, "anchor a", "plain values"),
    text("template", CONFIG, b"\n__use_yte__: true\n", CONFIG, "__use_yte__", "plain values"),
    text("number as key", CONFIG, b"\n3: 4\n", CONFIG, "key 3", "words"),
    text("not UTF-8", CONFIG, b"\nrtol: \xff\n", CONFIG, "UTF-8"),
    text("control character", CONFIG, b"\nrtol: \x00\n", CONFIG, "allowed"),
    text("list at the top", CONFIG, b"- rtol\n", CONFIG, "list", "keys with values"),
    text("empty file", CONFIG, b"", CONFIG, "keys with values"),
    text("deep nesting", CONFIG, b"a: " + 5000 * b"[" + 5000 * b"]", CONFIG, "nested too deeply"),
    without("missing configuration", CONFIG),
    without("missing scenes", SCENES),
    without("missing model inputs", INPUTS),
    # a second file and single keys on the command line
    second("second file: unknown key", b"colour: red\n", "'colour'", "inputs"),
    second("second file: value", b"rtol: 3\n", "rtol", "3", "at most 0.01"),
    second(
        "second file: key twice", b"rtol: 1.0e-8\nrtol: 1.0e-7\n", SECOND, "'rtol' stands twice"
    ),
    second("second file: alias", b"a: &a [1]\nb: *a\n", SECOND, "anchor a", "plain values"),
    second(
        "second file: part of a scene", b"scenes: {fig03: {curves: []}}\n", "fig03.curves", "[]"
    ),
    given("key on the command line", "colour=red", "'colour'", "inputs"),
    given("value on the command line", "rtol=much", "rtol", "'much'", "a number"),
    given("run that is no word", "run=../soft", "run is '../soft'", "a plain word"),
    given("run called like a folder of products", "run=figures", "run is 'figures'", "no folder"),
    given(
        "number in braces on the command line",
        "inputs={truncation: 2.5}",
        "inputs.truncation is '2.5'",
        "in braces after --config",
    ),
    given("changes that are not there", "changes=none.yaml", "none.yaml", "a readable YAML file"),
    given("changes that are a folder", "changes=config", "config: Is a directory", "YAML file"),
    given("changes that are a number", "changes=3", "changes is 3", "the path of a YAML file"),
]


def spoilt(case: Case, sources: Workspace, root: Path) -> Workspace:
    """A repository with something made before, and with the configuration of ``case``."""
    workspace = sources.copied_to(root)
    kept = root / "results/datasets/fig03.nc"
    kept.parent.mkdir(parents=True)
    kept.write_bytes(b"made before")
    case.spoil(root)
    return workspace


def contents(root: Path) -> dict[str, bytes]:
    """Every file but those in which Snakemake keeps its books."""
    files = (path for path in root.rglob("*") if path.is_file())
    return {
        str(path): path.read_bytes()
        for path in files
        if not {".snakemake", "__pycache__"}.intersection(path.parts)
    }


@dataclass
class Attempt:
    """A run on the configuration of a case, under way."""

    root: Path
    before: dict[str, bytes]
    said: Path
    code: Future


@pytest.fixture(scope="module")
def attempts(request, sources, tmp_path_factory) -> dict[str, Attempt]:
    """Runs on all chosen cases, side by side, each in a process of its own."""
    place = tmp_path_factory.mktemp("refused")
    chosen = [item.callspec.params["case"] for item in request.session.items if is_case(item)]
    context = get_context("forkserver")
    context.set_forkserver_preload(["snakemake.cli", "jsonschema", "yte"])
    made = {}
    with ProcessPoolExecutor(os.cpu_count(), context, max_tasks_per_child=1) as pool:
        for number, case in enumerate(chosen):
            root, said = place / str(number), place / f"{number}.txt"
            spoilt(case, sources, root)
            arguments = ("-c1", CHEAP, *case.arguments)
            run = pool.submit(run_here, root, arguments, said)
            made[case.name] = Attempt(root, contents(root), said, run)
        yield made


def is_case(item) -> bool:
    return "attempts" in getattr(item, "fixturenames", ())


@pytest.mark.parametrize("case", CASES, ids=lambda case: case.name)
def test_it_is_refused_in_one_line_that_names_key_value_and_what_is_allowed(case, attempts):
    attempt = attempts[case.name]
    code = attempt.code.result()
    said = attempt.said.read_text(encoding="utf-8", errors="replace").splitlines()
    messages = [line for line in said if line and not line.startswith(ANNOUNCEMENTS)]
    assert code != 0
    assert len(messages) == 1, "\n".join(said)
    assert not [word for word in case.words if word not in messages[0]], messages[0]
    assert contents(attempt.root) == attempt.before
