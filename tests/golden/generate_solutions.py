"""Golden values of the three-body lubricated contact: writes `solutions.csv` beside this file.

Every row is one contact: the numbers it depends on (float64, printed by `repr`) and its solution (25 significant
digits), computed by `solved.py`. The points are spread at random, from a fixed seed, over the published
ranges of load, viscosity, particle diameter, roughness and particle density, and over all interpretations of the equations.

    python -m tests.golden.generate_solutions             # writes solutions.csv

Needs mpmath. Units are SI. The load is F_t/(A_n E_ss), the total contact area A_t/A_n. Columns that do not explain
themselves: `status` is the `solution_status`; `group` says what the row is for; `surface_offset` is 1 where y_s and sigma_s follow from the distance
between the mean planes of summits and surface, 0 where y_s = 0 and sigma_s = sigma. Rows with viscosity 0 are dry. The
group `smooth` leaves the published ranges for film loads down to 1e-20 of the load. Numbers too small for float64 are
meant as they stand: as float64 they are 0.
"""

import csv
import itertools
import math
import multiprocessing
import random
import sys
import time
from pathlib import Path

from mpmath import mp

from tests.golden import solved as model

PRODUCT = Path(__file__).with_name("solutions.csv")
COLUMNS = (
    "group",
    *model.INTERPRETATIONS,
    *model.COORDINATES,
    *model.PARAMETERS,
    *model.OUTPUTS,
    "status",
)
SEED = 20240
DIGITS = 36  # working precision: 25 printed digits, and what steep tails and tiny film loads cost

# Choices for each of model.INTERPRETATIONS
CHOICES = (
    ("uncentred", "centred", "gap_convolved"),
    (0, 1),
    ("printed", "physical"),
    ("printed", "contacting"),
    ("fluid", "total"),
)
PUBLISHED = dict(
    E_ss=112e9, E_sa=112e9, H_s1=5e9, H_s2=5e9, k=0.4, omega_ratio=54.0, R_x=6.35e-3, G=2038.0, V=0.04, kappa=1.0,
    U_per_viscosity=7.3e-10 / 150e-6,
)  # fmt: skip
# ASSUME: the unpublished inputs are spread around these numbers.
# beta = eta_s R sigma and R [m] are pairs: value at a roughness of 300 nm, exponent of the roughness
UNPUBLISHED = {
    "uncentred": dict(
        beta=(0.65, -0.80), R=(29.7e-6, 0.33), A_n=6.4e-6, participation=0.0221,
        mean_ratio=0.0, sigma_a_ratio=1.60, gap_ratio=0.0, truncation=2.44,
    ),
    "centred": dict(
        beta=(1.58, -0.49), R=(21.5e-6, 1.39), A_n=2.6e-6, participation=0.0239,
        mean_ratio=0.48, sigma_a_ratio=1.42, gap_ratio=0.0, truncation=2.57,
    ),
    "gap_convolved": dict(
        beta=(2.67, -0.96), R=(11.5e-6, 0.41), A_n=1.1e-6, participation=1.0,
        mean_ratio=0.0, sigma_a_ratio=0.68, gap_ratio=1.15, truncation=3.23,
    ),
}  # fmt: skip
REAL_SURFACE = dict(beta=(0.05, 0.0), R=(12e-6, 0.0))  # ASSUME: typical of measured surfaces
VISCOSITIES = ((0.3e-6, 4e-6), (4e-6, 40e-6), (40e-6, 90e-6), (90e-6, 150e-6))  # [m2/s]
FILM = dict(
    viscosity=(50e-6, 150e-6), particle_diameter=(20e-9, 200e-9), roughness=(100e-9, 300e-9)
)
# Groups that keep a candidate only where this output lies in this range
WANTED = {
    "mixed": ("solid_load_fraction", 0.03, 0.90),
    "hybrid": ("particle_contact_area_ratio", 0.05, 0.95),
    "smooth": ("fluid_load_fraction", 0.0, 1e-12),
}


