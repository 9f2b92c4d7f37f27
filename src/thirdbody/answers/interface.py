"""``Interface``: two rough surfaces with particles and oil under a load, in engineering units."""

from __future__ import annotations

from collections import Counter
from collections.abc import Collection, Mapping, Sequence
from dataclasses import dataclass, field, replace
from functools import cached_property
from typing import Any

import numpy as np
from numpy.typing import NDArray

from thirdbody.answers.answer import Answer, Curve, Row, Value, few_particles
from thirdbody.answers.changes import BORDERS, Transition, transitions
from thirdbody.answers.ensemble import calibrated_ensemble, ensemble_notes
from thirdbody.answers.turning import RATIOS, turning_point, turning_window
from thirdbody.conditions.checks import check_count, check_ends, check_names, checked_parameters
from thirdbody.conditions.in_si import in_si
from thirdbody.conditions.usual import without_warnings
from thirdbody.curves.turning_point import PROMINENCE
from thirdbody.data.paper_tables import LOADS
from thirdbody.data.quantities import FLAGS, QUANTITIES, STATUS_MEANINGS
from thirdbody.data.sizes import sizes_note
from thirdbody.messages import format_value
from thirdbody.model.parameters import Parameters
from thirdbody.model.regimes import SOLUTION_STATUSES
from thirdbody.solver.solution import Solution
from thirdbody.solver.solve import solve
from thirdbody.units import ENGINEERING, SEARCHED, UNITS, decimal, has_unit

LENGTH = UNITS["roughness_nm"]  # unit of the separation in answers
FLAGS_WITH_BORDERS = ("lubrication_regime", "contact_mode")
MEANINGLESS = ("outside_film_formula", "area_exceeded")  # changes with these statuses are left out


