"""Numbers in README and docs are those of the run; the page of the verdicts begins with them."""

import json
import re
import runpy
from pathlib import Path

import pytest

from chenhorng.claims.words import COLOURS
from chenhorng.findings import judged_findings
from thirdbody.files import read_yaml

pytestmark = pytest.mark.results

ROOT = Path(__file__).parents[2]
RESULTS = ROOT / "results"
TOOL = ROOT / "docs" / "readme_numbers.py"


def test_the_pages_say_what_the_results_say(capsys):
    status = runpy.run_path(TOOL)["main"]([])
    assert status == 0, capsys.readouterr().out


def test_the_default_is_the_interpretation_that_the_rule_ranks_first():
    content = json.loads((RESULTS / "claims" / "claims.json").read_text(encoding="utf-8"))
    ranked = [row["interpretation"] for row in content["interpretations"]]
    if content["interpretations"][0]["left_out_loss"] is None:
        pytest.skip("no cross-validation has been run")
    assert content["interpretation"] == ranked[0]
    assert content["interpretations"][0]["equal"]
    assert (ROOT / read_yaml(ROOT / "config" / "config.yaml")["calibrated"]).stem == ranked[0]


def test_the_claims_page_begins_with_the_verdict_and_the_headline_numbers():
    content = json.loads((RESULTS / "claims" / "claims.json").read_text(encoding="utf-8"))
    page = (RESULTS / "claims" / "claims.md").read_text(encoding="utf-8")
    head = page[: page.index("## How to read this page")]
    assert f"{content['held']} of {content['judged']} checkable statements hold" in head
    if content["predicted_of"]:
        assert f"{content['predicted']} of {content['predicted_of']} hold when" in head
    settings = read_yaml(ROOT / "config" / "calibration.yaml")
    assert {row["id"] for row in content["headline"]} == set(settings["headline"])
    for row in content["headline"]:
        assert row["statement"] in head
        assert row["model"] in head


def test_the_first_screen_and_the_page_of_verdicts_have_one_count_and_one_palette():
    content = json.loads((RESULTS / "claims" / "claims.json").read_text(encoding="utf-8"))
    index, page = (
        (RESULTS / name).read_text(encoding="utf-8")
        for name in ("index.html", "claims/claims.html")
    )
    first = index[index.index("<h1") : index.index("How this is counted")]
    assert f"<b>{content['held']} of {content['judged']}</b>" in first
    assert f"{len(content['statements'])}" not in first
    findings = judged_findings(
        read_yaml(ROOT / "config" / "findings.yaml", list), content["statements"]
    )
    for place, finding in enumerate(findings, start=1):
        heading = f'{place}. <b aria-hidden="true">{finding["mark"]}</b> '
        assert heading + finding["outcome"].capitalize() in first
        assert f"{finding['held']} of {finding['judged']} statements that test it hold" in first
        assert (RESULTS / "figures" / f"{finding['panel']}.svg").is_file()
        assert all(f"claims.html#{row['id']}" in first for row in finding["failed"])
        repeats = len(finding["failed"]) - (finding["judged"] - finding["held"])
        part = first[first.index(heading) :].partition("</li>\n<li>")[0]
        assert ("Which fail, with repeats: " in part) is (repeats > 0)
    for table in "departures", "limits":
        assert f'href="tables/{table}.html"' in first
    in_findings = sum(finding["judged"] for finding in findings)
    assert f"{in_findings} of the {content['judged']} test them" in first
    shares = [part for each in findings for part in (each["held"], each["judged"] - each["held"])]
    assert [int(part) for part in re.findall(r'style="flex: (\d+)"', first)] == [
        *filter(None, shares)
    ]
    for verdict, colour in COLOURS.items():
        assert f"--{verdict.split()[0]}: {colour};" in page
        assert f".share .{verdict.split()[0]} {{ background: {colour}; }}" in index
    assert all(
        "print" in query or "screen" in query for query in re.findall(r"@media.*", index + page)
    )
