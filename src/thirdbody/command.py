"""The command ``thirdbody``: each question is a sub-command, a function of this module.

The rest of the library is imported only to answer a question, so that ``thirdbody --help`` is quick.
"""

import json
import sys
import warnings
from collections.abc import Mapping
from pathlib import Path
from typing import Annotated, Any

import typer

from thirdbody.variables import AXES, CONDITIONS

ANSWERED, NONE_FOUND, BAD_INPUT = 0, 1, 2  # exit codes
MATERIALS = (
    "steel, silicon-nitride, alumina, or modulus [GPa], Poisson's ratio, hardness [GPa]: 205,0.29,5"
)


def _option(text: str, *names: str, metavar: str = "NUMBER") -> Any:
    """An option, called as its argument if it is given no names."""
    return typer.Option(*names, help=text, metavar=metavar)


def _condition(name: str, text: str, before: str = "") -> Any:
    """The option of a condition, with its name and unit in the table of variables."""
    axis = CONDITIONS[name]
    return _option(f"{text} [{axis.alias_unit}]", f"--{before}{axis.alias.replace('_', '-')}")


def _other(name: str) -> Any:
    return _condition(name, "of the second interface", "other-")


Load = Annotated[float | None, _condition("load", "normal load")]
Viscosity = Annotated[
    float | None, _condition("viscosity", "kinematic viscosity of the oil, 0 if dry")
]
Size = Annotated[
    float | None, _condition("particle_diameter", "mean particle diameter x_a, 0 if none")
]
Roughness = Annotated[
    float | None, _condition("roughness", "equivalent rms roughness, sqrt(Rq_1^2 + Rq_2^2)")
]
Density = Annotated[float | None, _condition("particle_density", "particles per area, 0 if none")]
Speed = Annotated[
    float | None, _condition("speed", "entrainment speed; default: that of the inputs")
]
Along = Annotated[
    str, _option(f"condition that varies: {', '.join(CONDITIONS)}", metavar="CONDITION")
]
FIRST = _option("first value, in the unit of its option", "--from")
LAST = _option("last value, in the unit of its option", "--to")
Inputs = Annotated[
    str | None, _option("inputs from bearing --write; default: calibrated", metavar="FILE")
]
Csv = Annotated[str | None, _option("table to write, - for standard output", metavar="FILE")]
Plot = Annotated[str | None, _option("figure to write", metavar="FILE")]
Json = Annotated[bool, typer.Option("--json", help="print the answer as JSON")]

app = typer.Typer(
    add_completion=False,
    rich_markup_mode=None,
    no_args_is_help=True,
    pretty_exceptions_enable=False,
    context_settings={"help_option_names": ["-h", "--help"]},
)


def _version(is_given: bool) -> None:
    if is_given:
        import thirdbody

        print(f"thirdbody {thirdbody.__version__}")
        raise typer.Exit()


@app.callback(epilog="Exit codes: 0 answered, 1 no such value, 2 bad input.")
def _thirdbody(
    version: Annotated[
        bool, typer.Option("--version", callback=_version, is_eager=True, help="print the version")
    ] = False,
) -> None:
    """Contact of rough surfaces with hard particles and an oil film between them."""


def _example(*lines: str) -> str:
    """The epilog with an example."""
    return "\b\nExample:\n  " + " \\\n    ".join(lines)  # \b: no wrapping


@app.command(
    epilog=_example(
        "thirdbody state --load-N 10 --viscosity-cSt 90",
        "--particle-diameter-nm 500 --roughness-nm 300",
        "--particle-density-per-m2 1e11",
    )
)
def state(
    load: Load = None,
    viscosity: Viscosity = None,
    particle_diameter: Size = None,
    roughness: Roughness = None,
    particle_density: Density = None,
    speed: Speed = None,
    inputs: Inputs = None,
    as_json: Json = False,
) -> int:
    """Load sharing, contact area, regime and mode."""
    from thirdbody import answers

    conditions = _conditions(locals())
    return _show(answers.state(_parameters(inputs), conditions), as_json)


@app.command(
    epilog=_example(
        "thirdbody transitions --along viscosity --load-N 10",
        "--particle-diameter-nm 500 --roughness-nm 300",
        "--particle-density-per-m2 1e11",
    )
)
def transitions(
    along: Along = "load",
    first: Annotated[float | None, FIRST] = None,
    last: Annotated[float | None, LAST] = None,
    load: Load = None,
    viscosity: Viscosity = None,
    particle_diameter: Size = None,
    roughness: Roughness = None,
    particle_density: Density = None,
    speed: Speed = None,
    inputs: Inputs = None,
    as_json: Json = False,
) -> int:
    """Where regime or mode change along a condition."""
    from thirdbody import answers

    conditions = _conditions(locals(), without=along)
    axis = CONDITIONS[along]
    ends = [end if given is None else given for end, given in zip(axis.searched, (first, last))]
    between = None if first is last is None else (ends[0], ends[1])
    table = answers.changes_along(_parameters(inputs), conditions, axis.alias, between)
    return _show(table, as_json)


