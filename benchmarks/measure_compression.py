"""Size and read time of datasets under each lossless compression that NetCDF-4 offers.

    python benchmarks/measure_compression.py results/datasets/*.nc

Every file is written anew with each setting, one chunk a variable, and then read whole several
times; the least processor time of all readings counts, so that neither disk nor neighbours do.
"""

import argparse
import tempfile
import time
from pathlib import Path

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


def rewrite(source, target, setting):
    """Copy the NetCDF file ``source`` to ``target``, its gridded variables under ``setting``."""
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


def reading_time(paths):
    """Processor seconds to open ``paths`` and read all of them, the least of several times."""
    times = []
    for _ in range(READINGS):
        start = time.process_time()
        for path in paths:
            with netCDF4.Dataset(path) as file:
                for variable in file.variables.values():
                    variable[:]
        times.append(time.process_time() - start)
    return min(times)


def measure(sources):
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
