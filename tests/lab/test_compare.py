"""Measurements beside the model: values, ranges, residuals, speeds."""

import json

import numpy as np
import pandas as pd
import pint
import pytest

import thirdbody as tb

FRACTION = "solid_load_fraction"


def test_the_model_and_its_range_stand_beside_each_measurement(runs, rest, solved):
    table = tb.lab.compare(runs(), **rest)
    assert table[FRACTION].tolist() == [0.9, 0.7, 0.5]
    np.testing.assert_allclose(table[f"{FRACTION}_model"], solved.solid_load_fraction)
    residual = table[FRACTION] - solved.solid_load_fraction
    np.testing.assert_allclose(table[f"{FRACTION}_residual"], residual)
    loads = table["load_N"].to_numpy()
    members = [tb.solve(load_N=loads, parameters=p, **rest) for p in tb.ensemble()]
    ends = np.quantile([each.solid_load_fraction for each in members], (0.05, 0.95), axis=0)
    np.testing.assert_allclose(table[[f"{FRACTION}_low", f"{FRACTION}_high"]].T, ends)
    (summary,) = table.attrs["summary"]
    assert summary["mean_residual"] == pytest.approx(residual.mean())
    assert summary["rms_residual"] == pytest.approx(np.sqrt((residual**2).mean()))
    inside = (table[FRACTION] >= ends[0]) & (table[FRACTION] <= ends[1])
    assert (summary["inside_range"], summary["count"]) == (inside.sum(), 3)
    json.dumps(table.attrs)  # plain values, which files of pandas keep


def test_quantities_have_their_units(runs, rest, solved, defaults):
    columns = {"contact resistance (mohm)": [5, 4, 3], "film_thickness [um]": [1, np.nan, 0.5]}
    columns["real contact area [um^2]"] = [1500, 2900, 4600]
    table = tb.lab.compare(runs(**columns), resistivity_ohm_m=1e-7, **rest)
    area = solved.total_contact_area * defaults.apparent_area
    for name, expected in (
        ("film_thickness_nm", [1000, np.nan, 500]),
        ("film_thickness_nm_model", 1e9 * solved.film_thickness * defaults.ball_radius),
        ("real_contact_area_mm2_model", 1e6 * area),
        ("contact_resistance_ohm_model", 0.5e-7 * np.sqrt(np.pi / area)),
    ):
        np.testing.assert_allclose(table[name], expected, rtol=1e-6, err_msg=name)
    counts = {row["quantity"]: row["count"] for row in table.attrs["summary"]}
    assert counts["film_thickness_nm"] == 2 and counts["contact_resistance_ohm"] == 3


def test_coefficients_of_the_generator_are_fitted(rest):
    points = tb.solve(load_N=[1, 3, 10, 30, 50], **rest)
    table = pd.DataFrame(
        {"load [N]": [1, 3, 10, 30, 50], "COF": tb.lab.friction(points, 0.1, 0.04)}
    )
    found = tb.lab.compare(table, **rest)
    assert found.attrs["coefficients"]["film_friction"] == pytest.approx(0.04)
    np.testing.assert_allclose(found["friction_coefficient_residual"], 0.0, atol=1e-9)
    kept = tb.lab.compare(table, film_friction=0.03, boundary_friction=0.1, **rest)
    assert kept["friction_coefficient_model"].equals(pd.Series(tb.lab.friction(points, 0.1, 0.03)))


def test_half_the_speed_is_half_the_viscosity(runs, rest, defaults):
    speed = tb.lab.compare(runs(**{"speed [m/s]": 2.0}), **rest)
    half = tb.lab.compare(runs(**{"speed [mm/s]": 1000.0}), **rest)
    thin = tb.lab.compare(runs(**{"speed [m/s]": 2.0}), **rest | {"viscosity_cSt": 45})
    name = f"{FRACTION}_model"
    assert half[name].tolist() == pytest.approx(thin[name].tolist())
    assert half[name].iloc[2] > speed[name].iloc[2]
    at_rest = tb.lab.compare(runs(**{"speed [m/s]": 0.0}), **rest)
    assert at_rest[name].tolist() == [1.0, 1.0, 1.0]
    with pytest.raises(ValueError, match="speed_m_per_s is nan"):
        tb.lab.compare(runs(**{"speed [m/s]": [2.0, np.nan, 2.0]}), **rest)


def test_a_speed_and_an_oil_are_those_of_bearing(runs, rest):
    oil = dict(speed_m_per_s=2, oil_density_kg_per_m3=870)
    expected = tb.lab.compare(runs(), parameters=tb.bearing(**oil), **rest)
    units = dict(speed_m_per_s=pint.Quantity(2000.0, "mm/s"))
    units["oil_density_kg_per_m3"] = pint.Quantity(0.87, "g/cm^3")
    for found in (
        tb.lab.compare(runs(), **oil, **rest),
        tb.lab.compare(runs(), **units, **rest),
        tb.lab.compare(runs(**{"speed [m/s]": 2.0}), oil_density_kg_per_m3=870, **rest),
        tb.lab.compare(runs(**{"speed [m/s]": 2.0}), parameters=tb.bearing(**oil), **rest),
    ):
        for name in (f"{FRACTION}_model", f"{FRACTION}_low"):
            np.testing.assert_allclose(found[name], expected[name], rtol=1e-9)


