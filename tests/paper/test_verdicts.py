"""Tables and pages of the verdicts: words, counts, ranges and departures, mostly on made-up
verdicts.
"""

import json
import re
from dataclasses import replace

import numpy as np
import pandas as pd
import pytest

from chenhorng.calibration.calibration import Interpretation
from chenhorng.claims import verdicts
from chenhorng.claims.claim import Verdict
from chenhorng.claims.claims import load_claims
from chenhorng.claims.departures import (
    departure_rows,
    departure_words,
    random_inputs,
    read_departures,
)
from chenhorng.claims.evidence import QUICK_EFFORT
from chenhorng.claims.judge import Judge, count_once
from chenhorng.claims.kinds import Absence, Value
from chenhorng.claims.verdicts import claims_html, claims_json, claims_markdown
from chenhorng.claims.words import CONTRADICTED, FAILS, HOLDS, NOT_TESTED
from chenhorng.home import config_directory
from chenhorng.tables import TABLES
from thirdbody.core.particles import first_yield_depth
from thirdbody.files import read_yaml
from thirdbody.symbols import short

SETTINGS = read_yaml(config_directory() / "calibration.yaml")
CALIBRATED = read_yaml(config_directory() / "config.yaml")["calibrated"]
HELD = Verdict("1", 0.0, 0.0, (1.0,))
MISSED = Verdict("2", 7.4, 1.0, (2.0,), finding="A_t* is 2; 1 is printed.")
BEYOND = Verdict("> 2", 0.0, 1.0, (2.0,), tested=False)
WORDY = Verdict("boundary", 0.0, 0.0)


def claim(name, loads=(), made=Value, **fields):
    conditions = {"viscosity_cSt": 0, "particle_diameter_nm": 0, "roughness_nm": 300}
    fields |= {"conditions": conditions | {"particle_density_per_m2": 0, **dict(loads)}}
    fields |= {"tolerance": 0.1, "tolerance_kind": "absolute", "reason": "reason", "kind": "value"}
    fields |= {"place": "Figure 4A", "statement": "statement", "quote": ""}
    if made is Value:
        fields = {"extreme": "minimum", "published": 3.0} | fields
    return made(id=name, quantity="total_contact_area", **fields)


def twin(name):
    """A statement of a cluster, without a number."""
    return claim(name, made=Absence, cluster="twins")


TAKEN_FIELDS = {"contradicts": ("aside",), "published": 1.0, "reference": {"viscosity_cSt": 90}}
TAKEN = claim("taken", {"load_max": 1e-5}, **TAKEN_FIELDS)
ASIDE = claim("aside", contradicts=("taken",), aside="Figure 9 says so | twice", published=2.0)
CLAIMS = (TAKEN, ASIDE, twin("one"), twin("other"))
DEFAULT = {
    "interpretation": "some",
    "inputs": {"truncation": 2.0},
}


def by_id(found):
    return {each.id: verdict for each, verdict in zip(CLAIMS, found, strict=True)}


def report(main, members=(), predicted=None, headline=(), compared=("some",)):
    main = by_id(main)
    return verdicts.Report(
        claims=CLAIMS,
        settings={"headline": headline, "interpretations": dict.fromkeys(compared)},
        default=DEFAULT,
        verdicts=main,
        members=tuple(map(by_id, members)),
        interpretations={},
        predicted=predicted or {},
        comparison=pd.DataFrame(),
    )


def test_the_word_for_a_verdict():
    words = [verdicts.outcome(TAKEN, verdict) for verdict in (HELD, MISSED, BEYOND)]
    assert words == [HOLDS, FAILS, NOT_TESTED]
    assert {verdicts.outcome(ASIDE, verdict) for verdict in (HELD, MISSED)} == {CONTRADICTED}


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


def test_the_counts_with_repeats_lead_to_the_count_without():
    page = claims_html(report((HELD, HELD, HELD, MISSED)))
    assert "4 statements: 2 hold, 1 fails, 1 contradicted by the paper itself. " in page
    assert "The 3 that hold or fail are 2 without repeats." in page


