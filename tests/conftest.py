"""Inputs that tests share, the paper's equations as the verification has them, and the checkers of
CF and ACDD."""

import re
import shutil
from dataclasses import replace

import numpy as np
import pytest

COUNTED = pytest.StashKey[list]()

# inputs that stay as they are when a calibration finds better ones
INPUTS = {
    "elastic_modulus_surfaces": 112e9,
    "elastic_modulus_particle": 112e9,
    "hardness_surface_1": 5e9,
    "hardness_surface_2": 5e9,
    "yield_pressure_ratio": 0.4,
    "plastic_interference_ratio": 54.0,
    "ball_radius": 6.35e-3,
    "material_parameter": 2038.0,
    "hardness_parameter": 0.04,
    "speed_per_viscosity": 7.3e-10 / 150e-6,
    "ellipticity": 1.0,
    "apparent_area": 6.4e-6,
    "reference_roughness": 300e-9,
    "summit_parameter": 0.65,
    "summit_parameter_exponent": -0.80,
    "summit_radius": 29.7e-6,
    "summit_radius_exponent": 0.33,
    # McCool (1986)
    "summit_deviation_ratio": (1.0 - 3.717e-4 / 0.65**2) ** 0.5,
    "summit_offset_ratio": 0.045944 / 0.65,
    "mean_ratio": 0.0,
    "spread_ratio": 1.60,
    "truncation": 2.44,
    "participation": 0.0221,
    "elastic_depth_ratio": 0.0111,
    "particle_plane": "surface",
    "film_load": "fluid",
}
INTERPRETATIONS = {
    "uncentred": {},
    "centred": {"mean_ratio": 0.48, "spread_ratio": 1.42},
    "film_of_the_total_load": {"film_load": "total"},
    "no_offset": {"summit_offset_ratio": 0.0, "summit_deviation_ratio": 1.0},
    "summit_plane": {"summit_deviation_ratio": 1.2, "particle_plane": "summit"},
    "unlike_materials": {
        **{"hardness_surface_1": 3.0e9, "hardness_surface_2": 7.0e9},
        **{"elastic_modulus_particle": 2.0e11, "ellipticity": 2.5},
    },
}
# what does not apply to data without a place, a time, an instrument or a name in the table of
# standard names, and addresses and dates that there are not
INAPPLICABLE = re.compile(
    r"(geospatial_\w+|time_coverage_\w+|standard_name|instrument\w*|platform\w*|keywords_vocabulary|program"
    r"|creator_(institution|url|email)|publisher_\w+|metadata_link|product_version|Attr date_\w+)\b"
)


def pytest_configure(config):
    config.stash[COUNTED] = []


def pytest_terminal_summary(terminalreporter, config):
    for line in config.stash[COUNTED]:
        terminalreporter.write_line(line)


@pytest.fixture(scope="session")
def tell(pytestconfig):
    """Function that has a line printed at the end: what was counted."""
    return pytestconfig.stash[COUNTED].append


@pytest.fixture(scope="session")
def needs_git():
    """Skips a test where git is not installed."""
    if shutil.which("git") is None:
        pytest.skip("git is not installed")


@pytest.fixture(scope="session")
def parameters():
    """Inputs whose turning points, windows and transitions the tests know."""
    from thirdbody.core.parameters import Parameters

    return Parameters(**INPUTS)


@pytest.fixture(scope="session")
def defaults():
    """The inputs that the configuration takes by default."""
    import thirdbody

    return thirdbody.load_parameters()


@pytest.fixture(scope="session", params=list(INTERPRETATIONS))
def interpretation(request, parameters):
    """The inputs of each interpretation in turn."""
    return replace(parameters, **INTERPRETATIONS[request.param])


@pytest.fixture(scope="session", params=["uncentred", "centred"])
def sizes(request, parameters):
    """The inputs with sizes about 0 and about a mean, in turn."""
    return replace(parameters, **INTERPRETATIONS[request.param])


@pytest.fixture(scope="session")
def loads(parameters):
    """Loads F_t* [1] over the range of Table 2, 0.04 to 80 N."""
    return np.geomspace(0.04, 80.0, 60) / parameters.newtons_per_load


@pytest.fixture(scope="session")
def equations():
    """The class ``PlainEquations``: an implementation that shares no line with the library."""
    from plain_equations import PlainEquations

    return PlainEquations


@pytest.fixture(scope="session")
def findings_in():
    """Function that gives what the checkers of CF-1.11 and ACDD-1.3 have to say of a NetCDF file,
    but what does not apply; their own errors would be said by none."""
    from compliance_checker.runner import CheckSuite

    suite = CheckSuite()
    suite.load_all_available_checkers()

    def found_in(path):
        opened = suite.load_dataset(str(path))
        found = {}
        for convention in ("cf:1.11", "acdd:1.3"):
            scores, errors = suite.run_all(opened, [convention])[convention]
            assert not errors
            found[convention] = [text for score in scores for text in shortcomings(score)]
        opened.close()
        said = [text for text in found["acdd:1.3"] if not INAPPLICABLE.match(text)]
        return {"CF": found["cf:1.11"], "ACDD": said}

    return found_in


def shortcomings(score):
    """The messages of a check without full marks, or its name if it gives no reason."""
    value = score.value
    if value is True or (isinstance(value, tuple) and value[0] == value[1]):
        return []
    return score.msgs or [score.name]
