"""The schema of config.yaml and scenes.yaml: a class for each mapping, and a field with bounds for
each key.

The classes are closed, so that a misspelt key is an error.  They are strict, so that a text is no
number.
"""

import math
import re
from collections.abc import Callable, Mapping
from dataclasses import dataclass
from itertools import pairwise
from typing import Annotated, Any

import numpy as np
from pydantic import (
    BaseModel,
    ConfigDict,
    Field,
    GetCoreSchemaHandler,
    GetJsonSchemaHandler,
    ValidationError,
    field_validator,
    model_validator,
)
from pydantic_core.core_schema import no_info_after_validator_function

from thirdbody.conditions import LOOSEST, TIGHTEST
from thirdbody.variables import CONDITION_AXES, VARIABLES, decimal

FIGURES = tuple(f"fig{number:02d}" for number in range(3, 14))
FOLDERS = (
    "accuracy|atlas|bands|calibration|claims|datasets|explorer|extracted|figures|release|tables"
)
OTHER_PRODUCTS = r"fig.*|claims|sensitivity|.*_(wide|tpca_loads|transitions)"
LONGEST = 60  # characters of a value in a message
# the least usual value of each condition [``alias_unit``]: a smaller one is in another unit
LEAST = {axis.name: float(decimal(axis.from_si(axis.usual[0]), 12)) for axis in CONDITION_AXES}


@dataclass(frozen=True)
class Allowed:
    """A check of a value, and words on the allowed values, for the message and for the
    documentation."""

    is_allowed: Callable[[Any], bool]
    words: str

    def check(self, value: Any) -> Any:
        """Return the ``value``, or raise ``ValueError`` if it is not allowed."""
        if not self.is_allowed(value):
            raise ValueError(f"allowed: {self.words}")
        return value

    def __get_pydantic_core_schema__(self, source: Any, handler: GetCoreSchemaHandler) -> Any:
        return no_info_after_validator_function(self.check, handler(source))

    def __get_pydantic_json_schema__(self, schema: Any, handler: GetJsonSchemaHandler) -> Any:
        return handler(schema) | {"allowed": self.words}


def one_of(*names: str) -> Allowed:
    """A check that a value is one of the ``names``."""
    return Allowed(names.__contains__, ", ".join(names))


def zero_or_from(least: float) -> Allowed:
    """A check that a number is 0, or ``least`` or more."""
    return Allowed(lambda value: not 0 < value < least, f"0, or {least:g} or more")


def plain_word(taken: str) -> Allowed:
    """A check that a text is a plain word, and that the expression ``taken``, for names of
    products, does not match it."""
    return Allowed(
        lambda name: is_plain(name, taken),
        "a plain word of small letters, digits and _ that no product has",
    )


def is_file(path: str) -> bool:
    """Whether ``path`` is the path of a YAML file below config/."""
    return bool(re.fullmatch(r"config/[A-Za-z0-9_/-]+\.yaml", path))


def is_plain(name: str, taken: str) -> bool:
    """Whether ``name`` is a word of small letters, digits and _ that does not match ``taken``."""
    return bool(re.fullmatch(r"[a-z][a-z0-9_]{0,40}", name)) and not re.fullmatch(taken, name)


Load = Annotated[float, Field(ge=1e-7, le=1e4, description="normal load F_t [N]")]
Viscosity = Annotated[
    float,
    Field(ge=0, le=1e5, description="kinematic viscosity nu [cSt], 0 when dry"),
    zero_or_from(LEAST["viscosity"]),
]
Diameter = Annotated[
    float,
    Field(ge=0, le=1e5, description="particle size x_a [nm], 0 without particles"),
    zero_or_from(LEAST["particle_diameter"]),
]
Ratio = Annotated[
    float,
    Field(ge=0, le=1000, description="particle size over roughness, x_a/sigma [1]"),
]
Roughness = Annotated[
    float,
    Field(
        ge=LEAST["roughness"],
        le=1e4,
        description="equivalent root mean square roughness sigma [nm]",
    ),
]
Density = Annotated[
    float,
    Field(ge=0, le=1e15, description="particles per unit area eta_a [m-2], 0 without particles"),
    zero_or_from(LEAST["particle_density"]),
]
NamedLoad = Annotated[float, Field(gt=0, le=1, description="F_t* named in the text [1]")]
Rtol = Annotated[float, Field(ge=TIGHTEST, le=LOOSEST, description="requested relative error [1]")]
Positive = Allowed(lambda value: value > 0, "above 0")
File = Annotated[str, Allowed(is_file, "the path of a YAML file below config/")]
Pair = Field(min_length=2, max_length=2)
Increasing = Allowed(
    lambda values: all(before < after for before, after in pairwise(values)),
    "numbers that increase",
)
Some = Field(min_length=1, max_length=1000)
Distinct = Allowed(lambda values: len({*values}) == len(values), "different values")


class Closed(BaseModel):
    """A mapping that refuses other keys, and numbers that are not finite."""

    model_config = ConfigDict(extra="forbid", strict=True, allow_inf_nan=False)


class LoadAxis(Closed):
    """F_t* from the first to the last load in newtons, evenly spaced in its logarithm."""

    load_N: Annotated[list[Load], Pair, Increasing]
    count: Annotated[int, Field(ge=5, le=100_000, description="number of loads")]


