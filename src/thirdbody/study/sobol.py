"""Total Sobol indices: how much of a result's variance each unprinted input takes part in.

A quadratic in the inputs, the response surface, is fitted to the logarithm of each output at evenly
scattered sets of inputs, and the indices are those of this surface.  Inputs are varied by *positions*
between -1 and 1, the ends of their ranges.

Sampling and estimators: SALib (Iwanaga, Usher & Herman 2022, doi:10.18174/sesmo.18155; Herman &
Usher 2017, doi:10.21105/joss.00097), after Saltelli et al. (2010), doi:10.1016/j.cpc.2009.09.018.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import replace
from typing import Any

import numpy as np
from numpy.typing import NDArray
from SALib.analyze import sobol as analysis
from SALib.sample import sobol as sampling
from scipy.stats import qmc

from thirdbody.model.bounds import BOUNDS
from thirdbody.model.parameters import Parameters
from thirdbody.study.evidence import FULL_EFFORT, QUICK_EFFORT
from thirdbody.study.sensitivity import Found, Subject

LEAST_SETS = 1.2  # solved sets of inputs for each term of a response surface


def quadratic_terms(positions: NDArray[np.float64]) -> NDArray[np.float64]:
    """Terms of a quadratic at ``positions`` [1], shape (sets, inputs): shape (sets, terms).

    They are 1, every input, and every product of two inputs.

    Examples
    --------
    >>> quadratic_terms(np.array([[2.0, 3.0]]))
    array([[1., 2., 3., 4., 6., 9.]])
    """
    pairs = np.triu_indices(positions.shape[1])
    products = positions[:, pairs[0]] * positions[:, pairs[1]]
    return np.hstack([np.ones((len(positions), 1)), positions, products])


class ResponseSurface:
    """A quadratic in the inputs, fitted to the logarithm of one positive output.

    Parameters
    ----------
    terms : array, shape (sets, terms)
        The ``quadratic_terms`` of the solved sets of inputs.
    values : array, shape (sets,)
        The output there [unit of the output]; sets where it is nan are left out.

    Attributes
    ----------
    unexplained : float
        Fraction of the variance of the logarithm that the fit to all other sets misses [1].

    Raises
    ------
    ValueError
        If the output occurs in too few sets.
    """

    def __init__(self, terms: NDArray[np.float64], values: NDArray[np.float64]):
        known = np.isfinite(values)
        least = int(np.ceil(LEAST_SETS * terms.shape[1]))
        if known.sum() < least:
            raise ValueError(f"occurs in {known.sum()} sets of inputs; allowed: at least {least}")
        terms, logarithms = terms[known], np.log(values[known])
        basis, triangle = np.linalg.qr(terms)
        self._coefficients = np.linalg.solve(triangle, basis.T @ logarithms)
        # By how much the fit to all other sets misses each set: residual over (1 - leverage).
        residual = logarithms - terms @ self._coefficients
        missed = residual / (1.0 - np.sum(basis**2, axis=1))
        self.unexplained = float(np.mean(missed**2) / np.var(logarithms))

    def __call__(self, terms: NDArray[np.float64]) -> NDArray[np.float64]:
        """Output [its unit], shape (sets,), where the ``quadratic_terms`` are ``terms``."""
        return np.exp(terms @ self._coefficients)


class Sampling:
    """Saltelli's sampling scheme for inputs distributed evenly from -1 to 1.

    Parameters
    ----------
    names : sequence of str
        The inputs.
    base_samples : int
        A power of 2.
    seed : int
        The same seed gives the same samples and intervals.

    Attributes
    ----------
    positions : array, shape (samples, inputs)
        Where the output must be known [1].
    """

    def __init__(self, names: Sequence[str], base_samples: int, seed: int):
        bounds = [[-1.0, 1.0]] * len(names)
        self._problem = {"num_vars": len(names), "names": list(names), "bounds": bounds}
        self._options = {"calc_second_order": False, "seed": seed}
        self.positions = sampling.sample(self._problem, base_samples, **self._options)

    def total_indices(
        self, values: NDArray[np.float64]
    ) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
        """Total index of each input and half its 95 % confidence interval [1], shape (inputs,).

        ``values``, shape (samples,), are the output at ``positions``.
        """
        found = analysis.analyze(self._problem, values, **self._options)
        return found["ST"], found["ST_conf"]


def default_indices(
    subject: Subject,
    parameters: Parameters,
    inputs: Mapping[str, float],
    settings: Mapping[str, Any],
) -> tuple[NDArray[np.float64], Found]:
    """Total Sobol indices of the outputs around given inputs.

    An output that occurs in too few of the solved sets keeps nan, and a line of text says so.

    Parameters
    ----------
    subject : Subject
        What is asked about.
    parameters : Parameters
        All inputs of the model.
    inputs : mapping
        Which of them vary, with their values, SI: those of ``varied_inputs``.
    settings : mapping
        The entry ``sobol`` of ``config/sensitivity.yaml``: ``spread`` is the relative change to
        either side, as far as the input may have such values, ``solved`` the number of sets of
        inputs, ``base_samples`` and ``seed`` those of ``Sampling``.

    Returns
    -------
    base : array, shape (outputs,)
        The outputs at ``parameters``, in the order of ``subject.outputs``.
    found : Found
        Indices, half their 95 % intervals, and how well the response surfaces fit.

    Examples
    --------
    >>> from thirdbody import load_parameters
    >>> from thirdbody.data.conditions import Condition
    >>> dry = Condition(0.0, 300e-9, 300e-9, 1e11)
    >>> subject = Subject((dry,), (), (), newtons=(0.04, 80.0))
    >>> inputs = load_parameters()
    >>> settings = {"spread": 0.05, "solved": 12, "base_samples": 64, "seed": 1}
    >>> varied = {"apparent_area": inputs.apparent_area}
    >>> base, found = default_indices(subject, inputs, varied, settings)
    >>> found.measure, found.value.shape
    ('sobol_total', (2, 1))
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
    """Evenly scattered sets of inputs: positions from -1 to 1, and the outputs of each set."""
    scattered = qmc.LatinHypercube(len(inputs), rng=settings["seed"]).random(settings["solved"])
    positions = 2.0 * scattered - 1.0
    sides = np.array([1.0 - settings["spread"], 1.0 + settings["spread"]])
    ends = [np.clip(value * sides, *BOUNDS[name]) for name, value in inputs.items()]
    low, high = np.transpose(ends)
    sets = low + (high - low) * scattered
    changes = [dict(zip(inputs, some, strict=True)) for some in sets.tolist()]
    return positions, np.array([_values(subject, parameters, some) for some in changes])


def _values(subject, parameters, changes):
    """Outputs with ``changes`` among the inputs; all nan if no surface can have such inputs."""
    try:
        return subject.values(replace(parameters, **changes), QUICK_EFFORT)
    except ValueError:
        return np.full(len(subject.outputs), np.nan)
