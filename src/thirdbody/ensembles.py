"""``Ensemble``: sets of inputs, each fitted without some figures of the paper, and their setup.

The best set gives the answer to a question.  The answers of all sets give its range.
"""

from __future__ import annotations

import json
import math
import warnings
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import asdict, dataclass, fields, replace
from typing import Any, Self

import numpy as np
from numpy.typing import ArrayLike, NDArray

from thirdbody.conditioning import conditioned, differing_numbers, far_texts
from thirdbody.conditions import OIL_DENSITY, checked_number, checked_numbers, single_number
from thirdbody.core.parameters import BOUNDS, WORDS, Parameters
from thirdbody.files import format_value

MEMBER = "member"  # the dimension of results of all members
ENDS = (0.05, 0.95)  # quantiles at the ends of a range over the members
# what a range is, in answers, captions, datasets and pages: no confidence interval
FITTED = "each fitted without some figures of the paper"
RANGE = f"range of the ensemble: 5 to 95 % of sets of inputs, {FITTED}"
GIGA = 1e9
USUAL_MATERIAL = {"modulus_GPa": (0.1, 2000.0, "GPa"), "hardness_GPa": (0.01, 200.0, "GPa")}
BODIES = "ball", "flat", "particle"
# An input that others depend on: the others were calibrated for its value, or are derived from it
# (below Eq. 8).  The words say why a change of this input alone is wrong.
BEARING = "thirdbody.bearing changes them together"
CALIBRATED = "they were found for the value of the calibrated file"
ROUNDED = 0.1  # a value that differs less from that of the calibrated file is the same, rounded
BELONGS_TO = {
    "elastic_modulus_surfaces": (
        ("material_parameter", "hardness_parameter", "speed_per_viscosity"),
        BEARING,
    ),
    "hardness_surface_1": (("hardness_parameter",), BEARING),
    "hardness_surface_2": (("hardness_parameter",), BEARING),
    "ball_radius": (("speed_per_viscosity",), BEARING),
    "apparent_area": (("summit_parameter", "summit_radius"), CALIBRATED),
    "mean_ratio": (("spread_ratio", "elastic_depth_ratio"), CALIBRATED),
    "particle_plane": (("elastic_depth_ratio", "summit_offset_ratio"), CALIBRATED),
    "film_load": (("summit_parameter", "summit_radius", "apparent_area"), CALIBRATED),
}


@dataclass(frozen=True)
class Material:
    """The material of a body: modulus, Poisson's ratio and hardness, as numbers or quantities.

    Parameters
    ----------
    modulus_GPa : float
        Young's modulus E [GPa].
    poisson_ratio : float
        Poisson's ratio v [1], 0 to 0.5.
    hardness_GPa : float
        Hardness H [GPa].

    Examples
    --------
    >>> import thirdbody as tb
    >>> bronze = tb.Material(modulus_GPa=110, poisson_ratio=0.34, hardness_GPa=1.5)
    >>> inputs = tb.bearing(flat=bronze)
    >>> inputs.hardness_surface_2
    1500000000.0
    """

    modulus_GPa: float
    poisson_ratio: float
    hardness_GPa: float

    def __post_init__(self):
        numbers = {name: getattr(self, name) for name in USUAL_MATERIAL}
        ratio = checked_number("poisson_ratio", self.poisson_ratio, positive=False)
        for name, number in (
            checked_numbers(numbers, USUAL_MATERIAL, stacklevel=5) | {"poisson_ratio": ratio}
        ).items():
            object.__setattr__(self, name, number)
        if self.poisson_ratio > 0.5:
            raise ValueError(f"poisson_ratio is {self.poisson_ratio}; allowed: 0 to 0.5")

    @property
    def compliance(self) -> float:
        """(1 - v^2)/E [Pa-1]."""
        return (1.0 - self.poisson_ratio**2) / (GIGA * self.modulus_GPa)

    @property
    def hardness(self) -> float:
        """Hardness [Pa]."""
        return GIGA * self.hardness_GPa


