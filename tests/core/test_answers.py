"""The answers of the command against solves of one's own."""

import re
from dataclasses import replace

import numpy as np
import pandas as pd
import pytest
from methods import ENGINEERING

import thirdbody as tb
from thirdbody import answers
from thirdbody.core.film import film_parameter
from thirdbody.core.particles import mean_and_largest
from thirdbody.ensembles import FITTED
from thirdbody.variables import AXES, CONDITIONS, FLAGS, QUANTITIES

LAYER = {name: ENGINEERING[name] for name in ("roughness_nm", "particle_density_per_m2")}


@pytest.fixture
def inputs(defaults):
    """The default with two members, which are enough here."""
    return replace(defaults, members=defaults.members[:2])


def by_name(table):
    return table.dropna(subset="name").set_index("name")


def without(key, **changes):
    return {name: value for name, value in (ENGINEERING | changes).items() if name != key}


def test_the_state_is_what_solve_gives_in_other_units(inputs):
    table = answers.state(inputs, ENGINEERING)
    solution = tb.solve(**ENGINEERING, parameters=inputs)
    assert table.attrs["found"]
    rows = by_name(table)
    for name in QUANTITIES.keys() & rows.index:
        scale = 1e9 if name == "separation" else 1.0
        assert rows.loc[name, "value"] == pytest.approx(scale * float(getattr(solution, name)))
    for name in FLAGS:
        assert getattr(solution, name) == rows.loc[name, "value"]


def test_the_range_is_that_of_the_members(defaults):
    members = tb.ensemble(defaults)
    shares = [
        float(tb.solve(**ENGINEERING, parameters=each).solid_load_fraction) for each in members
    ]
    table = answers.state(defaults, ENGINEERING)
    row = by_name(table).loc["solid_load_fraction"]
    assert (row["low"], row["high"]) == pytest.approx(tuple(np.quantile(shares, [0.05, 0.95])))
    assert (row["agree"], row["members"]) == (len(members), len(members))
    count = f"range of {len(members)} calibrated sets of inputs: 5 to 95 % of them, {FITTED}"
    assert count in table.attrs["notes"]
    assert f"range of {len(members)} sets" in answers.table_text(table)


def test_the_nominal_pressure_and_that_of_hertz_stand_beside_the_state(inputs):
    rows = answers.state(inputs, ENGINEERING, verbose=True).set_index("symbol")["value"]
    assert rows["A_n"] == pytest.approx(1e6 * inputs.apparent_area)
    assert rows["p_n"] == pytest.approx(1e-6 * 10.0 / inputs.apparent_area)
    # a = (3 F R/4 E)^(1/3) = 75.2 um for 10 N on the ball of Table 2
    assert rows["A_H"] == pytest.approx(np.pi * 0.07518**2, rel=1e-3)
    assert rows["A_H"] * rows["p_H"] == pytest.approx(10.0)


def test_lambda_stands_beside_the_gap_that_solids_hold_open(inputs):
    def rows(**changes):
        table = answers.state(inputs, ENGINEERING | changes)
        assert "lambda is of the film alone" in table.attrs["notes"][-1]
        return table.set_index("symbol")["value"]

    here, slower = rows(), rows(speed_m_per_s=0.25 * inputs.speed)
    load = 10.0 / inputs.newtons_per_load
    assert here["lambda"] == pytest.approx(film_parameter(load, 90e-6, 3e-7, inputs.best))
    assert slower["lambda"] == pytest.approx(0.25**0.663 * here["lambda"])
    assert slower["H_c"] * inputs.ball_radius / 3e-7 > 3.0 > 1.5 > slower["lambda"]
    assert rows(viscosity_cSt=0.0)["lambda"] == 0.0


