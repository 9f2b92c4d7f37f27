"""Notes below an answer, each a sentence: on conditions that the paper has not, on the sizes of
particles, on A_n, the speed and the range."""

import re
import textwrap
from collections.abc import Iterable, Mapping

import numpy as np
from numpy.typing import ArrayLike

from thirdbody.core.parameters import Parameters
from thirdbody.core.particles import ParticleLayer, mean_and_largest
from thirdbody.ensembles import FITTED, Ensemble
from thirdbody.symbols import TIGHT
from thirdbody.variables import CONDITIONS, SPEED, decimal

WIDTH = 80  # letters of a line of text
SPEED_DIGITS = 3  # of the speed that follows from U/nu


def wrapped(text: str, first: str = "", others: str = "", width: int = WIDTH) -> str:
    """A text in lines of so many columns that begin with ``first`` and ``others``.

    A number stays on the line of its unit; options and paths stay whole.
    """
    tight = re.sub(TIGHT, "\N{NO-BREAK SPACE}", text)
    lines = textwrap.fill(
        tight,
        width,
        initial_indent=first,
        subsequent_indent=others,
        break_long_words=False,
        break_on_hyphens=False,
    )
    return lines.replace("\N{NO-BREAK SPACE}", " ")


def note_lines(notes: Iterable[str]) -> str:
    """The ``notes`` as text of ``WIDTH`` columns."""
    return "\n".join(wrapped(note, "  ", "    ") for note in notes)


def outside_notes(conditions: Mapping[str, ArrayLike], speed: float) -> list[str]:
    """A note for each of the ``conditions`` by alias, in its unit, that is outside Table 2.

    The paper has one ``speed`` [m/s], that of its inputs.  0 is never outside: it stands for no
    oil, no particles, or rest.
    """
    notes = []
    for axis in CONDITIONS.values():
        values = np.asarray(conditions.get(axis.alias, ()), float)
        if values.any():
            least = np.min(values, initial=np.inf, where=values != 0.0)
            paper, digits = axis.paper, 12  # 80 N as F_t* and back is 80 N again
            if axis is SPEED:
                digits = SPEED_DIGITS
                paper = 2 * (decimal(speed, digits).item(),)
            ends = decimal([least, np.max(values)], digits)
            if ends[0] < paper[0] or ends[1] > paper[1]:
                unit = axis.alias_unit
                given, known = (
                    " to ".join(dict.fromkeys(f"{float(f'{end:.4g}'):g}" for end in both))
                    for both in (ends, paper)
                )
                notes.append(f"{axis.words} {given} {unit}: the paper has {known} {unit}")
    return notes


def number_text(value: float, digits: int = 3) -> str:
    """A number with significant ``digits``, also their zeros; without a power of ten if it is
    neither small nor large."""
    rounded = f"{value:.{digits - 1}e}"
    if not 1e-4 <= abs(float(rounded)) < 1e6:
        return rounded if value else "0"
    _, exponent = rounded.split("e")
    return f"{float(rounded):.{max(digits - 1 - int(exponent), 0)}f}"


def sizes_words(parameters: Parameters, diameter: float = 1.0, unit: str = "x_a") -> str:
    """The mean of the sizes of particles and the largest, for a ``diameter`` x_a in a ``unit``."""
    mean, largest = map(number_text, mean_and_largest(diameter, parameters))
    return f"the mean of the sizes is {mean} {unit}, the largest, X_max, {largest} {unit}"


def label_note(parameters: Parameters) -> str:
    """A note on what the particle size x_a stands for."""
    return f"particle size x_a, a label: {sizes_words(parameters)}"


def sizes_note(diameter: float, roughness: float, parameters: Parameters) -> str:
    """A note on what a ``diameter`` x_a [m] stands for.

    It ends with the separation d below which the particles carry load on a ``roughness`` sigma [m].
    """
    layer = ParticleLayer.of(np.array([diameter]), roughness, np.ones(1), parameters)
    x_a = 1e9 * diameter
    return (
        f"particle size x_a = {x_a:.4g} nm, a label: {sizes_words(parameters, x_a, 'nm')}; "
        f"particles carry load at separations d below {number_text(1e9 * layer.reach[0])} nm"
    )


def layer_notes(conditions: Mapping[str, ArrayLike], parameters: Parameters) -> list[str]:
    """A note on what x_a stands for, if the ``conditions`` by alias have particles.

    It has lengths for one x_a on one roughness.  A condition that is missing is searched along.
    """
    size, roughness, density = (
        np.unique(np.asarray(conditions.get(name, np.nan), float))
        for name in ("particle_diameter_nm", "roughness_nm", "particle_density_per_m2")
    )
    size = size[size != 0.0]
    if not (size.size and density.any()):
        return []
    if size.size == roughness.size == 1 and np.isfinite([size, roughness]).all():
        return [sizes_note(1e-9 * size.item(), 1e-9 * roughness.item(), parameters)]
    return [label_note(parameters)]


def few_notes(per_m2: float, area: float) -> list[str]:
    """A note if ``area`` A_n [m2] has less than one particle; otherwise none."""
    count = per_m2 * area
    note = f"{count:.2g} particles in A_n = {1e6 * area:.3g} mm2: most contacts have none"
    return [note] if 0.0 < count < 1.0 else []


def area_note(parameters: Parameters | Ensemble) -> str:
    """A note on the nominal area A_n, to which loads refer."""
    return f"the nominal area A_n of the inputs is {1e6 * parameters.apparent_area:.3g} mm2"


def ratios_note(parameters: Parameters | Ensemble) -> str:
    """A note on what areas and the film thickness are relative to."""
    return (
        f"total_contact_area is over A_n, film_thickness over R_x = "
        f"{1e3 * parameters.ball_radius:.4g} mm; contact area ratios are over the total"
    )


def speed_notes(ensemble: Ensemble) -> list[str]:
    """A note on the speed in the inputs; none if the density of the oil is unknown."""
    density = ensemble.setup.oil_density_kg_per_m3
    if density is None:
        return []
    speed = f"an entrainment speed of {ensemble.speed:.{SPEED_DIGITS}g} m/s"
    note = f"with an oil of {density:.4g} kg/m3, U/nu is for {speed}"
    return [note]


def range_note(ensemble: Ensemble) -> str:
    """A note on the meaning of ranges."""
    count = len(ensemble.members)
    if count == 1:
        return "no range: these inputs have no ensemble"
    return f"range of {count} calibrated sets of inputs: 5 to 95 % of them, {FITTED}"
