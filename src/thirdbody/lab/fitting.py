"""``fit``: inputs of the model calibrated to measurements."""

from collections.abc import Sequence
from dataclasses import dataclass, replace
from functools import cached_property
from itertools import combinations
from os import PathLike
from typing import Any

import numpy as np
import pandas as pd
from numpy.typing import ArrayLike, NDArray
from scipy.optimize import approx_fprime, least_squares

from thirdbody.conditions import checked_number, without_warnings
from thirdbody.core.parameters import BOUNDS, Parameters
from thirdbody.inputs import or_calibrated
from thirdbody.lab.comparison import of_oil, read_runs, solve_runs
from thirdbody.lab.estimates import COEFFICIENTS, MEASURED, USUAL_COEFFICIENTS, measurable

# least and most value, and unit, of what can be fitted: the logarithm needs positive numbers
LIMITS = {name: (*bounds,) for name, bounds in BOUNDS.items() if bounds.least > 0.0}
LIMITS |= USUAL_COEFFICIENTS
STEP = 1e-4  # of derivatives, in logarithms
FAR = 100.0  # residual where the model has no solution, so that the search turns back
LEAST_SIZE = 1e-12  # of a singular value of the Jacobian
HARDLY_TOLD = 0.5  # of the variance of the prior that the data take away
ALIKE = 0.95  # correlation of two unknowns of which the data tell only a combination


def fit(
    measured: str | PathLike | pd.DataFrame,
    unknowns: Sequence[str],
    *,
    parameters: Parameters | None = None,
    relative_error: float = 0.05,
    boundary_friction: float = 0.12,
    film_friction: float = 0.03,
    resistivity_ohm_m: float = 2.2e-7,
    oil_density_kg_per_m3: float | None = None,
    **conditions: ArrayLike,
) -> pd.DataFrame:
    """Calibrate chosen inputs of the model to measurements, by least squares of their logarithms.

    The residuals are those of the measurements, over their standard deviation, and those of the prior:
    where the ``members`` of ``parameters`` differ in an unknown, its logarithm has their mean and standard
    deviation.  Other unknowns are free within their bounds; ``parameters.with_members(())`` frees all.  The
    covariance is that of the Jacobian at the solution.  Other inputs stay, also those that depend on an
    unknown, as G, V and U/nu on a modulus.

    Parameters
    ----------
    measured : path or pandas.DataFrame
        As in ``thirdbody.lab.compare``.
    unknowns : sequence of str
        Positive inputs, by the field names of ``Parameters``; also the three coefficients below.
    parameters : Parameters, optional
        The other inputs and the start of the search, by default the calibrated ones.
    relative_error : float
        Standard deviation of the measurements, relative to each value; of ratios, such as friction, to the
        root mean square of the column.
    boundary_friction, film_friction, resistivity_ohm_m : float or quantity
        Coefficients of ``thirdbody.lab.friction`` [1] and ``thirdbody.lab.contact_resistance`` [ohm m].
    oil_density_kg_per_m3, **conditions
        As in ``thirdbody.lab.compare``.

    Returns
    -------
    pandas.DataFrame
        A row for each of the unknowns: ``value``, ``standard_error``, ``prior`` and ``prior_deviation`` in its
        ``unit``, nan without a prior; and ``told_by_data`` [1], the part of the variance of the prior that
        the measurements take away, or of that between the bounds.  ``attrs`` has ``parameters``, the
        inputs with these values; ``coefficients``; ``covariance`` of the logarithms; ``misfit``, the root mean
        square of the residuals over the error; and ``notes``, with what the measurements do not tell.

    Raises
    ------
    ValueError
        For an unknown that is no positive input, and as in ``thirdbody.lab.compare``.

    Examples
    --------
    >>> import numpy as np
    >>> import pandas as pd
    >>> import thirdbody as tb
    >>> layer = dict(particle_diameter_nm=500, particle_density_per_m2=1e11, roughness_nm=300)
    >>> interface = dict(viscosity_cSt=90, **layer)
    >>> truth = tb.load_parameters(participation=0.5)
    >>> points = tb.solve(load_N=[2, 5, 10, 20, 40], parameters=truth, **interface)
    >>> data = pd.DataFrame({"load [N]": [2, 5, 10, 20, 40], "separation [nm]": 1e9 * points.separation})
    >>> table = tb.lab.fit(data, ["participation"], relative_error=0.01, **interface)
    >>> table["value"].round(2).to_dict()
    {'participation': 0.5}
    >>> fitted = table.attrs["parameters"]
    """
    parameters = or_calibrated(parameters)
    for name in unknowns:
        if name not in LIMITS:
            raise ValueError(f"unknowns has {name!r}; allowed: {', '.join(LIMITS)}")
    observed, table, notes = read_runs(measured, parameters, conditions)
    parameters = of_oil(oil_density_kg_per_m3, parameters, table)
    misfit = _Misfit(
        unknowns=tuple(unknowns),
        parameters=parameters,
        coefficients={
            "boundary_friction": checked_number("boundary_friction", boundary_friction),
            "film_friction": checked_number("film_friction", film_friction),
            "resistivity_ohm_m": checked_number(
                "resistivity_ohm_m", resistivity_ohm_m, unit="ohm m"
            ),
        },
        observed=observed,
        errors=_errors(observed, checked_number("relative_error", relative_error)),
        conditions=table,
    )
    logarithms, covariance = _solved(misfit)
    changes, coefficients = misfit.inputs(logarithms)
    deviation = np.sqrt(np.diag(covariance))
    prior, prior_deviation = misfit.prior
    value = np.exp(logarithms)
    least, most = np.log([LIMITS[name][:2] for name in unknowns]).T
    known = np.where(np.isnan(prior), (most - least) / np.sqrt(12.0), prior_deviation)
    result = pd.DataFrame(
        {
            "value": value,
            "standard_error": value * deviation,
            "prior": np.exp(prior),
            "prior_deviation": np.exp(prior) * prior_deviation,
            "unit": [LIMITS[name][2] for name in unknowns],
            "told_by_data": np.maximum(1.0 - (deviation / known) ** 2, 0.0),
        },
        index=[*unknowns],
    )
    size = float(np.sqrt(np.mean(misfit.of_data(logarithms) ** 2)))
    result.attrs = {
        "notes": notes + _notes(result, covariance, size, relative_error),
        "parameters": parameters.changed(**changes),
        "coefficients": coefficients,
        "covariance": covariance.tolist(),
        "misfit": size,
    }
    return result


