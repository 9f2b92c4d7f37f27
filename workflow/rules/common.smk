# Shared by the rules: the location of project files, and the modules that a script imports.
import ast
import sys
from functools import cache
from hashlib import sha256
from pathlib import Path

import grimp

import thirdbody
from thirdbody.configuration import config_directory

PACKAGE = Path(thirdbody.__file__).resolve().parent
HOME = config_directory().parent  # the repository, or the installed package
LIBRARY = "src/thirdbody/"


def project_file(name):
    """The path of a file of the project, relative if the current folder is its repository."""
    in_library = str(name).startswith(LIBRARY)
    path = PACKAGE / str(name).removeprefix(LIBRARY) if in_library else HOME / name
    return str(path.relative_to(HOME) if Path.cwd() == HOME else path)


# snakedeploy copies the configuration into the folder of the user's workflow
CONFIG = "config" if Path("config/config.yaml").is_file() else project_file("config")


def configured(name):
    """A file of the configuration, as a parameter of a rule: its content is in ``sources``, so its date, which
    may be in the future, does not matter."""
    return f"{CONFIG}/{name}.yaml"


IMPORTS = grimp.build_graph("thirdbody", exclude_type_checking_imports=True, cache_dir=None)
# priority of small jobs that no long one waits for: they fill both cores at the end of a run
SMALL = -1
STYLE = project_file("src/thirdbody/figures/paper.mplstyle")


def figure_files(figure, category):
    """The files of a figure by kind; the PNG goes into Snakemake's report."""
    files = {kind: f"<results>/figures/{figure}.{kind}" for kind in FIGURE_KINDS}
    caption, labels = "../report/product.rst", {"figure": figure}
    return files | {"png": report(files["png"], caption, category=category, labels=labels)}


def sources_of(script, *modules, config=()):
    """SHA-256 of ``modules``, of those that a script imports, of all their imports, and of files of the
    configuration.

    As a parameter of a rule, it reruns the rule if any of them is edited.
    """
    named = set(modules)
    for statement in ast.walk(ast.parse((HOME / "workflow/scripts" / script).read_bytes())):
        if isinstance(statement, ast.ImportFrom):
            named.add(statement.module)
            named |= {f"{statement.module}.{each.name}" for each in statement.names}
    used = named & IMPORTS.modules
    for name in list(used):
        used |= IMPORTS.find_upstream_modules(name)
    packages = {name.rpartition(".")[0] for name in used}
    modules = [file for name in used | packages for file in module_files(name)]
    return digest([*modules, *(f"{CONFIG}/{name}.yaml" for name in config)])


def digest(files):
    """SHA-256 of the content of all ``files`` together."""
    return sha256("".join(sorted(map(file_sum, files))).encode()).hexdigest()


@cache
def file_sum(file):
    try:
        return sha256(Path(file).read_bytes()).hexdigest()
    except OSError as error:
        sys.exit(f"{file} cannot be read ({error.strerror})")


@cache
def module_files(name):
    """A module, and the data beside it under the same name."""
    path = PACKAGE.parent.joinpath(*name.split("."))
    return [*path.parent.glob(f"{path.name}.*")] or [path / "__init__.py"]


def name_targets(wildcards):
    """Refuse a target that nothing makes, in one line with the targets that there are."""
    names = ", ".join(sorted(each.name for each in workflow.rules if not each.has_wildcards()))
    files = f"{RESULTS}/figures/NAME.svg and others, NAME being {', '.join(DRAWN)}"
    raise ValueError(f"target is {wildcards.target}; allowed: {names}; and {files}")
