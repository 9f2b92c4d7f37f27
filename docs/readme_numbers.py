"""Put the numbers of the last run, and the output of examples, into README and pages of the
documentation.

A block of a page stands between two markers with its name.

    python docs/readme_numbers.py            name pages that differ from results/, exit 1 for any
    python docs/readme_numbers.py --write    renew the blocks of all pages
    python docs/readme_numbers.py --show took    print the block with this name

The last bits of a number depend on the processor.  So a page agrees with a run if it shows the same
digits; a number at the edge of two roundings may show either.  The measurements of `make accuracy`
differ from run to run: a page agrees if its numbers agree up to a factor.  Without such a run the
page keeps its numbers.
"""

import io
import json
import re
import subprocess
import sys
from contextlib import redirect_stdout
from functools import partial
from pathlib import Path
from textwrap import fill

import numpy as np
import pandas as pd
from matplotlib.pyplot import imread
from scipy.special import erf
from tabulate import tabulate

import thirdbody
from benchmarks.work_precision import largest_errors
from chenhorng.claims.words import counted_once
from chenhorng.findings import MARKS, RULE, in_no_finding, judged_findings
from chenhorng.markdown import markdown_text
from chenhorng.tables import TABLES, read_csv
from thirdbody.core.particles import first_yield_depth
from thirdbody.files import read_yaml
from thirdbody.symbols import unicode

ROOT = Path(__file__).resolve().parents[1]
BITS = 1e-9  # relative difference of a number on another processor
README = ROOT / "README.md"
DOCS = [ROOT / "docs" / f"{name}.md" for name in ("results", "history", "workflow")]
PAGES = README, ROOT / "paper.md", *DOCS
COLLECTING = "all", "write_sums"  # rules that read everything
RESULTS = ROOT / "results"
ACCURACY = RESULTS / "accuracy"
MEASURED_PICTURE = ROOT / "docs" / "work_precision.png", ACCURACY / "work_precision.png"
PANEL = "panel_turning_point_viscosity"  # of README
PICTURES = {  # pictures in docs/, and the figures that they copy
    ROOT / "docs" / "figure01.png": RESULTS / "figures" / "fig01.png",
    ROOT / "docs" / "figure11.png": RESULTS / "figures" / "fig11.png",
    ROOT / "docs" / "claims.png": RESULTS / "figures" / "claims.png",
    ROOT / "docs" / f"{PANEL}.png": RESULTS / "figures" / f"{PANEL}.png",
    ROOT / "docs" / "profiles.png": RESULTS / "figures" / "profiles.png",
}


def read_rows(name: str, move: float = 0.0) -> list[dict]:
    """The rows of a table of results/tables, numbers changed by the fraction ``move``."""
    rows = read_csv(RESULTS / "tables" / f"{name}.csv", TABLES[name])
    return [{column: _moved(value, move) for column, value in row.items()} for row in rows]


def _moved(value, move):
    """A value of a table, changed by the fraction ``move`` if it is a number but no count."""
    is_real = isinstance(value, float) and not value.is_integer()
    return value * (1.0 + move) if is_real else value


def read_claims() -> dict:
    """The verdicts, and the sentences about them."""
    return json.loads((RESULTS / "claims" / "claims.json").read_text(encoding="utf-8"))


