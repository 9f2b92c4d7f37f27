"""Symbols and numbers of plain texts as HTML: A_sa,t* with a subscript, 5.96e-5 as a power of ten."""

import re
from html import escape

SYMBOL = re.compile(r"(?<!\w)([A-Za-zσηνφ])_(sa,t|ss,t|TPCA|max|min|[a-z]{1,2}|[0-9])(?![A-Za-z_])")
POWER = re.compile(r"\b(\d+(?:\.\d+)?)e([+-]?)0*(\d+)\b")
RAISED = re.compile(r"\b10\^(-?\d+)")
PER = re.compile(r"(?<=\bm)-2\b")


def html(text: str) -> str:
    """A text as HTML: escaped, with subscripts and powers of ten."""
    text = SYMBOL.sub(r"<i>\1</i><sub>\2</sub>", escape(text))
    text = POWER.sub(lambda found: f"{found[1]}×10<sup>{_sign(found[2])}{found[3]}</sup>", text)
    text = RAISED.sub(lambda found: f"10<sup>{found[1].replace('-', '−')}</sup>", text)
    return PER.sub("<sup>−2</sup>", text)


def _sign(sign):
    return "−" if sign == "-" else ""