def test_changes_are_those_of_transitions_with_the_range_of_the_members(inputs):
    conditions = without("viscosity_cSt")
    table = answers.changes_along(inputs, conditions, "viscosity_cSt", None)
    found = tb.transitions("viscosity_cSt", parameters=inputs, **conditions)
    assert table["value"].tolist() == found["viscosity_cSt"].tolist()
    of_members = [tb.transitions("viscosity_cSt", parameters=each, **conditions) for each in inputs]
    first = [each["viscosity_cSt"].iloc[0] for each in of_members]
    ends = table.loc[0, ["low", "high"]].tolist()
    assert ends == pytest.approx(np.quantile(first, [0.05, 0.95]).tolist())
    assert (table.loc[0, "agree"], table.loc[0, "members"]) == (2, 2)


@pytest.mark.parametrize(("along", "symbol"), [("load_N", "F_t"), ("viscosity_cSt", "nu")])
def test_a_change_has_the_symbol_of_its_unit(inputs, along, symbol):
    table = answers.changes_along(inputs, without(along), along, None)
    assert set(zip(table["symbol"], table["unit"])) == {
        (symbol, AXES[along.split("_")[0]].alias_unit)
    }


def test_what_is_not_passed_is_not_found(inputs):
    table = answers.changes_along(
        inputs, without("load_N", viscosity_cSt=0.0), "load_N", (5.6, 6.0)
    )
    assert not table.attrs["found"] and table.empty
    assert "searched: load 5.6 to 6 N" in table.attrs["notes"]
    assert "none" in answers.table_text(table)


def test_the_turning_point_is_a_maximum_and_its_sizes_have_one(inputs):
    dry = without("load_N", viscosity_cSt=0.0, particle_diameter_nm=300.0)
    table = answers.turning_load(inputs, dry)
    load, _, peak, _, low, high = table["value"]
    solution = tb.solve(**dry, load_N=load * np.array([0.98, 1.0, 1.02]), parameters=inputs)
    ratio = solution.particle_contact_area_ratio
    assert ratio[1] > max(ratio[0], ratio[2]) and peak == pytest.approx(ratio[1], rel=1e-8)
    sizes = np.multiply.outer([low, high], [0.99, 1.01]).ravel()
    at_sizes = tb.turning_point(**dry | {"particle_diameter_nm": sizes}, parameters=inputs)
    assert at_sizes["exists"].tolist() == [False, True, True, False]


@pytest.mark.parametrize("viscosity", [0.0, 90.0])
def test_a_last_load_that_is_not_carried_is_said_and_leaves_the_answer(inputs, viscosity):
    given = without("load_N", viscosity_cSt=viscosity, particle_diameter_nm=300.0)
    carried, more = (answers.turning_load(inputs, given, (0.01, last)) for last in (80.0, 1e4))
    assert more["agree"].tolist() == [2] * 6
    assert more["value"].tolist() == pytest.approx(carried["value"].tolist(), rel=0.05)
    (note,) = [note for note in more.attrs["notes"] if "load_exceeded" in note]
    assert note.startswith("dry at 10000 N, load_exceeded: ")
    assert not [note for note in carried.attrs["notes"] if "load_exceeded" in note]


@pytest.mark.parametrize("along", ["load_N", "viscosity_cSt", "roughness_nm"])
def test_a_curve_is_what_solve_gives(inputs, along):
    table = answers.curve(inputs, without(along), along, (80.0, 120.0), 5)
    assert table[along].to_numpy() == pytest.approx(np.geomspace(80.0, 120.0, 5))
    solution = tb.solve(**ENGINEERING | {along: table[along].to_numpy()}, parameters=inputs)
    for name in QUANTITIES:
        np.testing.assert_array_equal(table[name], getattr(solution, name))
        assert (table[f"{name}_low"] <= table[f"{name}_high"]).all()
    assert table["solution_status"].tolist() == ["converged"] * 5


