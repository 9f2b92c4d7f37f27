"""Whether a finding of the paper comes out follows from the verdicts on its statements alone."""

import pytest

from chenhorng.claims.claims import load_claims
from chenhorng.findings import (
    IN_PART,
    NOT,
    REPRODUCED,
    in_no_finding,
    judged_findings,
    outcome,
    worth_of_inputs,
)
from chenhorng.home import config_directory
from thirdbody.files import read_yaml

FINDINGS = read_yaml(config_directory() / "findings.yaml", list)
FINDING = {"tested_by": ["a", "twice"], "numbers": "{a[numbers][0]:.1f} for {a[published]}"}


def row(id, verdict, cluster="", numbers=(2.0,), predicted=""):
    known = {"id": id, "cluster": cluster, "verdict": verdict, "predicted": predicted}
    return known | {"numbers": numbers, "published": 3}


def judged(*verdicts):
    rows = [row("a", verdicts[0]), *(row(f"b{i}", v, "twice") for i, v in enumerate(verdicts[1:]))]
    (found,) = judged_findings([FINDING], [*rows, row("other", "fails")])
    return found


@pytest.mark.parametrize(
    ("held", "of", "word"), [(3, 3, REPRODUCED), (2, 4, IN_PART), (1, 3, NOT), (0, 0, NOT)]
)
def test_a_finding_is_reproduced_if_all_hold_and_in_part_from_half_on(held, of, word):
    assert outcome(held, of) == word


def test_statements_of_a_cluster_count_once_and_each_that_fails_is_named():
    found = judged("holds", "holds", "fails")
    assert (found["held"], found["judged"], found["outcome"]) == (1, 2, IN_PART)
    assert [each["id"] for each in found["failed"]] == ["b1"]
    assert judged("holds", "holds", "contradicted by the paper itself")["outcome"] == REPRODUCED


def test_what_holds_without_its_figure_and_what_tests_no_finding_are_counted():
    rows = [row("a", "holds", predicted="fails"), row("twice", "fails", predicted="holds")]
    (found,) = judged_findings([FINDING], rows)
    assert (found["held"], found["predicted"]) == (1, 1)
    others = [row("c", "holds"), row("d", "fails", "e"), row("f", "holds", "e"), row("g", "")]
    assert in_no_finding([FINDING], rows + others) == (1, 2)


def test_the_numbers_are_those_of_the_statements():
    assert judged("holds", "holds")["numbers"] == "2.0 for 3"
    (moved,) = judged_findings([FINDING], [row("a", "holds"), row("twice", "holds")], 0.1)
    assert moved["numbers"] == "2.2 for 3"
    (none,) = judged_findings([FINDING], [row("a", "fails", "", [None]), row("twice", "holds")])
    assert none["numbers"] == "nan for 3"


def test_inputs_are_held_against_the_words_of_the_paper_and_against_what_surfaces_can_have():
    departures = [{"departure": "as it is"}, {"departure": "baseline: as worded"}]
    limits = [
        {"condition": "any", "quantity": "x", "value": 1.234, "verdict": "impossible"},
        {"condition": "any", "quantity": "y", "value": 1.0, "verdict": "possible"},
        {"condition": "any", "quantity": "z", "value": 1.0, "verdict": None},
    ]
    assert worth_of_inputs(departures, limits) == {
        "worded": departures[1],
        "impossible": ["x = 1.23 (any)"],
    }
    assert worth_of_inputs(departures[:1], limits[1:]) == {"worded": None, "impossible": []}


def test_a_statement_that_does_not_exist_is_named():
    with pytest.raises(ValueError, match="twice: no statement"):
        judged_findings([FINDING], [row("a", "holds")])


def test_the_five_findings_are_tested_by_statements_of_the_paper_and_each_tests_one():
    names = {claim.counted_as for claim in load_claims(config_directory() / "claims.yaml")}
    tested = [name for finding in FINDINGS for name in finding["tested_by"]]
    assert len(FINDINGS) == 5
    assert {*tested} <= names and len({*tested}) == len(tested)
