"""Inputs that tests share, and the paper's equations written a second time, for arrays."""

import json
from dataclasses import replace

import numpy as np
import pytest

COUNTED = pytest.StashKey[list]()

NODES, WEIGHTS = np.polynomial.legendre.leggauss(40)
NODES, WEIGHTS = 0.5 * (NODES + 1.0), 0.5 * WEIGHTS
PARTS = 6  # of each integral: 240 nodes leave errors below 1e-13
REACH = 90.0  # exp(-REACH/2) does not matter
SQRT_2PI = np.sqrt(2.0 * np.pi)

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
    "summit_offset": True,
    "size_distribution": "uncentred",
    "mean_ratio": 0.0,
    "spread_ratio": 1.60,
    "gap_ratio": 0.0,
    "truncation": 2.44,
    "participation": 0.0221,
    "elastic_depth_ratio": 0.0111,
    "elastic_limits": "printed",
    "coverage_limits": "printed",
    "film_load": "fluid",
}
READINGS = {
    "uncentred": {},
    "centred": {"size_distribution": "centred", "mean_ratio": 0.48, "spread_ratio": 1.42},
    "gap_convolved": {
        "size_distribution": "gap_convolved",
        "spread_ratio": 0.68,
        "gap_ratio": 1.15,
        "truncation": 3.23,
    },
    "physical_limits": {"elastic_limits": "physical", "elastic_depth_ratio": 0.0885},
    "contacting": {"coverage_limits": "contacting"},
    "film_of_the_total_load": {"film_load": "total"},
    "no_offset": {"summit_offset": False},
    "unlike_materials": {
        "hardness_surface_1": 3.0e9,
        "hardness_surface_2": 7.0e9,
        "elastic_modulus_particle": 2.0e11,
        "ellipticity": 2.5,
    },
}


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
def parameters():
    """Inputs whose turning points, windows and transitions the tests know."""
    from thirdbody.model.parameters import Parameters

    return Parameters(**INPUTS)


@pytest.fixture(scope="session")
def defaults():
    """The inputs that the configuration takes by default."""
    import thirdbody

    return thirdbody.load_parameters()


@pytest.fixture(scope="session", params=list(READINGS))
def reading(request, parameters):
    """The inputs of each reading in turn."""
    return replace(parameters, **READINGS[request.param])


@pytest.fixture(scope="session", params=["uncentred", "centred", "gap_convolved"])
def sizes(request, parameters):
    """The inputs of each reading of phi_a in turn."""
    return replace(parameters, **READINGS[request.param])


@pytest.fixture(scope="session")
def loads(parameters):
    """Loads F_t* [1] over the range of Table 2, 0.04 to 80 N."""
    return np.geomspace(0.04, 80.0, 60) / parameters.newtons_per_load


@pytest.fixture(scope="session")
def equations():
    """The class ``Equations``."""
    return Equations


def integral(function, start, end):
    """Integrals of ``function`` from each ``start`` to ``end``, 1-D, by Gauss-Legendre parts."""
    width = (end - start) / PARTS
    total = 0.0
    for part in range(PARTS):
        x = (start + part * width)[:, None] + width[:, None] * NODES
        total = total + width * (WEIGHTS * function(x)).sum(-1)
    return total


