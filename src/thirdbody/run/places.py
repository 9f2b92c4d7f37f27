"""Where the files of a run go: a run with a name keeps them apart from those of all others."""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path

PRODUCTS = Path("results")
CUSTODY = ".custody"  # folder of the records in that of the products


@dataclass(frozen=True)
class Places:
    """Places of a run, relative to the root of the repository.

    Attributes
    ----------
    products : Path
        Folder of the products.
    logs : Path
        Folder of what jobs said and took.
    lock : Path
        File that is locked while the run is under way.
    """

    products: Path
    logs: Path
    lock: Path

    @classmethod
    def of_run(cls, name: str | None) -> Places:
        """Those of the run ``name``: all below ``results/NAME/``; None is the run without a name.

        >>> print(Places.of_run("soft").logs)
        results/soft/logs
        """
        if name is None:
            return cls(PRODUCTS, Path("logs"), Path(".snakemake/thirdbody.lock"))
        products = PRODUCTS / name
        return cls(products, products / "logs", products / CUSTODY / "lock")

    def without_run(self, path: str | Path) -> str:
        """What the run without a name calls a product of this one; other paths stay as they are."""
        path = Path(path)
        inside = path.is_relative_to(self.products)
        return str(PRODUCTS / path.relative_to(self.products) if inside else path)
