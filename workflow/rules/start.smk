# Before anything else: whether this can run here, in one line; and what the terminal shows.
import logging
import re
import sys
from pathlib import Path

# whether the library is there, and whether it is that of this checkout
BESIDE = Path(workflow.basedir) / "src/thirdbody"
INSTALL = f'pip install "{workflow.basedir if BESIDE.is_dir() else "thirdbody"}[workflow]"'
try:
    import thirdbody
except ModuleNotFoundError:
    sys.exit(f"thirdbody is not installed for {sys.executable}; allowed: {INSTALL}")
if BESIDE.is_dir() and not BESIDE.samefile(Path(thirdbody.__file__).parent):
    sys.exit(
        f"the library is {Path(thirdbody.__file__).parent}; allowed: that of this checkout, by PYTHONPATH=src"
    )
try:
    import grimp

    from thirdbody import version
    from thirdbody.paper.configuration.settings import read_settings
    from thirdbody.plain_yaml import config_directory, read_yaml
except ModuleNotFoundError as missing:
    sys.exit(f"{missing.name} is not installed for {sys.executable}; allowed: {INSTALL}")

# Snakemake does not quote the interpreter of a script
if not re.fullmatch(r"[\w/.,:@%+~-]+", sys.executable):
    sys.exit(
        f"the path {sys.executable} has a blank or a sign of the shell; allowed: a folder whose path has none"
    )

# on a full disk, lines that do not fit into Snakemake's log are dropped
logging.raiseExceptions = False

FILES_NAMED = 3  # in the reason of a job; a first run would name all files of the workflow


def in_a_line(record):
    """Whether a record of Snakemake is to be printed: not that jobs are selected, and reasons with few files."""
    shortened = []
    for clause in filter(None, (getattr(record, "reason", None) or "").split("; ")):
        what, _, files = clause.partition(": ")
        first, others = files.split(", ")[:FILES_NAMED], files.split(", ")[FILES_NAMED:]
        named = ", ".join(first) + (f" and {len(others)} more" if others else "")
        shortened.append(f"{what}: {named}" if files else what)
    if shortened:
        record.reason = "; ".join(shortened)
    return not str(record.msg).startswith(("Select jobs to execute", "Execute "))


logging.getLogger("snakemake.logging").addFilter(in_a_line)
