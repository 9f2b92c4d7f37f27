"""The paper's equations on the datasets that the workflow made."""

import numpy as np
import pytest
from numpy.testing import assert_allclose

import thirdbody as tb
from thirdbody.data.conditions import Condition
from thirdbody.data.model_attribute import parameters_of_attribute
from thirdbody.model.regimes import SOLUTION_STATUSES
from thirdbody.solver.solution import QUANTITIES

pytestmark = [pytest.mark.results, pytest.mark.filterwarnings("error")]

CONVERGED, NOT_CONVERGED = map(SOLUTION_STATUSES.index, ("converged", "not_converged"))
LOADED = 1e-280  # smaller shares of a load have underflowed


def test_every_shown_point_is_solved(curves):
    _, values = curves
    # converged, or outside the meaning of the film formula, which is said and not hidden; next to
    # where the largest particles lose touch float64 may not hold all digits that were asked for
    status = values["solution_status"]
    assert set(np.unique(status)) <= {0.0, 1.0, 3.0}
    assert (status == NOT_CONVERGED).mean() < 2e-3
    for name in QUANTITIES:
        assert np.isfinite(values[name]).all(), name
        assert (values[name] >= 0.0).all(), name


def test_the_attributes_alone_give_each_value_again(dataset, curves):
    conditions, values = curves
    attribute = dataset.attrs["model_parameters"]
    load = dataset["load"].values[:, None]
    for index, roughness in enumerate(dataset["roughness"].values):
        here = conditions[2] == roughness
        inputs = parameters_of_attribute(attribute, roughness, index)
        solution = tb.solve(
            load=load,
            **Condition(*conditions[:, here])._asdict(),
            parameters=inputs,
            rtol=dataset.attrs["rtol"],
        )
        for name in QUANTITIES:
            again = getattr(solution, name)
            assert_allclose(values[name][:, here], again, rtol=1e-9, atol=LOADED, err_msg=name)
        for name in ("lubrication_regime", "contact_mode"):
            assert np.array_equal(values[name][:, here], getattr(solution, name)), name
        # points in other company are solved in another way, which may promise more digits
        both = values["solution_status"][:, here], solution.solution_status
        differ = both[0] != both[1]
        assert set(both[0][differ]) | set(both[1][differ]) <= {0, NOT_CONVERGED}


def test_separation_falls_with_the_load(curves):
    _, values = curves
    assert (np.diff(values["separation"], axis=0) < 0.0).all()


def test_dry_solids_bear_all(curves):
    (viscosity, *_), values = curves
    dry = viscosity == 0.0
    assert (values["solid_load_fraction"][:, dry] == 1.0).all()
    assert (values["fluid_load_fraction"][:, dry] == 0.0).all()
    status = values["solution_status"][:, dry]
    assert np.isin(status, (CONVERGED, NOT_CONVERGED)).all()
    # float64 may not hold what is asked of single points
    assert (status == CONVERGED).sum() >= 0.999 * status.size


def test_lubricant_parts_the_surfaces(curves):
    conditions, values = curves
    for curve in np.flatnonzero(conditions[0] > 0.0):
        same = (conditions[1:] == conditions[1:, curve, None]).all(axis=0)
        dry = np.flatnonzero(same & (conditions[0] == 0.0))
        for other in dry:
            ratio = values["separation"][:, curve] / values["separation"][:, other]
            # the solids bear no more than when dry; both sides are in error
            assert (ratio >= 1.0 - 2e-9).all()


def test_two_body_curves_have_no_particle_area(curves):
    (_, diameter, _, density), values = curves
    bare = (diameter == 0.0) | (density == 0.0)
    assert (values["particle_contact_area_ratio"][:, bare] == 0.0).all()
    assert (values["contact_mode"][:, bare] == 0.0).all()
    assert (values["contact_mode"][:, ~bare] > 0.0).all()


def test_dry_contact_area_falls_with_the_particles_size(datasets):
    fig03 = datasets["fig03"].isel(viscosity=0, roughness=0, particle_density=0)
    area = fig03["total_contact_area"].transpose("load", "particle_diameter").values
    ratio = fig03["particle_contact_area_ratio"].transpose("load", "particle_diameter").values
    # where particles bear nothing, Eq. 4 as printed still takes their share from the summits
    touching = ratio[:, 1:] > 0.05
    change = area[:, 1:] / area[:, :-1] - 1.0
    assert touching.any(axis=0)[1:].all()
    assert (change[touching] <= 2e-9).all()
    assert change[touching].min() < -0.1
