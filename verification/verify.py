"""Is this archive complete and unchanged, and are its numbers those of the model?

    python verification/verify.py [FOLDER] [--seed N] [--points N] [--packed] [--sums]

FOLDER is an unpacked archive, by default the one that this program lies in.  Needs Python 3.11,
numpy, scipy and netCDF4, nothing else, and for the datasets a POSIX system.  It looks for missing
and extra files first, and compares the SHA-256 sums of those that are listed; nothing in FOLDER is
imported before they agree.  Then it compares the descriptions of the tables and the crate with the
files, looks for what pages and drawings would load from elsewhere, and compares each dataset with
the data contract and the configuration (contract.py) and with the equations of the paper at every
point; some points are solved again from the inputs alone (plain_model.py).  Prints one line.  Exit
code 0: whole; 1: not.
"""

import sys

sys.dont_write_bytecode = True  # nothing may be added to the archive, not even by checking it
if __name__ == "__main__" and not sys.flags.safe_path:
    del sys.path[0]  # this folder: Python would run a json.py or numpy.py that lies here

import argparse
import csv
import hashlib
import importlib
import json
import random
import re
import tempfile
import warnings
import zipfile
from datetime import date
from pathlib import Path
from urllib.parse import unquote
from xml.etree import ElementTree

HERE = Path(__file__).resolve().parent
DIGITS = 64  # hexadecimal, of a SHA-256 sum
METADATA = "ro-crate-metadata.json"
TABLE_SCHEMAS = "table-schemas.json"
BAG_DECLARATION = "BagIt-Version: 1.0\nTag-File-Character-Encoding: UTF-8\n"
PROGRAMS = ("content_hash.py", "contract.py", "plain_model.py", "recompute.py", "verify.py")
# files of the bag itself: the crate does not describe them
OF_BAG = {"bag-info.txt", "bagit.txt", "manifest-sha256.txt", "tagmanifest-sha256.txt"}
# everything beside data/
TAG_FILES = {"README.md", METADATA, *OF_BAG, *(f"verification/{name}" for name in PROGRAMS)}
NO_PRODUCTS = ("source", "configuration")  # other folders of the payload
CONFIGURATION = "data/configuration/config.json"
INPUTS = "data/configuration/parameters.json"
CONTENT_SUMS = "data/datasets/content-sha256.json"
SHOWN_FAULTS = 5
SHOWN_DEVIATION = 1e-16  # a smaller one is shown as this
LONGEST_LINE = 10_000_000  # characters of a table that are read at once
LARGEST_TEXT = 100_000_000  # bytes of a manifest, description or page, which are read at once
# a part of a path that every system can write
PORTABLE = re.compile(r"[A-Za-z0-9._+-]*[A-Za-z0-9_+-]")
# how each page begins: a browser then loads nothing but pictures from beside it
POLICY = (
    "default-src 'none'; img-src 'self' data:; script-src 'unsafe-inline'; "
    "style-src 'unsafe-inline'; base-uri 'none'; form-action 'none'"
)
PAGE_BEGINS = re.compile(
    r"<!doctype html>\s*<html lang=\"en\">\s*<head>\s*<meta charset=\"utf-8\">\s*"
    rf"<meta http-equiv=\"Content-Security-Policy\" content=\"{re.escape(POLICY)}\">",
    re.IGNORECASE,
)
# what makes a drawing run or load something: an element, a NAME=VALUE, or a part of a style
DRAWING_LOADS = re.compile(
    r"^<(?:script|foreignObject|animate\w*|set)$|^on\w+=|^base=|^(?:href|src)=(?!#|data:image/png)"
    r"|@import|\burl\((?!#)|\\",
    re.IGNORECASE,
)
XHTML = "{http://www.w3.org/1999/xhtml}"
FILE_MODE = 0o100644 << 16  # a regular file, writable by its owner
UNIX = 3  # code of a zip file for a system with such modes


class Faults(dict):
    """The faults of an archive: for each file the first reason."""

    def add(self, path, reason):
        self.setdefault(str(path), " ".join(str(reason).split()))


def sha256(path):
    """SHA-256 of a file."""
    with open(path, "rb") as content:
        return sha256_of(content)


def sha256_of(content):
    """SHA-256 of an open file."""
    digest = hashlib.sha256()
    while block := content.read(1 << 20):
        digest.update(block)
    return digest.hexdigest()


