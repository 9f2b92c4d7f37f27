"""The sources and settings of a job, as texts among the parameters of its rule: Snakemake names the
texts that have changed.
"""

import ast
import json
from hashlib import sha256
from pathlib import Path

import grimp

from thirdbody.files import read_yaml

INPUTS_OF_RULES = ".j2", ".html"  # suffixes of templates


class Sources:
    """The files of ``packages`` in ``folder``; files in ``home`` are named relative to it."""

    def __init__(self, folder: Path, home: Path, *packages: str) -> None:
        self.folder, self.home = folder, home
        self.graph = grimp.build_graph(
            *packages, exclude_type_checking_imports=True, cache_dir=None
        )

    def of_script(self, script: Path) -> list[str]:
        """A text for each file that a job of ``script`` runs: the script, the modules that it
        imports, all modules that these import, and the data beside the modules."""
        imported = imports_of(script) & self.graph.modules
        modules = imported.union(*map(self.graph.find_upstream_modules, imported))
        packages = {name.rpartition(".")[0] for name in modules} - {""}
        files = {script}.union(*map(self.module_files, modules | packages))
        return sorted(map(self.text, files))

    def module_files(self, name: str) -> list[Path]:
        """The files of a module: its source, and the data beside it under the same name."""
        path = self.folder.joinpath(*name.split("."))
        beside = path.parent.glob(f"{path.name}.*")
        files = [file for file in beside if file.suffix not in INPUTS_OF_RULES]
        return files or [path / "__init__.py"]

    def project_file(self, name: str | Path) -> str:
        """The path of a file of the project, relative if the current folder is ``home``."""
        top, _, rest = str(name).partition("/")
        path = self.folder / rest if top == "src" else self.home / name
        return str(path.relative_to(self.home) if Path.cwd() == self.home else path)

    def text(self, path: Path) -> str:
        """The name of a file, and the first digits of its SHA-256."""
        name = path.relative_to(self.home) if path.is_relative_to(self.home) else path
        return f"{name} {_digest(path.read_bytes())}"


def imports_of(script: Path) -> set[str]:
    """The names that a script imports: modules, and names of submodules or members."""
    names: set[str] = set()
    for statement in ast.walk(ast.parse(script.read_bytes())):
        if isinstance(statement, ast.Import):
            names.update(alias.name for alias in statement.names)
        if isinstance(statement, ast.ImportFrom):
            within = [f"{statement.module}.{alias.name}" for alias in statement.names]
            names.update([f"{statement.module}", *within])
    return names


def settings_text(path: str | Path, expected: type = dict) -> str:
    """The name of a file of the configuration, and the first digits of the SHA-256 of its content.

    The content has the type ``expected``.  A comment does not change the text.  A file that cannot
    be read raises ``ValueError`` in one line.
    """
    content = json.dumps(read_yaml(path, expected), default=str)
    return f"{path} {_digest(content.encode())}"


def _digest(content: bytes) -> str:
    return sha256(content).hexdigest()[:8]
