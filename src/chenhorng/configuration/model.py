"""What config.yaml and scenes.yaml may say: a class for each mapping, a field for each key, with its bounds.

The classes are closed, so that a misspelt key is an error, and numbers are numbers, not texts.
"""

import math
import re
from collections.abc import Mapping
from itertools import pairwise
from typing import Annotated, Any

import numpy as np
from pydantic import AfterValidator, BaseModel, ConfigDict, Field, ValidationError, model_validator

from thirdbody.variables import VARIABLES

FIGURES = {f"fig{number:02d}" for number in range(3, 14)}
FOLDERS = (
    "accuracy|atlas|bands|calibration|claims|datasets|explorer|extracted|figures|release|tables"
)


def zero_or_from(least: float) -> AfterValidator:
    """A number that is 0 or not below ``least``."""

    def check(value):
        if 0 < value < least:
            raise ValueError(f"allowed: 0, or {least:g} or more")
        return value

    return AfterValidator(check)


def _increasing(values):
    if any(after <= before for before, after in pairwise(values)):
        raise ValueError("allowed: numbers that increase")
    return values


def _variable(name):
    if name not in VARIABLES:
        raise ValueError(f"allowed: {', '.join(VARIABLES)}")
    return name


def _distinct(values):
    if len({*values}) < len(values):
        raise ValueError("allowed: different values")
    return values


def number(least: float, most: float, words: str, or_zero: bool = False, **limits: Any) -> Any:
    """The field of a number between two ends, and what it is."""
    if or_zero:
        allowed: dict[str, Any] = {"allowed": f"0, or number from {least:g} to {most:g}"}
        return Field(ge=0, le=most, description=words, json_schema_extra=allowed)
    return Field(le=most, description=words, **({"ge": least} | limits))


Load = Annotated[float, number(1e-7, 1e4, "normal load F_t [N]")]
Viscosity = Annotated[
    float,
    number(0.3, 1e5, "kinematic viscosity nu [cSt], 0 when dry", or_zero=True),
    zero_or_from(0.3),
]
Diameter = Annotated[
    float,
    number(1, 1e5, "mean particle diameter x_a [nm], 0 without particles", or_zero=True),
    zero_or_from(1),
]
Ratio = Annotated[float, number(0, 1000, "mean particle diameter over roughness, x_a/sigma [1]")]
Roughness = Annotated[float, number(1, 1e4, "equivalent root mean square roughness sigma [nm]")]
Density = Annotated[
    float,
    number(1e6, 1e15, "particles per unit area eta_a [m-2], 0 without particles", or_zero=True),
    zero_or_from(1e6),
]
Rtol = Annotated[float, number(1e-11, 1e-2, "requested relative error [1]")]
NamedLoad = Annotated[float, number(0, 1, "F_t* named in the text [1]", gt=0)]
Positive = Field(gt=0)
File = Annotated[
    str,
    Field(
        pattern=r"^config/[A-Za-z0-9_/-]+\.yaml$",
        json_schema_extra={"allowed": "the path of a YAML file in config/"},
    ),
]
Increasing = AfterValidator(_increasing)
Values = Field(min_length=1, max_length=1000), AfterValidator(_distinct)
Axis = Field(min_length=1, max_length=1000), Increasing


class Closed(BaseModel):
    """A mapping without other keys, with numbers that are finite."""

    model_config = ConfigDict(extra="forbid", strict=True, allow_inf_nan=False)


class LoadAxis(Closed):
    """F_t* from the first to the last load in newtons, evenly spaced in its logarithm."""

    load_N: Annotated[list[Load], Field(min_length=2, max_length=2), Increasing]
    count: Annotated[int, Field(ge=5, le=100_000, description="number of loads")]


class Layer(Closed):
    """Conditions with particles that lie side by side: the area fraction pi/4 x_a^2 eta_a cannot exceed 1."""

    @model_validator(mode="after")
    def _particles_fit(self):
        most = {name: np.max(value) for name, value in self if value is not None}
        diameter = most.get("particle_diameter_nm")
        if diameter is None:
            diameter = most["particle_diameter_per_roughness"] * most["roughness_nm"]
        covered = 0.25 * math.pi * (1e-9 * diameter) ** 2 * most["particle_density_per_m2"]
        if covered > 1.0:
            raise ValueError(
                f"particles of {diameter:g} nm cover {covered:.3g} of the interface; allowed: at most 1"
            )
        return self


class Curves(Layer):
    """A group of curves: every combination of the values is computed."""

    viscosity_cSt: Annotated[list[Viscosity], *Values]
    particle_diameter_nm: Annotated[list[Diameter], *Values] | None = None
    particle_diameter_per_roughness: Annotated[list[Ratio], *Values] | None = None
    roughness_nm: Annotated[list[Roughness], *Values]
    particle_density_per_m2: Annotated[list[Density], *Values]

    @model_validator(mode="before")
    def _one_diameter(self):
        if isinstance(self, Mapping) and ("particle_diameter_nm" in self) == (
            "particle_diameter_per_roughness" in self
        ):
            raise ValueError(
                "allowed: either particle_diameter_nm or particle_diameter_per_roughness"
            )
        return self


