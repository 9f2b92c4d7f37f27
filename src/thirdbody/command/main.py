"""``main``: reads the command line, runs the sub-command and prints the answer."""

from __future__ import annotations

import io
import json
import os
import re
import sys
import warnings
from collections.abc import Sequence
from contextlib import redirect_stdout, suppress
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
    r"Option '(\S+)' requires an argument\.": r"\1 has no value",
    r"Missing argument '(\S+)'.": r"\1 is missing",
    r"Missing command.": f"QUESTION is missing; allowed: {', '.join(NAMES)}",
    r"No such command '(.*?)'\..*": rf"QUESTION is '\1'; allowed: {', '.join(NAMES)}",
    r"No such option: (\S+)": r"there is no option \1",
    r"\b(?:between|low to high|between_N) is": "--from or --to is",
}


def main(arguments: Sequence[str] | None = None) -> int:
    """Answer the question of a command line, by default ``sys.argv``; returns the exit code."""
    arguments = sys.argv[1:] if arguments is None else list(arguments)
    name = " ".join(["thirdbody", *(each for each in arguments[:1] if each in NAMES)])
    printed = io.StringIO()  # of --help and --version
    with warnings.catch_warnings(record=True) as caught, redirect_stdout(printed):
        warnings.simplefilter("ignore")
        warnings.simplefilter("default", UserWarning)  # other warnings are for developers
        try:
            asked = questions(arguments, prog_name="thirdbody", standalone_mode=False)
        except typer.TyperException as error:
            return _refuse(name, error.format_message())
        except (ValueError, OSError, ModuleNotFoundError) as error:
            return _refuse(name, str(error))
    for message in dict.fromkeys(str(each.message) for each in caught):
        _tell(name, f"warning: {_plain(message)}")
    if asked == STOPPED:
        _tell(name, "stopped; run the same command again to start over")
    if isinstance(asked, int):
        return _print(name, printed.getvalue()) or asked
    answer, as_json = asked
    written = _print(name, _text(answer, as_json) + "\n")
    return written or (ANSWERED if getattr(answer, "found", True) else NONE_FOUND)


def _tell(name: str, message: str) -> None:
    with suppress(OSError):
        print(f"{name}: {message}", file=sys.stderr)


def _refuse(name: str, message: str) -> int:
    _tell(name, _plain(message))
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
    if isinstance(answer, str):
        return answer
    if as_json:
        return json.dumps(answer.as_dict())
    if hasattr(answer, "as_csv"):
        return answer.as_csv().rstrip("\n")
    if sys.stdout.isatty():
        return answer.as_text(get_terminal_size().columns, on_terminal=True)
    return str(answer)


def _print(name: str, text: str) -> int:
    """Print a text; a closed pipe is not an error."""
    try:
        print(text, end="", flush=True)
    except OSError as error:
        # The rest of the buffer would be written again at exit.
        os.dup2(os.open(os.devnull, os.O_WRONLY), sys.stdout.fileno())
        if not isinstance(error, BrokenPipeError):
            _tell(name, f"the answer cannot be written ({error.strerror})")
            return NOT_WRITTEN
    return ANSWERED
