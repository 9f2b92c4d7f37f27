# Names that the rules share: the library, the settings, the paths of files, the sources of jobs.
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
    from chenhorng.job_log import without_none
    from chenhorng.sources import Sources, settings_text
except ModuleNotFoundError as missing:
    sys.exit(f'{missing.name} is not installed for {sys.executable}; pip install ".[workflow]"')

logger.addFilter(without_none)

# folders: src/ and the repository; or that of the installed packages and chenhorng in it
PACKAGES, HOME = Path(thirdbody.__file__).resolve().parents[1], config_directory().parent
SOURCES = Sources(PACKAGES, HOME, "thirdbody", "chenhorng")
project_file = SOURCES.project_file


def sources_of(script):
    """A text for each file that a job of a script runs, as parameters of its rule."""
    return SOURCES.of_script(HOME / "workflow/scripts" / script)


def figure_files(figure, category):
    """The files of a figure by format; the PNG goes into Snakemake's report."""
    files = {name: f"<results>/figures/{figure}.{name}" for name in FIGURE_FORMATS}
    caption, labels = "../report/product.rst", {"figure": figure}
    return files | {"png": report(files["png"], caption, category=category, labels=labels)}


# a workflow that uses this one has a copy of the configuration, made by snakedeploy
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
# without the record, Snakemake would keep products of another configuration
if workflow.is_main_process and Path(RESULTS, "datasets").is_dir():
    if not Path(".snakemake/metadata").is_dir():
        sys.exit(f"{RESULTS} has products without .snakemake, their record; allowed: both or none")
