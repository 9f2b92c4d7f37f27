"""The command ``thirdbody``: each engineering question is a sub-command, a function of this module.

The rest of the library is imported only to answer a question, so that ``thirdbody --help`` is quick.
"""

import io
import os
import re
import sys
import warnings
from collections.abc import Callable, Collection, Iterator, Mapping, Sequence
from contextlib import contextmanager, redirect_stdout, suppress
from inspect import signature
from json import dumps
from shutil import get_terminal_size
from typing import Annotated, Any

import typer

from thirdbody.variables import AXES, BY_ALIAS

ANSWERED, NONE_FOUND, BAD_INPUT, NOT_WRITTEN, STOPPED = 0, 1, 2, 3, 130  # exit codes
COMMANDS = {}  # the example of each question by its name
MATERIALS = "steel, silicon-nitride, alumina, or GPa,1,GPa: modulus, Poisson's ratio and hardness"


def _number(given: Any) -> float:
    text = str(given)  # also called with defaults, which are numbers
    try:
        return int(text) if text.isdecimal() else float(text)
    except ValueError:
        raise typer.BadParameter(f"is {text!r}; allowed: a number, without unit") from None


def _material(text: str) -> Any:
    """A material: a name, or modulus [GPa], Poisson's ratio and hardness [GPa]."""
    from thirdbody.bearings import MATERIALS as KNOWN
    from thirdbody.bearings import Material

    try:
        if text.replace("-", " ") in KNOWN:
            return KNOWN[text.replace("-", " ")]
        modulus, ratio, hardness = map(float, text.split(","))
        return Material(modulus, ratio, hardness)
    except ValueError:
        raise typer.BadParameter(f"is {text!r}; allowed: {MATERIALS}, e.g. 205,0.29,5") from None


def _option(name: str, text: str, metavar: str = "NUMBER", parser: Callable = _number) -> Any:
    """The type of an argument that an option sets."""
    option = typer.Option(f"--{name}", help=text, metavar=metavar, parser=parser)
    return Annotated[str | None, option]


def _file(name: str, text: str) -> Any:
    return _option(name, text, "FILE", str)


def _body(name: str) -> Any:
    return _option(name, f"{MATERIALS}, e.g. 205,0.29,5", "MATERIAL", _material)


LOAD = "normal load [N]"
VISCOSITY = "kinematic viscosity of the lubricant, 0 if dry [cSt]"
SIZE = "mean particle diameter x_a as in the paper, 0 if none [nm]"
ROUGHNESS = "equivalent root mean square roughness, sqrt(Rq_1^2 + Rq_2^2) of two surfaces; Rq is 1.25 Ra [nm]"
DENSITY = "particles per area, 0 if none [m-2]"
Load = _option("load-N", LOAD)
Viscosity = _option("viscosity-cSt", VISCOSITY)
Size = _option("particle-diameter-nm", SIZE)
Roughness = _option("roughness-nm", ROUGHNESS)
Density = _option("particle-density-per-m2", DENSITY)
First = _option("from", "first value, in the unit of its option")
Last = _option("to", "last value, in the unit of its option")
FirstLoad = _option("from-N", "first load [N]")
LastLoad = _option("to-N", "last load [N]")
Inputs = _file("inputs", "inputs from bearing --write; default: calibrated")
Csv = _file("csv", "table to write")
Plot = _file("plot", "figure to write")
Json = Annotated[bool, typer.Option("--json", help="print the answer as JSON")]
Asked = tuple[Any, bool]  # an answer, and whether it is printed as JSON


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


def _question(example: str) -> Callable:
    """Add a function as the sub-command of its name, with an example."""

    def add(answer: Callable) -> Callable:
        name = answer.__name__.replace("_", "-")
        COMMANDS[name] = f"thirdbody {name} {example}"
        epilog = f"\b\nExample:\n  {COMMANDS[name]}"  # \b: no wrapping
        return questions.command(name, epilog=epilog)(answer)

    return add


@_question(
    "--load-N 10 --viscosity-cSt 90 --particle-diameter-nm 500 --roughness-nm 300 "
    "--particle-density-per-m2 1e11"
)
def state(
    *,
    load_N: Load,
    viscosity_cSt: Viscosity,
    particle_diameter_nm: Size,
    roughness_nm: Roughness,
    particle_density_per_m2: Density,
    inputs: Inputs = None,
    json: Json = False,
) -> Asked:
    """Load sharing, contact area, regime and mode."""
    return _interface(locals()).state(), json


