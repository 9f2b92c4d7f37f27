"""Total Sobol indices of results in the inputs that the paper does not print.

The model is solved at evenly scattered sets of inputs; a quadratic in the inputs is fitted to the
logarithm of each output, and the indices are those of this response surface.  How much of the
variance it misses is measured on sets left out of the fit, and reported.

Sampling and estimators: SALib (Iwanaga, Usher & Herman 2022, doi:10.18174/sesmo.18155; Herman &
Usher 2017, doi:10.21105/joss.00097), after Saltelli et al. (2010), doi:10.1016/j.cpc.2009.09.018.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace

import numpy as np
from SALib.analyze import sobol as analysis
from SALib.sample import sobol as sampling
from scipy.stats import qmc

from thirdbody.model.parameters import Parameters
from thirdbody.study.evidence import FULL_EFFORT, QUICK_EFFORT
from thirdbody.study.sensitivity import Found, Subject

LEAST_SETS = 1.2  # solved sets a term of the response surface


def quadratic_terms(positions):
    """1, every input, and every product of two: shape (sets, terms) from (sets, inputs)."""
    pairs = np.triu_indices(positions.shape[1])
    products = positions[:, pairs[0]] * positions[:, pairs[1]]
    return np.hstack([np.ones((len(positions), 1)), positions, products])


class ResponseSurface:
    """A quadratic in the inputs for the logarithm of one positive output.

    ``terms`` are the ``quadratic_terms`` of the solved sets, ``values`` the output there; sets
    without it are left out.  ``unexplained`` is the share of the variance that the fit misses on
    sets that it has not seen.  Raises ``ValueError`` if there are too few sets.
    """

    def __init__(self, terms, values):
        known = np.isfinite(values)
        least = int(np.ceil(LEAST_SETS * terms.shape[1]))
        if known.sum() < least:
            raise ValueError(f"occurs in {known.sum()} sets of inputs; allowed: at least {least}")
        terms, logarithms = terms[known], np.log(values[known])
        basis, triangle = np.linalg.qr(terms)
        self._coefficients = np.linalg.solve(triangle, basis.T @ logarithms)
        # what each set would be missed by without itself: residual over (1 - leverage)
        residual = logarithms - terms @ self._coefficients
        missed = residual / (1.0 - np.sum(basis**2, axis=1))
        self.unexplained = float(np.mean(missed**2) / np.var(logarithms))

    def __call__(self, terms):
        """The output where the ``quadratic_terms`` are ``terms``."""
        return np.exp(terms @ self._coefficients)


class Sampling:
    """Saltelli's base samples for the inputs ``names``, each evenly within [-1, 1]."""

    def __init__(self, names, base_samples: int, seed: int):
        bounds = [[-1.0, 1.0]] * len(names)
        self._problem = {"num_vars": len(names), "names": list(names), "bounds": bounds}
        self._options = {"calc_second_order": False, "seed": seed}
        self.positions = sampling.sample(self._problem, base_samples, **self._options)

    def total_indices(self, values):
        """Total index of each input, and half its 95 % interval, from ``values`` at ``positions``."""
        found = analysis.analyze(self._problem, values, **self._options)
        return found["ST"], found["ST_conf"]


def default_indices(
    subject: Subject, parameters: Parameters, inputs: Mapping[str, float], settings: Mapping
):
    """Outputs at ``parameters``, and the total indices of ``inputs`` around their values.

    ``settings`` is the entry ``sobol`` of ``config/sensitivity.yaml``.
    """
    base = subject.values(parameters, FULL_EFFORT)
    positions, solved = _solved_sets(subject, parameters, inputs, settings)
    samples = Sampling(inputs, settings["base_samples"], settings["seed"])
    solved_terms, terms = map(quadratic_terms, (positions, samples.positions))
    value, error = np.full((2, base.size, len(inputs)), np.nan)
    unexplained = np.full(base.shape, np.nan)
    for index in np.flatnonzero(np.isfinite(base)):
        try:
            surface = ResponseSurface(solved_terms, solved[:, index])
        except ValueError as few:
            print(f"{subject.outputs[index]}: {few}")
            continue
        unexplained[index] = surface.unexplained
        value[index], error[index] = samples.total_indices(surface(terms))
    occurs = np.isfinite(solved).mean(axis=0)
    return base, Found("sobol_total", value, error, occurs, unexplained)


def _solved_sets(subject, parameters, inputs, settings):
    """Positions within [-1, 1] of evenly scattered sets of inputs, and the outputs of each."""
    scattered = qmc.LatinHypercube(len(inputs), rng=settings["seed"]).random(settings["solved"])
    positions = 2.0 * scattered - 1.0
    sets = np.array(list(inputs.values())) * (1.0 + settings["spread"] * positions)
    changes = [dict(zip(inputs, some, strict=True)) for some in sets.tolist()]
    return positions, np.array([_values(subject, parameters, some) for some in changes])


def _values(subject, parameters, changes):
    """Outputs of one set of inputs; none where no surface has them."""
    try:
        return subject.values(replace(parameters, **changes), QUICK_EFFORT)
    except ValueError:
        return np.full(len(subject.outputs), np.nan)
