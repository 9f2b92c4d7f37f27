"""Symbols and powers of ten in the texts of pages and figures."""

import pytest

from chenhorng.typeset import html, latex, mathtext


@pytest.mark.parametrize(
    ("text", "page", "figure"),
    [
        ("x_a/sigma < 1.3", "<i>x</i><sub>a</sub>/<i>σ</i> &lt; 1.3", "$x_{a}$/$σ$ < 1.3"),
        (
            "A_sa,t* of 5.96e-05",
            "<i>A</i><sub>sa,t</sub>* of 5.96×10<sup>−5</sup>",
            "$A_{sa,t}$* of 5.96×10$^{−5}$",
        ),
        ("eta_a = 1e+11", "<i>η</i><sub>a</sub> = 10<sup>11</sup>", "$η_{a}$ = 10$^{11}$"),
        ("Aₛₐ,ₜ* at 10⁻⁶", "<i>A</i><sub>sa,t</sub>* at 10<sup>−6</sup>", "Aₛₐ,ₜ* at 10⁻⁶"),
        ("a nuisance, summit_radius", "a nuisance, summit_radius", "a nuisance, summit_radius"),
    ],
)
def test_symbols_and_powers_are_set(text, page, figure):
    assert html(text) == page
    assert mathtext(text) == figure


@pytest.mark.parametrize(
    ("text", "typeset"),
    [
        ("x_a/sigma < 1.3", r"$x_{a}$/$\sigma$ $<$ 1.3"),
        ("Aₛₐ,ₜ* of 5.96e-05", r"$A_{sa,t}^*$ of \num{5.96e-5}"),
        ("10⁻⁶ of R_x^2, 3 m-2", "10$^{-6}$ of $R_{x}$$^{2}$, 3 m$^{-2}$"),
        ("↓ 50 % & summit_radius", r"$\downarrow$ 50 \% \& summit\_radius"),
    ],
)
def test_latex_is_escaped_and_set(text, typeset):
    assert latex(text) == typeset
