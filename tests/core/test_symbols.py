"""Symbols, units and powers of ten in HTML, LaTeX, mathtext and Unicode."""

import pytest

from thirdbody import symbols
from thirdbody.plotting.scales import axis_label
from thirdbody.variables import CONDITIONS, DERIVED, NORMAL_LOAD, QUANTITIES

# symbol of a variable: HTML, LaTeX, mathtext, Unicode
SYMBOLS = {
    "F_t*": ("<i>F</i><sub>t</sub>*", "$F_{t}^*$", "$F_{t}^*$", "Fₜ*"),
    "F_t": ("<i>F</i><sub>t</sub>", "$F_{t}$", "$F_{t}$", "Fₜ"),
    "nu": ("<i>ν</i>", r"$\nu$", "$ν$", "ν"),
    "x_a": ("<i>x</i><sub>a</sub>", "$x_{a}$", "$x_{a}$", "xₐ"),
    "sigma": ("<i>σ</i>", r"$\sigma$", "$σ$", "σ"),
    "eta_a": ("<i>η</i><sub>a</sub>", r"$\eta_{a}$", "$η_{a}$", "ηₐ"),
    "u": ("<i>u</i>", "$u$", "$u$", "u"),
    "A_t*": ("<i>A</i><sub>t</sub>*", "$A_{t}^*$", "$A_{t}^*$", "Aₜ*"),
    "A_sa,t*": ("<i>A</i><sub>sa,t</sub>*", "$A_{sa,t}^*$", "$A_{sa,t}^*$", "Aₛₐ,ₜ*"),
    "A_ss,t*": ("<i>A</i><sub>ss,t</sub>*", "$A_{ss,t}^*$", "$A_{ss,t}^*$", "Aₛₛ,ₜ*"),
    "L_s": ("<i>L</i><sub>s</sub>", "$L_{s}$", "$L_{s}$", "Lₛ"),
    "L_f": ("<i>L</i><sub>f</sub>", "$L_{f}$", "$L_{f}$", "L_f"),
    "d": ("<i>d</i>", "$d$", "$d$", "d"),
    "H_c": ("<i>H</i><sub>c</sub>", "$H_{c}$", "$H_{c}$", "H_c"),
    "x_a/sigma": ("<i>x</i><sub>a</sub>/<i>σ</i>", r"$x_{a}$/$\sigma$", "$x_{a}$/$σ$", "xₐ/σ"),
}
TEXTS = {
    "5.96e-05 < 1e+11": (
        *("5.96×10<sup>−5</sup> &lt; 10<sup>11</sup>", r"\num{5.96e-5} $<$ $10^{11}$"),
        *("5.96×10⁻⁵ < 10¹¹", "5.96×10⁻⁵ < 10¹¹"),
    ),
    "-0.15, (-2) to -.5, 1e-3, s-2, 250-400": (
        "−0.15, (−2) to −.5, 10<sup>−3</sup>, s<sup>−2</sup>, 250-400",
        "$-$0.15, ($-$2) to $-$.5, $10^{-3}$, s$^{-2}$, 250-400",
        *2 * ("−0.15, (−2) to −.5, 10⁻³, s⁻², 250-400",),
    ),
    "10⁻⁶ of R_x^2, 3 m-2": (
        "10<sup>−6</sup> of <i>R</i><sub>x</sub><sup>2</sup>, 3 m<sup>−2</sup>",
        *(
            "$10^{-6}$ of $R_{x}$$^{2}$, 3 m$^{-2}$",
            "10⁻⁶ of $R_{x}$², 3 m⁻²",
            "10⁻⁶ of Rₓ², 3 m⁻²",
        ),
    ),
    "H_s1 - 2": (
        *("<i>H</i><sub>s1</sub> − 2", r"$H_{s1}$ $-$ 2"),
        *("$H_{s1}$ − 2", "Hₛ₁ − 2"),
    ),
    "a nuisance, s-s, summit_radius": (
        *("a nuisance, s-s, summit_radius", r"a nuisance, s-s, summit\_radius"),
        *["a nuisance, s-s, summit_radius"] * 2,
    ),
    "↓ 50 % & d": (
        *("↓ 50 % &amp; <i>d</i>", r"$\downarrow$ 50 \% \& $d$", "↓ 50 % & $d$", "↓ 50 % & d"),
    ),
}


@pytest.mark.parametrize(("text", "forms"), (SYMBOLS | TEXTS).items())
def test_a_text_in_four_forms(text, forms):
    page, latex, figure, plain = forms
    assert symbols.html(text).replace("\N{NO-BREAK SPACE}", " ") == page
    assert symbols.latex(text) == latex
    assert symbols.mathtext(text) == figure
    assert symbols.unicode(text) == plain
    for form in (symbols.html, symbols.latex, symbols.mathtext):
        assert form(plain) == form(text)  # from Unicode too
    assert symbols.mathtext(figure) == figure


@pytest.mark.parametrize(
    ("text", "unbroken"),
    [
        ("At sigma = 300 nm it is < 14.9 % smaller", ["σ</i> = 300 nm", "is &lt; 14.9 %"]),
        ("5.96e-5 is printed, 3 more", []),
        ("10¹¹ m⁻², 6 mm² or 3 ± 1 GPa", ["</sup> m", "6 mm", "3 ± 1 GPa"]),
    ],
)
def test_no_line_ends_between_a_number_and_its_unit_or_symbol(text, unbroken):
    page = symbols.html(text)
    tight = [part.replace(" ", "\N{NO-BREAK SPACE}") for part in unbroken]
    assert all(part in page for part in tight)
    assert page.count("\N{NO-BREAK SPACE}") == sum(part.count(" ") for part in unbroken)


def test_the_table_has_the_symbol_of_each_variable():
    variables = [*CONDITIONS.values(), *QUANTITIES.values(), NORMAL_LOAD, DERIVED["diameter_ratio"]]
    assert {each.symbol for each in variables} == {*SYMBOLS}


def test_any_letter_of_a_symbol_is_one():
    assert symbols.mathtext("eta_s R sigma", is_symbol=True) == "$η_{s}$ $R$ $σ$"
    assert symbols.mathtext("U/nu", is_symbol=True) == "$U$/$ν$"
    assert symbols.html("the load W") == "the load W"
    assert symbols.html("W", is_symbol=True) == "<i>W</i>"


@pytest.mark.parametrize(
    ("variable", "label"),
    [
        ("load", "$F_{t}^*$"),
        ("particle_density", "Particle density $η_{a}$ (m⁻²)"),
        ("speed", "Entrainment speed $u$ (m/s)"),
        ("film_thickness", "$H_{c}$ (10⁻⁴)"),
        ("turning_point_ratio", "$A_{sa,t}^*$ at the turning point"),
    ],
)
def test_an_axis_has_words_symbol_and_unit(variable, label):
    assert axis_label(variable) == label


@pytest.mark.parametrize(
    ("value", "text"),
    [(5e10, "5×10¹⁰"), (1e11, "10¹¹"), (1.2344e-5, "1.234×10⁻⁵"), (10.0, "10¹"), (1.0, "10⁰")],
)
def test_a_number_is_a_power_of_ten(value, text):
    assert symbols.power_text(value) == text


@pytest.mark.parametrize(
    ("number", "text"), [("1e+11", "1e11"), ("3.27e-06", "3.27e-6"), ("250", "250")]
)
def test_an_exponent_is_short(number, text):
    assert symbols.short(number) == text
