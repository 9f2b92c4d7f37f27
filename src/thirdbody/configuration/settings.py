"""Reading and judging configuration: one line that names the key, its value and what is allowed."""

from __future__ import annotations

import math
from dataclasses import fields
from importlib.metadata import version
from pathlib import Path

import yaml

from thirdbody.model.parameters import Parameters


class _StrictLoader(yaml.composer.Composer, yaml.CSafeLoader):
    """YAML without duplicate keys, anchors or tags: a configuration is plain data.

    Parsed in C, which takes a quarter of the time, but composed in Python, where it can be refused.
    """

    def __init__(self, stream):
        yaml.CSafeLoader.__init__(self, stream)
        yaml.composer.Composer.__init__(self)

    def compose_node(self, parent, index):
        if self.check_event(yaml.AliasEvent):
            event = self.peek_event()
            raise yaml.composer.ComposerError(
                None, None, f"alias *{event.anchor}; allowed: plain values", event.start_mark
            )
        event = self.peek_event()
        for extra in ("tag", "anchor"):
            if getattr(event, extra, None) not in (None, "!"):
                problem = f"{extra} {getattr(event, extra)}; allowed: plain values"
                raise yaml.composer.ComposerError(None, None, problem, event.start_mark)
        return super().compose_node(parent, index)

    def construct_mapping(self, node, deep=False):
        seen = set()
        for key_node, _ in node.value:
            key = self.construct_object(key_node, deep=True)
            if not isinstance(key, str):
                raise yaml.constructor.ConstructorError(
                    None, None, f"key {key!r}; allowed: words", key_node.start_mark
                )
            if key in seen:
                raise yaml.constructor.ConstructorError(
                    None, None, f"key {key!r} stands twice", key_node.start_mark
                )
            seen.add(key)
        return super().construct_mapping(node, deep)


KINDS = {dict: "keys with values", list: "a list"}


def read_yaml(path, kind: type = dict):
    """The ``dict`` or ``list`` in a YAML file; ``ValueError`` in one line names file and place."""
    try:
        text = Path(path).read_bytes().decode("utf-8")
    except OSError as error:
        raise ValueError(f"{path}: {error.strerror}; allowed: a readable YAML file") from None
    except UnicodeDecodeError as error:
        raise ValueError(f"{path}: byte {error.start} is not UTF-8") from None
    try:
        content = yaml.load(text, _StrictLoader)
    except RecursionError:
        raise ValueError(f"{path}: nested too deeply") from None
    except (yaml.YAMLError, ValueError) as error:
        raise ValueError(f"{path}: {_one_line(error)}") from None
    if not isinstance(content, kind):
        raise ValueError(f"{path}: holds {type(content).__name__}; allowed: {KINDS[kind]}")
    return content


def _one_line(error) -> str:
    """Message of a YAML error with its place, in one line."""
    mark = getattr(error, "problem_mark", None)
    place = f"line {mark.line + 1}: " if mark else ""
    problem = getattr(error, "problem", None) or str(error)
    return " ".join(f"{place}{problem}".split())


def validate(config: dict, schema: dict) -> None:
    """Raise ``ValueError`` with one line for the first key of ``config`` that breaks ``schema``."""
    from jsonschema import Draft202012Validator

    _require_reasonable(config, "")
    errors = Draft202012Validator(schema).iter_errors(config)
    first = min(errors, key=lambda error: (len(error.absolute_path), _key(error)), default=None)
    if first is not None:
        raise ValueError(_explained(first))


def read_valid(path, schema) -> dict:
    """The mapping in a YAML file that keeps to the ``schema`` in another; ``ValueError`` as both."""
    content = read_yaml(path)
    try:
        validate(content, read_yaml(schema))
    except ValueError as error:
        raise ValueError(f"{path}: {error}") from None
    return content


LONGEST_LIST = 1000  # what the schemas allow at most


def _require_reasonable(value, key) -> None:
    """JSON Schema lets nan and infinities pass any bound, and takes for ever on a huge list."""
    if isinstance(value, dict):
        for name, item in value.items():
            _require_reasonable(item, f"{key}.{name}".lstrip("."))
    elif isinstance(value, list):
        if len(value) > LONGEST_LIST:
            raise ValueError(f"{key} holds {len(value)} values; allowed: at most {LONGEST_LIST}")
        for index, item in enumerate(value):
            _require_reasonable(item, f"{key}[{index}]")
    elif isinstance(value, float) and not math.isfinite(value):
        raise ValueError(f"{key} is {value}; allowed: finite numbers")


def _key(error) -> str:
    key = ""
    for part in error.absolute_path:
        key += f"[{part}]" if isinstance(part, int) else f".{part}"
    return key.lstrip(".")