def list_files(folder, faults):
    """Names of all files below ``folder``.  None is read."""
    found = set()
    for path in sorted(folder.rglob("*")):
        name = path.relative_to(folder).as_posix()
        if path.is_symlink() or not (path.is_file() or path.is_dir()):
            faults.add(name, "is no ordinary file")
        elif path.is_file():
            found.add(name)
    return found


def read_text(path):
    """Content of a manifest or description; ``ValueError`` if it is not UTF-8 or too large to be
    one.
    """
    if path.stat().st_size > LARGEST_TEXT:
        raise ValueError(f"{path.name} is larger than {LARGEST_TEXT} bytes")
    return path.read_bytes().decode()


def read_json(path):
    return json.loads(read_text(path))


def read_manifest(path, faults):
    """SHA-256 by name from the lines of a manifest."""
    listed = {}
    try:
        lines = read_text(path).split("\n")
    except (OSError, ValueError):
        faults.add(path.name, "cannot be read")
        return listed
    for number, line in enumerate(lines[:-1], start=1):
        digest, gap, name = line[:DIGITS], line[DIGITS : DIGITS + 2], line[DIGITS + 2 :]
        if gap != "  " or not name or name in listed or set(digest) - set("0123456789abcdef"):
            faults.add(path.name, f"line {number} is damaged")
        listed[name] = digest
    if not listed or list(listed) != sorted(listed) or lines[-1]:
        faults.add(path.name, "is damaged")
    return listed


def check_bag(folder, found, faults):
    """BagIt: every file is listed with its sum, and nothing else is there."""
    payload = {name for name in found if name.startswith("data/")}
    tags = {name for name in found if name not in payload and not name.startswith("tagmanifest-")}
    for kind, present in (("tagmanifest", tags), ("manifest", payload)):
        listed = read_manifest(folder / f"{kind}-sha256.txt", faults)
        for name in sorted(listed.keys() | present):
            if name not in found:
                faults.add(name, "is missing")
            elif name not in listed:
                faults.add(name, "is not part of the archive")
            else:
                check_file(folder / name, name, listed[name], faults)
    for name in sorted(TAG_FILES ^ (found - payload)):
        faults.add(name, "is not part of the archive" if name in found else "is missing")


def check_file(path, name, listed, faults):
    """A file that is listed has the SHA-256 ``listed``."""
    try:
        if sha256(path) != listed:
            faults.add(name, "is changed")
    except OSError as error:
        faults.add(name, f"cannot be read ({error.strerror})")


def check_names(found, faults):
    """Every system can unpack all files, each to a place of its own."""
    places = {}
    for name in sorted(found):
        other = places.setdefault(name.casefold(), name)
        if other != name:
            faults.add(name, f"is {other} on some systems")
        if not all(map(PORTABLE.fullmatch, name.split("/"))):
            faults.add(name, "has a name that not every system can write")


def check_declarations(folder, found, faults):
    """The bag's declaration, and the size and number of files in its description."""
    if read_text(folder / "bagit.txt") != BAG_DECLARATION:
        faults.add("bagit.txt", "is not the declaration of BagIt 1.0")
    sizes = [(folder / name).stat().st_size for name in found if name.startswith("data/")]
    payload = f"\nPayload-Oxum: {sum(sizes)}.{len(sizes)}\n"
    if payload not in read_text(folder / "bag-info.txt"):
        faults.add("bag-info.txt", "gives another size of the payload")


def check_tables(data, found, faults):
    """table-schemas.json: describes the columns of every CSV file among the products."""
    schemas = read_json(data / TABLE_SCHEMAS)
    products = (name.removeprefix("data/") for name in found if is_product(name))
    tables = {path for path in products if path.endswith(".csv")}
    for path in sorted(schemas.keys() ^ tables):
        faults.add(f"data/{path}", f"is in only one of {TABLE_SCHEMAS} and the archive")
    for path in sorted(schemas.keys() & tables):
        check_table(data / path, schemas[path]["fields"], f"data/{path}", faults)


def is_product(name):
    """Whether ``name`` lies in a folder of products."""
    top, *folders = name.split("/")[:-1] or [""]
    return top == "data" and bool(folders) and folders[0] not in NO_PRODUCTS


