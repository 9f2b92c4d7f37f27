"""The inputs of the model: a frozen dataclass of all numbers and interpretations."""

import math
from dataclasses import dataclass, fields
from functools import cached_property
from numbers import Real
from typing import Any, NamedTuple, TypeVar

import numpy as np
from numpy.typing import NDArray

# range of sigma [m] in which all inputs within their bounds give finite surfaces
LEAST_ROUGHNESS, MOST_ROUGHNESS = 1e-30, 1e30
HIGHEST_PLANE = 1000.0  # y_s/sigma_s above which the loads of summits lose digits
MATERIALS = (  # the inputs in the elastic factor
    *("elastic_modulus_surfaces", "elastic_modulus_particle"),
    *("hardness_surface_1", "hardness_surface_2"),
)
# ASSUME: the paper leaves open some interpretations.  Two are fixed: X_min is 0, and the film fills
# the separation of the mean planes.  These words choose the others:
WORDS = {"particle_plane": ("surface", "summit"), "film_load": ("fluid", "total")}
MOST_ELASTIC_FACTOR = 1.0  # up to this factor F_s decreases with d, and Eq. 1 has one root

Number = TypeVar("Number", float, NDArray)  # one number, or an array of them


class Bounds(NamedTuple):
    """The least and the most of a number, both allowed, and its SI unit."""

    least: float
    most: float
    unit: str

    def hold(self, value: Any) -> bool:
        """Whether ``value`` is a number in the interval."""
        is_number = isinstance(value, Real) and not isinstance(value, bool)
        return is_number and self.least <= value <= self.most

    def __str__(self) -> str:
        unit = "" if self.unit == "1" else f" {self.unit}"
        return f"a number from {self.least:g} to {self.most:g}{unit}"


# Within these bounds the results are tested.  The bounds are much wider than real materials and
# surfaces.
BOUNDS = {
    "elastic_modulus_surfaces": Bounds(1e8, 1e13, "Pa"),
    "elastic_modulus_particle": Bounds(1e8, 1e13, "Pa"),
    "hardness_surface_1": Bounds(1e6, 1e14, "Pa"),
    "hardness_surface_2": Bounds(1e6, 1e14, "Pa"),
    "yield_pressure_ratio": Bounds(0.1, 1.0, "1"),
    "plastic_interference_ratio": Bounds(1.0, 1e5, "1"),
    "ball_radius": Bounds(1e-6, 1.0, "m"),
    "material_parameter": Bounds(1.0, 1e5, "1"),
    "hardness_parameter": Bounds(1e-4, 1.0, "1"),
    "speed_per_viscosity": Bounds(1e-10, 1.0, "s m-2"),
    "ellipticity": Bounds(0.1, 10.0, "1"),
    "apparent_area": Bounds(1e-12, 1e-2, "m2"),
    "reference_roughness": Bounds(1e-12, 1e-2, "m"),
    "summit_parameter": Bounds(0.0193, 100.0, "1"),
    "summit_parameter_exponent": Bounds(-2.0, 2.0, "1"),
    "summit_radius": Bounds(1e-7, 1e-2, "m"),
    "summit_radius_exponent": Bounds(-2.0, 2.0, "1"),
    "summit_deviation_ratio": Bounds(0.05, 5.0, "1"),
    "summit_offset_ratio": Bounds(0.0, 5.0, "1"),
    "mean_ratio": Bounds(0.0, 2.0, "1"),
    # a narrower distribution of sizes makes a step in the load that float64 cannot resolve to 1e-9
    "spread_ratio": Bounds(1e-6, 10.0, "1"),
    "truncation": Bounds(0.5, 10.0, "1"),
    "participation": Bounds(1e-6, 1.0, "1"),
    "elastic_depth_ratio": Bounds(0.0, 5.0, "1"),
}


