"""Options of the sub-commands: their names, which carry the unit, and what values they allow."""

from __future__ import annotations

from argparse import ArgumentParser, ArgumentTypeError, Namespace
from collections.abc import Callable, Collection

from thirdbody.answers.bearing import MATERIALS, Material
from thirdbody.answers.interface import Interface
from thirdbody.answers.units import ENGINEERING, SEARCHED, unit_text
from thirdbody.conditions.checks import NEVER_ZERO
from thirdbody.configuration.inputs import load_parameters
from thirdbody.data.conditions import AXES
from thirdbody.model.parameters import Parameters

OTHER = "other_"  # before the names of the conditions of a second interface


def number(positive: bool) -> Callable[[str], float]:
    """What reads an option that is ``positive``, or zero or positive.

    Examples
    --------
    >>> number(positive=True)("2.5e3")
    2500.0
    """

    def read(text: str) -> float:
        try:
            value = float(text)
        except ValueError:
            value = -1.0
        if not 0.0 <= value < float("inf") or (positive and value == 0.0):
            sign = "positive" if positive else "zero or positive"
            raise ArgumentTypeError(f"is {text!r}; allowed: a {sign} number, without unit")
        return value

    return read


def whole_number(text: str) -> int:
    """What reads the number of points of a curve."""
    if not text.isdecimal() or not 2 <= int(text) <= 100_000:
        raise ArgumentTypeError(f"is {text!r}; allowed: a whole number from 2 to 100000")
    return int(text)


def material(text: str) -> Material:
    """What reads a material: a name, or modulus [GPa], Poisson's ratio and hardness [GPa].

    Examples
    --------
    >>> material("210,0.3,7").modulus
    210000000000.0
    """
    names = {name.replace(" ", "-"): known for name, known in MATERIALS.items()}
    if text in names:
        return names[text]
    try:
        modulus, ratio, hardness = map(float, text.split(","))
        return Material(1e9 * modulus, ratio, 1e9 * hardness)
    except ValueError:
        allowed = f"{', '.join(names)}, or modulus [GPa], Poisson's ratio and hardness [GPa]"
        raise ArgumentTypeError(f"is {text!r}; allowed: {allowed} as in 205,0.29,5") from None


def one_of(names: Collection[str]) -> Callable[[str], str]:
    """What reads one of some names."""

    def read(text: str) -> str:
        if text not in names:
            raise ArgumentTypeError(f"is {text!r}; allowed: {', '.join(names)}")
        return text

    return read


def option(name: str) -> str:
    """The option for the name of an argument.

    Examples
    --------
    >>> option("load_N")
    '--load-N'
    """
    return "--" + name.replace("_", "-")


def add_conditions(
    parser: ArgumentParser,
    but: Collection[str] = (),
    other: bool = False,
    required: bool = True,
) -> None:
    """Options for the conditions of an interface, all ``but`` some axes; or of an ``other`` one, whose
    conditions are those of the first unless they are given."""
    for name, key in ENGINEERING.items():
        if name in but:
            continue
        what = "normal load" if name == "load" else AXES[name].long_name
        parser.add_argument(
            option(OTHER * other + key),
            type=number(name in NEVER_ZERO),
            required=required and not other,
            metavar="NUMBER",
            help=f"{'of the second: ' * other}{what} [{unit_text(name)}]",
        )
    parser.add_argument(
        option(OTHER * other + "inputs"),
        type=read_inputs,
        metavar="FILE",
        help="inputs of the model, YAML, as `thirdbody bearing --write` makes it; "
        + ("by default those of the first" if other else "by default the calibrated ones"),
    )


def read_inputs(path: str) -> Parameters:
    """What reads a file of inputs."""
    try:
        return load_parameters(path)
    except (ValueError, OSError) as error:
        raise ArgumentTypeError(f"is {path!r}; {error}") from None


def add_ends(parser: ArgumentParser, along: str | None = None) -> None:
    """Options for the ends of a search ``along`` an axis, or of a curve over any."""
    for end, name in enumerate(("from", "to")):
        parser.add_argument(
            option(name),
            type=number(positive=True),
            required=along is None,
            default=along and SEARCHED[along][end],
            metavar="NUMBER",
            help=f"{('first', 'last')[end]} value, in the unit of its option"
            + (f" (default {SEARCHED[along][end]:g})" if along else ""),
        )


def ends_of(options: Namespace, first: str = "from", last: str = "to") -> tuple[float, float]:
    """The ends that two options give.

    Raises
    ------
    ValueError
        Unless the first is less than the last.
    """
    low, high = getattr(options, first), getattr(options, last)
    if not low < high:
        raise ValueError(f"{option(first)} is {low:g}; allowed: less than {option(last)}, {high:g}")
    return low, high


def interface_of(options: Namespace) -> Interface:
    """The interface that options describe; an axis that they do not give stands at a value that
    counts for nothing."""
    given = vars(options)
    conditions = {
        key: SEARCHED[name][0] if given.get(key) is None else given[key]
        for name, key in ENGINEERING.items()
    }
    return Interface(**conditions, parameters=options.inputs or load_parameters())


def other_interface_of(options: Namespace) -> Interface:
    """The second interface: the first with what options for the other one say."""
    given = vars(options)
    names = {**dict.fromkeys(ENGINEERING.values()), "inputs": "parameters"}
    changes = {
        called or name: given[OTHER + name]
        for name, called in names.items()
        if given[OTHER + name] is not None
    }
    return interface_of(options).changed(**changes)
