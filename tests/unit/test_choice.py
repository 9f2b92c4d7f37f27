"""Which of the acceptable sets of inputs a reading takes."""

import numpy as np
import pytest

from thirdbody.study.calibration import Reading, Unknown
from thirdbody.study.checks import Verdict
from thirdbody.study.choice import most_held
from thirdbody.study.claims import Claim
from thirdbody.study.evidence import FULL_EFFORT
from thirdbody.study.verdicts import Judgement

ROLES = ("calibration", "calibration", "validation")
CLAIMS = tuple(
    Claim(f"{n}", "Figure 4A", "statement", "value", role, {"roughness_nm": 300}, 0.1, False, "why")
    for n, role in enumerate(ROLES)
)
TRUNCATION = Unknown("truncation", (0.0, 10.0), (4.0, 6.0), logarithmic=False)
READING = Reading("some", {"participation": 1.0}, (TRUNCATION,))
QUICKLY = {1.0: "100", 2.0: "110", 3.0: "110", 4.0: "110", 5.0: "101"}
IN_FULL = QUICKLY | {4.0: "101"}  # the last one of each is of the validation


class Court:
    """Holds statements by the truncation, and remembers what it judged in full."""

    claims = CLAIMS

    def __init__(self):
        self.in_full = []

    def judge(self, name, inputs, effort):
        assert inputs["participation"] == 1.0
        found = QUICKLY
        if effort is FULL_EFFORT:
            self.in_full.append(inputs["truncation"])
            found = IN_FULL
        verdicts = (
            Verdict("", (0.0,), 0, 0.0, 0.0, (0.0, 0.0), True, word == "1")
            for word in found[inputs["truncation"]]
        )
        return Judgement(name, tuple(verdicts))


def test_most_statements_of_the_calibration_decide_and_then_the_least_unusual():
    court = Court()
    sets = np.array([[0.1, 1.0], [0.2, 1.1], [0.3, 1.2], [0.4, 1.3], [0.5, 1.4]])
    chosen = most_held(READING, sets, court)
    # 2, 3 and 4 hold most, 4 no longer in full; of the others 3 is nearer to what is usual
    assert chosen == pytest.approx(sets[2])
    assert court.in_full == [2.0, 3.0, 4.0]
