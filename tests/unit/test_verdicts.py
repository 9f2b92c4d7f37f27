"""What is made of the verdicts: words, counts, and the page, on made-up judgements."""

import pytest

from thirdbody.study import verdicts
from thirdbody.study.checks import Verdict
from thirdbody.study.claims import Claim
from thirdbody.study.verdict_text import claims_markdown
from thirdbody.study.verdicts import Judgement, Trial, counted_once, discriminating, outcome

HELD = Verdict("1", 1.0, 0.0, 0.0, True, True)
MISSED = Verdict("2", 2.0, 1.0, 3.0, True, False)
BEYOND = Verdict("> 2", 2.0, 1.0, 0.0, False, False)


def claim(name, role="calibration", **fields):
    conditions = {"viscosity_cSt": 0, "roughness_nm": 300}
    return Claim(
        *(name, "Figure 4A", "statement", "value", role, conditions, 0.1, False, "reason"), **fields
    )


TAKEN = claim("taken", contradicts=("aside",), published=1.0)
ASIDE = claim("aside", contradicts=("taken",), aside="Figure 9 says so | twice", published=2.0)
TWINS = claim("one", cluster="twins"), claim("other", cluster="twins")
CLAIMS = (TAKEN, ASIDE, *TWINS, claim("kept back", role="withheld"))


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
    default = {"reading": "some", "objective": 1.0}
    contents = [{"objective": 1.0}]
    main = (MISSED, HELD, HELD, MISSED, HELD)
    held = trial(main, (HELD,) * 5)
    held = Trial(held.claims, held.main, (), (Judgement("lower one", main),), held.readings)
    page = claims_markdown(held, default, contents, [])
    assert "**0 of 2 hold, 0 %.**" in page
    apart = page.split("## Where the paper contradicts itself")[1].split("## The statements")[0]
    (row,) = (line for line in apart.splitlines() if line.startswith("| aside"))
    cells = [cell.strip() for cell in row.replace("\\|", "or").split("|")[1:-1]]
    assert cells == ["aside", "yes", "taken (fails)", "Figure 9 says so or twice"]
    failed = page.split("## What fails")[1]
    assert "**taken**" in failed
    assert "**other**" in failed
    assert "**aside**" not in failed
