"""A dataset against the plain model: every point at its own separation, and some solved anew."""

import json
import math
import sys
from typing import NamedTuple

import contract
import netCDF4
import numpy as np
import plain_model
from contract import DIMENSIONS

BOUND = "error_bound"  # of the numbers of a point
QUANTITIES = tuple(name for name in contract.NUMBERS if name != BOUND)
NOT_SHOWN = "not_shown"  # what a flag says of a combination that a figure does not show
SUMMITS = ("eta_s", "R", "sigma_s", "y_s")  # of the model, along the roughness
UNSOLVED = ("coverage_exceeded", "load_exceeded")  # Eq. 1 holds nowhere
UNSEEN = (*UNSOLVED, "not_converged")  # values do not show these
ROUNDING = 1e-14  # of sums and products of stored numbers
EVALUATION = 1e-9  # of what follows from the stored separation by evaluating Eqs. 4, 5 and 7
SOLUTION = 1e-8  # of what the solver found, beyond its own error_bound
LEAST_BOUND = 1e-14  # loads are known as logarithms of up to 30: no float64 solver promises less


class Dataset(NamedTuple):
    """What a file holds: its inputs of the model, its axes and its values as stored."""

    model: dict
    axes: dict  # coordinates, 1-D
    values: dict  # quantities and names of flags, 5-D
    shown: np.ndarray  # which combinations are shown, 5-D
    title: str
    rtol: float


class Outcome(NamedTuple):
    """What a check found: ``findings`` say what is wrong; worst deviations [1] and counts."""

    findings: list
    evaluated: int
    solved: int
    worst: float


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
        json.loads(file.model_parameters), axes, values, first, file.title, float(file.rtol)
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


def deviation(found, expected):
    """Relative difference; numbers too small for float64's full precision count as zero."""
    if found == expected or max(abs(found), abs(expected)) < sys.float_info.min:
        return 0.0
    difference = abs(found - expected) / max(abs(expected), sys.float_info.min)
    return difference if difference >= 0.0 else math.inf  # nan


def evaluated(row, point, data):
    """Names, deviations and tolerances of everything that must hold at the stored separation."""
    d, model = row["separation"], data.model
    there = plain_model.state(d, model, point)
    solid, fluid = row["solid_load_fraction"], row["fluid_load_fraction"]
    balance = there.log_solid_load - math.log(point.load) - plain_model.logarithm(solid)
    share = row["particle_contact_area_ratio"] + row["surface_contact_area_ratio"]
    yield "film_thickness", deviation(row["film_thickness"] * model["R_x"], d), ROUNDING
    yield "solid_load_fraction + fluid_load_fraction", deviation(solid + fluid, 1.0), ROUNDING
    yield "sum of the contact area ratios", deviation(share, 1.0), ROUNDING
    yield "balance of the loads", abs(balance), tolerance(row)
    yield "coverage beyond the whole interface", max(there.coverage - 1.0, 0.0), 0.0
    for name, expected in (
        ("total_contact_area", there.total_area),
        ("particle_contact_area_ratio", there.particle_ratio),
        ("surface_contact_area_ratio", there.summit_ratio),
    ):
        yield name, deviation(row[name], expected), EVALUATION
    if point.dry:
        yield "dry fluid_load_fraction", deviation(fluid, 0.0), 0.0
    elif fluid > 0.0:
        log_load = plain_model.log_load_in_w(math.log(fluid), model, point)
        film = plain_model.film_separation(log_load, model, point)
        yield "separation by the film", deviation(d, film), EVALUATION
    else:
        yield "negative fluid_load_fraction", -fluid, 0.0
        yield "film without load", hidden_film(d, model, point), EVALUATION


def hidden_film(separation, model, point):
    """What a film with L_f = 0 would carry at ``separation`` d [m], or how far it exceeds d [1]."""
    if plain_model.bears_fluid_share(model, point):
        fluid = math.exp(plain_model.log_film_load(separation, model, point) - math.log(point.load))
        return deviation(0.0, fluid)
    film = plain_model.film_separation(math.log(point.load), model, point)
    return max(film / separation - 1.0, 0.0) if separation > 0.0 else math.inf


def tolerance(row):
    """Of numbers that the solver found: no error is larger than the point's ``error_bound``."""
    return SOLUTION + (row[BOUND] if math.isfinite(row[BOUND]) else 0.0)


def misnamed(row, point, data):
    """Names of the flags that do not agree with the numbers beside them."""
    regime = plain_model.lubrication_regime(row["solid_load_fraction"])
    mode = plain_model.contact_mode(row["particle_contact_area_ratio"], point.two_body)
    status = plain_model.named_status(
        row["total_contact_area"], row["fluid_load_fraction"], data.model, point
    )
    expected = {
        "lubrication_regime": {regime},
        "contact_mode": {mode},
        "solution_status": {status} if row[BOUND] <= data.rtol else {"not_converged"},
    }
    return [name for name, meanings in expected.items() if row[name] not in meanings]


def without_values(row):
    """Whether a point has no values, or none that float64 can hold."""
    missing = row["solution_status"] == "not_converged" and math.isnan(row["separation"])
    return missing or row["solution_status"] in UNSOLVED


def solved(row, point, data):
    """Names, deviations and tolerances against a solution that starts from the inputs alone."""
    solution = plain_model.solve(data.model, point)
    agrees = row["solution_status"] == solution.status
    if not agrees and (row["solution_status"] != "not_converged" or solution.state is None):
        yield f"solution_status (here {solution.status})", math.inf, 0.0
        return
    if without_values(row):
        return
    for name, expected in (
        ("total_contact_area", solution.state.total_area),
        ("particle_contact_area_ratio", solution.state.particle_ratio),
        ("surface_contact_area_ratio", solution.state.summit_ratio),
        ("solid_load_fraction", solution.solid_fraction),
        ("fluid_load_fraction", solution.fluid_fraction),
        ("separation", solution.separation),
        ("film_thickness", solution.separation / data.model["R_x"]),
    ):
        yield name, deviation(row[name], expected), tolerance(row)


def check(path, config, inputs, count, rng):
    """The ``Outcome`` for the dataset ``path``: all points evaluated, ``count`` of them solved."""
    with netCDF4.Dataset(path) as file:
        findings = list(contract.form_findings(file))
        if findings:
            return Outcome(findings, 0, 0, 0.0)
        data = read(file)
    findings = list(contract.configuration_findings(data, path.stem, config, inputs))
    if findings:
        return Outcome(findings, 0, 0, 0.0)
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
    return Outcome(findings, len(points), len(sample), worst)


def point_findings(data, index, is_sampled):
    """What is wrong at one point, and the largest deviation from the plain solution."""
    row = {name: data.values[name].item(index) for name in data.values}
    point = point_at(data, index)
    where = f"at {','.join(map(str, map(int, index)))}"
    anew = is_sampled or row["solution_status"] in UNSEEN
    measured = list(solved(row, point, data)) if anew else []
    worst = max((by for _, by, _ in measured), default=0.0)
    findings = []
    if without_values(row):
        numbers = (*QUANTITIES, BOUND)
        findings += [f"{n} {where} has a value" for n in numbers if not math.isnan(row[n])]
    else:
        measured += evaluated(row, point, data)
        findings += [f"{name} {where} is misnamed" for name in misnamed(row, point, data)]
        if row[BOUND] < LEAST_BOUND:
            findings.append(f"error_bound {where} is smaller than rounding allows")
    findings += [f"{name} {where} is off by {by:.1e}" for name, by, most in measured if by > most]
    return findings, worst
