"""Can the printed particle term (participation 1) satisfy Figures 4, 6 and 11 together?

Each calibrated reading is judged on the statements of these figures alone, at its best inputs and
at every member of its ensemble.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import replace

from thirdbody.data.places import part_of_paper
from thirdbody.model.parameters import Parameters
from thirdbody.study.checks import judge
from thirdbody.study.claims import Claim, referenced_conditions
from thirdbody.study.evidence import QUICK_EFFORT, SolvedEvidence

MEMBERS = 4  # of each ensemble: the best and those farthest from it and from each other
PARTS = ("Figure 4", "Figure 6", "Figure 11")


def conflict_rows(
    claims: Sequence[Claim], readings: Sequence[Mapping], base: Parameters, newtons
) -> Iterator[dict]:
    """One row a reading, member and statement with a published value or course.

    ``readings`` are contents of calibrated files (``thirdbody.study.posterior``), whose first member is
    the best and whose next are the farthest apart; ``newtons`` is the first and last normal load
    [N].
    """
    chosen = [
        claim for claim in claims if part_of_paper(claim.where) in PARTS and not claim.is_withheld
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
