"""A dataset against the plain model: every point at its own separation, and some solved anew."""

import json
import math
import resource
import sys
from contextlib import contextmanager
from typing import NamedTuple

import contract
import netCDF4
import numpy as np
import plain_model
from contract import DIMENSIONS

BOUND = "error_bound"  # of the numbers of a point
QUANTITIES = tuple(name for name in contract.NUMBERS if name != BOUND)
NOT_SHOWN = "not_shown"  # the flag of a combination that no figure shows
SUMMITS = ("eta_s", "R", "sigma_s", "y_s")  # inputs with a value for each roughness
UNSOLVED = ("coverage_exceeded", "load_exceeded")  # Eq. 1 has no solution: a point has no values
UNRESOLVED = "not_converged"  # float64 does not hold the digits that were asked for
ROUNDING = 1e-14  # of sums and products of stored numbers
EVALUATION = 1e-9  # error of this program in Eqs. 4, 5 and 7 at a stored separation
SOLUTION = 1e-8  # error of a solution by this program, where float64 resolves it
INTEGRALS = 1e-11  # error of its forces, which counts where float64 does not
FLOAT64 = 1e-15  # relative noise of forces in float64, for each unit of their logarithms
LARGEST_LOGARITHM = 745.0  # of a number in float64
MARGIN = 100.0  # ratio of what two programs may take for the noise of one point
LARGEST_FILE = 100 * contract.MOST_POINTS  # bytes: twelve numbers a point, not compressed
LEAST_BOUND = 1e-14  # least honest bound: solvers hold loads as logarithms of up to 30


class Dataset(NamedTuple):
    """What a file holds: its inputs of the model, its axes and its values as stored."""

    model: dict
    axes: dict  # coordinates, 1-D
    values: dict  # quantities and names of flags, 5-D
    shown: np.ndarray  # which combinations are shown, 5-D
    title: str
    rtol: float
    identity: tuple  # attributes configuration_sha256 and id


class Outcome(NamedTuple):
    """What a check found: what is wrong (``findings``), counts of points, the worst deviation [1],
    and the ``rtol`` [1] asked for.  Only a file that ``has_form`` may be read further."""

    findings: list
    evaluated: int = 0
    solved: int = 0
    worst: float = 0.0
    rtol: float = 0.0
    has_form: bool = True


@contextmanager
def opened(path):
    """The dataset ``path``.  Meanwhile this process can open no other file: a link to numbers or
    filters elsewhere is an error.  Only POSIX systems have such a limit."""
    content = path.read_bytes()
    soft, hard = resource.getrlimit(resource.RLIMIT_NOFILE)
    resource.setrlimit(resource.RLIMIT_NOFILE, (0, hard))
    try:
        with netCDF4.Dataset(path.name, memory=content) as file:
            yield file
    finally:
        resource.setrlimit(resource.RLIMIT_NOFILE, (soft, hard))


def read(file):
    """The ``Dataset`` in an open file of the expected form."""
    file.set_auto_maskandscale(False)
    axes = {name: file[name][:] for name in contract.COORDINATES}
    values = {name: file[name][:] for name in contract.NUMBERS}
    shown = {name: values[name] != contract.FILL_VALUE for name in values}
    values |= {name: flag_names(name, file[name][:]) for name in contract.FLAGS}
    shown |= {name: values[name] != NOT_SHOWN for name in contract.FLAGS}
    first = shown["separation"]
    if any((other != first).any() for other in shown.values()):
        raise ValueError("some variables leave out points that others show")
    return Dataset(
        model=json.loads(file.model_parameters),
        axes=axes,
        values=values,
        shown=first,
        title=file.title,
        rtol=float(file.rtol),
        identity=(file.configuration_sha256, file.id),
    )


def flag_names(name, values):
    """Names of the flag values of the variable ``name``."""
    meanings = contract.FLAGS[name][2]
    return np.vectorize(lambda value: meanings.get(value, "unknown"), otypes=[object])(values)


def point_at(data, index):
    """The ``plain_model.Point`` at ``index``."""
    place = dict(zip(DIMENSIONS, index))
    conditions = (float(data.axes[name][place[name]]) for name in DIMENSIONS)
    surface = (data.model[name][place["roughness"]] for name in SUMMITS)
    return plain_model.Point(*conditions, *surface)


