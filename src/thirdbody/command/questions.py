"""The sub-commands: what each asks, its options, an example, and the call that answers it."""

from __future__ import annotations

from argparse import ArgumentParser, Namespace
from collections.abc import Callable
from dataclasses import dataclass

import yaml

from thirdbody.answers.answer import Answer
from thirdbody.answers.bearing import bearing, derived
from thirdbody.answers.curve import Curve
from thirdbody.answers.interface import BORDERED
from thirdbody.answers.units import ENGINEERING
from thirdbody.command.options import (
    add_conditions,
    add_ends,
    ends_of,
    interface_of,
    material,
    number,
    one_of,
    option,
    other_interface_of,
    whole_number,
)
from thirdbody.configuration.inputs import load_parameters
from thirdbody.data.files import atomic_write
from thirdbody.data.paper_tables import LOADS

# the interface of the examples, by the names of the axes
GIVEN = {
    "load": "--load-N 10",
    "viscosity": "--viscosity-cSt 90",
    "particle_diameter": "--particle-diameter-nm 500",
    "roughness": "--roughness-nm 300",
    "particle_density": "--particle-density-per-m2 1e11",
}


def example(command: str, but: str = "", more: str = "") -> str:
    """A command with the conditions of ``GIVEN``, all ``but`` one, and ``more`` options."""
    given = (text for name, text in GIVEN.items() if name != but)
    return " ".join(filter(None, ["thirdbody", command, *given, more]))


@dataclass(frozen=True)
class Question:
    """A sub-command.

    Attributes
    ----------
    asks : str
        What it answers.
    example : str
        A command that works.
    add_options : callable
        Adds its options to a parser.
    answer : callable
        Maps parsed options to an ``Answer`` or a ``Curve``.
    """

    asks: str
    example: str
    add_options: Callable[[ArgumentParser], None]
    answer: Callable[[Namespace], Answer | Curve]


def along(axis: str, command: str, asks: str, flags: tuple[str, ...]) -> Question:
    """The question where regimes or modes, ``flags``, change along an axis."""

    def add_options(parser):
        add_conditions(parser, but=[axis])
        add_ends(parser, axis)

    def answer(options):
        return interface_of(options).transitions(axis, flags, ends_of(options))

    return Question(asks, example(command, but=axis), add_options, answer)


def _add_turning_options(parser):
    add_conditions(parser, but=["load"])
    for name, default in zip(("from_N", "to_N"), LOADS):
        parser.add_argument(
            option(name),
            type=number(positive=True),
            default=default,
            metavar="NUMBER",
            help=f"{name.split('_')[0]} this load [N] (default {default:g})",
        )


def _turning_point(options):
    return interface_of(options).turning_point(ends_of(options, "from_N", "to_N"))


NUMBERS_OF_BEARING = {
    "ball_radius_mm": "radius of the ball R_x [mm]",
    "speed_m_per_s": "rolling speed u [m/s]",
    "oil_density_kg_per_m3": "density of the oil rho [kg m-3]; goes with the speed",
    "dynamic_viscosity_mPa_s": "dynamic viscosity mu_0 [mPa s]; with nu in the place of the density",
    "viscosity_cSt": "kinematic viscosity nu [cSt]; U is told for it",
    "pressure_viscosity_per_GPa": "pressure-viscosity coefficient alpha [GPa-1]",
}
BODIES_OF_BEARING = ("ball", "flat", "particle")


def _add_bearing_options(parser):
    for name, what in NUMBERS_OF_BEARING.items():
        parser.add_argument(option(name), type=number(True), metavar="NUMBER", help=what)
    for name in BODIES_OF_BEARING:
        parser.add_argument(
            option(name),
            type=material,
            metavar="MATERIAL",
            help=f"material of the {name}: steel, silicon-nitride, alumina, or modulus [GPa], "
            "Poisson's ratio and hardness [GPa] as in 205,0.29,5",
        )
    parser.add_argument(
        "--write", metavar="FILE", help="write all inputs there, for --inputs of other questions"
    )


