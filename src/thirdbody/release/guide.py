"""Values for ``README.md`` of an archive."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import numpy as np

from thirdbody.data.netcdf import PlainDataset, read_plain
from thirdbody.data.quantities import STATUS, STATUS_MEANINGS
from thirdbody.data.tables import DRAWN_POINTS
from thirdbody.model.regimes import WITHOUT_VALUES
from thirdbody.release.datapackage import table_schema
from thirdbody.release.files import files_in


def describe_content(data: Path, kinds: dict[str, str]) -> dict[str, Any]:
    """Values for the template of ``README.md``, from the folder ``data`` of an archive; ``kinds`` has the titles of
    the folders of products, of which ``datasets`` must be one."""
    datasets = {path.name: read_plain(path) for path in sorted(data.glob("datasets/*.nc"))}
    return {
        "kinds": kinds,
        "names": {kind: files_in(data / kind, data / kind) for kind in kinds},
        "datasets": [_describe_dataset(name, dataset) for name, dataset in datasets.items()],
        "quantities": next(iter(datasets.values())).variables,
        "tables": {
            kind: {path.name: table_schema(path) for path in sorted((data / kind).glob("*.csv"))}
            for kind in ("tables", "claims")
        },
        "drawn_points": DRAWN_POINTS,
        "status_meanings": STATUS_MEANINGS,
        "without_values": WITHOUT_VALUES,
    }


def _describe_dataset(name: str, dataset: PlainDataset) -> dict[str, Any]:
    """Name, title and shape of a dataset, and its numbers of points by their status."""
    status = dataset[STATUS]
    meanings = status.attrs["flag_meanings"].split()
    flags = zip(status.attrs["flag_values"], meanings, strict=True)
    counts = {meaning: int(np.count_nonzero(status.values == flag)) for flag, meaning in flags}
    points = {each: n for each, n in counts.items() if n and each != "not_shown"}
    shape = " x ".join(map(str, status.values.shape))
    return {"name": name, "title": dataset.attrs["title"], "shape": shape, "points": points}
