"""Viscosities of oils: published values of ASTM D2270, ASTM D341 and ISO 3448."""

import numpy as np
import pandas as pd
import pint
import pytest

import thirdbody as tb
from thirdbody.lab.oil import GRADES, viscosity_index_of


@pytest.mark.parametrize(
    ("at_40", "at_100", "index"),
    [(73.30, 8.86, 92), (22.83, 5.05, 156), (53.47, 7.80, 111)],  # examples of ASTM D2270
)
def test_the_viscosity_index_is_that_of_the_standard(at_40, at_100, index):
    assert viscosity_index_of(at_40, at_100) == pytest.approx(index, abs=0.5)


@pytest.mark.parametrize("grade", [grade for grade in GRADES if grade >= 10])
@pytest.mark.parametrize("index", [60, 95, 160])
def test_an_oil_of_a_grade_has_its_viscosity_and_index(grade, index):
    at_40, at_100 = tb.lab.oil_viscosity([40, 100], grade=grade, viscosity_index=index)
    assert at_40 == pytest.approx(GRADES[grade])
    assert viscosity_index_of(at_40, at_100) == pytest.approx(index)


def test_a_published_example_of_the_line():
    """ASTM D341 through 32 cSt at 40 C and 5.4 cSt at 100 C gives 8.5 cSt at 80 C."""
    assert tb.lab.oil_viscosity(80, points={40: 32, 100: 5.4}) == pytest.approx(8.5, abs=0.05)


def test_the_line_goes_through_both_points_and_is_straight_in_its_coordinates():
    kelvin = np.array([313.15, 343.15, 373.15])
    found = tb.lab.oil_viscosity(kelvin - 273.15, points={100: 10.7, 40: 68})
    assert found[[0, 2]] == pytest.approx([68.0, 10.7])
    slopes = np.diff(np.log10(np.log10(found + 0.7))) / np.diff(np.log10(kelvin))
    assert slopes[0] == pytest.approx(slopes[1])


@pytest.mark.parametrize(
    ("temperature", "oil"),
    [
        (60, {"grade": 47}),
        (60, {}),
        (60, {"viscosity_index": 95}),
        (60, {"grade": 46, "points": {40: 46, 100: 6.8}}),
        (60, {"viscosity_index": 95, "points": {40: 46, 100: 6.8}}),
        (60, {"grade": 2}),  # too thin at 100 C
        (60, {"points": {40: 46}}),
        (60, {"points": {40: 5, 100: 46}}),
        (160, {"points": {40: 10, 100: 2.5}}),
        (-80, {"grade": 46}),
        (400, {"grade": 3200}),
        (np.nan, {"grade": 46}),
    ],
)
def test_what_is_no_oil_is_refused(temperature, oil):
    with pytest.raises((ValueError, KeyError)):
        tb.lab.oil_viscosity(temperature, **oil)


def test_oils_by_the_name_of_their_grade_and_temperatures_with_units():
    expected = tb.lab.oil_viscosity(60, grade=46, viscosity_index=95)
    assert tb.lab.oil_viscosity(60, grade=46) == expected
    assert tb.lab.oil_viscosity(60, grade="ISO VG 46") == expected
    warm = pint.Quantity(333.15, "kelvin")
    assert tb.lab.oil_viscosity(warm, grade="VG-46") == pytest.approx(expected)
    with pytest.raises(pint.DimensionalityError):
        tb.lab.oil_viscosity(pint.Quantity(1.0, "m"), grade=46)


def test_temperatures_of_a_table_give_a_column_of_the_table():
    table = pd.DataFrame({"oil [C]": [40.0, 80.0]}, index=["cold", "hot"])
    found = tb.lab.oil_viscosity(table["oil [C]"], grade=46)
    assert found.index.equals(table.index) and found["cold"] == pytest.approx(46.0)


def test_the_least_grade_that_is_enough():
    table = tb.lab.oil_grade(73.5, 75)
    assert table["grade"].tolist() == [320, 460, 680]
    assert table.loc[table["is_least_enough"], "grade"].tolist() == [460]
    for row in table.itertuples():
        assert row.viscosity_cSt == pytest.approx(tb.lab.oil_viscosity(75, grade=row.grade).item())
    at_40 = tb.lab.oil_grade(pint.Quantity(46e-6, "m**2/s"), pint.Quantity(313.15, "K"))
    assert at_40.loc[at_40["is_least_enough"], "grade"].item() == 46


def test_grades_at_the_ends():
    assert tb.lab.oil_grade(1e5, 20)["grade"].tolist() == [3200]
    assert not tb.lab.oil_grade(1e5, 20)["is_least_enough"].any()
    thin = tb.lab.oil_grade(2.5, 100)
    assert thin["is_least_enough"].tolist() == [False, True, False]
    assert thin["viscosity_cSt"].is_monotonic_increasing
    better = tb.lab.oil_grade(73.5, 75, viscosity_index=160)
    assert better.loc[better["is_least_enough"], "grade"].item() < 460
    for bad in ((-1, 60), (46, 500)):
        with pytest.raises(ValueError):
            tb.lab.oil_grade(*bad)
