"""The command ``thirdbody``: every question is a sub-command, with a function in this module.

Functions import the rest of the library when they answer, so that ``thirdbody --help`` is quick.
"""

import json
import math
import sys
import warnings
from argparse import ArgumentParser, RawDescriptionHelpFormatter
from collections.abc import Callable, Mapping
from typing import Any, NoReturn

from thirdbody.variables import AXES, CONDITIONS

ANSWERED, NONE_FOUND, BAD_INPUT = 0, 1, 2  # exit codes
READ, WRITTEN = ("inputs", "other_inputs"), ("csv", "plot", "write")  # options with a file


def state(inputs: str | None, as_json: bool, verbose: bool, **interface: float | None) -> int:
    """Load sharing, contact area, regime and mode."""
    from thirdbody import answers

    table = answers.state(_parameters(inputs), _conditions(interface), verbose)
    return _show(table, as_json)


def transitions(
    along: str,
    first: float | None,
    last: float | None,
    inputs: str | None,
    as_json: bool,
    **interface: float | None,
) -> int:
    """Where regime or mode change along a condition."""
    from thirdbody import answers

    conditions = _conditions(interface, without=along)
    axis = CONDITIONS[along]
    ends = [end if given is None else given for end, given in zip(axis.searched, (first, last))]
    between = None if first is last is None else (ends[0], ends[1])
    table = answers.changes_along(_parameters(inputs), conditions, axis.alias, between)
    return _show(table, as_json)


def turning_point(
    first: float, last: float, inputs: str | None, as_json: bool, **interface: float | None
) -> int:
    """The load at which the contact area turns (TPCA)."""
    from thirdbody import answers

    conditions = _conditions(interface, without="load")
    return _show(answers.turning_load(_parameters(inputs), conditions, (first, last)), as_json)


def curve(
    along: str,
    first: float,
    last: float,
    count: int,
    csv: str | None,
    plot: str | None,
    inputs: str | None,
    **interface: float | None,
) -> int:
    """All variables along one condition, as CSV or figure."""
    from thirdbody import answers

    conditions = _conditions(interface, without=along)
    alias = CONDITIONS[along].alias
    for option, end in (("--from", first), ("--to", last)):
        if not 0.0 < end < math.inf:  # points are evenly spaced in the logarithm
            raise ValueError(f"{option} is {end:g}; allowed: a positive number")
    table = answers.curve(_parameters(inputs), conditions, alias, (first, last), count)
    if plot is not None:
        from thirdbody.plotting.drawing import save_figure
        from thirdbody.plotting.plot import plot_curve

        save_figure(plot_curve(table, alias, conditions), plot)
    if csv is not None or plot is None:
        _write(table.to_csv(index=False, float_format="%.10g"), csv or "-")
    for note in table.attrs["notes"]:
        _tell("note", note)
    return ANSWERED


def compare(
    other_inputs: str | None, inputs: str | None, as_json: bool, **interfaces: float | None
) -> int:
    """Two interfaces; the second differs by --other-..."""
    from thirdbody import answers

    conditions = _conditions(interfaces)
    changes = _by_alias({name: interfaces[f"other_{name}"] for name in CONDITIONS})
    if not changes and other_inputs is None:
        raise ValueError(
            "--other-... is missing; allowed: one or more, as --other-viscosity-cSt 120"
        )
    parameters = _parameters(inputs)
    other = parameters if other_inputs is None else _parameters(other_inputs)
    return _show(
        answers.compare_interfaces(parameters, conditions, other, conditions | changes), as_json
    )


def bearing(inputs: str | None, write: str | None, as_json: bool, **changes: Any) -> int:
    """Inputs for another ball, speed, oil or material."""
    from thirdbody import bearings

    changes |= {name: _material(changes[name]) for name in bearings.BODIES}
    parameters = bearings.bearing(_parameters(inputs), **changes)
    if write is not None:
        import yaml

        _write(yaml.safe_dump(parameters.known(), sort_keys=False), write)
    table = bearings.derived_inputs(parameters)
    if as_json:
        print(table.to_json(orient="index"))
    else:
        from thirdbody.answers import aligned

        rows = [
            [row.Index, f"{row.value:.4g}", row.unit, row.formula] for row in table.itertuples()
        ]
        print(*aligned([["input", "value", "unit", "formula"], *rows]), sep="\n")
        print("", *table.attrs["notes"], sep="\n  ")
    return ANSWERED


# ---- shared by the questions


def _conditions(
    interface: Mapping[str, float | None], without: str | None = None
) -> dict[str, float]:
    """The conditions by alias, except the condition ``without``; the speed may be missing.

    Raises ``ValueError`` with all options that are missing.
    """
    if without is not None and interface.get(without) is not None:
        raise ValueError(
            f"{_flag(without)} is given with --along {without}; allowed: --from and --to"
        )
    missing = [_flag(name) for name in AXES if name != without and interface[name] is None]
    if missing:
        raise ValueError(f"missing: {', '.join(missing)}")
    return _by_alias(interface)


