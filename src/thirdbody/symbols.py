"""Symbols, units and powers of ten in HTML, LaTeX, mathtext of matplotlib and Unicode.

Texts may write symbols in ASCII, ``A_sa,t*``, ``sigma``, ``5.96e-5``, ``m-2``, or with the small
letters and digits of Unicode, ``Aₛₐ,ₜ*``, ``10⁻⁵``.  Both give the same result.  With ``is_symbol``
any single letter is a symbol: ``U/nu``.
"""

import re
from collections.abc import Callable
from html import escape
from typing import NamedTuple
from unicodedata import normalize

_NAMES = "sigma", "eta", "mu", "nu", "phi", "omega", "kappa", "lambda"
GREEK = dict(zip(_NAMES, "σημνφωκλ", strict=True))
SUPERSCRIPTS = "⁻⁰¹²³⁴⁵⁶⁷⁸⁹"
LETTER = rf"[A-Za-z{''.join(GREEK.values())}]"
WORD = rf"(?<![A-Za-z])(?:{'|'.join(GREEK)})(?![A-Za-z])"  # a Greek letter by its name
SMALL = r"[ₐₑₒₓₕₖₗₘₙₚₛₜᵢⱼᵣᵤᵥ₀-₉]"
BELOW = rf"{SMALL}+(?:,{SMALL}+)?"
# a letter with an index; below, a single letter that is no word, no unit and no panel
SYMBOL = (
    rf"(?<!\w)({LETTER})_((?:sa|ss),t|TPCA|max|min|steel|[a-z]?[0-9]|[A-Za-z]{{1,2}})(?![A-Za-z_])"
)
SINGLE = r"(?<![\w$'’])({})(?![\w$'’])"
IN_TEXT, IN_SYMBOL = SINGLE.format(f"[du{''.join(GREEK.values())}]"), SINGLE.format(LETTER)
POWER = r"\b(\d+(?:\.\d+)?)e([+-]?)0*(\d+)\b"
RAISED = r"\^(-?\d+)"
OF_TEN = rf"\b(?:(\d+(?:\.\d+)?)×)?10{RAISED}"  # a power as ``unicode`` writes it
PER = r"(?<=\b[ms])-(?=\d\b)"  # m-2
# before a number or alone: no hyphen, and no sign of a power
MINUS = r"(?<![\w^).])-(?=\.?\d)|(?<= )-(?= )"
UNIT = r"(?:%|k?N|[nmµ]?m|cSt|[GMk]?Pa)(?![A-Za-z])"
# spaces at which no line ends: between a number and its unit, beside a sign, and in Figure 3
TIGHT = (
    rf"(?<=[\d{SUPERSCRIPTS}]) (?={UNIT})| (?=[=<>±] )|(?<= [=<>±]) "
    r"|(?:(?<=\bFigure)|(?<=\bFigures)|(?<=\bTable)|(?<=\bEq\.)|(?<=\bEqs\.)) (?=\d)"
)
TO_BELOW = str.maketrans("aeoxhklmnpstijruv0123456789", "ₐₑₒₓₕₖₗₘₙₚₛₜᵢⱼᵣᵤᵥ₀₁₂₃₄₅₆₇₈₉")
TO_ABOVE = str.maketrans("-0123456789", SUPERSCRIPTS)
LATEX_LETTERS = {letter: rf"\{name}" for name, letter in GREEK.items()} | {"φ": r"\varphi"}
LATEX_SIGNS = {
    **{sign: rf"\{sign}" for sign in "&%#{}_$"},
    **{"\\": r"\textbackslash{}", "~": r"\textasciitilde{}", "^": r"\textasciicircum{}"},
    **{"<": "$<$", ">": "$>$", "±": r"$\pm$", "×": r"$\times$", "−": "$-$"},
    **{"↑": r"$\uparrow$", "↓": r"$\downarrow$", "✗": r"$\times$"},
}


