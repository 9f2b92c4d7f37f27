"""Particles per area of a film, from the code of ISO 4406 and from a mass."""

import numpy as np
import pandas as pd
import pint
import pytest

import thirdbody as tb

# ISO 4406:2021, Table 1: particles per mL, more than and up to, by scale number
TABLE = {
    28: (1.3e6, 2.5e6),
    24: (80e3, 160e3),
    20: (5000, 10000),
    19: (2500, 5000),
    18: (1300, 2500),
    17: (640, 1300),
    16: (320, 640),
    13: (40, 80),
    10: (5, 10),
    8: (1.3, 2.5),
    1: (0.01, 0.02),
    0: (0.0, 0.01),
}


@pytest.mark.parametrize("number", TABLE)
def test_classes_of_the_standard(number):
    found = tb.lab.cleanliness(f"{number}/{number}/{number}", gap_nm=1000)
    least, most = TABLE[number]  # times 1e6 mL in a m3, times a height of 1e-6 m
    assert found["least_per_m2"].tolist() == pytest.approx([least] * 3)
    assert found["most_per_m2"].tolist() == pytest.approx([most] * 3)


def test_the_film_and_the_enrichment_scale_the_count():
    whole = tb.lab.cleanliness("ISO 18/16/13", gap_nm=1000)
    assert whole["size_um"].tolist() == [4, 6, 14]
    half = tb.lab.cleanliness(
        "ISO 4406:2021 */16 / 13", gap_nm=pint.Quantity(0.5, "um"), enrichment=2
    )
    assert half["size_um"].tolist() == [6, 14]
    assert half["most_per_m2"].tolist() == pytest.approx(whole["most_per_m2"].tolist()[1:])


@pytest.mark.parametrize(
    "code", ["", "18/16", "18/16/13/1", "16/18/13", "99/1/1", "a/b/c", "-/-/-", "18/16/-1"]
)
def test_what_is_no_code_is_refused(code):
    with pytest.raises(ValueError):
        tb.lab.cleanliness(code, gap_nm=1000)


def test_less_than_one_particle_in_the_nominal_area_is_said(defaults):
    few = tb.lab.cleanliness("18/16/13", gap_nm=1000)
    assert len(few.attrs["notes"]) == 3
    assert f"{2500.0 * defaults.apparent_area:.2g} " in few.attrs["notes"][0]
    wide = defaults.changed(apparent_area=1e-4)
    assert not tb.lab.cleanliness("28/28/28", gap_nm=1000, parameters=wide).attrs["notes"]


def test_a_mass_is_a_number_of_spheres():
    found = tb.lab.debris_density(mg_per_L=100.0, particle_diameter_nm=500, gap_nm=1000)
    sphere = 7850.0 * np.pi / 6.0 * 5e-7**3  # kg
    assert found["particles_per_mL"].item() == pytest.approx(0.1 / sphere * 1e-6)
    assert found["particle_density_per_m2"].item() == pytest.approx(0.1 / sphere * 1e-6)


def test_masses_in_other_units_are_the_same():
    size = dict(particle_diameter_nm=500, gap_nm=800, oil_density_kg_per_m3=900)
    expected = tb.lab.debris_density(mg_per_L=90.0, **size)["particle_density_per_m2"].item()
    for mass in (
        {"ppm": 100.0},
        {"percent": 0.01},
        {"percent": pint.Quantity(100.0, "ppm")},
        {"mg_per_L": pint.Quantity(0.09, "kg/m^3")},
    ):
        found = tb.lab.debris_density(**mass, **size)["particle_density_per_m2"].item()
        assert found == pytest.approx(expected)
    alumina = tb.lab.debris_density(mg_per_L=90.0, material_density_kg_per_m3=3925.0, **size)
    assert alumina["particle_density_per_m2"].item() == pytest.approx(2.0 * expected)


def test_samples_of_a_table_keep_their_index():
    samples = pd.Series([10.0, 100.0, 0.0], index=["new", "used", "none"])
    found = tb.lab.debris_density(ppm=samples, particle_diameter_nm=500, gap_nm=1000, enrichment=3)
    density = found["particle_density_per_m2"]
    assert density["used"] == pytest.approx(10.0 * density["new"]) and density["none"] == 0.0
    assert found.attrs["notes"]


def test_what_is_no_mass_is_refused():
    size = dict(particle_diameter_nm=500, gap_nm=1000)
    for bad in ({}, {"ppm": 1, "percent": 1}, {"ppm": -1}, {"ppm": 1, "enrichment": 0}):
        with pytest.raises(ValueError):
            tb.lab.debris_density(**size, **bad)
    with pytest.warns(tb.OutOfRangeWarning):
        tb.lab.debris_density(ppm=1, gap_nm=1e-6, particle_diameter_nm=500)