@dataclass(frozen=True)
class Interface:
    """An interface, with a method for each question.

    The normal load F_t [N] and the equivalent root mean square roughness sigma [nm] are positive.
    The kinematic viscosity [cSt] is 0 without oil; the mean diameter x_a [nm] and the number eta_a
    [m-2] are 0 without particles.  Each is a number or a quantity.  ``parameters`` describe
    materials, ball and film: by default the calibrated ones; ``thirdbody.bearing`` derives others.

    Raises ``ValueError`` for a condition that is not a finite number or out of range, and for inputs that
    are not ``Parameters``; issues one ``OutOfRangeWarning`` for conditions outside their usual range.

    Examples
    --------
    >>> import thirdbody as tb
    >>> layer = dict(particle_diameter_nm=500, particle_density_per_m2=1e11, roughness_nm=300)
    >>> interface = tb.Interface(load_N=10, viscosity_cSt=90, **layer)
    >>> interface.changed(viscosity_cSt=0).state().value("lubrication_regime")
    'boundary'
    """

    load_N: float
    viscosity_cSt: float
    particle_diameter_nm: float
    roughness_nm: float
    particle_density_per_m2: float
    parameters: Parameters | None = field(default=None, repr=False)

    def __post_init__(self):
        object.__setattr__(self, "parameters", checked_parameters(self.parameters))
        given = in_si(self.conditions, self.parameters)
        for name, key in ENGINEERING.items():
            if given[name].ndim:
                raise ValueError(f"{key} has shape {given[name].shape}; allowed: one number")
            if has_unit(getattr(self, key)):
                number = UNITS[key].from_si(given[name], self.parameters.newtons_per_load)
                object.__setattr__(self, key, float(decimal(number)))

    @property
    def conditions(self) -> dict[str, float]:
        """The five conditions by their names in engineering units."""
        return {key: getattr(self, key) for key in ENGINEERING.values()}

    @cached_property
    def members(self) -> tuple[Parameters, ...]:
        """The sets of inputs of the ensemble (see ``calibrated_ensemble``)."""
        return calibrated_ensemble(self.parameters)

    @property
    def _inputs(self) -> tuple[Parameters, ...]:
        return self.parameters, *self.members

    def changed(self, **conditions: float | Parameters) -> Interface:
        """The same interface with other conditions, or other ``parameters``."""
        return replace(self, **conditions)

    def described(self, without: str = "") -> str:
        """The conditions in words, except the one named ``without``."""
        return ", ".join(
            f"{_words(name)} {getattr(self, key):g} {UNITS[key].text}"
            for name, key in ENGINEERING.items()
            if name != without
        )

    def state(self) -> Answer:
        """Question 1: load sharing, contact area, regime and mode.

        The answer has a row for each variable of ``Solution``; ``found`` is false if the force
        balance has no root.
        """
        mine, *of_members = self._states()
        rows = tuple(
            _row(name, value, [each[name] for each in of_members]) for name, value in mine.items()
        )
        found = mine["separation"] is not None
        return Answer(f"State at {self.described()}", rows, self._notes(mine), found)

    def compare(self, other: Interface) -> Answer:
        """Question 10: compare this interface with an ``other``, which may have other inputs.

        The answer has a row for each variable: ``value`` here, ``other`` there, and the ensemble
        range of the second minus the first; ``found`` is false if a force balance has no root.
        """
        if not isinstance(other, Interface):
            raise ValueError(f"other is {format_value(other)}; allowed: an Interface")
        mine, *of_members = self._states()
        theirs, *of_their_members = other._states()
        rows = []
        for name, value in mine.items():
            pairs = [(a[name], b[name]) for a, b in zip(of_members, of_their_members)]
            if name in FLAGS:
                changes = [value if pair == (value, theirs[name]) else "" for pair in pairs]
            else:
                changes = [b - a if None not in (a, b) else None for a, b in pairs]
            rows.append(replace(_row(name, value, changes), other=theirs[name]))
        notes = (
            f"first:  {self.described()}",
            f"second: {other.described()}",
            *self._notes(mine),
            *other._notes(theirs),
        )
        found = None not in (mine["separation"], theirs["separation"])
        return Answer("Two interfaces", tuple(rows), notes, found)

    def _notes(self, state: Mapping[str, Value]) -> tuple[str, ...]:
        """Remarks on a state."""
        name = state["solution_status"].replace(" ", "_")
        status = [] if name == SOLUTION_STATUSES[0] else [f"{name}: {STATUS_MEANINGS[name]}"]
        sizes = self._size_notes(self.particle_diameter_nm)
        few = few_particles(self.particle_density_per_m2, self.parameters.apparent_area)
        return *status, *sizes, *few, *ensemble_notes(self.members)

    def _size_notes(self, *diameters_nm: float) -> tuple[str, ...]:
        """The sizes that each x_a [nm] stands for, if there are particles."""
        if not self.particle_density_per_m2 > 0.0:
            return ()
        roughness = float(LENGTH.to_si(self.roughness_nm))
        sizes = [float(LENGTH.to_si(each)) for each in diameters_nm if each > 0.0]
        return tuple(sizes_note(each, roughness, self.parameters) for each in sizes)

    def _states(self) -> list[dict[str, Value]]:
        """The variables in engineering units and words, for the inputs and for each member."""
        return [_state(_solved(self.conditions, each)) for each in self._inputs]

    def transitions(
        self,
        along: str = "load",
        flags: Collection[str] = FLAGS_WITH_BORDERS,
        between: tuple[float, float] | None = None,
    ) -> Answer:
        """Questions 2 to 6: the values of one condition at which regime or mode changes.

        ``along`` is ``load``, ``viscosity``, ``particle_diameter``, ``roughness`` or
        ``particle_density``; the value of the interface for it is ignored.  ``flags`` are
        ``lubrication_regime``, ``contact_mode`` or both.  ``between`` are the ends of the search in
        the unit of the interface, by default those of ``thirdbody.find``.

        The answer has a row for each change, with increasing values, and one for each limit that is
        not crossed; ``found`` is whether there is a change.  Changes where the equations are not
        valid are left out.
        """
        key = _key_of(along)
        check_names("flags", flags, FLAGS_WITH_BORDERS)
        between = SEARCHED[along] if between is None else between
        others = {name: value for name, value in self.conditions.items() if name != key}
        with without_warnings():
            every = [
                transitions(key, parameters=each, between=between, **others)
                for each in self._inputs
            ]
        mine, *of_members = (_meaningful(each, flags) for each in every)
        unit = UNITS[key].text
        rows = []
        for (before, after, index), value in mine.items():
            same = [each.get((before, after, index)) for each in of_members]
            change = f"{_words(before)} to {_words(after)}"
            rows.append(Row.of(f"{before}_to_{after}", change, value, unit, same))
        for border in BORDERS:
            passages = (border.above, border.below, 0), (border.below, border.above, 0)
            if border.flag in flags and not any(each in mine for each in passages):
                first = [
                    min(filter(None, map(each.get, passages)), default=None) for each in of_members
                ]
                change = f"between {_words(border.below)} and {_words(border.above)}"
                rows.append(Row.of(f"{border.below}_and_{border.above}", change, None, unit, first))
        notes = (
            f"searched: {_words(along)} {between[0]:g} to {between[1]:g} {unit}",
            *(f"at {end:g} {unit}: {self._state_at(key, end)}" for end in between),
            *(
                f"left out at {each.value:.4g} {unit}, {each.solution_status}: "
                f"{STATUS_MEANINGS[each.solution_status]}"
                for each in every[0]
                if each.border.flag in flags and each.solution_status in MEANINGLESS
            ),
            *self._size_notes(*(mine.values() if along == "particle_diameter" else [])),
            *ensemble_notes(self.members),
        )
        title = f"Changes along the {_words(along)} at {self.described(without=along)}"
        return Answer(title, tuple(rows), notes, bool(mine))

    def _state_at(self, key, value) -> str:
        """Regime, mode and status at one end of a search."""
        state = _state(_solved(self.conditions | {key: value}, self.parameters))
        words = [state[name] for name in (*FLAGS_WITH_BORDERS, "solution_status")]
        return ", ".join(each for each in words if each not in (None, SOLUTION_STATUSES[0]))

    def turning_point(self, between_N: tuple[float, float] = LOADS) -> Answer:
        """Question 7: the load at which the particle fraction of the contact area turns, and the sizes.

        The curve covers the loads ``between_N`` [N], by default those of the paper.  The answer has
        the load, the area ratio and L_s at the turning point, then the least and largest diameter
        for which dry contact has one; ``found`` is whether this interface has one.
        """
        with without_warnings():
            mine, *of_members = (self._turning_with(each, between_N) for each in self._inputs)
        size = UNITS["particle_diameter_nm"].text
        quantities = {
            "load_N": ("load at the turning point, F_t", "N"),
            "load": ("the same over A_n E_ss, F_TPCA*", "1"),
            "peak_ratio": ("A_sa,t* there", "1"),
            "solid_load_fraction": ("L_s there", "1"),
            "low": ("least diameter with a turning point (dry)", size),
            "high": ("largest diameter with a turning point (dry)", size),
        }
        rows = tuple(
            Row.of(name, what, mine[name], unit, [each[name] for each in of_members])
            for name, (what, unit) in quantities.items()
        )
        notes = (
            f"the curve runs from {between_N[0]:g} to {between_N[1]:g} N; the maximum of A_sa,t* "
            f"stands out by {PROMINENCE:g} on both sides",
            f"diameters are searched from {RATIOS[0]:g} to {RATIOS[-1]:g} times the roughness",
            *self._size_notes(self.particle_diameter_nm),
            *ensemble_notes(self.members),
        )
        title = f"Turning point at {self.described(without='load')}"
        return Answer(title, rows, notes, mine["load"] is not None)

    def _turning_with(self, parameters, between_N) -> dict[str, Value]:
        """The rows of ``turning_point`` for one set of inputs."""
        given = {key: value for key, value in self.conditions.items() if key != "load_N"}
        found = turning_point(parameters=parameters, between_N=between_N, **given)
        names = "load", "peak_ratio", "solid_load_fraction"
        state = {name: float(getattr(found, name)) if found.exists else None for name in names}
        load = state["load"] and state["load"] * parameters.newtons_per_load
        layer = {name: given[name] for name in ("roughness_nm", "particle_density_per_m2")}
        window = turning_window(parameters=parameters, between_N=between_N, **layer)
        low, high = (
            None if np.isnan(end) else float(end) * self.roughness_nm
            for end in (window.low, window.high)
        )
        return {"load_N": load, **state, "low": low, "high": high}

    def curve(self, along: str, low: float, high: float, count: int = 60) -> Curve:
        """Question 9: all variables along one condition, with their ensemble ranges.

        ``along`` is as in ``transitions``.  The ``count`` points, 2 to a million, are
        logarithmically spaced from ``low`` to ``high``, positive, in the unit of the interface.

        Examples
        --------
        >>> import thirdbody as tb
        >>> curve = tb.Interface(10, 90, 500, 300, 1e11).curve("viscosity", 90, 150, count=3)
        >>> curve.points.round(1)
        array([ 90. , 116.2, 150. ])
        >>> bool((np.diff(curve.values["solid_load_fraction"]) < 0.0).all())
        True
        """
        key = _key_of(along)
        check_ends("low to high", (low, high))
        check_count("count", count)
        points = np.geomspace(low, high, count)
        mine, *of_members = (
            _solved(self.conditions | {key: points}, each) for each in self._inputs
        )
        return Curve.of(key, points, mine, of_members)