def claims_block(move: float = 0.0) -> str:
    """The score beside what other inputs hold, the printed numbers, and what ranges are worth."""
    departures = {row["departure"]: row for row in read_rows("departures", move)}
    least, most = (
        next(row for name, row in departures.items() if f", the {word} of" in name)
        for word in ("least", "most")
    )
    printed = departures["baseline: all but summits and A_n as the text words it"]
    null = (
        f"Usual inputs at random hold {least['holds']:g} to {most['holds']:g} of "
        f"{most['judged']:g}, the words of the text as printed {printed['holds']:g} of "
        f"{printed['judged']:g}."
    )
    inside = [row["inside"] == "yes" for row in read_rows("coverage")]
    rows = read_csv(RESULTS / "tables" / "held_out.csv", TABLES["own_claims"])
    known, new = (
        counted_once(
            (row["cluster"] or row["id"], row["verdict"])
            for row in rows
            if bool(row["figures"]) is in_figures
        )
        for in_figures in (True, False)
    )
    others = (
        f"Of {known[1] + new[1]} statements in the abstracts of three other papers on the model, "
        f"which no search has seen, {known[0] + new[0]} hold: {known[0]} of the {known[1]} that "
        f"figures of the paper say too, and {new[0]} of the {new[1]} that none says."
    )
    sizes = pd.DataFrame(read_rows("deviations", move))["deviation"].abs()
    deviations = (
        f"Of the {len(sizes)} numbers in the headline statements the median deviation is "
        f"{sizes.median():.1%}, the mean {sizes.mean():.1%}; {sum(inside)} of the {len(inside)} "
        "lie in the range of members of the ensemble that have not seen their figure."
    )
    return fill(f"{read_claims()['score']} {null} {deviations} {others}", 120)


def findings_block(move: float = 0.0) -> str:
    """What the paper finds, and whether it comes out."""
    judged = read_claims()
    findings = read_yaml(ROOT / "config" / "findings.yaml", list)
    held, of = in_no_finding(findings, judged["statements"])
    score = (
        f"{judged['held']} of {judged['judged']} checkable statements of the paper hold, with one "
        f"set of inputs. {judged['predicted']} of {judged['predicted_of']} are predicted: they "
        f"hold with inputs that were found without their figure. Five sentences of ours sum up the "
        f"paper. {RULE} {of} statements test none of the five; {held} of them hold."
    )
    lines = [fill(score, 120), ""]
    for place, each in enumerate(judged_findings(findings, judged["statements"], move), start=1):
        parts = list(dict.fromkeys(row["part"] for row in each["failed"]))
        failed = f"; failures: {', '.join(parts)}" if parts else ""
        line = (
            f"{place}. {each['mark']} **{each['outcome'].capitalize()}** ({each['held']} of "
            f"{each['judged']} statements hold, {each['predicted']} are predicted{failed})."
            f" {_typeset(each['sentence'])} "
            f"*{each['figure']}: {_typeset(each['numbers'])}*"
        )
        lines.append(fill(line, 120, subsequent_indent="   ", break_on_hyphens=False))
    return "\n".join(lines)


def outcomes_block(move: float = 0.0) -> str:
    """How many of the findings are reproduced, and in part."""
    findings = read_yaml(ROOT / "config" / "findings.yaml", list)
    words = [each["outcome"] for each in judged_findings(findings, read_claims()["statements"])]
    all_of_it, some, none = map(words.count, MARKS)
    counts = f"{all_of_it} are reproduced, {some} in part and {none} not"
    return fill(f"Of {len(words)} sentences that sum up the paper {counts}. {RULE}", 120)


def _typeset(text):
    return markdown_text(unicode(text))


def ranking_block() -> str:
    """All interpretations in the order of the rule."""
    ranking = pd.read_csv(ROOT / "config" / "calibrated" / "ranking.csv")
    ranking["equal"] = ranking["equal"].map({True: "yes", False: ""})
    ranking["interpretation"] = "`" + ranking["interpretation"] + "`"
    ranking["mean_deviation"] = [f"{each:.1%}" for each in ranking["mean_deviation"]]
    table = ranking[RANKED].rename(columns=lambda name: name.replace("_", " "))
    return tabulate(
        table, headers="keys", tablefmt="github", showindex=False, disable_numparse=True
    )


def library_block() -> str:
    """The output of the example in README."""
    (example,) = re.findall(r"```python\n(.*?)```", README.read_text(encoding="utf-8"), re.DOTALL)
    printed = io.StringIO()
    with redirect_stdout(printed):
        exec(example, {})
    return f"```text\n{printed.getvalue()}```"