def _by_alias(interface: Mapping[str, float | None]) -> dict[str, float]:
    """The conditions that have a value, by alias."""
    return {
        axis.alias: value
        for name, axis in CONDITIONS.items()
        if (value := interface.get(name)) is not None
    }


def _check_files(options: Mapping[str, Any]) -> None:
    """Raise ``ValueError`` for a file to write that is read, or is written twice."""
    written = [option for option in WRITTEN if options.get(option) not in (None, "-")]
    if not written:
        return
    from thirdbody.files import is_same_file
    from thirdbody.inputs import CALIBRATED_FILE

    taken = [("the library", CALIBRATED_FILE)]
    taken += [(_option(option), options[option]) for option in READ if options.get(option)]
    for option in written:
        for user, path in taken:
            if is_same_file(options[option], path):
                file = f"{_option(option)} is {options[option]}, the file of {user}"
                raise ValueError(f"{file}; allowed: another file")
        taken.append((_option(option), options[option]))


def _option(name: str) -> str:
    return f"--{name.replace('_', '-')}"


def _parameters(path: str | None) -> Any:
    from thirdbody.inputs import load_parameters

    return load_parameters(path)


def _material(text: str | None) -> Any:
    """A material: a name, or modulus [GPa], Poisson's ratio and hardness [GPa]."""
    from thirdbody.ensembles import Material

    if text is None or "," not in text:
        return text
    return Material(*map(float, text.split(",")))


def _show(table: Any, as_json: bool) -> int:
    """Print an answer, and return the exit code."""
    from thirdbody.answers import table_text

    if as_json:
        rows = json.loads(table.to_json(orient="records"))
        print(
            json.dumps({"title": table.attrs["title"], "rows": rows, "notes": table.attrs["notes"]})
        )
    else:
        print(table_text(table))
    return ANSWERED if table.attrs["found"] else NONE_FOUND


def _tell(kind: str, message: object) -> None:
    """Print a message on standard error, as wide as an answer."""
    from thirdbody.notes import wrapped

    for line in f"{kind}: {message}".splitlines():
        print(wrapped(line, others="  "), file=sys.stderr)


def _write(text: str, path: str) -> None:
    """Write a text to a file, or to standard output for ``-``."""
    if path == "-":
        print(text, end="")
        return
    from thirdbody.files import atomic_write

    with atomic_write(path) as (part,):
        part.write_text(text, encoding="utf-8")


# ---- options of the questions

NUMBER: dict[str, Any] = {"type": float, "metavar": "NUMBER"}
FILE: dict[str, Any] = {"metavar": "FILE"}
TEXTS = {
    "load": "normal load",
    "viscosity": "kinematic viscosity of the oil, 0 if dry",
    "particle_diameter": f"x_a: {AXES['particle_diameter'].label}",
    "roughness": "equivalent rms roughness, sqrt(Rq_1^2 + Rq_2^2)",
    "particle_density": "particles per area, 0 if none",
    "speed": "entrainment speed; default: that of the inputs",
}
MATERIALS = (
    "steel, silicon-nitride, alumina, or modulus [GPa], Poisson's ratio, hardness [GPa]: 205,0.29,5"
)
LAYER = "--particle-diameter-nm 500 --roughness-nm 300", "--particle-density-per-m2 1e11"


def _flag(name: str) -> str:
    """The option of a condition, with its unit."""
    return _option(CONDITIONS[name].alias)


class _Parser(ArgumentParser):
    """A parser whose errors are printed as all others."""

    def error(self, message: str) -> NoReturn:
        self.print_usage(sys.stderr)
        _tell("error", message)
        raise SystemExit(BAD_INPUT)


def _options(title: str) -> tuple[_Parser, Callable]:
    """A parser of options that several questions share, and its method to add an option."""
    shared = _Parser(add_help=False)
    return shared, shared.add_argument_group(title).add_argument


def _add_ends(
    question: ArgumentParser, first: float | None = None, last: float | None = None, **more: Any
) -> None:
    """Add the options ``--from`` and ``--to`` to a question."""
    text = "value, in the unit of its option"
    text += "" if first is None else "; default: %(default)s"
    question.add_argument(
        "--from", dest="first", default=first, help=f"first {text}", **NUMBER, **more
    )
    question.add_argument("--to", dest="last", default=last, help=f"last {text}", **NUMBER, **more)


