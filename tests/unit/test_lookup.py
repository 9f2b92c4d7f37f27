"""The table for real time keeps the error that it says, and says where it cannot be asked."""

import numpy as np
import pytest

import thirdbody as tb
from thirdbody.atlas.lookup import Lookup
from thirdbody.atlas.smallest import ALLOWED, Counts, allowed_misses, search_lookup
from thirdbody.configuration.plain_yaml import read_yaml
from thirdbody.configuration.schema import config_directory
from thirdbody.data.netcdf import write_netcdf

AXES = read_yaml(config_directory() / "atlas.yaml")["axes"]
SETTINGS = {
    **{"error": 0.02, "share": 0.99, "search_points": 2000, "check_points": 4000},
    **{"most_numbers": 20000, "seed": 7},
}


@pytest.fixture(scope="module")
def lookup(defaults):
    return search_lookup(defaults, AXES, SETTINGS)


def shares(parameters, load, viscosity, diameter, roughness, density):
    found = tb.solve(
        load=np.divide(load, parameters.newtons_per_load),
        viscosity=np.multiply(viscosity, 1e-6),
        particle_diameter=np.multiply(diameter, 1e-9),
        roughness=np.multiply(roughness, 1e-9),
        particle_density=density,
        parameters=parameters,
    )
    return found.solid_load_fraction, found.particle_contact_area_ratio


def drawn(count, seed):
    ends = np.array([[float(axis["from"]), float(axis["to"])] for axis in AXES.values()])
    share = np.random.default_rng(seed).random((5, count))
    evenly = ends[:, :1] + share * (ends[:, 1:] - ends[:, :1])
    logarithmic = [[axis["scale"] == "logarithmic"] for axis in AXES.values()]
    return np.where(logarithmic, ends[:, :1] * (ends[:, 1:] / ends[:, :1]) ** share, evenly)


def test_it_keeps_the_error_at_other_conditions(lookup, defaults):
    conditions = drawn(3000, 11)
    errors = np.max(np.abs(np.subtract(lookup(*conditions), shares(defaults, *conditions))), axis=0)
    assert (errors <= SETTINGS["error"]).mean() > 0.97
    told = lookup.tables.attrs
    assert (errors <= SETTINGS["error"]).mean() == pytest.approx(
        told["error_kept_in_share"], abs=0.01
    )
    quantiles = (told[f"error_quantile_{percent}_percent"] for percent in ("99", "99_9"))
    assert 0.0 < next(quantiles) <= next(quantiles) <= told["largest_error"]
    assert told["checked_conditions"] == SETTINGS["check_points"]
    assert told["error_kept_in_share"] >= SETTINGS["share"]


def test_it_is_small(lookup):
    stored = sum(table.size for table in lookup.tables.data_vars.values())
    assert stored == lookup.tables.attrs["numbers"] < 600


@pytest.mark.parametrize(
    "conditions",
    [(10, 0, 300, 300, 1e11), (10, 90, 0, 300, 1e11), (10, 90, 300, 300, 0), (1, 0, 0, 200, 0)],
)
def test_dry_and_bare_contact_can_be_asked_for(lookup, defaults, conditions):
    found = lookup(*conditions)
    np.testing.assert_allclose(found, shares(defaults, *conditions), atol=SETTINGS["error"])


@pytest.mark.parametrize("place", range(5))
def test_beyond_what_it_spans_it_says_nothing(lookup, place):
    conditions = [10.0, 90.0, 300.0, 300.0, 1e11]
    assert np.isfinite(lookup(*conditions)).all()
    for factor in (1e-4, 1e4):
        beyond = list(conditions)
        beyond[place] *= factor
        assert np.isnan(lookup(*beyond)).all()


def test_conditions_broadcast(lookup):
    loads = np.geomspace(0.1, 10.0, 3)[:, np.newaxis]
    solid, ratio = lookup(loads, [0.0, 90.0], 300, 300, 1e11)
    assert solid.shape == ratio.shape == (3, 2)
    assert solid[1, 1] == lookup(loads[1, 0], 90.0, 300, 300, 1e11)[0]


def test_a_file_holds_all_of_it(lookup, tmp_path):
    write_netcdf(lookup.tables, tmp_path / "lookup.nc", {})
    again = Lookup.read(tmp_path / "lookup.nc")
    conditions = drawn(100, 3)
    np.testing.assert_array_equal(again(*conditions), lookup(*conditions))
    with pytest.raises(OSError, match="cannot be read"):
        Lookup.read(__file__)


def test_every_reading_has_a_table_or_is_refused(reading):
    settings = SETTINGS | {"search_points": 300, "check_points": 500, "error": 0.05, "share": 0.9}
    fit = all(getattr(reading, name) in words for name, words in ALLOWED.items())
    if fit:
        found = search_lookup(reading, AXES, settings)
        assert found.tables.attrs["error_kept_in_share"] > 0.85
    else:
        with pytest.raises(ValueError, match=r"is \w+; allowed for a lookup table: "):
            search_lookup(reading, AXES, settings)


def test_numbers_are_counted():
    assert Counts(3, 2, 5, 4).numbers == 2 * 3 * 2 + 2 + 3 * 5 + 4 + 8


def test_a_table_is_better_at_the_search_than_it_has_to_be():
    searched, checked = 50_000, 100_000
    misses = allowed_misses(0.999, searched, checked)
    for count, keeps in ((misses, True), (misses + 1, False)):
        share = count / searched
        chance = 3.0 * np.sqrt(share / searched + share / checked)
        assert (share + chance <= 1e-3) == keeps
    assert allowed_misses(1.0, searched, checked) == 0