def test_two_interfaces_have_both_values_and_the_range_of_the_change(inputs):
    others = ENGINEERING | {"viscosity_cSt": 120.0}
    table = by_name(answers.compare_interfaces(inputs, ENGINEERING, inputs, others))
    share = table.loc["solid_load_fraction"]
    assert share["value"] == by_name(answers.state(inputs, ENGINEERING)).loc[share.name, "value"]
    assert share["other"] == by_name(answers.state(inputs, others)).loc[share.name, "value"]
    assert share["low"] <= share["high"] < 0.0


def test_inputs_without_an_ensemble_have_no_range_and_say_so(inputs):
    alone = replace(inputs, members=(inputs.best,))
    for table in (
        answers.state(alone, ENGINEERING),
        answers.changes_along(alone, without("load_N"), "load_N", None),
        answers.turning_load(alone, without("load_N")),
    ):
        assert [note for note in table.attrs["notes"] if note.startswith("no range: ")]
        assert table[["low", "high"]].isna().all().all()
    table = answers.curve(alone, without("load_N"), "load_N", (1.0, 10.0), 2)
    assert "separation_low" not in table


def test_each_answer_names_its_area_and_the_speed_of_an_oil(inputs):
    mine = tb.bearing(inputs, speed_m_per_s=2.0, oil_density_kg_per_m3=870.0, apparent_area_mm2=3.0)
    area = "the nominal area A_n of the inputs is 3 mm2"
    speed = "with an oil of 870 kg/m3, U/nu is for an entrainment speed of 2 m/s"
    for load in ({}, {"viscosity_cSt": 0.0}):
        given = ENGINEERING | load
        others = {key: value for key, value in given.items() if key != "load_N"}
        for table in (
            answers.state(mine, given),
            answers.changes_along(mine, others, "load_N", None),
            answers.turning_load(mine, others),
            answers.compare_interfaces(mine, given, mine, given | {"load_N": 5.0}),
        ):
            assert area in table.attrs["notes"]
            assert (speed in table.attrs["notes"]) == (given["viscosity_cSt"] > 0.0)


def test_in_a_full_film_there_is_no_contact_mode(inputs):
    thick = ENGINEERING | {"viscosity_cSt": 1000.0}
    rows = by_name(answers.state(inputs, thick))["value"]
    assert (rows["lubrication_regime"], rows["contact_mode"]) == ("full_film", "none")
    table = answers.curve(inputs, without("viscosity_cSt"), "viscosity_cSt", (50.0, 2000.0), 5)
    assert table["contact_mode"].isna().equals(table["lubrication_regime"] == "full_film")
    table = answers.changes_along(inputs, without("viscosity_cSt"), "viscosity_cSt", (50.0, 2000.0))
    assert "at 2000 cSt: full_film, converged" in table.attrs["notes"]


def test_numbers_have_as_many_digits_as_their_range_allows(inputs):
    text = answers.table_text(answers.state(inputs, ENGINEERING))
    (line,) = [line.split() for line in text.splitlines() if line.startswith("L_s")]
    # a range of 0.04 leaves two digits behind the point of 0.766
    assert len(line[1]) in (4, 5)


@pytest.mark.parametrize(
    ("value", "low", "high", "texts"),
    [
        (0.82777, 0.78, 0.88, ("0.83", "0.78 to 0.88")),
        (1013.4, 980.1, 1013.9, ("1010", "980 to 1010")),
        (2.9034, 2.9034, 2.9035, ("2.90", "")),
        (1.6e-4, 1.54e-4, 1.61e-4, ("0.000160", "0.000154 to 0.000161")),
        (2.345e11, 1.0e11, 3.0e11, ("2.3e+11", "1.0e+11 to 3.0e+11")),
        (0.0, -1.0, 1.0, ("0", "-1.0 to 1.0")),
    ],
)
def test_numbers_have_three_digits_or_as_many_as_are_certain(value, low, high, texts):
    row = {"symbol": "L_s", "quantity": "share", "unit": "1", "value": value}
    table = pd.DataFrame([row | {"low": low, "high": high, "agree": 2, "members": 2}])
    table.attrs = {"title": "", "notes": []}
    line = answers.table_text(table).splitlines()[3].split("share")[0]
    assert line.strip().split(maxsplit=2)[1:] == [text for text in texts if text]