class Form(NamedTuple):
    """How an output writes a symbol with index and star, an exponent, and any other sign."""

    symbol: str
    below: Callable[[str], str]
    star: str
    raised: Callable[[str], str]
    other: Callable[[str], str] = str


def _small(index):
    """An index in small letters.  Unicode has no small c: such an index stays on the line."""
    small = index.translate(TO_BELOW)
    return small if re.fullmatch(BELOW, small) else f"_{index}"


def _small_above(exponent):
    return exponent.translate(TO_ABOVE)


UNICODE = Form("{}{}{}", _small, "*", _small_above)
MATHTEXT = Form("${}{}{}$", "_{{{}}}".format, "^*", _small_above)
HTML = Form(
    *("<i>{}</i>{}{}", "<sub>{}</sub>".format, "*"),
    *(lambda exponent: f"<sup>{exponent.replace('-', '−')}</sup>", escape),
)
LATEX = Form(
    *("${}{}{}$", "_{{{}}}".format, "^*", "$^{{{}}}$".format),
    lambda sign: LATEX_SIGNS.get(sign, sign),
)


def unicode(text: str, is_symbol: bool = False) -> str:
    """A text in Unicode alone: σ, xₐ, 5.96×10⁻⁵."""
    return _written(text, is_symbol, UNICODE)


def mathtext(text: str, is_symbol: bool = False) -> str:
    """A text in mathtext of matplotlib, with powers of ten in Unicode."""
    return _written(text, is_symbol, MATHTEXT)


def html(text: str, is_symbol: bool = False) -> str:
    """A text as HTML, escaped.  A number stays on the line of its unit and of its symbol."""
    return _written(re.sub(TIGHT, "\N{NO-BREAK SPACE}", text), is_symbol, HTML)


def latex(text: str, is_symbol: bool = False) -> str:
    """A text for LaTeX with the package siunitx, escaped."""
    return _written(text, is_symbol, LATEX)


def power_text(value: float) -> str:
    """``value`` as a power of ten, with at most four digits: 5×10¹⁰, 10¹¹."""
    mantissa, exponent = f"{value:.3e}".split("e")
    return unicode(f"{float(mantissa):g}e{exponent}")


def short(number: str) -> str:
    """A number without the plus sign and the zeros of an exponent: 1e11."""
    return re.sub(r"e\+?(-?)0*", r"e\1", number)


def _written(text: str, is_symbol: bool, form: Form) -> str:
    """A text by the rules of ``form``."""

    def write(match):
        letter, index, single, star, factor, sign, digits, above, other = match.groups(default="")
        if letter := letter or single:
            letter = LATEX_LETTERS.get(letter, letter) if form is LATEX else letter
            return form.symbol.format(letter, index and form.below(index), star and form.star)
        if not factor:
            return form.raised(above) if above else form.other(other)
        exponent = sign.strip("+") + digits
        if form is LATEX:
            return rf"$10^{{{exponent}}}$" if factor == "1" else rf"\num{{{factor}e{exponent}}}"
        return ("10" if factor == "1" else f"{factor}×10") + form.raised(exponent)

    text = re.sub(WORD, lambda match: GREEK[match[0]], text)
    text = re.sub(BELOW, lambda match: f"_{normalize('NFKC', match[0])}", text)
    text = re.sub(f"[{SUPERSCRIPTS}]+", lambda match: f"^{normalize('NFKC', match[0])}", text)
    text = re.sub(MINUS, "−", re.sub(PER, "^-", text.replace("^−", "^-")))
    text = re.sub(OF_TEN, lambda match: f"{match[1] or 1}e{match[2]}", text)
    symbol = rf"(?:{SYMBOL}|{IN_SYMBOL if is_symbol else IN_TEXT})(\*?)"
    return re.sub(rf"{symbol}|{POWER}|{RAISED}|(.)", write, text, flags=re.DOTALL)
