"""The log and the products of a job of the workflow."""

import traceback
from collections.abc import Iterable, Iterator
from contextlib import contextmanager, redirect_stderr, redirect_stdout
from logging import LogRecord
from pathlib import Path
from types import SimpleNamespace
from typing import Any

from thirdbody.files import DamagedFile, atomic_write, digest

# The record of what was made.  Each job writes the SHA-256 of its products there, as `sha256sum`
# prints it.  The last line on a product counts.
SUMS = Path(".snakemake/made.sha256")


@contextmanager
def job(snakemake: Any) -> Iterator[SimpleNamespace]:
    """Run the script of the workflow that has this ``snakemake`` object.

    An input that is not as its job made it is refused.  The script prints to its log, and the
    SHA-256 of its outputs goes to ``SUMS``.  The yielded paths of the outputs, by name, are
    temporary.  Once the script has ended, all outputs are moved into place together.  So neither a
    killed run nor two runs at once leave half a file.
    """
    output = snakemake.output
    with logged(snakemake.log[0]), atomic_write(*output) as paths:
        require_as_made(snakemake.input)
        yield SimpleNamespace(**dict(zip(output.keys(), paths, strict=True)))
        lines = [f"{digest(path)}  {name}\n" for name, path in zip(output, paths, strict=True)]
        with open(SUMS, "a", encoding="utf-8") as sums:
            sums.write("".join(lines))  # a single write, as other jobs write at the same time


def require_as_made(files: Iterable[str]) -> None:
    """Raise ``DamagedFile`` for a product among ``files`` that is not as its job made it.  A file
    that ``SUMS`` does not name is taken as it is."""
    lines = SUMS.read_text(encoding="utf-8").splitlines() if SUMS.is_file() else []
    made = {name: digits for digits, _, name in (line.partition("  ") for line in lines)}
    for file in made.keys() & {*files}:
        if digest(file) != made[file]:
            raise DamagedFile(file, "is not as its job made it")


def without_none(record: LogRecord) -> bool:
    """A filter of Snakemake's log, which would write "message: None" of a failed job."""
    if record.levelname == "ERROR" and getattr(record, "rule_msg", "") is None:
        record.rule_msg = "failed"
    return True


@contextmanager
def logged(log: str | Path) -> Iterator[None]:
    """Send the output of a script to the file ``log``.

    If the script fails, the log says why, and the exit code is 1.  A user can fix ``ValueError``,
    ``OSError`` and ``MemoryError``: the log ends with their message.  For a damaged product it also
    has the command that remakes the product.  For any other error, also an exit or Ctrl-C, the log
    ends with the traceback.
    If the log cannot be written, the message goes to standard error.
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
            except BaseException:
                failure = traceback.format_exc().rstrip()
            if failure:
                print(failure, file=stream)
    except OSError as error:  # a wrong path, or a full disk
        raise SystemExit(failure or f"{log} cannot be written ({error.strerror})") from None
    if failure:
        raise SystemExit(1)