@app.command(
    epilog=_example(
        "thirdbody turning-point --viscosity-cSt 0",
        "--particle-diameter-nm 300 --roughness-nm 300",
        "--particle-density-per-m2 1e11",
    )
)
def turning_point(
    first: Annotated[float, FIRST] = 0.04,
    last: Annotated[float, LAST] = 80.0,
    viscosity: Viscosity = None,
    particle_diameter: Size = None,
    roughness: Roughness = None,
    particle_density: Density = None,
    speed: Speed = None,
    inputs: Inputs = None,
    as_json: Json = False,
) -> int:
    """The load at which the contact area turns (TPCA)."""
    from thirdbody import answers

    conditions = _conditions(locals(), without="load")
    return _show(answers.turning_load(_parameters(inputs), conditions, (first, last)), as_json)


@app.command(
    epilog=_example(
        "thirdbody curve --along viscosity --from 10 --to 150 --load-N 10",
        "--particle-diameter-nm 500 --roughness-nm 300",
        "--particle-density-per-m2 1e11 --csv curve.csv --plot curve.svg",
    )
)
def curve(
    along: Along,
    first: Annotated[float, FIRST],
    last: Annotated[float, LAST],
    count: Annotated[int, _option("number of points")] = 60,
    load: Load = None,
    viscosity: Viscosity = None,
    particle_diameter: Size = None,
    roughness: Roughness = None,
    particle_density: Density = None,
    speed: Speed = None,
    csv: Csv = None,
    plot: Plot = None,
    inputs: Inputs = None,
) -> int:
    """All variables along one condition, as CSV or figure."""
    from thirdbody import answers

    conditions = _conditions(locals(), without=along)
    _check_files(csv, plot)
    alias = CONDITIONS[along].alias
    table = answers.curve(_parameters(inputs), conditions, alias, (first, last), count)
    if plot is not None:
        from thirdbody.plotting.plot import plot_curve

        _save(plot_curve(table, alias), plot)
    _write_csv(table, csv or "-")
    return ANSWERED


@app.command(
    epilog=_example(
        "thirdbody compare --load-N 10 --viscosity-cSt 90",
        "--particle-diameter-nm 500 --roughness-nm 300",
        "--particle-density-per-m2 1e11 --other-viscosity-cSt 120",
    )
)
def compare(
    load: Load = None,
    viscosity: Viscosity = None,
    particle_diameter: Size = None,
    roughness: Roughness = None,
    particle_density: Density = None,
    speed: Speed = None,
    other_load: Annotated[float | None, _other("load")] = None,
    other_viscosity: Annotated[float | None, _other("viscosity")] = None,
    other_particle_diameter: Annotated[float | None, _other("particle_diameter")] = None,
    other_roughness: Annotated[float | None, _other("roughness")] = None,
    other_particle_density: Annotated[float | None, _other("particle_density")] = None,
    other_speed: Annotated[float | None, _other("speed")] = None,
    other_inputs: Annotated[
        str | None, _option("inputs of the second interface", metavar="FILE")
    ] = None,
    inputs: Inputs = None,
    as_json: Json = False,
) -> int:
    """Two interfaces; the second differs by --other-..."""
    from thirdbody import answers

    given = locals()
    conditions = _conditions(given)
    changes = _by_alias({name: given[f"other_{name}"] for name in CONDITIONS})
    if not changes and other_inputs is None:
        raise ValueError(
            "--other-... is missing; allowed: one or more, as --other-viscosity-cSt 120"
        )
    parameters = _parameters(inputs)
    other = parameters if other_inputs is None else _parameters(other_inputs)
    return _show(
        answers.compare_interfaces(parameters, conditions, other, conditions | changes), as_json
    )


