"""Figure 13: the turning point with various particle densities."""

from __future__ import annotations

from thirdbody.figures.curves import Content, plot_curves


def plot_turning_point_densities(data, turning_points=(), band=None):
    """Figure 13: A_sa,t*, a panel for each roughness."""
    contents = [
        Content("particle_contact_area_ratio", roughness=roughness)
        for roughness in data["roughness"].values
    ]
    return plot_curves(data, "particle_density", contents, turning_points, band)
