"""Central film thickness of rough line and point contacts (Eqs. 7-8), and where it holds.

Source: Masjedi & Khonsari (2015).
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from thirdbody.model.parameters import Parameters

SPEED_EXPONENT = 0.663
ROUGHNESS_SPEED_EXPONENT = 0.884
ROUGHNESS_LOAD_EXPONENT = -0.133
INVERSE_STEPS = 6  # leave nothing of an error that starts below a factor of 2 in thickness


@dataclass(frozen=True)
class Film:
    """Eq. 7 as a function of the load parameter: H_c = e^(s + a ln W) + e^(r + b ln W).

    ``smooth`` s and ``rough`` r have the shape of the points; the exponents a and b are scalars.
    """

    smooth: np.ndarray
    rough: np.ndarray
    smooth_exponent: float
    rough_exponent: float
    turning_ratio: float

    @classmethod
    def of(cls, viscosity, roughness, parameters: Parameters) -> Film:
        """Film at kinematic ``viscosity`` [m2/s], positive, and ``roughness`` sigma [m]."""
        kappa = parameters.ellipticity
        speed = np.log(parameters.speed_per_viscosity) + np.log(viscosity)
        speed_exponent = SPEED_EXPONENT * kappa**0.025
        smooth = (
            np.log(3.672 * (1.0 - 0.573 * np.exp(-0.74 * kappa)))
            + speed_exponent * speed
            + 0.502 * kappa**0.064 * np.log(parameters.material_parameter)
        )
        rough = smooth + (
            np.log(0.025 * kappa**0.081)
            + 1.248 * np.log(roughness / parameters.ball_radius)
            + 0.119 * np.log(parameters.hardness_parameter)
            - ROUGHNESS_SPEED_EXPONENT * speed
            - 0.977 * np.log(parameters.material_parameter)
        )
        smooth_exponent = -0.045 * kappa**0.18
        return cls(
            smooth,
            rough,
            smooth_exponent,
            smooth_exponent + ROUGHNESS_LOAD_EXPONENT,
            speed_exponent / (ROUGHNESS_SPEED_EXPONENT - speed_exponent),
        )

    def take(self, chosen) -> Film:
        """The film at the points that an index or mask ``chosen`` picks."""
        return Film(
            self.smooth[chosen],
            self.rough[chosen],
            self.smooth_exponent,
            self.rough_exponent,
            self.turning_ratio,
        )

    def thickness(self, log_load_parameter):
        """H_c [1] and its slope dH_c/d ln W [1] at ``log_load_parameter`` ln W (Eq. 7)."""
        smooth = np.exp(self.smooth + self.smooth_exponent * log_load_parameter)
        rough = np.exp(self.rough + self.rough_exponent * log_load_parameter)
        return smooth + rough, self.smooth_exponent * smooth + self.rough_exponent * rough

    def crossing(self):
        """ln W where the terms of Eq. 7 are equal, and ln of each there; seen from there, all films
        of one ellipticity are the same curve."""
        log_parameter = (self.smooth - self.rough) / (self.rough_exponent - self.smooth_exponent)
        return log_parameter, self.smooth + self.smooth_exponent * log_parameter

    def load_parameter(self, thickness, steps=INVERSE_STEPS):
        """ln W at which the film is ``thickness`` H_c [1] thick: the inverse of ``thickness``.

        Newton's method on ln H_c, which is convex in ln W; it starts where one term of Eq. 7 has
        the thickness by itself, so that it cannot overshoot.
        """
        target = np.log(thickness)
        log_parameter = np.maximum(
            (target - self.smooth) / self.smooth_exponent,
            (target - self.rough) / self.rough_exponent,
        )
        for _ in range(steps):
            value, slope = self.thickness(log_parameter)
            log_parameter = log_parameter - (np.log(value) - target) * value / slope
        return log_parameter

    def is_meaningful(self, log_load_parameter):
        """Whether H_c still rises with viscosity: the roughness term is below its turning point.

        Eq. 7 lets the film grow without bound as U goes to zero; where dH_c/dU < 0 it is
        outside its meaning (roughness term above 3 at kappa = 1).
        """
        return log_load_parameter > self.turning()

    def turning(self):
        """ln W below which H_c falls with viscosity."""
        excess = np.log(self.turning_ratio) + self.smooth - self.rough
        return excess / ROUGHNESS_LOAD_EXPONENT
