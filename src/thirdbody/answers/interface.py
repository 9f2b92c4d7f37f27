"""``Interface``: two rough surfaces, particles and an oil under a load, in engineering units."""

from __future__ import annotations

from collections import Counter
from collections.abc import Collection
from dataclasses import dataclass, field, replace
from functools import cached_property

import numpy as np
from numpy.typing import NDArray

from thirdbody.answers.answer import Answer, Row, Value
from thirdbody.answers.arguments import check_count, check_ends, check_number
from thirdbody.answers.changes import BORDERS, Transition, transitions
from thirdbody.answers.curve import Curve
from thirdbody.answers.ensemble import calibrated_ensemble
from thirdbody.answers.turning import RATIOS, turning_point, turning_window
from thirdbody.answers.units import ENGINEERING, SEARCHED, in_si, unit_text
from thirdbody.conditions.checks import NEVER_ZERO, check_names, check_parameters
from thirdbody.configuration.inputs import load_parameters
from thirdbody.curves.turning_point import PROMINENCE
from thirdbody.data.conditions import AXES
from thirdbody.data.paper_tables import LOADS
from thirdbody.data.quantities import FLAGS, QUANTITIES, STATUS_MEANINGS
from thirdbody.messages import shown
from thirdbody.model.parameters import Parameters
from thirdbody.model.regimes import SOLUTION_STATUSES
from thirdbody.solver.solve import solve

SHOWN_IN = {"separation": AXES["roughness"]}  # variables that are told in the unit of an axis
BORDERED = ("lubrication_regime", "contact_mode")
MEANINGLESS = ("outside_film_formula", "area_exceeded")  # statuses of changes that are left out
ARROW = "\N{RIGHTWARDS ARROW}"


