"""The command ``thirdbody``: each engineering question is a sub-command.

The rest of the library is imported only to answer a question, so that ``thirdbody --help`` is quick.
"""

from __future__ import annotations

import json
import os
import re
import sys
import warnings
from collections.abc import Callable, Iterable, Mapping, Sequence
from inspect import Parameter, Signature, signature
from shutil import get_terminal_size
from typing import Annotated, Any

import typer

from thirdbody.units import ENGINEERING, SEARCHED

ANSWERED, NONE_FOUND, BAD_INPUT, NOT_WRITTEN, STOPPED = 0, 1, 2, 3, 130  # exit codes
REGIME, MODE = "lubrication_regime", "contact_mode"
SURFACE, LAYER = "--roughness-nm 300", "--particle-density-per-m2 1e11"
PARTICLES = f"--particle-diameter-nm 500 {SURFACE} {LAYER}"
_EXAMPLES = {
    "state": f"--load-N 10 --viscosity-cSt 90 {PARTICLES}",
    "viscosity": f"--load-N 10 {PARTICLES}",
    "size": f"--load-N 10 --viscosity-cSt 90 {SURFACE} {LAYER}",
    "roughness": f"--load-N 10 --viscosity-cSt 90 --particle-diameter-nm 500 {LAYER}",
    "density": f"--load-N 10 --viscosity-cSt 90 --particle-diameter-nm 500 {SURFACE}",
    "transitions": f"--viscosity-cSt 90 {PARTICLES}",
    "turning-point": f"--viscosity-cSt 0 --particle-diameter-nm 300 {SURFACE} {LAYER}",
    "bearing": "--ball silicon-nitride --ball-radius-mm 5 --speed-m-per-s 2 "
    "--oil-density-kg-per-m3 850 --pressure-viscosity-per-GPa 20 --write bearing.yaml",
    "curve": f"--load-N 10 {PARTICLES} --along viscosity --from 10 --to 150 "
    "--csv curve.csv --plot curve.svg",
    "compare": f"--load-N 10 --viscosity-cSt 90 {PARTICLES} --other-viscosity-cSt 120",
}
EXAMPLES = {name: f"thirdbody {name} {options}" for name, options in _EXAMPLES.items()}
MEASURED = f"thirdbody compare-data measured.csv --viscosity-cSt 90 {PARTICLES} --plot compared.svg"
MATERIALS = "steel, silicon-nitride, alumina, or GPa,1,GPa: modulus, Poisson's ratio and hardness"


def _number(given: Any) -> float:
    text = str(given)  # also called with defaults, which are numbers
    try:
        return int(text) if text.isdecimal() else float(text)
    except ValueError:
        raise typer.BadParameter(f"is {text!r}; allowed: a number, without unit") from None


def _material(text: str) -> Any:
    """A material: a name, or modulus [GPa], Poisson's ratio and hardness [GPa]."""
    from thirdbody.answers.bearing import MATERIALS as KNOWN
    from thirdbody.answers.bearing import USUAL_MATERIAL, Material
    from thirdbody.conditions import warn_outside, without_warnings

    try:
        if text.replace("-", " ") in KNOWN:
            return KNOWN[text.replace("-", " ")]
        modulus, ratio, hardness = map(float, text.split(","))
        with without_warnings():
            material = Material(1e9 * modulus, ratio, 1e9 * hardness)
    except ValueError:
        raise typer.BadParameter(f"is {text!r}; allowed: {MATERIALS}, e.g. 205,0.29,5") from None
    usual = {
        name: (1e-9 * low, 1e-9 * high, "GPa") for name, (low, high, _) in USUAL_MATERIAL.items()
    }
    warn_outside({"modulus": modulus, "hardness": hardness}, usual)
    return material


def _options(texts: Mapping[str, str], default: Any = None, **more: Any) -> dict[str, tuple]:
    """Types and defaults of options with these help texts, by the names of their arguments."""
    more = {"parser": _number, "metavar": "NUMBER"} | more
    names = {key: NAMES.get(key, key).replace("_", "-") for key in texts}
    return {
        key: (Annotated[str | None, typer.Option(f"--{names[key]}", help=text, **more)], default)
        for key, text in texts.items()
    }


def _ends(first: Any = Parameter.empty, last: Any = Parameter.empty) -> dict[str, tuple]:
    text = "value, in the unit of its option"
    return _options({"first": f"first {text}"}, first) | _options({"last": f"last {text}"}, last)