def rules_block() -> str:
    """The graph of the rules, without the collecting ones, in the language of mermaid."""
    command = [sys.executable, "-m", "snakemake", "--rulegraph", "mermaid-js"]
    graph = subprocess.run(command, cwd=ROOT, capture_output=True, text=True, check=True).stdout
    names = dict(re.findall(r"(id\d+)\[(\w+)\]", graph))
    edges = [tuple(map(names.get, edge)) for edge in re.findall(r"(id\d+) --> (id\d+)", graph)]
    lines = [f"    {one} --> {other}" for one, other in sorted(edges) if other not in COLLECTING]
    return "\n".join(["```mermaid", "flowchart LR", *lines, "```"])


def took_block(move: float = 0.0) -> str:
    """The assumptions of the calibrated inputs beyond the print, and the number of statements that
    hold without each of them."""
    inputs = thirdbody.load_parameters().best
    rows = read_rows("departures", move)
    held = {row["departure"]: f"{row['holds']:g} of {row['judged']:g}" for row in rows}
    below = erf(1.0 / (inputs.spread_ratio * np.sqrt(2.0)))
    first_yield = inputs.elastic_depth_ratio / first_yield_depth(inputs)
    lines = [
        ("all inputs as calibrated", "", "", held["as it is"]),
        (
            "depth h_e of the elastic zone",
            "no value",
            f"{inputs.elastic_depth_ratio:.2f} x_a, {first_yield:.0f} times that of first yield",
            held["h_e at first yield"],
        ),
        (
            "size x_a",
            '"mean particle diameter", but Eq. 6 has no mean',
            f"{100 * below:.0f} in 100 particles are smaller",
            held["x_a as the mean size"],
        ),
        (
            "deviation of the summits",
            "no value",
            f"{inputs.summit_deviation_ratio:.2f} σ",
            held["summits scatter as the surface"],
        ),
        (
            "plane of the summits",
            "not mentioned",
            f"{inputs.summit_offset_ratio:.2f} σ above the mean plane, at 300 nm",
            held["one plane for summits and surface"],
        ),
        (
            "particles that carry load",
            "all",
            f"{inputs.participation:.0%} of them",
            held["all particles carry load"],
        ),
        ("load in W of Eq. 8", "F_t", "F_f, that of the film", held["W of F_t"]),
        (
            "apparent area A_n",
            "no value, but the digits of its loads",
            f"{1e6 * inputs.apparent_area:.2f} mm²",
            "",
        ),
        (
            "all but summits and A_n as the text words it",
            "",
            "",
            held["baseline: all but summits and A_n as the text words it"],
        ),
    ]
    names = "assumed", "the paper", "here", "statements that hold without it"
    table = [dict(zip(names, line, strict=True)) for line in lines]
    return tabulate(table, headers="keys", tablefmt="github", disable_numparse=True)


# method, rtol, and the uses that they serve
CHOICES = (
    ("library_grid", 1e-3, "maps, sweeps of 10⁸ points, the atlas"),
    (
        "library",
        1e-9,
        "all else: fits, uncertainty studies, results that others build on (the default)",
    ),
)
CALLS = {"library": "`tb.solve`", "library_grid": "`tb.grid`"}
PLAIN_SOLVER = "nested_roots", None


SHOWN = "times", "errors", "uses"  # tables of `make accuracy` in the block


def measured_costs() -> tuple[dict, list[dict], list[dict], list[dict]]:
    """Time of a point [µs] by method and ``rtol`` at usual conditions, and the tables ``SHOWN``."""
    times, errors, uses = (read_csv(ACCURACY / f"{name}.csv", TABLES[name]) for name in SHOWN)
    cost = {
        (row["method"], row["rtol"]): row["microseconds_per_point"]
        for row in times
        if row["span"] == "usual"
    }
    return cost, times, errors, uses


