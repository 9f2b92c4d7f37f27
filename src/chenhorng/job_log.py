"""The log and the products of a job of the workflow."""

import re
from collections.abc import Iterable, Iterator
from contextlib import contextmanager, redirect_stderr, redirect_stdout
from pathlib import Path
from types import SimpleNamespace
from typing import Any

from thirdbody.files import DamagedFile, atomic_write, digest

SUM = re.compile(r"^([0-9a-f]{64})  (.+)$", re.MULTILINE)  # of a product, as `sha256sum` prints it


@contextmanager
def job(snakemake: Any) -> Iterator[SimpleNamespace]:
    """Run a script of the workflow, whose ``snakemake`` this is.

    What it prints goes to its log, and then the SHA-256 of each output.  The paths of its outputs, which are yielded by
    their names, are temporary: all are moved into place together once the script has ended, so that a run that
    is killed leaves no half of a file, nor do two runs at once.
    """
    output = snakemake.output
    with logged(snakemake.log[0]), atomic_write(*output) as paths:
        yield SimpleNamespace(**dict(zip(output.keys(), paths, strict=True)))
        for name, path in zip(output, paths, strict=True):
            print(f"{digest(path)}  {name}")


def require_as_made(products: Iterable[str], logs: str | Path) -> dict[str, str]:
    """The SHA-256 of each product in the log of its job; ``DamagedFile`` for a product of another content."""
    paths = sorted(Path(logs).rglob("*.log"), key=lambda path: path.stat().st_mtime_ns)
    texts = [path.read_text(encoding="utf-8") for path in paths]  # of two, the newer one counts
    sums = {name: digits for text in texts for digits, name in SUM.findall(text)}
    for product in products:
        if digest(product) != sums.get(product):
            raise DamagedFile(product, "is not as its job made it")
    return sums


@contextmanager
def logged(log: str | Path) -> Iterator[None]:
    """Send what a script prints to the file ``log``.

    For ``ValueError``, ``OSError`` and ``MemoryError``, which a user can fix, the log ends with the
    message instead of a traceback, for a damaged product also with the command that recreates it, and
    the script exits with code 1.  If the log cannot be written, the message goes to standard error.
    """
    failure = None
    try:
        with open(log, "w", encoding="utf-8", buffering=1) as stream:
            try:
                with redirect_stdout(stream), redirect_stderr(stream):
                    yield
            except (ValueError, OSError, MemoryError) as error:
                failure = str(error) or type(error).__name__
                if isinstance(error, DamagedFile):
                    failure += f"; remake it: snakemake -c2 --force {error.path}"
                print(failure, file=stream)
    except OSError as error:  # a wrong path, or a full disk
        raise SystemExit(failure or f"{log} cannot be written ({error.strerror})") from None
    if failure:
        raise SystemExit(1)
