# What the rules of the calibration share: which searches, samples and folds an interpretation has.
import json

CALIBRATION = settings["calibration"]
SEEDS = CALIBRATION["seeds"]
FOLDS = range(len(CALIBRATION["folds"]))
FEW_UNKNOWNS = [
    name
    for name, each in CALIBRATION["interpretations"].items()
    if len({*CALIBRATION["always"], *each.get("unknowns", ())} - set(each["fixed"]))
    <= CALIBRATION["shortlist"]["unknowns"]
]
SEARCHED = "<results>/calibration/{{interpretation}}/seed{seed}.csv"


def settings_of(wildcards):
    """The settings for one interpretation, which depends on nothing of the others."""
    name = wildcards.interpretation
    interpretation = dict(CALIBRATION["interpretations"][name])
    budget = CALIBRATION["budget"] | interpretation.pop("budget", {})
    return {**CALIBRATION, "budget": budget, "interpretations": {name: interpretation}}


def searches_of(wildcards):
    """The searches of an interpretation: of the shortlist from all seeds, else from the first."""
    return expand(SEARCHED, seed=SEEDS if is_shortlisted(wildcards) else SEEDS[:1])


def samples_of(wildcards):
    """The samples of an interpretation of the shortlist."""
    samples = "<results>/calibration/{{interpretation}}/seed{seed}_samples.csv"
    return expand(samples, seed=SEEDS) if is_shortlisted(wildcards) else []


def folds_of(wildcards):
    """The cross-validation of an interpretation of the shortlist."""
    folds = "<results>/calibration/{{interpretation}}/fold{fold}.csv"
    return expand(folds, fold=FOLDS) if is_shortlisted(wildcards) else []


def is_shortlisted(wildcards):
    chosen = checkpoints.shortlist.get().output.chosen
    return wildcards.interpretation in json.loads(Path(chosen).read_text(encoding="utf-8"))