NAMES = {"first": "from", "last": "to", "first_N": "from-N", "last_N": "to-N"}  # of options
FILE = {"parser": str, "metavar": "FILE"}
CONDITIONS = {
    "load_N": "normal load [N]",
    "viscosity_cSt": "kinematic viscosity of the lubricant, 0 if dry [cSt]",
    "particle_diameter_nm": "mean particle diameter x_a as in the paper, 0 if none [nm]",
    "roughness_nm": "equivalent root mean square roughness [nm]",
    "particle_density_per_m2": "particles per area, 0 if none [m-2]",
}
EACH, SOME = _options(CONDITIONS, Parameter.empty), _options(CONDITIONS)
OTHER = _options({f"other_{key}": f"second interface: {text}" for key, text in CONDITIONS.items()})
OTHER_INPUTS = _options({"other_inputs": "inputs of the second interface"}, **FILE)
BEARING = _options(
    {
        "ball_radius_mm": "radius R_x [mm]",
        "speed_m_per_s": "rolling speed u [m/s]",
        "oil_density_kg_per_m3": "density rho [kg m-3]; required with the speed",
        "dynamic_viscosity_mPa_s": "mu_0 [mPa s]; with nu instead of the density",
        "viscosity_cSt": "nu [cSt]; U is printed for it",
        "pressure_viscosity_per_GPa": "alpha [GPa-1]",
        "apparent_area_mm2": "A_n [mm2], reference area of loads",
    }
)
BODIES = _options(
    dict.fromkeys(("ball", "flat", "particle"), f"{MATERIALS}, e.g. 205,0.29,5"),
    parser=_material,
    metavar="MATERIAL",
)
SPEED = _options({"speed_m_per_s": "speed of the inputs [m/s], if the data have speeds"})
ESTIMATES = _options(
    {
        "boundary_friction": "friction of solids [1], by default 0.12",
        "film_friction": "friction of the film [1], by default 0.03",
        "resistivity_ohm_m": "of both bodies [ohm m], by default 2.2e-7",
    }
)
JSON = {"json": (Annotated[bool, typer.Option("--json", help="print the answer as JSON")], False)}
COMMON = _options({"inputs": "inputs from bearing --write; default: calibrated"}, **FILE) | JSON
PRODUCTS = _options({"csv": "table to write", "plot": "figure to write"}, **FILE)
DATA = typer.Argument(metavar="FILE", help="CSV with units in its headings, e.g. load [N]")

questions = typer.Typer(
    add_completion=False,
    rich_markup_mode=None,
    context_settings={"help_option_names": ["-h", "--help"]},
)


def _version(given: bool) -> None:
    if given:
        import thirdbody

        print(f"thirdbody {thirdbody.__version__}")
        raise typer.Exit()


@questions.callback(
    epilog="Exit codes: 0 answered, 1 no such value, 2 bad input, 3 the answer "
    "cannot be written, 130 stopped by Ctrl-C."
)
def _thirdbody(
    version: Annotated[
        bool, typer.Option("--version", callback=_version, is_eager=True, help="print the version")
    ] = False,
) -> None:
    """Contact of rough surfaces with hard particles and an oil film between them."""


def _question(name: str, options: dict[str, tuple], example: str | None = None) -> Callable:
    """Add a function of the given arguments as a sub-command with ``options``."""

    def add(answer: Callable) -> None:
        def asked(**given: Any) -> tuple[Any, bool]:
            return answer(given), given["json"]

        asked.__doc__ = answer.__doc__
        asked.__signature__ = Signature(
            Parameter(key, Parameter.KEYWORD_ONLY, annotation=kind, default=default)
            for key, (kind, default) in options.items()
        )
        epilog = f"\b\nExample:\n  {example or EXAMPLES[name]}"  # \b: no wrapping
        questions.command(name, epilog=epilog)(asked)

    return add


@_question("state", EACH | COMMON)
def _state(given):
    """Load sharing, contact area, regime and mode."""
    return _interface(given).state()


# name: the condition to search, the flags that change, the question in words
CHANGES = {
    "viscosity": ("viscosity", [REGIME], "Which viscosity leaves boundary lubrication."),
    "size": ("particle_diameter", [MODE], "Which particle size a filter has to keep out."),
    "roughness": ("roughness", [REGIME, MODE], "At which roughness the regime or mode changes."),
    "density": ("particle_density", [MODE], "Which density of debris is too much."),
    "transitions": ("load", [REGIME, MODE], "At which load the regime or mode changes."),
}


