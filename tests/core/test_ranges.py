"""Ranges: what is given is known, members come with the inputs, and the default lies within its
range.
"""

import math
import pickle
import warnings
from dataclasses import replace

import numpy as np
import pandas as pd
import pytest
import xarray as xr
import yaml
from methods import ENGINEERING

import thirdbody as tb
from chenhorng.coverage import random_conditions
from chenhorng.home import config_directory
from thirdbody.conditioning import NEAR
from thirdbody.core.parameters import WORDS
from thirdbody.ensembles import BELONGS_TO, CALIBRATED, ENDS, Ensemble, range_over_members
from thirdbody.files import read_yaml
from thirdbody.inputs import CALIBRATED_FILE

VARIABLES = (
    *("solid_load_fraction", "total_contact_area", "particle_contact_area_ratio"),
    *("separation", "film_thickness"),
)


def differing(members):
    """Names of the inputs in which members differ."""
    inputs = [member.as_dict() for member in members]
    return {name for name in inputs[0] if len({each[name] for each in inputs}) > 1}


def shares(parameters):
    """L_s of each member."""
    return tb.solve(**ENGINEERING, parameters=parameters, members=True).solid_load_fraction


def range_of(parameters):
    return np.quantile(shares(parameters), ENDS)


@pytest.fixture
def write(tmp_path):
    """Writes inputs as YAML and gives the path."""

    def write_file(content):
        path = tmp_path / "given.yaml"
        path.write_text(yaml.safe_dump(content))
        return path

    return write_file


@pytest.fixture
def own(write):
    """A calibrated file of one's own, with three members of which one input differs."""
    content = read_yaml(CALIBRATED_FILE)
    spreads = [0.3, 0.4, 0.6]
    content["ensemble"] = [content["inputs"] | {"spread_ratio": value} for value in spreads]
    content["inputs"]["spread_ratio"] = 0.4
    return write(content), spreads


def test_the_calibrated_inputs_have_an_ensemble_that_differs(defaults):
    members = tb.ensemble()
    assert len(members) >= 16
    assert tb.ensemble(defaults) == members == [*defaults.members]
    assert members[0] == defaults.best
    # what is unprinted may differ, and so may what interpretations fix
    settings = read_yaml(config_directory() / "calibration.yaml")
    fixed = {name for each in settings["interpretations"].values() for name in each["fixed"]}
    names = differing(members)
    assert names & set(settings["unknowns"]) and names <= {*settings["unknowns"], *fixed}


def test_an_input_that_is_given_is_known_even_if_it_is_the_default(defaults):
    area = defaults.apparent_area
    same, near = (tb.load_parameters(apparent_area=value) for value in (area, 1.0001 * area))
    for inputs, value in ((same, area), (near, 1.0001 * area)):
        assert {member.apparent_area for member in inputs.members} == {inputs.apparent_area}
        assert inputs.apparent_area == pytest.approx(value, rel=1e-12)
        assert len(inputs.members) == len(defaults.members)
    assert range_of(same) == pytest.approx(range_of(near), rel=1e-3)


def test_each_unknown_that_is_given_leaves_the_others_open(defaults):
    names = differing(defaults.members)
    for name in names:
        given = {name: getattr(defaults, name)}
        with warnings.catch_warnings():
            warnings.simplefilter("error")
            inputs = tb.load_parameters(**given)
        assert inputs.best == defaults.best
        assert differing(inputs.members) == names - {name}
    every = defaults.changed(**{name: getattr(defaults, name) for name in names})
    assert every.members == (defaults.best,)  # nothing is left in which they differ


def test_the_members_are_those_of_the_calibrated_file(own, defaults):
    path, spreads = own
    inputs = tb.load_parameters(path)
    best_first = [0.4, *(value for value in spreads if value != 0.4)]
    assert [member.spread_ratio for member in inputs.members] == best_first
    assert differing(inputs.members) == {"spread_ratio"}
    assert inputs.spread_ratio == 0.4 and inputs.apparent_area == defaults.apparent_area
    assert np.ptp(shares(inputs)) > 0.0
    known = tb.load_parameters(path, hardness_surface_1=4e9, hardness_parameter=0.03)
    assert [member.spread_ratio for member in known.members] == best_first
    assert {member.hardness_surface_1 for member in known.members} == {4e9}


