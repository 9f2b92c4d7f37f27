"""Symbols and numbers of plain texts, for HTML and for matplotlib: A_sa,t* with a subscript, sigma as a letter,
5.96e-5 as a power of ten."""

import re
from html import escape

GREEK = {"sigma": "σ", "eta": "η", "mu": "μ", "nu": "ν"}
LETTER = re.compile(r"(?<![A-Za-z])(sigma|eta|mu|nu)(?![A-Za-z])")
SYMBOL = re.compile(
    r"(?<!\w)([A-Za-zσημνφ])_(sa,t|ss,t|TPCA|max|min|steel|[a-z]?[0-9]|[a-z]{1,2})(?![A-Za-z_])"
)
ALONE = re.compile(r"(?<!\w)([σημνφ])(?!\w)")
POWER = re.compile(r"\b(\d+(?:\.\d+)?)e([+-]?)0*(\d+)\b")
RAISED = re.compile(r"\^(-?\d+)")
PER = re.compile(r"(?<=\bm)-2\b")


def html(text: str) -> str:
    """A text as HTML: escaped, with subscripts and powers of ten."""
    text = ALONE.sub(r"<i>\1</i>", escape(_with_letters(text)))
    text = SYMBOL.sub(r"<i>\1</i><sub>\2</sub>", text)
    text = POWER.sub(lambda found: "{}10<sup>{}</sup>".format(*_power(found)), text)
    text = RAISED.sub(lambda found: f"<sup>{found[1].replace('-', '−')}</sup>", text)
    return PER.sub("<sup>−2</sup>", text)


def mathtext(text: str) -> str:
    """A text for matplotlib, with subscripts and powers of ten."""
    text = SYMBOL.sub(r"$\1_{\2}$", _with_letters(text))
    return POWER.sub(lambda found: "{}10$^{{{}}}$".format(*_power(found)), text)


def _with_letters(text):
    return LETTER.sub(lambda found: GREEK[found[1]], text)


def _power(found):
    """What is before the ten, and the exponent."""
    factor, sign, exponent = found.groups()
    return "" if factor == "1" else f"{factor}×", exponent if sign != "-" else f"−{exponent}"