def _without(along: str) -> dict[str, tuple]:
    return {key: option for key, option in EACH.items() if key != ENGINEERING[along]} | COMMON


def _add_changes(name: str, along: str, flags: list[str], text: str) -> None:
    """Add the question at which value of a condition the flags change."""

    def changes(given):
        return _interface(given).transitions(along, flags, _increasing(given, "first", "last"))

    changes.__doc__ = text
    _question(name, _ends(*SEARCHED[along]) | _without(along))(changes)


for name, question in CHANGES.items():
    _add_changes(name, *question)

LOADS = _options({"first_N": "first load [N]"}, 0.04) | _options({"last_N": "last load [N]"}, 80.0)


@_question("turning-point", LOADS | _without("load"))
def _turning_point(given):
    """At which load the contact area turns (TPCA), and for which sizes."""
    return _interface(given).turning_point(_increasing(given, "first_N", "last_N"))


@_question("bearing", BEARING | BODIES | _options({"write": "file of inputs"}, **FILE) | JSON)
def _bearing(given):
    """Which inputs follow from another ball, speed, oil or material."""
    from thirdbody.answers.bearing import bearing, derived
    from thirdbody.configuration.inputs import load_parameters

    inputs = bearing(load_parameters(), **_known(given, BEARING | BODIES))
    if given["write"] is not None:
        import yaml

        _write(given["write"], yaml.safe_dump(inputs.as_dict(), sort_keys=False))
    return derived(inputs, given["viscosity_cSt"])


AXIS = _options(
    {"along": ", ".join(ENGINEERING)}, Parameter.empty, parser=str, metavar="AXIS"
) | _options({"count": "points"}, 60)


@_question("curve", SOME | AXIS | _ends() | PRODUCTS | COMMON)
def _curve(given):
    """All variables along one axis, as CSV and as a plot."""
    along = given["along"]
    if along not in ENGINEERING:
        raise ValueError(f"--along is {along!r}; allowed: {', '.join(ENGINEERING)}")
    for name, key in ENGINEERING.items():
        if name != along and given[key] is None:
            raise ValueError(f"{key} is missing; allowed: a number")
    ends = _increasing(given, "first", "last")
    found = _interface(given).curve(along, *ends, given["count"])
    _write_products(given, found)
    written = " and ".join(_known(given, PRODUCTS).values())
    return f"{written} written" if written and not given["json"] else found


@_question("compare", EACH | OTHER | OTHER_INPUTS | COMMON)
def _compare(given):
    """Compare two interfaces; the second differs by --other-..."""
    one = _interface(given)
    changes = {key.removeprefix("other_"): value for key, value in _known(given, OTHER).items()}
    if given["other_inputs"] is not None:
        changes["parameters"] = _inputs(given, "other_inputs")
    return one.compare(one.changed(**changes))


DATA_FILE = {"file": (Annotated[str, DATA], Parameter.empty)}


@_question("compare-data", DATA_FILE | SOME | SPEED | ESTIMATES | PRODUCTS | COMMON, MEASURED)
def _compare_data(given):
    """Compare your measurements with the model: residuals, ensemble ranges, a figure."""
    from thirdbody.measured.comparison import compare
    from thirdbody.measured.estimates import Assumed

    found = compare(
        given["file"],
        parameters=_inputs(given, "inputs"),
        assumed=Assumed(**_known(given, ESTIMATES)),
        **_known(given, SOME | SPEED),
    )
    _write_products(given, found)
    return found.answer


def _known(given: Mapping[str, Any], names: Iterable[str]) -> dict[str, Any]:
    """The arguments with these names that are given."""
    return {name: given[name] for name in names if given.get(name) is not None}


def _increasing(given: Mapping[str, Any], first: str, last: str) -> tuple[float, float]:
    """The ends of a search; ``ValueError`` unless they are positive and increase."""
    least, most = given[first], given[last]
    if not 0.0 < least < most:
        allowed = f"positive numbers less than --{NAMES[last]}, {most:g}"
        raise ValueError(f"--{NAMES[first]} is {least:g}; allowed: {allowed}")
    return least, most


def _interface(given: Mapping[str, Any]) -> Any:
    """The interface from the arguments of a sub-command; an absent condition is not used."""
    from thirdbody.answers.interface import Interface

    unused = {key: SEARCHED[name][0] for name, key in ENGINEERING.items()}
    conditions = unused | _known(given, CONDITIONS)
    return Interface(**conditions, parameters=_inputs(given, "inputs"))