def _parser() -> ArgumentParser:
    """The parser of all questions."""
    parser = _Parser(
        "thirdbody",
        description="Contact of rough surfaces with hard particles and an oil film between them.",
        epilog="Exit codes: 0 answered, 1 no such value, 2 bad input.",
        allow_abbrev=False,
    )
    parser.add_argument("--version", action="store_true", help="print the version")
    questions = parser.add_subparsers(title="questions", metavar="QUESTION")

    def ask(answer: Callable[..., int], *example: str, options: list[_Parser]) -> ArgumentParser:
        """Add the sub-command that calls the function ``answer``."""
        name = answer.__name__.replace("_", "-")
        lines = " \\\n    ".join(example)
        question = questions.add_parser(
            name,
            usage=f"thirdbody {name} [options]",
            help=answer.__doc__,
            description=answer.__doc__,
            epilog=f"example:\n  thirdbody {name} {lines}",
            formatter_class=RawDescriptionHelpFormatter,
            allow_abbrev=False,
            parents=options,
        )
        question.set_defaults(answer=answer)
        return question

    interface = []
    for name, text in TEXTS.items():
        condition, add = _options("interface")
        interface.append(condition)
        add(_flag(name), dest=name, help=f"{text} [{CONDITIONS[name].alias_unit}]", **NUMBER)
    other, add = _options("second interface, where it differs")
    for name in TEXTS:
        add(f"--other-{_flag(name)[2:]}", dest=f"other_{name}", **NUMBER)
    add("--other-inputs", help="inputs from bearing --write", **FILE)
    inputs, add = _options("inputs")
    add("--inputs", help="inputs from bearing --write; default: calibrated", **FILE)
    table, add = _options("answer")
    add("--json", dest="as_json", action="store_true", help="print the answer as JSON")
    along: dict[str, Any] = {"metavar": "CONDITION", "choices": CONDITIONS}
    along |= {"help": f"condition that varies: {', '.join(CONDITIONS)}"}

    _, *without_load = interface
    options = [*interface, inputs, table]
    question = ask(state, "--load-N 10 --viscosity-cSt 90", *LAYER, options=options)
    question.add_argument(
        "--verbose", action="store_true", help="also A_n and the nominal and Hertz pressures"
    )
    question = ask(transitions, "--along viscosity --load-N 10", *LAYER, options=options)
    question.add_argument("--along", default="load", **along)
    _add_ends(question)
    example = "--particle-diameter-nm 300 --roughness-nm 300", LAYER[1]
    question = ask(
        turning_point, "--viscosity-cSt 0", *example, options=[*without_load, inputs, table]
    )
    _add_ends(question, *AXES["load"].paper)
    question = ask(
        curve,
        "--along viscosity --from 10 --to 150 --load-N 10",
        LAYER[0],
        f"{LAYER[1]} --csv curve.csv --plot curve.svg",
        options=[*interface, inputs],
    )
    question.add_argument("--along", required=True, **along)
    _add_ends(question, required=True)
    question.add_argument(
        "--count",
        type=int,
        default=60,
        metavar="NUMBER",
        help="number of points, evenly spaced in the logarithm; default: 60",
    )
    question.add_argument(
        "--csv", help="table to write, - for standard output, the default without --plot", **FILE
    )
    question.add_argument("--plot", help="figure to write", **FILE)
    ask(
        compare,
        "--load-N 10 --viscosity-cSt 90",
        LAYER[0],
        f"{LAYER[1]} --other-viscosity-cSt 120",
        options=[*interface, other, inputs, table],
    )
    question = ask(
        bearing,
        "--ball silicon-nitride --ball-radius-mm 5",
        "--speed-m-per-s 2 --oil-density-kg-per-m3 850",
        "--pressure-viscosity-per-GPa 20 --write bearing.yaml",
        options=[inputs, table],
    )
    for flag, text in {
        "--ball-radius-mm": "radius R_x [mm]",
        "--speed-m-per-s": "entrainment speed (u_1 + u_2)/2 [m/s]",
        "--oil-density-kg-per-m3": "rho, with the speed [kg m-3]",
        "--pressure-viscosity-per-GPa": "alpha [GPa-1]",
        "--apparent-area-mm2": "A_n, nominal area of loads [mm2]",
        "--ellipticity": "kappa, 1 for a ball [1]",
    }.items():
        question.add_argument(flag, help=text, **NUMBER)
    question.add_argument("--ball", metavar="MATERIAL", help=f"surface 1: {MATERIALS}")
    question.add_argument("--flat", metavar="MATERIAL", help="surface 2")
    question.add_argument("--particle", metavar="MATERIAL", help="at least as hard as both")
    question.add_argument("--write", help="file of inputs to write", **FILE)
    return parser


def main(arguments: list[str] | None = None) -> int:
    """Answer a command line, by default ``sys.argv``, and return the exit code."""
    parser = _parser()
    options = vars(parser.parse_args(arguments))
    if options.pop("version"):
        import thirdbody

        print(f"thirdbody {thirdbody.__version__}")
        return ANSWERED
    if "answer" not in options:
        parser.print_help(sys.stderr)
        return BAD_INPUT
    with warnings.catch_warnings():
        warnings.simplefilter("default", UserWarning)
        warnings.showwarning = lambda message, *_: _tell("warning", message)
        try:
            _check_files(options)
            return options.pop("answer")(**options)
        except (ValueError, TypeError, OSError, ImportError) as error:
            _tell("error", error)
            return BAD_INPUT