@app.command(
    epilog=_example(
        "thirdbody bearing --ball silicon-nitride --ball-radius-mm 5",
        "--speed-m-per-s 2 --oil-density-kg-per-m3 850",
        "--pressure-viscosity-per-GPa 20 --write bearing.yaml",
    )
)
def bearing(
    ball_radius_mm: Annotated[float | None, _option("radius R_x [mm]")] = None,
    speed_m_per_s: Annotated[float | None, _option("entrainment speed (u_1 + u_2)/2 [m/s]")] = None,
    oil_density_kg_per_m3: Annotated[float | None, _option("rho, with the speed [kg m-3]")] = None,
    pressure_viscosity_per_GPa: Annotated[
        float | None, _option("alpha [GPa-1]", "--pressure-viscosity-per-GPa")
    ] = None,
    apparent_area_mm2: Annotated[float | None, _option("A_n, nominal area of loads [mm2]")] = None,
    ellipticity: Annotated[float | None, _option("kappa, 1 for a ball [1]")] = None,
    ball: Annotated[str | None, _option(f"surface 1: {MATERIALS}", metavar="MATERIAL")] = None,
    flat: Annotated[str | None, _option("surface 2", metavar="MATERIAL")] = None,
    particle: Annotated[str | None, _option("at least as hard as both", metavar="MATERIAL")] = None,
    inputs: Inputs = None,
    write: Annotated[str | None, _option("file of inputs to write", metavar="FILE")] = None,
    as_json: Json = False,
) -> int:
    """Inputs for another ball, speed, oil or material."""
    from thirdbody import bearings

    given = locals()
    changes = {name: given[name] for name in bearings.USUAL_BEARING}
    changes |= {name: _material(given[name]) for name in bearings.BODIES}
    parameters = bearings.bearing(_parameters(inputs), **changes)
    if write is not None:
        import yaml

        _write(yaml.safe_dump(parameters.known(), sort_keys=False), write)
    table = bearings.derived_inputs(parameters)
    if as_json:
        print(table.to_json(orient="index"))
    else:
        print(table.to_string(float_format="{:.6g}".format), *table.attrs["notes"], sep="\n")
    return ANSWERED


def _conditions(arguments: Mapping[str, Any], without: str | None = None) -> dict[str, float]:
    """The conditions among the arguments, all but one; ``ValueError`` names all that are missing.
    The speed may be missing."""
    if without is not None:
        if without not in CONDITIONS:
            raise ValueError(f"--along is {without!r}; allowed: {', '.join(CONDITIONS)}")
        if arguments.get(without) is not None:
            option = f"--{CONDITIONS[without].alias.replace('_', '-')}"
            raise ValueError(f"{option} is given with --along {without}; allowed: --from and --to")
    missing = [name for name in AXES if name != without and arguments.get(name) is None]
    if missing:
        options = ", ".join(f"--{AXES[name].alias.replace('_', '-')}" for name in missing)
        raise ValueError(f"missing: {options}")
    return _by_alias(arguments)


def _by_alias(arguments: Mapping[str, Any]) -> dict[str, float]:
    """The conditions that are given among the arguments, by their aliases."""
    return {
        axis.alias: arguments[name]
        for name, axis in CONDITIONS.items()
        if arguments.get(name) is not None
    }


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
    """Print an answer; the exit code."""
    from thirdbody.answers import table_text

    if as_json:
        rows = json.loads(table.to_json(orient="records"))
        print(
            json.dumps({"title": table.attrs["title"], "rows": rows, "notes": table.attrs["notes"]})
        )
    else:
        print(table_text(table))
    return ANSWERED if table.attrs["found"] else NONE_FOUND


def _check_files(csv: str | None, plot: str | None) -> None:
    """Raise ``ValueError`` if a figure would replace the table."""
    if csv is not None and plot is not None and Path(csv).resolve() == Path(plot).resolve():
        raise ValueError(f"--csv and --plot are both {csv}; allowed: two files")


def _write_csv(table: Any, path: str) -> None:
    _write(table.to_csv(index=False, float_format="%.10g"), path)


def _write(text: str, path: str) -> None:
    """Write a text to a file, or to standard output for ``-``."""
    if path == "-":
        print(text, end="")
        return
    from thirdbody.files import atomic_write

    with atomic_write(path) as (part,):
        part.write_text(text, encoding="utf-8")


def _save(figure: Any, path: str) -> None:
    from thirdbody.plotting.drawing import save_figure

    save_figure(figure, path)


def main(arguments: list[str] | None = None) -> int:
    """Answer the question of a command line, by default ``sys.argv``; returns the exit code."""
    with warnings.catch_warnings():
        warnings.simplefilter("default", UserWarning)
        warnings.showwarning = lambda message, *_: print(f"warning: {message}", file=sys.stderr)
        try:
            code = app(arguments, prog_name="thirdbody", standalone_mode=False)
        except typer.TyperException as error:
            error.show()  # type: ignore[attr-defined]  # all that typer raises have it
            return BAD_INPUT
        except (ValueError, TypeError, OSError, ImportError) as error:
            print(f"error: {error}", file=sys.stderr)
            return BAD_INPUT
    return code or ANSWERED
