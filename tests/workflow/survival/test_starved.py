"""No room, no right to write: a clear line, and nothing is harmed."""

import os
import re
import subprocess

import pytest
from harm import LONG, assert_same, complete, ended, obey_permissions, products, start
from workspace import SNAKEMAKE

NAMESPACE = ("unshare", "--mount", *(() if os.geteuid() == 0 else ("--map-root-user",)))
# runs in a disk of its own: little room, what it left, more room, what it left
ON_A_SMALL_DISK = """
set -eu
room=$1 disk=$2 sources=$3 kept=$4
shift 4
mount -t tmpfs -o size="$room"k none "$disk"
cp -R "$sources"/. "$disk"
cd "$disk"
export PYTHONPATH="$disk"/src
code=0
"$@" > "$kept"/full.txt 2>&1 || code=$?
echo $code > "$kept"/code
cp -R results "$kept"/early
mount -o remount,size=1G "$disk"
"$@" > "$kept"/roomy.txt 2>&1
cp -R results "$kept"/late
"""
long = pytest.mark.skipif(not LONG, reason="make test-survival")


def may_mount() -> bool:
    try:
        return subprocess.run([*NAMESPACE, "true"], capture_output=True).returncode == 0
    except FileNotFoundError:
        return False


@long
@pytest.mark.skipif(not may_mount(), reason="no mount namespace here")
@pytest.mark.parametrize("room", [500, 2500])
def test_a_full_disk_is_named_and_the_run_completes_when_it_has_room(
    sources, undisturbed, tmp_path, room, tell
):
    """The disk holds the whole repository: Snakemake's own files do not fit either, which it says
    itself.
    """
    disk, kept = tmp_path / "disk", tmp_path / "kept"
    disk.mkdir()
    kept.mkdir()
    files = [path for path in sources.root.rglob("*") if path.is_file()]
    needed = sum(-(-path.stat().st_size // 4096) * 4 for path in files)
    given = str(needed + room), disk, sources.root, kept
    command = [*NAMESPACE, "sh", "-c", ON_A_SMALL_DISK, "sh", *given, *SNAKEMAKE]
    ran = subprocess.run(command, capture_output=True, text=True)
    said = (kept / "full.txt").read_text(errors="replace")
    assert ran.returncode == 0, ran.stderr + said + (kept / "roomy.txt").read_text()
    assert (kept / "code").read_text() != "0\n"
    assert re.search(r"(results|logs)/\S+ cannot be written \(", said) or "No space left" in said
    early = products(kept / "early")
    assert not [name for name in early if undisturbed.get(name) != early[name]]
    assert_same(kept / "late", undisturbed)
    tell(f"disk full after {len(early)} of {len(undisturbed)} products, {room} kB")


@long
def test_a_folder_that_may_not_be_written_to_is_named(workspace, undisturbed, tell):
    results = workspace.root / "results"
    (results / "tables/table1.tex").unlink()
    folders = [results, *(path for path in results.rglob("*") if path.is_dir())]
    for folder in folders:
        folder.chmod(0o555)
    code, said = ended(start(workspace, prepare=obey_permissions))
    for folder in folders:
        folder.chmod(0o755)
    assert code != 0
    assert "Write-protected output files" in said
    kept = products(workspace.root / "results")
    assert not [name for name in kept if kept[name] != undisturbed[name]]
    complete(workspace)
    assert_same(workspace.root / "results", undisturbed)
    tell(f"read-only results: {len(kept)} products as they were")
