"""The folder with the files of the workflow: the repository, or the installed package."""

from pathlib import Path


def config_directory() -> Path:
    """The folder of the configuration: inside an installed package, otherwise beside ``src/``."""
    package = Path(__file__).resolve().parent
    home = package if (package / "config").is_dir() else package.parents[1]
    return home / "config"