def _bearing(options):
    given = {name: getattr(options, name) for name in (*NUMBERS_OF_BEARING, *BODIES_OF_BEARING)}
    inputs = bearing(load_parameters(), **given)
    if options.write:
        with atomic_write(options.write) as part:
            part.write_text(yaml.safe_dump(inputs.as_dict(), sort_keys=False), encoding="utf-8")
    return derived(inputs, options.viscosity_cSt)


def _add_curve_options(parser):
    parser.add_argument(
        "--along",
        type=one_of(ENGINEERING),
        required=True,
        metavar="AXIS",
        help=f"axis of the curve: {', '.join(ENGINEERING)}; its own option counts for nothing",
    )
    add_conditions(parser, required=False)  # all but one are, and which one is not known yet
    add_ends(parser)
    parser.add_argument(
        "--count", type=whole_number, default=60, metavar="NUMBER", help="points (default 60)"
    )
    parser.add_argument(
        "--csv", metavar="FILE", help="write the curve there instead of printing it"
    )
    parser.add_argument(
        "--plot", metavar="FILE", help="draw it: a name that ends with .svg, .png, .pdf"
    )


def _curve(options):
    missing = [
        key
        for name, key in ENGINEERING.items()
        if name != options.along and vars(options)[key] is None
    ]
    if missing:
        raise ValueError(f"{option(missing[0])} is missing; allowed: a number")
    curve = interface_of(options).curve(options.along, *ends_of(options), options.count)
    if options.csv:
        with atomic_write(options.csv) as part:
            part.write_text(curve.as_csv(), encoding="utf-8")
    if options.plot:
        from thirdbody.figures.line import draw, save_drawing

        save_drawing(
            draw(curve.along, curve.points, curve.values, curve.low, curve.high), options.plot
        )
    return curve


def _add_two(parser):
    add_conditions(parser)
    add_conditions(parser, other=True)


REGIME, MODE = BORDERED
QUESTIONS = {
    "state": Question(
        "how load and contact area divide, in which regime and mode",
        example("state"),
        add_conditions,
        lambda options: interface_of(options).state(),
    ),
    "viscosity": along(
        "viscosity",
        "viscosity",
        "which viscosity leaves boundary lubrication, and which reaches a full film",
        (REGIME,),
    ),
    "size": along(
        "particle_diameter",
        "size",
        "which particle size, that is which filter, keeps out of the particle-surface mode",
        (MODE,),
    ),
    "roughness": along(
        "roughness", "roughness", "at which roughness regime or mode change", BORDERED
    ),
    "density": along(
        "particle_density",
        "density",
        "which density of debris is too much: the mode changes",
        (MODE,),
    ),
    "transitions": along(
        "load", "transitions", "at which load the regime or the mode changes", BORDERED
    ),
    "turning-point": Question(
        "at which load the contact area turns (TPCA), and for which sizes it does",
        "thirdbody turning-point --viscosity-cSt 0 --particle-diameter-nm 300 --roughness-nm 300 "
        "--particle-density-per-m2 1e11",
        _add_turning_options,
        _turning_point,
    ),
    "bearing": Question(
        "which inputs follow from another ball, speed, oil, steel or ceramic",
        "thirdbody bearing --ball silicon-nitride --ball-radius-mm 5 --speed-m-per-s 2 "
        "--oil-density-kg-per-m3 850 --pressure-viscosity-per-GPa 20 --write bearing.yaml",
        _add_bearing_options,
        _bearing,
    ),
    "curve": Question(
        "all variables along one axis, as CSV and as a plot",
        example(
            "curve",
            but="viscosity",
            more="--along viscosity --from 10 --to 150 --csv curve.csv --plot curve.svg",
        ),
        _add_curve_options,
        _curve,
    ),
    "compare": Question(
        "two interfaces beside each other",
        example("compare", more="--other-viscosity-cSt 120"),
        _add_two,
        lambda options: interface_of(options).compare(other_interface_of(options)),
    ),
}
