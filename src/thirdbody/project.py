"""Where the files of the project lie: in its repository, or inside the installed package.

A wheel holds ``config/``, ``locks/`` and ``workflow/`` inside of the package.  Tests, benchmarks, the
independent model and all that a release describes are in the repository alone.
"""

from __future__ import annotations

from pathlib import Path

PACKAGE = Path(__file__).resolve().parent
HOME = PACKAGE if (PACKAGE / "config").is_dir() else PACKAGE.parents[1]


def project_file(name: str | Path) -> str:
    """The path of a file of the project, for the inputs of a rule.

    Parameters
    ----------
    name : str or Path
        Its place in the repository, such as ``src/thirdbody/figures/paper.mplstyle``.

    Returns
    -------
    str
        Relative to the repository where that is the current folder, so that runs are the same on all
        machines; else absolute.
    """
    library = "src/thirdbody/"
    if str(name).startswith(library):
        path = PACKAGE / str(name).removeprefix(library)
    else:
        path = HOME / name
    return str(path.relative_to(HOME) if Path.cwd() == HOME else path)


def configuration_folder() -> str:
    """The folder of the configuration: ``config`` if the current folder has it, else the project's.

    ``snakedeploy`` copies that folder into the folder of a user's own workflow.
    """
    return "config" if Path("config/config.yaml").is_file() else project_file("config")
