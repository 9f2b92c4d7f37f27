"""Conversion of dimensionless loads to newtons, without numpy."""


def newtons_per_load(apparent_area: float, elastic_modulus_surfaces: float) -> float:
    """F_t/F_t* = A_n E_ss [N].

    Parameters
    ----------
    apparent_area : float
        A_n [m2].
    elastic_modulus_surfaces : float
        E_ss [Pa].

    Examples
    --------
    >>> newtons_per_load(2e-4, 1e11)
    20000000.0
    """
    return apparent_area * elastic_modulus_surfaces
