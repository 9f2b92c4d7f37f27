"""The tables of the page on the configuration, from its schemas and files."""

from pathlib import Path

import yaml

from thirdbody.core.parameters import BOUNDS

ROOT = Path(__file__).resolve().parents[1]
CONFIG, SCHEMAS = ROOT / "config", ROOT / "src/chenhorng/configuration"
LIMITS = {
    "minimum": "from {}",
    "exclusiveMinimum": "and above {}",
    "maximum": "to {}",
    "minItems": "of {} or more",
}
KINDS = {"array": "list", "object": "mapping", "boolean": "true or false", "string": "text"}


def read(path):
    return yaml.safe_load(path.read_text(encoding="utf-8"))


def resolved(schema, document):
    """A schema with what its references say, and the document in which further ones are."""
    if not isinstance(schema.get("$ref"), str) or "#" not in schema["$ref"]:
        return schema, document
    file, _, pointer = schema["$ref"].partition("#")
    document = read(SCHEMAS / file) if file else document
    target = document
    for key in pointer.strip("/").split("/"):
        target = target[key]
    target, document = resolved(target, document)
    return target | {key: each for key, each in schema.items() if key != "$ref"}, document


def allowed(schema):
    """What a value may be, in words."""
    if "allowed" in schema:
        return str(schema["allowed"])
    if "enum" in schema:
        return ", ".join(map(str, schema["enum"]))
    kind = schema.get("type", "")
    kinds = [kind] if isinstance(kind, str) else kind
    words = " or ".join(KINDS.get(kind, kind) for kind in kinds)
    limits = [text.format(f"{schema[key]:g}") for key, text in LIMITS.items() if key in schema]
    return " ".join([words, *limits])


def keys(schema, document, place=""):
    """Yield place, schema of each key below a schema."""
    for name, each in schema.get("properties", {}).items():
        inner, inside = resolved(each, document)
        yield f"{place}{name}", inner
        yield from keys(inner, inside, f"{place}{name}.")
    for name, marker in (("additionalProperties", ".NAME."), ("items", "[].")):
        if isinstance(schema.get(name), dict):
            inner, inside = resolved(schema[name], document)
            yield from keys(inner, inside, place[:-1] + marker)


def row(*cells):
    return "| " + " | ".join(str(cell).replace("|", "\\|") for cell in cells) + " |\n"


def configuration():
    """A row a key of ``config/config.yaml`` and ``config/scenes.yaml``."""
    schema = read(SCHEMAS / "config.schema.yaml")
    text = row("key", "what it is", "allowed") + row("---", "---", "---")
    for place, each in keys(schema, schema):
        text += row(f"`{place}`", each.get("description", ""), allowed(each))
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
