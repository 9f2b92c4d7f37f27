"""SHA-256 of what a NetCDF file says, whatever library and compression wrote it.

    python content_hash.py FILE.nc ...

The digest is taken over these lines and values, in UTF-8, each line ended by a newline, attributes
and variables sorted by name:

    dimension NAME LENGTH                  of each dimension
    attribute NAME JSON                    of each global attribute
    variable NAME TYPE DIMENSION ...       of each variable, followed by
    attribute NAME JSON                    of each of its attributes, and by
    its values as they are stored (fill values too), little-endian, in C order

TYPE is numpy's (`<f8`, `|i1`); JSON is Python's `json.dumps` of the value, lists for arrays.
"""

import hashlib
import json
import sys

import netCDF4
import numpy as np


def content_sha256(path):
    """Hexadecimal digest of the content of the NetCDF file ``path``."""
    digest = hashlib.sha256()

    def say(*words):
        digest.update((" ".join(words) + "\n").encode())

    def say_attributes(owner):
        for name in sorted(owner.ncattrs()):
            value = owner.getncattr(name)
            plain = value.tolist() if isinstance(value, (np.ndarray, np.generic)) else value
            say("attribute", name, json.dumps(plain))

    with netCDF4.Dataset(path) as file:
        file.set_auto_maskandscale(False)
        for name, dimension in sorted(file.dimensions.items()):
            say("dimension", name, str(len(dimension)))
        say_attributes(file)
        for name, variable in sorted(file.variables.items()):
            values = np.ascontiguousarray(variable[:])
            values = values.astype(values.dtype.newbyteorder("<"))
            say("variable", name, values.dtype.str, *variable.dimensions)
            say_attributes(variable)
            digest.update(values.tobytes())
    return digest.hexdigest()


if __name__ == "__main__":
    for path in sys.argv[1:]:
        print(content_sha256(path), "", path)
