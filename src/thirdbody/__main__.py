"""The command ``thirdbody``, also ``python -m thirdbody``."""

import sys


def run() -> int:
    """Answer one question, in any encoding; Ctrl-C ends it quietly while modules are imported, too."""
    sys.stdout.reconfigure(errors="backslashreplace")
    try:
        from thirdbody.command.main import main

        return main()
    except KeyboardInterrupt:
        return 130


if __name__ == "__main__":
    raise SystemExit(run())
