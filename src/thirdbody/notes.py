"""Notes below an answer, each a sentence: on the sizes of particles, on A_n, the speed and the
range."""

import numpy as np

from thirdbody.core.parameters import Parameters
from thirdbody.core.particles import ParticleLayer, mean_and_largest
from thirdbody.ensembles import RANGE, Ensemble


def sizes_note(diameter: float, roughness: float, parameters: Parameters) -> str:
    """A note on the sizes of particles with ``diameter`` x_a [m].

    It has their mean, the largest, and the separation d below which they carry load on a
    ``roughness`` sigma [m].
    """
    mean, largest = mean_and_largest(diameter, parameters)
    layer = ParticleLayer.of(np.array([diameter]), roughness, np.ones(1), parameters)
    return (
        f"the particle size x_a = {1e9 * diameter:.4g} nm is a label: the mean of the sizes is "
        f"{1e9 * mean:.4g} nm, the largest, X_max, {1e9 * largest:.4g} nm; "
        f"particles carry load at separations d below {1e9 * layer.reach[0]:.4g} nm"
    )


def few_notes(per_m2: float, area: float) -> list[str]:
    """A note if ``area`` A_n [m2] has less than one particle; otherwise none."""
    count = per_m2 * area
    note = f"{count:.2g} particles in A_n = {1e6 * area:.3g} mm2: most contacts have none"
    return [note] if 0.0 < count < 1.0 else []


def area_note(parameters: Parameters | Ensemble) -> str:
    """A note on the nominal area A_n, to which loads refer."""
    return f"the nominal area A_n of the inputs is {1e6 * parameters.apparent_area:.3g} mm2"


def ratios_note(parameters: Parameters | Ensemble) -> str:
    """A note on what areas and the film thickness are relative to."""
    return (
        f"total_contact_area is over A_n, film_thickness over R_x = "
        f"{1e3 * parameters.ball_radius:.4g} mm; contact area ratios are over the total"
    )


def speed_notes(ensemble: Ensemble) -> list[str]:
    """A note on the speed in the inputs; none if the density of the oil is unknown."""
    density = ensemble.setup.oil_density_kg_per_m3
    if density is None:
        return []
    speed = f"an entrainment speed of {ensemble.speed:.3g} m/s"
    note = f"with an oil of {density:.4g} kg/m3, U/nu is for {speed}"
    return [note]


def range_note(ensemble: Ensemble) -> str:
    """A note on the meaning of ranges."""
    count = len(ensemble.members)
    if count == 1:
        return "no range: these inputs have no ensemble"
    return f"{RANGE}; here of {count} sets"
