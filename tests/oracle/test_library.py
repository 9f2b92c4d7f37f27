"""The library against the extended-precision oracle, for each calibrated interpretation."""

import json
from pathlib import Path

import numpy as np
import pytest

import thirdbody as tb
from tests.oracle.extended import CONDITIONS, QUANTITIES, SURFACE, Oracle, why_not
from thirdbody.data.model_attribute import model_attribute

pytestmark = pytest.mark.skipif(why_not() is not None, reason=str(why_not()))

CALIBRATED = sorted((Path(__file__).parents[2] / "config" / "calibrated").glob("*.yaml"))
ROUGHNESS = 100e-9, 300e-9, 500e-9
POINTS = 60  # on each surface
RTOL = 1e-9


@pytest.fixture(scope="module")
def oracle(tmp_path_factory):
    return Oracle(tmp_path_factory.mktemp("oracle"))


def drawn(parameters, seed):
    """Conditions over the ranges of Table 2 by name, some of them dry or without particles."""
    random = np.random.default_rng(seed)
    count = POINTS * len(ROUGHNESS)
    newtons = 0.04 * (80.0 / 0.04) ** random.random(count)
    dry, bare = random.random((2, count)) < 0.2
    return {
        "load": newtons / parameters.newtons_per_load,
        "viscosity": np.where(dry, 0.0, random.uniform(20e-6, 150e-6, count)),
        "particle_diameter": np.where(bare, 0.0, random.uniform(50e-9, 1000e-9, count)),
        "roughness": np.repeat(ROUGHNESS, POINTS),
        "particle_density": 10.0 ** random.uniform(10.0, 12.0, count),
    }


@pytest.mark.parametrize("path", CALIBRATED, ids=lambda path: path.stem)
def test_the_library_finds_the_same(oracle, path):
    parameters = tb.load_parameters(path)
    conditions = drawn(parameters, seed=CALIBRATED.index(path))
    model = json.loads(model_attribute(parameters, ROUGHNESS))
    model |= {name: np.repeat(model[name], POINTS) for name in SURFACE}
    expected = oracle.solve(model, **conditions)
    assert (expected.count == 1).mean() > 0.5
    given = {name: conditions[name] for name in CONDITIONS}
    found = tb.solve(**given, parameters=parameters, rtol=RTOL)
    known = (found.solution_status == 0) & (expected.count == 1)
    assert known.sum() > 0.9 * (expected.count == 1).sum()
    for name in QUANTITIES:
        right = expected.first(name)[known].astype(float)
        values = getattr(found, name)[known]
        np.testing.assert_allclose(values, right, rtol=RTOL, atol=1e-290, err_msg=name)