_ALLOWED = {
    "type": lambda e: f"allowed: {_words(e.validator_value)}",
    "enum": lambda e: f"allowed: {', '.join(map(str, e.validator_value))}",
    "minimum": lambda e: f"allowed: at least {e.validator_value:g}",
    "maximum": lambda e: f"allowed: at most {e.validator_value:g}",
    "exclusiveMinimum": lambda e: f"allowed: above {e.validator_value:g}",
    "exclusiveMaximum": lambda e: f"allowed: below {e.validator_value:g}",
    "minItems": lambda e: f"allowed: at least {e.validator_value} values",
    "maxItems": lambda e: f"allowed: at most {e.validator_value} values",
    "uniqueItems": lambda e: "allowed: no value twice",
    "minProperties": lambda e: f"allowed: at least {e.validator_value} keys",
    "minLength": lambda e: "allowed: at least one letter",
    "maxLength": lambda e: f"allowed: at most {e.validator_value} letters",
    "pattern": lambda e: f"allowed: {e.schema.get('description', e.validator_value)}",
    "oneOf": lambda e: f"allowed: {e.schema.get('description', 'one of several forms')}",
}


def _words(kinds) -> str:
    """JSON Schema's type names as a person says them."""
    named = {"object": "keys with values", "array": "a list", "string": "a word", "null": "nothing"}
    kinds = [kinds] if isinstance(kinds, str) else kinds
    return " or ".join(named.get(kind, f"a{'n' * (kind[0] in 'aeiou')} {kind}") for kind in kinds)


def _explained(error) -> str:
    """One line for a schema error."""
    key = _key(error) or "configuration"
    if error.validator == "additionalProperties":
        known = sorted(error.schema.get("properties", {}))
        patterns = error.schema.get("patternProperties", {})
        extra = next(
            name for name in error.instance if name not in known and not _matches(name, patterns)
        )
        return f"{key}: unknown key {_shown(extra)}; allowed: {', '.join(known) or ', '.join(patterns)}"
    if error.validator == "required":
        missing = next(name for name in error.validator_value if name not in error.instance)
        return f"{key}: key {missing!r} is missing; allowed: it must be given"
    allowed = _ALLOWED.get(error.validator, lambda e: e.message)(error)
    return f"{key} is {_shown(error.instance)}; {allowed}"


def _matches(name, patterns) -> bool:
    import re

    return any(re.search(pattern, name) for pattern in patterns)


def _shown(value) -> str:
    text = repr(value)
    return text if len(text) <= 60 else f"{text[:57]}..."


def read_inputs(base, *overlays) -> dict:
    """Values of the inputs: those of the file ``base`` with each key of ``overlays`` in its place.

    Raises ``ValueError`` for an unknown key, or a value out of the bounds that ``base`` states.
    """
    entries = read_yaml(base)
    _check_entries(base, entries)
    values = {name: entry["value"] for name, entry in entries.items()}
    for path in (base, *overlays):
        for name, given in _input_values(path, entries).items():
            try:
                values[name] = _checked_input(name, given, entries)
            except ValueError as error:
                raise ValueError(f"{path}: {error}") from None
    return values


def _check_entries(path, entries: dict) -> None:
    """Every input has an entry, with a value and with what is allowed; nothing else has one."""
    names = [field.name for field in fields(Parameters)]
    for name in names:
        entry = entries.get(name)
        if not isinstance(entry, dict) or "value" not in entry:
            shown = _shown(entry)
            raise ValueError(f"{path}: {name} is {shown}; allowed: an entry with a value")
        if "allowed" not in entry and "bounds" not in entry:
            raise ValueError(f"{path}: {name} has no bounds; allowed: bounds or allowed values")
        _check_allowed(path, name, entry)
    for name in entries:
        if name not in names:
            raise ValueError(f"{path}: unknown key {name!r}; allowed: {', '.join(names)}")


def _check_allowed(path, name, entry: dict) -> None:
    """An entry allows two finite numbers and all between them, or what it lists."""
    bounds = entry.get("bounds", [0, 1])
    two = isinstance(bounds, list) and len(bounds) == 2
    if not two or not all(_is_number(end) and math.isfinite(end) for end in bounds):
        shown = _shown(bounds)
        raise ValueError(f"{path}: {name}.bounds is {shown}; allowed: two finite numbers")
    listed = entry.get("allowed", [True])
    if (
        not isinstance(listed, list)
        or not listed
        or not all(type(x) in (bool, str) for x in listed)
    ):
        shown = _shown(listed)
        raise ValueError(f"{path}: {name}.allowed is {shown}; allowed: a list of words or truths")


def _is_number(value) -> bool:
    return isinstance(value, (int, float)) and not isinstance(value, bool)