@_question(
    "--load-N 10 --particle-diameter-nm 500 --roughness-nm 300 --particle-density-per-m2 1e11"
)
def viscosity(
    *,
    first: First = AXES["viscosity"].searched[0],
    last: Last = AXES["viscosity"].searched[1],
    load_N: Load,
    particle_diameter_nm: Size,
    roughness_nm: Roughness,
    particle_density_per_m2: Density,
    inputs: Inputs = None,
    json: Json = False,
) -> Asked:
    """Which viscosity leaves boundary lubrication."""
    return _changes(locals(), "viscosity", ["lubrication_regime"]), json


@_question("--load-N 10 --viscosity-cSt 90 --roughness-nm 300 --particle-density-per-m2 1e11")
def size(
    *,
    first: First = AXES["particle_diameter"].searched[0],
    last: Last = AXES["particle_diameter"].searched[1],
    load_N: Load,
    viscosity_cSt: Viscosity,
    roughness_nm: Roughness,
    particle_density_per_m2: Density,
    inputs: Inputs = None,
    json: Json = False,
) -> Asked:
    """Which particle size a filter has to keep out."""
    return _changes(locals(), "particle_diameter", ["contact_mode"]), json


@_question(
    "--load-N 10 --viscosity-cSt 90 --particle-diameter-nm 500 --particle-density-per-m2 1e11"
)
def roughness(
    *,
    first: First = AXES["roughness"].searched[0],
    last: Last = AXES["roughness"].searched[1],
    load_N: Load,
    viscosity_cSt: Viscosity,
    particle_diameter_nm: Size,
    particle_density_per_m2: Density,
    inputs: Inputs = None,
    json: Json = False,
) -> Asked:
    """At which roughness the regime or mode changes."""
    return _changes(locals(), "roughness", ["lubrication_regime", "contact_mode"]), json


@_question("--load-N 10 --viscosity-cSt 90 --particle-diameter-nm 500 --roughness-nm 300")
def density(
    *,
    first: First = AXES["particle_density"].searched[0],
    last: Last = AXES["particle_density"].searched[1],
    load_N: Load,
    viscosity_cSt: Viscosity,
    particle_diameter_nm: Size,
    roughness_nm: Roughness,
    inputs: Inputs = None,
    json: Json = False,
) -> Asked:
    """Which density of debris is too much."""
    return _changes(locals(), "particle_density", ["contact_mode"]), json


@_question(
    "--viscosity-cSt 90 --particle-diameter-nm 500 --roughness-nm 300 "
    "--particle-density-per-m2 1e11"
)
def transitions(
    *,
    first: First = AXES["load"].searched[0],
    last: Last = AXES["load"].searched[1],
    viscosity_cSt: Viscosity,
    particle_diameter_nm: Size,
    roughness_nm: Roughness,
    particle_density_per_m2: Density,
    inputs: Inputs = None,
    json: Json = False,
) -> Asked:
    """At which load the regime or mode changes."""
    return _changes(locals(), "load", ["lubrication_regime", "contact_mode"]), json


@_question(
    "--viscosity-cSt 0 --particle-diameter-nm 300 --roughness-nm 300 --particle-density-per-m2 1e11"
)
def turning_point(
    *,
    first_N: FirstLoad = 0.04,
    last_N: LastLoad = 80.0,
    viscosity_cSt: Viscosity,
    particle_diameter_nm: Size,
    roughness_nm: Roughness,
    particle_density_per_m2: Density,
    inputs: Inputs = None,
    json: Json = False,
) -> Asked:
    """At which load the contact area turns (TPCA), and for which sizes."""
    ends = _increasing(first_N, last_N, "-N")
    return _interface(locals()).turning_point(ends), json


