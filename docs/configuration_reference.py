"""The tables of the page on the configuration, from the classes that check it and from its
files."""

from pathlib import Path

from chenhorng.configuration.model import Configuration
from thirdbody.core.parameters import BOUNDS
from thirdbody.files import read_yaml
from thirdbody.symbols import unicode

INPUTS = Path(__file__).resolve().parents[1] / "config" / "inputs.yaml"
LIMITS = {"minimum": "from {}", "exclusiveMinimum": "above {}", "maximum": "to {}"}
KINDS = {"array": "list", "object": "mapping", "boolean": "true or false", "string": "text"}


def resolved(schema, definitions):
    """A schema with what its references say, without the null of a key that may be left out."""
    for choice in schema.get("anyOf", []):
        if choice.get("type") != "null":
            schema = schema | choice
    name = schema.get("$ref", "").rpartition("/")[2]
    return resolved(definitions[name], definitions) | schema if name else schema


def described(schema):
    """What a value is; for a list what its values are."""
    words = schema.get("description") or schema.get("items", {}).get("description", "")
    return " ".join(words.split())


def allowed(schema):
    """What a value may be, in words."""
    kind = schema.get("type", "")
    least, most = schema.get("minItems"), schema.get("maxItems")
    if least is not None:
        limits = [f"of {least}" if least == most else f"of {least} or more"]
    else:
        limits = [text.format(f"{schema[key]:g}") for key, text in LIMITS.items() if key in schema]
    words = " ".join([KINDS.get(kind, kind), *limits])
    if schema.get("items", {}).get("type") == "number":
        words += f": {allowed(schema['items'])}"
    return "; ".join(filter(None, [words, schema.get("allowed")]))


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
        text += row(f"`{place}`", described(each), allowed(each))
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
