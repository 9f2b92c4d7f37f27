"""The sub-commands: their options, and the calls that answer them."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping
from inspect import Parameter, Signature, signature
from typing import Annotated, Any

import typer

from thirdbody.units import ENGINEERING, SEARCHED

REGIME, MODE = "lubrication_regime", "contact_mode"
SURFACE, LAYER = "--roughness-nm 300", "--particle-density-per-m2 1e11"
PARTICLES = f"--particle-diameter-nm 500 {SURFACE} {LAYER}"
_OPTIONS = {
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
EXAMPLES = {name: f"thirdbody {name} {options}" for name, options in _OPTIONS.items()}


def _number(given: Any) -> float:
    text = str(given)  # also called with defaults, which are numbers
    try:
        return int(text) if text.isdecimal() else float(text)
    except ValueError:
        raise typer.BadParameter(f"is {text!r}; allowed: a number, without unit") from None


def _option(name: str, text: str, kind: Any = float) -> Any:
    """The type of the argument for the option --``name``."""
    return Annotated[kind, typer.Option(f"--{name}", parser=_number, metavar="NUMBER", help=text)]


def _optional(texts: Mapping[str, str]) -> dict[str, tuple]:
    """Optional numbers, by the names of their arguments."""
    return {
        key: (_option(key.replace("_", "-"), text, float | None), None)
        for key, text in texts.items()
    }


CONDITIONS = {
    "load_N": "normal load [N]",
    "viscosity_cSt": "kinematic viscosity of the lubricant, 0 if dry [cSt]",
    "particle_diameter_nm": "mean particle diameter x_a as in the paper, 0 if none [nm]",
    "roughness_nm": "equivalent root mean square roughness [nm]",
    "particle_density_per_m2": "particles per area, 0 if none [m-2]",
}
# types and defaults of options, by the names of their arguments
EACH = {
    key: (_option(key.replace("_", "-"), text), Parameter.empty) for key, text in CONDITIONS.items()
}
SOME = _optional(CONDITIONS)
OTHER = _optional({f"other_{key}": f"second interface: {text}" for key, text in CONDITIONS.items()})
BEARING = _optional(
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
SPEED = _optional({"speed_m_per_s": "speed of the inputs [m/s], if the data have speeds"})
ESTIMATES = _optional(
    {
        "boundary_friction": "friction of solids [1], by default 0.12",
        "film_friction": "friction of the film [1], by default 0.03",
        "resistivity_ohm_m": "of both bodies [ohm m], by default 2.2e-7",
    }
)
First = _option("from", "first value, in the unit of its option")
Last = _option("to", "last value, in the unit of its option")
File = Annotated[str | None, typer.Option(metavar="FILE")]
Inputs = Annotated[
    str | None,
    typer.Option(metavar="FILE", help="inputs from bearing --write; default: calibrated"),
]
Json = Annotated[bool, typer.Option("--json", help="print the answer as JSON")]
COMMON = {"inputs": (Inputs, None), "json": (Json, False)}

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
    """Add a function as a sub-command with ``options`` and the options of the function."""

    def add(answer: Callable) -> None:
        def asked(**given: Any) -> tuple[Any, bool]:
            return answer(**given), given["json"]

        own = signature(answer, eval_str=True).parameters
        every = options | {
            key: (own[key].annotation, own[key].default) for key in own if key != "given"
        }
        asked.__doc__ = answer.__doc__
        asked.__signature__ = Signature(
            Parameter(key, Parameter.KEYWORD_ONLY, annotation=kind, default=default)
            for key, (kind, default) in every.items()
        )
        epilog = f"\b\nExample:\n  {example or EXAMPLES[name]}"  # \b: no wrapping
        questions.command(name, epilog=epilog)(asked)

    return add


@_question("state", EACH | COMMON)
def _state(**given):
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
    least, most = SEARCHED[along]

    def changes(first: First = least, last: Last = most, **given):
        return _interface(given).transitions(along, flags, _increasing(first, last))

    changes.__doc__ = text
    _question(name, _without(along))(changes)


for name, question in CHANGES.items():
    _add_changes(name, *question)


@_question("turning-point", _without("load"))
def _turning_point(
    first: _option("from-N", "first load [N]") = 0.04,  # Table 2
    last: _option("to-N", "last load [N]") = 80.0,
    **given,
):
    """At which load the contact area turns (TPCA), and for which sizes."""
    return _interface(given).turning_point(_increasing(first, last, "-N"))


MATERIALS = "steel, silicon-nitride, alumina, or GPa,1,GPa: modulus, Poisson's ratio and hardness"


def _material(text: str) -> Any:
    """A material: a name, or modulus [GPa], Poisson's ratio and hardness [GPa]."""
    from thirdbody.answers.bearing import MATERIALS as KNOWN
    from thirdbody.answers.bearing import USUAL_MATERIAL, Material
    from thirdbody.conditions.checks import warn_outside, without_warnings

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


