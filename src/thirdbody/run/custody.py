"""What a run relies on: that it is alone in its folder, and that products are as they were made."""

from __future__ import annotations

import fcntl
import hashlib
import os
import re
from collections import defaultdict
from pathlib import Path

# a line of a log as ``thirdbody.data.files.whole`` prints it and ``sha256sum -c`` reads it
RECORD = re.compile(rb"^([0-9a-f]{64})  (results(?:/\w[\w.-]*)+)$", re.MULTILINE)


def hold_alone(path):
    """The file ``path``, open and locked; the kernel frees the lock when this process ends.

    However it ends: no lock is ever stale.  Raises ``OSError`` while another process holds it.
    """
    Path(path).parent.mkdir(exist_ok=True)
    held = open(path, "a", encoding="ascii")
    try:
        fcntl.flock(held, fcntl.LOCK_EX | fcntl.LOCK_NB)
    except BlockingIOError:
        held.close()
        raise OSError("another run is under way in this folder; wait for its end") from None
    return held


def require_writable(folder) -> None:
    """Raise ``OSError`` naming ``folder``, or a folder in it, that may not be written to."""
    for path, _, _ in os.walk(folder):
        if not os.access(path, os.W_OK | os.X_OK):
            raise OSError(f"{path} may not be written to; allow it, or run in a folder of your own")


def recorded_digests(logs) -> dict[str, set[str]]:
    """SHA-256 of each product under ``results/`` that the log files in the folder ``logs`` name.

    There are several where another rule made the product before.
    """
    digests = defaultdict(set)
    for log in Path(logs).rglob("*.log"):
        for digest, product in RECORD.findall(log.read_bytes()):
            digests[product.decode()].add(digest.decode())
    return digests


def remove_damaged(logs) -> list[str]:
    """Remove products that differ from what the log files in ``logs`` record; their names.

    One without a record is left alone.  Raises ``OSError`` naming one that cannot be removed.
    """
    recorded = recorded_digests(logs).items()
    damaged = sorted(product for product, made in recorded if _differs(product, made))
    for product in damaged:
        Path(product).unlink()
    return damaged


def require_recorded(products, logs) -> None:
    """Raise ``ValueError`` naming one of ``products`` that no log file in ``logs`` records."""
    recorded = recorded_digests(logs)
    for product in map(str, products):
        if product not in recorded or _differs(product, recorded[product]):
            raise ValueError(
                f"{product} is not known to be whole: no log in {logs}/ records it as it is; "
                f"remake it: snakemake -c2 --force {product}"
            )


def _differs(product, digests) -> bool:
    """Whether a file is there and is none of those that were made, or cannot be read."""
    try:
        with open(product, "rb") as stream:
            return hashlib.file_digest(stream, "sha256").hexdigest() not in digests
    except FileNotFoundError:
        return False
    except OSError:
        return True
