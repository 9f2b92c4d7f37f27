"""Symbols and numbers of plain texts, for HTML, LaTeX and matplotlib: A_sa,t* with a subscript, sigma as a letter,
5.96e-5 as a power of ten."""

import re
from html import escape

MARKUP = re.compile(r"[\\`*_<>\[\]|&~$]")  # characters with a meaning in Markdown
GREEK = {"sigma": "σ", "eta": "η", "mu": "μ", "nu": "ν"}
LETTER = re.compile(r"(?<![A-Za-z])(sigma|eta|mu|nu)(?![A-Za-z])")
SYMBOL = re.compile(
    r"(?<!\w)([A-Za-zσημνφ])_(sa,t|ss,t|TPCA|max|min|steel|[a-z]?[0-9]|[a-z]{1,2})(?![A-Za-z_])"
)
ALONE = re.compile(r"(?<!\w)([σημνφ])(?!\w)")
POWER = re.compile(r"\b(\d+(?:\.\d+)?)e([+-]?)0*(\d+)\b")
RAISED = re.compile(r"\^(-?\d+)")
PER = re.compile(r"(?<=\bm)-2\b")
SMALL_BELOW = re.compile(r"([A-Za-zσημνφ])([ₐₛₜ]+(?:,[ₐₛₜ]+)?)")
SMALL_ABOVE = re.compile("[⁻⁰¹²³⁴-⁹]+")
BELOW, ABOVE = str.maketrans("ₐₛₜ", "ast"), str.maketrans("⁻⁰¹²³⁴⁵⁶⁷⁸⁹", "-0123456789")
GREEK_IN_LATEX = {"σ": r"\sigma", "η": r"\eta", "μ": r"\mu", "ν": r"\nu", "φ": r"\varphi"}
SIGNS_IN_LATEX = {
    **{sign: rf"\{sign}" for sign in "&%#{}_$"},
    **{"\\": r"\textbackslash{}", "~": r"\textasciitilde{}", "^": r"\textasciicircum{}"},
    **{"<": "$<$", ">": "$>$", "±": r"$\pm$", "×": r"$\times$", "−": "$-$"},
    **{"↑": r"$\uparrow$", "↓": r"$\downarrow$"},
    **{letter: f"${name}$" for letter, name in GREEK_IN_LATEX.items()},
}
IN_LATEX = re.compile(
    rf"{SYMBOL.pattern}(\*?)|{POWER.pattern}|{RAISED.pattern}|(.)", flags=re.DOTALL
)


def html(text: str) -> str:
    """A text as HTML: escaped, with subscripts and powers of ten."""
    text = ALONE.sub(r"<i>\1</i>", escape(_with_letters(_plain(text))))
    text = SYMBOL.sub(r"<i>\1</i><sub>\2</sub>", text)
    text = POWER.sub(lambda found: "{}10<sup>{}</sup>".format(*_power(found)), text)
    text = RAISED.sub(lambda found: f"<sup>{found[1].replace('-', '−')}</sup>", text)
    return PER.sub("<sup>−2</sup>", text)


def latex(text: str) -> str:
    """A text for LaTeX with the package siunitx: escaped, with subscripts and powers of ten."""
    return IN_LATEX.sub(_in_latex, PER.sub("^-2", _with_letters(_plain(text))))


def _in_latex(found):
    letter, below, star, factor, sign, exponent, above, other = found.groups()
    if letter:
        return f"${GREEK_IN_LATEX.get(letter, letter)}_{{{below}}}{'^*' if star else ''}$"
    if factor:
        return rf"\num{{{factor}e{sign}{exponent}}}"
    return f"$^{{{above}}}$" if above else SIGNS_IN_LATEX.get(other, other)


def mathtext(text: str) -> str:
    """A text for matplotlib, with subscripts and powers of ten."""
    text = SYMBOL.sub(r"$\1_{\2}$", ALONE.sub(r"$\1$", _with_letters(text)))
    return POWER.sub(lambda found: "{}10$^{{{}}}$".format(*_power(found)), text)


def _with_letters(text):
    return LETTER.sub(lambda found: GREEK[found[1]], text)


def _plain(text):
    """A text in which small letters below stand behind a low line, and small digits above behind a caret."""
    text = SMALL_BELOW.sub(lambda found: f"{found[1]}_{found[2].translate(BELOW)}", text)
    return SMALL_ABOVE.sub(lambda found: f"^{found[0].translate(ABOVE)}", text)


def _power(found):
    """What is before the ten, and the exponent."""
    factor, sign, exponent = found.groups()
    return "" if factor == "1" else f"{factor}×", exponent if sign != "-" else f"−{exponent}"


def markdown_text(text: str) -> str:
    """A text as one line of Markdown, in which its signs have no meaning."""
    return MARKUP.sub(r"\\\g<0>", " ".join(text.split()))
