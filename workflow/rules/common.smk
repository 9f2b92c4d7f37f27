# Shared by the rules: the library, the settings, where files are, and what a job depends on.
import json
import sys
from pathlib import Path

from snakemake.logging import logger

BESIDE = Path(workflow.basedir, "src/thirdbody")
try:
    import thirdbody

    if BESIDE.is_dir() and not BESIDE.samefile(Path(thirdbody.__file__).parent):
        library = Path(thirdbody.__file__).parent
        sys.exit(f"the library is {library}; allowed: that of this checkout, by PYTHONPATH=src")
    from chenhorng.configuration.settings import read_settings
    from chenhorng.home import config_directory
    from chenhorng.sources import Sources, settings_text
except ModuleNotFoundError as missing:
    sys.exit(f'{missing.name} is not installed for {sys.executable}; pip install ".[workflow]"')


def without_none(record):
    """Of a failed job Snakemake would write "message: None"."""
    if record.levelname == "ERROR" and getattr(record, "rule_msg", "") is None:
        record.rule_msg = "failed"
    return True


logger.addFilter(without_none)

# src/ and the repository, or where both packages are installed and the installed package
PACKAGES, HOME = Path(thirdbody.__file__).resolve().parents[1], config_directory().parent
SOURCES = Sources(PACKAGES, HOME, "thirdbody", "chenhorng")


def sources_of(script):
    """A text for each file that a script runs, as parameters of its rule."""
    return SOURCES.of_script(HOME / "workflow/scripts" / script)


def project_file(name):
    """The path of a file of the project, relative if the current folder is its repository."""
    top, _, rest = str(name).partition("/")
    path = PACKAGES / rest if top == "src" else HOME / name
    return str(path.relative_to(HOME) if Path.cwd() == HOME else path)


def figure_files(figure, category):
    """The files of a figure by kind; the PNG goes into Snakemake's report."""
    files = {kind: f"<results>/figures/{figure}.{kind}" for kind in FIGURE_KINDS}
    caption, labels = "../report/product.rst", {"figure": figure}
    return files | {"png": report(files["png"], caption, category=category, labels=labels)}


# snakedeploy copies the configuration into the folder of the user's workflow
CONFIG = "config" if Path("config/config.yaml").is_file() else project_file("config")
CLAIMS = f"{CONFIG}/claims.yaml"
PAPER_TABLES = f"{CONFIG}/paper_tables.yaml"
DIGITS = f"{CONFIG}/printed_digits.yaml"
INPUTS = f"{CONFIG}/inputs.yaml"
CALIBRATED = sorted(str(path) for path in Path(CONFIG, "calibrated").glob("*.yaml"))
try:  # Snakemake reads none of these files, as its errors do not name the file
    settings = read_settings(config, CONFIG, *workflow.overwrite_configfiles)
    CLAIMS_TEXT = settings_text(CLAIMS, list)
    PAPER_TABLES_TEXT = settings_text(PAPER_TABLES)
    DIGITS_TEXT = settings_text(DIGITS)
    INPUTS_TEXT = settings_text(INPUTS)
    CALIBRATED_TEXTS = [*map(settings_text, dict.fromkeys([settings["calibrated"], *CALIBRATED]))]
except ValueError as error:
    sys.exit(str(error))
SOFTWARE = settings["software"]

# a named run keeps all its files in results/NAME
RESULTS = f"results/{settings['run']}" if settings["run"] else "results"
LOGS = f"{RESULTS}/logs" if settings["run"] else "logs"
# without its record, Snakemake takes products of another configuration for those of this one
if workflow.is_main_process and Path(RESULTS, "datasets").is_dir():
    if not Path(".snakemake/metadata").is_dir():
        sys.exit(f"{RESULTS} has products without .snakemake, their record; allowed: both or none")
