"""Choose the default by the rule, and search for the cost of each headline number that it misses."""

import json
from dataclasses import replace

import numpy as np

from thirdbody.configuration.plain_yaml import read_yaml
from thirdbody.data.files import atomic_write
from thirdbody.job_log import logged
from thirdbody.study.calibration import Interpretation, Objective, make_folds
from thirdbody.study.claims import load_claims
from thirdbody.study.judge import Judge
from thirdbody.study.results import mixed_ensemble, price_front
from thirdbody.study.search import search
from thirdbody.study.verdicts import count_once, predict, rank_interpretations


def _fractions(judge, verdicts, folds):
    """The predicted fraction of the statements in each fold."""
    fractions = []
    for fold in make_folds(judge.claims, [each["figures"] for each in folds]):
        held, of = count_once(fold.left_out, verdicts)
        fractions.append(held / max(of, 1))
    return np.array(fractions)


with logged(snakemake.log[0]):
    settings = snakemake.params.settings
    statements = load_claims(snakemake.params.claims)
    base = snakemake.params.parameters
    judge = Judge(statements, base, settings["newtons"])
    contents = {
        content["interpretation"]: content for content in map(read_yaml, snakemake.input.calibrated)
    }
    verdicts = {name: judge(content["inputs"]) for name, content in contents.items()}
    predicted = {name: predict(judge, content) for name, content in contents.items()}
    table = rank_interpretations(judge, list(contents.values()), verdicts, predicted, settings)
    print(
        table[["interpretation", "predicted", "fitted", "penalty", "inputs"]].to_string(index=False)
    )
    ranking = table["interpretation"].tolist()
    default = ranking[0]
    interpretation = Interpretation.of(default, settings)
    plain = Objective.of(statements, settings, base)
    names = *(unknown.name for unknown in interpretation.unknowns), *interpretation.opposites
    inputs = {name: contents[default]["inputs"][name] for name in names}
    missed = [
        id
        for id, verdict in verdicts[default].items()
        if id in settings["headline"] and not verdict.holds
    ]
    fronts = {}
    for name in missed:
        emphasis = np.where(plain.repeating(name), settings["price_weight"], 1.0)
        raised = replace(plain, weights=plain.weights * emphasis)
        start = interpretation.positions(inputs)
        rows = search(interpretation, raised, start, settings["budget"], settings["seeds"][0])
        fronts[name] = price_front(interpretation, plain, name, rows, inputs)
    fractions = {
        name: _fractions(judge, predicted[name], content["folds"])
        for name, content in contents.items()
        if content.get("folds")
    }
    members, labels = mixed_ensemble(
        [contents[name] for name in ranking], fractions, settings["ensemble"]
    )
    content = {
        "interpretation": default,
        "fronts": fronts,
        "ensemble": members,
        "ensemble_interpretations": labels,
    }
    with atomic_write(snakemake.output.chosen) as part:
        part.write_text(json.dumps(content, indent=1) + "\n", encoding="utf-8")