@dataclass(frozen=True, kw_only=True)
class _Misfit:
    """The residuals of measurements and prior, by the logarithms of the unknowns."""

    unknowns: tuple[str, ...]
    parameters: Parameters
    coefficients: dict[str, float]
    observed: pd.DataFrame
    errors: pd.DataFrame
    conditions: pd.DataFrame

    @cached_property
    def prior(self) -> tuple[NDArray, NDArray]:
        """Mean and standard deviation of the logarithm of each unknown over the members; nan if all are one."""
        ends = np.full((2, len(self.unknowns)), np.nan)
        for column, name in enumerate(self.unknowns):
            numbers = [getattr(each, name, np.nan) for each in self.parameters.members]
            if len(set(numbers)) > 1:
                ends[:, column] = np.mean(np.log(numbers)), np.std(np.log(numbers), ddof=1)
        return ends[0], ends[1]

    @property
    def start(self) -> NDArray:
        """The logarithms of the values that are given."""
        values = self.parameters.as_dict() | self.coefficients
        return np.log([values[name] for name in self.unknowns])

    def inputs(self, logarithms: NDArray) -> tuple[dict[str, Any], dict[str, float]]:
        """The unknown inputs, and all coefficients."""
        values = dict(zip(self.unknowns, np.exp(logarithms).tolist()))
        changes = {name: value for name, value in values.items() if name not in COEFFICIENTS}
        return changes, {name: values.get(name, n) for name, n in self.coefficients.items()}

    def of_data(self, logarithms: NDArray) -> NDArray:
        """Model minus measurements, over their errors."""
        changes, coefficients = self.inputs(logarithms)
        inputs = replace(self.parameters, **changes).with_rig(self.parameters.rig)
        (solution,) = solve_runs(self.conditions, [inputs])
        with without_warnings():
            model = pd.DataFrame(measurable(solution, coefficients), self.observed.index)
        residuals = ((model[self.observed.columns] - self.observed) / self.errors).to_numpy()
        return np.nan_to_num(residuals[np.isfinite(self.observed)], nan=FAR, posinf=FAR)

    def __call__(self, logarithms: NDArray) -> NDArray:
        """The residuals of the data and of the prior."""
        mean, deviation = self.prior
        of_prior = (logarithms - mean) / deviation
        return np.concatenate([self.of_data(logarithms), of_prior[np.isfinite(mean)]])


def _errors(observed, relative_error):
    """The standard deviation of each measurement, of ratios the same in all rows."""
    sizes = {
        name: np.sqrt((column**2).mean()) if MEASURED[name].unit == "1" else column.abs()
        for name, column in observed.items()
    }
    return relative_error * pd.DataFrame(sizes, observed.index)


def _solved(misfit):
    """The logarithms of least misfit, within the bounds, and their covariance."""
    least, most = np.log([LIMITS[name][:2] for name in misfit.unknowns]).T
    least, most = least + STEP, most - 2.0 * STEP  # for the derivatives
    solution = least_squares(
        misfit,
        np.clip(misfit.start, least + STEP, most - STEP),
        jac=lambda logarithms: approx_fprime(logarithms, misfit, STEP),
        bounds=(least, most),
        x_scale="jac",
    )
    _, sizes, axes = np.linalg.svd(solution.jac, full_matrices=False)
    axes = axes / np.maximum(sizes, LEAST_SIZE)[:, np.newaxis]
    return solution.x, axes.T @ axes


def _notes(result, covariance, misfit, relative_error):
    """What the measurements do not tell, and an error that does not agree with the misfit."""
    notes = [
        f"the measurements hardly tell {name}: its standard error is {row.standard_error:.2g}, "
        f"for a value of {row.value:.3g}"
        for name, row in result.iterrows()
        if row.told_by_data < HARDLY_TOLD
    ]
    deviation = np.sqrt(np.diag(covariance))
    correlation = covariance / np.outer(deviation, deviation)
    notes += [
        f"the measurements tell only a combination of {one} and {other}: correlation {r:.2f}"
        for (i, one), (j, other) in combinations(enumerate(result.index), 2)
        if abs(r := correlation[i, j]) > ALIKE
    ]
    if not 0.5 < misfit < 2.0:
        better = f"relative_error={misfit * relative_error:.2g} agrees with it"
        notes.append(f"the misfit is {misfit:.2g} times relative_error; {better}")
    return notes