@dataclass(frozen=True)
class Interface:
    """An interface, and the questions that it answers.

    Attributes
    ----------
    load_N : float
        Normal load F_t [N], positive.
    viscosity_cSt : float
        Kinematic viscosity of the oil [cSt]; 0 where it is dry.
    particle_diameter_nm : float
        Mean diameter x_a of the particles [nm]; 0 where there are none.
    roughness_nm : float
        Equivalent root mean square roughness sigma [nm], positive.
    particle_density_per_m2 : float
        Particles per area eta_a [m-2]; 0 where there are none.
    parameters : Parameters
        Materials, ball, film: by default the calibrated ones; ``thirdbody.answers.bearing`` derives
        others.

    Raises
    ------
    ValueError
        For a condition that is not a finite number, or not in its range, and inputs that are no
        ``Parameters``.

    Examples
    --------
    >>> import thirdbody as tb
    >>> interface = tb.Interface(
    ...     load_N=10,
    ...     viscosity_cSt=90,
    ...     particle_diameter_nm=500,
    ...     roughness_nm=300,
    ...     particle_density_per_m2=1e11,
    ... )
    >>> interface.changed(viscosity_cSt=0).state().value("lubrication_regime")
    'boundary'
    """

    load_N: float
    viscosity_cSt: float
    particle_diameter_nm: float
    roughness_nm: float
    particle_density_per_m2: float
    parameters: Parameters = field(default_factory=load_parameters, repr=False)

    def __post_init__(self):
        check_parameters(self.parameters)
        for name, key in ENGINEERING.items():
            check_number(key, getattr(self, key), name in NEVER_ZERO)

    @property
    def conditions(self) -> dict[str, float]:
        """The five conditions by their names in engineering units."""
        return {key: getattr(self, key) for key in ENGINEERING.values()}

    @cached_property
    def members(self) -> tuple[Parameters, ...]:
        """The sets of inputs of the ensemble (see ``calibrated_ensemble``)."""
        return calibrated_ensemble(self.parameters)

    def changed(self, **conditions: float | Parameters) -> Interface:
        """The same interface with other conditions, or other ``parameters``."""
        return replace(self, **conditions)

    def described(self, but: str = "") -> str:
        """The conditions in words, all ``but`` the axis of one name."""
        words = {
            name: f"{getattr(self, key):g} {unit_text(name)}"
            for name, key in ENGINEERING.items()
            if name != but
        }
        return ", ".join(f"{_word(name)} {value}" for name, value in words.items())

    def state(self) -> Answer:
        """Question 1: how load and contact area divide, in which regime and mode.

        Returns
        -------
        Answer
            A row for each variable of ``Solution``; ``found`` unless nothing balances the load.
        """
        mine, *of_members = self._states()
        rows = tuple(
            Row.of(name, words(name), value, unit_of(name), [each[name] for each in of_members])
            for name, value in mine.items()
        )
        found = mine["separation"] is not None
        return Answer(f"State at {self.described()}", rows, self._warnings(mine), found)

    def compare(self, other: Interface) -> Answer:
        """Question 10: two interfaces beside each other.

        Parameters
        ----------
        other : Interface
            The second one; its inputs may be others.

        Returns
        -------
        Answer
            A row for each variable: ``value`` here, ``other`` there, and the range over the ensemble
            of the second less the first; ``found`` unless nothing balances a load.
        """
        if not isinstance(other, Interface):
            raise ValueError(f"other is {shown(other)}; allowed: an Interface")
        mine, *of_members = self._states()
        theirs, *of_their_members = other._states()
        rows = []
        for name, value in mine.items():
            pairs = [(a[name], b[name]) for a, b in zip(of_members, of_their_members)]
            if name in FLAGS:
                changes = [value if pair == (value, theirs[name]) else "" for pair in pairs]
            else:
                changes = [b - a if None not in (a, b) else None for a, b in pairs]
            row = Row.of(name, words(name), value, unit_of(name), changes)
            rows.append(replace(row, other=theirs[name]))
        notes = (
            f"first:  {self.described()}",
            f"second: {other.described()}",
            *self._warnings(mine),
            *other._warnings(theirs),
        )
        found = None not in (mine["separation"], theirs["separation"])
        return Answer("Two interfaces", tuple(rows), notes, found)

    def _states(self) -> list[dict[str, Value]]:
        """The variables in engineering units and words: with the inputs, and with each member."""
        states = []
        for parameters in (self.parameters, *self.members):
            solution = solve(**in_si(self.conditions, parameters), parameters=parameters)
            found = {name: getattr(solution, name) for name in (*QUANTITIES, *FLAGS)}
            states.append({name: plain(name, value) for name, value in found.items()})
        return states

    def _warnings(self, state) -> tuple[str, ...]:
        status = state["solution_status"].replace(" ", "_")
        return () if status == SOLUTION_STATUSES[0] else (f"{status}: {STATUS_MEANINGS[status]}",)

    def transitions(
        self,
        along: str = "load",
        flags: Collection[str] = BORDERED,
        between: tuple[float, float] | None = None,
    ) -> Answer:
        """Questions 2 to 6: at which value of one condition regime or mode change.

        Parameters
        ----------
        along : str
            ``load``, ``viscosity``, ``particle_diameter``, ``roughness`` or ``particle_density``;
            the interface's own value of it counts for nothing.
        flags : collection of str
            ``lubrication_regime``, ``contact_mode`` or both.
        between : pair of float, optional
            Ends of the search, in the unit of the interface; by default those of ``thirdbody.find``.

        Returns
        -------
        Answer
            A row for each change, with increasing values, and one for each border that is not
            passed; ``found`` if there is a change.  Changes where the equations have no meaning
            are left out.
        """
        key = _key_of(along)
        check_names("flags", flags, BORDERED)
        between = SEARCHED[along] if between is None else between
        others = {name: value for name, value in self.conditions.items() if name != key}
        found, *of_members = (
            transitions(key, parameters=each, between=between, **others)
            for each in (self.parameters, *self.members)
        )
        mine, *of_members = (_meaningful(each, flags) for each in (found, *of_members))
        unit = unit_text(along)
        rows = []
        for (before, after, index), value in mine.items():
            same = [each.get((before, after, index)) for each in of_members]
            name = f"{before}_to_{after}"
            rows.append(Row.of(name, f"{_word(before)} {ARROW} {_word(after)}", value, unit, same))
        for border in BORDERS:
            ways = (border.above, border.below, 0), (border.below, border.above, 0)
            if border.flag in flags and not any(way in mine for way in ways):
                first = [
                    min(filter(None, map(each.get, ways)), default=None) for each in of_members
                ]
                name = f"{border.below}_and_{border.above}"
                told = f"between {_word(border.below)} and {_word(border.above)}"
                rows.append(Row.of(name, told, None, unit, first))
        left_out = [each for each in found if each.solution_status in MEANINGLESS]
        notes = (
            f"searched: {_word(along)} {between[0]:g} to {between[1]:g} {unit}",
            *(self._end(along, end) for end in between),
            *(
                f"left out at {each.value:.4g} {unit}, {each.solution_status}: "
                f"{STATUS_MEANINGS[each.solution_status]}"
                for each in left_out
                if each.border.flag in flags
            ),
        )
        title = f"Changes along the {_word(along)} at {self.described(but=along)}"
        return Answer(title, tuple(rows), notes, bool(mine))

    def _end(self, along, value) -> str:
        """In which state an end of a search is."""
        there = self.changed(**{ENGINEERING[along]: value})
        solution = solve(**in_si(there.conditions, self.parameters), parameters=self.parameters)
        told = [plain(name, getattr(solution, name)) for name in (*BORDERED, "solution_status")]
        known = (each for each in told if each not in (None, SOLUTION_STATUSES[0]))
        return f"at {value:g} {unit_text(along)}: {', '.join(known)}"

    def turning_point(self, between_N: tuple[float, float] = LOADS) -> Answer:
        """Question 7: where the particles' share of the contact area turns, and for which sizes.

        Parameters
        ----------
        between_N : pair of float
            First and last load of the curve [N], by default those of the paper.

        Returns
        -------
        Answer
            Load, share of the area and of the load at the turning point, then the least and the
            largest diameter for which dry contact has one; ``found`` if this interface has one.
        """
        mine, *of_members = (
            self._turning_with(each, between_N) for each in (self.parameters, *self.members)
        )
        size = AXES["particle_diameter"].unit
        told = {
            "load_N": ("load at the turning point, F_t", "N"),
            "load": ("the same over A_n E_ss, F_TPCA*", "1"),
            "peak_ratio": ("A_sa,t* there", "1"),
            "solid_load_fraction": ("L_s there", "1"),
            "low": ("least diameter with a turning point (dry)", size),
            "high": ("largest diameter with a turning point (dry)", size),
        }
        rows = tuple(
            Row.of(name, what, mine[name], unit, [each[name] for each in of_members])
            for name, (what, unit) in told.items()
        )
        notes = (
            f"the curve runs from {between_N[0]:g} to {between_N[1]:g} N; the maximum of A_sa,t* "
            f"stands out by {PROMINENCE:g} on both sides",
            f"diameters are searched from {RATIOS[0]:g} to {RATIOS[-1]:g} times the roughness",
        )
        title = f"Turning point at {self.described(but='load')}"
        return Answer(title, rows, notes, mine["load"] is not None)

    def _turning_with(self, parameters, between_N) -> dict[str, Value]:
        """The rows of ``turning_point`` with some inputs."""
        given = in_si(self.conditions, parameters)
        given.pop("load")
        found = turning_point(parameters=parameters, between_N=between_N, **given)
        names = "load", "peak_ratio", "solid_load_fraction"
        state = {name: float(getattr(found, name)) if found.exists else None for name in names}
        load = state["load"] and state["load"] * parameters.newtons_per_load
        layer = {name: given[name] for name in ("roughness", "particle_density")}
        window = turning_window(parameters=parameters, between_N=between_N, **layer)
        ends = {
            name: _known(float(getattr(window, name)) * self.roughness_nm)
            for name in ("low", "high")
        }
        return {"load_N": load, **state, **ends}

    def curve(self, along: str, low: float, high: float, count: int = 60) -> Curve:
        """Question 9: all variables along one axis.

        Parameters
        ----------
        along : str
            ``load``, ``viscosity``, ``particle_diameter``, ``roughness`` or ``particle_density``.
        low, high : float
            Ends of the axis, positive, in the unit of the interface.
        count : int
            Number of points, evenly spaced in their logarithm; from 2 to a million.

        Returns
        -------
        Curve
            With the range over the ensemble.

        Raises
        ------
        ValueError
            For an unknown axis, ends that are not positive and increasing, or a ``count`` that is
            not whole or out of its range.

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
        given = self.conditions | {key: points}
        mine, *of_members = (
            solve(**in_si(given, each), parameters=each)
            for each in (self.parameters, *self.members)
        )
        return Curve.of(key, points, mine, of_members)


def _meaningful(changes: list[Transition], flags: Collection[str]) -> dict[tuple, float]:
    """Changes of ``flags`` where the equations mean something: their values, by what passes into what
    for which time."""
    times, found = Counter(), {}
    for change in changes:
        if change.border.flag in flags and change.solution_status not in MEANINGLESS:
            passed = change.before, change.after
            found[*passed, times[passed]] = change.value
            times[passed] += 1
    return found


def _key_of(along: str) -> str:
    """The name in engineering units of an axis."""
    if not isinstance(along, str) or along not in ENGINEERING:
        raise ValueError(f"along is {shown(along)}; allowed: {', '.join(ENGINEERING)}")
    return ENGINEERING[along]


def _known(value: float) -> float | None:
    return None if np.isnan(value) else value


def _word(name: str) -> str:
    return name.replace("_", " ")


def words(name: str) -> str:
    """What a variable is, with its symbol where it is a number."""
    if name in FLAGS:
        return FLAGS[name].long_name
    return f"{QUANTITIES[name].long_name}, {QUANTITIES[name].symbol}"


def unit_of(name: str) -> str:
    """The unit in which a variable is told; none of a name."""
    if name in FLAGS:
        return ""
    return SHOWN_IN[name].unit if name in SHOWN_IN else QUANTITIES[name].units


def plain(name: str, value: NDArray) -> Value:
    """A variable [SI] of one point as it is told; None where there is no solution."""
    if name in FLAGS:
        return _word(FLAGS[name].meanings[int(value)]) if value >= 0 else None
    if np.isnan(value):
        return None
    return SHOWN_IN[name].from_si(float(value)) if name in SHOWN_IN else float(value)
