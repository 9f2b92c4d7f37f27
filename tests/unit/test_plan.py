"""Which way points are solved: what is chosen, what can be asked for, and what a way leaves."""

import os
import sys
from dataclasses import replace
from functools import partial
from subprocess import run

import numpy as np
import pytest
from numpy.testing import assert_allclose

import thirdbody as tb
from benchmarks.classes import HEAVIEST, random_conditions
from benchmarks.measuring import least_seconds
from thirdbody.data.dataset import scene_dataset
from thirdbody.data.scene import Curves, Scene
from thirdbody.model.asperity import SummitPopulation
from thirdbody.model.contact import Contact
from thirdbody.solver import availability, balance, plan, solve
from thirdbody.solver.plan import (
    CALL_WORTH,
    COMPILING_WORTH,
    LOADING_WORTH,
    LOOP_WORTH,
    QUADRATURE_WORTH,
    TABLE_WORTH,
    THREADS_WORTH,
    WAYS,
    Group,
    fastest_ways,
    groups_of,
    search_ways,
    threads_worth,
)
from thirdbody.solver.points import Axis, Conditions
from thirdbody.solver.solution import VARIABLES
from thirdbody.solver.surfaces import FEW_SURFACES, Sheet, few_surfaces, log_yields

pytestmark = pytest.mark.filterwarnings("ignore::thirdbody.OutOfRangeWarning")

RTOL = 1e-9
MATERIALS = (0.02, 0.4, 54.0)  # H/E, k and omega_2/omega_1
POINT = {
    "load": 1e-5,
    "viscosity": 90e-6,
    "particle_diameter": 500e-9,
    "roughness": 300e-9,
    "particle_density": 1e11,
}
# imports the library, solves so many points and says whether the compiler was loaded
IS_LOADED = """
import sys
import numpy as np
import thirdbody as tb
from benchmarks.measuring import least_seconds
given = dict(viscosity=9e-5, particle_diameter=5e-7, roughness=3e-7, particle_density=1e11)
loads = np.geomspace(1e-7, 1e-5, int(sys.argv[1]))
tb.solve(load=loads, **given, parameters=tb.load_parameters())
print("numba" in sys.modules)
"""


def forget():
    """Have forgotten what the process has solved before."""
    plan._spent.cache_clear()
    plan._spent_unloaded.cache_clear()


@pytest.fixture
def loop(monkeypatch):
    """Says of the compiled loop whether it is installed, loaded and kept, whatever is true; and has
    what the process has solved before forgotten."""
    forget()

    def said(installed=True, loaded=False, kept=False):
        for name, answer in (("installed", installed), ("loaded", loaded), ("kept", kept)):
            monkeypatch.setattr(availability, f"is_{name}", lambda answer=answer: answer)

    return said


def chosen(parameters, *sizes, rtol=RTOL):
    """The ways of groups of such ``sizes``, each on a roughness of its own."""
    groups = [
        Group(Sheet.of_one(index, MATERIALS), 0, slice(0, size)) for index, size in enumerate(sizes)
    ]
    return list(fastest_ways(groups, parameters, rtol))


# ---- the choice


def test_few_points_are_solved_by_quadrature_and_more_by_tables(parameters, loop):
    loop()
    assert chosen(parameters, 1, TABLE_WORTH - 1, TABLE_WORTH) == [
        "quadrature",
        "quadrature",
        "tables",
    ]


