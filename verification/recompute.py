"""A dataset against the plain model: every point at its own separation, and some solved anew."""

import json
import math
import sys
from typing import NamedTuple

import netCDF4
import numpy as np
import plain_model

DIMENSIONS = ("load", "viscosity", "particle_diameter", "roughness", "particle_density")
QUANTITIES = (
    "total_contact_area",
    "particle_contact_area_ratio",
    "surface_contact_area_ratio",
    "solid_load_fraction",
    "fluid_load_fraction",
    "separation",
    "film_thickness",
)
BOUND = "error_bound"  # of the numbers of a point
COUNT = "separation_count"  # where a point has several
FLAGS = ("lubrication_regime", "contact_mode", "solution_status")
NOT_SHOWN = "not_shown"  # what a flag says of a combination that a figure does not show
SUMMITS = ("eta_s", "R", "sigma_s", "y_s")  # of the model, along the roughness
UNSOLVED = ("coverage_exceeded", "load_exceeded")  # Eq. 1 holds nowhere
UNSEEN = (*UNSOLVED, "several_separations", "not_converged")  # not to be told from the values
ROUNDING = 1e-14  # of sums and products of stored numbers
EVALUATION = 1e-9  # of what follows from the stored separation by evaluating Eqs. 4, 5 and 7
SOLUTION = 1e-8  # of what the solver found, unless the dataset asked for less


class Dataset(NamedTuple):
    """What a file holds: its model, its values as stored and the indices of its points."""

    model: dict
    axes: dict  # coordinates, 1-D
    values: dict  # quantities and names of flags, 5-D
    points: list  # index tuples
    rtol: float
    tolerance: float


class Outcome(NamedTuple):
    """What a check found: ``findings`` say what is wrong; worst deviations [1] and counts."""

    findings: list
    evaluated: int
    solved: int
    worst: float


def read(path):
    """The ``Dataset`` in the file ``path``; ``ValueError`` says what is missing or odd."""
    with netCDF4.Dataset(path) as file:
        file.set_auto_maskandscale(False)
        for name in (*DIMENSIONS, "normal_load", *QUANTITIES, BOUND, *FLAGS):
            if name not in file.variables:
                raise ValueError(f"has no variable {name}")
        axes = {name: file[name][:] for name in (*DIMENSIONS, "normal_load")}
        values = {name: file[name][:] for name in (*QUANTITIES, BOUND)}
        shown = {name: values[name] != fill(file[name]) for name in values}
        values |= {name: flag_names(file[name]) for name in FLAGS}
        shown |= {name: values[name] != NOT_SHOWN for name in FLAGS}
        if COUNT in file.variables:
            values[COUNT] = file[COUNT][:]
        model = json.loads(file.model_parameters)
        rtol = float(file.rtol)
    first = shown["separation"]
    if any((other != first).any() for other in shown.values()) or (first != first[:1]).any():
        raise ValueError("leaves out single points")
    return Dataset(
        model, axes, values, list(map(tuple, np.argwhere(first))), rtol, max(SOLUTION, 10.0 * rtol)
    )


def fill(variable):
    """The value that marks combinations which a figure does not show; nan where there are none."""
    return variable.getncattr("_FillValue") if "_FillValue" in variable.ncattrs() else math.nan


def flag_names(variable):
    """Names of the flags, by the variable's own ``flag_meanings``."""
    meanings = dict(zip(variable.flag_values.tolist(), variable.flag_meanings.split()))
    return np.vectorize(lambda value: meanings.get(value, "unknown"), otypes=[object])(variable[:])


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
    yield "balance of the loads", abs(balance), data.tolerance
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


def misnamed(row, point, data):
    """Names of the flags that do not agree with the numbers beside them."""
    regime = plain_model.lubrication_regime(row["solid_load_fraction"])
    mode = plain_model.contact_mode(row["particle_contact_area_ratio"], point.two_body)
    status = plain_model.named_status(
        row["total_contact_area"], row["fluid_load_fraction"], 1, data.model, point
    )
    expected = {
        "lubrication_regime": {regime},
        "contact_mode": {mode},
        "solution_status": {status} if row[BOUND] <= data.rtol else {"not_converged"},
    }
    if "converged" in expected["solution_status"]:
        expected["solution_status"].add("several_separations")
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
    if row[COUNT] not in (None, solution.count):
        yield f"{COUNT} (here {solution.count})", math.inf, 0.0
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
        yield name, deviation(row[name], expected), data.tolerance


def surface_findings(data):
    """What is wrong between each roughness and its summits in the model."""
    summits = zip(*(data.model[name] for name in SUMMITS))
    for sigma, (density, radius, spread, offset) in zip(data.axes["roughness"], summits):
        # summits above the mean plane scatter less than the surface, or as widely (one sigma)
        known = spread, plain_model.surface_roughness(density, radius, spread, offset)
        if min(deviation(sigma, each) for each in known) > EVALUATION:
            yield f"roughness {sigma:.6g} m is not that of the summits"
        if offset and deviation(offset, plain_model.summit_plane(density, radius)) > EVALUATION:
            yield f"y_s at roughness {sigma:.6g} m is not that of the summits"


def check(path, count, rng):
    """The ``Outcome`` for the dataset ``path``: all points evaluated, ``count`` of them solved."""
    data = read(path)
    newtons = data.axes["load"] * data.model["A_n"] * data.model["E_ss"]
    findings = list(surface_findings(data))
    if any(deviation(*pair) > ROUNDING for pair in zip(data.axes["normal_load"], newtons)):
        findings.append("normal_load is not load A_n E_ss")
    sample = set(rng.sample(data.points, min(count, len(data.points))))
    worst = 0.0
    for index in data.points:
        row = {COUNT: None} | {name: data.values[name].item(index) for name in data.values}
        point = point_at(data, index)
        where = f"at {','.join(map(str, map(int, index)))}"
        anew = index in sample or row["solution_status"] in UNSEEN
        measured = list(solved(row, point, data)) if anew else []
        worst = max([worst, *(found for _, found, _ in measured)])
        if without_values(row):
            findings += [f"{n} {where} has a value" for n in QUANTITIES if not math.isnan(row[n])]
        else:
            measured += evaluated(row, point, data)
            findings += [f"{name} {where} is misnamed" for name in misnamed(row, point, data)]
        findings += [
            f"{name} {where} is off by {by:.1e}" for name, by, most in measured if by > most
        ]
    return Outcome(findings, len(data.points), len(sample), worst)