def check_table(path, fields, name, faults):
    """Check that a CSV file has the columns described, and that its numbers are numbers."""
    numbers = [index for index, field in enumerate(fields) if field["type"] == "number"]
    with open(path, encoding="utf-8", newline="") as file:
        rows = csv.reader(iter(lambda: file.readline(LONGEST_LINE), ""))
        header = next(rows)
        if header != [field["name"] for field in fields]:
            faults.add(name, f"has other columns than {TABLE_SCHEMAS} describes")
        for row in rows:
            if len(row) != len(header):
                faults.add(name, "has rows of unequal length")
            for index in numbers:
                if row[index]:
                    float(row[index])


def check_crate(folder, found, faults):
    """ro-crate-metadata.json: describes every file but those of the bag itself, and no other."""
    graph = read_json(folder / METADATA)["@graph"]
    described = {unquote(entity["@id"]) for entity in graph if "File" in entity["@type"]}
    for path in sorted(described ^ (found - OF_BAG - {METADATA})):
        faults.add(path, f"is in only one of {METADATA} and the archive")


def check_pages(folder, found, faults):
    """Pages and drawings among the products load nothing from elsewhere."""
    for name in sorted(filter(is_product, found)):
        if name.endswith(".html") and not PAGE_BEGINS.match(read_text(folder / name)):
            faults.add(name, "may load what lies elsewhere")
        if name.endswith(".svg") and drawing_loads(read_text(folder / name)):
            faults.add(name, "may load what lies elsewhere")


def drawing_loads(text):
    """Whether an SVG drawing runs a program, or loads anything but pictures that lie in it."""
    words = []
    for element in ElementTree.fromstring(text).iter():
        space, _, tag = element.tag.rpartition("}")
        if f"{space}}}" == XHTML:
            return True
        words.append(f"<{tag}")
        words += [f"{key.rpartition('}')[2]}={value}" for key, value in element.items()]
        if tag == "style":
            words.append("".join(element.itertext()))
    return "<?xml-stylesheet" in text or any(map(DRAWING_LOADS.search, words))


def check_datasets(folder, found, count, seed, faults):
    """Content and numbers of every dataset; in words, what was checked and how well."""
    recompute = own_module("recompute")
    content_sha256 = own_module("content_hash").content_sha256
    listed = read_json(folder / CONTENT_SUMS)
    config = read_json(folder / CONFIGURATION)
    inputs = read_json(folder / INPUTS)
    prefix = "data/datasets/"
    present = {name.removeprefix(prefix) for name in found if name.startswith(prefix)}
    present.remove(Path(CONTENT_SUMS).name)
    configured = {f"{name}.nc" for name in config["scenes"]}
    of_paper = {name for name in configured if name.startswith("fig")}
    outcomes = []
    for name in sorted(of_paper | listed.keys() | present):
        place = f"{prefix}{name}"
        if name not in present:
            faults.add(place, "is missing")
        elif name not in configured:
            faults.add(place, f"is not in {CONFIGURATION}")
        elif name not in listed:
            faults.add(place, f"is not in {CONTENT_SUMS}")
        else:
            rng = random.Random(f"{seed} {name}")
            try:
                outcome = recompute.check(folder / place, config, inputs, count, rng)
                if outcome.has_form and content_sha256(folder / place) != listed[name]:
                    faults.add(place, f"has another content than {CONTENT_SUMS} says")
            except Exception as error:
                faults.add(place, f"cannot be recomputed ({type(error).__name__}: {error})")
                continue
            outcomes.append(outcome)
            if outcome.findings:
                faults.add(place, f"{outcome.findings[0]} ({len(outcome.findings)} such findings)")
    rtol = max((outcome.rtol for outcome in outcomes), default=0.0)
    worst = max([SHOWN_DEVIATION, *(outcome.worst for outcome in outcomes)])
    return (
        f"{len(outcomes)} datasets, {sum(o.evaluated for o in outcomes)} points that fulfil the "
        f"equations, {sum(o.solved for o in outcomes)} of them solved again within {worst:.0e} "
        f"(tolerance {recompute.SOLUTION:.0e} and the rtol of {rtol:.0e}, seed {seed})"
    )


def own_module(name):
    """A module of this folder.  Python searches it last, so that numpy is never taken from here."""
    if str(HERE) not in sys.path:
        sys.path.append(str(HERE))
    return importlib.import_module(name)


