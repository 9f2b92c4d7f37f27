"""Figures 6, 7 and 8: lubricated beside dry contact."""

from __future__ import annotations

from thirdbody.figures.curves import Content, plot_curves

CONTENTS = (
    Content("total_contact_area"),
    Content("solid_load_fraction"),
    Content("particle_contact_area_ratio"),
)


def plot_particle_diameters(data, turning_points=(), band=None):
    """Figure 6: A_t*, L_s and A_sa,t* for various particle diameters."""
    return plot_curves(data, "particle_diameter", CONTENTS, turning_points, band)


def plot_particle_densities(data, turning_points=(), band=None):
    """Figure 7: A_t*, L_s and A_sa,t* for various particle densities."""
    return plot_curves(data, "particle_density", CONTENTS, turning_points, band)


def plot_roughnesses(data, turning_points=(), band=None):
    """Figure 8: A_t*, L_s and A_sa,t* for various surfaces."""
    return plot_curves(data, "roughness", CONTENTS, turning_points, band)
