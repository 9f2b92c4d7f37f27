"""``Interface``: two rough surfaces with particles and oil under a load, in engineering units."""

from collections.abc import Collection, Mapping, Sequence
from dataclasses import dataclass, field, replace
from typing import Any, Self

import numpy as np

from thirdbody.answers.answer import Answer, Curve, Row, Value, few_particles, range_note
from thirdbody.answers.sizes import sizes_note
from thirdbody.conditions import (
    axis_of,
    check_count,
    checked_variables,
    ends_in_si,
    from_si,
    read_conditions,
    without_warnings,
)
from thirdbody.core.parameters import Parameters
from thirdbody.core.regimes import FULL_FILM_LIMIT, SOLUTION_STATUSES, codes_to_name
from thirdbody.core.turning_points import PROMINENCE
from thirdbody.inputs import or_calibrated
from thirdbody.points import Solution, solve
from thirdbody.printed import LOADS
from thirdbody.ranges import ranges
from thirdbody.searches import (
    BORDERS,
    IN_FULL_FILM,
    RATIOS,
    SWEEP,
    Border,
    Transition,
    all_changes,
    queries,
    sample,
    turning_point,
    turning_window,
)
from thirdbody.variables import AXES, BY_ALIAS, FLAGS, QUANTITIES, STATUS_MEANINGS, decimal

FLAGS_WITH_BORDERS = ("lubrication_regime", "contact_mode")
# changes with these statuses are left out, and why; ``full_film`` are changes of the contact mode there
LEFT_OUT = {name: STATUS_MEANINGS[name] for name in ("outside_film_formula", "area_exceeded")}
LEFT_OUT[IN_FULL_FILM] = (
    f"the solids carry less than {FULL_FILM_LIMIT:g} of the load, and no contact mode is given"
)
FULL_FILM_BORDER = BORDERS[1]
State = Mapping[str, Value]  # variables, or other quantities of an answer
# by name, the words and the unit of the rows
STATE = {
    name: (f"{quantity.label}, {quantity.symbol}", quantity.unit)
    for name, quantity in QUANTITIES.items()
} | {name: (flag.label, "") for name, flag in FLAGS.items()}
STATE["separation"] = "mean separation, of a film its thickness, d", "nm"
TURNING = {
    "load_N": ("load at the turning point, F_t", "N"),
    "load": ("the same over A_n E_ss, F_TPCA*", "1"),
    "peak_ratio": ("A_sa,t* there", "1"),
    "solid_load_fraction": ("L_s there", "1"),
    "low": ("least diameter with a turning point (dry)", "nm"),
    "high": ("largest diameter with a turning point (dry)", "nm"),
}


