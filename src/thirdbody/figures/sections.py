"""Sections through the three-body interface, and the file that keeps them."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from os import PathLike
from typing import Any

import numpy as np
from numpy.typing import NDArray

from thirdbody.data.attributes import coordinate_attributes, variable_attributes
from thirdbody.data.conditions import AXES, Condition
from thirdbody.data.netcdf import load, write_netcdf
from thirdbody.data.plain import PlainDataset
from thirdbody.data.quantities import FLAGS, QUANTITIES
from thirdbody.model.regimes import CONTACT_MODES

NUMBERS = ("separation", "particle_contact_area_ratio", "solid_load_fraction")  # of a state
# fields of a particle, all in m: names in the file and their meaning
PARTICLE = {
    "particle_position": "position of the centre of a particle; nan: no particle",
    "particle_height": "height of the centre of a particle",
    "particle_size": "diameter of a particle",
}
LINES = {"lower": "height of the lower surface", "upper": "height of the upper surface"}
TOUCHES, CARRIES_LOAD = "surfaces_touch", "particle_carries_load"


@dataclass(frozen=True)
class State:
    """A solved interface: its condition, and d [m], A_sa,t*, L_s and the mode of its solution."""

    condition: Condition
    separation: float
    particle_contact_area_ratio: float
    solid_load_fraction: float
    contact_mode: str

    @classmethod
    def of(cls, condition: Condition, solution: Any) -> State:
        """The state from the ``Solution`` of this one point; ``ValueError`` if there is none."""
        if not np.isfinite(solution.separation):
            raise ValueError(f"schematic conditions {condition._asdict()} have no solution")
        numbers = (float(getattr(solution, name)) for name in NUMBERS)
        return cls(condition, *numbers, CONTACT_MODES[int(solution.contact_mode)])


@dataclass(frozen=True)
class Particle:
    """A particle: position and height of its centre and its diameter [m]; does it carry load?"""

    position: float
    height: float
    diameter: float
    carries_load: bool


@dataclass(frozen=True)
class Section:
    """A section through two rough surfaces with particles between them.

    ``position`` along it and the heights ``lower`` and ``upper`` of both surfaces have shape (n,) [m];
    the heights are equal and flat where the surfaces touch, as ``touches`` says.
    """

    state: State
    position: NDArray[np.float64]
    lower: NDArray[np.float64]
    upper: NDArray[np.float64]
    touches: NDArray[np.bool_]
    particles: tuple[Particle, ...]


def write_sections(path: str | PathLike, sections: Sequence[Section]) -> None:
    """Write the sections of a schematic to a NetCDF-4 file; ``OSError`` if that fails."""
    states = [section.state for section in sections]
    attributes = {name: coordinate_attributes(AXES[name]) for name in Condition._fields}
    attributes |= {name: coordinate_attributes(QUANTITIES[name]) for name in NUMBERS}
    numbers = np.array(
        [[*state.condition, *(getattr(state, n) for n in NUMBERS)] for state in states]
    )
    variables = {
        name: ("panel", values, attributes[name])
        for name, values in zip(attributes, numbers.T, strict=True)
    }
    modes = np.array([CONTACT_MODES.index(state.contact_mode) for state in states], dtype=np.int8)
    variables["contact_mode"] = ("panel", modes, variable_attributes(FLAGS["contact_mode"]))
    along = ("panel", "position")
    for name, meaning in LINES.items():
        heights = [getattr(section, name) for section in sections]
        variables[name] = (along, heights, {"units": "m", "long_name": meaning})
    touches = np.array([section.touches for section in sections], dtype=np.int8)
    variables[TOUCHES] = (along, touches, {"long_name": "whether the surfaces touch"})
    # panels with fewer particles than others end with nan
    most = max(len(section.particles) for section in sections)
    table = np.full((len(sections), most, 4), np.nan)
    for panel, section in enumerate(sections):
        for place, one in enumerate(section.particles):
            table[panel, place] = one.position, one.height, one.diameter, one.carries_load
    each = ("panel", "particle")
    for index, (name, meaning) in enumerate(PARTICLE.items()):
        variables[name] = (each, table[..., index], {"units": "m", "long_name": meaning})
    carries = (table[..., 3] == 1.0).astype(np.int8)
    variables[CARRIES_LOAD] = (each, carries, {"long_name": "whether a particle carries load"})
    position = ("position", sections[0].position, {"units": "m", "long_name": "along the section"})
    dataset = PlainDataset(variables, {"position": position}, {"Conventions": "CF-1.11"})
    write_netcdf(dataset, path, {})


def read_sections(path: str | PathLike) -> list[Section]:
    """The sections of a file of ``write_sections``; ``OSError`` in one line if it cannot be read."""
    needed = (*Condition._fields, *NUMBERS, *LINES, *PARTICLE, "contact_mode", "position")
    data = load(path, (*needed, TOUCHES, CARRIES_LOAD))
    found = []
    for index in range(data.sizes["panel"]):
        panel = {name: variable.values[index] for name, variable in data.data_vars.items()}
        condition = Condition(*(float(panel[name]) for name in Condition._fields))
        numbers = (float(panel[name]) for name in NUMBERS)
        state = State(condition, *numbers, CONTACT_MODES[int(panel["contact_mode"])])
        columns = [panel[name].tolist() for name in PARTICLE]
        rows = zip(*columns, panel[CARRIES_LOAD].astype(bool).tolist(), strict=True)
        particles = tuple(Particle(*row) for row in rows if not np.isnan(row[0]))
        touches = panel[TOUCHES].astype(bool)
        lines = (panel[name] for name in LINES)
        found.append(Section(state, data["position"].values, *lines, touches, particles))
    return found
