"""One HTML file from a template, a style, scripts, D3 and the content of the page."""

from __future__ import annotations

import json
import re
from collections.abc import Mapping
from pathlib import Path
from typing import Any

HERE = Path(__file__).parent
FIRST = "main.js"  # the script that imports all others
IMPORT = re.compile(r'^import (\{[^}]*\}) from "\./(\w+\.js)";$', re.MULTILINE)
EXPORT = re.compile(r"^export (?=(?:const|function|class) (\w+))", re.MULTILINE)


def page_text(content: Mapping[str, Any]) -> str:
    """The page as self-contained HTML, from the ``content`` of
    ``thirdbody.explorer.content.page_content``."""
    data = json.dumps(content, ensure_ascii=False, allow_nan=False, separators=(",", ":"))
    parts = {
        "style.css": _read("page/style.css"),
        "d3.LICENSE": _read("vendor/d3.LICENSE"),
        "d3.min.js": _read("vendor/d3.min.js"),
        "content.json": data.replace("</", "<\\/"),
        "main.js": _one_script(FIRST),
    }
    return re.sub(r"\{\{([\w.]+)\}\}", lambda found: parts[found[1]], _read("page/index.html"))


def _one_script(first: str) -> str:
    """Bundle a script and all its imports: each module becomes a function that is called once."""
    joined: dict[str, str] = {}

    def join(name):
        if name in joined:
            return
        text = _read(f"page/{name}")
        for _, imported in IMPORT.findall(text):
            join(imported)
        body = IMPORT.sub(r'const \1 = modules["\2"];', EXPORT.sub("", text))
        exports = ", ".join(EXPORT.findall(text))
        joined[name] = f'modules["{name}"] = (() => {{\n{body}\nreturn {{ {exports} }};\n}})();'

    join(first)
    return "const modules = {};\n" + "\n\n".join(joined.values())


def _read(name: str) -> str:
    return (HERE / name).read_text(encoding="utf-8").strip()