def test_a_file_with_some_inputs_gives_them_to_the_members(write, defaults):
    inputs = tb.load_parameters(write({"participation": 0.6}))
    assert {member.participation for member in inputs.members} == {0.6}
    assert len(inputs.members) == round(NEAR * len(defaults.members))
    # each has its own of what the file does not have
    assert differing(inputs.members) == differing(defaults.members) - {"participation"}


def test_a_file_with_all_that_differs_leaves_no_ensemble(write, defaults):
    names = differing(defaults.members)
    inputs = tb.load_parameters(write({name: getattr(defaults, name) for name in names}))
    assert inputs.members == (defaults.best,)


def test_what_is_changed_is_changed_in_all_members(defaults):
    changed = defaults.changed(truncation=3.0)
    assert changed.best == replace(defaults.best, truncation=3.0)
    assert [member.truncation for member in changed.members] == [3.0] * len(defaults.members)
    for before, after in zip(defaults.members, changed.members, strict=True):
        assert after == replace(before, truncation=3.0)
    # what is changed later is known too, and the first keeps its own
    again = changed.changed(participation=0.5)
    assert {(each.truncation, each.participation) for each in again.members} == {(3.0, 0.5)}
    assert differing(defaults.members) == differing(tb.load_parameters().members)


def test_an_ensemble_is_its_members_and_its_setup(defaults):
    alone = Ensemble([defaults.best], defaults.setup)
    assert alone != defaults and alone == next(iter(defaults))
    assert tb.Parameters(**defaults.best.as_dict()) == defaults.best
    assert pickle.loads(pickle.dumps(defaults)) == defaults
    assert [each.best for each in defaults] == [*defaults.members]
    with pytest.raises(ValueError, match="^members is empty; allowed: one or more"):
        replace(defaults, members=())
    with pytest.raises(AttributeError):
        print(defaults.nonsense)


def test_members_are_solved_together_as_alone_at_the_same_newtons(defaults):
    few = replace(defaults, members=defaults.members[:3])
    given = ENGINEERING | {"load_N": np.array([1.0, 10.0])[:, None], "viscosity_cSt": [0.0, 90.0]}
    together = tb.solve(**given, speed_m_per_s=4.0, parameters=few, members=True)
    for number, member in enumerate(few):
        alone = tb.solve(**given, speed_m_per_s=4.0, parameters=member)
        for name, values in alone.variables.items():
            np.testing.assert_array_equal(together.variables[name][number], values)
    assert together.separation.shape == (3, 2, 2)
    assert tb.solve(**given, parameters=few).separation.shape == (2, 2)


@pytest.mark.parametrize("load", [{"load_N": [1.0, 10.0]}, {"load": [1e-6, 1e-5]}])
def test_datasets_and_tables_have_a_dimension_of_members(defaults, load):
    few = replace(defaults, members=defaults.members[:2])
    given = {key: value for key, value in ENGINEERING.items() if key != "load_N"} | load
    points = tb.solve(**given, parameters=few, members=True)
    dataset = points.to_dataset()
    assert dict(dataset.sizes) == {"member": 2, "load": 2}
    low, high = dataset["solid_load_fraction"].quantile(ENDS, "member").values
    expected = np.quantile(points.solid_load_fraction, ENDS, axis=0)
    np.testing.assert_allclose((low, high), expected, rtol=1e-15)
    table = points.to_dataframe()
    assert table["member"].tolist() == [0, 0, 1, 1]
    newtons = np.asarray(dataset["normal_load"])
    if "load" in load:  # the same F_t* is another load where A_n differs
        expected = np.outer([each.newtons_per_load for each in few.members], load["load"])
        np.testing.assert_allclose(newtons, expected)
        np.testing.assert_allclose(table["load_N"], expected.ravel())
    else:
        np.testing.assert_allclose(newtons, load["load_N"])
        assert table["load_N"].tolist() == [1.0, 10.0] * 2
    grid = tb.grid(**given, parameters=few, members=True)
    assert grid["separation"].dims[0] == "member"
    np.testing.assert_allclose(grid["separation"].squeeze(), points.separation, rtol=1e-8)
    np.testing.assert_allclose(grid["normal_load"], newtons)
    labelled = {key: xr.DataArray(value, dims="run") for key, value in load.items()}
    named = tb.solve(**given | labelled, parameters=few, members=True)
    assert named.separation.dims == ("member", "run")
    np.testing.assert_array_equal(named.separation, points.separation)