def test_the_page_has_the_score_and_the_contradictions_apart():
    main = (MISSED, HELD, HELD, MISSED)
    predicted = {"taken": HELD, "one": MISSED, "other": HELD}
    results = report(main, predicted=predicted)
    page = claims_markdown(results)
    assert "**0 of 2 checkable statements hold with one set of inputs; 1 of 2 hold when" in page
    apart = page.split("## Where the paper contradicts itself")[1].split("## How to read")[0]
    (row,) = (line for line in apart.splitlines() if "Figure 9" in line)
    cells = [cell.strip() for cell in row.replace("\\|", "or").split("|")[1:-1]]
    assert cells == ["statement", "yes", "taken (fails)", "Figure 9 says so or twice"]
    failed = page.split("## What fails, in the words of the paper")[1]
    assert "**taken**" in failed and "**other**" in failed and "**aside**" not in failed
    assert "It holds under none of the 0 interpretations." in failed
    html = claims_html(results)
    assert "0 of 2 checkable statements hold" in html and "; 1 of 2 hold when" in html
    assert all(f'id="{each.id}"' in html for each in CLAIMS)


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
    column = table["range of the ensemble"]
    assert column["taken"] == "1 to 19"
    assert column["one"] == "16 of 21 agree"
    assert column["other"] == "0.05 to 0.95, 1.1 to 2.9"
    assert (table.loc["taken", "paper"], table.loc["taken", "model"]) == ("1.0", "10")
    rows = results.table.set_index("id")
    ends = rows.loc["other", ["value", "range_low", "range_high"]].tolist()
    assert ends == pytest.approx([2.0, 1.1, 2.9])
    alone = verdicts.headline_table(report(main, headline=["one"]))
    assert alone["range of the ensemble"].tolist() == ["no ensemble"]


def test_the_score_says_among_how_many_the_default_was_chosen():
    main, predicted = (HELD, HELD, HELD, MISSED), {"taken": HELD, "one": HELD}
    said = verdicts.score_sentence(report(main, predicted=predicted, compared="abc"))
    assert said.startswith("**1 of 2 checkable") and "; 2 of 2 hold when" in said
    assert "chosen among 3 " in said
    alone = verdicts.score_sentence(report(main, predicted=predicted))
    assert "chosen among" not in alone and "; 2 of 2 hold when" in alone
    unknown = verdicts.score_sentence(report(main))
    assert unknown.startswith("**1 of 2 checkable") and "hold when" not in unknown


def test_what_no_inputs_can_meet_stands_beside_the_number_that_is_missed():
    limited = replace(TAKEN, limit="it is at most 0.9 under any inputs")
    results = replace(report((MISSED, HELD, HELD, HELD)), claims=(limited, *CLAIMS[1:]))
    failed = claims_markdown(results).split("## What fails")[1].split("## The inputs")[0]
    assert "at most 0.9" in failed
    html = claims_html(results)
    (row,) = (line for line in html.splitlines() if "at most 0.9" in line)
    assert row.startswith('<tr class="fails" id="taken">')


def test_a_printed_number_has_a_graph_with_its_tolerance_and_what_is_found():
    """TAKEN prints 1.0, with a tolerance of 0.1."""
    near = HELD._replace(numbers=(1.05, 0.9, 1.13))
    far = HELD._replace(numbers=(1.5, 0.5))
    begin, middle, length, _ = 30.0, 50.0, 40.0, 46.0
    for verdict, places, arrows in (
        (near, [middle + 0.5 * 20.0, middle - 20.0, middle + 1.3 * 20.0], 0),
        (far, [], 2),
    ):
        page = claims_html(report((verdict, HELD, HELD, HELD)))
        (row,) = (line for line in page.splitlines() if 'id="taken"' in line)
        found = [float(each) for each in re.findall(r'cx="(.*?)"', row)]
        assert found == pytest.approx(places, abs=0.01)
        assert f'<rect x="{begin}" y="1" width="{length}"' in row and f'd="M{middle} 0V12"' in row
        assert row.count('class="missed" d="M') == arrows
        kinds = re.findall(r'class="(met|missed)" cx', row)
        assert kinds == (["met", "met", "missed"] if places else [])
    for stands_for, graphs in (("about one", 0), ("300 nm", 1)):
        words = replace(TAKEN, stands_for=stands_for)
        results = replace(report((near, HELD, HELD, HELD)), claims=(words, *CLAIMS[1:]))
        (row,) = (line for line in claims_html(results).splitlines() if 'id="taken"' in line)
        assert row.count("<svg") == graphs


