"""Extremes at which models of this kind break: writes `extremes.csv` beside this file.

Columns as in `solutions.csv`, but for the first five: `item` and `case` say what is extreme; `origin` is `equations`
where `solved.py` solves the row as it stands, else the name of the function here that takes its limit;
`status` is the `solution_status` expected, the outputs of an unsolved row are empty; `gap_conditioning` is the relative
error of d that a relative error of 1 in the solid load makes, |d ln d/d ln F_s|.

    python -m tests.golden.generate_extremes      # writes extremes.csv
"""

import csv
import sys
from pathlib import Path

from mpmath import mp

from tests.golden import solved as model
from tests.golden.generate_accuracy_points import inputs_of
from tests.golden.generate_solutions import text

PRODUCT = Path(__file__).with_name("extremes.csv")
DIGITS = 40
LEADING = ("item", "case", "origin", "status", "gap_conditioning")
COLUMNS = (*LEADING, *model.INTERPRETATIONS, *model.COORDINATES, *model.PARAMETERS, *model.OUTPUTS)
WET, DRY = 90e-6, 0.0
POINT = dict(load=1e-5, viscosity=WET, particle_diameter=500e-9, particle_density=1e11)
TWO_BODY = dict(particle_diameter=0.0)
OFFSET_LOST = dict(
    beta=(0.0195, 0.0)
)  # the summits' deviation nearly vanishes, their plane lies high
EQUAL = dict(sigma_a_ratio=0.0, mean_ratio=1.0)


def point(roughness=300e-9, phi_a="uncentred", **changes):
    """All numbers of a point: the default inputs and conditions but for `changes`."""
    conditions = {name: changes.pop(name) for name in model.COORDINATES if name in changes}
    return inputs_of(phi_a, roughness, changes) | POINT | conditions


# ------------------------------------------------------------------------------------------------ solutions and limits
def equations(row):
    """Outputs of a row by the equations as they stand, and their status."""
    solved = model.solve_contact(row, most_coverage=1)
    return {name: solved[name] for name in (*model.OUTPUTS, "status")}


def outputs(p, d, L_s, L_f, A_sa, A_ss):
    """Outputs from the separation, the shares of the load, and the areas over A_n; and their status."""
    total = A_sa + A_ss
    ratios = (A_sa / total, A_ss / total) if total else (mp.zero, mp.one)
    found = dict(zip(model.OUTPUTS, (total, *ratios, L_s, L_f, d, d / p.R_x)))
    return found | {"status": model.status_of(found, p)}


def nearly_closed(row):
    """Dry, next to zero separation."""
    return equations(row)


def film_alone(row):
    """So thick a film that no solid touches: L_f = 1 and d = R_x H_c(F_t). Areas of exp(-1e4) and less are zero."""
    p = model.interface(row)
    d = p.film(p.load)
    assert (d - p.y_s) / p.sigma_s > 140
    return outputs(p, d, mp.zero, mp.one, mp.zero, mp.zero)


def vanishing_film(row):
    """The solids bear all but L_f, which follows from the dry separation: H_c(L_f F_t) = d/R_x; below 1e-25."""
    p = model.interface(row)
    d = particles_alone(p)
    L_f = film_share(d, p)
    assert L_f < mp.mpf("1e-25")
    areas = p.particles(d), mp.zero
    return outputs(p, d, 1 - L_f, L_f, *areas)


def particles_alone(p):
    """d [m] at which particles bear the whole load, so far apart that no summit touches."""
    reach = (p.truncation * p.sigma_a_ratio + p.h_e_ratio) * p.particle_diameter
    wanted = p.load * p.E_ss / p.H_s1
    d = reach * model.root(lambda x: p.particles(reach * x) / wanted - 1, mp.mpf("0.1"), mp.one)
    assert (d - p.y_s) / p.sigma_s > 140
    return d


def equal_particles(row):
    """All particles as large as the mean m (the limit of zero width): at the separation m they bear any load between
    that of elastic contact and their full one, at m + h_e any below; the balance says how much."""
    p = model.interface(row)
    m, h_e = p.mean_ratio * p.particle_diameter, p.h_e_ratio * p.particle_diameter
    largest = mp.ncdf(p.truncation)  # sizes above X_max are left out
    full = mp.pi * p.participation * p.particle_density / (p.H_s1 + p.H_s2) * largest * m**2
    elastic = 9 * mp.pi**2 / 4 * (p.H_s1**2 / p.E_sa**2 + p.H_s2**2 / p.E_ss**2)
    for d, least, most in ((m, elastic, 1), (m + h_e, 0, elastic)):
        L_f = film_share(d, p) if p.viscosity else mp.zero
        summits = p.summits(d, of_area=False) * (1 - p.H_s1 * full)
        A_sa = (p.load * (1 - L_f) - summits) * p.E_ss / p.H_s1
        share = A_sa / (p.H_s2 * full)
        if least < share < most:
            covered = p.H_s1 * full * max(share - elastic, 0) / (1 - elastic)
            A_ss = p.summits(d, of_area=True) * (1 - covered)
            return outputs(p, d, 1 - L_f, L_f, A_sa, A_ss)
    raise ArithmeticError("the load lies on neither step")


