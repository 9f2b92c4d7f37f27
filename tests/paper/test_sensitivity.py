"""Sensitivities against power laws and the physics that forbids a response."""

from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest
from numpy.testing import assert_allclose

from chenhorng.claims.evidence import FULL_EFFORT, solve_evidence
from chenhorng.figures.sensitivity import LEAST, NUMBERS, plot
from chenhorng.sensitivity import (
    STEP,
    Subject,
    elasticities,
    last_crossings,
    sensitivity_rows,
    varied_inputs,
)
from chenhorng.tables import TABLES, read_csv, write_csv
from thirdbody.core.transitions import LIMITS
from thirdbody.files import read_yaml
from thirdbody.points import solve

ROOT = Path(__file__).parents[2]
CONFIG = ROOT / "config"
SETTINGS = read_yaml(CONFIG / "sensitivity.yaml")
EXPONENTS = np.array([[2.0, -0.5, 0.0], [14.0, 1.0, -3.0]])
INPUTS = {"first": 0.3, "second": -2.0, "third": 5e-6}


@pytest.fixture(scope="module")
def subject():
    return Subject.of(SETTINGS)


def test_what_is_varied_beside_the_unknowns_is_not_among_them():
    unknowns = read_yaml(CONFIG / "calibration.yaml")["unknowns"]
    assert SETTINGS["also"] and not unknowns.keys() & set(SETTINGS["also"])


def power_laws(changes):
    """Outputs that are products of powers of the inputs over their defaults."""
    ratios = np.array([changes.get(name, value) / value for name, value in INPUTS.items()])
    return 7.0 * np.prod(ratios**EXPONENTS, axis=1)


def test_elasticities_are_the_exponents_of_power_laws():
    def values(changes):
        return np.append(power_laws(changes), np.nan)  # the last does not occur

    found, error = elasticities(values, values({}), INPUTS)
    assert np.isnan(found[-1]).all() and np.isnan(error[-1]).all()
    # truncation: e(e-1)(e-2)/6 of the squared step, at most 364 for an exponent of 14
    assert_allclose(found[:-1], EXPONENTS, rtol=0, atol=365 * STEP**2)
    assert_allclose(error[:-1], 0.0, atol=4 * 365 * STEP**2)


def test_an_input_at_its_upper_bound_is_stepped_inwards():
    seen = []

    def values(changes):
        seen.append(changes["participation"])
        return np.array([changes["participation"] ** 2])

    found, error = elasticities(values, np.array([1.0]), {"participation": 1.0})
    assert max(seen) == 1.0
    assert_allclose(found, [[2.0]], atol=1e-5)
    assert error.max() < 1e-4


def test_crossings_are_where_the_limits_are_crossed(subject, parameters):
    asked = {"curve": set(subject.transitions), "turning_point": set(), "window": set()}
    evidence = solve_evidence(parameters, asked, subject.newtons)
    found = last_crossings(evidence, subject.transitions)
    assert np.isfinite(found).any()
    for condition, loads in zip(subject.transitions, found, strict=True):
        for (quantity, level), load in zip(LIMITS, loads, strict=True):
            values = evidence.curves[condition][quantity]
            if np.isnan(load):
                assert (values > level).all() or (values < level).all()
            else:
                solved = solve(load=load, **condition._asdict(), parameters=parameters)
                assert_allclose(getattr(solved, quantity), level, rtol=1e-6)


def test_what_cannot_respond_does_not(subject, parameters):
    only = replace(subject, transitions=(), window_roughness=())
    # A_n enters through the film alone; exponents act away from the reference roughness
    inputs = varied_inputs(parameters, ["apparent_area", "summit_radius_exponent", "participation"])

    def values(changes):
        return only.values(replace(parameters, **changes), FULL_EFFORT)

    found, error = elasticities(values, values({}), inputs)
    dry_load, dry_ratio, wet_load, wet_ratio = found
    assert_allclose([dry_load[0], dry_ratio[0], wet_ratio[0]], 0.0, atol=STEP**2)
    assert wet_load[0] < -0.1
    assert_allclose(found[:, 1], 0.0, atol=STEP**2)
    assert (np.abs(found[:2, 2]) > 0.01).all()
    assert_allclose(error, 0.0, atol=1e-3)


def test_table_and_figure_show_every_sensitivity_and_say_what_is_missing(subject, tmp_path, style):
    shape = len(subject.outputs), len(INPUTS)
    base = np.linspace(1.0, 2.0, shape[0])
    base[3] = np.nan
    value = np.linspace(-1.0, 1.0, base.size * shape[1]).reshape(shape)
    rows = sensitivity_rows(subject, base, INPUTS, value, 0.01 * value**2)
    assert len(rows) == (len(base) - 1) * len(INPUTS) + 1
    (missing,) = (row for row in rows if not row["input"])
    assert missing["value"] is missing["elasticity"] is missing["input_value"] is None
    path = tmp_path / "sensitivity.csv"
    write_csv(path, rows, TABLES["sensitivity"])
    assert "nan" not in path.read_text()
    symbols = dict.fromkeys(INPUTS, "sigma_s/sigma")
    drawing = plot(read_csv(path, TABLES["sensitivity"]), symbols)
    axes, (panel,) = drawing.axes[0], drawing.panels  # the colour bar follows
    expected = np.delete(value, 3, axis=0)
    expected = expected[:, (np.abs(expected) >= LEAST).any(axis=0)]  # no empty rows
    drawn = np.sort([float(series.name.split("; ")[-1]) for series in panel.series])
    assert_allclose(drawn, np.sort(expected.ravel()), atol=1e-9)
    # each in a cell of its own, and its number in it where it is not negligible
    assert len({(one.x.min(), one.y.min()) for one in panel.series}) == len(panel.series)
    assert len(axes.texts) == (np.abs(expected) >= LEAST).sum()
    assert all("$σ_{s}$/$σ$" in label.get_text() for label in axes.get_yticklabels())
    decisive = len({*np.argmax(np.abs(expected), axis=1)})
    assert panel.title.endswith(f"one of {NUMBERS[decisive]} inputs")
