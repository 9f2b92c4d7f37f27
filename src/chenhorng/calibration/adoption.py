"""The files that a calibration replaces: the files of ``config/calibrated/``, and the inputs of the
library.
"""

from collections.abc import Mapping
from typing import Any

import yaml

OF_INTERPRETATION = (
    "# Calibrated inputs of one interpretation, made by `snakemake -c2 calibrate`; "
    "not edited by hand.\n"
)
OF_LIBRARY = (
    "# The calibrated inputs of the model and their ensemble, SI, made by "
    "`snakemake -c2 calibrate`; not edited by hand.\n"
)
KEPT_BY_LIBRARY = "interpretation", "inputs", "ensemble"


def calibrated_text(content: Mapping[str, Any]) -> str:
    """The text of a file of ``config/calibrated/``."""
    return OF_INTERPRETATION + _text(content)


def library_text(content: Mapping[str, Any]) -> str:
    """The text of ``src/thirdbody/calibrated.yaml``, from the ``content`` of a file of
    ``config/calibrated/``.
    """
    return OF_LIBRARY + _text({key: content[key] for key in KEPT_BY_LIBRARY})


def _text(content) -> str:
    return yaml.safe_dump(dict(content), sort_keys=False, width=100, default_flow_style=None)
