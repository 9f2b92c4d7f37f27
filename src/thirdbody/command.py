"""The command ``thirdbody``: each engineering question is a sub-command.

``command.toml`` has their texts.  The rest of the library is imported only to answer a question, so
that ``thirdbody --help`` is quick.
"""

import io
import json
import os
import re
import sys
import warnings
from collections.abc import Callable, Iterable, Mapping, Sequence
from contextlib import redirect_stdout, suppress
from functools import partial
from inspect import Parameter, Signature, signature
from shutil import get_terminal_size
from typing import Annotated, Any

import typer

from thirdbody.messages import did_you_mean
from thirdbody.toml_tables import toml_beside
from thirdbody.units import ENGINEERING, SEARCHED

ANSWERED, NONE_FOUND, BAD_INPUT, NOT_WRITTEN, STOPPED = 0, 1, 2, 3, 130  # exit codes
TEXTS = toml_beside(__file__)
QUESTIONS = TEXTS["questions"]
COMMANDS = {name: f"thirdbody {name} {each['example']}" for name, each in QUESTIONS.items()}
EXAMPLES = {name: each for name, each in COMMANDS.items() if name != "compare-data"}
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
    from thirdbody.answers.bearing import Material

    try:
        if text.replace("-", " ") in KNOWN:
            return KNOWN[text.replace("-", " ")]
        modulus, ratio, hardness = map(float, text.split(","))
        return Material(modulus, ratio, hardness)
    except ValueError:
        raise typer.BadParameter(f"is {text!r}; allowed: {MATERIALS}, e.g. 205,0.29,5") from None


def _options(
    texts: Mapping[str, str],
    default: Any = None,
    metavar: str = "NUMBER",
    parser: Callable = _number,
) -> dict[str, tuple]:
    """Types and defaults of options with these help texts, by the names of their arguments."""
    options = {}
    for key, text in texts.items():
        name = "--" + NAMES.get(key, key).replace("_", "-")
        option = typer.Option(name, help=text, metavar=metavar, parser=parser)
        options[key] = Annotated[str | None, option], default
    return options


def _other(key: str, *more: Any) -> dict[str, tuple]:
    return _options({key: TEXTS["others"][key]}, *more)


NAMES = {"first": "from", "last": "to", "first_N": "from-N", "last_N": "to-N"}  # of options
FILE = None, "FILE", str  # no default
CONDITION_TEXTS, BEARING, ESTIMATES = (
    TEXTS[name] for name in ("conditions", "bearing", "estimates")
)
EACH, SOME = _options(CONDITION_TEXTS, Parameter.empty), _options(CONDITION_TEXTS)
OTHER = _options(
    {f"other_{key}": f"second interface: {text}" for key, text in CONDITION_TEXTS.items()}
)
BODIES = dict.fromkeys(("ball", "flat", "particle"), f"{MATERIALS}, e.g. 205,0.29,5")
JSON = {"json": (Annotated[bool, typer.Option("--json", help="print the answer as JSON")], False)}
COMMON = _other("inputs", *FILE) | JSON
PRODUCTS = _other("csv", *FILE) | _other("plot", *FILE)

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


def _question(name: str, options: dict[str, tuple]) -> Callable:
    """Add a function of the given arguments as a sub-command with ``options``."""

    def add(answer: Callable) -> None:
        def asked(**given: Any) -> tuple[Any, bool]:
            return answer(given), given["json"]

        asked.__signature__ = Signature(
            Parameter(key, Parameter.KEYWORD_ONLY, annotation=kind, default=default)
            for key, (kind, default) in options.items()
        )
        epilog = f"\b\nExample:\n  {COMMANDS[name]}"  # \b: no wrapping
        questions.command(name, help=QUESTIONS[name]["text"], epilog=epilog)(asked)

    return add


@_question("state", EACH | COMMON)
def _state(given):
    return _interface(given).state()


def _without(along: str) -> dict[str, tuple]:
    return {key: option for key, option in EACH.items() if key != ENGINEERING[along]} | COMMON


def _changes(along, flags, given):
    between = _increasing(given, "first", "last")
    between = None if between == SEARCHED[along] else between
    return _interface(given).transitions(along, flags, between)


for name, each in QUESTIONS.items():
    if "along" in each:
        along, (first, last) = each["along"], SEARCHED[each["along"]]
        options = _other("first", first) | _other("last", last) | _without(along)
        _question(name, options)(partial(_changes, along, each["flags"]))


@_question("turning-point", _other("first_N", 0.04) | _other("last_N", 80.0) | _without("load"))
def _turning_point(given):
    return _interface(given).turning_point(_increasing(given, "first_N", "last_N"))


OF_BODIES = _options(BODIES, None, "MATERIAL", _material) | _other("write", *FILE) | JSON