@dataclass(frozen=True)
class Surface:
    """Summits of the equivalent rough surface, for a single roughness or an array of roughnesses.

    Attributes
    ----------
    roughness : float or array
        sigma [m].
    summit_density, summit_radius : float or array
        eta_s [m-2] and R [m].
    summit_deviation, summit_offset : float or array
        sigma_s and y_s [m]: standard deviation and mean height of the summits.
    """

    roughness: float | NDArray
    summit_density: float | NDArray
    summit_radius: float | NDArray
    summit_deviation: float | NDArray
    summit_offset: float | NDArray


@dataclass(frozen=True)
class Parameters:
    """One set of all inputs of the model, in SI units.

    ``config/inputs.yaml`` has the symbol, unit and source of each field, ``BOUNDS`` the allowed
    numbers.  Fields that are words select interpretations of the paper.
    ``thirdbody.load_parameters`` returns the calibrated sets as an ``Ensemble``.

    Raises
    ------
    ValueError
        For a number out of bounds, a value that is not a number, and an unknown word.  The message
        has the field, its value and the allowed values.

    Examples
    --------
    >>> import thirdbody
    >>> from dataclasses import replace
    >>> parameters = thirdbody.load_parameters().best
    >>> parameters.ball_radius
    0.00635
    >>> replace(parameters, hardness_surface_1=-1e9)
    Traceback (most recent call last):
    ...
    ValueError: hardness_surface_1 is -1000000000.0; allowed: a number from 1e+06 to 1e+14 Pa
    >>> replace(parameters, film_load="solid")
    Traceback (most recent call last):
    ...
    ValueError: film_load is 'solid'; allowed: fluid, total
    """

    # materials
    elastic_modulus_surfaces: float  # of the contact between the two surfaces
    elastic_modulus_particle: float  # of the contact between a particle and a surface
    hardness_surface_1: float
    hardness_surface_2: float
    # a summit that yields
    yield_pressure_ratio: float  # mean pressure over the hardness, at first yield
    plastic_interference_ratio: float  # interference when fully plastic over that at first yield
    # ball and film (Eqs. 7 and 8)
    ball_radius: float
    material_parameter: float
    hardness_parameter: float
    speed_per_viscosity: float  # the speed parameter over the kinematic viscosity
    ellipticity: float
    apparent_area: float  # to which loads and areas are relative
    # summits; power laws of the roughness about its reference value
    reference_roughness: float
    summit_parameter: float  # density times radius of the summits times roughness
    summit_parameter_exponent: float
    summit_radius: float
    summit_radius_exponent: float
    summit_deviation_ratio: float  # standard deviation of the summits over the roughness
    summit_offset_ratio: float  # height of the summits' plane over the roughness
    # particles (Eqs. 4 to 6); diameters are ratios to x_a
    mean_ratio: float  # mean of the sizes: 0 as in Eq. 6, 1 as the text describes x_a
    spread_ratio: float  # standard deviation of the sizes
    truncation: float  # largest size above the mean, in standard deviations
    participation: float  # fraction of the particles that carry load
    elastic_depth_ratio: float  # depth of the elastic zone
    particle_plane: str  # from which particles meet the separation
    # force balance
    film_load: str  # the load in W of Eq. 8

    def __post_init__(self):
        for name, words in WORDS.items():
            word = getattr(self, name)
            if word not in words:
                raise ValueError(f"{name} is {word!r}; allowed: {', '.join(words)}")
        for name, bounds in BOUNDS.items():
            number = getattr(self, name)
            if not bounds.hold(number):
                raise ValueError(f"{name} is {number!r}; allowed: {bounds}")

    @property
    def film_shares_load(self) -> bool:
        """Whether the load in W of Eq. 8 is F_f, so that film and solids share the load.

        Otherwise it is F_t, as printed.  The film thickness is then known in advance, and the
        solids carry all the load if they need a larger separation.
        """
        return self.film_load == "fluid"

    def total_load(self, solid_load: Number, film_load: Number) -> Number:
        """F_t* [1] at a separation where the solids carry ``solid_load`` F_s* [1].

        ``film_load`` F* [1] is the load in W of a film as thick as the separation.
        """
        combine = np.add if self.film_shares_load else np.maximum
        return combine(solid_load, film_load)

    def particle_plane_height(self, summit_offset: float | NDArray) -> float | NDArray:
        """Height above the mean plane [m] of the plane that particles meet.

        With "summit" it is the plane of the summits, at ``summit_offset`` y_s [m]: the paper has
        the same d in both integrals.  With "surface" it is the mean plane, as d = R_x H_c is the
        separation of the mean planes.
        """
        of_surface = 0.0 * summit_offset  # zeros of the same shape
        return summit_offset if self.particle_plane == "summit" else of_surface

    @cached_property
    def elastic_factor(self) -> float:
        """(9 pi^2/4)(H_s1^2/E_sa^2 + H_s2^2/E_ss^2) [1] in Eqs. 4 and 5.

        It is the load of an elastic particle over the load of a plastic particle.
        """
        particle = self.hardness_surface_1 / self.elastic_modulus_particle
        surface = self.hardness_surface_2 / self.elastic_modulus_surfaces
        return 2.25 * math.pi**2 * (particle**2 + surface**2)

    def check_particles(self) -> None:
        """Raise ``ValueError`` unless plastic particles carry at least as much as elastic ones.

        Otherwise F_s could increase with d, and Eq. 1 could hold at several separations.
        """
        if self.elastic_factor > MOST_ELASTIC_FACTOR:
            materials = ", ".join(f"{name} {getattr(self, name):g}" for name in MATERIALS)
            raise ValueError(
                f"the elastic factor of particles (Eq. 4) is {self.elastic_factor:.3g} "
                f"for {materials}; allowed: at most {MOST_ELASTIC_FACTOR:g}, as for hard particles"
            )

    def check_ball(self) -> None:
        """Raise ``ValueError`` if the cross-section of the ball is smaller than A_n."""
        section = math.pi * self.ball_radius**2
        if self.apparent_area > section:
            raise ValueError(
                f"apparent_area is {self.apparent_area:g}; allowed: at most {section:.3g} m2, the "
                f"cross-section of a ball of ball_radius {self.ball_radius:g} m"
            )

    def sizes(self, diameter: Number) -> tuple[Number, Number]:
        """Mean m and standard deviation S [m] of the normal size distribution, for x_a [m]."""
        return self.mean_ratio * diameter, self.spread_ratio * diameter

    @cached_property
    def particle_pressure(self) -> float:
        """F_sa*/(A_sa/A_n) [1]: particles press with the hardness of surface 1 (Eqs. 4 and 5)."""
        return self.hardness_surface_1 / self.elastic_modulus_surfaces

    @cached_property
    def softer_hardness(self) -> float:
        """min(H_s1, H_s2) [Pa]: where two surfaces touch, the softer surface yields.

        ASSUME: the summit model of the paper (Zhao, Maietta & Chang 2000) has a single hardness,
        and Table 1 has two.  Below Eq. 8 the paper uses "the Vickers hardness of softer material"
        for both surfaces together.
        """
        return min(self.hardness_surface_1, self.hardness_surface_2)

    @cached_property
    def newtons_per_load(self) -> float:
        """F_t/F_t* = A_n E_ss [N]."""
        return self.apparent_area * self.elastic_modulus_surfaces

    def surface(self, roughness: float | NDArray) -> Surface:
        """Summits of one surface or several.

        The assumption is that eta_s R sigma, R and y_s/sigma follow power laws of the roughness,
        and that sigma_s is proportional to the roughness.

        Parameters
        ----------
        roughness : float or array
            sigma [m].

        Returns
        -------
        Surface
            Its fields have the shape of ``roughness``.

        Raises
        ------
        ValueError
            For a roughness outside 1e-30 to 1e30 m, as the power laws may overflow, and for a plane
            of the summits that is more than 1000 sigma_s above the mean plane.

        Examples
        --------
        >>> import thirdbody
        >>> from dataclasses import replace
        >>> inputs = replace(thirdbody.load_parameters().best, summit_offset_ratio=0.5)
        >>> inputs.surface(300e-9).summit_offset
        1.5e-07
        """
        inside = (roughness >= LEAST_ROUGHNESS) & (roughness <= MOST_ROUGHNESS)
        if np.count_nonzero(inside) < np.size(inside):
            bad = np.ravel(roughness)[np.argmin(inside)]
            allowed = f"{LEAST_ROUGHNESS:g} to {MOST_ROUGHNESS:g} m"
            raise ValueError(f"roughness is {bad:g}; allowed: {allowed}")
        scale = roughness / self.reference_roughness  # ASSUME: power laws; the paper prints none
        summit_parameter = self.summit_parameter * scale**self.summit_parameter_exponent
        radius = self.summit_radius * scale**self.summit_radius_exponent
        density = summit_parameter / (radius * roughness)
        # McCool (1986): y_s is proportional to 1/(eta_s R)
        offset = self.summit_offset_ratio * scale**-self.summit_parameter_exponent
        highest = HIGHEST_PLANE * self.summit_deviation_ratio
        if np.max(offset) > highest:
            bad = np.ravel(roughness)[np.argmax(offset)]
            power = f"summit_parameter_exponent {self.summit_parameter_exponent:g}"
            message = (
                f"roughness is {bad:g} m, at which {power} puts summits {np.max(offset):.3g} sigma"
            )
            raise ValueError(
                f"{message} above the mean plane; allowed: at most {highest:.3g} sigma"
            )
        return Surface(
            roughness=roughness,
            summit_density=density,
            summit_radius=radius,
            summit_deviation=self.summit_deviation_ratio * roughness,
            summit_offset=offset * roughness,
        )

    @classmethod
    def names(cls) -> list[str]:
        """The names of all inputs."""
        return [field.name for field in fields(cls)]

    def as_dict(self) -> dict:
        """All inputs as a dict."""
        return {name: getattr(self, name) for name in self.names()}


