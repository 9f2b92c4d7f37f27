"""Files of a release: its sources, their names and types, and texts from the templates in
``templates/``."""

import json
import mimetypes
import subprocess
import tempfile
from pathlib import Path
from typing import Any

from jinja2 import Environment, PackageLoader, StrictUndefined

from chenhorng.markdown import markdown_text

DATA_LICENCE = "CC-BY-4.0"
KNOWN_TYPES = mimetypes.MimeTypes()  # the types of Python, without those of the system
KNOWN_TYPES.add_type("text/markdown", ".md")  # Python knows it from 3.13 on


def media_type(name: str) -> str:
    """Media type of a file, by its suffix; plain text for an unknown suffix."""
    return KNOWN_TYPES.guess_type(name)[0] or "text/plain"


def source_files() -> list[str]:
    """Sorted paths of the sources in the current folder, the root of the project.  In a repository
    they are the files that git tracks; in an unpacked archive, the files that ``.gitignore`` does
    not name."""
    listing = ["ls-files", "-z", "--cached"]
    with tempfile.TemporaryDirectory() as empty:
        if not Path(".git").exists():
            _git("init", "--quiet", "--bare", empty)
            git = [f"--git-dir={empty}", "--work-tree=."]
            listing = [*git, *listing, "--others", "--exclude-standard"]
        names = _git(*listing).split("\0")
    return sorted({name for name in names if name and Path(name).is_file()})


def _git(*arguments: str) -> str:
    command = ["git", *arguments]
    return subprocess.run(command, stdout=subprocess.PIPE, encoding="utf-8", check=True).stdout


def files_in(folder: Path, root: Path) -> list[str]:
    """Sorted paths of all files below ``folder``, relative to ``root``, with forward slashes."""
    paths = (path for path in folder.rglob("*") if path.is_file())
    return sorted(path.relative_to(root).as_posix() for path in paths)


def write_json(path: Path, content: Any) -> None:
    """Write ``content`` as JSON to the file ``path``; a missing folder is created."""
    path.parent.mkdir(parents=True, exist_ok=True)
    path.write_text(json.dumps(content, indent=1, ensure_ascii=False) + "\n", encoding="utf-8")


def render(template: str, **values: Any) -> str:
    """The text of a ``template`` with ``values``; its filter ``text`` is ``markdown_text``."""
    environment = Environment(
        loader=PackageLoader("chenhorng.archive"),
        undefined=StrictUndefined,
        trim_blocks=True,
        lstrip_blocks=True,
        keep_trailing_newline=True,
    )
    environment.filters["text"] = markdown_text
    environment.policies["json.dumps_kwargs"] = {}  # keys are not sorted
    return environment.get_template(template).render(data_licence=DATA_LICENCE, **values)


def render_json(template: str, **values: Any) -> dict[str, Any]:
    """The content of a JSON ``template`` with ``values``."""
    return json.loads(render(template, **values))