@_question(
    "--ball silicon-nitride --ball-radius-mm 5 --speed-m-per-s 2 "
    "--oil-density-kg-per-m3 850 --pressure-viscosity-per-GPa 20 --write bearing.yaml"
)
def bearing(
    *,
    ball_radius_mm: _option("ball-radius-mm", "radius R_x [mm]") = None,
    speed_m_per_s: _option("speed-m-per-s", "rolling speed u [m/s]") = None,
    oil_density_kg_per_m3: _option(
        "oil-density-kg-per-m3", "density rho [kg m-3]; required with the speed"
    ) = None,
    dynamic_viscosity_mPa_s: _option(
        "dynamic-viscosity-mPa-s", "mu_0 [mPa s]; with nu instead of the density"
    ) = None,
    viscosity_cSt: _option("viscosity-cSt", "nu [cSt]; U is printed for it") = None,
    pressure_viscosity_per_GPa: _option("pressure-viscosity-per-GPa", "alpha [GPa-1]") = None,
    apparent_area_mm2: _option("apparent-area-mm2", "A_n [mm2], reference area of loads") = None,
    ball: _body("ball") = None,
    flat: _body("flat") = None,
    particle: _body("particle") = None,
    write: _file("write", "file of inputs to write") = None,
    json: Json = False,
) -> Asked:
    """Which inputs follow from another ball, speed, oil or material."""
    given = locals()
    from thirdbody.bearings import bearing as inputs_of
    from thirdbody.bearings import derived

    changes = {name: given[name] for name in given.keys() - {"write", "json"}}
    found = inputs_of(**changes)
    if write is not None:
        import yaml

        # what all members have is known; what they do not stays unknown where the file is read
        known = {
            name: value
            for name, value in found.as_dict().items()
            if all(getattr(member, name) == value for member in found.members)
        }
        _write(write, yaml.safe_dump(known, sort_keys=False))
    return derived(found, viscosity_cSt), json


@_question(
    "--load-N 10 --particle-diameter-nm 500 --roughness-nm 300 "
    "--particle-density-per-m2 1e11 --along viscosity --from 10 --to 150 "
    "--csv curve.csv --plot curve.svg"
)
def curve(
    *,
    load_N: Load = None,
    viscosity_cSt: Viscosity = None,
    particle_diameter_nm: Size = None,
    roughness_nm: Roughness = None,
    particle_density_per_m2: Density = None,
    along: _option(
        "along", "load, viscosity, particle_diameter, roughness, particle_density", "AXIS", str
    ),
    count: _option("count", "points") = 60,
    first: First,
    last: Last,
    csv: Csv = None,
    plot: Plot = None,
    inputs: Inputs = None,
    json: Json = False,
) -> Asked:
    """All variables along one axis, as CSV and as a plot."""
    given = locals()

    def draw():
        from thirdbody.plotting.plot import plot_curve

        return plot_curve(found.values, found.along)

    if along not in AXES:
        raise ValueError(f"--along is {along!r}; allowed: {', '.join(AXES)}")
    for key, axis in BY_ALIAS.items():
        if axis.name != along and given[key] is None:
            raise ValueError(f"{key} is missing; allowed: a number")
    ends = _increasing(first, last)
    found = _interface(given).curve(along, *ends, count)
    _write_table(csv, found)
    _write_plot(plot, draw)
    written = " and ".join(path for path in (csv, plot) if path is not None)
    return f"{written} written" if written and not json else found, json


@_question(
    "--load-N 10 --viscosity-cSt 90 --particle-diameter-nm 500 --roughness-nm 300 "
    "--particle-density-per-m2 1e11 --other-viscosity-cSt 120"
)
def compare(
    *,
    load_N: Load,
    viscosity_cSt: Viscosity,
    particle_diameter_nm: Size,
    roughness_nm: Roughness,
    particle_density_per_m2: Density,
    other_load_N: _option("other-load-N", f"second interface: {LOAD}") = None,
    other_viscosity_cSt: _option("other-viscosity-cSt", f"second interface: {VISCOSITY}") = None,
    other_particle_diameter_nm: _option(
        "other-particle-diameter-nm", f"second interface: {SIZE}"
    ) = None,
    other_roughness_nm: _option("other-roughness-nm", f"second interface: {ROUGHNESS}") = None,
    other_particle_density_per_m2: _option(
        "other-particle-density-per-m2", f"second interface: {DENSITY}"
    ) = None,
    other_inputs: _file("other-inputs", "inputs of the second interface") = None,
    inputs: Inputs = None,
    json: Json = False,
) -> Asked:
    """Compare two interfaces; the second differs by --other-..."""
    given = locals()
    one = _interface(given)
    changes = _conditions({key: given[f"other_{key}"] for key in one.conditions})
    if other_inputs is not None:
        changes["parameters"] = _inputs(other_inputs, "other-inputs")
    if not changes:
        message = "--other-... is missing; allowed: one or more, e.g. --other-viscosity-cSt 120"
        raise ValueError(message)
    try:
        return one.compare(one.changed(**changes)), json
    except ValueError as error:
        raise ValueError(f"other_{error}") from None


