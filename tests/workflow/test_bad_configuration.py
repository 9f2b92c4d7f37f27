"""Bad configuration is refused in one line, before any job starts, and harms nothing.

What else is refused is in ``unit/test_configuration.py``, which reads files as the Snakefile does.
"""

import pytest

CONFIG = "config/config.yaml"
TARGET = "results/extracted/table1/all.csv"  # what a run makes that is not refused
# what Snakemake says of its own settings before it reads the workflow
ANNOUNCED = ("Using workflow specific profile", "Config file config/")
SECOND, CHANGES = ("--configfile", "mine.yaml"), ("--config", "changes=mine.yaml")
PANEL = b"""schematics:
  fig02:
    - load_N: 1
      viscosity_cSt: 0
      particle_diameter_nm: 100
      roughness_nm: 200
      particle_density_per_m2: 1.0e+11
"""
# a file, what stands at its end, arguments, and what the one line must say: key or file, value, allowed
CASES = {
    "unknown key": (CONFIG, b"colour: red\n", (), ("'colour' was unexpected",)),
    "key twice": (CONFIG, b"rtol: 1.0e-8\n", (), (CONFIG, "duplicate key 'rtol'")),
    "not UTF-8": (CONFIG, b"rtol: \xff\n", (), (CONFIG, "UTF-8")),
    "no configuration": (CONFIG, None, (), (CONFIG, "allowed")),
    "second file": (
        "mine.yaml",
        b"rtol: 3\n",
        SECOND,
        ("rtol: 3 is greater than the maximum of 0.01",),
    ),
    "key twice in it": ("mine.yaml", b"a: 1\na: 2\n", SECOND, ("mine.yaml", "duplicate key 'a'")),
    "no statements": (
        "config/claims.yaml",
        None,
        (),
        ("config/claims.yaml", "a readable YAML file"),
    ),
    "panels": ("mine.yaml", PANEL, CHANGES, ("schematics.fig02: ", "is too short")),
    "changes": ("mine.yaml", b"inputs: soft.yaml\n", CHANGES, ("'soft.yaml'", "in config/")),
    "no changes": (CONFIG, b"", CHANGES, ("mine.yaml", "a readable YAML file")),
    "word": (CONFIG, b"", ("--config", "rtol=much"), ("rtol: 'much' is not of type 'number'",)),
    "run": (CONFIG, b"", ("--config", "run=../soft"), ("run is '../soft'", "a plain word")),
    "braces": (
        *(CONFIG, b"", ("--config", "inputs={truncation: 2.5}")),
        ("inputs.truncation is '2.5'", "a number from"),
    ),
}


def contents(root):
    """Every file but those in which Snakemake and Python keep their books."""
    files = (path for path in root.rglob("*") if path.is_file())
    hidden = {".snakemake", "__pycache__"}
    return {path: path.read_bytes() for path in files if not hidden.intersection(path.parts)}


@pytest.mark.parametrize("case", CASES)
def test_it_is_refused_in_one_line_that_names_key_value_and_what_is_allowed(
    sources, tmp_path, case
):
    file, added, arguments, words = CASES[case]
    workspace = sources.copied_to(tmp_path / "thirdbody")
    path = workspace.root / file
    if added is None:
        path.unlink()
    else:
        path.write_bytes((path.read_bytes() if path.exists() else b"") + added)
    before = contents(workspace.root)
    run = workspace.snakemake("-c1", TARGET, *arguments, config=())
    said = (run.stdout + run.stderr).splitlines()
    (line,) = [each for each in said if each and not each.startswith(ANNOUNCED)]
    assert run.returncode != 0
    assert all(word in line for word in words), line
    assert contents(workspace.root) == before