class Layer(Closed):
    """Conditions with particles.  They lie side by side, so the area fraction pi/4 x_a^2 eta_a
    cannot exceed 1.
    """

    @model_validator(mode="after")
    def _particles_fit(self):
        most = {name: np.max(value) for name, value in self if value is not None}
        diameter = most.get("particle_diameter_nm")
        if diameter is None:
            diameter = most["particle_diameter_per_roughness"] * most["roughness_nm"]
        covered = 0.25 * math.pi * (1e-9 * diameter) ** 2 * most["particle_density_per_m2"]
        if covered > 1.0:
            raise ValueError(
                f"particles of {diameter:g} nm cover {covered:.3g} of the interface; "
                "allowed: at most 1"
            )
        return self


class Curves(Layer):
    """A group of curves: every combination of the values is computed."""

    viscosity_cSt: Annotated[list[Viscosity], Some, Distinct]
    particle_diameter_nm: Annotated[list[Diameter], Some, Distinct] | None = None
    particle_diameter_per_roughness: Annotated[list[Ratio], Some, Distinct] | None = None
    roughness_nm: Annotated[list[Roughness], Some, Distinct]
    particle_density_per_m2: Annotated[list[Density], Some, Distinct]

    @model_validator(mode="before")
    @classmethod
    def _one_diameter(cls, content):
        keys = "particle_diameter_nm", "particle_diameter_per_roughness"
        if isinstance(content, Mapping) and len(content.keys() & {*keys}) != 1:
            raise ValueError(f"allowed: either {' or '.join(keys)}")
        return content


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
        Field(description="title of the dataset and the figure"),
        Allowed(
            lambda text: bool(re.fullmatch(r"[^\x00-\x1f]{1,200}", text)),
            "a line of 1 to 200 characters",
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
            description="groups of curves: every combination of the values of a group is computed",
        ),
    ]


class Windows(Closed):
    """The search for windows: the ranges of x_a/sigma in which the turning point occurs."""

    roughness_nm: Annotated[list[Roughness], Some, Distinct]
    particle_density_per_m2: Annotated[Density, Positive]
    particle_diameter_per_roughness: Annotated[list[Annotated[Ratio, Positive]], Pair, Increasing]
    count: Annotated[
        int, Field(ge=10, le=100_000, description="sampled x_a/sigma before the ends are refined")
    ]


class Schematics(Closed):
    """Conditions of the drawings, figures 1 and 2."""

    fig01: Annotated[
        list[Panel], Field(min_length=1, max_length=1, description="the panel of figure 1")
    ]
    fig02: Annotated[
        list[Panel], Field(min_length=3, max_length=3, description="the panels of figure 2")
    ]


class Atlas(Closed):
    """The conditions that ``snakemake atlas`` solves in every combination.  Each roughness has a
    file."""

    load_N: Annotated[list[Load], Some, Increasing]
    viscosity_cSt: Annotated[list[Viscosity], Some, Increasing]
    particle_diameter_nm: Annotated[list[Diameter], Some, Increasing]
    roughness_nm: Annotated[list[Roughness], Some, Increasing]
    particle_density_per_m2: Annotated[list[Density], Some, Increasing]
    rtol: Rtol
    variables: Annotated[
        list[Annotated[str, one_of(*VARIABLES)]], Field(description="kept at each point")
    ]


class Configuration(Closed):
    """The configuration of a run: config.yaml and scenes.yaml together."""

    run: (
        Annotated[str, plain_word(FOLDERS), Field(description="its files go to results/NAME")]
        | None
    ) = None
    calibrated: Annotated[
        File, Field(description="calibrated file with the inputs and their ensemble")
    ]
    inputs: Annotated[
        Any,
        Field(description="inputs that override them, or a file of them"),
        Allowed(
            lambda given: isinstance(given, Mapping) or isinstance(given, str) and is_file(given),
            "inputs with their values, or the path of a YAML file below config/",
        ),
    ]
    rtol: Annotated[
        Rtol, Field(description="requested relative error [1], by default that of the library")
    ]
    bands: Annotated[bool, Field(description="whether figures show the range of the ensemble")]
    windows: Windows
    load_axis: LoadAxis
    scenes: Annotated[
        dict[str, Scene],
        Field(description="a dataset and a figure for each name; those of the paper are required"),
    ]
    schematics: Schematics
    accuracy: Annotated[File, Field(description="settings of the accuracy run")]
    atlas: Atlas

    @field_validator("scenes", mode="before")
    @classmethod
    def _are_named(cls, scenes):
        if not isinstance(scenes, Mapping):
            return scenes
        for name in scenes.keys() - {*FIGURES}:
            if not is_plain(name, OTHER_PRODUCTS):
                raise ValueError(
                    f"{name!r:.{LONGEST}} is no name of a scene; allowed: a plain word of small "
                    "letters, digits and _ that no product has"
                )
        if missing := sorted({*FIGURES} - scenes.keys()):
            raise ValueError(f"{', '.join(missing)} missing; allowed: all figures of the paper")
        return scenes


def check(content: Any, name: str) -> None:
    """Raise ``ValueError`` for the first fault of ``content``.  Its line has the key, the value and
    the allowed values.
    """
    try:
        Configuration.model_validate(content)
    except ValidationError as error:
        raise ValueError(f"{name}: {first_fault(error)}") from None


def first_fault(error: ValidationError) -> str:
    """The first fault of an ``error`` in one line: the key, the value unless it is a mapping, and
    the message."""
    first = error.errors(include_url=False)[0]
    keys = [str(key) if str(key).isprintable() else repr(key) for key in first["loc"]]
    words = first["msg"].removeprefix("Value error, ")
    if not keys:
        return words
    place, value = f"{'.'.join(keys):.300}", first["input"]
    is_told = first["type"] != "missing" and not isinstance(value, Mapping)
    return f"{place} is {value!r:.{LONGEST}}; {words}" if is_told else f"{place}: {words}"