def test_the_page_has_true_minus_signs_and_is_a_table_on_paper():
    minus = HELD._replace(finding="It changes by -0.152.")
    page = claims_html(report((minus, HELD, HELD, HELD)))
    assert "It changes by −0.152." in page
    assert re.findall(r"@media (?!screen|print)", page) == []


def test_programs_read_what_the_page_says():
    nan = float("nan")
    main = (HELD, MISSED, HELD, Verdict("?", nan, nan, (nan,), tested=False))
    results = report(main, [main], headline=["taken"])
    others = {"mine": by_id((MISSED, HELD, BEYOND, HELD))}
    content = json.loads(claims_json(replace(results, interpretations=others)))
    assert (content["held"], content["judged"]) == (2, 2)
    assert content["inputs"] == DEFAULT["inputs"]
    assert [row["id"] for row in content["headline"]] == ["taken"]
    first, *_, last = content["statements"]
    assert (first["place"], first["published"], first["range"]) == ("Figure 4A", 1.0, [[1.0, 1.0]])
    (curve,) = first["curves"]
    assert (curve["viscosity"], curve["roughness"], curve["particle_diameter"]) == (0, 3e-7, 0)
    assert first["references"] == [curve | {"viscosity": 9e-5}]
    assert first["loads"] == {"load_max": 1e-5} and first["reason"] == "reason"
    words = [row["verdicts_of"]["mine"] for row in content["statements"]]
    assert words == ["fails", CONTRADICTED, "not tested", "holds"]
    assert (last["deviation"], last["numbers"], last["range"]) == (None, [None], [[None, None]])
    second = content["statements"][1]
    assert (second["part"], second["finding"]) == ("Figure 4", MISSED.finding)


DRY, OUTSIDE = "fig11a-turning-point-load-dry", "fig09a-no-turning-point-outside"


@pytest.fixture(scope="module")
def some():
    """Two statements, of which one has a wide tolerance: the load of the dry turning point."""
    every = {each.id: each for each in load_claims(config_directory() / "claims.yaml")}
    wide = replace(every[DRY], tolerance_kind="factor", tolerance=1.41)
    return [every[OUTSIDE], wide]