def film_share(d, p):
    """L_f of a film that is `d` thick."""
    return p.fluid_load(d) / p.load


def no_particles(row):
    """Particles of no size: the two-body contact."""
    return equations(row | TWO_BODY)


def conditioning(row, d):
    """|d ln d/d ln F_s| at the separation `d`; zero where no solid bears load."""
    p, step = model.interface(row), mp.mpf("1e-12")
    try:
        near, far = (mp.log(p.solid_load(d * factor)) for factor in (1 - step, 1 + step))
    except (ValueError, ZeroDivisionError):
        return mp.zero
    return abs(2 * step / (far - near)) if far != near else mp.zero


# --------------------------------------------------------------------------------------------------------- the extremes
def both(row):
    """The row dry and lubricated."""
    return (("dry", row | {"viscosity": DRY}), ("wet", row | {"viscosity": WET}))


def covered(row, coverage):
    """The row with the particle density that gives a coverage in Eq. 4."""
    one = model.interface(row | {"particle_density": 1.0})
    return row | {"particle_density": float(coverage / model.load_coverage(mp.zero, one))}


def loaded(row, t):
    """The dry row with the load at which the separation is t from the summits' plane, in their deviations."""
    p = model.interface(row)
    return row | {"viscosity": DRY, "load": float(p.solid_load(p.y_s + t * p.sigma_s))}


def lifted(row, t):
    """The lubricated row with the viscosity at which a film alone lies t above the summits' plane."""
    p = model.interface(row)
    target = p.y_s + t * p.sigma_s

    def excess(log_viscosity):
        p.viscosity = mp.exp(log_viscosity)
        return mp.log(p.film(p.load) / target)

    return row | {
        "viscosity": float(mp.exp(model.root(excess, mp.log(mp.mpf("5e-6")), mp.mpf(20))))
    }


def loads():
    """From 1e-12 to the load where dry separation reaches zero, and beyond."""
    for bodies, row in (("two-body", point(**TWO_BODY)), ("three-body", point())):
        for load in (1e-300, 1e-100, 1e-12, 1e-10, 1e-8, 1e-6, 1e-4, 1e-3):
            for medium, wet in both(row | {"load": load}):
                # far below the film's own load no solid is felt
                known = film_alone if medium == "wet" and load < 1e-50 else equations
                yield f"{load:g} {bodies} {medium}", known, wet
        closing = float(model.interface(row).solid_load(mp.zero))
        for below in (1e-1, 1e-2, 1e-4, 1e-6):
            nearly = row | dict(load=closing * (1 - below), viscosity=DRY)
            yield f"{below:g} below closing {bodies}", nearly_closed, nearly
        for factor in (1.1, 10.0, 1e6):
            yield (
                f"{factor:g} of closing {bodies}",
                "load_exceeded",
                row | dict(load=closing * factor, viscosity=DRY),
            )
            yield (
                f"{factor:g} of closing {bodies} wet",
                equations,
                row | dict(load=closing * factor),
            )


def viscosities():
    """Zero, subnormal, 1e-3 cSt and 1e4 cSt, and both sides of the turning point of the film formula."""
    for bodies, row in (("two-body", point(**TWO_BODY)), ("three-body", point())):
        yield f"0 {bodies}", equations, row | {"viscosity": 0.0}
        for viscosity in (5e-324, 1e-310, 1e-30):
            yield f"{viscosity:g} {bodies}", film_alone, row | {"viscosity": viscosity}
        for viscosity in (1e-9, 1e-6, 3e-6, 1e-5, 1e-4):
            yield f"{viscosity:g} {bodies}", equations, row | {"viscosity": viscosity}
        yield f"0.01 {bodies}", equations, row | {"viscosity": 1e-2}


