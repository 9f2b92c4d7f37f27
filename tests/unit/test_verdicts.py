"""What is made of the verdicts: words, counts, and the page, on made-up judgements."""

import json
from dataclasses import replace
from types import SimpleNamespace

import pytest

from thirdbody.study import verdicts
from thirdbody.study.calibration import Unknown
from thirdbody.study.checks import Verdict
from thirdbody.study.claims import Claim
from thirdbody.study.verdict_text import claims_html, claims_json, claims_markdown
from thirdbody.study.verdicts import Judgement, Trial, counted_once, discriminating, outcome

HELD = Verdict("1", (1.0,), 0, 0.0, 0.0, (0.0, 0.0), True, True)
MISSED = Verdict("2", (2.0,), 0, 1.0, 3.0, (3.0, 3.0), True, False)
BEYOND = Verdict("> 2", (2.0,), 0, 1.0, 0.0, (0.0, 0.0), False, False)


def claim(name, role="calibration", loads=(), **fields):
    conditions = {"viscosity_cSt": 0, "roughness_nm": 300, **dict(loads)}
    return Claim(
        *(name, "Figure 4A", "statement", "value", role, conditions, 0.1, False, "reason"), **fields
    )


TAKEN = claim(
    *("taken", "calibration", {"load_max": 1e-5}),
    contradicts=("aside",),
    published=1.0,
    reference={"viscosity_cSt": 90},
)
ASIDE = claim("aside", contradicts=("taken",), aside="Figure 9 says so | twice", published=2.0)
TWINS = claim("one", cluster="twins"), claim("other", cluster="twins")
CLAIMS = (TAKEN, ASIDE, *TWINS, claim("kept back", role="withheld"))

DEFAULT = {
    "reading": "some",
    "objective": 1.0,
    "inputs": {"truncation": 2.0},
    "identification": {"truncation": {"range_of_each_seed": [[1.5, 2.5], [1.6, 2.4]]}},
}


def trial(main, *readings):
    judgements = [Judgement(f"reading {n}", given) for n, given in enumerate(readings)]
    return Trial(CLAIMS, Judgement("default", main), (), (), tuple(judgements))


@pytest.mark.parametrize(
    ("statement", "verdict", "word"),
    [
        (TAKEN, HELD, verdicts.HOLDS),
        (TAKEN, MISSED, verdicts.FAILS),
        (TAKEN, BEYOND, verdicts.NOT_TESTED),
        (ASIDE, HELD, verdicts.CONTRADICTED),
        (ASIDE, MISSED, verdicts.CONTRADICTED),
        (CLAIMS[-1], HELD, verdicts.WITHHELD),
    ],
)
def test_the_word_for_a_verdict(statement, verdict, word):
    assert outcome(statement, verdict) == word


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
    main = (HELD, MISSED, *twins, HELD)
    rows = verdicts.verdict_rows(trial(main))
    assert counted_once((row["cluster"] or row["id"], row["verdict"]) for row in rows) == count
    (figure,) = verdicts.counts(rows, "figure")
    assert figure["hold, repeats once"] == "{} of {}".format(*count)


def test_what_holds_under_some_readings_and_fails_under_others_discriminates():
    held = (HELD,) * 5
    assert discriminating(trial(held, held, held)) == []
    assert discriminating(trial(held, held, (MISSED, MISSED, HELD, BEYOND, HELD))) == ["taken"]


def test_the_page_shows_contradictions_apart():
    contents = [{"objective": 1.0, "penalty": 0.0, "identification": {}}]
    main = (MISSED, HELD, HELD, MISSED, HELD)
    held = trial(main, (HELD,) * 5)
    held = Trial(held.claims, held.main, (), (Judgement("lower one", main),), held.readings)
    page = claims_markdown(held, DEFAULT, contents, [])
    assert "**Of 2 distinct statements of the paper that can be judged 0 hold (0 %)**" in page
    apart = page.split("## Where the paper contradicts itself")[1].split("## Predictions")[0]
    (row,) = (line for line in apart.splitlines() if "Figure 9" in line)
    cells = [cell.strip() for cell in row.replace("\\|", "or").split("|")[1:-1]]
    assert cells == ["statement", "yes", "taken (fails)", "Figure 9 says so or twice"]
    assert claims_html(held).count("</tr>") == 1 + len(held.claims)
    failed = page.split("## What fails, and what would change it")[1]
    assert "**taken**" in failed
    assert "**other**" in failed
    assert "**aside**" not in failed


def numbered(value):
    """A verdict that holds, with this number."""
    return Verdict(str(value), (value,), 0, 0.0, 0.0, (0.0, 0.0), True, True)


def test_headlines_give_the_range_of_the_ensemble_or_how_many_agree():
    wordy = Verdict("boundary", (), 0, 0.0, 0.0, (0.0, 0.0), True, True)
    main = (numbered(10.0), HELD, wordy, HELD, numbered(3.0))
    members = [
        Judgement("member", (numbered(float(n)), HELD, MISSED if n < 5 else wordy, HELD, HELD))
        for n in range(21)
    ]
    judged = trial(main)
    judged = Trial(judged.claims, judged.main, tuple(members), (), ())
    rows = {row["id"]: row for row in verdicts.headline_rows(judged, ["taken", "one"])}
    assert list(rows) == ["taken", "one"]
    assert rows["taken"]["ensemble, 90 %"] == "1 to 19"
    assert (rows["taken"]["paper"], rows["taken"]["model"]) == ("1.0", "10.0")
    assert rows["one"]["ensemble, 90 %"] == "16 of 21 agree"