Body = Annotated[
    str | None,
    typer.Option(parser=_material, metavar="MATERIAL", help=f"{MATERIALS}, e.g. 205,0.29,5"),
]


@_question("bearing", BEARING | {"json": COMMON["json"]})
def _bearing(
    ball: Body = None, flat: Body = None, particle: Body = None, write: File = None, **given
):
    """Which inputs follow from another ball, speed, oil or material."""
    from thirdbody.answers.bearing import bearing, derived
    from thirdbody.configuration.inputs import load_parameters

    numbers = {key: given[key] for key in BEARING}
    inputs = bearing(load_parameters(), ball=ball, flat=flat, particle=particle, **numbers)
    if write is not None:
        import yaml

        _write(write, yaml.safe_dump(inputs.as_dict(), sort_keys=False))
    return derived(inputs, given["viscosity_cSt"])


@_question("curve", SOME | COMMON)
def _curve(
    along: Annotated[str, typer.Option(metavar="AXIS", help=", ".join(ENGINEERING))],
    first: First,
    last: Last,
    count: _option("count", "points") = 60,
    csv: File = None,
    plot: File = None,
    json: Json = False,
    **given,
):
    """All variables along one axis, as CSV and as a plot."""
    if along not in ENGINEERING:
        raise ValueError(f"--along is {along!r}; allowed: {', '.join(ENGINEERING)}")
    for name, key in ENGINEERING.items():
        if name != along and given[key] is None:
            raise ValueError(f"{key} is missing; allowed: a number")
    found = _interface(given).curve(along, *_increasing(first, last), count)
    if csv is not None:
        _write(csv, found.as_csv())
    if plot is not None:
        from thirdbody.figures.plot import plot_curve

        _save(plot_curve(found), plot)
    written = " and ".join(filter(None, [csv, plot]))
    return f"{written} written" if written and not json else found


@_question("compare", EACH | OTHER | COMMON)
def _compare(other_inputs: Inputs = None, **given):
    """Compare two interfaces; the second differs by --other-..."""
    one = _interface(given)
    changes = {key.removeprefix("other_"): value for key, value in _known(given, OTHER).items()}
    if other_inputs is not None:
        changes["parameters"] = _inputs(other_inputs, "--other-inputs")
    return one.compare(one.changed(**changes))


MEASURED = f"thirdbody compare-data measured.csv --viscosity-cSt 90 {PARTICLES} --plot compared.svg"


@_question("compare-data", SOME | SPEED | ESTIMATES | COMMON, MEASURED)
def _compare_data(
    file: Annotated[
        str, typer.Argument(metavar="FILE", help="CSV with units in its headings, e.g. load [N]")
    ],
    csv: File = None,
    plot: File = None,
    **given,
):
    """Compare your measurements with the model: residuals, ensemble ranges, a figure."""
    from thirdbody.measured.comparison import compare
    from thirdbody.measured.estimates import Assumed

    found = compare(
        file,
        parameters=_inputs(given["inputs"], "--inputs"),
        assumed=Assumed(**_known(given, ESTIMATES)),
        **_known(given, SOME | SPEED),
    )
    if csv is not None:
        _write(csv, found.to_dataframe().to_csv(index=False, float_format="%.10g"))
    if plot is not None:
        _save(found.plot(), plot)
    return found.answer


def _known(given: Mapping[str, Any], names: Iterable[str]) -> dict[str, Any]:
    """The arguments with these names that are given."""
    return {name: given[name] for name in names if given.get(name) is not None}


def _increasing(first: float, last: float, unit: str = "") -> tuple[float, float]:
    if not 0.0 < first < last:
        allowed = f"positive numbers less than --to{unit}, {last:g}"
        raise ValueError(f"--from{unit} is {first:g}; allowed: {allowed}")
    return first, last


def _interface(given: Mapping[str, Any]) -> Any:
    """The interface from the arguments of a sub-command; an absent condition is not used."""
    from thirdbody.answers.interface import Interface

    unused = {key: SEARCHED[name][0] for name, key in ENGINEERING.items()}
    conditions = unused | _known(given, ENGINEERING.values())
    return Interface(**conditions, parameters=_inputs(given["inputs"], "--inputs"))


def _inputs(path: str | None, name: str) -> Any:
    from thirdbody.configuration.inputs import load_parameters

    try:
        return load_parameters(path)
    except (ValueError, OSError) as error:
        raise ValueError(f"{name} is {path!r}; {error}") from None


def _write(path: str, text: str) -> None:
    from thirdbody.data.files import atomic_write

    with atomic_write(path) as part:
        part.write_text(text, encoding="utf-8")


def _save(figure: Any, path: str) -> None:
    from thirdbody.figures.drawing import save_figure

    save_figure(figure, path)