@dataclass(frozen=True, kw_only=True)
class Setup:
    """The materials of the bodies and the density of the oil; None if unknown.

    The inputs of the model do not contain them.  They do contain the radius, the speed and the
    pressure-viscosity coefficient, as ``ball_radius``, ``speed_per_viscosity`` and
    ``material_parameter``.

    Parameters
    ----------
    ball, flat, particle : Material, optional
        The materials from which the moduli and hardnesses of the inputs were derived.
    oil_density_kg_per_m3 : float, optional
        Density of the oil.  It turns ``speed_per_viscosity`` into a speed.

    Examples
    --------
    >>> import thirdbody as tb
    >>> inputs = tb.bearing(speed_m_per_s=2.0, oil_density_kg_per_m3=870.0)
    >>> inputs.setup.oil_density_kg_per_m3
    870.0
    """

    ball: Material | None = None
    flat: Material | None = None
    particle: Material | None = None
    oil_density_kg_per_m3: float | None = None

    def __post_init__(self):
        if self.oil_density_kg_per_m3 is not None:
            name = "oil_density_kg_per_m3"
            density = checked_number(name, self.oil_density_kg_per_m3, unit="kg m-3")
            object.__setattr__(self, "oil_density_kg_per_m3", density)
        for name in BODIES:
            if not isinstance(body := getattr(self, name), Material | None):
                raise ValueError(f"{name} is {format_value(body)}; allowed: {_names(Material)}")

    @classmethod
    def of(cls, content: Mapping[str, Any]) -> Self:
        """The setup from a dict that ``as_dict`` returned."""
        values = _known_keys("setup", content, cls)
        for name in BODIES:
            if isinstance(values.get(name), Mapping):
                values[name] = Material(**_known_keys(name, values[name], Material))
        return cls(**values)

    def as_dict(self) -> dict[str, Any]:
        """The known values by name, with a dict for each material."""
        return {name: value for name, value in asdict(self).items() if value is not None}

    def speed(self, parameters: Parameters) -> float:
        """The entrainment speed u = (u_1 + u_2)/2 [m/s] of the inputs ``parameters``.

        It follows from U/nu = rho u/(E_ss R_x), with the density rho of the oil.
        """
        if self.oil_density_kg_per_m3 is None:
            raise ValueError(
                "the density of the oil is unknown, and with it the speed of these inputs; "
                "allowed: inputs of load_parameters or bearing, and members=True for each member"
            )
        stiffness = parameters.elastic_modulus_surfaces * parameters.ball_radius
        return parameters.speed_per_viscosity * stiffness / self.oil_density_kg_per_m3

    def without_speed(
        self, arrays: Mapping[str, NDArray], parameters: Parameters
    ) -> dict[str, NDArray]:
        """The conditions at the speed of ``parameters``, with viscosities to the same effect.

        U in Eq. 8 contains only the product of viscosity and speed.
        """
        solved = dict(arrays)
        speed = solved.pop("speed", None)
        if speed is not None:
            solved["viscosity"] = solved["viscosity"] * (speed / self.speed(parameters))
        return solved


def _names(kind) -> str:
    return ", ".join(field.name for field in fields(kind))


def _known_keys(name, content, kind) -> dict[str, Any]:
    """A dict with fields of the dataclass ``kind``; ``ValueError`` for anything else."""
    if not isinstance(content, Mapping):
        raise ValueError(f"{name} is {format_value(content)}; allowed: {_names(kind)}")
    unknown = [key for key in content if key not in {field.name for field in fields(kind)}]
    if unknown:
        raise ValueError(f"{name} has {', '.join(map(str, unknown))}; allowed: {_names(kind)}")
    return dict(content)


