"""Media types of the files in an archive."""

from __future__ import annotations

from os import PathLike
from pathlib import PurePath

MEDIA_TYPES = {
    ".bib": "application/x-bibtex",
    ".cff": "application/yaml",
    ".css": "text/css",
    ".csv": "text/csv",
    ".html": "text/html",
    ".ipynb": "application/x-ipynb+json",
    ".js": "text/javascript",
    ".json": "application/json",
    ".md": "text/markdown",
    ".nc": "application/x-netcdf",
    ".pdf": "application/pdf",
    ".png": "image/png",
    ".py": "text/x-python",
    ".svg": "image/svg+xml",
    ".tex": "application/x-tex",
    ".toml": "application/toml",
    ".yaml": "application/yaml",
    ".yml": "application/yaml",
}


def media_type(path: str | PathLike) -> str:
    """Media type of a file by the ending of its name; any other ending means plain text.

    Examples
    --------
    >>> media_type("results/datasets/fig03.nc")
    'application/x-netcdf'
    >>> media_type("LICENSE")
    'text/plain'
    """
    return MEDIA_TYPES.get(PurePath(path).suffix, "text/plain")