def test_coarser_tables_pay_earlier(parameters, loop):
    loop()
    assert chosen(parameters, TABLE_WORTH // 2, rtol=1e-3) == ["tables"]


@pytest.mark.parametrize("kind", [1, 2])
def test_points_on_one_roughness_share_its_tables(parameters, loop, kind):
    loop()
    half = slice(0, TABLE_WORTH // 2)
    sheet = Sheet.of_one(-3.0, MATERIALS)
    groups = [Group(sheet, 0, half), Group(sheet, kind, half)]
    assert list(fastest_ways(groups, parameters, RTOL)) == ["tables", "tables"]


def test_the_tables_of_a_cell_are_worth_more_points_than_those_of_a_roughness(parameters, loop):
    loop(loaded=True)
    cell = Sheet.of_cell(-12, MATERIALS)
    for size, way in (
        (TABLE_WORTH, "quadrature"),
        (LOOP_WORTH, "quadrature"),
        (LOOP_WORTH * cell.terms(RTOL), "compiled"),
    ):
        forget()
        assert fastest_ways([Group(cell, 0, slice(0, size))], parameters, RTOL) == [way]
    loop()
    many = Group(cell, 0, slice(0, TABLE_WORTH * cell.terms(RTOL)))
    assert fastest_ways([many], parameters, RTOL) == ["tables"]


def test_points_are_grouped_by_roughness_or_by_cell(parameters):
    random = np.random.default_rng(2)
    for surfaces in (1, 2, FEW_SURFACES, FEW_SURFACES + 1, 3000):
        roughness = np.geomspace(1e-7, 1e-6, surfaces)[random.integers(0, surfaces, 5000)]
        columns = POINT | {"roughness": roughness, "viscosity": random.integers(0, 2, 5000) * 9e-5}
        conditions = Conditions(*np.broadcast_arrays(*columns.values()))
        few = few_surfaces(roughness)
        assert (few is None) == (surfaces > FEW_SURFACES)
        seen = np.zeros(5000, int)
        for group in groups_of(conditions, parameters, few):
            seen[group.places] += 1
            some = conditions.take(group.places)
            assert (some.are_lubricated == some.are_lubricated[0]).all()
            summits = SummitPopulation.of(parameters.surface(some.roughness), parameters)
            assert group.sheet.is_cell == (few is None)
            if group.sheet.is_cell:
                assert np.abs(group.sheet.place(log_yields(summits))).max() <= 1.0 + 1e-12
            else:
                assert (some.roughness == some.roughness[0]).all()
        assert (seen == 1).all()


@pytest.mark.parametrize("viscosity", [(0.0,), (9e-5,), (0.0, 9e-5)])
@pytest.mark.parametrize("diameter", [(0.0,), (1e-200,), (5e-7,), (0.0, 5e-7), (1e-200, 5e-7)])
@pytest.mark.parametrize("roughness", [(3e-7,), (3e-7, 5e-7), tuple(np.geomspace(1e-7, 1e-6, 99))])
@pytest.mark.parametrize("points", [0, 1, 500])
def test_what_conditions_lie_between_tells_the_same_groups_as_the_points(
    parameters, viscosity, diameter, roughness, points
):
    random = np.random.default_rng(3)
    given = {"viscosity": viscosity, "particle_diameter": diameter, "roughness": roughness}
    values = {name: random.choice(given.get(name, [one]), points) for name, one in POINT.items()}
    axes = {name: Axis.of(each) for name, each in values.items()}
    few = few_surfaces(values["roughness"]) if points else values["roughness"]
    by_points = list(groups_of(Conditions(**values), parameters, few))
    by_ends = list(groups_of(Conditions(**values), parameters, few, axes))
    assert len(by_points) == len(by_ends)
    for one, other in zip(by_points, by_ends, strict=True):
        assert (one.sheet, one.kind) == (other.sheet, other.kind)
        assert np.array_equal(np.r_[one.places], np.r_[other.places])


@pytest.mark.parametrize("count", [1, 1000, 1001, 2001, 3333, 50_000])
@pytest.mark.parametrize("threads", [1, 2, 3])
def test_threads_share_pieces_evenly(count, threads):
    for places in (slice(5, 5 + count), np.arange(5, 5 + count)):
        pieces = [np.r_[piece] for piece in plan._pieces(places, 1000, threads)]
        assert np.concatenate(pieces).tolist() == list(range(5, 5 + count))
        lengths = [piece.size for piece in pieces]
        assert max(lengths) <= 1000
        if threads > 1 and count > 1000:
            assert len(pieces) % threads == 0
            assert max(lengths) < 1.1 * min(lengths)


@pytest.mark.parametrize(
    ("state", "worth"), [({"kept": True}, LOADING_WORTH), ({}, COMPILING_WORTH)]
)
def test_the_loop_is_chosen_once_it_saves_more_than_its_loading_takes(
    parameters, loop, state, worth
):
    loop(**state)
    assert chosen(parameters, worth - 1) == ["tables"]
    assert chosen(parameters, worth) == ["compiled"]


def test_points_of_all_roughnesses_count_together_for_the_loading(parameters, loop):
    loop(kept=True)
    parts = LOADING_WORTH // TABLE_WORTH
    assert set(chosen(parameters, *[TABLE_WORTH] * parts)) == {"compiled"}
    forget()
    assert set(chosen(parameters, *[TABLE_WORTH] * (parts - 1))) == {"tables"}
    # but a roughness with few points would not repay the tables of the loop
    few = chosen(parameters, LOADING_WORTH, LOOP_WORTH - 1, 1)
    assert few == ["compiled", "quadrature", "quadrature"]


def test_a_loop_that_is_loaded_is_chosen_once_solving_took_as_long_as_its_tables_do(
    parameters, loop
):
    loop(loaded=True)
    assert chosen(parameters, LOOP_WORTH) == ["compiled"]
    assert chosen(parameters, 1) == ["compiled"]
    forget()
    assert chosen(parameters, LOOP_WORTH - 1) == ["quadrature"]
    assert chosen(parameters, 1) == ["compiled"]
    assert chosen(parameters, 1, rtol=1e-6) == ["quadrature"]
    assert chosen(replace(parameters, participation=0.5), 1) == ["quadrature"]
    forget()
    ways = [chosen(parameters, 1) for call in range(20)]
    assert ways[0] == ["quadrature"]
    assert ways[-1] == ["compiled"]


def test_a_loop_that_is_kept_is_loaded_once_calls_took_as_long_as_loading_does(parameters, loop):
    few = LOADING_WORTH // (CALL_WORTH * QUADRATURE_WORTH)
    loop(kept=True)
    ways = [chosen(parameters, 1) for call in range(few + 20)]
    assert ways[few // 2] == ["quadrature"]
    assert ways[-1] == ["compiled"]
    forget()
    many = [chosen(parameters, LOADING_WORTH // 10) for call in range(12)]
    assert many[5] == ["tables"]
    assert many[-1] == ["compiled"]
    # calls that would not repay the tables of the loop do not repay its loading
    forget()
    each_new = (
        Group(Sheet.of_one(float(place), MATERIALS), 0, slice(0, 1)) for place in range(2 * few)
    )
    assert {*(fastest_ways([group], parameters, RTOL)[0] for group in each_new)} == {"quadrature"}
    forget()
    loop(kept=False)
    assert {chosen(parameters, 1)[0] for call in range(few + 20)} == {"quadrature"}


@pytest.mark.parametrize("film_load", ["total", "fluid"])
def test_points_that_the_loop_leaves_begin_where_it_came_near(parameters, monkeypatch, film_load):
    inputs = replace(parameters, film_load=film_load)
    given = random_conditions(HEAVIEST, 30_000, inputs) | {"parameters": inputs, "rtol": 1e-11}
    looked = []
    load = Contact.log_solid_load
    monkeypatch.setattr(
        Contact,
        "log_solid_load",
        lambda contact, separation: looked.append(separation.size) or load(contact, separation),
    )
    near = tb.solve(**given, way="compiled")
    points = sum(looked)
    assert points > 0
    looked.clear()
    monkeypatch.setattr(balance, "_beginning", lambda points, first: first)
    far = tb.solve(**given, way="compiled")
    assert points < 0.9 * sum(looked)
    assert np.array_equal(near.solution_status, far.solution_status)
    for name in ("separation", "total_contact_area", "solid_load_fraction"):
        assert_allclose(getattr(near, name), getattr(far, name), rtol=1e-11)


@pytest.mark.parametrize(
    "change",
    [{}, {"film_load": "fluid"}, {"coverage_limits": "contacting"}, {"elastic_depth_ratio": 1e-2}],
)
@pytest.mark.parametrize("kind", ["lubricated", "dry", "two_body"])
def test_a_point_of_numbers_is_solved_as_one_of_an_array(parameters, monkeypatch, change, kind):
    """By less around the loop, with the same bits, once the tables of the surface are made."""
    inputs, dense = replace(parameters, **change), [1e10, 1e13, 1e16]
    random, calls = np.random.default_rng(3), []
    choose = solve.solve_numbers
    monkeypatch.setattr(
        solve, "solve_numbers", lambda *given: calls.append(choose(*given)) or calls[-1]
    )
    tb.solve(**POINT, parameters=inputs, way="compiled")
    for _ in range(60):
        point = POINT | {
            "load": 10.0 ** random.uniform(-8, -1),
            "viscosity": 10.0 ** random.uniform(-6, -3) if kind == "lubricated" else 0.0,
            "particle_diameter": 0.0 if kind == "two_body" else 10.0 ** random.uniform(-8, -6),
            "particle_density": float(random.choice(dense)),
        }
        alone = tb.solve(**point, parameters=inputs)
        array = tb.solve(**point | {"load": [point["load"]]}, parameters=inputs)
        if calls[-1] is None:
            continue
        for name in VARIABLES:
            one, other = getattr(alone, name), getattr(array, name)
            assert one.shape == () and one.dtype == other.dtype
            assert one.tobytes() == other.tobytes(), name
        assert all(each.shape == () for each in alone.conditions.values())
    assert sum(each is not None for each in calls) > 20


def test_few_points_on_many_roughnesses_are_solved_together(parameters, loop):
    loop(loaded=True)
    sizes = [1] * 50
    for _ in range(1000):
        ways = chosen(parameters, LOOP_WORTH, *sizes)
    assert ways == ["compiled"] + ["quadrature"] * 50
    assert chosen(parameters, LOOP_WORTH, 1, 1) == ["compiled"] * 3


def test_what_is_repeatable_depends_on_the_points_alone(parameters):
    given = POINT | {"parameters": parameters, "load": np.geomspace(1e-7, 1e-4, TABLE_WORTH)}
    repeatable = partial(tb.solve, **given, way="repeatable")
    best = tb.solve(**given, way="tables")
    tb.solve(**given, way="compiled")
    assert availability.is_loaded()
    chosen, found = tb.solve(**given), repeatable()
    assert not np.array_equal(chosen.separation, best.separation)
    for name in VARIABLES:
        assert np.array_equal(getattr(found, name), getattr(best, name), equal_nan=True), name


def test_a_scene_keeps_its_bytes_whatever_was_solved_before(parameters, loop):
    one = [np.array([value]) for name, value in POINT.items() if name != "load"]
    scene = Scene("some", "A scene", np.geomspace(1e-7, 1e-4, LOOP_WORTH), groups=(Curves(*one),))
    loop(loaded=False)
    before = scene_dataset(scene, parameters).to_xarray()
    loop(loaded=True)
    tb.solve(**POINT | {"load": scene.load}, parameters=parameters, way="compiled")
    assert scene_dataset(scene, parameters).to_xarray().identical(before)


def test_the_loop_is_never_chosen_where_there_is_no_compiler(parameters, loop):
    loop(installed=False)
    assert chosen(parameters, 10 * COMPILING_WORTH) == ["tables"]


def test_searches_take_tables_where_these_are_coarse_or_repaid():
    roughness = np.array([3e-7, 1e-7, 3e-7, 3e-7])
    ((way, table_rtol, curves),) = search_ways(roughness, 1, 1e-4)
    assert (way, table_rtol, curves.tolist()) == ("tables", 1e-4, [0, 1, 2, 3])
    tables, quadrature = search_ways(roughness, TABLE_WORTH // 2, RTOL)
    assert tables[:2] == ("tables", RTOL)
    assert quadrature[:2] == ("quadrature", None)
    assert [tables[2].tolist(), quadrature[2].tolist()] == [[0, 2, 3], [1]]


def test_only_many_points_load_the_compiler(parameters, tmp_path):
    tb.solve(**POINT, parameters=parameters, way="compiled")
    assert availability.is_loaded()
    assert availability.is_kept()
    elsewhere = os.environ | {"NUMBA_CACHE_DIR": str(tmp_path)}
    for points, environment, loaded in (
        (LOADING_WORTH - 1, os.environ, False),
        (LOADING_WORTH, os.environ, True),
        (LOADING_WORTH, elsewhere, False),
    ):
        command = [sys.executable, "-c", IS_LOADED, str(points)]
        ran = run(command, env=environment, capture_output=True, text=True, check=True)
        assert ran.stdout.strip() == str(loaded), points


def test_the_loop_is_kept_where_numba_is_told_to_keep_it(monkeypatch, tmp_path):
    monkeypatch.setenv("NUMBA_CACHE_DIR", str(tmp_path))
    assert not availability.is_kept()
    folder = tmp_path / "compiled_0"
    folder.mkdir()
    (folder / "loop.solve_points-1.py20.nbi").touch()  # of another Python
    assert not availability.is_kept()
    version = "".join(map(str, sys.version_info[:2]))
    (folder / f"loop.solve_points-1.py{version}.nbi").touch()
    assert availability.is_kept()


def test_threads_are_those_that_the_process_may_use(monkeypatch):
    monkeypatch.delenv("OMP_NUM_THREADS", raising=False)
    assert threads_worth(THREADS_WORTH - 1) == 1
    monkeypatch.setattr(os, "sched_getaffinity", lambda process: {0, 3, 5}, raising=False)
    assert threads_worth(THREADS_WORTH) == 3
    monkeypatch.setenv("OMP_NUM_THREADS", "1")
    assert threads_worth(THREADS_WORTH) == 1


@pytest.mark.filterwarnings("error")
@pytest.mark.parametrize("surfaces", [1, 500])
def test_threads_change_no_bit(parameters, monkeypatch, surfaces):
    random = np.random.default_rng(8)
    given = POINT | {
        "load": np.exp(random.uniform(*np.log([1e-9, 1e-2]), THREADS_WORTH)),
        "roughness": np.geomspace(1e-7, 5e-7, surfaces)[
            random.integers(0, surfaces, THREADS_WORTH)
        ],
    }
    solutions = []
    for threads in ("1", "3"):
        monkeypatch.setenv("OMP_NUM_THREADS", threads)
        solutions.append(tb.solve(**given, parameters=parameters, way="compiled"))
    for name in VARIABLES:
        one, other = (getattr(solution, name) for solution in solutions)
        assert np.array_equal(one, other, equal_nan=True), name


@pytest.mark.parametrize("count", [50, 5000])
def test_many_surfaces_take_about_the_time_of_one(parameters, count):
    """Once their tables are there; the real factor is below 3, noise of the machine included."""
    random = np.random.default_rng(9)
    loads = np.exp(random.uniform(*np.log([1e-7, 1e-4]), 200_000))
    seconds = []
    for surfaces in (1, count):
        roughness = np.geomspace(2e-7, 6e-7, surfaces)[random.integers(0, surfaces, loads.size)]
        given = POINT | {"load": loads, "roughness": roughness}
        run = partial(tb.solve, **given, parameters=parameters, way="compiled")
        run()
        seconds.append(least_seconds({"run": run}, 3)["run"])
    assert seconds[1] < 6.0 * seconds[0]


# ---- what can be asked for


def test_every_way_can_be_asked_for_and_is_taken(parameters, monkeypatch):
    taken = []
    for name in ("solve_by_loop", "solve_by_tables", "solve_by_quadrature"):
        original = getattr(plan._Task, name)

        def noted(task, places, name=name, original=original):
            if not isinstance(places, list) or places:
                taken.append(name)
            return original(task, places)

        monkeypatch.setattr(plan._Task, name, noted)
    first = {}
    for way in WAYS:
        taken.clear()
        tb.solve(**POINT, parameters=parameters, way=way)
        first[way] = taken[0]
    assert first == {
        "compiled": "solve_by_loop",
        "tables": "solve_by_tables",
        "quadrature": "solve_by_quadrature",
    }


@pytest.mark.parametrize("way", ["table", "", 1, "Compiled"])
def test_any_other_way_is_refused_by_name(parameters, way):
    with pytest.raises(
        ValueError,
        match="^way is .*; allowed: compiled, tables, quadrature, repeatable, or None to choose$",
    ):
        tb.solve(**POINT, parameters=parameters, way=way)


def test_without_a_compiler_the_loop_is_refused_with_the_name_of_the_extra(
    parameters, loop, monkeypatch
):
    loop(installed=False)
    monkeypatch.setattr("thirdbody.extras.find_spec", lambda name: None)
    with pytest.raises(ImportError, match=r'needs numba: pip install "thirdbody\[compiled\]"$'):
        tb.solve(**POINT, parameters=parameters, way="compiled")


# ---- what a way leaves


@pytest.mark.parametrize("change", [{"load": 1e3, "viscosity": 0.0}, {"viscosity": 1e9}])
@pytest.mark.parametrize("film_load", ["fluid", "total"])
@pytest.mark.parametrize(("points", "way"), [(1, "quadrature"), (2 * TABLE_WORTH, "tables")])
def test_what_the_loop_leaves_is_solved_by_what_takes_less_time(
    parameters, film_load, change, points, way
):
    given = POINT | change | {"parameters": replace(parameters, film_load=film_load)}
    given["load"] = np.full(points, given["load"])
    left, found = tb.solve(**given, way="compiled"), tb.solve(**given, way=way)
    for name in VARIABLES:
        assert np.array_equal(getattr(left, name), getattr(found, name), equal_nan=True), name


def test_what_tables_leave_is_solved_by_quadrature(parameters):
    """Where the largest particles begin to touch, the error of tables is magnified."""
    load = np.geomspace(1e-12, 1e-7, 1000)
    given = POINT | {"load": load, "parameters": parameters, "rtol": 1e-11}
    by_tables, best = tb.solve(**given, way="tables"), tb.solve(**given, way="quadrature")
    same = by_tables.separation == best.separation
    assert 0 < np.count_nonzero(same) < load.size
    assert np.array_equal(by_tables.solution_status, best.solution_status)
