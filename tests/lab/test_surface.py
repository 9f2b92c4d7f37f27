"""Roughness of two surfaces, and summits of measured topographies."""

import numpy as np
import pandas as pd
import pint
import pytest

import thirdbody as tb

COUNT, SIZE, AMPLITUDE = 192, 50e-6, 1e-7
NUMBER, SPACING = 2.0 * np.pi * 16 / SIZE, SIZE / COUNT


@pytest.fixture(scope="module")
def waves():
    """Waves of known moments on a tilt: x, y and heights [m]."""
    pytest.importorskip("SurfaceTopography")
    x, y = np.meshgrid(*2 * [np.arange(COUNT) * SPACING], indexing="ij")
    return x, y, AMPLITUDE * (np.cos(NUMBER * x) + np.cos(NUMBER * y)) + 0.01 * x


@pytest.fixture(scope="module")
def path(waves, tmp_path_factory):
    """The waves in a file, in um."""
    path = tmp_path_factory.mktemp("waves") / "waves.xyz"
    np.savetxt(path, 1e6 * np.column_stack([each.ravel() for each in waves]))
    return path


@pytest.mark.parametrize("steps", [1, 4])
def test_the_summits_are_those_of_the_moments_over_the_scale(path, steps):
    scale = steps * SPACING
    found = tb.lab.surface(path, unit="um", scale_nm=1e9 * scale).loc["equivalent"]
    apparent = 2.0 * np.sin(0.5 * NUMBER * scale) / scale  # of differences over it
    m_0, m_2, m_4 = AMPLITUDE**2 * np.array([1.0, apparent**2 / 2, apparent**4 / 2])
    assert found["roughness"] == pytest.approx(np.sqrt(m_0), rel=0.01)
    assert found["slope"] == pytest.approx(np.sqrt(m_2), rel=0.02)
    assert found["curvature"] == pytest.approx(np.sqrt(m_4), rel=0.02)
    density = m_4 / (6 * np.sqrt(3) * np.pi * m_2)
    assert found["summit_density"] == pytest.approx(density, rel=0.04)
    assert found["summit_radius"] == pytest.approx(0.375 * np.sqrt(np.pi / m_4), rel=0.03)
    assert found["scale"] == pytest.approx(scale)


def test_files_arrays_and_topographies_are_the_same(path, waves):
    from SurfaceTopography import Topography

    heights = waves[2]
    topography = Topography(1e6 * heights, (1e6 * SIZE,) * 2, unit="um")
    expected = tb.lab.surface(path, unit="um").loc["equivalent"]
    for found in (
        tb.lab.surface(1e9 * heights, spacing_nm=1e9 * SPACING),
        tb.lab.surface(1e9 * heights, spacing_nm=pint.Quantity(1e6 * SPACING, "um")),
        tb.lab.surface(1e6 * heights, physical_sizes=(1e6 * SIZE,) * 2, unit="um"),
        tb.lab.surface(topography),
    ):
        pd.testing.assert_series_equal(found.loc["equivalent"], expected, rtol=1e-4)


def test_moments_of_two_surfaces_add_and_become_inputs(path, defaults):
    table = tb.lab.surface(path, path, unit="um")
    assert len(table) == 3 and table.index.is_unique
    one, _, both = (table.iloc[row] for row in range(3))
    assert both["roughness"] == pytest.approx(np.sqrt(2.0) * one["roughness"])
    assert both["summit_density"] == pytest.approx(one["summit_density"])
    assert both["summit_radius"] == pytest.approx(one["summit_radius"] / np.sqrt(2.0))
    inputs = tb.lab.surface_parameters(table)
    for each in (inputs, *inputs.members):
        summits = each.surface(both["roughness"])
        assert summits.summit_radius == pytest.approx(both["summit_radius"])
        assert summits.summit_density == pytest.approx(both["summit_density"])
    assert len(inputs.members) == len(defaults.members)
    own = defaults.changed(participation=0.3)
    assert tb.lab.surface_parameters(table, own).participation == 0.3