@dataclass(frozen=True, init=False)
class Interface:
    """An interface, with a method for each question.

    The normal load F_t [N] and the equivalent root mean square roughness sigma [nm] are positive.
    The kinematic viscosity [cSt] is 0 without oil; the mean diameter x_a [nm] and the number eta_a
    [m-2] are 0 without particles.  Each is given by any of its names in ``thirdbody.solve``, as a
    number or a quantity.  ``parameters`` describe materials, ball and film: by default the
    calibrated ones; ``thirdbody.bearing`` derives others.

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
    parameters: Parameters = field(repr=False)

    def __init__(self, *, parameters: Parameters | None = None, **conditions: float):
        parameters = or_calibrated(parameters)
        object.__setattr__(self, "parameters", parameters)
        read = read_conditions(conditions, parameters)
        for name, value in read.arrays.items():
            if value.shape:
                raise ValueError(f"{read.keys[name]} has shape {value.shape}; allowed: one number")
            key = AXES[name].alias
            number = conditions.get(key)
            if not isinstance(number, int | float):
                number = float(decimal(from_si(key, value, parameters.newtons_per_load)))
            object.__setattr__(self, key, number)

    @property
    def conditions(self) -> dict[str, float]:
        """The five conditions by their names in engineering units."""
        return {key: getattr(self, key) for key in BY_ALIAS}

    @property
    def members(self) -> tuple[Parameters, ...]:
        """The sets of inputs of the ensemble."""
        return self.parameters.members

    def changed(self, **conditions: float | Parameters) -> Self:
        """The same interface with other conditions, or other ``parameters``."""
        others = {axis_of(key).name for key in conditions if key != "parameters"}
        kept = {
            key: getattr(self, key) for key, axis in BY_ALIAS.items() if axis.name not in others
        }
        return Interface(**{"parameters": self.parameters} | kept | conditions)

    def described(self, without: str = "") -> str:
        """The conditions in words, except the one named ``without``."""
        return ", ".join(
            f"{_words(axis.name)} {getattr(self, key):g} {axis.alias_unit}"
            for key, axis in BY_ALIAS.items()
            if axis.name != without
        )

    def state(self) -> Answer:
        """Question 1: load sharing, contact area, regime and mode.

        The answer has a row for each variable of ``Solution``; ``found`` is false if the force
        balance has no root.
        """
        mine, *of_members = self._states()
        found = mine["separation"] is not None
        rows = _rows(STATE, mine, of_members)
        return Answer(f"State at {self.described()}", rows, self._notes(mine), found)

    def compare(self, other: "Interface") -> Answer:
        """Question 10: compare this interface with an ``other``, which may have other inputs.

        The answer has a row for each variable: ``value`` here, ``other`` there, and the ensemble
        range of the second minus the first; ``found`` is false if a force balance has no root.
        """
        mine, *of_members = self._states()
        theirs, *of_their_members = other._states()
        changes = [
            {name: _change(name, (a[name], b[name]), (mine[name], theirs[name])) for name in mine}
            for a, b in zip(of_members, of_their_members)
        ]
        rows = [replace(row, other=theirs[row.name]) for row in _rows(STATE, mine, changes)]
        described = f"first:  {self.described()}", f"second: {other.described()}"
        notes = *described, *dict.fromkeys((*self._notes(mine), *other._notes(theirs)))
        found = None not in (mine["separation"], theirs["separation"])
        return Answer("Two interfaces", tuple(rows), notes, found)

    def transitions(
        self,
        along: str = "load",
        flags: str | Collection[str] = FLAGS_WITH_BORDERS,
        between: tuple[float, float] | None = None,
    ) -> Answer:
        """Questions 2 to 6: the values of one condition at which regime or mode changes.

        ``along`` is an axis by any of its names; the value of the interface for it is ignored.
        ``flags`` are ``lubrication_regime``, ``contact_mode`` or both.  ``between`` are the ends of
        the search in the unit of the interface, by default those of ``thirdbody.find``.

        The answer has a row for each change, with increasing values, and one for each limit that is
        not crossed; ``found`` is whether there is a change.  Changes where the equations are not
        valid are left out, and those of the contact mode in a full film, where hardly anything touches;
        then the ends of the full film are also given.
        """
        axis = axis_of(along)
        along, key = axis.name, axis.alias
        flags = checked_variables(flags, FLAGS_WITH_BORDERS)
        between = axis.searched if between is None else self._ends("between", between, key)
        given = {name: value for name, value in self.conditions.items() if name != key}
        with without_warnings():
            every = [
                self._changes(key, given, between, each)
                for each in (self.parameters, *self.members)
            ]
        left_out = [
            each
            for each in every[0]
            if each.border.flag in flags and each.solution_status in LEFT_OUT
        ]
        shown = [border for border in BORDERS if border.flag in flags]
        if any(each.solution_status == IN_FULL_FILM for each in left_out):
            shown = list(dict.fromkeys([*shown, FULL_FILM_BORDER]))
        mine, *of_members = (_by_name(each, shown) for each in every)
        unit = axis.alias_unit
        passed = {name: (_words(name), unit) for name in mine if "_to_" in name}
        missed = {
            border.name: (f"between {_words(border.name)}", unit)
            for border in shown
            if border.name not in mine
        }
        sizes = [mine[name] for name in passed] if along == "particle_diameter" else []
        notes = (
            f"searched: {_words(along)} {between[0]:g} to {between[1]:g} {unit}",
            *(f"at {end:g} {unit}: {self._words_at(key, end)}" for end in between),
            *dict.fromkeys(
                f"left out at {each.value:.4g} {unit}, {_words(each.solution_status)}: "
                f"{LEFT_OUT[each.solution_status]}"
                for each in left_out
            ),
            *self._ensemble_notes(*sizes),
        )
        title = f"Changes along the {_words(along)} at {self.described(without=along)}"
        return Answer(title, _rows(passed | missed, mine, of_members), notes, bool(mine))

    def turning_point(self, between_N: tuple[float, float] = LOADS) -> Answer:
        """Question 7: the load at which the particle fraction of the contact area turns, and the sizes.

        The curve covers the loads ``between_N`` [N], by default those of the paper.  The answer has
        the load, the area ratio and L_s at the turning point, then the least and largest diameter
        for which dry contact has one; ``found`` is whether this interface has one.
        """
        between_N = self._ends("between_N", between_N, "load_N")
        with without_warnings():
            mine, *of_members = (
                self._turning_with(each, between_N) for each in (self.parameters, *self.members)
            )
        notes = (
            f"the curve runs from {between_N[0]:g} to {between_N[1]:g} N; the maximum of A_sa,t* "
            f"stands out by {PROMINENCE:g} on both sides",
            f"diameters are searched from {RATIOS[0]:g} to {RATIOS[-1]:g} times the roughness",
            *self._ensemble_notes(self.particle_diameter_nm),
        )
        title = f"Turning point at {self.described(without='load')}"
        rows = _rows(TURNING, mine, of_members)
        return Answer(title, rows, notes, mine["load"] is not None)

    def curve(self, along: str, low: float, high: float, count: int = 60) -> Curve:
        """Question 9: all variables along one condition, with their ensemble ranges.

        ``along`` is as in ``transitions``.  The ``count`` points, 2 to a million, are
        logarithmically spaced from ``low`` to ``high``, positive, in the unit of the interface.
        """
        import pandas as pd

        key = axis_of(along).alias
        low, high = self._ends("low to high", (low, high), key)
        check_count(count)
        table = pd.DataFrame({key: np.geomspace(low, high, count)})
        mine, *of_members = self._solved(**{key: table[key].to_numpy()})
        for name in QUANTITIES:
            table[name] = getattr(mine, name)
            table = table.assign(**ranges(name, [getattr(each, name) for each in of_members]))
        for name, codes in codes_to_name(mine.variables).items():
            table[name] = pd.Categorical.from_codes(codes, FLAGS[name].meanings)
        return Curve(key, table)

    def _ends(self, name: str, ends: Any, key: str) -> tuple[float, float]:
        """The ends of a range, numbers or quantities, in the unit of the condition ``key``."""
        si = ends_in_si(name, ends, key, self.parameters)
        return tuple(decimal(from_si(key, si, self.parameters.newtons_per_load)).tolist())

    def _changes(self, key, given, between, parameters) -> list[Transition]:
        """All changes along ``key``, with those in a full film."""
        samples = sample(key, between, SWEEP, parameters)
        return all_changes(key, samples, queries(given, parameters, key), parameters)

    def _solved(self, **changes) -> list[Solution]:
        """Solutions with ``changes`` of the conditions, for the inputs and for each member."""
        given = self.conditions | changes
        with without_warnings():
            return [solve(**given, parameters=each) for each in (self.parameters, *self.members)]

    def _states(self) -> list[State]:
        """The variables in engineering units and words, for the inputs and for each member."""
        return [_state(each) for each in self._solved()]

    def _words_at(self, key, value) -> str:
        """Regime, mode and status at one end of a search."""
        with without_warnings():
            state = _state(solve(**self.conditions | {key: value}, parameters=self.parameters))
        words = [state[name] for name in (*FLAGS_WITH_BORDERS, "solution_status")]
        return ", ".join(each for each in words if each not in (None, SOLUTION_STATUSES[0]))

    def _turning_with(self, parameters, between_N) -> State:
        """The rows of ``turning_point`` for one set of inputs."""
        given = {key: value for key, value in self.conditions.items() if key != "load_N"}
        found = turning_point(parameters=parameters, between_N=between_N, **given)
        layer = {name: given[name] for name in ("roughness_nm", "particle_density_per_m2")}
        window = turning_window(parameters=parameters, between_N=between_N, **layer)
        names = "load_N", "load", "peak_ratio", "solid_load_fraction"
        values = {name: getattr(found, name) if found.exists else np.nan for name in names}
        values |= {end: getattr(window, end) * self.roughness_nm for end in ("low", "high")}
        return {name: _known(value) for name, value in values.items()}

    def _notes(self, state: State) -> tuple[str, ...]:
        """Remarks on a state."""
        name = state["solution_status"].replace(" ", "_")
        status = [] if name == SOLUTION_STATUSES[0] else [f"{name}: {STATUS_MEANINGS[name]}"]
        if state["lubrication_regime"] == "full film":
            status.append(f"full film: {LEFT_OUT[IN_FULL_FILM]}")
        few = few_particles(self.particle_density_per_m2, self.parameters.apparent_area)
        return *status, *few, *self._ensemble_notes(self.particle_diameter_nm)

    def _ensemble_notes(self, *diameters_nm: float) -> list[str]:
        """The sizes that each x_a [nm] stands for, if there are particles; and a lacking ensemble."""
        notes = []
        if self.particle_density_per_m2 > 0.0:
            lengths = AXES["roughness"].to_si([self.roughness_nm, *diameters_nm])
            roughness, *sizes = lengths.tolist()
            notes = [sizes_note(each, roughness, self.parameters) for each in sizes if each > 0.0]
        return [*notes, range_note(self.members)]


def _rows(described: Mapping, mine: State, of_members: Sequence[State]) -> tuple[Row, ...]:
    """A row for each quantity, with the words and the unit with which it is ``described``."""
    return tuple(
        Row.of(name, text, mine.get(name), unit, [each.get(name) for each in of_members])
        for name, (text, unit) in described.items()
    )


def _state(solution: Solution) -> State:
    """The variables of one point in engineering units and words."""
    state = {name: _known(getattr(solution, name)) for name in QUANTITIES}
    state["separation"] = _known(QUANTITIES["separation"].from_si(solution.separation))
    for name, code in codes_to_name(solution.variables).items():
        state[name] = _words(FLAGS[name].meanings[code]) if code >= 0 else None
    return state


def _known(value) -> float | None:
    return None if np.isnan(value) else float(value)


def _change(name: str, of_member: tuple[Value, Value], mine: tuple[Value, Value]) -> Value:
    """The second value minus the first; of words the first of ``mine``, if the member has the same."""
    if name in FLAGS:
        return mine[0] if of_member == mine else ""
    return None if None in of_member else of_member[1] - of_member[0]


def _by_name(changes: list[Transition], borders: Sequence[Border]) -> dict[str, float]:
    """Values of valid changes at ``borders``, numbered if they occur again; and of the first at each border."""
    found = {}
    for each in changes:
        if each.border in borders and each.solution_status not in LEFT_OUT:
            name = f"{each.before}_to_{each.after}"
            times = 1 + sum(other.startswith(name) for other in found)
            found[name if times == 1 else f"{name}_{times}"] = each.value
            found.setdefault(each.border.name, each.value)
    return found


def _words(name: str) -> str:
    return name.replace("_", " ")
