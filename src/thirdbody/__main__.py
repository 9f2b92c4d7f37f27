"""The command ``thirdbody``, also ``python -m thirdbody``."""

import os
import sys
from io import TextIOWrapper


def run() -> int:
    """Run the command.  It works in any encoding, and Ctrl-C ends it without a traceback."""
    sys.stderr = sys.stderr or open(os.devnull, "w")  # noqa: SIM115
    if isinstance(sys.stdout, TextIOWrapper):  # it is None if the caller has closed it
        sys.stdout.reconfigure(errors="backslashreplace")
    try:
        from thirdbody.command import main

        return main()
    except KeyboardInterrupt:
        return 130


if __name__ == "__main__":
    raise SystemExit(run())
