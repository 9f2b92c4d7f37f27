"""The page's script gives the library's numbers: it is run in the browser at random points."""

import itertools
from dataclasses import replace

import numpy as np
import pytest

from chenhorng.home import config_directory
from chenhorng.tables import TABLES, read_csv
from thirdbody.core.parameters import BOUNDS, WORDS
from thirdbody.core.solve import DEFAULT_RTOL
from thirdbody.files import read_yaml
from thirdbody.points import solve
from thirdbody.variables import CONDITION_AXES, QUANTITIES

POINTS = 1000
RTOL = 1e-6
TINY = 1e-300  # smaller numbers are no numbers in float64 any more
NEWTONS = 0.04, 80.0
SOLVED_IN_THE_PAGE = """
return arguments[0].map(([inputs, condition, load]) => {
  const found = thirdbody.solve(inputs, condition, load);
  return [found.status, found.regime, found.mode,
    ...arguments[1].map((name) => Number.isNaN(found[name]) ? null : String(found[name]))];
});
"""


def random_inputs(random, changes, defaults):
    """Inputs within the bounds of the search for them, but with these ``changes``."""
    unknowns = read_yaml(config_directory() / "calibration.yaml")["unknowns"]
    searched = {name: unknown["bounds"] for name, unknown in unknowns.items()}
    # with a search that goes beyond what the library takes
    bounds = {name: (max(low, BOUNDS[name].least), high) for name, (low, high) in searched.items()}
    drawn = {
        name: float(np.exp(random.uniform(*np.log(ends))))
        if ends[0] > 0.0
        else random.uniform(*ends)
        for name, ends in bounds.items()
    }
    return replace(defaults.best, **drawn | changes)


def random_conditions(random):
    """Conditions over the paper's ranges; a third is dry, and some have no particles."""
    return {
        "viscosity": random.choice([0.0, 1.0, 1.0]) * random.uniform(0.0, 150e-6),
        "particle_diameter": random.choice([0.0, *[1.0] * 9]) * random.uniform(0.0, 1000e-9),
        "roughness": random.uniform(100e-9, 500e-9),
        "particle_density": float(np.exp(random.uniform(*np.log([1e10, 5e12])))),
    }


def has_summits(inputs, roughness):
    """Whether the inputs leave a variance to the summits; the library refuses others."""
    try:
        inputs.surface(roughness)
    except ValueError:
        return False
    return True


@pytest.fixture(scope="module")
def points(defaults):
    """Inputs, conditions and loads, every combination of words in turn, without and with a mean of
    the sizes.
    """
    random = np.random.default_rng(20240507)
    combinations = itertools.cycle(itertools.product((False, True), *WORDS.values()))
    found = []
    while len(found) < POINTS:
        has_mean, *words = next(combinations)
        changes = dict(zip(WORDS, words, strict=True))
        changes["mean_ratio"] = has_mean * random.uniform(0.0, 1.3)
        inputs = random_inputs(random, changes, defaults)
        conditions = random_conditions(random)
        load = float(np.exp(random.uniform(*np.log(NEWTONS)))) / inputs.newtons_per_load
        if not has_summits(inputs, conditions["roughness"]):
            continue
        found.append((inputs, conditions, load))
    return found


def solved_by_the_library(inputs, conditions, load):
    """Status, regime, mode and variables of a point."""
    solution = solve(load=load, **conditions, parameters=inputs, rtol=DEFAULT_RTOL)
    flags = solution.solution_status, solution.lubrication_regime, solution.contact_mode
    values = [float(getattr(solution, name)) for name in QUANTITIES]
    return str(flags[0]), int(flags[1]), int(flags[2]), *values


def solved_by_the_page(explorer, points, names=(*QUANTITIES,)):
    """The same of the page's own script, in the browser."""
    asked = [(inputs.as_dict(), conditions, load) for inputs, conditions, load in points]
    rows = explorer.open().run(SOLVED_IN_THE_PAGE, asked, names)
    return [
        (*row[:3], *(np.nan if value is None else float(value) for value in row[3:]))
        for row in rows
    ]


