"""The command ``thirdbody``, also ``python -m thirdbody``."""

import os
import sys
from io import TextIOWrapper


def run() -> int:
    """Run the command in any encoding; Ctrl-C ends it quietly, even while modules are imported."""
    sys.stderr = sys.stderr or open(os.devnull, "w")  # noqa: SIM115
    if isinstance(sys.stdout, TextIOWrapper):  # None if it is closed: then no answer can be written
        sys.stdout.reconfigure(errors="backslashreplace")
    try:
        from thirdbody.command import main

        return main()
    except KeyboardInterrupt:
        return 130


if __name__ == "__main__":
    raise SystemExit(run())
