"""The list of the searches of a calibration, and the files from which each search starts."""

import json
from collections.abc import Callable, Mapping
from pathlib import Path
from typing import Any

FOLDER = "<results>/calibration"


class Searches:
    """The searches that the settings of a calibration ask for.

    ``shortlist`` returns the path of the file with the names on the shortlist, once the shortlist
    is chosen.
    """

    def __init__(self, settings: Mapping[str, Any], shortlist: Callable[[], str]) -> None:
        self.settings, self.entries = settings, settings["interpretations"]
        self.shortlist = shortlist

    def wide(self) -> list[str]:
        """The interpretations whose searches start from scattered inputs."""
        return [name for name, entry in self.entries.items() if "nearby" not in entry]

    def nearby(self, name: str) -> list[str]:
        """The interpretation from whose best inputs the searches of ``name`` start; empty if they
        start from scattered inputs."""
        return [self.entries[name]["nearby"]] if "nearby" in self.entries[name] else []

    def settings_of(self, name: str) -> dict[str, Any]:
        """The settings without the interpretations on which the searches of ``name`` do not
        depend."""
        names = [name, *self.nearby(name)]
        return {**self.settings, "interpretations": {key: self.entries[key] for key in names}}

    def starts(self, name: str) -> list[str]:
        """The files with the inputs from which a search over all statements starts."""
        for other in self.nearby(name):
            return self.found(other)
        return [f"{FOLDER}/{name}/scattered.csv"]

    def starts_of_fold(self, name: str, fold: int | str) -> list[str]:
        """The files with the inputs from which a search starts that leaves out a ``fold``."""
        for other in self.nearby(name):
            return [f"{FOLDER}/{other}/fold{fold}.csv"]
        return [f"{FOLDER}/{name}/scattered.csv"]

    def found(self, name: str) -> list[str]:
        """The files of the searches over all statements of an interpretation."""
        seeds = self.settings["seeds"]
        seeds = seeds if name in self.shortlisted() else seeds[:1]
        return [f"{FOLDER}/{name}/seed{seed}.csv" for seed in seeds]

    def shortlisted(self) -> list[str]:
        """The names on the shortlist."""
        return json.loads(Path(self.shortlist()).read_text(encoding="utf-8"))

    def is_cross_validated(self, name: str) -> bool:
        """Whether the shortlist has the interpretation, or the one from whose inputs its searches
        start."""
        while nearby := self.nearby(name):
            (name,) = nearby
        return name in self.shortlisted()
