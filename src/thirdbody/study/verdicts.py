"""The verdict on every statement of the paper, and what would change those that fail.

All statements are judged under many sets of inputs: the default, the members of its ensemble, the
default with one unknown moved at a time, and the best inputs of every reading.  ``Court`` judges
them under one set of inputs, a ``Trial`` holds the judgements under all, and the functions below
make rows of tables and text of a trial.
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Collection, Iterable, Iterator, Mapping, Sequence
from contextlib import suppress
from dataclasses import dataclass, replace
from typing import Any

import numpy as np
from numpy.typing import NDArray

from thirdbody.data.places import part_of_paper
from thirdbody.data.spread import spread
from thirdbody.model.parameters import Parameters
from thirdbody.study.calibration import Reading
from thirdbody.study.checks import Verdict, judge
from thirdbody.study.claims import Claim, referenced_conditions
from thirdbody.study.evidence import FULL_EFFORT, QUICK_EFFORT, Effort, SolvedEvidence

HOLDS, FAILS, NOT_TESTED = "holds", "fails", "not tested"
CONTRADICTED, WITHHELD = "contradicted by the paper itself", "value withheld"
LEAST_GAIN = 0.01  # smaller improvements of a score are not told
NO_RANGE = (np.nan, np.nan)
NUDGE = 0.08  # how far an input is moved by itself, as a share of its bounds


@dataclass(frozen=True)
class Judgement:
    """Verdicts on all statements under one set of inputs.

    Attributes
    ----------
    name : str
        Name of the set of inputs.
    verdicts : tuple of Verdict
        In the order of the statements.
    """

    name: str
    verdicts: tuple[Verdict, ...]

    def held(self) -> NDArray[np.bool_]:
        """Which statements hold, shape (claims,)."""
        return np.array([verdict.holds for verdict in self.verdicts], dtype=bool)


class Court:
    """Judges the same statements under any set of inputs.

    Parameters
    ----------
    claims : sequence of Claim
        The statements.
    base : Parameters
        Values of the inputs that a set does not give.
    newtons : tuple of float
        First and last normal load of every curve [N].
    """

    def __init__(self, claims: Sequence[Claim], base: Parameters, newtons: tuple[float, float]):
        self.claims = tuple(claims)
        self.base = base
        self.newtons = newtons
        self.asked = referenced_conditions(claims)

    def judge(
        self, name: str, inputs: Mapping[str, Any], effort: Effort = QUICK_EFFORT
    ) -> Judgement:
        """Judge all statements under one set of inputs.

        Parameters
        ----------
        name : str
            Name of the set, for the judgement.
        inputs : mapping
            Fields of ``Parameters`` that replace those of ``base``, SI.
        effort : Effort
            How finely curves and windows are solved.

        Raises
        ------
        ValueError
            If the inputs are not physical.
        """
        parameters = replace(self.base, **inputs)
        evidence = SolvedEvidence(parameters, self.asked, self.newtons, effort)
        return Judgement(name, tuple(judge(claim, evidence) for claim in self.claims))


@dataclass(frozen=True)
class Trial:
    """All statements, judged under all sets of inputs.

    Attributes
    ----------
    claims : tuple of Claim
        The statements.
    main : Judgement
        Under the default inputs.
    ensemble : tuple of Judgement
        Under each member of the ensemble of the default.
    nudged : tuple of Judgement
        Under the default with one unknown moved, up and down for each, where a surface can have it.
    readings : tuple of Judgement
        Under the best inputs of each reading.
    """

    claims: tuple[Claim, ...]
    main: Judgement
    ensemble: tuple[Judgement, ...]
    nudged: tuple[Judgement, ...]
    readings: tuple[Judgement, ...]

    @classmethod
    def of(
        cls,
        court: Court,
        default: Mapping[str, Any],
        reading: Reading,
        readings: Sequence[Mapping[str, Any]],
    ) -> Trial:
        """Hold the trial.

        Parameters
        ----------
        court : Court
            Has the statements.
        default : mapping
            Content of the calibrated file whose inputs are the default.
        reading : Reading
            The reading that this file is of.
        readings : sequence of mapping
            Contents of the calibrated files of all readings.
        """
        inputs = court.base.as_dict() | default["inputs"]
        nudged = []
        for name, changed in _nudges(reading, inputs):
            with suppress(ValueError):  # no surface has these inputs
                nudged.append(court.judge(name, changed))
        return cls(
            court.claims,
            court.judge("default", inputs, FULL_EFFORT),
            tuple(court.judge("member", {**inputs, **member}) for member in default["ensemble"]),
            tuple(nudged),
            tuple(court.judge(each["reading"], each["inputs"]) for each in readings),
        )


def verdict_rows(trial: Trial) -> list[dict[str, Any]]:
    """Rows of the table ``claims``.

    Parameters
    ----------
    trial : Trial
        All statements, judged under all sets of inputs.

    Returns
    -------
    list of dict
        For each statement what is published and measured, how far apart they are, the verdict
        under the default inputs, the range that holds 90 % of the ensemble, and how many members
        of the ensemble and readings agree with the verdict.

    Examples
    --------
    >>> claim = Claim(
    ...     id="fig03a-ratio-zero-without-particles",
    ...     place="Figure 3A, section 3.3",
    ...     statement="Without particles the particle contact ratio is 0 at each load.",
    ...     kind="value",
    ...     role="calibration",
    ...     quantity="particle_contact_area_ratio",
    ...     extreme="maximum",
    ...     conditions={
    ...         "viscosity_cSt": 0,
    ...         "particle_diameter_nm": 0,
    ...         "roughness_nm": 100,
    ...         "particle_density_per_m2": 1e11,
    ...     },
    ...     published=0.0,
    ...     tolerance=0.001,
    ...     relative=False,
    ...     reason="true by definition of the ratio",
    ... )
    >>> from thirdbody import load_parameters
    >>> court = Court([claim], load_parameters(), newtons=(0.04, 80.0))
    >>> trial = Trial((claim,), court.judge("default", {}), (), (), ())
    >>> (row,) = verdict_rows(trial)
    >>> row["measured"], row["verdict"]
    ('0', 'holds')
    """
    return [
        {
            "id": claim.id,
            "place": claim.place,
            "statement": claim.statement,
            "quote": claim.quote,
            "kind": claim.kind,
            "role": claim.role,
            "curves": claim.curves_told,
            "published": _published(claim),
            "measured": verdict.measured,
            "value": verdict.value,
            **_range_of_value(trial, index),
            "deviation": verdict.deviation,
            "tolerance": claim.tolerance,
            "tolerance_kind": "relative" if claim.relative else "absolute",
            "score": verdict.score,
            "verdict": outcome(claim, verdict),
            "ensemble_agree": _agreeing(trial.ensemble, index, verdict),
            "ensemble_size": len(trial.ensemble),
            "readings_agree": _agreeing(trial.readings, index, verdict),
            "readings_size": len(trial.readings),
            "cluster": claim.cluster,
            "contradicts": " ".join(claim.contradicts),
        }
        for index, (claim, verdict) in enumerate(
            zip(trial.claims, trial.main.verdicts, strict=True)
        )
    ]


def headline_rows(trial: Trial, chosen: Collection[str]) -> list[dict[str, Any]]:
    """Numbers of the paper, of the model and of the ensemble, for some statements.

    Parameters
    ----------
    trial : Trial
        All statements, judged under all sets of inputs.
    chosen : collection of str
        Ids of the statements.

    Returns
    -------
    list of dict
        For each, in the order of the statements: what it says, the paper's and the model's numbers,
        of each the range that holds 90 % of the ensemble, and the verdict.  Numbers of several curves
        that are the same are given once.  Where no numbers are compared, the range is the share of the
        ensemble that agrees with the verdict.
    """
    rows = []
    for index, (claim, verdict) in enumerate(zip(trial.claims, trial.main.verdicts, strict=True)):
        if claim.id not in chosen:
            continue
        ends = ranges(trial, index)
        if np.isfinite(ends).any():
            within = ", ".join(f"{low:.3g} to {high:.3g}" for low, high in ends)
        else:
            same = _agreeing(trial.ensemble, index, verdict)
            within = f"{same} of {len(trial.ensemble)} agree"
        rows.append(
            {
                "statement": claim.statement,
                "id": claim.id,
                "paper": _published(claim),
                "model": once(verdict.measured),
                "ensemble, 90 %": once(within),
                "verdict": outcome(claim, verdict),
            }
        )
    return rows


def ranges(trial: Trial, index: int) -> NDArray[np.float64]:
    """Which range holds 90 % of the ensemble, for each number of a statement.

    Parameters
    ----------
    trial : Trial
        All statements, judged under all sets of inputs.
    index : int
        Place of the statement.

    Returns
    -------
    array, shape (numbers, 2)
        Low and high ends, in the order of ``Verdict.numbers`` [unit of the quantity]; nan without a
        member that has the number.
    """
    members = [each.numbers for each in _on(trial.ensemble, index) if each.numbers]
    places = range(len(trial.main.verdicts[index].numbers))
    ends = [spread(each[place] for each in members) or NO_RANGE for place in places]
    return np.reshape(ends, (-1, 2))


def _range_of_value(trial: Trial, index: int) -> dict[str, float]:
    """Columns of the range of ``Verdict.value``, the number that is farthest off; nan if there is none."""
    verdict = trial.main.verdicts[index]
    ends = ranges(trial, index)[verdict.worst].tolist() if verdict.numbers else NO_RANGE
    return dict(zip(("range_low", "range_high"), ends, strict=True))


def once(text: str) -> str:
    """What was measured on several curves, said once if it is the same on all.

    Parameters
    ----------
    text : str
        Numbers with ``, `` between them, or what else was measured.

    Examples
    --------
    >>> once("0.2, 0.2"), once("0.2, 0.3")
    ('0.2', '0.2, 0.3')
    """
    first, *others = text.split(", ")
    return text if set(others) - {first} else first


def _agreeing(judgements: Sequence[Judgement], index: int, verdict: Verdict) -> int:
    """How many judgements come to the same as ``verdict`` on the statement at ``index``."""
    same = verdict.tested, verdict.holds
    return sum((other.tested, other.holds) == same for other in _on(judgements, index))


def _on(judgements: Sequence[Judgement], index: int) -> list[Verdict]:
    """The verdicts on the statement at ``index``."""
    return [each.verdicts[index] for each in judgements]


def reading_rows(
    trial: Trial, readings: Sequence[Mapping[str, Any]], headline: Sequence[str]
) -> list[dict[str, Any]]:
    """Compare the readings, each at its best inputs.

    Parameters
    ----------
    trial : Trial
        All statements, judged under all sets of inputs.
    readings : sequence of mapping
        Contents of the calibrated files of all readings, in the order of ``trial.readings``.
    headline : sequence of str
        Ids of the statements to compare the readings by.

    Returns
    -------
    list of dict
        For each reading how many statements of each role hold, repeats counted once, the penalty
        of its inputs for being unusual, how many they are, its objective, and what is measured for
        the statements of ``headline``.  The first is to be the default: most statements that it was
        fitted to hold under it, then its inputs are the least unusual, then the fewest.
    """
    rows, ranks = [], {}
    for judgement, content in zip(trial.readings, readings, strict=True):
        row = {"reading": judgement.name}
        held = {}
        for role in ("calibration", "validation"):
            held[role], judged = count_held(trial.claims, judgement, role)
            row[role] = f"{held[role]}/{judged}"
        found = content["penalty"], len(content["identification"])
        row |= {"penalty": f"{found[0]:.2f}", "inputs": found[1], "objective": content["objective"]}
        ranks[judgement.name] = -held["calibration"], *found
        for claim, verdict in zip(trial.claims, judgement.verdicts, strict=True):
            if claim.id in headline:
                row[claim.id] = verdict.measured + (" ✓" if verdict.holds else "")
        rows.append(row)
    return sorted(rows, key=lambda row: ranks[row["reading"]])


def _published(claim: Claim) -> str:
    """What the paper says, as text; empty if it is neither numbers nor a sequence of states."""
    if claim.published is None:
        return ""
    separator = " > " if claim.kind.endswith("_sequence") else ", "
    return separator.join(str(each) for each in np.atleast_1d(claim.published))


def outcome(claim: Claim, verdict: Verdict) -> str:
    """The word for a verdict.

    Parameters
    ----------
    claim : Claim
        A statement of the paper.
    verdict : Verdict
        What came of judging it.

    Returns
    -------
    str
        A statement that stands aside for others neither holds nor fails, whatever was measured.
    """
    if claim.is_withheld:
        return WITHHELD
    if claim.aside:
        return CONTRADICTED
    if not verdict.tested:
        return NOT_TESTED
    return HOLDS if verdict.holds else FAILS


def counted_once(outcomes: Iterable[tuple[str, str]]) -> tuple[int, int]:
    """Count statements that hold, those that repeat one another once.

    Parameters
    ----------
    outcomes : iterable of (str, str)
        Cluster of each statement, its id if it has none, and the word for its verdict.

    Returns
    -------
    held, judged : int
        A cluster holds if all its statements that were tested hold.

    Examples
    --------
    >>> counted_once([("a", HOLDS), ("a", FAILS), ("b", HOLDS), ("b", NOT_TESTED), ("c", WITHHELD)])
    (1, 2)
    """
    clusters: dict[str, bool] = {}
    for name, word in outcomes:
        if word in (HOLDS, FAILS):
            clusters[name] = clusters.get(name, True) and word == HOLDS
    return sum(clusters.values()), len(clusters)


def count_held(claims: Sequence[Claim], judgement: Judgement, role: str) -> tuple[int, int]:
    """``counted_once`` of the ``claims`` of a role, as a judgement on all of them says."""
    return counted_once(
        (claim.counted_as, outcome(claim, verdict))
        for claim, verdict in zip(claims, judgement.verdicts, strict=True)
        if claim.role == role
    )


def held_once(rows: Iterable[Mapping[str, Any]]) -> tuple[int, int]:
    """``counted_once`` of rows of the table ``claims``."""
    return counted_once((row["cluster"] or row["id"], row["verdict"]) for row in rows)


def discriminating(trial: Trial) -> list[str]:
    """Ids of the statements that hold under some readings and fail under others."""
    found = []
    for index, claim in enumerate(trial.claims):
        words = {outcome(claim, verdict) for verdict in _on(trial.readings, index)}
        if {HOLDS, FAILS} <= words:
            found.append(claim.id)
    return found


def explanations(trial: Trial) -> dict[str, str]:
    """Explain the statements that fail.

    Parameters
    ----------
    trial : Trial
        All statements, judged under all sets of inputs.

    Returns
    -------
    dict
        For each statement that fails, by its id, a paragraph: what the model gives, which change
        of one input or of the reading would bring it nearer, and which statements would be lost.
    """
    return {
        claim.id: _paragraph(trial, index)
        for index, (claim, verdict) in enumerate(
            zip(trial.claims, trial.main.verdicts, strict=True)
        )
        if outcome(claim, verdict) == FAILS
    }


def _nudges(reading: Reading, inputs: Mapping[str, Any]) -> Iterator[tuple[str, dict[str, Any]]]:
    """Names and sets of inputs with one unknown moved, down and up for each."""
    for unknown in reading.unknowns:
        for direction, step in (("lower", -NUDGE), ("higher", NUDGE)):
            position = np.clip(unknown.position(inputs[unknown.name]) + step, 0.0, 1.0)
            name = f"{direction} {unknown.name.replace('_', ' ')}"
            yield name, {**inputs, unknown.name: unknown.value(position)}


def _paragraph(trial: Trial, index: int) -> str:
    """What the model gives for the statement at ``index``, and what would bring it nearer."""
    verdict = trial.main.verdicts[index]
    return " ".join(
        [
            f"The model gives {verdict.measured}, a score of {verdict.score:.2g}.",
            _by_input(trial, index, verdict),
            _by_reading(trial, index),
        ]
    )


def _by_input(trial: Trial, index: int, verdict: Verdict) -> str:
    best = min(trial.nudged, key=lambda each: each.verdicts[index].score)
    found = best.verdicts[index]
    if verdict.score - found.score <= LEAST_GAIN:
        return "No single input, moved by itself, brings it nearer."
    effect = "it would hold" if found.holds else f"its score would fall to {found.score:.2g}"
    return f"With a {best.name} {effect}; {_price(trial, best)}."


def _by_reading(trial: Trial, index: int) -> str:
    better = [other for other in trial.readings if other.verdicts[index].holds]
    if not better:
        return f"It holds under none of the {len(trial.readings)} readings at their best inputs."
    kindest = max(better, key=lambda other: int(other.held().sum()))
    return (
        f"It holds under {len(better)} of {len(trial.readings)} readings "
        f"({', '.join(other.name for other in better)}); under the best of them, {kindest.name}, "
        f"{_price(trial, kindest)}."
    )


def _price(trial: Trial, other: Judgement) -> str:
    """Which statements hold under the default inputs and would fail under those of ``other``."""
    lost = [
        claim.id
        for claim, before, after in zip(trial.claims, trial.main.held(), other.held(), strict=True)
        if before and not after and not claim.aside
    ]
    if not lost:
        return "no statement that holds now forbids it"
    shown = ", ".join(lost[:4]) + (f" and {len(lost) - 4} more" if len(lost) > 4 else "")
    return f"{len(lost)} that hold now forbid it: {shown}"


def counts(rows: Sequence[Mapping[str, Any]], by: str) -> list[dict[str, Any]]:
    """How many statements fare how, in each group of them.

    Parameters
    ----------
    rows : sequence of Mapping
        Rows of the table ``claims``.
    by : str
        ``role``, or ``figure``: the part of the paper that a statement stands in.

    Returns
    -------
    list of dict
        A row a group, in the order of the first statement of each: its name under ``by``, the
        number of statements under each verdict, and how many hold if repeats count once.
    """
    groups: dict[str, list] = {}
    for row in rows:
        group = row["role"] if by == "role" else part_of_paper(row["place"])
        groups.setdefault(group, []).append(row)
    order = (HOLDS, FAILS, NOT_TESTED, CONTRADICTED, WITHHELD)
    table = []
    for name, group in groups.items():
        count = Counter(row["verdict"] for row in group)
        held, judged = held_once(group)
        table.append(
            {by: name, **{each: count[each] for each in order}}
            | {"hold, repeats once": f"{held} of {judged}" if judged else ""}
        )
    return table
