"""Figures 4, 5, 11 and 12: lubricants of various viscosities."""

from __future__ import annotations

from thirdbody.figures.curves import Content, plot_curves


def plot_lubrication(data, turning_points=(), band=None):
    """Figure 4: A_sa,t*, A_t*, L_s and H_c, lubricated, dry, and in two-body contact."""
    contents = [
        Content("particle_contact_area_ratio"),
        Content("total_contact_area"),
        Content("solid_load_fraction"),
        Content("film_thickness"),
    ]
    return plot_curves(data, "viscosity", contents, turning_points, band)


def plot_solid_load(data, turning_points=(), band=None):
    """Figure 5: L_s, a panel for each roughness."""
    contents = [
        Content("solid_load_fraction", roughness=roughness)
        for roughness in data["roughness"].values
    ]
    return plot_curves(data, "viscosity", contents, turning_points, band)


def plot_shifted_turning_point(data, turning_points=(), band=None):
    """Figure 11: A_sa,t* and L_s against the load, and A_sa,t* against H_c."""
    contents = [
        Content("particle_contact_area_ratio"),
        Content("solid_load_fraction"),
        Content("particle_contact_area_ratio", x="film_thickness"),
    ]
    return plot_curves(data, "viscosity", contents, turning_points, band)


def plot_smooth_and_rough(data, turning_points=(), band=None):
    """Figure 12: A_sa,t* and L_s on the smoothest surface, A_sa,t* on the roughest."""
    smoothest, roughest = data["roughness"].values[[0, -1]]
    contents = [
        Content("particle_contact_area_ratio", roughness=smoothest),
        Content("solid_load_fraction", roughness=smoothest),
        Content("particle_contact_area_ratio", roughness=roughest),
    ]
    return plot_curves(data, "viscosity", contents, turning_points, band)
