"""Random points over the whole domain of the model and all its interpretations, for tests."""

from __future__ import annotations

import itertools

import numpy as np

from benchmarks.points import parameters_on_one_surface
from tests.oracle.extended import INTERPRETATIONS, SURFACE

# what points have in turn: whether the sizes have a mean, and the words of the interpretations
COMBINATIONS = list(itertools.product((False, True), *INTERPRETATIONS.values()))
PUBLISHED = {  # Tables 1 and 2, with one choice of what the paper does not print
    **{"E_ss": 112e9, "E_sa": 112e9, "H_s1": 5e9, "H_s2": 5e9, "k": 0.4, "omega_ratio": 54.0},
    **{"R_x": 6.35e-3, "G": 2038.0, "V": 0.04, "kappa": 1.0, "U_per_viscosity": 7.3e-10 / 150e-6},
    **{"A_n": 2e-6, "mean_ratio": 0.0, "sigma_a_ratio": 1.0, "truncation": 3.0},
    **{"participation": 0.02, "h_e_ratio": 0.33},
    **{"eta_s": 0.04 / (2e-5 * 3e-7), "R": 2e-5, "sigma_s": 3e-7, "y_s": 0.0},
    **{name: names[0] for name, names in INTERPRETATIONS.items()},
}


def draw(n, seed, combinations=None):
    """A model whose numbers and interpretations are arrays of n, and conditions to go with them.

    ``combinations`` are n of ``COMBINATIONS``, by default random ones: half of the sizes have no
    mean. In a quarter of the materials E/H is low, with an elastic factor up to 1; a part of the
    surfaces and sizes is extreme; coverage by all particles stays below 2.
    """
    rng = np.random.default_rng(seed)

    def logarithmic(low, high):
        return 10.0 ** rng.uniform(np.log10(low), np.log10(high), n)

    def mostly(share, usual, other):
        return np.where(rng.random(n) < share, usual, other)

    if combinations is None:
        combinations = [COMBINATIONS[i] for i in rng.integers(len(COMBINATIONS), size=n)]
    has_mean, *words = map(np.array, zip(*combinations))
    model = dict(zip(INTERPRETATIONS, words, strict=True))
    model["E_ss"] = mostly(0.75, 112e9, logarithmic(1e8, 2e10))
    model["E_sa"] = mostly(0.5, model["E_ss"], logarithmic(1e9, 1e12))
    model["H_s1"] = mostly(0.5, 5e9, logarithmic(1e8, 2e10))
    model["H_s2"] = mostly(0.5, model["H_s1"], logarithmic(1e8, 2e10))
    # softer bodies where the elastic factor would be too large: it is then up to 1
    excess = np.sqrt(elastic_factor(model))
    hardness = np.where(excess > 1.0, rng.uniform(0.1, 1.0, n) / excess, 1.0)
    model |= {name: np.maximum(model[name] * hardness, 1e6) for name in ("H_s1", "H_s2")}
    model["k"] = rng.uniform(0.1, 1.0, n)
    model["omega_ratio"] = mostly(0.5, 54.0, logarithmic(1.0, 1e4))
    model |= {"R_x": logarithmic(1e-4, 1e-1), "G": logarithmic(100.0, 1e4)}
    model |= {"V": logarithmic(1e-3, 1.0), "kappa": logarithmic(0.1, 10.0)}
    model |= {"U_per_viscosity": logarithmic(1e-7, 1e-4), "A_n": logarithmic(1e-8, 1e-4)}
    model["mean_ratio"] = np.where(has_mean, rng.uniform(0.0, 2.0, n), 0.0)
    model["sigma_a_ratio"] = mostly(0.8, rng.uniform(0.1, 2.0, n), logarithmic(1e-5, 3.0))
    model["truncation"] = rng.uniform(0.5, 10.0, n)
    model["participation"] = logarithmic(1e-4, 1.0)
    model["h_e_ratio"] = mostly(0.9, logarithmic(1e-3, 5.0), 0.0)

    roughness = mostly(0.7, logarithmic(1e-7, 1e-6), logarithmic(1e-9, 1e-5))
    model["R"] = logarithmic(1e-7, 1e-2)
    model["eta_s"] = logarithmic(0.02, 5.0) / (model["R"] * roughness)
    model["y_s"] = roughness * mostly(0.7, logarithmic(1e-2, 5.0), 0.0)
    model["sigma_s"] = roughness * mostly(0.7, logarithmic(0.05, 5.0), 1.0)

    diameter = mostly(0.95, roughness * logarithmic(0.03, 30.0), 0.0)
    density = logarithmic(1e-4, 0.3) / covered_by_one(diameter, model)
    return model, {
        "load": mostly(0.8, logarithmic(1e-8, 1e-2), logarithmic(1e-300, 1.0)),
        "viscosity": mostly(0.7, logarithmic(1e-6, 1e-3), 0.0),
        "particle_diameter": diameter,
        "roughness": roughness,
        "particle_density": density,
    }


