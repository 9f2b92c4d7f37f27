"""Reading the YAML files of ``config/`` and checking them before anything is computed.

``plain_yaml`` reads the files, ``schema`` checks them against the schema beside each file and by
``rules``, ``inputs`` returns the inputs of the model, and ``settings`` the settings of the
workflow.  Start with ``schema`` and ``config/config.schema.yaml``.
"""

from pathlib import Path


def config_directory() -> Path:
    """The configuration folder: inside an installed package, otherwise beside ``src/``."""
    package = Path(__file__).resolve().parents[1]
    home = package if (package / "config").is_dir() else package.parents[1]
    return home / "config"