def test_everything_is_judged_by_the_real_model(parameters, some):
    content = read_yaml(config_directory().parent / CALIBRATED)
    inputs = content["inputs"]
    content["ensemble"] = []
    content["folds"] = [
        {"left_out": [OUTSIDE], "inputs": inputs},
        {"left_out": [DRY], "inputs": inputs | {"elastic_depth_ratio": 0.5}},
    ]
    name = content["interpretation"]
    settings = SETTINGS | {"interpretations": {name: {"fixed": {}}}}
    judge = Judge(some, parameters.as_dict(), SETTINGS["newtons"])
    default = {"inputs": inputs, "ensemble": []}
    found = verdicts.Report.of(judge, content, [content], settings, **default)
    assert [verdict.holds for verdict in found.verdicts.values()] == [True, True]
    number = short(f"{found.verdicts[DRY].value:.3g}")
    assert number in found.verdicts[DRY].finding and "3.27e-6" in found.verdicts[DRY].finding
    predicted = found.predicted
    assert predicted[OUTSIDE].holds and not predicted[DRY].holds
    table = found.table
    assert table["predicted"].tolist() == ["holds", "fails"]
    assert np.isnan(table["range_low"]).all() and (table["ensemble_size"] == 0).all()
    (row,) = found.comparison.to_dict("records")
    assert (row["interpretation"], row["predicted"], row["fitted"]) == (name, "1/2", "2/2")
    assert (row["above_least"], row["standard_error"], row["equal"]) == (0.0, 0.0, True)
    deviation = found.verdicts[DRY].value / 3.27e-6 - 1.0
    assert row["mean_deviation"] == pytest.approx(abs(deviation))
    # what the search said of its inputs is not said of others
    changed = default | {"inputs": inputs | {"spread_ratio": 0.9 * inputs["spread_ratio"]}}
    other = verdicts.Report.of(judge, content, [content], settings, **changed)
    assert other.table["predicted"].tolist() == ["", ""]
    told = json.loads(claims_json(other))
    assert (told["predicted"], told["predicted_of"]) == (0, 0)
    assert told["inputs"]["spread_ratio"] == changed["inputs"]["spread_ratio"]
    assert found.has_calibrated_inputs and not other.has_calibrated_inputs
    pages = [claims_markdown(each) for each in (found, other)]
    assert [page.count("hold when their figure was not used") for page in pages] == [1, 0]
    assert "No cross-validation has been run for these inputs." in pages[1]


def test_departures_are_taken_back_one_by_one(defaults, some):
    judge = Judge(some, defaults.best.as_dict(), SETTINGS["newtons"])
    written = [{"name": "one", "inputs": {"elastic_depth_ratio": "at_first_yield"}}]
    settings = SETTINGS | {"headline": [DRY], "departures": written, "random_sets": 3}
    departures = read_departures(settings, judge.base)
    shallow = {"elastic_depth_ratio": first_yield_depth(defaults.best)}
    assert departures == [{"name": "one", "inputs": shallow}]
    taken_back = [judge(shallow)]
    rows = departure_rows(judge, settings, judge({}), departures, taken_back)
    unchanged, changed, least, most = rows
    names = [column.name for column in TABLES["departures"]]
    assert all([*row] == names for row in rows)
    for row, name, inputs in ((unchanged, "as it is", {}), (changed, "one", shallow)):
        found = judge(inputs)
        assert row["departure"] == name
        assert (row["holds"], row["judged"]) == count_once(some, found)
        assert row["headline"] == found[DRY].holds
        deviation = abs(found[DRY].value / 3.27e-6 - 1.0) if found[DRY].value > 0.0 else 1.0
        assert row["mean_deviation"] == row["median_deviation"] == pytest.approx(deviation)
    assert (unchanged["inputs"], changed["inputs"]) == ("", "elastic_depth_ratio = 0.00177")
    assert unchanged["holds"] == 2 and changed["holds"] < 2
    (words,) = departure_words(judge, departures, taken_back)
    assert (words["name"], words["inputs"]) == ("one", shallow)
    assert list(words["verdicts"].values()).count("holds") == changed["holds"]
    counts = [count_once(some, judge(each, QUICK_EFFORT)) for each in random_inputs(settings)]
    assert (least["holds"], least["judged"]) == min(counts)
    assert (most["holds"], most["judged"]) == max(counts)
    assert least["headline"] is least["mean_deviation"] is most["median_deviation"] is None


def test_random_inputs_fill_the_usual_ranges():
    sets = random_inputs(SETTINGS | {"random_sets": 8})
    assert sets == random_inputs(SETTINGS | {"random_sets": 8})
    settings = SETTINGS | {"interpretations": {"all": {"fixed": {}}}}
    for unknown in Interpretation.of("all", settings).unknowns:
        values = np.array([each[unknown.name] for each in sets])
        low, high = map(unknown.position, unknown.usual)
        places = (np.array([unknown.position(value) for value in values]) - low) / (high - low)
        # one in each eighth of the range
        assert sorted((8.0 * places).astype(int)) == list(range(8)), unknown.name
        assert max(map(unknown.penalty, values)) == 0.0
