"""Which function draws which figure of the paper."""

from __future__ import annotations

from thirdbody.figures import comparison, density, dry, schematics, viscosity

# plot(parameters, panels) -> Figure, from conditions alone
SCHEMATICS = {
    "fig01": schematics.plot_interface,
    "fig02": schematics.plot_modes,
}
# plot(data, turning_points=(), band=None) -> Figure
CURVE_FIGURES = {
    "fig03": dry.plot_contact_modes,
    "fig04": viscosity.plot_lubrication,
    "fig05": viscosity.plot_solid_load,
    "fig06": comparison.plot_particle_diameters,
    "fig07": comparison.plot_particle_densities,
    "fig08": comparison.plot_roughnesses,
    "fig09": dry.plot_turning_points,
    "fig10": dry.plot_diameter_ratios,
    "fig11": viscosity.plot_shifted_turning_point,
    "fig12": viscosity.plot_smooth_and_rough,
    "fig13": density.plot_turning_point_densities,
}
