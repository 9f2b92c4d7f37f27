"""Figures 3, 9 and 10: dry contact with particles of various diameters."""

from __future__ import annotations

from thirdbody.figures.curves import Content, plot_curves


def plot_contact_modes(data, turning_points=(), band=None):
    """Figure 3: A_sa,t* and A_t* from the p-s over the hybrid to the s-s mode."""
    contents = [Content("particle_contact_area_ratio"), Content("total_contact_area")]
    return plot_curves(data, "particle_diameter", contents, turning_points, band)


def plot_turning_points(data, turning_points=(), band=None):
    """Figure 9: A_sa,t*, and A_t* with the locus of the turning points."""
    contents = [
        Content("particle_contact_area_ratio"),
        Content("total_contact_area", locus=True),
    ]
    return plot_curves(data, "particle_diameter", contents, turning_points, band)


def plot_diameter_ratios(data, turning_points=(), band=None):
    """Figure 10: A_sa,t* for x_a/sigma around 1, a panel for each roughness."""
    contents = [
        Content("particle_contact_area_ratio", roughness=roughness)
        for roughness in data["roughness"].values
    ]
    return plot_curves(data, "diameter_ratio", contents, turning_points, band)