def test_searches_of_members_stand_one_below_the_other(defaults):
    few = replace(defaults, members=defaults.members[:2])
    layer = {key: value for key, value in ENGINEERING.items() if key != "viscosity_cSt"}
    one = {key: value for key, value in ENGINEERING.items() if key != "load_N"}
    dry = {"roughness_nm": 300, "particle_density_per_m2": 1e11}
    for search in (
        lambda **given: tb.find("solid_load_fraction", 0.5, "viscosity_cSt", **layer, **given),
        lambda **given: tb.transitions("load_N", **one, **given),
        lambda **given: tb.turning_point(**one, **given),
        lambda **given: tb.turning_window(**dry, **given),
    ):
        table = search(parameters=few, members=True)
        assert table.index.names[0] == "member"
        for number, member in enumerate(few):
            pd.testing.assert_frame_equal(table.loc[number], search(parameters=member))
        pd.testing.assert_frame_equal(search(parameters=few), table.loc[0])


def test_a_speed_of_inputs_without_an_oil_is_refused(defaults):
    with pytest.raises(ValueError, match="the density of the oil is unknown"):
        tb.solve(**ENGINEERING, speed_m_per_s=2.0, parameters=defaults.best)


def test_a_change_that_cannot_be_is_refused(defaults):
    with pytest.raises(ValueError, match="^participation is 2.0; allowed: "):
        defaults.changed(participation=2.0)


def test_a_bearing_is_known_to_all_members(defaults):
    inputs = tb.bearing(ball_radius_mm=10.0, apparent_area_mm2=4.0)
    assert inputs.speed_per_viscosity == pytest.approx(defaults.speed_per_viscosity * 0.635)
    for name in ("ball_radius", "apparent_area", "speed_per_viscosity"):
        assert {getattr(member, name) for member in inputs.members} == {getattr(inputs, name)}
    assert differing(inputs.members) == differing(defaults.members) - {"apparent_area"}


# ---- what is given narrows


@pytest.fixture
def gaussian(defaults):
    """Members whose logarithms follow each other with a scatter, and an exponent with them."""
    common, own, other = np.random.default_rng(3).normal(size=(3, 200))
    members = tuple(
        replace(
            defaults.best,
            apparent_area=5e-6 * math.exp(0.1 * one),
            summit_radius=1e-4 * math.exp(0.2 * one + 0.05 * two),
            summit_radius_exponent=-0.5 * one + 0.1 * three,
        )
        for one, two, three in zip(common, own, other, strict=True)
    )
    return Ensemble(members, defaults.setup)


def test_members_are_moved_by_the_regression_and_keep_their_own_residual(gaussian):
    given = gaussian.changed(apparent_area=5.5e-6)
    first, *others = gaussian.members
    nearest = sorted(others, key=lambda each: abs(math.log(5.5e-6 / each.apparent_area)))[:66]
    kept = [first, *(each for each in others if each in nearest)]
    steps = [math.log(5.5e-6 / each.apparent_area) for each in kept]
    pairs = list(zip(kept, given.members, strict=True))
    radius = [math.log(new.summit_radius / old.summit_radius) for old, new in pairs]
    exponent = [new.summit_radius_exponent - old.summit_radius_exponent for old, new in pairs]
    np.testing.assert_allclose(radius, 2.0 * np.array(steps), rtol=0.1)
    np.testing.assert_allclose(exponent, -5.0 * np.array(steps), rtol=0.1)
    left = np.std([math.log(each.summit_radius) for each in given.members])
    assert left == pytest.approx(0.05, rel=0.15)  # the scatter alone, of 0.2


def test_moved_inputs_stay_within_their_bounds(defaults):
    members = tuple(
        replace(defaults.best, participation=part, summit_offset_ratio=offset)
        for part, offset in ((0.6, 0.01), (0.8, 0.2), (0.9, 0.4))
    )
    moved = Ensemble(members, defaults.setup).changed(participation=0.4)
    assert moved.summit_offset_ratio == 0.0


