"""How often the default lies within its own range: over random conditions of Table 2.

    python -m benchmarks.ranges

A range is 5 to 95 % of the members of the ensemble.  A default at its edge would give a reader
values outside the range printed beside them.
"""

import numpy as np
import pandas as pd

import thirdbody as tb
from thirdbody.ensembles import range_over_members

CONDITIONS = 400
SEED = 1
# ASSUME: one condition in ten is dry, and one in ten has no particles
PART = 0.1
VARIABLES = {
    "solid_load_fraction": "L_s",
    "total_contact_area": "A_t*",
    "particle_contact_area_ratio": "A_sa,t*",
    "separation": "d",
    "film_thickness": "H_c",
}
ROUNDING = 1e-9  # of the solver, where all members have one value


def random_conditions(count: int, seed: int) -> dict[str, np.ndarray]:
    """Conditions within Table 2 of the paper by their names in ``thirdbody.solve``, each of shape
    (count,).
    """
    rng = np.random.default_rng(seed)

    def logarithmic(low, high):
        return np.exp(rng.uniform(np.log(low), np.log(high), count))

    return {
        "load_N": logarithmic(0.04, 80.0),
        "viscosity_cSt": np.where(rng.random(count) < PART, 0.0, rng.uniform(5.0, 150.0, count)),
        "particle_diameter_nm": np.where(
            rng.random(count) < PART, 0.0, rng.uniform(20.0, 1000.0, count)
        ),
        "roughness_nm": rng.uniform(100.0, 500.0, count),
        "particle_density_per_m2": logarithmic(1e10, 5e12),
    }


def shares_within(ensemble: tb.Ensemble) -> pd.Series:
    """Share of the conditions [1] at which the best of an ``ensemble`` lies within the range of its
    members, by variable; conditions at which the best has no values are left out."""
    conditions = random_conditions(CONDITIONS, SEED)
    points = tb.solve(**conditions, parameters=ensemble, members=True)
    shares = {}
    for name, symbol in VARIABLES.items():
        members = getattr(points, name)
        solved = np.isfinite(members[0])
        numbers = members[0, solved]
        low, high = range_over_members(members[:, solved])
        slack = ROUNDING * np.abs(numbers)
        shares[symbol] = ((low - slack <= numbers) & (numbers <= high + slack)).mean()
    return pd.Series(shares)


if __name__ == "__main__":
    inputs = tb.load_parameters()
    print(f"{CONDITIONS} conditions of Table 2, {len(inputs.members)} members; within the range:")
    print(shares_within(inputs).map("{:.1%}".format).to_string())