def particle_diameters():
    """From 1e-12 m to 1e-4 m, and exactly 0."""
    sizes = (
        (0.0, 1e11),
        (1e-12, 1e11),
        (1e-10, 1e11),
        (1e-8, 1e11),
        (1e-6, 1e11),
        (1e-5, 1e9),
        (1e-4, 1e7),
    )
    for diameter, density in sizes:
        for medium, row in both(point(particle_diameter=diameter, particle_density=density)):
            yield f"{diameter:g} {medium}", equations, row
    for medium, row in both(point(particle_diameter=1e-200)):
        yield f"1e-200 {medium}", no_particles, row
    for medium, row in both(point(particle_diameter=1e-4)):
        yield f"1e-4 too many {medium}", "coverage_exceeded", row


def roughnesses():
    """From 1 nm to 10 um."""
    for roughness in (1e-9, 1e-8, 1e-6, 1e-5):
        for bodies, changes in (("two-body", TWO_BODY), ("three-body", {})):
            for medium, row in both(point(roughness, **changes)):
                thick = medium == "wet" and bodies == "two-body" and roughness < 1e-8
                yield f"{roughness:g} {bodies} {medium}", film_alone if thick else equations, row


def particle_densities():
    """From 0 to a coverage of 0.999, 1 and above."""
    for medium, row in both(point()):
        yield f"0 {medium}", equations, row | {"particle_density": 0.0}
        yield f"1e-300 {medium}", no_particles, row | {"particle_density": 1e-300}
        for coverage in (0.5, 0.999, 1.0 - 1e-9):
            yield f"coverage {coverage:.10g} {medium}", equations, covered(row, coverage)
        for coverage in (1.0 + 1e-12, 1.5, 1e12):
            yield f"coverage {coverage:.13g} {medium}", "coverage_exceeded", covered(row, coverage)


def plasticities():
    """psi = (E/H) sqrt(sigma_s/R) from 1e-3 to 1e3: purely elastic to purely plastic."""
    here = point()
    present = here["E_ss"] / here["H_s2"] * (here["sigma_s"] / here["R"]) ** 0.5
    for psi in (1e-3, 1e-1, 1e1, 1e3):
        hardness = here["H_s2"] * present / psi
        for bodies, changes in (("two-body", TWO_BODY), ("three-body", dict(particle_density=1e8))):
            load = 1e-5 if psi < 100 else 1e-7  # a softer surface closes earlier
            for medium, row in both(point(H_s1=hardness, H_s2=hardness, load=load, **changes)):
                yield f"psi {psi:g} {bodies} {medium}", equations, row


def separations():
    """d/sigma_s from -3 to 100."""
    deep = point(**OFFSET_LOST, **TWO_BODY)
    for t in (-8, -3, -1):
        yield f"{t} dry", equations, loaded(deep, t)
    for t in (0, 4, 8, 20, 30, 36):
        yield f"{t} dry", equations, loaded(point(**TWO_BODY), t)
    for t in (8, 20, 37, 38.5, 50, 100):
        yield f"{t} wet", equations, lifted(point(**TWO_BODY), t)
        yield f"{t} wet three-body", equations, lifted(point(particle_diameter=1e-7), t)


def fluid_shares():
    """L_f from 1 - 1e-15 to 1e-300."""
    for t in (7.2, 8.9, 9.5, 36):
        yield f"1 - L_f at t = {t}", equations, lifted(point(load=1e-6, **TWO_BODY), t)
    for diameter, viscosity in (
        (1e-4, 1e-3),
        (1e-4, 3e-3),
        (1e2, 1e-2),
        (1e8, 1e-2),
        (1e20, 1e-2),
        (1e43, 1e-2),
    ):
        # so large a particle that no film has its height: beyond nature, within the equations
        row = point(
            10e-9, particle_diameter=diameter, particle_density=4.5 / diameter**2, load=1e-6
        )
        yield f"x_a {diameter:g}, {viscosity:g}", vanishing_film, row | {"viscosity": viscosity}


def materials():
    """H_s1 and H_s2, E_sa and E_ss far apart."""
    changes = (
        dict(H_s1=1e9, H_s2=2e10), dict(H_s1=2e10, H_s2=1e9), dict(E_sa=1e13), dict(E_sa=5e10),
        dict(H_s1=3e9, H_s2=7e9, E_sa=2e11, E_ss=5e10), dict(H_s1=1e6, H_s2=1e10), dict(H_s1=1e11, H_s2=1e9, E_sa=1e12),
    )  # fmt: skip
    for change in changes:
        name = ", ".join(f"{symbol} {value:g}" for symbol, value in change.items())
        for medium, row in both(point(load=1e-6, **change)):
            yield f"{name} {medium}", equations, row


