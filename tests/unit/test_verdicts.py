"""Tables and pages of the verdicts: words, counts, ranges and order, on made-up verdicts."""

import json

import numpy as np
import pandas as pd
import pytest

from thirdbody.configuration import config_directory
from thirdbody.configuration.plain_yaml import read_yaml
from thirdbody.study import verdicts
from thirdbody.study.claim import Verdict
from thirdbody.study.claims import load_claims
from thirdbody.study.judge import Judge
from thirdbody.study.kinds import Value
from thirdbody.study.verdicts import claims_html, claims_json, claims_markdown

SETTINGS = read_yaml(config_directory() / "calibration.yaml")
NOTHING_REQUIRED = {"headline": 0, "summit_parameter": 1e3, "roughness_nm": [100, 500]}
HELD = Verdict("1", 0.0, 0.0, (1.0,))
MISSED = Verdict("2", 7.4, 1.0, (2.0,))
BEYOND = Verdict("> 2", 0.0, 1.0, (2.0,), tested=False)
WORDY = Verdict("boundary", 0.0, 0.0)


def claim(name, loads=(), published=None, **fields):
    fields |= {"conditions": {"viscosity_cSt": 0, "roughness_nm": 300, **dict(loads)}}
    fields |= {"tolerance": 0.1, "tolerance_kind": "absolute", "reason": "reason", "kind": "value"}
    fields |= {"place": "Figure 4A", "statement": "statement", "quote": "", "published": published}
    return Value(id=name, **fields)


TAKEN_FIELDS = {"contradicts": ("aside",), "published": 1.0, "reference": {"viscosity_cSt": 90}}
TAKEN = claim("taken", {"load_max": 1e-5}, **TAKEN_FIELDS)
ASIDE = claim("aside", contradicts=("taken",), aside="Figure 9 says so | twice", published=2.0)
CLAIMS = (TAKEN, ASIDE, claim("one", cluster="twins"), claim("other", cluster="twins"))
DEFAULT_NAME = "fluid_natural_area_3"
DEFAULT = {
    "interpretation": "some",
    "inputs": {"truncation": 2.0},
    "identification": {"truncation": {"range_of_each_seed": [[1.5, 2.5], [1.6, 2.4]]}},
}


def by_id(found):
    return {each.id: verdict for each, verdict in zip(CLAIMS, found, strict=True)}


def report(main, members=(), predicted=None, headline=()):
    main = by_id(main)
    return verdicts.Report(
        claims=CLAIMS,
        settings={"headline": headline, "headline_tolerances": {}},
        default=DEFAULT,
        verdicts=main,
        faint=main,
        fine=main,
        members=tuple(map(by_id, members)),
        interpretations={},
        predicted=predicted or {},
        comparison=pd.DataFrame(),
    )


def candidate(content, verdict, predicted):
    return verdicts.Candidate(
        content=content, verdicts={"taken": verdict}, predicted={"taken": predicted}
    )


def test_the_word_for_a_verdict():
    words = [verdicts.outcome(TAKEN, verdict) for verdict in (HELD, MISSED, BEYOND)]
    assert words == [verdicts.HOLDS, verdicts.FAILS, verdicts.NOT_TESTED]
    assert {verdicts.outcome(ASIDE, verdict) for verdict in (HELD, MISSED)} == {
        verdicts.CONTRADICTED
    }


@pytest.mark.parametrize(
    ("twins", "count"),
    [
        ((HELD, HELD), (2, 2)),
        ((HELD, MISSED), (1, 2)),
        ((MISSED, MISSED), (1, 2)),
        ((HELD, BEYOND), (2, 2)),
        ((BEYOND, BEYOND), (1, 1)),
    ],
)
def test_statements_that_repeat_one_another_count_once(twins, count):
    main = (HELD, MISSED, *twins)
    assert verdicts.count_once(CLAIMS, by_id(main)) == count
    (row,) = verdicts.counts_by_figure(report(main)).to_dict("records")
    assert row["figure"] == "Figure 4"
    assert row["hold, repeats once"] == "{} of {}".format(*count)


def test_the_page_has_the_score_and_the_contradictions_apart():
    main = (MISSED, HELD, HELD, MISSED)
    predicted = {"taken": HELD, "one": MISSED, "other": HELD}
    results = report(main, predicted=predicted)
    page = claims_markdown(results)
    assert "Of 2 distinct statements 1 are predicted" in page
    assert "Of 2 that can be judged 0 hold (0 %)" in page
    apart = page.split("## Where the paper contradicts itself")[1].split("## Predictions")[0]
    (row,) = (line for line in apart.splitlines() if "Figure 9" in line)
    cells = [cell.strip() for cell in row.replace("\\|", "or").split("|")[1:-1]]
    assert cells == ["statement", "yes", "taken (fails)", "Figure 9 says so or twice"]
    failed = page.split("## What fails, in the words of the paper")[1]
    assert "**taken**" in failed and "**other**" in failed and "**aside**" not in failed
    assert "It holds under none of the 0 interpretations." in failed
    html = claims_html(results)
    assert html.count("<tr class") == len(CLAIMS)
    assert "rowgroup" in html and html.count('type="radio"') == 5


