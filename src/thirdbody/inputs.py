"""The calibrated inputs of the model, and inputs of a user that override them."""

from collections.abc import Mapping
from dataclasses import replace
from functools import cache
from pathlib import Path
from typing import Any

from thirdbody.core.parameters import Parameters
from thirdbody.ensembles import PAPER_SETUP, Ensemble, Setup, as_ensemble
from thirdbody.files import read_yaml

CALIBRATED_FILE = Path(__file__).with_name("calibrated.yaml")  # the default


def load_parameters(
    path: str | Path | None = None,
    *,
    setup: Setup | Mapping[str, Any] | None = None,
    **inputs: float | str,
) -> Ensemble:
    """The calibrated inputs of the model, overridden by a file and by arguments.

    Parameters
    ----------
    path : str or Path, optional
        A YAML file with some inputs, SI, and perhaps a ``setup``: they override the calibrated
        inputs.  A calibrated file, with ``inputs`` and ``ensemble``, replaces all of them.
    setup : Setup or dict, optional
        Materials and density of the oil; it overrides the setup of the file.  The default is that
        of the paper, steel, with an oil of 850 kg/m3.
    **inputs : float, str or quantity
        Inputs by the field names of ``Parameters``, SI or quantities.  They override the file.

    Returns
    -------
    Ensemble
        The best set of inputs and the other members, SI.  All members have the inputs of the file
        and of ``inputs``; those that were calibrated with them follow, as in ``Ensemble.changed``.

    Raises
    ------
    ValueError
        As in ``Ensemble.changed``.

    Warns
    -----
    UserWarning
        As in ``Ensemble.changed``.

    Examples
    --------
    >>> parameters = load_parameters()
    >>> parameters.ball_radius  # [m]
    0.00635
    >>> sparse = load_parameters(participation=0.5)
    >>> sparse.participation, sparse.truncation == parameters.truncation
    (0.5, True)
    """
    content = {} if path is None else read_yaml(path)
    is_calibrated = "inputs" in content
    ensemble = ensemble_of(content if is_calibrated else _default_content())
    known = content.pop("setup", None) if setup is None else setup
    if known is not None:
        ensemble = replace(ensemble, setup=known if isinstance(known, Setup) else Setup.of(known))
    changes = {} if is_calibrated else content
    return ensemble._with(changes | inputs, stacklevel=3)


def ensemble_of(calibrated: Mapping[str, Any]) -> Ensemble:
    """The ensemble from the content of a ``calibrated`` file, the best set first."""
    inputs: Any = calibrated.get("inputs")
    members = calibrated.get("ensemble")
    if not isinstance(members, list) or not all(isinstance(x, dict) for x in (inputs, *members)):
        raise ValueError(
            "these are not calibrated inputs; allowed: inputs, a dict, and ensemble, a list of them"
        )
    best = Parameters(**inputs)
    best.check_ball()
    others = [Parameters(**inputs | member) for member in members]
    if best in others:  # the best is a member as often as in the file
        others.remove(best)
    return Ensemble((best, *others), PAPER_SETUP).changed()


def or_calibrated(parameters: Parameters | Ensemble | None) -> Ensemble:
    """``parameters`` as an ensemble, or the calibrated ensemble for None."""
    return _calibrated() if parameters is None else as_ensemble(parameters)


@cache
def _calibrated():
    return load_parameters()


@cache
def _default_content():
    """The content of the calibrated file, read once: reading takes longer than solving a point."""
    return read_yaml(CALIBRATED_FILE)


def ensemble(parameters: Ensemble | None = None) -> list[Parameters]:
    """The sets of inputs, each fitted without some figures of the paper, the best first.

    Parameters
    ----------
    parameters : Ensemble, optional
        Inputs of the model, by default the calibrated inputs.

    Returns
    -------
    list of Parameters
        The members; only the best if there are no others.

    Examples
    --------
    >>> import thirdbody as tb
    >>> len(tb.ensemble())
    61
    """
    return list(or_calibrated(parameters).members)