def deviation(first, second):
    """Difference of two numbers over the larger; 0 if float64 holds neither in full."""
    larger = max(abs(first), abs(second))
    if first == second or larger < sys.float_info.min:
        return 0.0
    difference = abs(first - second) / larger
    return difference if difference >= 0.0 else math.inf  # nan


class Own(NamedTuple):
    """The solution of a point by this program, from the inputs alone, and its relative errors."""

    solution: plain_model.Solution
    uncertainty: float  # by which it and the library may differ because of rounding
    noise: float  # the part that comes from float64, not from the integrals here


def solve(point, model):
    """``Own`` solution of a point."""
    solution = plain_model.solve(model, point)
    if solution.state is None:
        return Own(solution, 0.0, 0.0)
    of_forces = FLOAT64 * (1.0 + min(abs(solution.state.log_solid_load), LARGEST_LOGARITHM))
    noise, uncertainty = (
        plain_model.uncertainty(solution.separation, model, point, relative)
        for relative in (of_forces, INTEGRALS + of_forces)
    )
    return Own(solution, MARGIN * uncertainty, noise)


def area_ratios(state, point):
    """Names and values of the shares of the contact area that float64 holds in full."""
    least = sys.float_info.min
    for name, share in (
        ("particle_contact_area_ratio", state.particle_ratio),
        ("surface_contact_area_ratio", state.summit_ratio),
    ):
        area = state.total_area * (share if share > 0.0 else 1.0)
        if point.two_body or area >= least:
            yield name, share


def evaluated(row, point, data, tolerance):
    """Names, deviations and tolerances of all that must hold at the stored separation."""
    d, model = row["separation"], data.model
    there = plain_model.state(d, model, point)
    solid, fluid = row["solid_load_fraction"], row["fluid_load_fraction"]
    borne = math.exp(min(there.log_solid_load - math.log(point.load), 1.0))
    share = row["particle_contact_area_ratio"] + row["surface_contact_area_ratio"]
    yield "film_thickness", deviation(row["film_thickness"] * model["R_x"], d), ROUNDING
    yield "solid_load_fraction + fluid_load_fraction", deviation(solid + fluid, 1.0), ROUNDING
    yield "sum of the contact area ratios", deviation(share, 1.0), ROUNDING
    yield "balance of the loads", deviation(solid, borne), tolerance
    yield "coverage beyond the whole interface", max(there.coverage - 1.0, 0.0), 0.0
    for name, expected in (("total_contact_area", there.total_area), *area_ratios(there, point)):
        yield name, deviation(row[name], expected), tolerance
    if point.dry:
        yield "dry fluid_load_fraction", deviation(fluid, 0.0), 0.0
    elif fluid > 0.0:
        log_load = plain_model.log_load_in_w(math.log(fluid), model, point)
        film = plain_model.film_separation(log_load, model, point)
        yield "separation by the film", deviation(d, film), tolerance
    else:
        yield "negative fluid_load_fraction", -fluid, 0.0
        yield "film without load", hidden_film(d, model, point), tolerance


def hidden_film(separation, model, point):
    """L_f [1] of a film at ``separation`` d [m] that is stored as 0, or its excess over d [1]."""
    if plain_model.bears_fluid_share(model, point):
        fluid = math.exp(plain_model.log_film_load(separation, model, point) - math.log(point.load))
        return deviation(0.0, fluid)
    film = plain_model.film_separation(math.log(point.load), model, point)
    return max(film / separation - 1.0, 0.0) if separation > 0.0 else math.inf


def misnamed(row, point, data):
    """Names of the flags that do not agree with the numbers beside them."""
    regime = plain_model.lubrication_regime(row["solid_load_fraction"])
    mode = plain_model.contact_mode(row["particle_contact_area_ratio"], point.two_body)
    numbers = (row[n] for n in ("total_contact_area", "fluid_load_fraction", "film_thickness"))
    status = plain_model.named_status(*numbers, data.model, point)
    expected = {
        "lubrication_regime": regime,
        "contact_mode": mode,
        "solution_status": status if row[BOUND] <= data.rtol else UNRESOLVED,
    }
    return [name for name, meaning in expected.items() if row[name] != meaning]


