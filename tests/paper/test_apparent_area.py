"""The apparent area from the digits of the printed loads."""

from dataclasses import replace

import pytest

from chenhorng.claims.apparent_area import EXCLUDED, POSSIBLE, TAKEN, area_rows, losses_of_areas
from chenhorng.claims.paper_tables import rounding, steel_modulus
from chenhorng.home import config_directory
from chenhorng.sheets import sheet_of
from thirdbody.files import read_yaml

DIGITS = read_yaml(config_directory() / "printed_digits.yaml")
LOSSES = {6e-6: 50.0, 3e-6: 70.0}
STEEL = steel_modulus(0.29)


@pytest.fixture(scope="module")
def rows(parameters):
    printed = replace(parameters, elastic_modulus_surfaces=112e9, ball_radius=6.35e-3)
    return area_rows(DIGITS, 8.6e-9, printed, STEEL, LOSSES)


def of_all(rows, area):
    (row,) = (row for row in rows if row["area_m2"] == area and row["place"] == "all")
    return row


@pytest.mark.parametrize(
    ("printed", "digits", "ends"),
    [(5.96e-5, 3, (5.955e-5, 5.965e-5)), (4e-6, 1, (3.5e-6, 4.5e-6)), (100.0, 3, (99.5, 100.5))],
)
def test_a_number_stands_for_what_is_rounded_to_it(printed, digits, ends):
    assert rounding(printed, digits) == pytest.approx(ends, rel=1e-12)


def test_each_load_leaves_a_range_and_all_of_them_6_mm2(rows):
    loads = {row["printed"]: row for row in rows if row["area_m2"] == 6e-6 and row["printed"]}
    found = {
        printed: (row["normal_load_N"], 1e6 * row["printed_modulus_low_m2"])
        + (1e6 * row["printed_modulus_high_m2"],)
        for printed, row in loads.items()
    }
    assert found == {
        5.96e-5: pytest.approx((40.0, 5.9873, 5.9974), abs=1e-4),
        1.49e-5: pytest.approx((10.0, 5.9723, 6.0125), abs=1e-4),
        3.0e-5: pytest.approx((20.0, 5.8548, 6.0533), abs=1e-4),
        4.0e-6: pytest.approx((2.5, 4.9603, 6.3776), abs=1e-4),
    }
    row = of_all(rows, 6e-6)
    ends = [1e6 * row[f"printed_modulus_{end}_m2"] for end in ("low", "high")]
    assert ends == pytest.approx([5.9873, 5.9974], abs=1e-4)
    steel = [1e6 * row[f"material_modulus_{end}_m2"] for end in ("low", "high")]
    assert steel == pytest.approx([5.9920, 6.0021], abs=1e-4)
    assert [row["stiffness_low_N"], row["stiffness_high_N"]] == pytest.approx(
        [670578, 671704], 1e-6
    )


def test_the_axis_excludes_twice_and_6_mm2_has_the_least_loss(rows):
    verdicts = {row["area_m2"]: row["verdict"] for row in rows if row["place"] == "all"}
    assert [verdicts[area] for area in (12e-6, 6e-6, 3e-6)] == [EXCLUDED, TAKEN, POSSIBLE]
    assert "5.96e-05, without 0.0001 of Figure 6B" in of_all(rows, 12e-6)["remark"]
    assert "0.000119; the left-out loss of its search is 50.0" in of_all(rows, 6e-6)["remark"]
    assert "is 70.0" in of_all(rows, 3e-6)["remark"]
    assert verdicts[min(verdicts)] == EXCLUDED and len(verdicts) == 8


def test_the_axis_begins_where_table_2_does(rows):
    last = rows[-1]
    assert last["normal_load_N"] == 80.0 / 2**11
    assert "8.6496e-09 with E_ss as printed, 8.6564e-09 with" in last["remark"]
    assert last["remark"].endswith("0.04 N would be 8.8572e-09")


def test_loads_that_do_not_double_leave_no_area(parameters):
    third = {"place": "Figure 0", "printed": 2.24e-5, "digits": 3}
    other = DIGITS | {"lubricated_loads": [*DIGITS["lubricated_loads"], third]}
    assert len(area_rows(other, 8.6e-9, parameters, STEEL, LOSSES)) == 1


def test_without_a_search_no_area_is_taken(parameters):
    rows = area_rows(DIGITS, 8.6e-9, parameters, STEEL, {})
    assert {row["verdict"] for row in rows if row["place"] == "all"} == {EXCLUDED, POSSIBLE}


def test_areas_are_compared_between_interpretations_that_differ_in_the_area_alone():
    interpretations = {
        "one": {"fixed": {"mean_ratio": 0.0}},
        "one of 3": {"fixed": {"mean_ratio": 0.0, "apparent_area": 3e-6}},
        "other": {"fixed": {"mean_ratio": 1.0}},
    }
    losses = {"one": 40.0, "one of 3": 60.0, "other": 30.0}
    assert losses_of_areas(interpretations, losses, 6e-6) == {6e-6: 40.0, 3e-6: 60.0}


def test_the_sheet_has_a_line_for_each_area(rows):
    sheet = sheet_of("apparent_area", rows, (), 1.0)
    lines = {line["A_n [mm²]"]: line for line in sheet.rows}
    line = lines["6"]
    assert line["A_n E_ss by 5.96e-5, Figure 6A [kN]"] == "670.6 to 671.7 for 40 N"
    assert line["A_n for E_ss of Table 1 [mm²]"] == "5.987 to 5.997"
    assert line["A_n for E_ss of steel [mm²]"] == "5.992 to 6.002"
    assert line["verdict"] == TAKEN and lines["12"]["verdict"] == EXCLUDED
    assert "8.6e-9" in sheet.note
