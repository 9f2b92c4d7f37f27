"""One archive file of a folder: the same content gives the same bytes."""

from __future__ import annotations

import zipfile
from datetime import date
from pathlib import Path

from thirdbody.release.bag import files_in

FILE_MODE = 0o100644 << 16
UNIX = 3


def pack(folder: Path, archive, day: str) -> None:
    """Write the zip file ``archive`` of ``folder``, every member dated ``day`` (ISO 8601).

    Members are sorted, of one mode and without owner.  They are stored as they are, for the bytes
    that a compressor makes depend on its version.
    """
    moment = (*date.fromisoformat(day).timetuple()[:3], 0, 0, 0)
    with zipfile.ZipFile(archive, "w", zipfile.ZIP_STORED) as packed:
        for name in files_in(folder, folder):
            member = zipfile.ZipInfo(f"{folder.name}/{name}", moment)
            member.create_system = UNIX
            member.external_attr = FILE_MODE
            packed.writestr(member, (folder / name).read_bytes())