def another_status(status, own, rtol):
    """The status that a point should have; None if ``status`` may be right.

    This compares whether the point has values, and whether ``rtol`` is reached.  ``misnamed`` says
    which status belongs to values.
    """
    if own.solution.state is None:
        return own.solution.status if status != own.solution.status else None
    if status in UNSOLVED:
        return own.solution.status
    if status == UNRESOLVED:
        return own.solution.status if MARGIN * own.noise < rtol else None
    return UNRESOLVED if own.noise > MARGIN * rtol else None


def solved(row, own, point, data, tolerance):
    """Names, deviations and tolerances against the ``own`` solution."""
    solution = own.solution
    for name, expected in (
        ("total_contact_area", solution.state.total_area),
        *area_ratios(solution.state, point),
        ("solid_load_fraction", solution.solid_fraction),
        ("fluid_load_fraction", solution.fluid_fraction),
        ("separation", solution.separation),
        ("film_thickness", solution.separation / data.model["R_x"]),
    ):
        yield name, deviation(row[name], expected), tolerance


def check(path, config, inputs, count, rng):
    """The ``Outcome`` for the dataset ``path``: all points evaluated, ``count`` of them solved."""
    if path.stat().st_size > LARGEST_FILE:
        return Outcome([f"is larger than {LARGEST_FILE} bytes"], has_form=False)
    with opened(path) as file:
        findings = list(contract.form_findings(file))
        if findings:
            return Outcome(findings, has_form=False)
        data = read(file)
    findings = list(contract.configuration_findings(data, path.stem, config, inputs))
    if findings:
        return Outcome(findings)
    newtons = data.axes["load"] * data.model["A_n"] * data.model["E_ss"]
    if any(deviation(*pair) > ROUNDING for pair in zip(data.axes["normal_load"], newtons)):
        findings.append("normal_load is not load A_n E_ss")
    points = list(map(tuple, np.argwhere(data.shown)))
    sample = set(rng.sample(points, min(count, len(points))))
    worst = 0.0
    for index in points:
        found, by = point_findings(data, index, index in sample)
        findings += found
        worst = max(worst, by)
    return Outcome(findings, len(points), len(sample), worst, data.rtol)


def point_findings(data, index, is_sampled):
    """What is wrong at one point, and its largest deviation from the solution of this program.

    The deviation is 0 for a point that float64 does not resolve.
    """
    row = {name: data.values[name].item(index) for name in data.values}
    point, status = point_at(data, index), row["solution_status"]
    where = f"at {','.join(map(str, map(int, index)))}"
    uncertainty, measured, worst = 0.0, [], 0.0
    if is_sampled or status in (*UNSOLVED, UNRESOLVED):  # such a status is not seen in values
        own = solve(point, data.model)
        expected = another_status(status, own, data.rtol)
        if expected:
            return [f"solution_status {where} is {status}, here {expected}"], 0.0
        uncertainty = own.uncertainty if status == UNRESOLVED else 0.0
    if status in UNSOLVED:
        numbers = (*QUANTITIES, BOUND)
        return [f"{n} {where} has a value" for n in numbers if not math.isnan(row[n])], 0.0
    if is_sampled or status == UNRESOLVED:
        promised = data.rtol if status == UNRESOLVED else row[BOUND]
        measured += solved(row, own, point, data, promised + SOLUTION + uncertainty)
    if status != UNRESOLVED:
        worst = max((by for _, by, _ in measured), default=0.0)
    # the separation and the value that follows from it are each within rtol
    measured += evaluated(row, point, data, 2.0 * data.rtol + EVALUATION + uncertainty)
    findings = [f"{name} {where} is misnamed" for name in misnamed(row, point, data)]
    if row[BOUND] < LEAST_BOUND:
        findings.append(f"error_bound {where} is smaller than rounding allows")
    findings += [f"{name} {where} is off by {by:.1e}" for name, by, most in measured if by > most]
    return findings, worst