def accuracy_block() -> str:
    """The choice of call and ``rtol``: time, true error, and uses."""
    cost, _, errors, _ = measured_costs()
    error = largest_errors(errors)
    table = [
        {
            "call": CALLS[method],
            "`rtol`": f"{rtol:g}",
            "whom it serves": use,
            "time a point [µs]": f"{cost[method, rtol]:.2g}",
            "largest true error": f"{error[method, rtol, 'usual']:.0e}",
            "at extremes": f"{error[method, rtol, 'extremes']:.0e}",
        }
        for method, rtol, use in CHOICES
    ]
    return tabulate(table, headers="keys", tablefmt="github", disable_numparse=True)


def times_block() -> str:
    """Times of all kinds of calls."""
    cost, times, _, uses = measured_costs()
    coarse, default = (cost[choice[:2]] for choice in CHOICES)
    plain = cost[PLAIN_SOLVER]
    one, surfaces, stream, start = (row["microseconds_per_point"] for row in uses)
    return (
        f"Over all `rtol` `tb.solve` takes {_range(times, 'library', 'usual')} µs a point at "
        f"usual conditions; there `tb.grid` at 0.001 is {default / coarse:.2g} times as fast as "
        f"the default. At extremes `tb.solve` takes {_range(times, 'library', 'extremes')} µs, "
        f"`tb.grid` {_range(times, 'library_grid', 'extremes')} µs. In the same run `quad` and "
        f"`brentq` take {plain / 1e3:.2g} ms a point. A call with one point takes "
        f"{one / 1e3:.2g} ms, nearly all of it for calls of numpy: put many points into one call. "
        f"Points that each have their own surface take {surfaces:.2g} µs there, those of a grid "
        f"that is streamed to a file {stream:.2g} µs. A new process imports the library and has "
        f"its first answer after {start / 1e6:.2g} s."
    )


def _range(times, method, span) -> str:
    """The least and the greatest time of a point [µs] over all ``rtol``, as text."""
    taken = [
        row["microseconds_per_point"]
        for row in times
        if (row["method"], row["span"]) == (method, span)
    ]
    return f"{min(taken):.2g} to {max(taken):.2g}"


def oracle_block() -> str:
    """The numbers of wrong points, in comparison with extended precision."""
    rows = read_csv(ACCURACY / "oracle.csv", TABLES["oracle"])
    names = "points", "wrong", "beyond_bound", "not_converged", "without_values"
    points, wrong, beyond, less_exact, without = (
        int(sum(row[name] for row in rows)) for name in names
    )
    return (
        f"`results/accuracy/oracle.csv` counts it: of {points:,} solutions in all combinations of "
        f"interpretations, half of them next to kinks, {wrong} are wrong and {beyond} are beyond "
        f"their bound. {100.0 * less_exact / points:.1f} % have the status `not_converged`, "
        f"{100.0 * without / points:.1f} % have no values. The largest error of the others is "
        f"{max(row['largest_error'] / row['rtol'] for row in rows):.2f} of `rtol`."
    )


# columns of the ranking in the history
RANKED = [
    *("interpretation", "unknowns", "left_out_loss", "above_least", "standard_error", "equal"),
    *("objective", "penalty", "predicted", "fitted", "headline", "mean_deviation"),
]
OF_TABLES = {"findings": findings_block, "outcomes": outcomes_block}
OF_TABLES |= {"claims": claims_block, "took": took_block}  # functions of ``move``
COMPUTED = {"library": library_block, "ranking": ranking_block, "rules": rules_block}
MEASURED = {"accuracy": accuracy_block, "times": times_block, "oracle": oracle_block}
LARGEST_FACTOR = 3.0  # between times on different machines or in different runs
SHADE = 8.5 / 255.0  # largest difference of a pixel
NUMBER = re.compile(r"\d+(?:\.\d+)?(?:e[-+]?\d+)?")


def is_measured() -> bool:
    """Whether results/ have an accuracy run with every method and ``rtol`` of the table."""
    if not all((ACCURACY / f"{name}.csv").is_file() for name in SHOWN):
        return False
    rows = read_csv(ACCURACY / "times.csv", TABLES["times"])
    return {*(choice[:2] for choice in CHOICES), PLAIN_SOLVER} <= {
        (row["method"], row["rtol"]) for row in rows
    }