def _inputs(given: Mapping[str, Any], key: str) -> Any:
    from thirdbody.configuration.inputs import load_parameters

    try:
        return load_parameters(given[key])
    except (ValueError, OSError) as error:
        raise ValueError(f"--{key.replace('_', '-')} is {given[key]!r}; {error}") from None


def _write(path: str, text: str) -> None:
    from thirdbody.data.files import atomic_write

    with atomic_write(path) as part:
        part.write_text(text, encoding="utf-8")


def _write_products(given: Mapping[str, Any], found: Any) -> None:
    """Write the table and the figure of a ``Curve`` or ``Comparison``."""
    if given["csv"] is not None:
        _write(given["csv"], found.to_dataframe().to_csv(index=False, float_format="%.10g"))
    if given["plot"] is not None:
        from thirdbody.figures.drawing import save_figure
        from thirdbody.figures.plot import plot_comparison, plot_curve

        draw = plot_comparison if "file" in given else plot_curve
        save_figure(draw(found), given["plot"])


QUESTIONS = {command.name: signature(command.callback) for command in questions.registered_commands}
# messages of typer, and their form in the library: the option, its value, what is allowed
MESSAGES = {
    r"Invalid value for '(\S+)': (is .*)": r"\1 \2",
    r"Missing (?:option|argument) '(\S+)'.": r"\1 is missing",
    r"Missing command.": f"QUESTION is missing; allowed: {', '.join(QUESTIONS)}",
    r"No such command '(.*)'\.": rf"QUESTION is '\1'; allowed: {', '.join(QUESTIONS)}",
    r"No such option: (\S+)": r"there is no option \1",
}


def main(arguments: Sequence[str] | None = None) -> int:
    """Answer the question of a command line, by default ``sys.argv``; returns the exit code."""
    arguments = sys.argv[1:] if arguments is None else list(arguments)
    name = " ".join(["thirdbody", *(each for each in arguments[:1] if each in QUESTIONS)])
    with warnings.catch_warnings(record=True) as caught:
        warnings.simplefilter("ignore")
        warnings.simplefilter("default", UserWarning)  # other warnings are for developers
        try:
            asked = questions(arguments, prog_name="thirdbody", standalone_mode=False)
        except typer.TyperException as error:
            return _refuse(name, error.format_message())
        except (ValueError, OSError, ModuleNotFoundError) as error:
            return _refuse(name, str(error))
    for message in dict.fromkeys(str(each.message) for each in caught):
        print(f"{name}: warning: {_plain(message)}", file=sys.stderr)
    if asked == STOPPED:
        print(f"{name}: stopped; run the same command again to start over", file=sys.stderr)
    if isinstance(asked, int):  # of --help, --version and Ctrl-C
        return asked
    answer, as_json = asked
    written = _print(name, _text(answer, as_json))
    return written or (ANSWERED if getattr(answer, "found", True) else NONE_FOUND)


def _refuse(name: str, message: str) -> int:
    print(f"{name}: {_plain(message)}", file=sys.stderr)
    return BAD_INPUT


def _plain(message: str) -> str:
    """A message on one line, with arguments of the library replaced by their options."""
    for pattern, replacement in MESSAGES.items():
        message = re.sub(pattern, replacement, message)
    arguments = {name for each in QUESTIONS.values() for name in each.parameters if "_" in name}
    names = "|".join(sorted(arguments, key=len, reverse=True))
    message = re.sub(rf"\b({names})\b", lambda found: "--" + found[1].replace("_", "-"), message)
    return " ".join(message.split())


def _text(answer: Any, as_json: bool) -> str:
    """The printed form of an ``Answer``, a ``Curve`` or a line; tables fit the width of a terminal."""
    if as_json:
        return json.dumps(answer.as_dict())
    if sys.stdout.isatty() and hasattr(answer, "as_text"):
        return answer.as_text(get_terminal_size().columns)
    return str(answer)


def _print(name: str, text: str) -> int:
    """Print a text; a closed pipe is not an error."""
    try:
        print(text, flush=True)
    except OSError as error:
        # The rest of the buffer would be written again at exit.
        os.dup2(os.open(os.devnull, os.O_WRONLY), sys.stdout.fileno())
        if not isinstance(error, BrokenPipeError):
            print(f"{name}: the answer cannot be written ({error.strerror})", file=sys.stderr)
            return NOT_WRITTEN
    return ANSWERED
