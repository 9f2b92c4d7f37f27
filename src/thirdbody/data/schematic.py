"""Sections through interfaces, as schematics show them, and the file that keeps them.

What is computed (``thirdbody.data.section``) and what is drawn (``thirdbody.figures.schematics``)
meet in this file: numbers of full precision, a section a panel.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from os import PathLike

import numpy as np
import xarray as xr
from numpy.typing import NDArray

from thirdbody.data.attributes import coordinate_attributes, variable_attributes
from thirdbody.data.conditions import AXES, Condition
from thirdbody.data.netcdf import load, write_netcdf
from thirdbody.data.quantities import FLAGS, QUANTITIES
from thirdbody.model.regimes import CONTACT_MODES


@dataclass(frozen=True)
class State:
    """A solved interface: its condition, and what a drawing needs of the solution.

    Attributes
    ----------
    condition : Condition
        Viscosity, particles and roughness.
    separation : float
        d [m].
    particle_contact_area_ratio : float
        A_sa,t* [1].
    solid_load_fraction : float
        L_s [1].
    contact_mode : str
        One of ``CONTACT_MODES``.
    """

    condition: Condition
    separation: float
    particle_contact_area_ratio: float
    solid_load_fraction: float
    contact_mode: str


@dataclass(frozen=True)
class Particle:
    """A particle: position and height of its centre and its diameter [m]; does it bear load?"""

    position: float
    height: float
    diameter: float
    bears_load: bool


@dataclass(frozen=True)
class Section:
    """A section through two rough surfaces with particles between them.

    Attributes
    ----------
    state : State
        The interface that is cut.
    position : ndarray, shape (n,)
        Places along the section [m].
    lower, upper : ndarray, shape (n,)
        Heights of both surfaces there [m]; flat where they touch.
    touches : ndarray of bool, shape (n,)
        Where they touch.
    particles : tuple of Particle
        Particles that the section meets.
    """

    state: State
    position: NDArray[np.float64]
    lower: NDArray[np.float64]
    upper: NDArray[np.float64]
    touches: NDArray[np.bool_]
    particles: tuple[Particle, ...]


NUMBERS = ("separation", "particle_contact_area_ratio", "solid_load_fraction")  # of a state
SURFACES = {"lower": "height of the lower surface", "upper": "height of the upper surface"}
# fields of a particle: name and meaning in the file
PARTICLE = {
    "position": ("particle_position", "position of the centre of a particle; nan: no particle"),
    "height": ("particle_height", "height of the centre of a particle"),
    "diameter": ("particle_size", "diameter of a particle"),
}
TOUCHES, BEARS_LOAD = "surfaces_touch", "particle_bears_load"


def write_sections(path: str | PathLike, sections: Sequence[Section]) -> None:
    """Write the sections of a schematic, one a panel, to a NetCDF-4 file.

    Parameters
    ----------
    path : path
        File to write.
    sections : sequence of Section
        At least one; all along the same positions.

    Raises
    ------
    OSError
        If there is no room or no right to write.
    """
    states = [section.state for section in sections]
    variables = {
        name: (
            "panel",
            [getattr(s.condition, name) for s in states],
            coordinate_attributes(AXES[name]),
        )
        for name in Condition._fields
    }
    for name in NUMBERS:
        values = [getattr(state, name) for state in states]
        variables[name] = ("panel", values, coordinate_attributes(QUANTITIES[name]))
    modes = np.array([CONTACT_MODES.index(state.contact_mode) for state in states], dtype=np.int8)
    flag = variable_attributes(FLAGS["contact_mode"])
    variables["contact_mode"] = ("panel", modes, flag)
    for name, meaning in SURFACES.items():
        heights = [getattr(section, name) for section in sections]
        variables[name] = (("panel", "position"), heights, {"units": "m", "long_name": meaning})
    touches = np.array([section.touches for section in sections], dtype=np.int8)
    variables[TOUCHES] = (("panel", "position"), touches, {"long_name": "whether they touch"})
    variables |= _particle_variables([section.particles for section in sections])
    position = ("position", sections[0].position, {"units": "m", "long_name": "along the section"})
    dataset = xr.Dataset(variables, {"position": position}, {"Conventions": "CF-1.11"})
    write_netcdf(dataset, path, {})


def _particle_variables(of_panels) -> dict:
    """Variables over panels and particles; panels with fewer particles than others end with nan."""
    shape = len(of_panels), max(map(len, of_panels))
    dimensions = ("panel", "particle")
    variables = {}
    for field, (name, meaning) in PARTICLE.items():
        values = np.full(shape, np.nan)
        for row, particles in zip(values, of_panels, strict=True):
            row[: len(particles)] = [getattr(particle, field) for particle in particles]
        variables[name] = (dimensions, values, {"units": "m", "long_name": meaning})
    bears = np.zeros(shape, dtype=np.int8)
    for row, particles in zip(bears, of_panels, strict=True):
        row[: len(particles)] = [particle.bears_load for particle in particles]
    variables[BEARS_LOAD] = (dimensions, bears, {"long_name": "whether a particle bears load"})
    return variables


def read_sections(path: str | PathLike) -> list[Section]:
    """The sections of a file of ``write_sections``, one a panel, as they were written.

    Raises
    ------
    OSError
        If the file is absent, damaged, or holds something else: one line names it.
    """
    particle_names = [name for name, _ in PARTICLE.values()]
    needed = (*Condition._fields, *NUMBERS, *SURFACES, *particle_names, "contact_mode", "position")
    data = load(path, (*needed, TOUCHES, BEARS_LOAD))
    return [_section(data, index) for index in range(data.sizes["panel"])]


def _section(data: xr.Dataset, index: int) -> Section:
    """The section of one panel of a file."""
    panel = {name: variable.values[index] for name, variable in data.data_vars.items()}
    state = State(
        Condition(*(float(panel[name]) for name in Condition._fields)),
        *(float(panel[name]) for name in NUMBERS),
        CONTACT_MODES[int(panel["contact_mode"])],
    )
    columns = [panel[name].tolist() for name, _ in PARTICLE.values()]
    bears = panel[BEARS_LOAD].astype(bool).tolist()
    particles = [
        Particle(*numbers, bears_load)
        for *numbers, bears_load in zip(*columns, bears, strict=True)
        if not np.isnan(numbers[0])
    ]
    surfaces = (panel[name] for name in SURFACES)
    touches = panel[TOUCHES].astype(bool)
    return Section(state, data["position"].values, *surfaces, touches, tuple(particles))
