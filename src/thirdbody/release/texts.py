"""Descriptions of an archive, for people and for programs, from the templates in ``templates/``."""

from __future__ import annotations

import json
import re
from typing import Any

from jinja2 import Environment, PackageLoader, StrictUndefined

DATA_LICENCE = "CC-BY-4.0"


def render(template: str, **values: Any) -> str:
    """Text of a template with ``values`` and the filter ``text`` (``markdown_text``)."""
    environment = Environment(
        loader=PackageLoader("thirdbody.release"),
        undefined=StrictUndefined,
        trim_blocks=True,
        lstrip_blocks=True,
        keep_trailing_newline=True,
    )
    environment.filters["text"] = markdown_text
    environment.policies["json.dumps_kwargs"] = {}  # keys in their order
    return environment.get_template(template).render(data_licence=DATA_LICENCE, **values)


def render_json(template: str, **values: Any) -> dict[str, Any]:
    """Content of a template that is JSON."""
    return json.loads(render(template, **values))


def markdown_text(text: str) -> str:
    """``text`` as one line of Markdown, with markup and HTML escaped."""
    line = " ".join(str(text).split())
    line = line.replace("&", "&amp;").replace("<", "&lt;").replace(">", "&gt;")
    return re.sub(r"([\\`*_{}\[\]()#+!|~$])", r"\\\1", line)
