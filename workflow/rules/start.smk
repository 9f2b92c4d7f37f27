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

    from chenhorng.configuration.settings import read_settings
    from chenhorng.home import config_directory
    from thirdbody.plain_yaml import read_yaml
except ModuleNotFoundError as missing:
    sys.exit(f"{missing.name} is not installed for {sys.executable}; allowed: {INSTALL}")

# Snakemake does not quote the interpreter of a script
if not re.fullmatch(r"[\w/.,:@%+~-]+", sys.executable):
    sys.exit(
        f"the path {sys.executable} has a blank or a sign of the shell; allowed: a folder whose path has none"
    )

# on a full disk, lines that do not fit into Snakemake's log are dropped
logging.raiseExceptions = False

WORDY = "Union of exclusive params before and now across all output: "
FILE_TEXT = re.compile(r"'([^' ]+) [0-9a-f]{8}'")  # of `file_text`
FILES_NAMED = 3  # in the reason of a job
# reasons that are not told: there is no product yet, or another job of the run has its own
FOLLOWS = "Missing output files", "Input files updated by another job"


class OneLine(logging.Formatter):
    """What a job does and why, in one line; all else as Snakemake writes it."""

    def __init__(self, of_snakemake):
        super().__init__()
        self.of_snakemake = of_snakemake

    def format(self, record):
        does, reason = (getattr(record, name, None) for name in ("rule_msg", "reason"))
        if not does or reason is None:
            return self.of_snakemake.format(record)
        causes = [each for each in reason.split("; ") if not each.startswith(FOLLOWS)]
        return f"{does} ({'; '.join(map(self.shortened, causes))})" if causes else does

    def shortened(self, clause):
        """A clause of a reason with a few files: those in it, or those whose texts in the parameters differ; of
        other parameters both values."""
        what, _, rest = clause.replace(WORDY, "").partition(": ")
        values = [rest] if what.startswith("Params") else rest.split(", ")
        files = [*dict.fromkeys(FILE_TEXT.findall(rest))] or values
        more = f" and {len(files) - FILES_NAMED} more" if len(files) > FILES_NAMED else ""
        return f"{what}: {', '.join(files[:FILES_NAMED])}{more}" if rest else what


def is_told(record):
    """Whether a record of Snakemake is to be printed: not that jobs are selected."""
    return not str(record.msg).startswith(("Select jobs to execute", "Execute "))


LOG = logging.getLogger("snakemake.logging")
LOG.addFilter(is_told)
for handler in LOG.handlers:
    if handler.formatter:
        handler.setFormatter(OneLine(handler.formatter))
