"""Puts the numbers of the last run into the README, between its markers.

    python tools/readme_numbers.py            say which blocks differ from results/, exit 1 if any
    python tools/readme_numbers.py --write    renew them
"""

import re
import sys
from pathlib import Path

from tabulate import tabulate

from thirdbody.tables import TABLES, read_csv
from thirdbody.verdicts import counts

ROOT = Path(__file__).resolve().parents[1]
README = ROOT / "README.md"
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


BLOCKS = {"claims": claims_block, "windows": turning_points_block}


def renewed(text: str) -> str:
    """``text`` with every block between ``<!-- name -->`` and ``<!-- /name -->`` made again."""
    for name, block in BLOCKS.items():
        pattern = rf"(<!-- {name} -->\n).*?(<!-- /{name} -->)"
        content = block()
        text = re.sub(pattern, lambda match: f"{match[1]}{content}\n{match[2]}", text, flags=re.S)
    return text


def main(arguments) -> int:
    """Exit status: 0 if the README says what results/ say."""
    text = README.read_text(encoding="utf-8")
    new = renewed(text)
    if "--write" in arguments:
        README.write_text(new, encoding="utf-8")
    elif new != text:
        print("README.md: numbers differ from results/; run tools/readme_numbers.py --write")
        return 1
    return 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