@_question(
    "measured.csv --viscosity-cSt 90 --particle-diameter-nm 500 --roughness-nm 300 "
    "--particle-density-per-m2 1e11 --plot compared.svg"
)
def compare_data(
    *,
    file: Annotated[
        str, typer.Argument(metavar="FILE", help="CSV with units in its headings, e.g. load [N]")
    ],
    load_N: Load = None,
    viscosity_cSt: Viscosity = None,
    particle_diameter_nm: Size = None,
    roughness_nm: Roughness = None,
    particle_density_per_m2: Density = None,
    speed_m_per_s: _option(
        "speed-m-per-s",
        "speed of the inputs [m/s], if the data have speeds; with a density, any rolling speed",
    ) = None,
    oil_density_kg_per_m3: _option(
        "oil-density-kg-per-m3",
        "density of the oil [kg m-3]: the inputs are derived for it and the speeds",
    ) = None,
    ball_radius_mm: _option("ball-radius-mm", "radius R_x [mm]") = None,
    boundary_friction: _option(
        "boundary-friction", "friction of solids [1], by default 0.12"
    ) = None,
    film_friction: _option("film-friction", "friction of the film [1], by default 0.03") = None,
    resistivity_ohm_m: _option(
        "resistivity-ohm-m", "of both bodies [ohm m], by default 2.2e-7"
    ) = None,
    csv: Csv = None,
    plot: Plot = None,
    inputs: Inputs = None,
    json: Json = False,
) -> Asked:
    """Compare your measurements with the model: residuals, ensemble ranges, a figure."""
    given = locals()
    from thirdbody.lab.comparison import compare as compare_with_model
    from thirdbody.lab.estimates import Assumed

    assumed = {key: given[key] for key in vars(Assumed()) if given[key] is not None}
    found = compare_with_model(
        file,
        parameters=_inputs(inputs),
        assumed=Assumed(**assumed),
        speed_m_per_s=speed_m_per_s,
        oil_density_kg_per_m3=oil_density_kg_per_m3,
        ball_radius_mm=ball_radius_mm,
        **_conditions(given),
    )
    _write_table(csv, found)
    _write_plot(plot, found.plot)
    return found.answer, json


def _conditions(given: Mapping[str, Any]) -> dict[str, float]:
    """The conditions among the arguments of a sub-command that are given."""
    return {key: given[key] for key in BY_ALIAS if given.get(key) is not None}


def _interface(given: Mapping[str, Any]) -> Any:
    """The interface from the arguments of a sub-command; an absent condition is not used."""
    from thirdbody.answers.interface import Interface

    unused = {key: axis.searched[0] for key, axis in BY_ALIAS.items()}
    return Interface(**unused | _conditions(given), parameters=_inputs(given["inputs"]))


def _inputs(path: str | None, option: str = "inputs") -> Any:
    from thirdbody.inputs import load_parameters

    try:
        return load_parameters(path)
    except (ValueError, OSError) as error:
        raise ValueError(f"--{option} is {path!r}; {error}") from None


def _increasing(first: float, last: float, unit: str = "") -> tuple[float, float]:
    """The ends of a search; ``ValueError`` unless they are positive and increase."""
    if not 0.0 < first < last:
        allowed = f"positive numbers less than --to{unit}, {last:g}"
        raise ValueError(f"--from{unit} is {first:g}; allowed: {allowed}")
    return first, last


def _changes(given: Mapping[str, Any], along: str, flags: Collection[str]) -> Any:
    """The changes of flags along a condition, between the ends of a search."""
    between = _increasing(given["first"], given["last"])
    between = None if between == AXES[along].searched else between
    return _interface(given).transitions(along, flags, between)


class NotWritten(OSError):
    """A file for the answer cannot be written."""


@contextmanager
def _writing() -> Iterator[None]:
    """A context in which an ``OSError`` is ``NotWritten``."""
    try:
        yield
    except OSError as error:
        raise NotWritten(error) from None


def _write(path: str, text: str) -> None:
    from thirdbody.files import atomic_write

    with _writing(), atomic_write(path) as part:
        part.write_text(text, encoding="utf-8")


