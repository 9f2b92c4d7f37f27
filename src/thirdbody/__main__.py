"""The command ``thirdbody``, also ``python -m thirdbody``."""


def run() -> int:
    """Answer one question; Ctrl-C ends it quietly while modules are imported, too."""
    try:
        from thirdbody.command.main import main

        return main()
    except KeyboardInterrupt:
        return 130


if __name__ == "__main__":
    raise SystemExit(run())