def elastic_factor(model):
    """Of the elastic particles' area in Eq. 5."""
    strains = (model["H_s1"] / model["E_sa"]) ** 2 + (model["H_s2"] / model["E_ss"]) ** 2
    return 2.25 * np.pi**2 * strains


def covered_by_one(diameter, model):
    """About the area [m2] that a particle covers, times the share of particles that take part."""
    widest = np.maximum(diameter * np.maximum(model["mean_ratio"], 1.0), 1e-9)
    return widest**2 * model["participation"]


def draw_for_library(surfaces, points, seed):
    """What ``draw`` gives, with ``points`` points in turn on each of so many surfaces that the
    library knows, of which any 8 in turn have all ``COMBINATIONS``; and the surfaces'
    ``Parameters``.
    """
    every = itertools.islice(itertools.cycle(COMBINATIONS), surfaces)
    combinations = [one for one in every for _ in range(points)]
    drawn, conditions = draw(surfaces * points, seed, combinations)
    shared = np.repeat(np.arange(surfaces) * points, points)
    model = {name: values[shared] for name, values in drawn.items()}
    roughness = conditions["roughness"][shared]
    diameter = conditions["particle_diameter"] * roughness / conditions["roughness"]
    covered = (
        covered_by_one(conditions["particle_diameter"], drawn) * conditions["particle_density"]
    )
    conditions |= {"roughness": roughness, "particle_diameter": diameter}
    conditions["particle_density"] = covered / covered_by_one(diameter, model)
    inputs = [surface_of_library(i * points, points, model, roughness) for i in range(surfaces)]
    return model, conditions, inputs


def surface_of_library(first, points, model, roughness):
    """``Parameters`` of the points from ``first`` on, whose summits ``model`` then has: those that
    the library gives a surface of this roughness."""
    given = {name: values[first].item() for name, values in model.items()}
    sigma = float(roughness[first])
    inputs = parameters_on_one_surface(given, sigma)
    surface = inputs.surface(sigma)
    summits = surface.summit_density, surface.summit_radius
    summits += surface.summit_deviation, surface.summit_offset
    for name, value in zip(SURFACE, summits, strict=True):
        model[name][first : first + points] = value
    return inputs


def one(index, model, conditions):
    """The numbers and interpretations of one point, of those that ``draw`` gives."""
    return {name: values[index].item() for name, values in {**model, **conditions}.items()}


def move_to_kinks(model, conditions, oracle, seed):
    """The conditions, with loads that bring the surfaces next to a kink of F_s(d).

    Kinks are where the largest particles lose touch, and where the elastic ones end; each
    separation lies between 1e-14 and 3e-2 of one, on either side.  A film of the total load stands
    there under that load, where it is more than the solids bear; else these bear all.  ``model``
    and ``conditions`` are those of ``draw_for_library``; what bears next to nothing or too much
    keeps its load.
    """
    rng = np.random.default_rng(seed)
    n, sigma = conditions["load"].size, conditions["roughness"]
    diameter = np.where(conditions["particle_diameter"] > 0, conditions["particle_diameter"], sigma)
    conditions = conditions | {"particle_diameter": diameter}
    mean, spread = model["mean_ratio"] * diameter, model["sigma_a_ratio"] * diameter
    largest, depth = mean + model["truncation"] * spread, model["h_e_ratio"] * diameter
    kink = np.where(rng.random(n) < 0.5, largest, largest + depth)
    kink = np.where((rng.random(n) < 0.2) & (depth > 0.0), depth, kink)
    apart = 10.0 ** rng.uniform(-14.0, np.log10(3e-2), n) * rng.choice([-1.0, 1.0], n)
    kink = kink + np.where(model["particle_plane"] == "summit", model["y_s"], 0.0)
    separation = np.abs(kink * (1.0 + apart))
    others = {name: values for name, values in conditions.items() if name != "load"}
    solid, _, _, film = oracle.evaluate(model, separation, **others).astype(float)
    load = np.where(model["film_load"] == "total", np.maximum(solid, film), solid + film)
    usual = (load > 1e-300) & (load < 1e3)
    return conditions | {"load": np.where(usual, load, conditions["load"])}
