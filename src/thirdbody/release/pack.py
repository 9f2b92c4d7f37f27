"""The folder of a release as one file: the same content gives the same bytes."""

from __future__ import annotations

import zipfile
from datetime import date
from os import PathLike
from pathlib import Path

from thirdbody.release.bag import files_in

FILE_MODE = 0o100644 << 16  # a plain file that its owner may write, in the upper half of the field
UNIX = 3  # code of the system whose modes these are


def pack(folder: Path, archive: str | PathLike, day: str) -> None:
    """Write a folder as a zip file.

    Members are sorted, have the same mode and day, and no owner.  They are stored uncompressed, as
    the bytes that a compressor makes depend on its version.

    Parameters
    ----------
    folder : Path
        What is packed; its name is the first part of every member's name.
    archive : path
        File to write.
    day : str
        Date of every member, ISO 8601.
    """
    moment = (*date.fromisoformat(day).timetuple()[:3], 0, 0, 0)
    with zipfile.ZipFile(archive, "w", zipfile.ZIP_STORED) as packed:
        for name in files_in(folder, folder):
            member = zipfile.ZipInfo(f"{folder.name}/{name}", moment)
            member.create_system = UNIX
            member.external_attr = FILE_MODE
            packed.writestr(member, (folder / name).read_bytes())