def _input_values(path, entries) -> dict:
    """Values that the file ``path`` gives: plain, or entries in the layout of ``entries``."""
    content = read_yaml(path)
    content = content.get("inputs", content)  # a calibrated file says more than its inputs
    if not isinstance(content, dict):
        raise ValueError(f"{path}: inputs is {_shown(content)}; allowed: keys with values")
    return {name: _plain_value(path, name, given, entries) for name, given in content.items()}


def _plain_value(path, name, given, entries):
    """The value in an entry, which must not differ from that of ``entries`` in anything else."""
    if not isinstance(given, dict):
        return given
    known = entries.get(name, given)
    for key in given:
        if key not in (*known, "value"):
            allowed = ", ".join(known)
            raise ValueError(f"{path}: {name}: unknown key {key!r}; allowed: {allowed}")
    if given.get("unit") != known.get("unit") and "unit" in given:
        unit = _shown(given["unit"])
        raise ValueError(f"{path}: {name}.unit is {unit}; allowed: {known.get('unit')}")
    if "value" not in given:
        raise ValueError(f"{path}: {name}: key 'value' is missing; allowed: it must be given")
    return given["value"]


def _checked_input(name, value, entries):
    """``value`` of the input ``name`` in the type and bounds of its entry."""
    if name not in entries:
        raise ValueError(f"unknown key {name!r}; allowed: {', '.join(entries)}")
    entry = entries[name]
    if "allowed" in entry:
        if value not in entry["allowed"] or type(value) is not type(entry["allowed"][0]):
            allowed = ", ".join(map(str, entry["allowed"]))
            raise ValueError(f"{name} is {_shown(value)}; allowed: {allowed}")
        return value
    low, high = entry["bounds"]
    if not _is_number(value) or not low <= value <= high:
        raise ValueError(
            f"{name} is {_shown(value)}; allowed: a number from {low:g} to {high:g} {entry.get('unit', '')}"
        )
    return float(value)


CALIBRATED = {"reading": str, "objective": float, "inputs": dict, "ensemble": list}


def read_calibrated(path) -> dict:
    """A file that `snakemake calibrate` writes: a reading, its best inputs and their ensemble.

    Raises ``ValueError`` with one line for a key that is missing or no input of the model.
    """
    content = read_yaml(path)
    for key, kind in CALIBRATED.items():
        if not isinstance(content.get(key), kind):
            shown = _shown(content.get(key))
            raise ValueError(
                f"{path}: {key} is {shown}; allowed: what `snakemake calibrate` writes"
            )
    names = {field.name for field in fields(Parameters)}
    for values in (content["inputs"], *content["ensemble"]):
        unknown = sorted(set(values) - names) if isinstance(values, dict) else [values]
        if unknown:
            raise ValueError(
                f"{path}: unknown input {_shown(unknown[0])}; allowed: those of the model"
            )
    return content


def config_directory() -> Path:
    """Where the configuration lies: inside an installed package, else beside ``src/``."""
    package = Path(__file__).resolve().parents[1]
    installed = package / "config"
    return installed if installed.is_dir() else package.parents[1] / "config"


def load_parameters(path=None) -> Parameters:
    """Inputs of the model from a YAML file, by default the calibrated ones of ``config/``.

    ``path`` names a file with the layout of ``config/inputs.yaml``, or one that gives only some
    of its keys (the others keep their value there).  Raises ``ValueError`` with one line that
    names the file, the key, its value and what is allowed.
    """
    directory = config_directory()
    if path is None:
        path = directory.parent / read_yaml(directory / "config.yaml")["inputs"]
    return Parameters(**read_inputs(directory / "inputs.yaml", path))


def read_plain(*paths) -> None:
    """Refuse configuration files that hold anything but plain data, before Snakemake reads them."""
    for path in paths:
        if "__use_yte__" in read_yaml(path):
            raise ValueError(f"{path}: key '__use_yte__' runs code; allowed: plain values")


def read_changes(path) -> dict:
    """Keys of the file given with ``--config changes=``, none without one.

    Nothing but ``read_yaml`` reads it, where Snakemake has read a ``--configfile`` before it reads
    the workflow, templates that run code included.
    """
    if path is None:
        return {}
    if not isinstance(path, str):
        raise ValueError(f"changes is {_shown(path)}; allowed: the path of a YAML file")
    return read_yaml(path)


