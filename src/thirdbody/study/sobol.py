"""Total Sobol indices: the part of the variance of a result to which each unprinted input contributes.

A quadratic in the inputs, the response surface, is fitted to the logarithm of each output at evenly
scattered sets of inputs.  Its terms are products of Legendre polynomials, uncorrelated over the
ranges of the inputs, so that the square of a coefficient is the variance of its term (polynomial
chaos expansion: Sudret 2008, doi:10.1016/j.ress.2007.04.002).  Inputs are varied by *positions*
between -1 and 1, the ends of their ranges.
"""

from __future__ import annotations

from collections.abc import Mapping
from contextlib import suppress
from dataclasses import replace
from typing import Any

import numpy as np
from numpy.typing import NDArray
from scipy.stats import qmc

from thirdbody.model.bounds import BOUNDS
from thirdbody.model.parameters import Parameters
from thirdbody.study.evidence import QUICK_EFFORT
from thirdbody.study.sensitivity import Found, Subject

LEAST_SETS = 1.2  # solved sets of inputs for each term of a response surface


def legendre_terms(
    positions: NDArray[np.float64],
) -> tuple[NDArray[np.float64], NDArray[np.bool_]]:
    """Terms of a quadratic at ``positions``, shape (sets, inputs), each with mean square 1: shape (sets,
    terms); and whether a term depends on an input, shape (terms, inputs)."""
    first = np.sqrt(3.0) * positions
    second = np.sqrt(5.0) * (1.5 * positions**2 - 0.5)
    one, other = np.triu_indices(positions.shape[1], k=1)
    terms = [np.ones((len(positions), 1)), first, second, first[:, one] * first[:, other]]
    inputs = np.eye(positions.shape[1], dtype=bool)
    involved = [np.zeros_like(inputs[:1]), inputs, inputs, inputs[one] | inputs[other]]
    return np.hstack(terms), np.vstack(involved)


def total_indices(
    positions: NDArray[np.float64], values: NDArray[np.float64]
) -> tuple[NDArray[np.float64], float]:
    """Total Sobol index of each input in the logarithm of a positive output, shape (inputs,), and the
    fraction of the variance missed in leave-one-out cross-validation [1].

    ``values``, shape (sets,), is the output at ``positions``, shape (sets, inputs); nan where it does not
    occur.  Both results are nan if it occurs in too few sets.
    """
    terms, involved = legendre_terms(positions)
    known = np.isfinite(values)
    if known.sum() < LEAST_SETS * terms.shape[1]:
        return np.full(positions.shape[1], np.nan), np.nan
    terms, logarithms = terms[known], np.log(values[known])
    basis, triangle = np.linalg.qr(terms)
    coefficients = np.linalg.solve(triangle, basis.T @ logarithms)
    # Leave-one-out error of each set: residual over (1 - leverage).
    missed = (logarithms - terms @ coefficients) / (1.0 - np.sum(basis**2, axis=1))
    variances = coefficients[1:] ** 2
    indices = variances @ involved[1:] / variances.sum()
    return indices, float(np.mean(missed**2) / np.var(logarithms))


def default_indices(
    subject: Subject,
    parameters: Parameters,
    inputs: Mapping[str, float],
    base: NDArray[np.float64],
    settings: Mapping[str, Any],
) -> Found:
    """Total Sobol indices of the outputs, ``base`` at ``parameters``, for some ``inputs``, SI.

    The error is the fraction missed by the response surface: any input may contribute to it.
    ``settings`` is the entry ``sobol`` of ``config/sensitivity.yaml``.
    """
    scattered = qmc.LatinHypercube(len(inputs), rng=settings["seed"]).random(settings["solved"])
    sides = np.array([1.0 - settings["spread"], 1.0 + settings["spread"]])
    ends = [np.clip(value * sides, *BOUNDS[name]) for name, value in inputs.items()]
    low, high = np.transpose(ends)
    solved = np.full((len(scattered), base.size), np.nan)
    for place, values in enumerate((low + (high - low) * scattered).tolist()):
        with suppress(ValueError):  # no surface has these inputs
            changed = replace(parameters, **dict(zip(inputs, values, strict=True)))
            solved[place] = subject.values(changed, QUICK_EFFORT)
    value = np.full((base.size, len(inputs)), np.nan)
    unexplained = np.full(base.shape, np.nan)
    for index in np.flatnonzero(np.isfinite(base)):
        value[index], unexplained[index] = total_indices(2.0 * scattered - 1.0, solved[:, index])
    error = np.broadcast_to(unexplained[:, None], value.shape)
    occurs = np.isfinite(solved).mean(axis=0)
    return Found("sobol_total", value, error, occurs, unexplained)
