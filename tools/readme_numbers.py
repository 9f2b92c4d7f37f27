"""Puts the numbers of the last run into README and docs, between their markers.

    python tools/readme_numbers.py            say which pages differ from results/, exit 1 if any
    python tools/readme_numbers.py --write    renew them
"""

import sys
from pathlib import Path

from tabulate import tabulate

from thirdbody.configuration import read_yaml
from thirdbody.tables import TABLES, read_csv
from thirdbody.verdicts import counts

ROOT = Path(__file__).resolve().parents[1]
PAGES = (ROOT / "README.md", ROOT / "docs" / "calibration.md")
RESULTS = ROOT / "results"


def claims_block() -> str:
    """Counts of the verdicts by role."""
    rows = read_csv(RESULTS / "claims" / "claims.csv", TABLES["claims"])
    return tabulate(counts(rows, "role"), headers="keys", tablefmt="github")


def turning_points_block() -> str:
    """The windows of the turning point, as computed."""
    rows = read_csv(RESULTS / "tables" / "tpca_windows.csv", TABLES["tpca_windows"])
    ends: dict[float, dict] = {}
    for row in rows:
        name = f"{row['end']} end of x_a/σ"
        ends.setdefault(row["roughness_m"], {})[name] = f"{row['diameter_over_roughness']:.3f}"
    table = [{"σ [nm]": f"{1e9 * roughness:g}", **row} for roughness, row in ends.items()]
    return tabulate(table, headers="keys", tablefmt="github", disable_numparse=True)


def calibrated_files() -> list[dict]:
    """Contents of all calibrated files, lowest objective first."""
    paths = sorted((ROOT / "config" / "calibrated").glob("*.yaml"))
    return sorted(map(read_yaml, paths), key=lambda content: content["objective"])


def readings_block() -> str:
    """Every reading with its objective and its margin to the best."""
    contents = calibrated_files()
    table = [
        {
            "reading": content["reading"],
            "objective": f"{content['objective']:.2f}",
            "above the best": f"{content['objective'] - contents[0]['objective']:.2f}",
            "of each seed": ", ".join(f"{each:.1f}" for each in content["objective_of_each_seed"]),
            "evaluations": content["evaluations"],
        }
        for content in contents
    ]
    return tabulate(table, headers="keys", tablefmt="github", disable_numparse=True)


def identified_block() -> str:
    """Inputs of the default reading, the range that is acceptable, and whether that pins them."""
    content = read_yaml(ROOT / read_yaml(ROOT / "config" / "config.yaml")["inputs"])
    table = [
        {
            "input": name,
            "best": f"{content['inputs'][name]:.3g}",
            "acceptable": "{:.3g} to {:.3g}".format(*found["acceptable"]),
            "identified": "yes" if found["identified"] else "no",
        }
        for name, found in content["identification"].items()
    ]
    return tabulate(table, headers="keys", tablefmt="github", disable_numparse=True)


BLOCKS = {
    "claims": claims_block,
    "windows": turning_points_block,
    "readings": readings_block,
    "identified": identified_block,
}


def renewed(text: str) -> str:
    """``text`` with every block between ``<!-- name -->`` and ``<!-- /name -->`` made again."""
    for name, block in BLOCKS.items():
        start, end = f"<!-- {name} -->\n", f"<!-- /{name} -->"
        if start in text:
            before, rest = text.split(start, 1)
            text = before + start + block() + "\n" + end + rest.split(end, 1)[1]
    return text


def main(arguments) -> int:
    """Exit status: 0 if the pages say what results/ say."""
    stale = []
    for page in PAGES:
        text = page.read_text(encoding="utf-8")
        new = renewed(text)
        if "--write" in arguments:
            page.write_text(new, encoding="utf-8")
        elif new != text:
            stale.append(page.name)
    if stale:
        print(f"{', '.join(stale)}: numbers differ from results/; run tools/readme_numbers.py --write")
    return 1 if stale else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