class Equations:
    """Eqs. 4, 5 and 7 from the numbers of ``model_parameters`` alone, for 1-D arrays of points.

    Integrals are taken numerically where the library has closed forms.  Loads are over A_n E_ss,
    areas over A_n; all points lie on one roughness [m], whose place in the lists is ``index``.
    """

    def __init__(self, model, index, roughness, diameter, density):
        self.__dict__.update(json.loads(model))
        for name in ("eta_s", "R", "sigma_s", "y_s"):
            setattr(self, name, getattr(self, name)[index])
        touching = (diameter > 0.0) & (density > 0.0)
        self.roughness = roughness
        self.x_a = np.where(touching, diameter, roughness)
        self.eta_a = np.where(touching, density, 0.0)
        self.mean = 0.0 * self.x_a if self.phi_a == "uncentred" else self.mean_ratio * self.x_a
        self.spread = self.sigma_a_ratio * self.x_a
        if self.phi_a == "gap_convolved":
            self.spread = np.hypot(self.spread, self.gap_ratio * roughness)
        self.largest = self.mean + self.truncation * self.spread

    def asperity(self, omega):
        """Load [N] and area [m2] of one summit pressed by ``omega`` [m] (Zhao, Maietta, Chang)."""
        omega_1, omega_2 = self.yield_interferences
        elastic = omega < omega_1
        if self.omega_ratio > 1.0:
            u = np.clip((omega - omega_1) / (omega_2 - omega_1), 0.0, 1.0)
            log_share = np.log(omega_2 / np.clip(omega, omega_1, omega_2))
            pressure = 1.0 - (1.0 - self.k) * log_share / np.log(self.omega_ratio)
        else:
            u = np.where(elastic, 0.0, 1.0)
            pressure = 1.0
        area = np.pi * self.R * omega * (1.0 - 2.0 * u**3 + 3.0 * u**2)
        hertz = 4.0 / 3.0 * self.E_ss * np.sqrt(self.R) * omega**1.5
        return np.where(elastic, hertz, area * pressure * self.H_s2), area

    @property
    def yield_interferences(self):
        """omega_1 and omega_2 [m]."""
        omega_1 = (0.75 * np.pi * self.k * self.H_s2 / self.E_ss) ** 2 * self.R
        return omega_1, self.omega_ratio * omega_1

    def summits(self, d):
        """ln F_ss* and ln A_ss* of all summits at separations ``d`` [m]."""
        t = (d - self.y_s) / self.sigma_s
        tail = REACH / (np.abs(t) + np.sqrt(t * t + REACH))
        end = self.sigma_s * np.where(t > 0.0, tail, np.sqrt(REACH) - t)
        edges = [0.0 * end, *(np.minimum(w, end) for w in self.yield_interferences), end]
        below = np.minimum(t, 0.0)[:, None]

        def weighted(which):
            def integrand(root):
                w = root**2 / self.sigma_s
                weight = np.exp(-w * (t[:, None] + 0.5 * w) - 0.5 * below**2)
                return 2.0 * root * self.asperity(root**2)[which] * weight

            pieces = zip(edges, edges[1:], strict=False)
            total = sum(integral(integrand, np.sqrt(a), np.sqrt(b)) for a, b in pieces)
            return np.log(self.eta_s / (SQRT_2PI * self.sigma_s) * total)

        log_weight = 0.5 * np.maximum(t, 0.0) ** 2
        return weighted(0) - np.log(self.E_ss) - log_weight, weighted(1) - log_weight

    def moment(self, a, b):
        """I(a, b) [m2], sizes ending at X_max (Eq. 6)."""
        ends = self.mean - 12.0 * self.spread, self.mean + 12.0 * self.spread
        held = ends[0], np.minimum(self.largest, ends[1])
        mean, spread = self.mean[:, None], self.spread[:, None]

        def integrand(x):
            z = (x - mean) / spread
            square = x**2
            if self.phi_a == "gap_convolved":
                square = (self.x_a**2 * (1.0 + self.sigma_a_ratio**2))[:, None]
            return square * np.exp(-0.5 * z**2) / (SQRT_2PI * spread)

        return integral(integrand, np.clip(a, *held), np.clip(b, *held))

    @property
    def share(self):
        """pi eta_a p/(H_s1 + H_s2) [m-2 Pa-1]."""
        return np.pi * self.participation * self.eta_a / (self.H_s1 + self.H_s2)

    def particle_area(self, d):
        """A_sa* (Eq. 5)."""
        h_e = self.h_e_ratio * self.x_a
        elastic = (d - h_e, d) if self.elastic_limits == "printed" else (d, d + h_e)
        yielding = (self.H_s1 / self.E_sa) ** 2 + (self.H_s2 / self.E_ss) ** 2
        factor = 2.25 * np.pi**2 * yielding
        moment = factor * self.moment(*elastic) + self.moment(d, self.largest)
        return self.H_s2 * self.share * moment

    def coverage(self, d):
        """Share of the interface under particles larger than ``d`` [m] (Eq. 5)."""
        return self.H_s1 * self.share * self.moment(d, self.largest)

    def load_coverage(self, d):
        """Share of the interface that Eq. 4 takes from the summits."""
        if self.coverage_limits == "contacting":
            return self.coverage(d)
        if self.phi_a == "gap_convolved":
            every = self.x_a**2 * (1.0 + self.sigma_a_ratio**2)
            return self.H_s1 * self.share * every
        return self.H_s1 * self.share * self.moment(0.0 * d, self.largest)

    def solid_load(self, d):
        """F_s* (Eqs. 2 and 4)."""
        bare = np.exp(self.summits(d)[0]) * (1.0 - self.load_coverage(d))
        return bare + self.H_s1 / self.E_ss * self.particle_area(d)

    def areas(self, d):
        """A_t*, A_sa,t* and A_ss,t* (Eqs. 5 and 10), the ratios also where A_t* underflows."""
        log_summits = self.summits(d)[1] + np.log(1.0 - self.coverage(d))
        particles = self.particle_area(d)
        with np.errstate(divide="ignore", over="ignore"):
            odds = np.exp(np.log(particles) - log_summits)
            ratios = 1.0 / (1.0 + 1.0 / odds), 1.0 / (1.0 + odds)
        return np.exp(log_summits) + particles, *ratios

    def film(self, load, viscosity):
        """H_c and its roughness term where the film bears ``load`` F_f* (Eq. 7)."""
        W = load * self.A_n / self.R_x**2
        U = self.U_per_viscosity * viscosity
        kappa = self.kappa
        smooth = 3.672 * W ** (-0.045 * kappa**0.18) * U ** (0.663 * kappa**0.025)
        smooth = smooth * self.G ** (0.502 * kappa**0.064) * (1.0 - 0.573 * np.exp(-0.74 * kappa))
        rough = 0.025 * (self.roughness / self.R_x) ** 1.248 * self.V**0.119 * W**-0.133
        rough = rough * U**-0.884 * self.G**-0.977 * kappa**0.081
        return smooth * (1.0 + rough), rough