@pytest.mark.filterwarnings("ignore::thirdbody.OutOfRangeWarning")
def test_every_variable_status_regime_and_mode_is_the_librarys(points, explorer, tell):
    expected = [solved_by_the_library(*point) for point in points]
    found = solved_by_the_page(explorer, points)
    assert [row[:3] for row in found] == [row[:3] for row in expected]
    assert len({status for status, *_ in expected}) > 1
    library, page = (np.array([row[3:] for row in rows]) for rows in (expected, found))
    assert (np.isnan(library) == np.isnan(page)).all()
    error = np.abs(page - library) / np.maximum(np.abs(library), TINY)
    tell(f"explorer: {POINTS} points, largest relative error {np.nanmax(error):.1e}")
    worst = np.unravel_index(np.nanargmax(error), error.shape)
    assert np.nanmax(error) <= RTOL, ([*QUANTITIES][worst[1]], points[worst[0]])


# inputs, conditions and loads at which each status is met beside others
SOFT = {"hardness_surface_1": 1e6, "hardness_surface_2": 1e6}
DRY = {"viscosity": 0.0}
CROWDED = DRY | {"particle_density": 1e14, "particle_diameter": 1e-6}
EXTREMES = {
    "load_exceeded": ({}, DRY | {"particle_diameter": 0.0}, (1e-5, 1.0)),
    "outside_film_formula": ({}, {"viscosity": 1e-7}, (1e-8, 1e-4)),
    "outside_film_formula by load": ({}, {}, (1e-3, 1e10)),
    "outside_film_formula by total load": ({"film_load": "total"}, {}, (1e-3, 1e10)),
    "area_exceeded": (SOFT, DRY | {"particle_diameter": 0.0}, (1e-6, 1e-5)),
    "coverage_exceeded": ({}, CROWDED, (1e-7, 1e-4)),
}


@pytest.mark.parametrize("status", EXTREMES)
@pytest.mark.filterwarnings("ignore::thirdbody.OutOfRangeWarning")
def test_each_status_is_that_of_both(explorer, parameters, status):
    changed, conditions, loads = EXTREMES[status]
    inputs = replace(parameters, **changed)
    usual = dict(viscosity=9e-5, particle_diameter=5e-7, roughness=3e-7, particle_density=1e11)
    point = usual | conditions
    loads = np.geomspace(*loads, 60)
    library = solve(load=loads, **point, parameters=inputs)
    expected = [*library.solution_status]
    assert status.split()[0] in expected
    points = [(inputs, point, load) for load in loads.tolist()]
    found = solved_by_the_page(explorer, points, ["separation"])
    assert [row[0] for row in found] == expected
    separation = [row[-1] for row in found]
    np.testing.assert_allclose(separation, library.separation, rtol=RTOL)


def test_turning_points_are_the_librarys(explorer, page, defaults):
    """Those of all figures, as the workflow's table has them; curves without one have none."""
    rows = read_csv(page.parents[1] / "tables" / "tpca_loads.csv", TABLES["tpca_loads"])
    conditions = [{axis.name: row[axis.column] for axis in CONDITION_AXES} for row in rows]
    bare = dict(viscosity=0.0, particle_diameter=2e-7, roughness=3e-7, particle_density=1e11)
    script = "return arguments[1].map((each) => thirdbody.turningPoint(arguments[0], each))"
    *found, none = explorer.open().run(script, defaults.best.as_dict(), [*conditions, bare])
    assert none is None and len(found) > 20
    for name, key in (("load", "load"), ("peak_ratio", "particle_contact_area_ratio")):
        mine, library = [point[key] for point in found], [row[name] for row in rows]
        np.testing.assert_allclose(mine, library, rtol=RTOL)