def check_packed(folder, found, faults):
    """The packed archive beside ``folder`` has the sum on record, and the bytes of `write_zip`.

    So no program unpacks anything else from it.
    """
    packed = packed_beside(folder)
    packed_sum = sha256(packed)
    if packed_sum != record_beside(folder)["archive"]["sha256"]:
        faults.add(packed, "is not the archive that its provenance names")
    with tempfile.TemporaryFile() as own:
        write_zip(folder, found, own)
        own.seek(0)
        if sha256_of(own) != packed_sum:
            faults.add(packed, "holds something else than the folder")


def write_zip(folder, names, file):
    """Write the files ``names`` of ``folder`` to the open ``file``, with the date of the bag.

    The same files make the same bytes.  They are not compressed, because compression depends on the
    version of its library.
    """
    (day,) = re.findall(r"^Bagging-Date: (.*)$", read_text(folder / "bag-info.txt"), re.MULTILINE)
    moment = (*date.fromisoformat(day).timetuple()[:3], 0, 0, 0)
    with zipfile.ZipFile(file, "w", zipfile.ZIP_STORED) as packed:
        for name in sorted(names):
            member = zipfile.ZipInfo(name, moment)
            member.create_system = UNIX
            member.external_attr = FILE_MODE
            packed.writestr(member, (folder / name).read_bytes())


def packed_beside(folder):
    return folder.with_name(f"{folder.name}.zip")


def record_beside(folder):
    return read_json(folder.with_name(f"{folder.name}-provenance.json"))


def verify(folder, count, seed, packed_too=False, sums_alone=False):
    """``Faults`` of the archive in ``folder``, and what was checked in words."""
    faults = Faults()
    found = list_files(folder, faults)
    data, counted = folder / "data", []
    sums = {
        "manifests": lambda: check_bag(folder, found, faults),
        "names": lambda: check_names(found, faults),
        "bag-info.txt": lambda: check_declarations(folder, found, faults),
    }
    contents = {
        f"data/{TABLE_SCHEMAS}": lambda: check_tables(data, found, faults),
        METADATA: lambda: check_crate(folder, found, faults),
        "pages": lambda: check_pages(folder, found, faults),
        "data/datasets": lambda: counted.append(check_datasets(folder, found, count, seed, faults)),
    }
    others = {}
    if packed_too:
        others[packed_beside(folder)] = lambda: check_packed(folder, found, faults)
    run_checks(sums | others, faults)
    if not faults and not sums_alone:
        run_checks(contents, faults)
    return faults, "; ".join([f"{len(found)} files with their SHA-256 sums", *counted])


def run_checks(checks, faults):
    """Call each check.  A check that fails is itself a fault of its subject."""
    for subject, check in checks.items():
        try:
            check()
        except Exception as error:
            faults.add(subject, f"cannot be checked ({type(error).__name__}: {error})")


def main(arguments=None):
    """Print the verdict in one line, and return the exit code."""
    parser = argparse.ArgumentParser(description=__doc__.partition("\n")[0])
    parser.add_argument(
        "folder", nargs="?", type=Path, default=HERE.parent, help="unpacked archive"
    )
    parser.add_argument("--seed", type=int, default=2024, help="of the choice of points")
    parser.add_argument("--points", type=int, default=100, help="solved again, in each dataset")
    parser.add_argument("--packed", action="store_true", help="compare the file beside it too")
    parser.add_argument("--sums", action="store_true", help="compare the sums of all files alone")
    given = parser.parse_args(arguments)
    warnings.simplefilter("ignore")  # one line is promised
    if not (given.folder / "bagit.txt").is_file():
        say(f"not whole: {given.folder}: bagit.txt is missing, so this is no archive")
        return 1
    archive = given.folder.resolve()
    sys.path[:] = [place for place in sys.path if not Path(place).resolve().is_relative_to(archive)]
    faults, checked = verify(given.folder, given.points, given.seed, given.packed, given.sums)
    name = archive.name
    if not faults:
        say(f"whole: {name}: {checked}")
        return 0
    shown = "; ".join(f"{path} {reason}" for path, reason in list(faults.items())[:SHOWN_FAULTS])
    more = len(faults) - SHOWN_FAULTS
    say(f"not whole: {name}: {shown}" + (f"; and {more} more" if more > 0 else ""))
    return 1


def say(text):
    """Print one line.  Names come from the archive, so characters that could break the line, or
    that a terminal cannot show, are written as in Python."""
    print(text.encode("unicode_escape").decode("ascii"))


if __name__ == "__main__":
    sys.exit(main())
