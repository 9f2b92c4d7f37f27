"""The tables of the page on the configuration, from the classes that check it and its files."""

from pathlib import Path

import yaml

from chenhorng.configuration.model import Configuration
from thirdbody.core.parameters import BOUNDS

ROOT = Path(__file__).resolve().parents[1]
CONFIG = ROOT / "config"
LIMITS = {
    "minimum": "from {}",
    "exclusiveMinimum": "above {}",
    "maximum": "to {}",
    "minItems": "of {} or more",
}
KINDS = {"array": "list", "object": "mapping", "boolean": "true or false", "string": "text"}


def read(path):
    return yaml.safe_load(path.read_text(encoding="utf-8"))


def choices(schema, definitions):
    """What a value may be, each a schema without references; a key that is left out has none."""
    if "anyOf" in schema:
        return [one for each in schema["anyOf"] for one in choices(each, definitions)]
    if "$ref" in schema:
        return choices(definitions[schema["$ref"].rpartition("/")[2]], definitions)
    return [schema] if schema.get("type") != "null" else []


def allowed(schema):
    """What a value may be, in words."""
    if "enum" in schema:
        return ", ".join(map(str, schema["enum"]))
    kind = KINDS.get(schema.get("type"), schema.get("type", ""))
    ends = {key: schema[key] for key in LIMITS if key in schema}
    if "exclusiveMinimum" in ends:
        ends.pop("minimum", None)
    limits = [LIMITS[key].format(f"{end:g}") for key, end in ends.items()]
    text = " ".join([kind, *limits])
    entry = schema.get("items", {})
    return f"{text}, of {allowed(entry)}" if entry.get("type") in ("number", "integer") else text


def keys(schema, definitions, place=""):
    """Yield place, description and allowed values of each key below a schema."""
    for name, each in schema.get("properties", {}).items():
        found = choices(each, definitions)
        entries = [one for each in found for one in choices(each.get("items", {}), definitions)]
        descriptions = (one.get("description", "") for one in (each, *found, *entries))
        description = next(filter(None, descriptions), "").split("\n")[0]
        yield f"{place}{name}", description, " or ".join(map(allowed, found))
        for one in found:
            yield from keys(one, definitions, f"{place}{name}.")
    for name, marker in (("additionalProperties", ".NAME."), ("items", "[].")):
        if isinstance(schema.get(name), dict):
            for one in choices(schema[name], definitions):
                yield from keys(one, definitions, place[:-1] + marker)


def row(*cells):
    return "| " + " | ".join(str(cell).replace("|", "\\|") for cell in cells) + " |\n"


def configuration():
    """A row a key of ``config/config.yaml`` and ``config/scenes.yaml``."""
    schema = Configuration.model_json_schema()
    text = row("key", "what it is", "allowed") + row("---", "---", "---")
    for place, description, values in keys(schema, schema["$defs"]):
        text += row(f"`{place}`", description, values)
    return text


def inputs():
    """A row an input of the model."""
    text = row("input", "symbol", "unit", "source", "allowed") + row(*["---"] * 5)
    for name, entry in read(CONFIG / "inputs.yaml").items():
        bounds = ", ".join(map(str, entry["allowed"])) if "allowed" in entry else BOUNDS[name]
        unit = entry.get("unit", "")
        text += row(f"`{name}`", entry.get("symbol", ""), unit, entry["source"], bounds)
    return text


def fill(app, name, source):
    """Put the tables into the page, for the event ``source-read`` of Sphinx."""
    if name == "workflow":
        source[0] = source[0].replace("<!-- configuration -->", configuration())
        source[0] = source[0].replace("<!-- inputs -->", inputs())
