"""Film thickness: printed values, its inverse, and where the formula holds (Eqs. 7-8)."""

import numpy as np
import pytest
from numpy.testing import assert_allclose

from thirdbody.core.film import Film, film_parameter

pytestmark = pytest.mark.filterwarnings("error")

CENTISTOKES = 1e-6
ROUGHNESS = 300e-9


@pytest.mark.parametrize(
    ("load_parameter", "viscosity", "printed"),
    [(1e-6, 120.0, 1.783e-4), (1e-6, 70.0, 1.274e-4), (8.86e-9, 120.0, 2.273e-4)],
)
def test_film_thickness_to_the_printed_digits(parameters, load_parameter, viscosity, printed):
    film = Film.of(np.array([viscosity]) * CENTISTOKES, ROUGHNESS, parameters)
    assert float(f"{film.thickness(np.log(load_parameter))[0][0]:.3e}") == printed


def test_lambda_is_of_smooth_bodies_under_the_whole_load(parameters):
    loads, oils = np.array([1.0, 10.0]), np.array([0.0, 90e-6])
    found = film_parameter(loads[:, None] / parameters.newtons_per_load, oils, 3e-7, parameters)
    radius = parameters.ball_radius
    W = loads / (parameters.elastic_modulus_surfaces * radius**2)
    U, G = parameters.speed_per_viscosity * 90e-6, parameters.material_parameter
    smooth = 3.672 * W**-0.045 * U**0.663 * G**0.502 * (1.0 - 0.573 * np.exp(-0.74))
    assert parameters.ellipticity == 1.0
    assert_allclose(found[:, 1], smooth * radius / 3e-7, rtol=1e-12)
    assert_allclose(found[:, 0], 0.0)


def test_the_ranges_of_figure_11c_end_at_one_load(parameters):
    oils = Film.of(np.array([70.0, 120.0]) * CENTISTOKES, ROUGHNESS, parameters)
    rounded = 0.5e-6  # half a unit of the last digit that is printed

    def newtons(thickness):
        stiffness = parameters.elastic_modulus_surfaces * parameters.ball_radius**2
        return stiffness * np.exp(oils.log_W_and_slope(thickness)[0])

    printed = np.array([1.15e-4, 1.63e-4])
    least, most = newtons(printed + rounded), newtons(printed - rounded)
    assert_allclose([least[0], most[1]], 30.0, rtol=0.02)  # N: where they meet but for rounding
