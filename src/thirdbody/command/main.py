"""``main``: reads the command line, asks the question and prints the answer."""

from __future__ import annotations

import json
import re
import sys
from argparse import ArgumentParser, Namespace, RawDescriptionHelpFormatter
from collections.abc import Sequence

from thirdbody.answers.answer import Answer
from thirdbody.command.options import option
from thirdbody.command.questions import QUESTIONS

ANSWERED, NONE_FOUND, BAD_INPUT = 0, 1, 2


class OneLineParser(ArgumentParser):
    """A parser whose errors are one line: the option, its value and what is allowed."""

    def error(self, message: str):
        """Leave with ``BAD_INPUT``."""
        told = message.removeprefix("argument ").replace(": is '", " is '", 1)
        unknown = re.match(r"QUESTION: invalid choice: ('.*?')", told)
        if unknown:
            told = f"QUESTION is {unknown[1]}; allowed: {', '.join(QUESTIONS)}"
        self.exit(BAD_INPUT, f"{self.prog}: {told}\n")


def make_parser() -> ArgumentParser:
    """The parser of the command and its sub-commands."""
    parser = OneLineParser(
        prog="thirdbody",
        description="Contact of rough surfaces with hard particles and an oil film between them.",
        epilog="exit codes: 0 answered, 1 what was asked for does not occur, 2 bad input",
        allow_abbrev=False,
    )
    commands = parser.add_subparsers(dest="question", metavar="QUESTION", required=True)
    for name, question in QUESTIONS.items():
        command = commands.add_parser(
            name,
            help=question.asks,
            description=f"{question.asks[0].upper()}{question.asks[1:]}.",
            epilog=f"example:\n  {question.example}",
            formatter_class=RawDescriptionHelpFormatter,
            allow_abbrev=False,
        )
        question.add_options(command)
        command.add_argument("--json", action="store_true", help="print the answer as JSON")
    return parser


def told(error: Exception, options: Namespace) -> str:
    """What is wrong, arguments of the library under the names of their options."""
    names = "|".join(name for name in vars(options) if "_" in name)  # conditions, at least
    return re.sub(rf"\b({names})\b", lambda found: option(found[1]), str(error))


def main(arguments: Sequence[str] | None = None) -> int:
    """Answer one question.

    Parameters
    ----------
    arguments : sequence of str, optional
        The command line, by default that of the process.

    Returns
    -------
    int
        0 if there is an answer, 1 if what is asked for does not occur.

    Raises
    ------
    SystemExit
        With code 2 after one line about what is wrong with the input.

    Examples
    --------
    Without oil and particles nothing changes with the size of particles:

    >>> given = "--load-N 10 --viscosity-cSt 0 --roughness-nm 300 --particle-density-per-m2 0"
    >>> main(["size", *given.split(), "--json"])  # doctest: +ELLIPSIS
    {"title": "Changes along the particle diameter at load 10 N, ...
    1
    """
    parser = make_parser()
    options = parser.parse_args(arguments)
    question = QUESTIONS[options.question]
    try:
        answer = question.answer(options)
    except (ValueError, OSError, ModuleNotFoundError) as error:
        print(f"{parser.prog} {options.question}: {told(error, options)}", file=sys.stderr)
        return BAD_INPUT
    if isinstance(answer, Answer):
        print(json.dumps(answer.as_dict()) if options.json else answer)
        return ANSWERED if answer.found else NONE_FOUND
    if options.json:
        print(json.dumps(answer.columns()))
    else:
        written = " and ".join(filter(None, [options.csv, options.plot]))
        print(f"{written} written" if written else answer.as_csv().rstrip("\n"))
    return ANSWERED
