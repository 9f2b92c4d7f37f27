"""Texts of an archive, for people and for programs, by the templates in ``templates/``."""

from __future__ import annotations

import re
from importlib.resources import files
from pathlib import Path
from typing import Any

import netCDF4
import numpy as np
from jinja2 import Environment, StrictUndefined

from thirdbody.data.quantities import STATUS_MEANINGS
from thirdbody.data.tables import DRAWN_POINTS
from thirdbody.model.regimes import WITHOUT_VALUES
from thirdbody.release.citation import DATA_LICENCE
from thirdbody.release.datapackage import table_schema
from thirdbody.release.files import files_in


def render(template: str, **values: Any) -> str:
    """Text of a template, which can use ``values`` and the filter ``text`` (``markdown_text``)."""
    environment = Environment(
        undefined=StrictUndefined, trim_blocks=True, lstrip_blocks=True, keep_trailing_newline=True
    )
    environment.filters["text"] = markdown_text
    source = files(__package__).joinpath("templates", template).read_text(encoding="utf-8")
    return environment.from_string(source).render(data_licence=DATA_LICENCE, **values)


def describe_content(data: Path, kinds: dict[str, str]) -> dict[str, Any]:
    """What ``README.md`` says of the files in an archive: values for its template.

    Parameters
    ----------
    data : Path
        Folder of the archive that holds products, sources and configuration.
    kinds : dict
        Title of each folder of products in ``data``, by name; ``datasets`` must be among them.
    """
    paths = sorted(data.glob("datasets/*.nc"))
    return {
        "kinds": kinds,
        "names": {kind: files_in(data / kind, data / kind) for kind in kinds},
        "datasets": [_describe_dataset(path) for path in paths],
        "quantities": _describe_variables(paths[0]),
        "tables": {
            kind: {path.name: table_schema(path) for path in sorted((data / kind).glob("*.csv"))}
            for kind in ("tables", "claims")
        },
        "drawn_points": DRAWN_POINTS,
        "status_meanings": STATUS_MEANINGS,
        "without_values": WITHOUT_VALUES,
    }


def markdown_text(text: str) -> str:
    r"""``text`` as one line of Markdown in which nothing is markup or HTML.

    Examples
    --------
    >>> markdown_text("a|b <script> [x](y)")
    'a\\|b &lt;script&gt; \\[x\\]\\(y\\)'
    """
    line = " ".join(str(text).split())
    line = line.replace("&", "&amp;").replace("<", "&lt;").replace(">", "&gt;")
    return re.sub(r"([\\`*_{}\[\]()#+!|~$])", r"\\\1", line)


def _describe_dataset(path: Path) -> dict[str, Any]:
    """Name, title and shape of a dataset, and its numbers of points by their status."""
    with netCDF4.Dataset(path) as dataset:
        dataset.set_auto_maskandscale(False)
        status = dataset["solution_status"]
        names = dict(zip(status.flag_values.tolist(), status.flag_meanings.split(), strict=True))
        codes, counts = np.unique(status[:], return_counts=True)
        points = {names[code]: int(n) for code, n in zip(codes.tolist(), counts, strict=True)}
        points.pop("not_shown", None)
        shape = " x ".join(map(str, status.shape))
        return {"name": path.name, "title": dataset.title, "shape": shape, "points": points}


def _describe_variables(path: Path) -> dict[str, dict[str, Any]]:
    """Attributes of each variable of a dataset, by name."""
    with netCDF4.Dataset(path) as dataset:
        return {name: vars(variable) for name, variable in dataset.variables.items()}
