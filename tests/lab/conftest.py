"""Conditions and measurements that tests of the laboratory share."""

import pandas as pd
import pytest

import thirdbody as tb


@pytest.fixture
def rest():
    """All conditions but the load."""
    layer = dict(particle_diameter_nm=500, roughness_nm=300, particle_density_per_m2=1e11)
    return dict(viscosity_cSt=90, **layer)


@pytest.fixture
def runs():
    """Function that gives measurements at three loads, with more columns."""

    def table(**columns):
        loads = {"load [N]": [5.0, 10.0, 20.0], "solid load fraction [%]": [90, 70, 50]}
        return pd.DataFrame(loads | columns)

    return table


@pytest.fixture(scope="session")
def solved():
    """The solution at the loads of ``runs``."""
    layer = dict(particle_diameter_nm=500, roughness_nm=300, particle_density_per_m2=1e11)
    return tb.solve(load_N=[5.0, 10.0, 20.0], viscosity_cSt=90, **layer)