def widths():
    """phi_a ever narrower, and of no width: the limit of equal particles."""
    for ratio in (1e-1, 1e-2, 1e-4, 1e-6, 1e-9):
        for medium, row in both(
            point(phi_a="centred", sigma_a_ratio=ratio, mean_ratio=1.0, particle_diameter=1.2e-6)
        ):
            yield f"{ratio:g} {medium}", equations, row
    for medium, row in both(point(phi_a="centred", particle_diameter=1.2e-6, **EQUAL)):
        for load in (1e-5, 1e-4):
            yield f"0 {load:g} {medium}", equal_particles, row | {"load": load}
        yield f"0 uncentred {medium}", no_particles, row | {"phi_a": "uncentred"}
    gap = point(
        phi_a="gap_convolved",
        sigma_a_ratio=0.0,
        mean_ratio=1.0,
        gap_ratio=1.15,
        particle_density=1e10,
    )
    for medium, row in both(gap):
        yield f"0 gap_convolved {medium}", equations, row


def truncations():
    """X_max at 0.5 and 10 spreads, also where the largest particles just touch."""
    for truncation in (0.5, 10.0):
        for phi_a in ("uncentred", "centred", "gap_convolved"):
            density = 1e10 if phi_a == "gap_convolved" else 1e11
            for load in (1e-9, 1e-5):
                for medium, row in both(
                    point(phi_a=phi_a, truncation=truncation, load=load, particle_density=density)
                ):
                    yield f"{truncation:g} {phi_a} {load:g} {medium}", equations, row


def plastic_ratios():
    """omega_2/omega_1 down to 1."""
    for excess in (0.0, 1e-15, 1e-9, 1e-3, 1.0, 1e4):
        for load in (1e-6, 1e-3):
            row = point(omega_ratio=1.0 + excess, load=load, viscosity=DRY, **TWO_BODY)
            yield f"1 + {excess:g} {load:g}", equations, row


def ellipticities():
    """kappa from 0.1 to 10."""
    for kappa in (0.1, 0.3, 3.0, 10.0):
        for load in (1e-7, 1e-4):
            yield f"{kappa:g} {load:g}", equations, point(kappa=kappa, load=load)


def soft_particles():
    """Elastic particles that press more than plastic ones, so that several separations balance some of the loads."""
    for limits in ("printed", "physical"):
        soft = point(100e-9, E_sa=5e9, h_e_ratio=0.5, elastic_limits=limits)
        for load in (2e-5, 1e-4, 1.8e-4, 5e-4):
            for medium, row in both(soft | {"load": load}):
                yield f"{limits} {load:g} {medium}", equations, row


def wide_areas():
    """Soft surfaces, whose summits would have more area than there is."""
    soft = point(H_s1=1e6, H_s2=1e6, **TWO_BODY)
    for load in (1e-6, 9e-6, 1.05e-5, 1.2e-5, 1.4e-5):
        for medium, row in both(soft | {"load": load}):
            yield f"{load:g} {medium}", equations, row


ITEMS = dict(
    load=loads, viscosity=viscosities, particle_diameter=particle_diameters, roughness=roughnesses,
    particle_density=particle_densities, plasticity=plasticities, separation=separations, fluid_share=fluid_shares,
    materials=materials, width_of_sizes=widths, truncation=truncations, plastic_ratio=plastic_ratios,
    ellipticity=ellipticities, soft_particles=soft_particles, area=wide_areas,
)  # fmt: skip


def solved(item, case, known, row):
    """The cells of a row; `known` is how its solution is known, or the status of one that has none."""
    leading = dict(item=item, case=case, origin="argument", status=known, gap_conditioning="")
    values = dict.fromkeys(model.OUTPUTS, "")
    if callable(known):
        values = known(row)
        leading["origin"] = known.__name__
        leading["gap_conditioning"] = mp.nstr(conditioning(row, values["separation"]), 3)
    cells = leading | row | values  # whose status is that of the solution
    return [text(cells[column]) for column in COLUMNS]


def main():
    """Solve all rows and write the product."""
    mp.dps = DIGITS
    rows = []
    for item, cases in ITEMS.items():
        for case, known, row in cases():
            try:
                rows.append(solved(item, case, known, row))
            except (ArithmeticError, AssertionError, ValueError) as error:
                raise ArithmeticError(f"{item}: {case}: {error!r}") from error
        print(f"{item}: {len(rows)} rows", file=sys.stderr, flush=True)
    with PRODUCT.open("w", newline="") as file:
        writer = csv.writer(file, lineterminator="\n")
        writer.writerow(COLUMNS)
        writer.writerows(rows)


if __name__ == "__main__":
    main()