def _solved(conditions: Mapping[str, Any], parameters: Parameters) -> Solution:
    with without_warnings():
        return solve(**conditions, parameters=parameters)


def _state(solution: Solution) -> dict[str, Value]:
    """The variables of one point in engineering units and words."""
    return {name: _value(name, getattr(solution, name)) for name in (*QUANTITIES, *FLAGS)}


def _value(name: str, value: NDArray) -> Value:
    if name in FLAGS:
        return _words(FLAGS[name].meanings[int(value)]) if value >= 0 else None
    if np.isnan(value):
        return None
    return float(LENGTH.from_si(value) if name == "separation" else value)


def _row(name: str, value: Value, of_members: Sequence[Value]) -> Row:
    """The row of a variable."""
    if name in FLAGS:
        return Row.of(name, FLAGS[name].long_name, value, "", of_members)
    quantity = QUANTITIES[name]
    unit = LENGTH.text if name == "separation" else quantity.units
    return Row.of(name, f"{quantity.long_name}, {quantity.symbol}", value, unit, of_members)


def _meaningful(changes: list[Transition], flags: Collection[str]) -> dict[tuple, float]:
    """Changes of ``flags`` where the equations are valid: their values, by the states before and
    after and a counter of the pair."""
    times, found = Counter(), {}
    for change in changes:
        if change.border.flag in flags and change.solution_status not in MEANINGLESS:
            passed = change.before, change.after
            found[*passed, times[passed]] = change.value
            times[passed] += 1
    return found


def _key_of(along: str) -> str:
    """The name of an axis in engineering units."""
    if not isinstance(along, str) or along not in ENGINEERING:
        raise ValueError(f"along is {format_value(along)}; allowed: {', '.join(ENGINEERING)}")
    return ENGINEERING[along]


def _words(name: str) -> str:
    return name.replace("_", " ")
