"""The five axes: names, keys and units agree wherever they stand, and units turn into SI
exactly."""

import inspect
from typing import get_type_hints

import numpy as np
import pytest

import thirdbody as tb
from thirdbody.conditions import ConditionArguments
from thirdbody.curves import Condition
from thirdbody.points import Variables
from thirdbody.variables import AXES, CONDITION_AXES, CONDITIONS, VARIABLES


@pytest.mark.parametrize("value", [0.1, 0.3, 1.1, 70, 120, 325, 999.999])
def test_a_decimal_is_the_float_that_its_digits_mean_in_si(value):
    assert AXES["roughness"].to_si(value) == float(f"{value}e-9")
    assert AXES["viscosity"].to_si(value) == float(f"{value}e-6")


def test_values_are_sorted_and_stand_once():
    values = AXES["viscosity"].values([90, 0, 90.0, 25])
    assert values.tolist() == [0.0, 25e-6, 90e-6]
    back = [AXES["viscosity"].from_si(value) for value in values]
    np.testing.assert_allclose(back, [0, 25, 90], rtol=1e-15)


def test_a_condition_is_read_from_a_configuration_and_named_in_tables():
    given = {"viscosity_cSt": 90, "particle_diameter_nm": 500, "roughness_nm": 300}
    condition = Condition.of(given | {"particle_density_per_m2": 1e11, "load_N": 2.0})
    assert condition == (90e-6, 500e-9, 300e-9, 1e11)
    assert condition.columns["viscosity_m2_per_s"] == 90e-6
    assert list(condition.columns) == [axis.column for axis in CONDITION_AXES]
    with pytest.raises(KeyError, match="particle_density_per_m2"):
        Condition.of(given)


def test_type_checkers_know_each_condition_and_each_variable():
    names = {name for axis in CONDITIONS.values() for name in (axis.name, axis.alias)}
    assert get_type_hints(ConditionArguments).keys() == names
    assert get_type_hints(Variables).keys() == VARIABLES.keys()
    shown = inspect.signature(tb.solve).parameters
    assert names < shown.keys()
    assert {shown[name].annotation for name in names} == {"ArrayLike | None"}


@pytest.mark.parametrize(
    ("condition", "is_dry", "is_two_body"),
    [
        (Condition(90e-6, 3e-7, 3e-7, 1e11), False, False),
        (Condition(0.0, 3e-7, 3e-7, 1e11), True, False),
        (Condition(90e-6, 0.0, 3e-7, 1e11), False, True),
        (Condition(0.0, 3e-7, 3e-7, 0.0), True, True),
    ],
)
def test_a_condition_is_dry_or_two_body(condition, is_dry, is_two_body):
    assert (condition.is_dry, condition.is_two_body) == (is_dry, is_two_body)
