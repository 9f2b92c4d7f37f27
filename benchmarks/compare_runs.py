"""Compare the results of two runs of the workflow, for instance before and after an update of a dependency.

    python -m benchmarks.compare_runs OLD_RESULTS NEW_RESULTS [--rtol 1e-8]

Each file that differs gets a line.  The exit code is 1 if a file is missing, a text, a verdict or a status differs, or
a number of a dataset or a CSV table differs by more than ``--rtol``.  Bytes of other files may differ.
"""

import argparse
import csv
import math
from collections.abc import Iterator
from pathlib import Path

import numpy as np
import xarray as xr

FLAGS = "lubrication_regime", "contact_mode", "solution_status"
MEASURED = "accuracy/"  # times and memory differ from run to run
Difference = tuple[str, float]  # what, and by how much relative to the larger; infinite for texts


def largest_difference(old: np.ndarray, new: np.ndarray) -> float:
    """Largest relative difference of two arrays; infinite where only one value is finite."""
    same = (old == new) | (np.isnan(old) & np.isnan(new))
    with np.errstate(all="ignore"):
        apart = np.abs(new - old) / np.maximum(np.abs(old), np.abs(new))
    return float(np.max(np.where(np.isnan(apart), math.inf, apart), where=~same, initial=0.0))


def compare_datasets(old: Path, new: Path) -> Iterator[Difference]:
    """Differences of the variables of two NetCDF files."""
    with xr.open_dataset(old, decode_cf=False) as a, xr.open_dataset(new, decode_cf=False) as b:
        for name in sorted({*a.variables, *b.variables}):
            if name not in a.variables or name not in b.variables:
                yield f"{name} in one of them", math.inf
                continue
            x, y = a[name].values, b[name].values
            if x.shape != y.shape:
                yield f"{name} of another shape", math.inf
            elif name in FLAGS or x.dtype.kind not in "fiu":
                if changed := np.count_nonzero(x != y):
                    yield f"{name} at {changed} points", math.inf
            elif apart := largest_difference(x.astype(float), y.astype(float)):
                yield name, apart


def compare_tables(old: Path, new: Path) -> Iterator[Difference]:
    """Differences of two CSV files by column; of verdicts, by row."""
    a, b = (list(csv.DictReader(path.open(encoding="utf-8", newline=""))) for path in (old, new))
    if len(a) != len(b) or (a and a[0].keys() != b[0].keys()):
        yield f"{len(a)} rows became {len(b)}, or columns differ", math.inf
        return
    largest: dict[str, float] = {}
    for number, (x, y) in enumerate(zip(a, b, strict=True), start=1):
        for column in (name for name in x if x[name] != y[name]):
            if column == "verdict":
                yield f"{x.get('id', number)}: {x[column]} became {y[column]}", math.inf
                continue
            try:
                apart = largest_difference(np.array(float(x[column])), np.array(float(y[column])))
            except ValueError:
                apart = math.inf  # of texts
            largest[column] = max(largest.get(column, 0.0), apart)
    yield from largest.items()


def compare_runs(old: Path, new: Path) -> Iterator[tuple[str, list[Difference]]]:
    """Names of all files that differ, and their differences."""
    a, b = (
        {str(path.relative_to(folder)): path for path in folder.rglob("*") if path.is_file()}
        for folder in (old, new)
    )
    kinds = {".nc": compare_datasets, ".csv": compare_tables}
    for name in sorted({*a, *b}):
        if name.startswith(MEASURED) or "/." in f"/{name}":
            continue
        if name not in a or name not in b:
            yield name, [(f"only in the {'old' if name in a else 'new'} run", math.inf)]
        elif a[name].read_bytes() != b[name].read_bytes():
            compare = kinds.get(Path(name).suffix)
            if found := list(compare(a[name], b[name])) if compare else [("other bytes", 0.0)]:
                yield name, found


def main(arguments: list[str] | None = None) -> int:
    """Print a line for each file that differs and a summary; return the exit code."""
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("old", type=Path)
    parser.add_argument("new", type=Path)
    parser.add_argument("--rtol", type=float, default=1e-8)
    given = parser.parse_args(arguments)
    differing = beyond = 0
    for name, found in compare_runs(given.old, given.new):
        differing += 1
        beyond += any(apart > given.rtol for _, apart in found)
        parts = (
            what if apart in (0.0, math.inf) else f"{what} {apart:.1e}" for what, apart in found
        )
        print(f"{name}: {', '.join(parts)}")
    print(f"{differing} files differ, {beyond} of them beyond {given.rtol:g}")
    return 1 if beyond else 0


if __name__ == "__main__":
    raise SystemExit(main())