# McCool (1986): height of the summits' plane, and loss of their variance, over 1/(eta_s R)
SUMMIT_PLANE = 0.045944
SUMMIT_VARIANCE = 3.717e-4


def mccool_summits(summit_parameter: float) -> dict[str, float]:
    """Deviation and mean height of the summits of an isotropic surface with Gaussian heights.

    The paper prints neither.  McCool (1986) derives both from the product of density, radius and
    roughness.  The summits lie above the mean plane, and their heights vary less than those of the
    surface.

    Parameters
    ----------
    summit_parameter : float
        eta_s R sigma [1] of the surface.

    Returns
    -------
    dict
        ``summit_deviation_ratio`` sigma_s/sigma and ``summit_offset_ratio`` y_s/sigma [1] of that
        surface, inputs of ``Parameters``.

    Raises
    ------
    ValueError
        For 0.01928 or less, which leaves the summits no variance.

    Examples
    --------
    >>> import thirdbody
    >>> from thirdbody.core.parameters import mccool_summits
    >>> inputs = thirdbody.load_parameters(summit_parameter=0.05)
    >>> round(inputs.changed(**mccool_summits(0.05)).summit_offset_ratio, 5)
    0.91888
    """
    least = math.sqrt(SUMMIT_VARIANCE)
    if not summit_parameter > least:
        raise ValueError(f"summit_parameter is {summit_parameter:g}; allowed: above {least:.5f}")
    return {
        "summit_deviation_ratio": math.sqrt(1.0 - (least / summit_parameter) ** 2),
        "summit_offset_ratio": SUMMIT_PLANE / summit_parameter,
    }
