"""Ranges: what is given is known, members come with the inputs, and the default lies within its range."""

import pickle
import warnings
from dataclasses import replace

import numpy as np
import pytest
import yaml
from methods import ENGINEERING

import thirdbody as tb
from benchmarks.ranges import CONDITIONS, SEED, VARIABLES, random_conditions, shares_within
from chenhorng.home import config_directory
from thirdbody.core.parameters import WORDS
from thirdbody.inputs import BELONGS_TO, CALIBRATED
from thirdbody.plain_yaml import read_yaml
from thirdbody.ranges import ENDS

CALIBRATED_FILE = config_directory() / "calibrated" / "half_free.yaml"


def differing(members):
    """Names of the inputs in which members differ."""
    inputs = [member.as_dict() for member in members]
    return {name for name in inputs[0] if len({each[name] for each in inputs}) > 1}


def shares(parameters):
    """L_s of each member."""
    members = tb.ensemble(parameters)
    return [float(tb.solve(**ENGINEERING, parameters=each).solid_load_fraction) for each in members]


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
    content["ensemble_interpretations"] = [content["interpretation"]] * 3
    content["inputs"]["spread_ratio"] = 0.4
    return write(content), spreads


def test_the_calibrated_inputs_have_an_ensemble_that_differs(defaults):
    members = tb.ensemble()
    assert len(members) >= 16
    assert tb.ensemble(defaults) == members == defaults.members
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
        assert inputs == defaults
        assert differing(inputs.members) == names - {name}
    every = defaults.changed(**{name: getattr(defaults, name) for name in names})
    assert every.members == ()  # nothing is left in which they differ


def test_the_members_are_those_of_the_calibrated_file(own, defaults):
    path, spreads = own
    inputs = tb.load_parameters(path)
    assert [member.spread_ratio for member in inputs.members] == spreads
    assert differing(inputs.members) == {"spread_ratio"}
    assert inputs.spread_ratio == 0.4 and inputs.apparent_area == defaults.apparent_area
    assert np.ptp(shares(inputs)) > 0.0
    known = tb.load_parameters(path, hardness_surface_1=4e9, hardness_parameter=0.03)
    assert [member.spread_ratio for member in known.members] == spreads
    assert {member.hardness_surface_1 for member in known.members} == {4e9}


def test_a_file_with_some_inputs_gives_them_to_the_members(write, defaults):
    inputs = tb.load_parameters(write({"participation": 0.25}))
    assert {member.participation for member in inputs.members} == {0.25}
    assert len(inputs.members) == len(defaults.members)
    # each keeps what the file does not have
    radii = [member.summit_radius for member in inputs.members]
    assert radii == [member.summit_radius for member in defaults.members]


def test_a_file_with_all_that_differs_leaves_no_ensemble(write, defaults):
    names = differing(defaults.members)
    inputs = tb.load_parameters(write({name: getattr(defaults, name) for name in names}))
    assert inputs == defaults and inputs.members == ()


def test_replaced_inputs_have_no_members_and_changed_ones_have(defaults):
    assert replace(defaults, truncation=3.0).members == ()
    assert tb.ensemble(replace(defaults, truncation=3.0)) == ()
    assert tb.ensemble(tb.Parameters(**defaults.as_dict())) == ()
    changed = defaults.changed(truncation=3.0)
    assert changed == replace(defaults, truncation=3.0)
    assert [member.truncation for member in changed.members] == [3.0] * len(defaults.members)
    for before, after in zip(defaults.members, changed.members, strict=True):
        assert after == replace(before, truncation=3.0)
        assert after.members == ()
    # what is changed later is known too, and the first keeps its own
    again = changed.changed(participation=0.5)
    assert {(each.truncation, each.participation) for each in again.members} == {(3.0, 0.5)}
    assert differing(defaults.members) == differing(tb.load_parameters().members)


def test_members_take_no_part_in_what_inputs_are(defaults):
    alone = defaults.with_members(())
    assert alone == defaults and hash(alone) == hash(defaults)
    assert "members" not in defaults.as_dict() and "members" not in repr(defaults)
    assert tb.Parameters(**defaults.as_dict()) == defaults
    assert pickle.loads(pickle.dumps(defaults)).members == defaults.members
    assert defaults.with_members([alone]).members == (alone,)


def test_a_change_that_cannot_be_is_refused(defaults):
    with pytest.raises(ValueError, match="^participation is 2.0; allowed: "):
        defaults.changed(participation=2.0)


def test_a_bearing_is_known_to_all_members(defaults):
    inputs = tb.bearing(ball_radius_mm=10.0, apparent_area_mm2=4.0)
    assert inputs.speed_per_viscosity == pytest.approx(defaults.speed_per_viscosity * 0.635)
    for name in ("ball_radius", "apparent_area", "speed_per_viscosity"):
        assert {getattr(member, name) for member in inputs.members} == {getattr(inputs, name)}
    assert differing(inputs.members) == differing(defaults.members) - {"apparent_area"}


OTHERS = {"mean_ratio": lambda value: 1.0 - value}
OTHERS |= {
    name: lambda value, words=words: words[1 - words.index(value)] for name, words in WORDS.items()
}


def test_another_mean_of_the_sizes_than_the_calibrated_one_is_told(defaults):
    with pytest.warns(UserWarning, match="^mean_ratio is changed without spread_ratio, elastic_"):
        tb.load_parameters(mean_ratio=OTHERS["mean_ratio"](defaults.mean_ratio))


@pytest.mark.parametrize(
    "name", [name for name, (_, reason) in BELONGS_TO.items() if reason == CALIBRATED]
)
def test_what_was_calibrated_for_another_value_is_told_unless_it_is_given(defaults, name):
    other = {name: OTHERS[name](getattr(defaults, name))}
    dependents, _ = BELONGS_TO[name]
    stays = {each: getattr(defaults, each) for each in dependents}
    for left_out in dependents:
        given = {each: value for each, value in stays.items() if each != left_out}
        with pytest.warns(UserWarning, match=f"^{name} is changed without {left_out}; they were"):
            tb.load_parameters(**other, **given)
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        tb.load_parameters(**other, **stays)
        tb.load_parameters(**{name: getattr(defaults, name)})


@pytest.fixture(scope="module")
def within():
    return shares_within(tb.load_parameters())


@pytest.mark.parametrize("symbol", VARIABLES.values())
def test_the_default_lies_within_its_range_in_19_of_20_conditions(within, symbol):
    assert within[symbol] >= 0.95


def test_shares_within_are_those_of_the_conditions_that_members_enclose(parameters):
    same = parameters.with_members([parameters] * 3)
    assert (shares_within(same) == 1.0).all()
    # what the particles do not change is within, all else is not
    far = replace(parameters, participation=3.0 * parameters.participation)
    found = shares_within(parameters.with_members([far] * 3))
    conditions = random_conditions(CONDITIONS, SEED)
    one, other = (tb.solve(**conditions, parameters=each) for each in (parameters, far))
    for name, symbol in VARIABLES.items():
        value, changed = getattr(one, name), getattr(other, name)
        unchanged = np.isclose(changed, value, rtol=1e-9, atol=0.0)
        assert found[symbol] == unchanged[np.isfinite(value)].mean() < 0.9
