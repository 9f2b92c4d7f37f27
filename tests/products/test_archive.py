"""Datasets as others see them: the data contract, CF and ACDD."""

import re
import sys
from pathlib import Path

import netCDF4
import numpy as np
import pytest

import thirdbody as tb
from chenhorng.configuration.settings import read_settings
from thirdbody.core.regimes import SOLUTION_STATUSES
from thirdbody.variables import QUANTITIES

ROOT = Path(__file__).resolve().parents[2]
pytestmark = pytest.mark.results
EVERY = 11  # points between those at which integrals are taken anew


@pytest.fixture(scope="module")
def verification():
    """The modules of ``verification/`` that know the contract and read datasets."""
    sys.path.append(str(ROOT / "verification"))
    import contract
    import recompute

    yield contract, recompute
    sys.path.remove(str(ROOT / "verification"))


@pytest.fixture(scope="session")
def path(figure, results):
    return results / "datasets" / f"{figure}.nc"


@pytest.fixture(scope="module")
def stored(path):
    with netCDF4.Dataset(path) as opened:
        yield opened


@pytest.fixture(scope="module")
def config():
    """The default configuration."""
    return read_settings({}, ROOT / "config")["config"]


def test_every_shown_point_is_solved(curves):
    _, values = curves
    # converged, or outside the meaning of the film formula, which is said and not hidden; next to
    # where the largest particles lose touch float64 may not hold all digits that were asked for
    status = values["solution_status"]
    assert set(np.unique(status)) <= {0.0, 1.0, 3.0}
    assert (status == SOLUTION_STATUSES.index("not_converged")).mean() < 2e-3
    for name in QUANTITIES:
        assert (values[name] >= 0.0).all() and np.isfinite(values[name]).all(), name


def test_axes_points_and_inputs_are_those_of_the_configuration(
    stored, figure, config, verification
):
    contract, recompute = verification
    data = recompute.read(stored)
    inputs = tb.load_parameters().best.as_dict()
    assert list(contract.configuration_findings(data, figure, config, inputs)) == []
    assert all((np.diff(data.axes[name]) > 0.0).all() for name in contract.DIMENSIONS)


def test_points_fulfil_the_equations_written_a_second_time(stored, verification):
    _, recompute = verification
    data = recompute.read(stored)
    for index in np.argwhere(data.shown)[::EVERY]:
        found, _ = recompute.point_findings(data, tuple(index), is_sampled=False)
        assert not found


def test_attributes_hold_no_time_of_day_and_no_folder(stored, path):
    owners = [stored, *stored.variables.values()]
    texts = [str(owner.getncattr(name)) for owner in owners for name in owner.ncattrs()]
    for text in texts:
        assert not re.search(r"\d\d:\d\d:\d\d|\dT\d\d", text), text
        assert str(path.parents[2]) not in text


def test_cf_and_acdd_find_nothing_but_what_does_not_apply(findings_in, results):
    """In one file: what is written of a variable, an axis or a dataset is the same in all."""
    assert findings_in(results / "datasets" / "fig04.nc") == {"CF": [], "ACDD": []}
