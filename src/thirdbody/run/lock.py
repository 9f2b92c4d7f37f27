"""A run is alone in its folder, and may write to it."""

from __future__ import annotations

import atexit
import fcntl
import os
import platform
import re
import secrets
import sys
import threading
import time
from contextlib import suppress
from pathlib import Path
from typing import IO

BEAT = 5.0  # seconds between two signs of life of a run
PATIENCE = 8  # beats without any, after which a run on another host is dead
BOOT = Path("/proc/sys/kernel/random/boot_id")
RECORD = re.compile(r"(?P<run>thirdbody-[0-9a-f]{12}) [0-9]{12} (?P<host>\S+)\n")
BUSY = "another run is under way in this folder{}; wait for its end"


class Hold:
    """Sole use of a folder by this process.

    Parameters
    ----------
    path
        The file that is locked.
    beat
        Seconds between two signs of life.

    Attributes
    ----------
    name : str
        The name of this run, which no other has.
    before : str or None
        The name of the run that ended without giving the folder back, if there was one.

    Raises
    ------
    OSError
        While another process holds the folder, on whatever host.

    Notes
    -----
    On one host the kernel's lock of the file tells the truth: it is freed when its holder ends, however
    that ends.  On a shared file system the kernel may know of locks on its own host alone, and may have
    none.  So the holder counts in a record beside the file.  Who finds the record of another host watches
    whether the count goes on; no clock is compared with another.  A run that was taken for dead, as it
    was paused, ends when it finds the record of its successor.
    """

    def __init__(self, path: str | Path, beat: float = BEAT) -> None:
        self.name, self.before = f"thirdbody-{secrets.token_hex(6)}", None
        self._record, self._beat = Path(f"{path}.run"), beat
        self._held, is_locked = _lock(path)
        try:
            self._succeed(is_locked)
            self._put_record()
        except OSError:
            self._held.close()
            raise
        self._ended = threading.Event()
        threading.Thread(target=self._count_on, daemon=True).start()
        atexit.register(self.close)

    def close(self) -> None:
        """Give the folder back."""
        if not self._ended.is_set():
            self._ended.set()
            if (self._read() or "").startswith(self.name):
                self._record.unlink(missing_ok=True)
            self._held.close()

    def __enter__(self) -> Hold:
        return self

    def __exit__(self, *_) -> None:
        self.close()

    def _succeed(self, is_locked: bool) -> None:
        """Take the record away of a run that is dead, if there is one."""
        found = self._read()
        if found is None:
            return
        told = RECORD.fullmatch(found)  # none if there was no room for it
        if not (is_locked and told and told["host"] == _host()):
            self._watch(found)
        self.before = told and told["run"]
        with suppress(FileNotFoundError):  # another run takes it at the same time
            os.rename(self._record, f"{self._record}.{self.name}")
            os.unlink(f"{self._record}.{self.name}")

    def _watch(self, found: str) -> None:
        """Raise ``OSError`` if the run whose record was ``found`` gives a sign of life."""
        seconds = round(PATIENCE * self._beat)
        print(f"{self._record} is of a run elsewhere; is it alive? {seconds} s", file=sys.stderr)
        for _ in range(PATIENCE):
            time.sleep(self._beat)
            told = RECORD.fullmatch(now := self._read() or found)
            if now != found:
                raise OSError(BUSY.format(f", on {told['host'].partition('/')[0]}" if told else ""))

    def _put_record(self) -> None:
        """Make the record of this run, unless another has one."""
        try:
            with open(self._record, "x", encoding="ascii") as record:
                record.write(self._text(0))
        except FileExistsError:
            raise OSError(BUSY.format("")) from None
        except OSError:  # no room: nothing is left that others would watch
            self._record.unlink(missing_ok=True)
            raise

    def _count_on(self) -> None:
        """Give signs of life, until another run has the folder."""
        count = 0
        while not self._ended.wait(self._beat):
            count += 1
            with suppress(OSError), open(self._record, "r+", encoding="ascii") as record:
                if not record.read().startswith(self.name):
                    print(
                        "this run was taken for dead, and another began; it ends", file=sys.stderr
                    )
                    os._exit(1)
                record.seek(0)
                record.write(self._text(count))
                record.flush()
                os.fsync(record.fileno())

    def _text(self, count: int) -> str:
        """The record: of one length, so that it fits on a full disk as well."""
        return f"{self.name} {count:012d} {_host()}\n"

    def _read(self) -> str | None:
        """The record that is there, if any is."""
        try:
            return self._record.read_text(encoding="ascii", errors="replace")
        except FileNotFoundError:
            return None


def _lock(path: str | Path) -> tuple[IO[str], bool]:
    """The open file ``path``, and whether the kernel has locked it: some file systems have no locks.

    Raises
    ------
    OSError
        While another process holds the lock.
    """
    Path(path).parent.mkdir(parents=True, exist_ok=True)
    held = open(path, "a", encoding="ascii")  # noqa: SIM115, it stays open
    try:
        fcntl.flock(held, fcntl.LOCK_EX | fcntl.LOCK_NB)
    except (BlockingIOError, PermissionError):
        held.close()
        raise OSError(BUSY.format("")) from None
    except OSError:
        return held, False
    return held, True


def _host() -> str:
    """This host, as it was booted: processes of one host share a kernel, and so its locks."""
    boot = BOOT.read_text(encoding="ascii").strip() if BOOT.exists() else ""
    return f"{platform.node()}/{boot}"


def require_writable(folder: str | Path) -> None:
    """Require the right to read and write ``folder`` and every folder in it, or to make it.

    Raises
    ------
    OSError
        Naming the first folder that may not be written to, or what is in the place of one.
    """
    if not os.path.lexists(folder):
        folder = Path(folder).parent
        within = [folder]
    elif Path(folder).is_dir():
        inner = (os.path.join(path, name) for path, names, _ in os.walk(folder) for name in names)
        within = [folder, *inner]
    else:
        raise OSError(f"{folder} is no folder; move it away: a run makes a folder of that name")
    for path in within:
        if not os.access(path, os.R_OK | os.W_OK | os.X_OK):
            raise OSError(f"{path} may not be written to; allow it, or run in a folder of your own")
