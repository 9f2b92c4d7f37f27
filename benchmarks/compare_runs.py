"""Compare the results of two runs of the workflow, for instance before and after an update of a dependency.

    python -m benchmarks.compare_runs OLD_RESULTS NEW_RESULTS [--rtol 1e-8]

Datasets are compared variable by variable, CSV tables (also those of figures) number by number, ``claims.csv`` verdict
by verdict, other files by their bytes.  Each file that differs gets a line.  The exit code is 1 if a file is missing, a
text or status differs, or a number differs by more than ``--rtol``.  Bytes of other files may differ.
"""

from __future__ import annotations

import argparse
import csv
import math
from collections.abc import Iterator
from pathlib import Path

import numpy as np
import xarray as xr

TEXTS = {"lubrication_regime", "contact_mode", "solution_status"}  # flags: any change counts
MEASURED = ("accuracy/",)  # times and memory differ from run to run
Difference = tuple[
    str, float
]  # where, and the largest relative difference; infinite where texts differ


def relative(old: np.ndarray, new: np.ndarray) -> float:
    """Largest relative difference of two arrays; infinite where only one is a finite number."""
    if old.shape != new.shape:
        return math.inf
    old, new = np.asarray(old, float), np.asarray(new, float)
    same = (old == new) | (np.isnan(old) & np.isnan(new))
    with np.errstate(all="ignore"):
        apart = np.abs(new - old) / np.maximum(np.abs(old), np.abs(new))
    apart = np.where(np.isnan(apart), math.inf, apart)
    return float(np.max(apart, where=~same, initial=0.0))


def compare_datasets(old: Path, new: Path) -> Iterator[Difference]:
    """Differences of the variables of two NetCDF files."""
    with (
        xr.open_dataset(old, decode_times=False) as a,
        xr.open_dataset(new, decode_times=False) as b,
    ):
        for name in sorted({*a.variables} | {*b.variables}):
            if name not in a.variables or name not in b.variables:
                yield f"variable {name} missing", math.inf
                continue
            x, y = a[name].values, b[name].values
            if name in TEXTS or x.dtype.kind not in "fiu":
                changed = x.shape != y.shape or np.count_nonzero(x != y)
                if changed:
                    yield f"{name} at {int(changed)} points", math.inf
            elif apart := relative(x, y):
                yield name, apart


def compare_tables(old: Path, new: Path) -> Iterator[Difference]:
    """Differences of two CSV files, column by column; of verdicts, row by row."""
    a, b = (list(csv.DictReader(path.open(encoding="utf-8", newline=""))) for path in (old, new))
    if len(a) != len(b) or (a and a[0].keys() != b[0].keys()):
        yield f"{len(a)} rows became {len(b)}, or other columns", math.inf
        return
    largest: dict[str, float] = {}
    for number, (x, y) in enumerate(zip(a, b, strict=True), start=1):
        for column in x:
            if column == "verdict" and x[column] != y[column]:
                what = x.get("claim") or x.get("id") or f"row {number}"
                yield f"{what}: {x[column]} became {y[column]}", math.inf
            elif x[column] != y[column]:
                apart = relative_of_cells(x[column], y[column])
                largest[column] = max(largest.get(column, 0.0), apart)
    yield from largest.items()


def relative_of_cells(old: str, new: str) -> float:
    """Relative difference of two numbers; infinite for texts."""
    try:
        return relative(np.array(float(old)), np.array(float(new)))
    except ValueError:
        return math.inf


def compare_bytes(old: Path, new: Path) -> Iterator[Difference]:
    """One difference of size zero if the bytes differ."""
    if old.read_bytes() != new.read_bytes():
        yield "other bytes", 0.0


def compare_runs(old: Path, new: Path) -> Iterator[tuple[str, list[Difference]]]:
    """Relative paths of all files that differ, with their differences."""
    a, b = (
        {str(path.relative_to(folder)): path for path in folder.rglob("*") if path.is_file()}
        for folder in (old, new)
    )
    kinds = {".nc": compare_datasets, ".csv": compare_tables}
    for name in sorted({*a} | {*b}):
        if name.startswith(MEASURED) or "/." in f"/{name}":
            continue
        if name not in a or name not in b:
            yield name, [("only in the " + ("old" if name in a else "new") + " run", math.inf)]
        elif found := list(kinds.get(Path(name).suffix, compare_bytes)(a[name], b[name])):
            yield name, found


def main(arguments: list[str] | None = None) -> int:
    """Print a line for each file that differs, and a summary; the exit code."""
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("old", type=Path)
    parser.add_argument("new", type=Path)
    parser.add_argument("--rtol", type=float, default=1e-8)
    given = parser.parse_args(arguments)
    differing, beyond = 0, 0
    for name, found in compare_runs(given.old, given.new):
        differing += 1
        beyond += any(apart > given.rtol for _, apart in found)
        parts = (
            where if apart in (0.0, math.inf) else f"{where} {apart:.1e}" for where, apart in found
        )
        print(f"{name}: {', '.join(parts)}")
    print(f"{differing} files differ, {beyond} of them beyond {given.rtol:g}")
    return 1 if beyond else 0


if __name__ == "__main__":
    raise SystemExit(main())
