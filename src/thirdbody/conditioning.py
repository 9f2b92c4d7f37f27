"""Members of an ensemble where some of their inputs are given.

Matheron's rule: each member is moved by the regression of its other inputs on what is given, and
keeps its own residual (Chiles & Delfiner 2012, Geostatistics, section 7.3).  It is exact for
Gaussian ensembles.  The valley of the calibrated inputs is bent, so that only the members nearest
to what is given stay.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import replace
from typing import Any

import numpy as np
from numpy.typing import NDArray

from thirdbody.core.parameters import BOUNDS, Parameters

# combinations of what is given in which members differ less than this, of that in which they
# differ most, say nothing on the other inputs
LEAST_SPREAD = 0.01
# the part of the members that is near what is given, and the least number of them
NEAR, FEWEST = 1.0 / 3.0, 12


def differing_numbers(members: Sequence[Parameters]) -> list[str]:
    """The numbers in which members differ: these were calibrated together."""
    return [name for name in BOUNDS if len({getattr(each, name) for each in members}) > 1]


def conditioned(members: Sequence[Parameters], given: Mapping[str, Any]) -> list[Parameters]:
    """Members that have the ``given`` inputs, SI: the first, and of the others those near to them.

    The other inputs follow as far as members tell; an input that all members share is only set.  A
    member that has the given values stays as it is.

    Raises
    ------
    ValueError
        For a number out of bounds and an unknown word.
    """
    differing = differing_numbers(members)
    known = [name for name in differing if name in given]
    others = [name for name in differing if name not in given]
    moved: list[dict[str, Any]] = [{} for _ in members]
    if known and others:
        for name, values in _moved(members, known, others, given).items():
            for inputs, value in zip(moved, values.tolist(), strict=True):
                inputs[name] = value
    # what is given last, as the regression stops where no member is near
    return [
        replace(members[index], **moved[index], **given) for index in _near(members, known, given)
    ]


def _near(members, known, given) -> list[int]:
    """Indices of the first member and of those that are nearest in the ``known``."""
    if not known:
        return [*range(len(members))]
    places = _columns(members, known)
    target = [_scaled(name, given[name]) for name in known]
    distances = np.linalg.norm((places - target) / places.std(axis=0), axis=1)
    distances[0] = 0.0
    count = max(round(NEAR * len(members)), FEWEST)
    return sorted(np.argsort(distances, kind="stable")[:count].tolist())


def _moved(members, known, others, given) -> dict[str, NDArray]:
    """The values of the ``others`` that follow from the ``known``, of each member."""
    replace(members[0], **given)  # the logarithm of a number out of bounds may not exist
    here, there = _columns(members, known), _columns(members, others)
    target = [np.clip(_scaled(name, given[name]), *_reach(members, name)) for name in known]
    unit = here.std(axis=0)
    deviations = (here - here.mean(axis=0)) / unit
    slopes = np.linalg.lstsq(deviations, there - there.mean(axis=0), rcond=LEAST_SPREAD)[0]
    changes = (target - here) / unit @ slopes
    found = {}
    for name, change in zip(others, changes.T, strict=True):
        # not by way of the logarithm: no change is then none to the bit
        values = _values(members, name)
        values = values * np.exp(change) if _is_positive(name) else values + change
        found[name] = np.clip(values, BOUNDS[name].least, BOUNDS[name].most)
    return found


def far_texts(members: Sequence[Parameters], given: Mapping[str, Any]) -> Iterator[str]:
    """Words on each of the ``given`` numbers that is far from all members."""
    for name in differing_numbers(members):
        if name not in given:
            continue
        low, high = _reach(members, name)
        if not low <= _scaled(name, given[name]) <= high:
            values = _values(members, name)
            yield (
                f"{name} is {given[name]:g}, and {values.min():g} to {values.max():g} in the "
                "ensemble; the calibrated inputs do not belong to this contact"
            )


def _reach(members, name) -> tuple[float, float]:
    """What the members may tell of: from their least to their most and as far again."""
    values = _scaled(name, _values(members, name))
    spread = np.ptp(values)
    return values.min() - spread, values.max() + spread


def _values(members, name) -> NDArray:
    return np.array([getattr(member, name) for member in members])


def _columns(members, names) -> NDArray:
    """The scaled inputs of these ``names``, shape (members, names)."""
    return np.column_stack([_scaled(name, _values(members, name)) for name in names])


def _is_positive(name) -> bool:
    return BOUNDS[name].least > 0.0


def _scaled(name, values):
    """Logarithms of what is always positive; other numbers as they are."""
    return np.log(values) if _is_positive(name) else values
