"""Where the files of the workflow are: the repository, or the installed package, which has copies
of them.
"""

from pathlib import Path


def config_directory() -> Path:
    """The configuration folder: inside an installed package, otherwise beside ``src/``."""
    package = Path(__file__).resolve().parent
    home = package if (package / "config").is_dir() else package.parents[1]
    return home / "config"
