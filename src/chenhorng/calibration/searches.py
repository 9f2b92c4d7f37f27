"""The searches of a calibration, and the files from which each starts."""

from collections.abc import Mapping
from typing import Any

FOLDER = "<results>/calibration"


class Searches:
    """The searches that the ``settings`` of a calibration ask for."""

    def __init__(self, settings: Mapping[str, Any]) -> None:
        self.settings, self.entries = settings, settings["interpretations"]

    def nearby(self, name: str) -> list[str]:
        """The interpretation whose best inputs start the search of interpretation ``name``, if
        there is one."""
        return [self.entries[name]["nearby"]] if "nearby" in self.entries[name] else []

    def settings_of(self, name: str) -> dict[str, Any]:
        """The settings for one interpretation, independent of the others."""
        names = [name, *self.nearby(name)]
        return {**self.settings, "interpretations": {each: self.entries[each] for each in names}}

    def starts(self, name: str) -> list[str]:
        """The files with the inputs from which a search over all statements starts."""
        for other in self.nearby(name):
            return self.found(other)
        return [f"{FOLDER}/{name}/scattered.csv"]

    def starts_of_fold(self, name: str, fold: int | str) -> list[str]:
        """The files with the inputs from which a search without a fold starts.  No search over all
        statements is among them."""
        for other in self.nearby(name):
            return [f"{FOLDER}/{other}/fold{fold}.csv"]
        return [f"{FOLDER}/{name}/scattered.csv"]

    def found(self, name: str) -> list[str]:
        """The files of the searches over all statements of an interpretation."""
        seeds = self.settings["seeds"]
        searched = seeds[:1] if self.nearby(name) else seeds
        return [f"{FOLDER}/{name}/seed{seed}.csv" for seed in searched]

    def levels(self, name: str, along: str) -> list[float]:
        """The levels of the quantity ``along`` in the profile of an interpretation."""
        (entry,) = (
            entry
            for entry in self.settings["profiles"]
            if (entry["of"], entry["along"]) == (name, along)
        )
        return entry["levels"]
