"""Processor time of one process of a run: up to here, importing by library, and the rest."""

from __future__ import annotations

import atexit
import builtins
import importlib
import json
import resource
import sys
from collections import Counter
from pathlib import Path
from time import process_time

START, WORK = "start", "work"  # beside the names of libraries


def record(place: str | Path, rule: str) -> None:
    """Have this process append a line to a file when it ends: what it was busy with.

    What the standard library takes to import counts for the library that asks for it first.

    Parameters
    ----------
    place : path
        File of one JSON object a line: ``rule``, and seconds by ``START``, library and ``WORK``.
    rule : str
        Name of what this process does.
    """
    spent = Counter({START: _processor_time()})
    owners, inside = ["itself"], [0.0]  # of the imports under way; time of those within each

    def timed(function):
        def importing(name, *rest, **more):
            root = name.partition(".")[0]
            is_relative = not root or any(rest[3:]) or more.get("level")
            known = is_relative or root in sys.stdlib_module_names
            owners.append(owners[-1] if known else root)
            inside.append(0.0)
            began = process_time()
            try:
                return function(name, *rest, **more)
            finally:
                whole = process_time() - began
                spent[owners.pop()] += whole - inside.pop()
                inside[-1] += whole

        return importing

    builtins.__import__ = timed(builtins.__import__)
    importlib.import_module = timed(importlib.import_module)
    atexit.register(_tell, place, rule, spent)


def record_whole(place: str | Path, rule: str) -> None:
    """The same without imports: all is ``WORK``, in any number of threads."""
    atexit.register(_tell, place, rule, Counter())


def _tell(place: str | Path, rule: str, spent: Counter) -> None:
    spent[WORK] = _processor_time() - spent.total()
    with open(place, "a", encoding="utf-8") as stream:
        stream.write(json.dumps({"rule": rule} | spent) + "\n")


def _processor_time() -> float:
    """User and system time of this process [s]."""
    usage = resource.getrusage(resource.RUSAGE_SELF)
    return usage.ru_utime + usage.ru_stime