def _write_table(path: str | None, found: Any) -> None:
    """Write the table of a ``Curve`` or ``Comparison``, if a path is given."""
    if path is not None:
        _write(path, found.to_dataframe().to_csv(index=False, float_format="%.10g"))


def _write_plot(path: str | None, draw: Callable) -> None:
    """Draw a figure and write it, if a path is given."""
    if path is not None:
        from thirdbody.plotting.drawing import save_figure

        figure = draw()
        with _writing():
            save_figure(figure, path)


EXAMPLES = {name: each for name, each in COMMANDS.items() if name != "compare-data"}

# messages of typer, and their form in the library: the option, its value, what is allowed
MESSAGES = {
    r"Invalid value for '(\S+)': (is .*)": r"\1 \2",
    r"Missing (?:option|argument) '(\S+)'.": r"\1 is missing",
    r"Option '(\S+)' requires an argument\.": r"\1 has no value",
    r"Missing command.": f"QUESTION is missing; allowed: {', '.join(COMMANDS)}",
    r"No such command '(.*?)'\..*": rf"QUESTION is '\1'; allowed: {', '.join(COMMANDS)}",
    r"No such option: (\S+)": r"there is no option \1",
    r"\b(?:between|low to high|between_N) is": "--from or --to is",
}


def main(arguments: Sequence[str] | None = None) -> int:
    """Answer the question of a command line, by default ``sys.argv``; returns the exit code."""
    arguments = sys.argv[1:] if arguments is None else list(arguments)
    name = " ".join(["thirdbody", *(each for each in arguments[:1] if each in COMMANDS)])
    printed = io.StringIO()  # of --help and --version
    refusal, code = None, BAD_INPUT
    with warnings.catch_warnings(record=True) as caught, redirect_stdout(printed):
        warnings.simplefilter("ignore")
        warnings.simplefilter("default", UserWarning)  # other warnings are for developers
        try:
            asked = questions(arguments, prog_name="thirdbody", standalone_mode=False)
        except typer.TyperException as error:
            refusal = error.format_message()
        except NotWritten as error:
            refusal, code = str(error), NOT_WRITTEN
        except (ValueError, OSError, ModuleNotFoundError) as error:
            refusal = str(error)
    for message in dict.fromkeys(str(each.message) for each in caught):
        _tell(name, f"warning: {_plain(message)}")
    if refusal is not None:
        _tell(name, _plain(refusal))
        return code
    if asked == STOPPED:
        _tell(name, "stopped; run the same command again to start over")
    if isinstance(asked, int):
        return _print(name, printed.getvalue()) or asked
    answer, as_json = asked
    text = str(answer)
    if as_json:
        text = dumps(answer.as_dict())
    elif sys.stdout and sys.stdout.isatty() and hasattr(answer, "as_text"):
        text = answer.as_text(get_terminal_size().columns)  # tables fit the width
    written = _print(name, text + "\n")
    return written or (ANSWERED if getattr(answer, "found", True) else NONE_FOUND)


def _tell(name: str, message: str) -> None:
    with suppress(OSError):
        print(f"{name}: {message}", file=sys.stderr)


def _plain(message: str) -> str:
    """A message on one line, with arguments of the library replaced by their options."""
    for pattern, replacement in MESSAGES.items():
        message = re.sub(pattern, replacement, message)
    functions = (command.callback for command in questions.registered_commands)
    arguments = {name for each in functions for name in signature(each).parameters if "_" in name}
    names = "|".join(sorted(arguments, key=len, reverse=True))
    named = rf"(?<!-)\b({names})\b"  # not what was typed as an option
    message = re.sub(named, lambda found: "--" + found[1].replace("_", "-"), message)
    return " ".join(message.split())


def _print(name: str, text: str) -> int:
    """Print a text; a closed pipe is not an error, a closed standard output is."""
    if sys.stdout is None:
        _tell(name, "the answer cannot be written (standard output is closed)")
        return NOT_WRITTEN
    try:
        print(text, end="", flush=True)
    except OSError as error:
        # The rest of the buffer would be written again at exit.
        os.dup2(os.open(os.devnull, os.O_WRONLY), sys.stdout.fileno())
        if not isinstance(error, BrokenPipeError):
            _tell(name, f"the answer cannot be written ({error.strerror})")
            return NOT_WRITTEN
    return ANSWERED
