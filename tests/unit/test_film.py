"""Film thickness: printed values, its inverse, and where the formula holds (Eqs. 7-8)."""

from dataclasses import replace

import numpy as np
import pytest
from numpy.testing import assert_allclose

from thirdbody.model.film import Film

pytestmark = pytest.mark.filterwarnings("error")

CENTISTOKES = 1e-6
ROUGHNESS = 300e-9


def film(parameters, viscosity, roughness=ROUGHNESS):
    return Film.of(np.atleast_1d(viscosity), roughness, parameters)


def thickness(parameters, log_load_parameter, viscosity, roughness=ROUGHNESS):
    """H_c at ln W and kinematic viscosity [m2/s]."""
    return film(parameters, viscosity, roughness).thickness(log_load_parameter)[0]


@pytest.mark.parametrize(
    ("load_parameter", "viscosity", "printed"),
    [(1e-6, 120.0, 1.783e-4), (1e-6, 70.0, 1.274e-4), (8.86e-9, 120.0, 2.273e-4)],
)
def test_film_thickness_to_the_printed_digits(parameters, load_parameter, viscosity, printed):
    value = thickness(parameters, np.log(load_parameter), viscosity * CENTISTOKES)[0]
    assert float(f"{value:.3e}") == printed


def test_the_ranges_of_figure_11c_end_at_one_load(parameters):
    oils = film(parameters, np.array([70.0, 120.0]) * CENTISTOKES)
    rounded = 0.5e-6  # half a unit of the last digit that is printed

    def newtons(thickness):
        stiffness = parameters.elastic_modulus_surfaces * parameters.ball_radius**2
        return stiffness * np.exp(oils.load_parameter_and_slope(thickness)[0])

    printed = np.array([1.15e-4, 1.63e-4])
    least, most = newtons(printed + rounded), newtons(printed - rounded)
    assert_allclose([least[0], most[1]], 30.0, rtol=0.02)  # N: where they meet but for rounding


def test_rounding_counts_every_logarithm_of_which_the_thickness_is_made(parameters):
    inputs = replace(
        parameters,
        ellipticity=1.6312086924537212,
        material_parameter=5247.642847183137,
        hardness_parameter=0.0010054058114793048,
        ball_radius=0.003392587080172459,
        speed_per_viscosity=1.8361848928908369e-07,
    )
    oil = film(inputs, 2.665739689460262e-06, 2.0882287151817785e-08)
    log_load_parameter = -11.04297534359267
    exact = 0.000003086879344748276936010111  # Eq. 7 by mpmath
    thickness, slope = oil.thickness(log_load_parameter)
    rounding = oil.rounding(log_load_parameter, slope / thickness)
    assert np.abs(thickness / exact - 1.0) <= rounding
    assert rounding < 1e-13
