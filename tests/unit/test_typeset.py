"""Symbols and powers of ten in the texts of pages and figures."""

import pytest

from thirdbody.typeset import html, mathtext


@pytest.mark.parametrize(
    ("text", "page", "figure"),
    [
        ("x_a/sigma < 1.3", "<i>x</i><sub>a</sub>/<i>σ</i> &lt; 1.3", "$x_{a}$/σ < 1.3"),
        (
            "A_sa,t* of 5.96e-05",
            "<i>A</i><sub>sa,t</sub>* of 5.96×10<sup>−5</sup>",
            "$A_{sa,t}$* of 5.96×10$^{−5}$",
        ),
        ("eta_a = 1e+11", "<i>η</i><sub>a</sub> = 10<sup>11</sup>", "$η_{a}$ = 10$^{11}$"),
        ("a nuisance, summit_radius", "a nuisance, summit_radius", "a nuisance, summit_radius"),
    ],
)
def test_symbols_and_powers_are_set(text, page, figure):
    assert html(text) == page
    assert mathtext(text) == figure
