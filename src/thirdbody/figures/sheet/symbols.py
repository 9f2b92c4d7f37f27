"""Symbols of the paper, such as A_sa,t*, set as outlines.

matplotlib's own mathematics is a grammar that is built anew in each process and parsed anew for
each format, which takes longer than drawing all curves of a figure; the symbols of this paper
need no more than one letter with something below and a star above.
"""

from __future__ import annotations

from dataclasses import dataclass
from functools import cache

from matplotlib.font_manager import FontProperties
from matplotlib.path import Path
from matplotlib.textpath import TextPath

# size and shift of what stands below and above the letter, in sizes of the letter
SMALL, LOWERED, RAISED = 0.7, -0.18, 0.38
THIN_SPACE = 0.06


@dataclass(frozen=True)
class Symbol:
    """A letter with ``below`` as its subscript, a star if ``starred``, and its ``unit``."""

    letter: str
    below: str
    starred: bool = False
    unit: str = ""

    @classmethod
    def of(cls, text: str, unit: str = "") -> Symbol:
        """The symbol that data files write as ``text``.

        Examples
        --------
        >>> Symbol.of("A_sa,t*")
        Symbol(letter='A', below='sa,t', starred=True, unit='')
        """
        letter, _, below = text.removesuffix("*").partition("_")
        return cls(letter, below, text.endswith("*"), unit)


@cache
def outline(symbol: Symbol, size: float) -> Path:
    """``symbol`` with its letter at the origin, set in ``size`` points."""
    pieces = [_set(symbol.letter, 0.0, 0.0, size, "italic")]
    beside = _end(pieces) + THIN_SPACE * size
    if symbol.below:
        pieces.append(_set(symbol.below, beside, LOWERED * size, SMALL * size, "italic"))
    if symbol.starred:
        pieces.append(_set("*", beside + THIN_SPACE * size, RAISED * size, SMALL * size))
    if symbol.unit:
        pieces.append(_set(f"({symbol.unit})", _end(pieces) + 0.4 * size, 0.0, size))
    return Path.make_compound_path(*pieces)


def _set(text, x, y, size, style="normal") -> Path:
    return TextPath((x, y), text, size=size, prop=FontProperties(style=style))


def _end(pieces) -> float:
    return max(piece.get_extents().x1 for piece in pieces)