def printed_notes(solution):
    """The notes below a printed solution, each in one line."""
    lines = repr(solution).splitlines()
    assert max(map(len, lines)) <= answers.WIDTH
    text = "\n".join(line for line in lines[1:] if line.startswith(" "))
    return text.replace("\n    ", " ").replace("  ", "").splitlines()


@pytest.mark.parametrize("size", [500.0, 512.25, 1012.25])
def test_a_number_stays_on_the_line_of_its_unit(inputs, size):
    given = ENGINEERING | {"particle_diameter_nm": size, "speed_m_per_s": 4.0}
    table = answers.state(inputs, given)
    lines = answers.table_text(table).splitlines()
    title = lines[: lines.index("")]
    assert " ".join(title) == table.attrs["title"] and len(title) == 2
    units = {axis.alias_unit for axis in CONDITIONS.values()}
    assert not {line.split()[0].strip(",;") for line in lines if line.strip()} & units


OUTSIDE = [
    ({"load_N": 10_000.0}, "load 10000 N: the paper has 0.04 to 80 N"),
    ({"viscosity_cSt": 150.1}, "viscosity 150.1 cSt: the paper has 0 to 150 cSt"),
    ({"particle_diameter_nm": 2000.0}, "particle size 2000 nm: the paper has 0 to 1000 nm"),
    ({"roughness_nm": 99.0}, "roughness 99 nm: the paper has 100 to 500 nm"),
    (
        {"particle_density_per_m2": 1e9},
        "particle density 1e+09 m-2: the paper has 1e+10 to 5e+12 m-2",
    ),
]
HARDER = "load 10000 N: the mean Hertz pressure is 5.63 GPa, above the hardness of the softer"


@pytest.mark.parametrize(("changes", "note"), OUTSIDE)
def test_a_condition_that_the_paper_has_not_is_said(inputs, changes, note):
    given = ENGINEERING | changes
    solution = tb.solve(**given, parameters=inputs)
    for notes in (
        answers.state(inputs, given).attrs["notes"],
        answers.compare_interfaces(inputs, ENGINEERING, inputs, given).attrs["notes"],
        solution.to_dataframe().attrs["notes"],
        printed_notes(solution),
    ):
        assert [each for each in notes if "the paper has" in each] == [note]
        assert any(each.startswith(HARDER) for each in notes) == ("load_N" in changes)


def test_a_speed_that_the_paper_has_not_is_said_and_no_other_is(inputs):
    mine = tb.bearing(inputs, speed_m_per_s=2.0, oil_density_kg_per_m3=870.0)
    speed = f"{inputs.speed:.3g}"

    def notes(given, parameters=inputs):
        told = answers.state(parameters, given).attrs["notes"]
        printed = printed_notes(tb.solve(**given, parameters=parameters))
        about = [[note for note in each if "speed" in note] for each in (told, printed)]
        assert about[0] == about[1]
        return about[0]

    for parameters in (inputs, mine):
        told = notes(ENGINEERING | {"speed_m_per_s": 100.0}, parameters)
        assert told == [f"entrainment speed 100 m/s: the paper has {speed} m/s"]
    for own in (inputs.speed, float(speed), 0.0):
        assert notes(ENGINEERING | {"speed_m_per_s": own}) == []
    table = answers.curve(inputs, ENGINEERING, "speed_m_per_s", (1.0, 8.0), 2)
    assert f"entrainment speed 1 to 8 m/s: the paper has {speed} m/s" in table.attrs["notes"]
    table = answers.changes_along(inputs, ENGINEERING, "speed_m_per_s", None)
    assert not [note for note in table.attrs["notes"] if "U/nu" in note]


