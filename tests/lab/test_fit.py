"""Inputs fitted to measurements that known inputs give."""

import numpy as np
import pandas as pd
import pytest

import thirdbody as tb

LOADS = np.geomspace(1.0, 50.0, 9)
UNKNOWNS = ["participation", "apparent_area"]
TRUTH = {"participation": 0.4, "apparent_area": 4.2e-6}
ERROR = 0.02


@pytest.fixture(scope="module")
def start(defaults):
    """The calibrated inputs without members, so that nothing but the data tells the unknowns."""
    return defaults.with_members(())


def measurements(inputs, conditions, seed=None):
    """Friction, separation and resistance of the model, with scatter if there is a seed."""
    points = tb.solve(load_N=LOADS, parameters=inputs, **conditions)
    scatter = np.zeros((3, LOADS.size))
    if seed is not None:
        scatter = ERROR * np.random.default_rng(seed).standard_normal(scatter.shape)
    friction = tb.lab.friction(points)
    size = np.sqrt((friction**2).mean())  # the scatter of ratios is the same in all rows
    return pd.DataFrame(
        {
            "load [N]": LOADS,
            "COF": friction + size * scatter[0],
            "separation [m]": points.separation * (1.0 + scatter[1]),
            "contact resistance [ohm]": tb.lab.contact_resistance(points) * (1.0 + scatter[2]),
        }
    )


def test_the_inputs_of_exact_measurements_are_found(start, rest):
    data = measurements(start.changed(**TRUTH), rest)
    table = tb.lab.fit(data, UNKNOWNS, parameters=start, relative_error=ERROR, **rest)
    np.testing.assert_allclose(table["value"], [TRUTH[name] for name in UNKNOWNS], rtol=1e-5)
    assert table.attrs["misfit"] < 1e-4
    inputs = table.attrs["parameters"]
    assert inputs == start.changed(**table["value"].to_dict())
    assert table["prior"].isna().all()


def test_standard_errors_are_the_scatter_of_many_fits(start, rest):
    truth = start.changed(**TRUTH)
    scores = []
    for seed in range(12):
        data = measurements(truth, rest, seed)
        table = tb.lab.fit(data, UNKNOWNS, parameters=start, relative_error=ERROR, **rest)
        expected = pd.Series(TRUTH)[table.index]
        scores.append((table["value"] - expected) / table["standard_error"])
        assert 0.5 < table.attrs["misfit"] < 1.5
    size = np.sqrt(np.mean(np.square(scores)))
    assert 0.6 < size < 1.7 and np.abs(scores).max() < 4.0


def test_the_prior_is_that_of_the_ensemble(defaults, rest):
    data = measurements(defaults.members[4], rest, seed=1)
    table = tb.lab.fit(data, ["summit_radius"], relative_error=1e3, **rest)
    logarithms = np.log([member.summit_radius for member in defaults.members])
    row = table.loc["summit_radius"]
    assert row["value"] == pytest.approx(np.exp(logarithms.mean()), rel=1e-3)
    assert row["standard_error"] == pytest.approx(row["prior_deviation"], rel=1e-3)
    deviation = np.exp(logarithms.mean()) * logarithms.std(ddof=1)
    assert row["prior_deviation"] == pytest.approx(deviation)
    assert row["told_by_data"] == pytest.approx(0.0, abs=1e-3)
    assert any("summit_radius" in note for note in table.attrs["notes"])


def test_data_and_prior_share_what_is_known(defaults, rest):
    """One unknown of which the model is nearly linear: the precisions of data and prior add."""
    data = measurements(defaults.members[4], rest, seed=2)
    both = tb.lab.fit(data, ["apparent_area"], relative_error=0.2, **rest).iloc[0]
    free = defaults.with_members(())
    alone = tb.lab.fit(data, ["apparent_area"], relative_error=0.2, parameters=free, **rest).iloc[0]
    errors = alone["standard_error"] / alone["value"], both["prior_deviation"] / both["prior"]
    expected = np.sum(1.0 / np.square(errors)) ** -0.5
    assert both["standard_error"] / both["value"] == pytest.approx(expected, rel=0.05)
    told = 1.0 - (both["standard_error"] / both["value"] / errors[1]) ** 2
    assert both["told_by_data"] == pytest.approx(told)


def test_coefficients_are_unknowns_too(defaults, rest):
    points = tb.solve(load_N=LOADS, **rest)
    data = pd.DataFrame({"load [N]": LOADS, "COF": tb.lab.friction(points, 0.1, 0.05)})
    table = tb.lab.fit(data, ["boundary_friction", "film_friction"], **rest)
    np.testing.assert_allclose(table["value"], [0.1, 0.05], rtol=1e-4)
    assert table.attrs["coefficients"]["film_friction"] == pytest.approx(0.05, rel=1e-4)
    assert table.attrs["parameters"] == defaults


def test_what_measurements_cannot_tell_is_said(start, rest):
    dry = rest | {"viscosity_cSt": 0}
    data = measurements(start, dry)
    table = tb.lab.fit(data, ["speed_per_viscosity"], parameters=start, **dry)
    assert table["told_by_data"].tolist() == [0.0]
    assert "speed_per_viscosity" in table.attrs["notes"][0]
    alike = ["boundary_friction", "film_friction"]
    one = pd.DataFrame({"load [N]": [10.0, 10.0], "COF": [0.09, 0.09]})
    table = tb.lab.fit(one, alike, parameters=start, **rest)
    assert any("combination" in note for note in table.attrs["notes"])


def test_an_error_that_does_not_agree_with_the_misfit_is_said(start, rest):
    data = measurements(start, rest, seed=3)
    table = tb.lab.fit(data, ["apparent_area"], parameters=start, relative_error=ERROR / 10, **rest)
    assert table.attrs["misfit"] == pytest.approx(10.0, rel=0.3)
    assert any("relative_error" in note for note in table.attrs["notes"])


def test_speeds_scale_the_film(start, rest):
    speeds = dict(speed_m_per_s=2.0, oil_density_kg_per_m3=870)
    inputs = tb.bearing(start, **speeds)
    data = measurements(inputs.changed(apparent_area=5e-6), rest)
    table = tb.lab.fit(data, ["apparent_area"], parameters=start, **speeds, **rest)
    assert table["value"].item() == pytest.approx(5e-6, rel=1e-4)


def test_what_cannot_be_fitted_is_refused(rest):
    data = pd.DataFrame({"load [N]": LOADS, "COF": 0.1})
    for name in ("summit_radius_exponent", "film_load", "members", "oil"):
        with pytest.raises(ValueError):
            tb.lab.fit(data, [name], **rest)
    with pytest.raises(ValueError):
        tb.lab.fit(data, ["participation"], relative_error=0.0, **rest)
    with pytest.raises(ValueError):
        tb.lab.fit(data, ["participation"])
