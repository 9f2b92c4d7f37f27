# Shared by the rules of the calibration: their settings, and the shortlisted interpretations.
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
FOUND = "<results>/calibration/{{interpretation}}"
SEARCHED = expand(f"{FOUND}/seed{{seed}}.csv", seed=SEEDS)


def settings_of(wildcards):
    """The settings for one interpretation, independent of the others."""
    name = wildcards.interpretation
    interpretation = dict(CALIBRATION["interpretations"][name])
    budget = CALIBRATION["budget"] | interpretation.pop("budget", {})
    return {**CALIBRATION, "budget": budget, "interpretations": {name: interpretation}}


def is_shortlisted(wildcards):
    chosen = checkpoints.shortlist.get().output.chosen
    return wildcards.interpretation in json.loads(Path(chosen).read_text(encoding="utf-8"))