def test_the_form_of_a_ball_is_no_roughness():
    pytest.importorskip("SurfaceTopography")
    rough = 100.0 * np.random.default_rng(2).standard_normal((128, 128))  # nm
    x = 1000.0 * (np.arange(128) - 63.5)
    ball = rough - (x[:, np.newaxis] ** 2 + x**2) / (2.0 * 6.35e6)
    with pytest.warns(tb.OutOfRangeWarning, match="parabola"):
        left = tb.lab.surface(ball, spacing_nm=1000)
    assert left.loc["equivalent", "roughness"] > 150e-9
    found = tb.lab.surface(ball, spacing_nm=1000, form="curvature")
    assert found.loc["equivalent", "roughness"] == pytest.approx(100e-9, rel=0.02)


@pytest.mark.filterwarnings("error::thirdbody.conditions.OutOfRangeWarning")
def test_a_flat_is_not_warned_of(path):
    for form in ("tilt", "curvature"):
        found = tb.lab.surface(path, unit="um", form=form).loc["equivalent", "roughness"]
        assert found == pytest.approx(AMPLITUDE, rel=0.02)


def test_a_tilt_that_is_left_is_warned_of(path):
    with pytest.warns(tb.OutOfRangeWarning, match="tilt"):
        found = tb.lab.surface(path, unit="um", form="none").loc["equivalent", "roughness"]
    assert found == pytest.approx(np.hypot(0.01 * SIZE / np.sqrt(12.0), AMPLITUDE), rel=0.02)


def test_missing_points_are_interpolated(waves):
    heights = 1e9 * waves[2]
    gaps = heights.copy()
    gaps[10, 20:24] = np.nan
    whole, found = (tb.lab.surface(each, spacing_nm=1e9 * SPACING) for each in (heights, gaps))
    np.testing.assert_allclose(found, whole, rtol=0.01)


def test_what_is_no_topography_is_refused(path, waves):
    heights = 1e9 * waves[2]
    size = dict(spacing_nm=1e9 * SPACING)
    for surfaces, options in [
        ((path,), {}),  # no unit
        ((heights,), dict(physical_sizes=(1.0, 1.0))),
        ((path,), dict(unit="um", scale_nm=1)),
        ((path,), dict(unit="um", scale_nm=1e6)),
        ((path,), dict(unit="um", form="ball")),
        ((0.0 * heights,), size),
        ((heights, heights, heights), size),
        ((), size),
    ]:
        with pytest.raises(ValueError):
            tb.lab.surface(*surfaces, **options)
    with pytest.raises(FileNotFoundError):
        tb.lab.surface("absent.xyz")
    with pytest.raises(TypeError):
        tb.lab.surface(heights)


def test_heights_in_another_unit_than_lengths_are_warned_of(waves, tmp_path):
    x, y, z = (each.ravel() for each in waves)
    mixed = tmp_path / "mixed.xyz"
    np.savetxt(mixed, np.c_[1e3 * x, 1e3 * y, 1e6 * z])  # lengths in mm, heights in um
    with pytest.warns(tb.OutOfRangeWarning, match="height_scale_factor=0.001"):
        tb.lab.surface(mixed, unit="mm")


def test_the_roughness_of_two_surfaces():
    assert tb.lab.equivalent_roughness(Rq=(240, 180)) == 300.0
    expected = 300.0 * np.sqrt(np.pi / 2.0)
    assert tb.lab.equivalent_roughness(Ra=(240, 180)) == pytest.approx(expected)
    for bad in ({}, {"Rq": 3}, {"Rq": (1, 2, 3)}, {"Ra": (1, -2)}, {"Rq": (1, 2), "Ra": (1, 2)}):
        with pytest.raises((TypeError, ValueError)):
            tb.lab.equivalent_roughness(**bad)


def test_the_roughness_of_surfaces_with_units_and_of_tables():
    lengths = pint.Quantity(0.24, "um"), pint.Quantity(180.0, "nm")
    assert tb.lab.equivalent_roughness(Rq=lengths).to("nm").magnitude == pytest.approx(300.0)
    table = pd.DataFrame({"ball": [240.0, 30.0], "flat": [180.0, 40.0]}, index=["a", "b"])
    found = tb.lab.equivalent_roughness(Rq=(table["ball"], table["flat"]))
    assert found.to_dict() == {"a": 300.0, "b": 50.0}
    with pytest.raises(ValueError):
        tb.lab.equivalent_roughness(Rq=(table["ball"], table["flat"].reset_index(drop=True)))
    with pytest.raises(pint.DimensionalityError):
        tb.lab.equivalent_roughness(Rq=(lengths[0], 180.0))