@pytest.mark.parametrize("end", [0, 1])
def test_the_ends_of_the_paper_are_not_outside_nor_is_0(inputs, end):
    ends = {axis.alias: axis.paper[end] for axis in AXES.values()}
    without_particles = {"particle_diameter_nm": 0.0, "particle_density_per_m2": 0.0}
    for given in (ends, ENGINEERING | without_particles | {"viscosity_cSt": 0.0}):
        text = repr(tb.solve(**given, parameters=inputs))
        assert "the paper has" not in text and "Hertz" not in text


def test_many_points_have_one_note_for_each_condition(inputs):
    given = ENGINEERING | {"load_N": np.geomspace(0.01, 8000.0, 50)}
    notes = tb.solve(**given, parameters=inputs).to_dataframe().attrs["notes"]
    outside, harder, *others = notes
    assert outside == "load 0.01 to 8000 N: the paper has 0.04 to 80 N"
    assert harder.startswith("load 8000 N: the mean Hertz pressure is 5.23 GPa")
    assert not [note for note in others if note.startswith("load ")]


def test_what_a_search_finds_outside_the_paper_is_said(inputs):
    table = answers.changes_along(inputs, without("viscosity_cSt"), "viscosity_cSt", None)
    first, last = (f"{table['value'].agg(end):.3g}" for end in ("min", "max"))
    (note,) = [note for note in table.attrs["notes"] if "the paper has" in note]
    told = re.fullmatch(r"viscosity (\S+) to (\S+) cSt: the paper has 0 to 150 cSt", note)
    assert [f"{float(text):.3g}" for text in told.groups()] == [first, last]
    table = answers.curve(inputs, without("load_N"), "load_N", (100.0, 9000.0), 3)
    assert len(table.attrs["notes"]) == 2


@pytest.mark.parametrize("along", ["load_N", *LAYER, "particle_diameter_nm"])
def test_each_answer_says_what_x_a_stands_for(inputs, along):
    mean, largest = mean_and_largest(500.0, inputs.best)
    sizes = f"the mean of the sizes is {mean:.0f} nm, the largest, X_max, {largest:.0f} nm"
    if along in ("particle_diameter_nm", "roughness_nm"):
        sizes = f"the mean of the sizes is {mean / 500:.3f} x_a, the largest, X_max, "
        sizes += f"{largest / 500:.2f} x_a"
    table = answers.changes_along(inputs, without(along), along, None)
    (note,) = [note for note in table.attrs["notes"] if note.startswith("particle size x_a")]
    assert f", a label: {sizes}" in note
    if along == "load_N":
        table = answers.changes_along(inputs, without(along, particle_diameter_nm=0.0), along, None)
        assert not [note for note in table.attrs["notes"] if "x_a" in note]


NO_PARTICLES = {"particle_diameter_nm": 0.0}, {"particle_density_per_m2": 0.0}


@pytest.mark.parametrize(
    ("changes", "start"),
    [
        ({}, "particle size x_a = 500 nm, a label: "),
        ({"load_N": [1.0, 10.0], "particle_diameter_nm": [0.0, 500.0]}, "particle size x_a = 500"),
        ({"particle_diameter_nm": [300.0, 500.0]}, "particle size x_a, a label: "),
        ({"roughness_nm": [100.0, 300.0]}, "particle size x_a, a label: "),
        *((changes, None) for changes in NO_PARTICLES),
    ],
)
def test_a_solution_says_once_what_x_a_stands_for(inputs, changes, start):
    given = ENGINEERING | changes
    solution = tb.solve(**given, parameters=inputs)
    notes = solution.to_dataframe().attrs["notes"]
    assert printed_notes(solution) == notes
    told = [note for note in notes if "x_a" in note]
    assert len(told) == (start is not None)
    if start:
        assert told[0].startswith(start)
    if not changes:
        assert told[0] in answers.state(inputs, given).attrs["notes"]
