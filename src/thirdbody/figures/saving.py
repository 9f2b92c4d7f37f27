"""The one place that saves: three formats and the data drawn, with the same bytes every time."""

from __future__ import annotations

import io
import struct
import zlib

# the canvases that ``savefig`` takes for the formats below
import matplotlib.backends.backend_agg  # noqa: F401
import matplotlib.backends.backend_pdf  # noqa: F401
import matplotlib.backends.backend_svg  # noqa: F401
import numpy as np
from matplotlib import rcParams

from thirdbody.figures.panel import NamedOutlines, NamedPoints
from thirdbody.files import whole

SUFFIXES = (".svg", ".pdf", ".png", ".csv")
METRE = 1.0 / 0.0254  # inches
COLUMNS = ("panel", "curve", "x_name", "x", "y_name", "y")


def save(figure, stem) -> None:
    """Write ``stem``.svg, .pdf, .png and, as .csv, the data that ``figure`` shows."""
    with whole(*(f"{stem}{suffix}" for suffix in SUFFIXES)) as (svg, pdf, png, data):
        figure.savefig(svg, format="svg", metadata={"Date": None})
        figure.savefig(pdf, format="pdf", metadata={"CreationDate": None})
        write_png(figure, png)
        write_drawn_data(figure, data)


def write_png(figure, path) -> None:
    """Write the pixels of ``figure``, without a date.

    They are compressed as they are: the filters that matplotlib's own writer tries on every row
    take a fifth of the time of drawing and make files of so few colours larger.
    """
    with io.BytesIO() as stream:
        figure.savefig(stream, format="rgba")
        drawn = np.frombuffer(stream.getvalue(), dtype=np.uint8)
    dpi = rcParams["savefig.dpi"]
    width = int(figure.get_figwidth() * dpi)
    rows = drawn.reshape(-1, 4 * width)
    unfiltered = np.pad(rows, ((0, 0), (1, 0)))  # each row tells its filter first: 0 is none
    a_metre = round(dpi * METRE)
    chunks = {
        b"IHDR": struct.pack(">IIBBBBB", width, len(rows), 8, 6, 0, 0, 0),
        b"pHYs": struct.pack(">IIB", a_metre, a_metre, 1),
        b"IDAT": zlib.compress(unfiltered, 3),
        b"IEND": b"",
    }
    with open(path, "wb") as stream:
        stream.write(b"\x89PNG\r\n\x1a\n")
        for kind, content in chunks.items():
            check = struct.pack(">I", zlib.crc32(kind + content))
            stream.write(struct.pack(">I", len(content)) + kind + content + check)


def write_drawn_data(figure, path) -> None:
    """Write every drawn point as panel, curve, x_name, x, y_name, y; SI units."""
    with open(path, "w", encoding="utf-8", newline="") as stream:
        stream.write(",".join(COLUMNS) + "\n")
        for panel in figure.axes:
            for label, points in drawn_points(panel):
                names = (panel.letter, label, panel.x_name, panel.y_name)
                letter, curve, x_name, y_name = map(_quoted, names)
                # all points of a curve in one step: one by one, numbers take long to write
                row = f"{letter},{curve},{x_name},%.10g,{y_name},%.10g\n"
                stream.write(row * len(points) % tuple(points.ravel().tolist()))


def _quoted(text: str) -> str:
    """``text`` as a field of a CSV file, within a format for numbers."""
    if any(letter in text for letter in ',"\n'):
        text = '"' + text.replace('"', '""') + '"'
    return text.replace("%", "%%")


def drawn_points(panel):
    """Label and points (n, 2) of each artist of ``panel`` that stands for data.

    These are lines, unless their label starts with an underscore, and what has names.
    """
    for line in panel.lines:
        if isinstance(line, NamedPoints):
            for name, point in zip(line.names, line.get_xydata(), strict=True):
                yield name, _known(point[np.newaxis])
        elif not line.get_label().startswith("_"):
            yield line.get_label(), _known(line.get_xydata())
    for outlines in panel.collections:
        if isinstance(outlines, NamedOutlines):
            for name, path in zip(outlines.names, outlines.get_paths(), strict=True):
                yield name, _known(path.vertices)


def _known(points):
    return points[np.isfinite(points).all(axis=1)]
