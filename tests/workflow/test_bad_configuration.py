"""Bad configuration is refused in one line, before any job starts, and harms nothing.

What else is refused is in ``tests/paper/test_settings.py``, which reads files as the Snakefile
does.
"""

import pytest

CONFIG = "config/config.yaml"
TARGET = "results/extracted/table1/all.csv"  # what a run makes that is not refused
# what Snakemake says of its own settings before it reads the workflow
ANNOUNCED = ("Using workflow specific profile", "Config file config/")
SECOND, CHANGES = ("--configfile", "mine.yaml"), ("--config", "changes=mine.yaml")
# by case: a file, the text added to its end, the arguments, and what the message must contain:
# the key or the file, the value, and what is allowed
CASES = {
    "key twice": (CONFIG, b"bands: true\n", (), (CONFIG, "duplicate key 'bands'")),
    "second file": (
        "mine.yaml",
        b"rtol: 3\n",
        SECOND,
        ("configuration: rtol is 3; ",),
    ),
    "no statements": (
        "config/claims.yaml",
        None,
        (),
        ("config/claims.yaml", "a readable YAML file"),
    ),
    "no changes": (CONFIG, b"", CHANGES, ("mine.yaml", "a readable YAML file")),
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
    run = workspace.snakemake("-c1", TARGET, *arguments)
    said = (run.stdout + run.stderr).splitlines()
    (line,) = [each for each in said if each and not each.startswith(ANNOUNCED)]
    assert run.returncode != 0
    assert all(word in line for word in words), line
    assert contents(workspace.root) == before