def surface(beta, R, sigma, offset):
    """eta_s, R, sigma_s, y_s of a surface with eta_s R sigma = beta (Zhao, Maietta & Chang)."""
    eta_s = beta / (R * sigma)
    if not offset:
        return dict(eta_s=eta_s, R=R, sigma_s=sigma, y_s=0.0)
    sigma_s = math.sqrt(sigma**2 - 3.717e-4 / (eta_s * R) ** 2)
    return dict(eta_s=eta_s, R=R, sigma_s=sigma_s, y_s=0.045944 / (eta_s * R))


def draw(slot, rng):
    """A candidate row: the numbers that the slot fixes, the others at random."""
    base = UNPUBLISHED[slot["phi_a"]]
    (beta, m), (R, n) = (shape := rng.choice((base, REAL_SURFACE)))["beta"], shape["R"]
    drawn = {
        name: base[name] * rng.uniform(0.8, 1.25)
        for name in ("A_n", "mean_ratio", "sigma_a_ratio", "gap_ratio", "truncation")
    }
    drawn["participation"] = rng.choice(
        (base["participation"], 1.0, 0.0885, rng.uniform(0.01, 0.05))
    )
    drawn["h_e_ratio"] = rng.choice((0.0111, 0.0885))
    drawn["roughness"] = rng.uniform(100e-9, 500e-9)
    drawn["particle_diameter"] = rng.uniform(20e-9, 1000e-9)
    drawn["particle_density"] = 10 ** rng.uniform(10, math.log10(5e12))
    drawn["normal_load"] = 10 ** rng.uniform(math.log10(0.04), math.log10(80))
    row = PUBLISHED | drawn | slot
    beta *= rng.uniform(0.8, 1.25) * (row["roughness"] / 300e-9) ** m
    R *= rng.uniform(0.8, 1.25) * (row["roughness"] / 300e-9) ** n
    row |= surface(beta, R, row["roughness"], row["surface_offset"])
    return row | {"load": row["normal_load"] / (row["A_n"] * row["E_ss"])}


def combinations(step=1, start=0):
    """Every combination of interpretations, or every `step`-th, endlessly."""
    combined = [dict(zip(model.INTERPRETATIONS, choice)) for choice in itertools.product(*CHOICES)]
    for index in itertools.count(start, step):
        yield combined[index % len(combined)]


def lubricated_slots():
    """Each combination of interpretations at four ranges of viscosity, where a film forms, and where loads or areas mix."""
    rng = random.Random(f"{SEED} lubricated")
    conditions = [*(("lubricated", {"viscosity": band}) for band in VISCOSITIES), ("film", FILM)]
    for interpretation in itertools.islice(combinations(), 48):
        for group, condition in conditions:
            yield {
                "group": group,
                **{name: rng.uniform(*band) for name, band in condition.items()},
                **interpretation,
            }
        for group in ("mixed", "hybrid"):
            yield {"group": group, "viscosity": rng.uniform(20e-6, 150e-6), **interpretation}


def limit_slots():
    """Dry contacts with particles; two-body contacts, wet and dry."""
    for interpretation in itertools.islice(combinations(step=2), 24):
        yield {"group": "dry", "viscosity": 0.0, **interpretation}
    no_size, no_number = {"particle_diameter": 0.0}, {"particle_density": 0.0}
    absent = (no_size, no_number, no_size | no_number)
    viscosities = (1e-6, 20e-6, 0.0, 60e-6, 90e-6, 0.0, 120e-6, 150e-6)
    for index, interpretation in enumerate(itertools.islice(combinations(step=5), 24)):
        viscosity = viscosities[index % 8]
        group = "two_body" if viscosity else "two_body_dry"
        yield {"group": group, "viscosity": viscosity, **absent[index % 3], **interpretation}