def test_headline_numbers_have_the_range_of_the_ensemble():
    numbered = [HELD._replace(computed=str(n), numbers=(float(n),)) for n in range(21)]
    window = [HELD._replace(numbers=(n / 20, 1 + n / 10)) for n in range(21)]
    members = [
        (number, HELD, MISSED._replace(numbers=()) if n < 5 else WORDY, ends)
        for n, (number, ends) in enumerate(zip(numbered, window, strict=True))
    ]
    main = (numbered[10], HELD, WORDY, window[10]._replace(worst=1))
    results = report(main, members, headline=["taken", "one", "other"])
    table = verdicts.headline_table(results).set_index("id")
    column = table["ensemble, 90 %"]
    assert column["taken"] == "1 to 19"
    assert column["one"] == "16 of 21 agree"
    assert column["other"] == "0.05 to 0.95, 1.1 to 2.9"
    assert (table.loc["taken", "paper"], table.loc["taken", "model"]) == ("1.0", "10")
    rows = results.table.set_index("id")
    ends = rows.loc["other", ["value", "range_low", "range_high"]].tolist()
    assert ends == pytest.approx([2.0, 1.1, 2.9])
    alone = verdicts.headline_table(report(main, headline=["one"]))
    assert alone["ensemble, 90 %"].tolist() == ["no ensemble"]


def test_the_first_interpretation_is_the_one_that_the_rule_prefers(parameters):
    """Most predicted, then the least penalty, then the fewest unknowns."""
    some = dict(list(SETTINGS["interpretations"].items())[:4])
    settings, names = SETTINGS | {"interpretations": some, "required": NOTHING_REQUIRED}, list(some)
    inputs = {name: unknown["usual"][0] for name, unknown in SETTINGS["unknowns"].items()}
    contents = [{"interpretation": name, "inputs": inputs} for name in names]
    contents[2] |= {"inputs": inputs | {"summit_parameter": 0.2}}  # unusual
    predicted = [MISSED, HELD, HELD, HELD]
    judge = Judge([TAKEN], parameters.as_dict(), SETTINGS["newtons"])
    candidates = map(candidate, contents, [HELD] * 4, predicted)
    table = verdicts.rank_interpretations(judge, candidates, settings)
    ranking = table["interpretation"].tolist()
    assert ranking[-1] == names[0] and ranking[-2] == names[2]
    assert table["inputs"].iloc[0] <= table["inputs"].iloc[1]
    assert table["predicted"].tolist()[-1] == "0/1"


def test_what_is_required_of_the_default_comes_first(parameters):
    """Enough headline numbers, and summits like those of usual surfaces on the roughest surface too."""
    some = dict(list(SETTINGS["interpretations"].items())[:2])
    inputs = {name: unknown["usual"][0] for name, unknown in SETTINGS["unknowns"].items()}
    steep = {"summit_parameter": 0.08, "summit_parameter_exponent": 0.9}
    contents = [
        {"interpretation": name, "inputs": inputs | own}
        for name, own in zip(some, (steep, {}), strict=True)
    ]
    settings = SETTINGS | {"interpretations": some, "headline": ["taken"]}
    first, second = some
    judge = Judge([TAKEN], parameters.as_dict(), SETTINGS["newtons"])

    def ranked(required, held):
        candidates = map(candidate, contents, held, [HELD] * 2)
        required = SETTINGS["required"] | required
        table = verdicts.rank_interpretations(judge, candidates, settings | {"required": required})
        return table["interpretation"].tolist(), table["eligible"].tolist()

    assert ranked({"headline": 1}, [HELD, HELD]) == ([second, first], [True, False])
    unlimited = {"headline": 1, "summit_parameter": 1.0}
    assert ranked(unlimited, [HELD, MISSED]) == ([first, second], [True, False])


def test_programs_read_what_the_page_says():
    nan = float("nan")
    main = (HELD, MISSED, HELD, Verdict("?", nan, nan, (nan,), tested=False))
    content = json.loads(claims_json(report(main, [main], headline=["taken"])))
    assert (content["held"], content["judged"]) == (2, 2)
    assert content["inputs"] == DEFAULT["inputs"]
    assert [row["id"] for row in content["headline"]] == ["taken"]
    first, *_, last = content["statements"]
    assert (first["place"], first["published"], first["range"]) == ("Figure 4A", 1.0, [[1.0, 1.0]])
    (curve,) = first["curves"]
    assert (curve["viscosity"], curve["roughness"], curve["particle_diameter"]) == (0, 3e-7, None)
    assert first["references"] == [curve | {"viscosity": 9e-5}]
    assert first["loads"] == {"load_max": 1e-5}
    assert (last["deviation"], last["numbers"], last["range"]) == (None, [None], [[None, None]])


def test_everything_is_judged_by_the_real_model(parameters):
    dry, outside = "fig11a-turning-point-load-dry", "fig09a-no-turning-point-outside"
    every = load_claims(config_directory() / "claims.yaml")
    claims = [each for each in every if each.id in (dry, outside)]
    content = read_yaml(config_directory() / "calibrated" / f"{DEFAULT_NAME}.yaml")
    inputs = content["inputs"]
    content["ensemble"] = []
    content["folds"] = [
        {"figures": [9], "inputs": inputs},
        {"figures": [11], "inputs": inputs | {"elastic_depth_ratio": 0.5}},
    ]
    judge = Judge(claims, parameters.as_dict(), SETTINGS["newtons"])
    found = verdicts.Report.of(judge, content, [content], SETTINGS)
    assert [verdict.holds for verdict in found.verdicts.values()] == [True, True]
    predicted = found.predicted
    assert predicted[outside].holds and not predicted[dry].holds
    table = found.table
    assert table["predicted"].tolist() == ["holds", "fails"]
    assert np.isnan(table["range_low"]).all() and (table["ensemble_size"] == 0).all()
