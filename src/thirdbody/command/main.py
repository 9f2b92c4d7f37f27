"""``main``: reads the command line, runs the sub-command and prints the answer."""

from __future__ import annotations

import json
import os
import re
import sys
import warnings
from collections.abc import Sequence
from inspect import signature
from shutil import get_terminal_size
from typing import Any

import typer

from thirdbody.command.questions import questions

NAMES = [command.name for command in questions.registered_commands]
ANSWERED, NONE_FOUND, BAD_INPUT, NOT_WRITTEN, STOPPED = 0, 1, 2, 3, 130  # exit codes
# messages of typer, and their form in the library: the option, its value, what is allowed
MESSAGES = {
    r"Invalid value for '(\S+)': (is .*)": r"\1 \2",
    r"Missing option '(\S+)'.": r"\1 is missing",
    r"Missing argument '(\S+)'.": r"\1 is missing",
    r"Missing command.": f"QUESTION is missing; allowed: {', '.join(NAMES)}",
    r"No such command '(.*)'\.": rf"QUESTION is '\1'; allowed: {', '.join(NAMES)}",
    r"No such option: (\S+)": r"there is no option \1",
}


def main(arguments: Sequence[str] | None = None) -> int:
    """Answer the question of a command line, by default ``sys.argv``; returns the exit code."""
    arguments = sys.argv[1:] if arguments is None else list(arguments)
    name = " ".join(["thirdbody", *(each for each in arguments[:1] if each in NAMES)])
    with warnings.catch_warnings(record=True) as caught:
        warnings.simplefilter("ignore")
        warnings.simplefilter("default", UserWarning)  # other warnings are for developers
        try:
            asked = questions(arguments, prog_name="thirdbody", standalone_mode=False)
        except typer.TyperException as error:
            return _refuse(name, error.format_message())
        except (ValueError, OSError, ModuleNotFoundError) as error:
            return _refuse(name, str(error))
    for message in dict.fromkeys(str(each.message) for each in caught):
        print(f"{name}: warning: {_plain(message)}", file=sys.stderr)
    if asked == STOPPED:
        print(f"{name}: stopped; run the same command again to start over", file=sys.stderr)
    if isinstance(asked, int):  # of --help, --version and Ctrl-C
        return asked
    answer, as_json = asked
    written = _print(name, _text(answer, as_json))
    return written or (ANSWERED if getattr(answer, "found", True) else NONE_FOUND)


def _refuse(name: str, message: str) -> int:
    print(f"{name}: {_plain(message)}", file=sys.stderr)
    return BAD_INPUT


def _plain(message: str) -> str:
    """A message on one line, with arguments of the library replaced by their options."""
    for pattern, replacement in MESSAGES.items():
        message = re.sub(pattern, replacement, message)
    functions = (command.callback for command in questions.registered_commands)
    arguments = {name for each in functions for name in signature(each).parameters if "_" in name}
    names = "|".join(sorted(arguments, key=len, reverse=True))
    message = re.sub(rf"\b({names})\b", lambda found: "--" + found[1].replace("_", "-"), message)
    return " ".join(message.split())


def _text(answer: Any, as_json: bool) -> str:
    """The printed form of an ``Answer``, a ``Curve`` or a line; tables fit the width of a terminal."""
    if as_json:
        return json.dumps(answer.as_dict())
    if sys.stdout.isatty() and hasattr(answer, "as_text"):
        return answer.as_text(get_terminal_size().columns)
    return str(answer)


def _print(name: str, text: str) -> int:
    """Print a text; a closed pipe is not an error."""
    try:
        print(text, flush=True)
    except OSError as error:
        # The rest of the buffer would be written again at exit.
        os.dup2(os.open(os.devnull, os.O_WRONLY), sys.stdout.fileno())
        if not isinstance(error, BrokenPipeError):
            print(f"{name}: the answer cannot be written ({error.strerror})", file=sys.stderr)
            return NOT_WRITTEN
    return ANSWERED
