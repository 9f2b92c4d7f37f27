"""Size and time to read of datasets under each lossless compression that NetCDF-4 offers.

    python benchmarks/measure_compression.py results/datasets/*.nc

Every file is written anew with each setting, each variable as one chunk, and then read whole
several times.  The least processor time counts, so that the disk and other programs play no part.
"""

from __future__ import annotations

import argparse
import tempfile
import time
from collections.abc import Mapping, Sequence
from os import PathLike
from pathlib import Path
from typing import Any

import netCDF4

READINGS = 7
SETTINGS = {
    "none": {},
    "zlib 1": {"compression": "zlib", "complevel": 1, "shuffle": False},
    "zlib 1, shuffle": {"compression": "zlib", "complevel": 1, "shuffle": True},
    "zlib 4, shuffle": {"compression": "zlib", "complevel": 4, "shuffle": True},
    "zlib 6": {"compression": "zlib", "complevel": 6, "shuffle": False},
    "zlib 9": {"compression": "zlib", "complevel": 9, "shuffle": False},
    "zlib 9, shuffle": {"compression": "zlib", "complevel": 9, "shuffle": True},
    "szip": {"compression": "szip", "szip_coding": "nn", "szip_pixels_per_block": 32},
    "zstd 4, shuffle": {"compression": "zstd", "complevel": 4, "shuffle": True},
}


def rewrite(source: str | PathLike, target: str | PathLike, setting: Mapping[str, Any]) -> None:
    """Copy a NetCDF file with another compression.

    Parameters
    ----------
    source, target : path
        File to read and file to write.
    setting : mapping
        Arguments of ``netCDF4.Dataset.createVariable`` for variables of several dimensions.

    Raises
    ------
    RuntimeError
        If the installed library does not offer this compression.
    """
    with netCDF4.Dataset(source) as old, netCDF4.Dataset(target, "w") as new:
        for name, dimension in old.dimensions.items():
            new.createDimension(name, len(dimension))
        new.setncatts({name: old.getncattr(name) for name in old.ncattrs()})
        for name, variable in old.variables.items():
            gridded = variable.ndim > 1
            attributes = {key: variable.getncattr(key) for key in variable.ncattrs()}
            copied = new.createVariable(
                name,
                variable.dtype,
                variable.dimensions,
                fill_value=attributes.pop("_FillValue", False),
                chunksizes=variable.shape if gridded else None,
                **(setting if gridded else {}),
            )
            copied.setncatts(attributes)
            copied.set_auto_maskandscale(False)
            variable.set_auto_maskandscale(False)
            copied[:] = variable[:]


def reading_time(paths: Sequence[str | PathLike]) -> float:
    """Processor time [s] to open files and read all that they hold, the least of several times."""
    times = []
    for _ in range(READINGS):
        start = time.process_time()
        for path in paths:
            with netCDF4.Dataset(path) as file:
                for variable in file.variables.values():
                    variable[:]
        times.append(time.process_time() - start)
    return min(times)


def measure(sources: Sequence[str | PathLike]) -> None:
    """Print a row for each setting: bytes, share of the uncompressed size, times."""
    print(f"{'setting':17} {'bytes':>10} {'share':>6} {'write ms':>9} {'read ms':>8}")
    uncompressed = None
    for label, setting in SETTINGS.items():
        with tempfile.TemporaryDirectory() as folder:
            targets = [Path(folder) / Path(source).name for source in sources]
            start = time.process_time()
            try:
                for source, target in zip(sources, targets, strict=True):
                    rewrite(source, target, setting)
            except RuntimeError as error:
                print(f"{label:17} not available: {error}")
                continue
            writing = time.process_time() - start
            size = sum(target.stat().st_size for target in targets)
            uncompressed = uncompressed or size
            times = f"{1e3 * writing:9.0f} {1e3 * reading_time(targets):8.1f}"
            print(f"{label:17} {size:10} {size / uncompressed:6.1%} {times}")


if __name__ == "__main__":
    parser = argparse.ArgumentParser(description=__doc__.partition("\n")[0])
    parser.add_argument("datasets", nargs="+", help="NetCDF files")
    measure(parser.parse_args().datasets)