def test_what_is_far_from_all_members_is_told_and_moves_them_no_farther(gaussian):
    with pytest.warns(UserWarning, match="^apparent_area is 2e-05, and .* do not belong to this"):
        far = gaussian.changed(apparent_area=2e-5)
    with pytest.warns(UserWarning, match="^apparent_area is 3e-05"):
        farther = gaussian.changed(apparent_area=3e-5)
    radii = [[each.summit_radius for each in one.members] for one in (far, farther)]
    assert radii[0] == radii[1] and far.apparent_area == 2e-5
    with pytest.warns(UserWarning) as told:
        tb.bearing(gaussian, apparent_area_mm2=20.0)
    assert [each.filename for each in told] == [__file__]


# a narrower range is one line in a figure; relative to the value where that has no scale
NARROW = {"solid_load_fraction": 0.01, "particle_contact_area_ratio": 0.01}
RELATIVE = 0.01


@pytest.fixture(scope="module")
def widths_if_given():
    """Width of each range with an input given as the best has it, over that without; a row for
    each input, condition and variable."""
    ensemble, rows = tb.load_parameters(), []
    settings = read_yaml(config_directory() / "calibration.yaml")["coverage"]
    conditions = random_conditions(settings | {"conditions": 50})

    def widths(inputs):
        points = tb.solve(**conditions, parameters=inputs, members=True)
        return {name: np.ptp(range_over_members(getattr(points, name)), 0) for name in VARIABLES}

    values, before = tb.solve(**conditions), widths(ensemble)
    for given in sorted(differing(ensemble.members)):
        after = widths(ensemble.changed(**{given: getattr(ensemble, given)}))
        for name in VARIABLES:
            least = NARROW.get(name, RELATIVE * np.abs(getattr(values, name)))
            seen = (before[name] > least) & np.isfinite(after[name])
            rows += [(given, name, ratio) for ratio in (after[name] / before[name])[seen]]
    return pd.DataFrame(rows, columns=["given", "variable", "ratio"])


def test_what_is_given_narrows_the_ranges(widths_if_given):
    ratio = widths_if_given["ratio"]
    # quantiles of few members scatter, and where members have two modes a single one counts
    assert ratio.mean() < 1.0
    assert (widths_if_given.groupby("given")["ratio"].median() <= 1.05).all()
    assert (ratio > 1.02).mean() < 0.2 and (ratio > 1.1).mean() < 0.1


def test_the_area_of_the_default_does_not_widen_the_share_of_the_solids(defaults):
    given = tb.bearing(apparent_area_mm2=1e6 * defaults.apparent_area)
    assert np.ptp(range_of(given)) <= np.ptp(range_of(defaults))


OTHERS = {"mean_ratio": lambda value: 1.0 - value, "apparent_area": lambda value: 0.5 * value}
OTHERS |= {
    name: lambda value, words=words: words[1 - words.index(value)] for name, words in WORDS.items()
}


def test_an_area_other_than_the_calibrated_one_is_told_and_its_rounding_is_not(defaults):
    assert "apparent_area" not in differing(defaults.members)
    area_mm2 = 1e6 * defaults.apparent_area
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        for factor in (0.92, 1.0, 1.08):
            tb.bearing(apparent_area_mm2=factor * area_mm2)
    for factor in (0.01, 0.8, 1.2):
        with pytest.warns(UserWarning, match="^apparent_area is changed without summit_") as told:
            tb.bearing(apparent_area_mm2=factor * area_mm2)
        assert [each.filename for each in told] == [__file__]


def test_another_mean_of_the_sizes_than_the_calibrated_one_is_told(defaults):
    alone = Ensemble((defaults.best,), defaults.setup)
    with pytest.warns(UserWarning, match="^mean_ratio is changed without spread_ratio, elastic_"):
        alone.changed(mean_ratio=OTHERS["mean_ratio"](defaults.mean_ratio))


@pytest.mark.parametrize(
    "name", [name for name, (_, reason) in BELONGS_TO.items() if reason == CALIBRATED]
)
def test_what_was_calibrated_for_another_value_is_told_unless_it_is_given(defaults, name):
    alone = Ensemble((defaults.best,), defaults.setup)  # where members differ, others follow
    other = {name: OTHERS[name](getattr(defaults, name))}
    dependents, _ = BELONGS_TO[name]
    stays = {each: getattr(defaults, each) for each in dependents}
    for left_out in dependents:
        given = {each: value for each, value in stays.items() if each != left_out}
        with pytest.warns(UserWarning, match=f"^{name} is changed without {left_out}; they were"):
            alone.changed(**other, **given)
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        alone.changed(**other, **stays)
        alone.changed(**{name: getattr(defaults, name)})
