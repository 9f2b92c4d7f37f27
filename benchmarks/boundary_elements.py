"""How far the summit model is from a full solution: the dry real contact area of generated
surfaces, over the load.

    pip install ContactMechanics
    python -m benchmarks.boundary_elements benchmarks/boundary_elements.csv

Writes one row for each surface, hardness and load, in some ten minutes.  ``ContactMechanics``
presses a rigid rough plane on an elastic half-space.  Its boundary elements bear at most the
hardness.  ``thirdbody`` solves the summits of the same heights.  Area over load depends on
F*/slope, H/(E_ss slope) and eta_s R sigma alone, so that one slope stands for all.
``PolonskyKeerRey`` of the package ``tamaas`` finds the same elastic areas within 2e-4 (one surface,
three loads).
"""

import csv
import math
import sys
from collections.abc import Iterator
from itertools import product

import numpy as np
from ContactMechanics import PeriodicFFTElasticHalfSpace
from ContactMechanics.Optimization import constrained_conjugate_gradients
from numpy.typing import NDArray

import thirdbody as tb
from thirdbody.core.parameters import mccool_summits

POINTS = 512  # on a side
SPACING = 100e-9  # m
SLOPE = 0.1  # root mean square of profiles
HURST = 0.8
SHORTEST = 32  # waves on a side
LONGEST = 4, 8  # waves on a side, of surfaces with different eta_s R sigma
SEEDS = 1, 2, 3
LOADS = 3e-4, 1e-3, 3e-3, 1e-2, 3e-2, 1e-1  # F*/slope
# H/(E_ss slope).  The first never yields; the others have H/E_ss = 0.0446, that of Table 1, and
# slopes of 0.033 and 0.1
HARDNESSES = math.inf, 1.34, 0.446
HARDEST = 1e14  # Pa; does not yield here
COLUMNS = (
    *("seed", "summit_parameter", "hardness_over_slope", "load_over_slope"),
    *("area_of_boundary_elements", "area_of_summits"),
)
# Squares on a grid count too much area.  The excess over perimeter and spacing is from Yastrebov,
# Anciaux & Molinari (2017, Tribol. Int. 114:161)
CORNERS = (math.pi - 1.0 + math.log(2.0)) / 24.0


def random_heights(longest: int, seed: int) -> NDArray[np.float64]:
    """Periodic self-affine heights [m] of a random Gaussian surface with the SLOPE, shape (POINTS,
    POINTS).
    """
    wave = np.fft.fftfreq(POINTS, 1.0 / POINTS)
    number = np.hypot(wave[:, np.newaxis], wave)
    amplitude = np.maximum(number, longest) ** -(1.0 + HURST)
    amplitude[(number == 0.0) | (number > SHORTEST)] = 0.0
    noise = np.random.default_rng(seed).standard_normal((POINTS, POINTS))
    heights = np.fft.ifft2(amplitude * np.fft.fft2(noise)).real
    heights *= SPACING / heights.std()
    return heights * SLOPE / math.sqrt(moments(heights)[1])


def moments(heights: NDArray[np.float64]) -> tuple[float, float, float]:
    """Mean squares of ``heights`` [m], and of the slopes and curvatures of profiles, by
    differences.
    """
    ahead = [np.roll(heights, -1, axis) for axis in (0, 1)]
    behind = [np.roll(heights, 1, axis) for axis in (0, 1)]
    slopes = (ahead - heights)[:, :-1, :-1] / SPACING
    bends = (np.add(ahead, behind) - 2.0 * heights)[:, 1:-1, 1:-1] / SPACING**2
    return np.var(heights), np.mean(slopes**2), np.mean(bends**2)


def with_summits(heights: NDArray[np.float64]) -> tb.Ensemble:
    """Inputs with the summits of ``heights`` [m] by their moments (McCool 1987, J. Tribol.
    109:264).
    """
    m_0, m_2, m_4 = moments(heights)
    roughness, radius = math.sqrt(m_0), 0.375 * math.sqrt(math.pi / m_4)
    summit_parameter = m_4 / (6.0 * math.sqrt(3.0) * math.pi * m_2) * radius * roughness
    return tb.load_parameters().changed(
        reference_roughness=roughness,
        summit_radius=radius,
        summit_parameter=summit_parameter,
        **mccool_summits(summit_parameter),
    )


def full_area(heights: NDArray[np.float64], hardness: float, load: float) -> float:
    """A_t* [1] by boundary elements, at ``hardness`` H/E_ss and ``load`` F* [1]."""
    side = POINTS * SPACING
    half_space = PeriodicFFTElasticHalfSpace(heights.shape, 1.0, (side, side))
    found = constrained_conjugate_gradients(
        half_space,
        heights,
        hardness=None if math.isinf(hardness) else hardness * half_space.area_per_pt,
        external_force=load * side**2,
    )
    if not found.success:
        raise RuntimeError(f"{found.message} at the load {load:g} and the hardness {hardness:g}")
    touches = found.jac > 0.0
    edges = sum(np.count_nonzero(touches != np.roll(touches, 1, axis)) for axis in (0, 1))
    return (np.count_nonzero(touches) - CORNERS * edges) / touches.size


def summit_area(inputs: tb.Ensemble, hardness: float, load: float) -> float:
    """A_t* [1] by the summits of ``inputs``, at ``hardness`` H/E_ss and ``load`` F* [1]."""
    hardness = min(hardness * inputs.elastic_modulus_surfaces, HARDEST)
    inputs = inputs.changed(
        hardness_surface_1=hardness,
        hardness_surface_2=hardness,
        hardness_parameter=inputs.hardness_parameter,  # only a film needs it, and there is none
    )
    nothing = {"viscosity": 0.0, "particle_diameter": 0.0, "particle_density": 0.0}
    roughness = inputs.reference_roughness
    found = tb.solve(load=load, roughness=roughness, parameters=inputs, **nothing)
    return float(found.total_contact_area)


def rows() -> Iterator[dict[str, float | str]]:
    """Rows of the table: both areas for each surface, hardness and load."""
    for longest, seed in product(LONGEST, SEEDS):
        heights = random_heights(longest, seed)
        inputs = with_summits(heights)
        summit_parameter = f"{inputs.summit_parameter:.4f}"
        for hardness, load in product(HARDNESSES, LOADS):
            values = seed, summit_parameter, hardness, load
            areas = (
                area(given, SLOPE * hardness, SLOPE * load)
                for area, given in ((full_area, heights), (summit_area, inputs))
            )
            yield dict(zip(COLUMNS, (*values, *(f"{area:.5g}" for area in areas)), strict=True))


if __name__ == "__main__":
    with open(sys.argv[1], "w", encoding="utf-8", newline="") as file:
        writer = csv.DictWriter(file, COLUMNS, lineterminator="\n")
        writer.writeheader()
        for row in rows():
            writer.writerow(row)
            file.flush()