def workflow_settings(config: dict) -> dict:
    """The configuration that the rules take their parameters from, checked as a whole.

    Every scene carries its own load axis and ``rtol``, so that it depends on nothing else;
    ``parameters`` are the inputs of the model and ``software`` the versions that compute.
    Raises ``ValueError`` with one line that names the key, its value and what is allowed.
    """
    directory = config_directory()
    validate(config, read_yaml(directory / "schema.yaml"))
    shared = {"load_axis": config["load_axis"], "rtol": config["rtol"]}
    _check_increasing(config["load_axis"]["load_N"], "load_axis.load_N")
    windows = config["windows"]
    ratios = windows["particle_diameter_per_roughness"]
    _check_increasing(ratios, "windows.particle_diameter_per_roughness")
    for name, scene in config["scenes"].items():
        _check_increasing(scene.get("load_axis", shared["load_axis"])["load_N"], f"scenes.{name}")
        for index, group in enumerate(scene["curves"]):
            _check_room(group, f"scenes.{name}.curves[{index}]")
    for name, panels in config["schematics"].items():
        for index, panel in enumerate(panels):
            lists = {key: [value] for key, value in panel.items()}
            _check_room(lists, f"schematics.{name}[{index}]")
    read_valid(directory / "paper_tables.yaml", directory / "paper_tables.schema.yaml")
    base = directory / "inputs.yaml"
    inputs = read_inputs(base, config["inputs"])
    calibration = read_valid(directory / "calibration.yaml", directory / "calibration.schema.yaml")
    sensitivity = read_valid(directory / "sensitivity.yaml", directory / "sensitivity.schema.yaml")
    _check_increasing(sensitivity["load_N"], f"{directory / 'sensitivity.yaml'}: load_N")
    _check_readings(directory / "calibration.yaml", calibration, read_yaml(base))
    return {
        **config,
        "scenes": {name: shared | scene for name, scene in config["scenes"].items()},
        "calibration": calibration,
        "sensitivity": sensitivity,
        "parameters": Parameters(**inputs).as_dict(),
        "uncalibrated": Parameters(**read_inputs(base)).as_dict(),
        "software": {name: version(name) for name in ("numpy", "scipy", "netCDF4", "xarray")},
    }


def _check_readings(path: Path, calibration: dict, entries: dict) -> None:
    """What a reading fixes is within bounds; all that it searches is an input with a range."""
    unknowns = calibration["unknowns"]
    places = {"unknowns": unknowns, "always": calibration["always"]}
    for name, reading in calibration["readings"].items():
        places[f"readings.{name}.unknowns"] = reading.get("unknowns", [])
        places[f"readings.{name}.start"] = reading["start"]
    try:
        _check_increasing(calibration["newtons"], "newtons")
        for place, names in places.items():
            for name in names:
                if name not in unknowns or name not in entries:
                    shown = _shown(name)
                    raise ValueError(
                        f"{place}: {shown} is no unknown; allowed: {', '.join(unknowns)}"
                    )
        for name, unknown in unknowns.items():
            _check_increasing(unknown["bounds"], f"unknowns.{name}.bounds")
            _check_increasing(unknown["usual"], f"unknowns.{name}.usual")
            if (
                unknown["scale"] == "logarithmic"
                and min(*unknown["bounds"], *unknown["usual"]) <= 0
            ):
                raise ValueError(
                    f"unknowns.{name} is logarithmic; allowed: bounds and usual above 0"
                )
        for name, reading in calibration["readings"].items():
            for key, value in reading["fixed"].items():
                try:
                    _checked_input(key, value, entries)
                except ValueError as error:
                    raise ValueError(f"readings.{name}.fixed: {error}") from None
            for key in (*calibration["always"], *reading.get("unknowns", [])):
                if key not in reading["start"]:
                    raise ValueError(
                        f"readings.{name}.start: key {key!r} is missing; allowed: a number"
                    )
    except ValueError as error:
        raise ValueError(f"{path}: {error}") from None


def _check_increasing(ends, key) -> None:
    if not ends[0] < ends[1]:
        raise ValueError(f"{key} is {ends}; allowed: a first value below the last")


def _check_room(group: dict, key) -> None:
    """Particles lie side by side: pi/4 x_a^2 eta_a cannot exceed 1."""
    diameters = group.get("particle_diameter_nm") or [
        ratio * sigma
        for ratio in group["particle_diameter_per_roughness"]
        for sigma in group["roughness_nm"]
    ]
    coverage = 0.25 * math.pi * (1e-9 * max(diameters)) ** 2 * max(group["particle_density_per_m2"])
    if coverage > 1.0:
        raise ValueError(
            f"{key}: particles of {max(diameters):g} nm at {max(group['particle_density_per_m2']):g}"
            f" m-2 cover {coverage:.3g} of the interface; allowed: at most 1"
        )


def with_one_reading(calibration: dict, name: str) -> dict:
    """The calibration settings without the other readings: a reading depends on its own alone."""
    return {**calibration, "readings": {name: calibration["readings"][name]}}