def test_the_index_is_that_of_the_measurements(runs, rest):
    table = runs(run=["a", "a", "b"], step=[1, 2, 1]).set_index(["run", "step"])
    assert tb.lab.compare(table, **rest).index.equals(table.index)
    some = runs().set_axis(["x", "y", "z"])[1:]
    oils = pd.Series([50.0, 90.0], index=["y", "z"])
    found = tb.lab.compare(some, **rest | {"viscosity_cSt": oils})
    assert found["viscosity_cSt"].to_dict() == oils.to_dict()
    with pytest.raises(ValueError):
        tb.lab.compare(some, **rest | {"viscosity_cSt": oils.set_axis([1, 2])})


def test_what_the_library_writes_is_compared(tmp_path, rest):
    loads = pd.Series([5.0, 10.0], index=["a", "b"])
    solved = tb.solve(load_N=loads, **rest).to_dataframe()
    solved.to_csv(tmp_path / "solved.csv")
    for measured in (solved, tmp_path / "solved.csv"):
        found = tb.lab.compare(measured)
        names = [row["quantity"] for row in found.attrs["summary"]]
        assert names == ["solid_load_fraction", "fluid_load_fraction", "separation_nm"]
        for name in names:
            np.testing.assert_allclose(found[f"{name}_residual"], 0.0, atol=1e-5)


def test_what_is_given_twice_or_has_no_effect_is_refused(runs, rest):
    for error, arguments in (
        (TypeError, dict(load_N=5)),
        (ValueError, dict(load=1e-5)),
        (ValueError, dict(oil_density_kg_per_m3=870)),
        (TypeError, dict(force=3)),
    ):
        with pytest.raises(error):
            tb.lab.compare(runs(), **rest, **arguments)
    with pytest.raises(TypeError):
        tb.lab.compare(runs(**{"speed [m/s]": 2.0}), speed_m_per_s=2.0, **rest)
    with pytest.raises(ValueError):
        tb.lab.compare(runs())
    with pytest.raises(FileNotFoundError):
        tb.lab.compare("absent.csv", **rest)


@pytest.mark.parametrize("load", [0.0, -1.0, np.nan, np.inf])
def test_loads_that_no_interface_has_are_refused(runs, rest, load):
    with pytest.raises(ValueError):
        tb.lab.compare(runs(**{"load [N]": [1.0, 2.0, load]}), **rest)


def test_a_model_without_solution_or_without_members(runs, rest, defaults):
    none = tb.lab.compare(runs(), **rest | {"particle_diameter_nm": 9e5})
    assert none.attrs["summary"][0]["count"] == 0
    assert none[f"{FRACTION}_model"].isna().all()
    alone = tb.lab.compare(runs(), parameters=defaults.with_members([]), **rest)
    assert f"{FRACTION}_low" not in alone
    assert alone.attrs["summary"][0]["inside_range"] is None


def test_the_curve_goes_along_the_condition_that_varies(runs, rest, defaults):
    table = tb.lab.compare(runs(), **rest)
    axes = tb.lab.plot_comparison(table).axes[0]
    loads, curve = axes.lines[0].get_data()
    assert table.attrs["along"] == "load_N" and len(loads) == 80
    np.testing.assert_allclose(curve[[0, -1]], table[f"{FRACTION}_model"].iloc[[0, -1]], rtol=1e-6)
    (outline,) = axes.collections[0].get_paths()
    for end in ("low", "high"):
        for load, height in zip(loads[[0, -1]], table[f"{FRACTION}_{end}"].iloc[[0, -1]]):
            assert np.isclose(outline.vertices, (load, height), rtol=1e-6).all(axis=1).any()
    two = {key: value for key, value in rest.items() if key != "viscosity_cSt"}
    table_of_two = tb.lab.compare(runs(**{"viscosity [cSt]": [0, 50, 90]}), **two)
    assert len(tb.lab.plot_comparison(table_of_two).axes[0].lines[0].get_xdata()) == 3
    with pytest.raises(ValueError):
        tb.lab.plot_comparison(table, defaults.changed(participation=0.3))


def test_the_curve_of_speeds_has_their_oil(runs, rest):
    speeds = runs(**{"load [N]": 10.0, "speed [m/s]": [1.0, 2.0, 4.0], "COF": [0.1, 0.09, 0.08]})
    table = tb.lab.compare(speeds, oil_density_kg_per_m3=900, **rest)
    curve = tb.lab.plot_comparison(table).axes[1].lines[0]
    assert table.attrs["along"] == "speed_m_per_s" and len(curve.get_xdata()) == 80
    last = table["friction_coefficient_model"].iloc[-1]
    assert curve.get_ydata()[-1] == pytest.approx(last)


def test_figures(runs, rest, tmp_path):
    pytest.importorskip("matplotlib")
    two = {key: value for key, value in rest.items() if key != "viscosity_cSt"}
    for table in (
        tb.lab.compare(runs(**{"separation [nm]": 900.0}), **rest),
        tb.lab.compare(runs(**{"viscosity [cSt]": [0, 50, 90], "separation [nm]": 900.0}), **two),
    ):
        figure = tb.lab.plot_comparison(table)
        assert len(figure.axes) == 2
        (*_, measured) = figure.axes[0].lines
        assert sorted(measured.get_xdata()) == sorted(table[table.attrs["along"]])