class Panel(Layer):
    """A panel of a drawing: a load and its conditions."""

    load_N: Annotated[Load, Field(le=1000)]
    viscosity_cSt: Viscosity
    particle_diameter_nm: Annotated[Diameter, Positive]
    roughness_nm: Roughness
    particle_density_per_m2: Annotated[Density, Positive]


class Scene(Closed):
    """A dataset and a figure."""

    title: Annotated[
        str,
        Field(
            pattern=r"^[^\x00-\x1f]{1,200}$",
            description="title of the dataset and of the figure",
            json_schema_extra={"allowed": "text in one line, up to 200 letters"},
        ),
    ]
    named_loads: Annotated[list[NamedLoad], Field(max_length=1000)] = []
    load_axis: LoadAxis | None = None
    rtol: Rtol | None = None
    curves: Annotated[
        list[Curves],
        Field(
            min_length=1,
            max_length=100,
            description="groups of curves; every combination of a group's values is computed",
        ),
    ]


class Windows(Closed):
    """Search for the range of x_a/sigma in which the turning point occurs."""

    roughness_nm: Annotated[list[Roughness], *Values]
    particle_density_per_m2: Annotated[Density, Positive]
    particle_diameter_per_roughness: Annotated[
        list[Annotated[Ratio, Positive]], Field(min_length=2, max_length=2), Increasing
    ]
    count: Annotated[
        int, Field(ge=10, le=100_000, description="sampled x_a/sigma before the ends are refined")
    ]


class Schematics(Closed):
    """Conditions of the drawings, figures 1 and 2."""

    fig01: Annotated[list[Panel], Field(min_length=1, max_length=1)]
    fig02: Annotated[list[Panel], Field(min_length=3, max_length=3)]


class Atlas(Closed):
    """The conditions that ``snakemake atlas`` solves: every combination, a file for each roughness."""

    load_N: Annotated[list[Load], *Axis]
    viscosity_cSt: Annotated[list[Viscosity], *Axis]
    particle_diameter_nm: Annotated[list[Diameter], *Axis]
    roughness_nm: Annotated[list[Roughness], *Axis]
    particle_density_per_m2: Annotated[list[Density], *Axis]
    rtol: Rtol
    variables: Annotated[
        list[Annotated[str, AfterValidator(_variable)]], Field(description="kept at each point")
    ]


def _plain(name, taken):
    """A plain word that is not ``taken`` as the name of a product."""
    if not re.fullmatch(r"[a-z][a-z0-9_]{0,40}", name) or re.fullmatch(taken, name):
        raise ValueError(
            f"{name!r}; allowed: a word of small letters, digits and _ that no product has"
        )
    return name


def _named(scenes):
    for name in {*scenes} - FIGURES:
        _plain(name, r"fig.*|claims|sensitivity|.*_(wide|tpca_loads|transitions)")
    if missing := FIGURES - {*scenes}:
        raise ValueError(f"{', '.join(sorted(missing))} missing; allowed: all figures of the paper")
    return scenes


class Configuration(Closed):
    """config.yaml and scenes.yaml together."""

    run: (
        Annotated[
            str,
            AfterValidator(lambda name: _plain(name, FOLDERS)),
            Field(
                description="name of the run; its files go to results/NAME",
                json_schema_extra={"allowed": "a word of small letters, digits and _"},
            ),
        ]
        | None
    ) = None
    calibrated: Annotated[
        File, Field(description="calibrated file with the inputs and their ensemble")
    ]
    inputs: Annotated[
        dict[str, Any] | File,
        Field(
            description="inputs that override them, or a file of them",
            json_schema_extra={"allowed": "inputs with their values, or the path of a YAML file"},
        ),
    ]
    rtol: Rtol
    bands: Annotated[bool, Field(description="whether figures show the range of the ensemble")]
    windows: Windows
    load_axis: LoadAxis
    scenes: Annotated[
        dict[str, Scene],
        AfterValidator(_named),
        Field(description="a dataset and a figure each; fig03 to fig13 are those of the paper"),
    ]
    schematics: Schematics
    accuracy: Annotated[File, Field(description="settings of the accuracy run")]
    atlas: Atlas


def check(content: Any, name: str) -> None:
    """Raise ``ValueError``, in one line with the key, its value and what is allowed, for the first fault."""
    try:
        Configuration.model_validate(content)
    except ValidationError as error:
        raise ValueError(f"{name}: {first_fault(error)}") from None


def first_fault(error: ValidationError) -> str:
    """The first fault in one line."""
    first = error.errors(include_url=False)[0]
    value = "" if first["type"] == "missing" else f" is {str(first['input']):.60}"
    return f"{'.'.join(map(str, first['loc']))}{value}; {first['msg']}"