def is_compared() -> bool:
    """Whether a run has compared points in extended precision."""
    path = ACCURACY / "oracle.csv"
    return path.is_file() and bool(read_csv(path, TABLES["oracle"]))


def renewed(text: str, blocks: dict) -> str:
    """``text`` with new ``blocks`` between ``<!-- name -->`` and ``<!-- /name -->``."""
    for name, block in blocks.items():
        start, end = f"<!-- {name} -->\n", f"<!-- /{name} -->"
        if start in text:
            before, rest = text.split(start, 1)
            text = before + start + block() + "\n" + end + rest.split(end, 1)[1]
    return text


def show_the_same(text: str, runs: list[str]) -> bool:
    """Whether a text has the words of all ``runs``, and whether each of its numbers is that of a
    run.  The runs differ in bits."""
    if {tuple(NUMBER.sub("#", run).split()) for run in runs} != {
        tuple(NUMBER.sub("#", text).split())
    }:
        return False
    shown = zip(*map(NUMBER.findall, runs), strict=True)
    return all(number in allowed for number, allowed in zip(NUMBER.findall(text), shown))


def at_edges(text: str, blocks: dict) -> list[str]:
    """A page with new ``blocks``, functions of ``move``: the numbers of the run moved down and up
    by ``BITS``, and last as they are."""
    return [
        renewed(text, {name: partial(block, move) for name, block in blocks.items()})
        for move in (-BITS, BITS, 0.0)
    ]


def agree(text: str, other: str) -> bool:
    """Whether two texts differ in numbers alone, and by less than ``LARGEST_FACTOR``."""
    if NUMBER.sub("#", text).split() != NUMBER.sub("#", other).split():
        return False
    pairs = zip(map(float, NUMBER.findall(text)), map(float, NUMBER.findall(other)), strict=True)
    return all(a == b or a < LARGEST_FACTOR * b and b < LARGEST_FACTOR * a for a, b in pairs)


def look_the_same(one: np.ndarray, other: np.ndarray) -> bool:
    """Whether two pictures, shape (rows, columns, channels) with values 0 to 1, differ in at most
    one of 10,000 pixels, by at most ``SHADE``.  Other last bits of a curve change the shades of its
    edge so much."""
    if one.shape != other.shape:
        return False
    differences = np.abs(one - other).max(axis=-1)
    return bool(differences.max() <= SHADE and np.mean(differences > 0.0) <= 1e-4)


def main(arguments) -> int:
    """Exit status: 0 if the pages agree with results/."""
    if "--show" in arguments:
        print((OF_TABLES | COMPUTED | MEASURED)[arguments[-1]]())
        return 0
    stale = []
    is_there = {"accuracy": is_measured(), "times": is_measured(), "oracle": is_compared()}
    measured = {name: block for name, block in MEASURED.items() if is_there[name]}
    for page in PAGES:
        text = page.read_text(encoding="utf-8")
        *moved, new = at_edges(renewed(text, COMPUTED), OF_TABLES)
        newest = renewed(new, measured)
        if "--write" in arguments:
            page.write_text(newest, encoding="utf-8")
        elif not show_the_same(text, [*moved, new]) or not agree(text, newest):
            stale.append(page.name)
    for picture, figure in PICTURES.items():
        if "--write" in arguments:
            picture.write_bytes(figure.read_bytes())
        elif not look_the_same(imread(picture), imread(figure)):
            stale.append(picture.name)
    picture, figure = MEASURED_PICTURE  # it differs from run to run
    if "--write" in arguments and figure.is_file():
        picture.write_bytes(figure.read_bytes())
    if len(measured) < len(MEASURED):
        print("errors and times stay as they are: run make accuracy to renew them")
    if stale:
        print(f"{', '.join(stale)}: differ from results/; run docs/readme_numbers.py --write")
    return 1 if stale else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
