"""Regimes and modes at their limits (sections 3.1 and 3.2)."""

import numpy as np
import pytest

from thirdbody.core.regimes import (
    CONTACT_MODES,
    LUBRICATION_REGIMES,
    MILDEST_FIRST,
    SOLUTION_STATUSES,
    contact_mode,
    gravest_status,
    lubrication_regime,
)


def with_particles(ratio):
    return contact_mode(ratio, True)


LIMITS = {
    lubrication_regime: (LUBRICATION_REGIMES, 0.03, 0.90, ("full_film", "mixed", "boundary")),
    with_particles: (CONTACT_MODES, 0.05, 0.95, ("surface_surface", "hybrid", "particle_surface")),
}


@pytest.mark.parametrize("flag", LIMITS)
def test_limits_belong_to_what_lies_between_them(flag):
    names, low, high, (below, between, above) = LIMITS[flag]
    fractions = 0.0, np.nextafter(low, 0.0), low, 0.5, high, np.nextafter(high, 1.0), 1.0
    found = [names[flag(fraction)] for fraction in fractions]
    assert found == [below, below, between, between, between, above, above]


def test_without_particles_contact_is_two_body():
    mode = contact_mode(np.array([[0.0], [0.5], [1.0]]), np.array([True, False]))
    assert [CONTACT_MODES[index] for index in mode[:, 1]] == ["two_body"] * 3


@pytest.mark.parametrize("place", range(len(MILDEST_FIRST)))
def test_of_all_statuses_that_apply_the_gravest_is_stored(place):
    milder = {name: np.ones(2, bool) for name in MILDEST_FIRST[: place + 1]}
    status = gravest_status(**milder | {MILDEST_FIRST[place]: np.array([True, False])})
    expected = MILDEST_FIRST[place], ("converged", *MILDEST_FIRST)[place]
    assert tuple(SOLUTION_STATUSES[index] for index in status) == expected
