"""Can the printed particle term (participation 1) satisfy Figures 4, 6 and 11 together?

Each calibrated reading is judged on the statements of these figures alone, at its best inputs and
at every member of its ensemble.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import replace
from typing import Any

from thirdbody.data.places import part_of_paper
from thirdbody.model.parameters import Parameters
from thirdbody.study.checks import judge
from thirdbody.study.claims import Claim, referenced_conditions
from thirdbody.study.evidence import QUICK_EFFORT, SolvedEvidence

MEMBERS = 4  # judged of each ensemble, whose first is the best and whose next are far apart
PARTS = ("Figure 4", "Figure 6", "Figure 11")


def conflict_rows(
    claims: Sequence[Claim],
    readings: Sequence[Mapping[str, Any]],
    base: Parameters,
    newtons: tuple[float, float],
) -> Iterator[dict[str, Any]]:
    """Judge the statements of the three figures under calibrated readings.

    Parameters
    ----------
    claims : sequence of Claim
        Statements of the paper; those of other figures, those whose value the paper keeps back,
        and those that stand aside for others are passed over.
    readings : sequence of mapping
        Contents of calibrated files, as ``thirdbody.study.posterior.summary`` returns them.
    base : Parameters
        Values of the inputs that a calibrated file does not give.
    newtons : tuple of float
        First and last normal load [N].

    Yields
    ------
    dict
        A row of the table ``conflict`` for each reading, member of its ensemble, and statement.

    Examples
    --------
    >>> from thirdbody import load_parameters
    >>> claim = Claim(
    ...     id="dry",
    ...     where="Figure 4A",
    ...     statement="Solids bear the whole load where there is no lubricant.",
    ...     kind="value",
    ...     role="calibration",
    ...     quantity="solid_load_fraction",
    ...     conditions={
    ...         "viscosity_cSt": 0,
    ...         "particle_diameter_nm": 500,
    ...         "roughness_nm": 300,
    ...         "particle_density_per_m2": 1e11,
    ...     },
    ...     published=1.0,
    ...     tolerance=0.01,
    ...     relative=False,
    ...     reason="follows from the force balance",
    ... )
    >>> free = {"reading": "free", "inputs": {}, "ensemble": [{"participation": 0.003}]}
    >>> (row,) = conflict_rows([claim], [free], load_parameters(), (0.04, 80.0))
    >>> row["part"], row["particle_term"], row["score"]
    ('Figure 4', 'free', 0.0)
    """
    chosen = [
        claim
        for claim in claims
        if part_of_paper(claim.where) in PARTS and not (claim.is_withheld or claim.aside)
    ]
    asked = referenced_conditions(chosen)
    for reading in readings:
        for member, inputs in enumerate(reading["ensemble"][:MEMBERS]):
            parameters = replace(base, **{**reading["inputs"], **inputs})
            evidence = SolvedEvidence(parameters, asked, newtons, QUICK_EFFORT)
            same = {
                "reading": reading["reading"],
                "size_distribution": parameters.size_distribution,
                "summit_plane": parameters.readings.summit_offset.plane,
                "particle_term": "free" if "participation" in inputs else "printed",
                "participation": parameters.participation,
                "member": member,
            }
            for claim in chosen:
                place = {"id": claim.id, "part": part_of_paper(claim.where)}
                yield same | place | {"score": judge(claim, evidence).score}
