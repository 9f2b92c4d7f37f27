"""One asperity; and load and area of Gaussian summits, computed elsewhere, to five digits.

For k = 0.4, omega_2 = 54 omega_1, eta_s R sigma_s = 0.05 and H/E = 5/112, by the plasticity index
psi = (E/H) sqrt(sigma_s/R): F/(A_n E) and A/A_n at d/sigma_s of 0, 1, 2 and 3 from the plane of the
summits.
"""

import numpy as np

from thirdbody.model.asperity import area_growth, pressure_fraction

PRINTED = {
    0.5: (
        (6.3989e-4, 1.1260e-4, 9.8931e-6, 3.9281e-7),
        (6.2666e-2, 1.3087e-2, 1.3337e-3, 6.0029e-5),
    ),
    1.0: (
        (1.1904e-3, 2.1671e-4, 1.9414e-5, 7.7860e-7),
        (6.2708e-2, 1.3090e-2, 1.3338e-3, 6.0030e-5),
    ),
    2.5: (
        (2.1256e-3, 3.9565e-4, 3.6730e-5, 1.5304e-6),
        (6.7305e-2, 1.3608e-2, 1.3635e-3, 6.0822e-5),
    ),
}


def asperity_load_and_area(omega, radius, modulus, hardness, yield_ratio, plastic_ratio):
    """F [N] and A [m2] of one asperity that is pressed by omega [m] (Zhao, Maietta & Chang 2000)."""
    omega = np.maximum(omega, 0.0)
    ratio = omega / ((0.75 * np.pi * yield_ratio * hardness / modulus) ** 2 * radius)
    area = np.pi * radius * omega * area_growth(ratio, plastic_ratio)
    hertz = 4.0 / 3.0 * modulus * np.sqrt(radius) * omega**1.5
    yielding = area * hardness * pressure_fraction(ratio, yield_ratio, plastic_ratio)
    return np.where(ratio < 1.0, hertz, yielding), area
