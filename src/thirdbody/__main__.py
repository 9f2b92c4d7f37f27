"""``python -m thirdbody`` is the command ``thirdbody``."""

from thirdbody.command.main import main

if __name__ == "__main__":
    raise SystemExit(main())