# Table 1.  The paper does not print the modulus of steel; this modulus gives the E_ss = 112 GPa of
# the table.
STEEL = Material(205.0, 0.29, 5.0)
# The setup of the calibrated inputs.  ASSUME: the density of mineral oils; the paper prints none.
PAPER_SETUP = Setup(ball=STEEL, flat=STEEL, particle=STEEL, oil_density_kg_per_m3=OIL_DENSITY)


@dataclass(frozen=True, repr=False)
class Ensemble:
    """Sets of inputs, each fitted without some figures of the paper, and the setup they share.

    ``ensemble.ball_radius``, like every input, is the value of the best set.  An input that a user
    sets is known: all members have it, and the inputs that were calibrated with it follow.

    Parameters
    ----------
    members : tuple of Parameters
        One or more sets, the best first.
    setup : Setup
        Materials of the bodies and density of the oil.

    Examples
    --------
    >>> import thirdbody as tb
    >>> inputs = tb.load_parameters()
    >>> len(inputs.members), inputs.members[0] == inputs.best
    (61, True)
    >>> inputs.best.ball_radius == inputs.ball_radius
    True

    The best set answers; all sets give the range of the answer:

    >>> particles = dict(particle_diameter_nm=300, particle_density_per_m2=1e11)
    >>> interface = dict(load_N=10, viscosity_cSt=120, roughness_nm=300, **particles)
    >>> shares = tb.solve(**interface, members=True).to_dataset()["solid_load_fraction"]
    >>> low, high = shares.quantile((0.05, 0.95), "member").values
    >>> bool(low < tb.solve(**interface).solid_load_fraction < high)
    True
    """

    members: tuple[Parameters, ...]
    setup: Setup

    def __post_init__(self):
        object.__setattr__(self, "members", tuple(self.members))
        if not self.members:
            raise ValueError("members is empty; allowed: one or more Parameters, the best first")

    def __repr__(self) -> str:
        count = len(self.members)
        return f"Ensemble of {count}, with the setup {self.setup!r}; the best: {self.best!r}"

    @property
    def best(self) -> Parameters:
        """The set of inputs for single answers."""
        return self.members[0]

    def __getattr__(self, name: str) -> Any:
        """An input or another attribute of the best set."""
        if name.startswith("_") or "members" not in vars(self):
            raise AttributeError(name)
        return getattr(self.best, name)

    def __iter__(self) -> Iterator[Ensemble]:
        """Ensembles of one member, with the same setup."""
        return (replace(self, members=(member,)) for member in self.members)

    @property
    def speed(self) -> float:
        """The entrainment speed u [m/s] of the best set: from U/nu and the density of the oil."""
        return self.setup.speed(self.best)

    def changed(self, **inputs: Any) -> Ensemble:
        """The ensemble with other ``inputs``, SI or quantities, in all members.

        If no member then differs from the best, the ensemble is the best alone.

        Where members differ in an input, it was calibrated together with others.  These follow, in
        each member by their regression on what is given (Matheron's rule), in logarithms if they
        are always positive, and within their bounds.  The third of the members that is nearest to
        what is given stays, and at least twelve.  Inputs in which all members agree are only
        set, also those that were given before: give together what belongs together.

        Raises
        ------
        ValueError
            For an unknown input, a number out of bounds, an unknown word, a quantity of another
            dimension, and an A_n larger than the ball.

        Warns
        -----
        UserWarning
            For a modulus, hardness or radius without G, V or U/nu, which depend on it;
            ``thirdbody.bearing`` changes them together.  For another ``apparent_area`` or
            ``mean_ratio``, by more than 10 %, and another ``particle_plane`` or ``film_load`` that
            all members share, without the inputs that were calibrated for it.  For a number far
            from those of all members: the other inputs then follow only as far as the members
            reach.

        Examples
        --------
        >>> import thirdbody as tb
        >>> inputs = tb.load_parameters().changed(truncation=3.0)
        >>> {member.truncation for member in inputs.members}
        {3.0}
        """
        return self._with(inputs, stacklevel=3)

    def _with(self, inputs: Mapping[str, Any], stacklevel: int) -> Ensemble:
        """``changed``, with the ``stacklevel`` of warnings."""
        changes = checked_inputs(inputs)
        members = tuple(conditioned(self.members, changes))
        best, *others = members
        if changes:
            best.check_ball()
        for message in (*far_texts(self.members, changes), *_what_stays(changes, self.members)):
            warnings.warn(message, UserWarning, stacklevel=stacklevel)
        return replace(self, members=members if set(others) - {best} else (best,))

    def as_dict(self) -> dict[str, Any]:
        """The inputs of the best set and the ``setup``, as arguments of
        ``thirdbody.load_parameters``."""
        return {**self.best.as_dict(), "setup": self.setup.as_dict()}

    def known(self) -> dict[str, Any]:
        """The content of a file of inputs: those in which all members agree, and the ``setup``.

        Who reads the file takes all other inputs from the calibrated ensemble.
        """
        inputs = {
            name: value
            for name, value in self.best.as_dict().items()
            if all(getattr(member, name) == value for member in self.members)
        }
        return {**inputs, "setup": self.setup.as_dict()}


