"""Regimes and modes at their limits (sections 3.1 and 3.2)."""

import numpy as np
import pytest

from thirdbody.model.regimes import (
    CONTACT_MODES,
    LUBRICATION_REGIMES,
    MILDEST_FIRST,
    SOLUTION_STATUSES,
    contact_mode,
    gravest_status,
    lubrication_regime,
)

BELOW, ABOVE = -np.inf, np.inf


@pytest.mark.parametrize(
    ("fraction", "name"),
    [
        (1.0, "boundary"),
        (np.nextafter(0.90, ABOVE), "boundary"),
        (0.90, "mixed"),
        (0.5, "mixed"),
        (0.03, "mixed"),
        (np.nextafter(0.03, BELOW), "full_film"),
        (0.0, "full_film"),
    ],
)
def test_regimes_at_their_limits(fraction, name):
    assert LUBRICATION_REGIMES[lubrication_regime(fraction)] == name


@pytest.mark.parametrize(
    ("ratio", "name"),
    [
        (1.0, "particle_surface"),
        (np.nextafter(0.95, ABOVE), "particle_surface"),
        (0.95, "hybrid"),
        (0.5, "hybrid"),
        (0.05, "hybrid"),
        (np.nextafter(0.05, BELOW), "surface_surface"),
        (0.0, "surface_surface"),
    ],
)
def test_modes_at_their_limits(ratio, name):
    assert CONTACT_MODES[contact_mode(ratio, True)] == name


@pytest.mark.parametrize("ratio", [0.0, 0.5, 1.0])
def test_without_particles_contact_is_two_body(ratio):
    assert CONTACT_MODES[contact_mode(ratio, False)] == "two_body"


def test_ratio_and_presence_of_particles_broadcast():
    mode = contact_mode(np.array([[0.0], [1.0]]), np.array([True, False, True]))
    assert mode.tolist() == [[1, 0, 1], [3, 0, 3]]


@pytest.mark.parametrize("shape", [(), (0,), (3,), (2, 2)])
def test_flags_are_bytes_of_the_shape_of_the_points(shape):
    for flags in (lubrication_regime(np.zeros(shape)), contact_mode(np.zeros(shape), True)):
        assert flags.dtype == np.int8
        assert flags.shape == shape


@pytest.mark.parametrize("place", range(len(MILDEST_FIRST)))
def test_of_all_statuses_that_apply_the_gravest_is_stored(place):
    milder = {name: np.ones(2, bool) for name in MILDEST_FIRST[: place + 1]}
    status = gravest_status(**milder | {MILDEST_FIRST[place]: np.array([True, False])})
    expected = MILDEST_FIRST[place], ("converged", *MILDEST_FIRST)[place]
    assert tuple(SOLUTION_STATUSES[index] for index in status) == expected
