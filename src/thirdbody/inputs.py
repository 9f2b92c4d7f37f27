"""The calibrated inputs of the model, and those of a user laid over them."""

import math
import warnings
from collections.abc import Mapping
from functools import cache
from pathlib import Path
from typing import Any

from thirdbody.conditions import numbers_in
from thirdbody.core.parameters import BOUNDS, WORDS, Parameters
from thirdbody.plain_yaml import read_yaml

CALIBRATED_FILE = Path(__file__).with_name("calibrated.yaml")  # the default


def load_parameters(path: str | Path | None = None, **inputs: float | str) -> Parameters:
    """The calibrated inputs of the model, with others laid over them.

    Parameters
    ----------
    path : str or Path, optional
        A YAML file with some inputs, SI, that override the calibrated ones; or a calibrated file, with
        ``inputs`` and ``ensemble``, that replaces them.
    **inputs : float, str or quantity
        Inputs by the field names of ``Parameters``, SI or quantities; they override the file.

    Returns
    -------
    Parameters
        All inputs, SI.

    Raises
    ------
    ValueError
        For an unknown input, a number out of bounds, an unknown word, a quantity of another dimension, and an
        A_n larger than the ball.

    Warns
    -----
    UserWarning
        For a modulus, hardness or radius without G, V or U/nu, which depend on it:
        ``thirdbody.bearing`` changes them together; and for another mean of the sizes, plane of the particles
        or load of the film without the inputs that were calibrated for it.

    Examples
    --------
    >>> parameters = load_parameters()
    >>> parameters.ball_radius  # [m]
    0.00635
    >>> sparse = load_parameters(participation=0.5)
    >>> sparse.participation, sparse.truncation == parameters.truncation
    (0.5, True)
    """
    calibrated, changes = _default_content(), {}
    if path is not None:
        content = read_yaml(path)
        calibrated, changes = (content, {}) if "inputs" in content else (calibrated, content)
    changes = changed_inputs(changes | inputs)
    parameters = parameters_of(calibrated)
    changed = parameters.changed(**changes)
    changed.check_ball()
    _warn_of_what_stays(changes, parameters)
    return changed


def changed_inputs(changes: Mapping[str, Any]) -> dict[str, float | str]:
    """Some inputs as floats in SI and words; ``ValueError`` for a name that is none."""
    for name in changes:
        if name not in Parameters.names():
            raise ValueError(f"{name} is no input; allowed: {', '.join(Parameters.names())}")
    return {
        name: value
        if isinstance(value, str) and name in WORDS
        else float(numbers_in(name, value, BOUNDS[name].unit))
        for name, value in changes.items()
    }


def parameters_of(calibrated: Mapping[str, Any]) -> Parameters:
    """The inputs in the ``calibrated`` content of a file, and their ensemble, if its members differ."""
    values = calibrated["inputs"]
    members = [Parameters(**values | member) for member in calibrated["ensemble"]]
    return Parameters(**values).with_members(members).changed()


def or_calibrated(parameters: Parameters | None) -> Parameters:
    """``parameters``, or the calibrated ones if it is None."""
    return _calibrated() if parameters is None else parameters


@cache
def _calibrated():
    return load_parameters()


@cache
def _default_content():
    """Cached: reading the file takes longer than solving one point."""
    return read_yaml(CALIBRATED_FILE)


def ensemble(parameters: Parameters | None = None) -> tuple[Parameters, ...]:
    """The sets of inputs that explain the paper about equally well, from which ranges are computed.

    They are the members of the calibrated file of ``parameters``, by default that of the project, with as many
    members from each interpretation that explains the paper as well as the best.  What was given to
    ``load_parameters``, ``bearing`` or ``Parameters.changed`` is known: all members have it.  The range of a
    result is 5 to 95 % of its values over them.

    Parameters
    ----------
    parameters : Parameters, optional
        Inputs of the model, by default the calibrated ones.

    Returns
    -------
    tuple of Parameters
        The members; none for inputs that were built without them.

    Examples
    --------
    >>> import numpy as np
    >>> import thirdbody as tb
    >>> particles = dict(particle_diameter_nm=300, particle_density_per_m2=1e11)
    >>> interface = dict(load_N=10, viscosity_cSt=120, roughness_nm=300, **particles)
    >>> shares = [
    ...     float(tb.solve(**interface, parameters=member).solid_load_fraction)
    ...     for member in tb.ensemble()
    ... ]
    >>> low, high = np.quantile(shares, (0.05, 0.95))
    >>> bool(low < tb.solve(**interface).solid_load_fraction < high)
    True
    """
    return or_calibrated(parameters).members


# inputs that were found for one value of another, or are derived from it (below Eq. 8), and what changes them together
BEARING = "thirdbody.bearing changes them together"
CALIBRATED = "they were found for the value of the calibrated file"
BELONGS_TO = {
    "elastic_modulus_surfaces": (
        ("material_parameter", "hardness_parameter", "speed_per_viscosity"),
        BEARING,
    ),
    "hardness_surface_1": (("hardness_parameter",), BEARING),
    "hardness_surface_2": (("hardness_parameter",), BEARING),
    "ball_radius": (("speed_per_viscosity",), BEARING),
    "mean_ratio": (("spread_ratio", "elastic_depth_ratio"), CALIBRATED),
    "particle_plane": (("elastic_depth_ratio", "summit_offset_ratio"), CALIBRATED),
    "film_load": (("summit_parameter", "summit_radius", "apparent_area"), CALIBRATED),
}


def _warn_of_what_stays(changes, before):
    """Warn of inputs that differ from ``before`` without those that belong to their value."""
    for name in BELONGS_TO.keys() & changes.keys():
        dependents, reason = BELONGS_TO[name]
        stay = ", ".join(other for other in dependents if other not in changes)
        value, old = changes[name], getattr(before, name)
        same = value == old if isinstance(value, str) else math.isclose(value, old)
        if stay and not same:
            message = f"{name} is changed without {stay}; {reason}"
            warnings.warn(message, UserWarning, stacklevel=3)