def corner_slots():
    """Corners of the published ranges, with few enough participating particles to cover the surface in part only."""
    names = ("normal_load", "viscosity", "particle_diameter", "roughness", "particle_density")
    ends = ((0.04, 80.0), (2e-6, 150e-6), (100e-9, 1000e-9), (100e-9, 500e-9), (1e10, 5e12))
    for corner, interpretation in zip(itertools.product(*ends), combinations(step=7)):
        yield {
            "group": "corner",
            "participation": 0.02,
            **dict(zip(names, corner)),
            **interpretation,
        }


def material_slots():
    """Unequal hardness and modulus, elliptical contacts, other asperity laws and other film numbers."""
    rng = random.Random(f"{SEED} materials")
    ranges = dict(
        E_ss=(90e9, 150e9), E_sa=(60e9, 250e9), H_s1=(3e9, 8e9), H_s2=(3e9, 8e9), k=(0.3, 0.5),
        omega_ratio=(40.0, 110.0), R_x=(4e-3, 12e-3), G=(1500.0, 5000.0), V=(0.01, 0.1), kappa=(0.6, 4.0),
        U_per_viscosity=(3e-6, 8e-6),
    )  # fmt: skip
    for index, interpretation in enumerate(itertools.islice(combinations(step=5, start=1), 24)):
        viscosity = 0.0 if index % 8 == 7 else rng.uniform(2e-6, 150e-6)
        materials = {name: rng.uniform(*ends) for name, ends in ranges.items()}
        yield {"group": "materials", "viscosity": viscosity, **materials, **interpretation}


def smooth_slots():
    """Large particles between surfaces smoother than the published ones, where the fluid's share of the load vanishes."""
    rng = random.Random(f"{SEED} smooth")
    ranges = dict(
        roughness=(5e-9, 20e-9), viscosity=(3e-6, 20e-6), particle_diameter=(500e-9, 1000e-9), normal_load=(0.04, 1.0),
        participation=(0.01, 0.05), particle_density=(1e12, 5e12),
    )  # fmt: skip
    for interpretation in itertools.islice(combinations(step=10), 12):
        yield {
            "group": "smooth",
            **{name: rng.uniform(*ends) for name, ends in ranges.items()},
            **interpretation,
        }


def text(value):
    """A cell: 25 digits of a solution, repr of a float64, or the word itself."""
    if isinstance(value, mp.mpf):
        return mp.nstr(value, 25)
    return repr(value) if isinstance(value, float) else str(value)


def fill(numbered_slot):
    """Cells of the first candidate of a slot that is solved and wanted; None where 200 are not."""
    number, slot = numbered_slot
    mp.dps = DIGITS
    rng = random.Random(f"{SEED} {number}")
    name, low, high = WANTED.get(slot["group"], ("solid_load_fraction", 0, 1))
    for _ in range(200):
        try:
            row = model.solve_contact(draw(slot, rng))
        except model.Meaningless:
            continue
        if low <= row[name] <= high:
            return [text(row[column]) for column in COLUMNS]
    return None


def generate():
    """Fill all slots over two processes and write the product."""
    slots = [
        *lubricated_slots(),
        *limit_slots(),
        *corner_slots(),
        *material_slots(),
        *smooth_slots(),
    ]
    start, rows = time.monotonic(), []
    with multiprocessing.Pool(2) as pool:
        for done, row in enumerate(pool.imap(fill, enumerate(slots), chunksize=4), start=1):
            rows += [row] if row else []
            if done % 16 == 0 or done == len(slots):
                elapsed = time.monotonic() - start
                print(
                    f"{done}/{len(slots)} slots, {len(rows)} rows, {elapsed:.0f} s",
                    file=sys.stderr,
                    flush=True,
                )
    with PRODUCT.open("w", newline="") as file:
        writer = csv.writer(file, lineterminator="\n")
        writer.writerow(COLUMNS)
        writer.writerows(rows)


if __name__ == "__main__":
    generate()