@_question("bearing", _options(BEARING) | OF_BODIES)
def _bearing(given):
    from thirdbody.answers.bearing import bearing, derived
    from thirdbody.configuration.inputs import load_parameters

    inputs = bearing(load_parameters(), **_known(given, BEARING | BODIES))
    if given["write"] is not None:
        import yaml

        _write(given["write"], yaml.safe_dump(inputs.as_dict(), sort_keys=False))
    return derived(inputs, given["viscosity_cSt"])


AXIS = _other("along", Parameter.empty, "AXIS", str) | _other("count", 60)
AXIS |= _other("first", Parameter.empty) | _other("last", Parameter.empty)


@_question("curve", SOME | AXIS | PRODUCTS | COMMON)
def _curve(given):
    along = given["along"]
    if along not in ENGINEERING:
        allowed = ", ".join(ENGINEERING) + did_you_mean(along, ENGINEERING)
        raise ValueError(f"--along is {along!r}; allowed: {allowed}")
    for name, key in ENGINEERING.items():
        if name != along and given[key] is None:
            raise ValueError(f"{key} is missing; allowed: a number")
    ends = _increasing(given, "first", "last")
    found = _interface(given).curve(along, *ends, given["count"])
    _write_products(given, found)
    written = " and ".join(_known(given, PRODUCTS).values())
    return f"{written} written" if written and not given["json"] else found


@_question("compare", EACH | OTHER | _other("other_inputs", *FILE) | COMMON)
def _compare(given):
    one = _interface(given)
    if not _known(given, [*OTHER, "other_inputs"]):
        raise ValueError(
            "--other-... is missing; allowed: one or more, e.g. --other-viscosity-cSt 120"
        )
    changes = {key.removeprefix("other_"): value for key, value in _known(given, OTHER).items()}
    if given["other_inputs"] is not None:
        changes["parameters"] = _inputs(given, "other_inputs")
    try:
        return one.compare(one.changed(**changes))
    except ValueError as error:
        raise ValueError(f"other_{error}") from None


DATA = typer.Argument(metavar="FILE", help="CSV with units in its headings, e.g. load [N]")
DATA_FILE = {"file": (Annotated[str, DATA], Parameter.empty)}


@_question("compare-data", DATA_FILE | SOME | _options(ESTIMATES) | PRODUCTS | COMMON)
def _compare_data(given):
    from thirdbody.measured.comparison import compare
    from thirdbody.measured.estimates import Assumed

    found = compare(
        given["file"],
        parameters=_inputs(given, "inputs"),
        assumed=Assumed(**_known(given, vars(Assumed()))),
        **_known(
            given, [*CONDITION_TEXTS, "speed_m_per_s", "oil_density_kg_per_m3", "ball_radius_mm"]
        ),
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
    conditions = unused | _known(given, CONDITION_TEXTS)
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


# messages of typer, and their form in the library: the option, its value, what is allowed
MESSAGES = {
    r"Invalid value for '(\S+)': (is .*)": r"\1 \2",
    r"Missing (?:option|argument) '(\S+)'.": r"\1 is missing",
    r"Option '(\S+)' requires an argument\.": r"\1 has no value",
    r"Missing command.": f"QUESTION is missing; allowed: {', '.join(QUESTIONS)}",
    r"No such command '(.*?)'\..*": rf"QUESTION is '\1'; allowed: {', '.join(QUESTIONS)}",
    r"No such option: (\S+)": r"there is no option \1",
    r"\b(?:between|low to high|between_N) is": "--from or --to is",
}


def main(arguments: Sequence[str] | None = None) -> int:
    """Answer the question of a command line, by default ``sys.argv``; returns the exit code."""
    arguments = sys.argv[1:] if arguments is None else list(arguments)
    name = " ".join(["thirdbody", *(each for each in arguments[:1] if each in QUESTIONS)])
    printed = io.StringIO()  # of --help and --version
    refusal = None
    with warnings.catch_warnings(record=True) as caught, redirect_stdout(printed):
        warnings.simplefilter("ignore")
        warnings.simplefilter("default", UserWarning)  # other warnings are for developers
        try:
            asked = questions(arguments, prog_name="thirdbody", standalone_mode=False)
        except typer.TyperException as error:
            refusal = error.format_message()
        except (ValueError, OSError, ModuleNotFoundError) as error:
            refusal = str(error)
    for message in dict.fromkeys(str(each.message) for each in caught):
        _tell(name, f"warning: {_plain(message)}")
    if refusal is not None:
        _tell(name, _plain(refusal))
        return BAD_INPUT
    if asked == STOPPED:
        _tell(name, "stopped; run the same command again to start over")
    if isinstance(asked, int):
        return _print(name, printed.getvalue()) or asked
    answer, as_json = asked
    text = str(answer)
    if as_json:
        text = json.dumps(answer.as_dict())
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