def differing(ensemble: Ensemble) -> dict[str, str]:
    """The attribute of results of all members: the inputs of each that differ from the best."""
    usual = ensemble.best.as_dict()
    others = [
        {name: value for name, value in member.as_dict().items() if value != usual[name]}
        for member in ensemble.members
    ]
    return {"ensemble": json.dumps(others)}


def as_ensemble(parameters: Parameters | Ensemble) -> Ensemble:
    """``parameters`` as an ensemble: of one member, with an unknown setup, for ``Parameters``."""
    if isinstance(parameters, Ensemble):
        return parameters
    return Ensemble((parameters,), Setup())


def checked_inputs(changes: Mapping[str, Any]) -> dict[str, Any]:
    """The inputs ``changes`` as floats in SI, or as words; ``ValueError`` for an unknown name."""
    for name in changes:
        if name not in Parameters.names():
            raise ValueError(f"{name} is no input; allowed: {', '.join(Parameters.names())}")
    return {
        name: value if name in WORDS else single_number(name, value, BOUNDS[name].unit)
        for name, value in changes.items()
    }


def _what_stays(changes: Mapping[str, Any], members: Sequence[Parameters]) -> Iterator[str]:
    """Yield a message for each input that changes while its dependent inputs do not.

    Dependent inputs follow where members differ in the input.
    """
    before = members[0]
    for name in BELONGS_TO.keys() & changes.keys() - {*differing_numbers(members)}:
        dependents, reason = BELONGS_TO[name]
        stay = ", ".join(other for other in dependents if other not in changes)
        value, old = changes[name], getattr(before, name)
        tolerance = ROUNDED if reason == CALIBRATED else 1e-9
        same = value == old or (
            not isinstance(value, str) and math.isclose(value, old, rel_tol=tolerance)
        )
        if stay and not same:
            yield f"{name} is changed without {stay}; {reason}"


def range_over_members(values: Sequence[ArrayLike]) -> NDArray:
    """The ends ``ENDS`` of the range of ``values``, an array for each member: shape (2, ...).

    A member counts only where its value is finite.  Both ends are nan where no member counts.
    """
    members = np.asarray(values, float)
    members = np.where(np.isfinite(members), members, np.nan)
    ends = np.quantile(members, ENDS, axis=0)
    partly = np.isnan(members).any(axis=0)  # only here: nanquantile is slow, a loop over points
    if partly.any():
        with warnings.catch_warnings():
            warnings.filterwarnings("ignore", "All-NaN", RuntimeWarning)
            ends[:, partly] = np.nanquantile(members[:, partly], ENDS, axis=0)
    return ends
