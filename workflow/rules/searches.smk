# The searches of the calibration: which there are, and the files from which each starts.
import json
from pathlib import Path

CALIBRATION = settings["calibration"]
SEEDS = CALIBRATION["seeds"]
FOLDS = range(len(CALIBRATION["folds"]))
SEARCHED_WIDELY = [
    name for name, entry in CALIBRATION["interpretations"].items() if "nearby" not in entry
]


def settings_of(wildcards):
    """The settings for one interpretation, independent of the others."""
    names = [wildcards.interpretation, *nearby(wildcards)]
    return {
        **CALIBRATION,
        "interpretations": {name: CALIBRATION["interpretations"][name] for name in names},
    }


def nearby(wildcards):
    """The interpretation from whose best inputs that of a job is searched, if there is one."""
    entry = CALIBRATION["interpretations"][wildcards.interpretation]
    return [entry["nearby"]] if "nearby" in entry else []


def start_of(wildcards):
    """The files with the inputs from which a search starts."""
    for name in nearby(wildcards):
        if "fold" in wildcards.keys():
            return [f"<results>/calibration/{name}/fold{wildcards.fold}.csv"]
        return searches_of(name)
    return [f"<results>/calibration/{wildcards.interpretation}/scattered.csv"]


def searches_of(name):
    """The files of the searches over all statements of an interpretation."""
    seeds = SEEDS if name in shortlisted() else SEEDS[:1]
    return [f"<results>/calibration/{name}/seed{seed}.csv" for seed in seeds]


def shortlisted():
    chosen = checkpoints.shortlist.get().output.chosen
    return json.loads(Path(chosen).read_text(encoding="utf-8"))


def is_cross_validated(wildcards):
    """Whether an interpretation, or the one from which its starts come in the end, is on the shortlist."""
    name = wildcards.interpretation
    while "nearby" in CALIBRATION["interpretations"][name]:
        name = CALIBRATION["interpretations"][name]["nearby"]
    return name in shortlisted()
