"""The tables of the page on the configuration, from its classes and files."""

from pathlib import Path

from chenhorng.configuration.model import Configuration
from thirdbody.core.parameters import BOUNDS
from thirdbody.plain_yaml import read_yaml
from thirdbody.symbols import unicode

INPUTS = Path(__file__).resolve().parents[1] / "config" / "inputs.yaml"
LIMITS = {
    "minimum": "from {}",
    "exclusiveMinimum": "above {}",
    "gt": "above {}",
    "maximum": "to {}",
}
KINDS = {"object": "mapping", "boolean": "true or false", "string": "text"}


def resolved(schema, definitions):
    """A schema with what its reference says, or the first of its choices; others are null or a file."""
    inner = schema.get("anyOf", [{}])[0]
    if reference := schema.get("$ref", inner.get("$ref")):
        inner = definitions[reference.rpartition("/")[2]]
    return inner | schema


def allowed(schema):
    """What a value may be, in words."""
    if "allowed" in schema:
        return schema["allowed"].removeprefix("0, or " if "gt" in schema else "")
    if schema["type"] == "array":
        least, most = (schema.get(key) for key in ("minItems", "maxItems"))
        count = f" of {least}" if least == most else f" of {least or 0} or more"
        inner = schema["items"]
        return f"list{count}" + (f": {allowed(inner)}" if "maximum" in inner else "")
    words = KINDS.get(schema["type"], schema["type"])
    bounds = schema.keys() - ({"minimum"} if schema.keys() & {"gt", "exclusiveMinimum"} else set())
    limits = [text.format(f"{schema[key]:g}") for key, text in LIMITS.items() if key in bounds]
    return " ".join([words, *limits])


def keys(schema, definitions, place=""):
    """Yield place, schema of each key below a schema."""
    for name, each in schema.get("properties", {}).items():
        inner = resolved(each, definitions)
        yield f"{place}{name}", inner
        yield from keys(inner, definitions, f"{place}{name}.")
    for name, marker in (("additionalProperties", ".NAME."), ("items", "[].")):
        if isinstance(schema.get(name), dict):
            yield from keys(resolved(schema[name], definitions), definitions, place[:-1] + marker)


def row(*cells):
    return "| " + " | ".join(str(cell).replace("|", "\\|") for cell in cells) + " |\n"


def configuration():
    """A row a key of ``config/config.yaml`` and ``config/scenes.yaml``."""
    schema = Configuration.model_json_schema()
    text = row("key", "what it is", "allowed") + row("---", "---", "---")
    for place, each in keys(schema, schema["$defs"]):
        words = each.get("description") or resolved(each["items"], schema["$defs"])["description"]
        text += row(f"`{place}`", words, allowed(each))
    return text


def inputs():
    """A row an input of the model."""
    text = row("input", "symbol", "unit", "source", "allowed") + row(*["---"] * 5)
    for name, entry in read_yaml(INPUTS).items():
        bounds = ", ".join(map(str, entry["allowed"])) if "allowed" in entry else BOUNDS[name]
        unit = entry.get("unit", "")
        symbol = unicode(entry.get("symbol", ""), is_symbol=True)
        text += row(f"`{name}`", symbol, unit, entry["source"], bounds)
    return text


def fill(app, name, source):
    """Put the tables into the page, for the event ``source-read`` of Sphinx."""
    if name == "workflow":
        source[0] = source[0].replace("<!-- configuration -->", configuration())
        source[0] = source[0].replace("<!-- inputs -->", inputs())
