"""Where the files of the project lie: in its repository, or in the package that is installed.

A wheel holds ``config/``, ``locks/`` and ``workflow/`` inside of the package.  Tests, benchmarks, the
independent model and all that a release describes are in the repository alone.
"""

from __future__ import annotations

import os
from pathlib import Path

PACKAGE = Path(__file__).resolve().parents[1]
IS_INSTALLED = (PACKAGE / "config").is_dir()
HOME = PACKAGE if IS_INSTALLED else PACKAGE.parents[1]
LIBRARY = "src/thirdbody/"  # the package as it lies in the repository


def is_current_folder() -> bool:
    """Whether this run is in the repository itself, not one of other work that uses it."""
    return Path.cwd() == HOME


def tell_environments() -> None:
    """Set the variable by which ``workflow/envs`` finds what it is to install."""
    os.environ["THIRDBODY_HOME"] = str(HOME)


def place_of(name: str | Path) -> str:
    """The path of a file of the project, for the inputs of a rule.

    Parameters
    ----------
    name : str or Path
        Its place in the repository.

    Returns
    -------
    str
        ``name`` itself in the repository, where runs are to be the same on all machines; else where
        the file is.

    Examples
    --------
    In the root of the repository:

    >>> place_of("config/claims.yaml"), place_of("src/thirdbody/figures/paper.mplstyle")
    ('config/claims.yaml', 'src/thirdbody/figures/paper.mplstyle')
    """
    library = str(name).startswith(LIBRARY)
    path = PACKAGE / str(name).removeprefix(LIBRARY) if library else HOME / name
    return str(path.relative_to(HOME) if is_current_folder() else path)


def configuration_folder() -> str:
    """The folder of the configuration: ``config`` where that is the project's or a copy, else its own.

    A copy, such as ``snakedeploy`` makes, is known by the schema of the configuration in it.
    """
    own = Path("config")
    return str(own) if (own / "config.schema.yaml").is_file() else place_of("config")