def window(low, high):
    """A verdict that holds, with these ends."""
    return Verdict(f"{low} to {high}", (low, high), 1, 0.0, 0.0, (0.0, 0.0), True, True)


def test_each_number_of_a_statement_has_its_own_range():
    members = [
        Judgement("member", (window(n / 20, 1 + n / 10), HELD, HELD, HELD, HELD)) for n in range(21)
    ]
    judged = replace(
        trial((window(0.5, 2.0), HELD, HELD, HELD, HELD)),
        ensemble=(*members, Judgement("none", (MISSED._replace(numbers=()), *(HELD,) * 4))),
    )
    (row,) = verdicts.headline_rows(judged, ["taken"])
    assert row["ensemble, 90 %"] == "0.05 to 0.95, 1.1 to 2.9"
    row = verdicts.verdict_rows(judged)[0]
    assert (row["value"], row["range_low"], row["range_high"]) == pytest.approx((2.0, 1.1, 2.9))


def test_what_is_the_same_on_every_curve_is_said_once():
    same = HELD._replace(measured="1, 1, 1", numbers=(1.0,) * 3)
    judged = trial((same, HELD, HELD, HELD, HELD))
    judged = replace(judged, ensemble=(Judgement("member", judged.main.verdicts),))
    (row,) = verdicts.headline_rows(judged, ["taken"])
    assert (row["model"], row["ensemble, 90 %"]) == ("1", "1 to 1")


def test_the_first_reading_is_the_one_that_the_rule_prefers():
    def content(objective, penalty, unknowns):
        return {
            "objective": objective,
            "penalty": penalty,
            "identification": dict.fromkeys(map(str, range(unknowns))),
        }

    most, fewer = (HELD,) * 5, (MISSED, HELD, HELD, HELD, HELD)
    judged = trial(most, fewer, most, most, most)
    contents = [content(1, 0, 1), content(4, 1.0, 3), content(3, 0.5, 3), content(2, 0.5, 2)]
    ranked = [row["reading"] for row in verdicts.reading_rows(judged, contents, [])]
    assert ranked == ["reading 3", "reading 2", "reading 1", "reading 0"]


def test_programs_read_what_the_page_says():
    nan = float("nan")
    judged = trial(
        (HELD, MISSED, HELD, MISSED, Verdict("?", (nan,), 0, nan, nan, (nan, nan), False, False))
    )
    judged = replace(judged, ensemble=(Judgement("member", judged.main.verdicts),))
    content = json.loads(claims_json(judged, DEFAULT, [], ["taken"]))
    assert (content["held"], content["judged"]) == (1, 2)
    assert content["inputs"] == DEFAULT["inputs"]
    assert [row["id"] for row in content["headline"]] == ["taken"]
    assert [row["id"] for row in content["predictions"]] == ["kept back"]
    first, *_, last = content["statements"]
    assert (first["place"], first["published"], first["range"]) == ("Figure 4A", 1.0, [[1.0, 1.0]])
    (curve,) = first["curves"]
    assert (curve["viscosity"], curve["roughness"], curve["particle_diameter"]) == (0, 3e-7, None)
    assert first["references"] == [curve | {"viscosity": 9e-5}]
    assert first["loads"] == {"load_max": 1e-5}
    assert (first["tolerance"], first["tolerance_kind"]) == (0.1, "absolute")
    assert (last["score"], last["numbers"], last["range"]) == (None, [None], [[None, None]])


def test_a_table_tells_the_curves_and_the_kind_of_each_tolerance():
    judged = trial((HELD,) * 5)
    row = verdicts.verdict_rows(judged)[0]
    assert row["curves"] == "nu = 0 cSt; sigma = 300 nm; load_max = 1e-05; held against nu = 90 cSt"
    (line,) = (
        line
        for line in claims_markdown(judged, DEFAULT, [], []).splitlines()
        if line.startswith("| taken ") and "| statement " in line
    )
    assert "| 0.1, absolute " in line


def test_an_input_is_moved_only_where_a_surface_can_have_it(parameters):
    def judge(name, inputs, effort=None):
        if inputs["summit_parameter"] < parameters.summit_parameter:
            raise ValueError("summit_parameter leaves no variance to the summits")
        return Judgement(name, ())

    court = SimpleNamespace(claims=(), base=parameters, judge=judge)
    unknown = Unknown("summit_parameter", (0.02, 2.0), (0.1, 1.0), True)
    reading = SimpleNamespace(unknowns=[unknown])
    held = Trial.of(court, {"inputs": {}, "ensemble": [{}]}, reading, [])
    assert [each.name for each in held.nudged] == ["higher summit parameter"]
    assert len(held.ensemble) == 1
