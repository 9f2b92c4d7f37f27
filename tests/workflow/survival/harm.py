"""Ways to harm a run, and what must hold after it: the products of an undisturbed one."""

from __future__ import annotations

import csv
import ctypes
import hashlib
import io
import json
import os
import random
import signal
import subprocess
import sys
import time
from pathlib import Path

from workspace import Workspace, ended, is_product, start

from thirdbody.run.custody import SUFFIX
from thirdbody.run.places import CUSTODY

LONG = os.environ.get("SURVIVAL") == "long"  # `make test-survival`
MEASURED = ("seconds", "microseconds_per_point")  # columns of solver_cost, never the same twice
VERIFY = """
import json, sys
from pathlib import Path
sys.path.insert(0, "verification")
from verify import verify
print(json.dumps(verify(Path(sys.argv[1]), 0, 0, Path("results"))[0]))
"""
PR_CAPBSET_DROP, CAP_DAC_OVERRIDE, CAP_DAC_READ_SEARCH = 24, 1, 2


def complete(workspace: Workspace, *arguments, **options) -> str:
    """What a run says that must succeed."""
    code, said = ended(start(workspace, *arguments, **options))
    assert code == 0, said
    return said


def release_in(workspace: Workspace) -> Path:
    """The folder of the release in a workspace."""
    (folder,) = workspace.root.glob("results/release/*/")
    return folder


def found_by_verify(workspace: Workspace, release: Path) -> dict[str, str]:
    """All that `make verify` finds wrong with a release or with the products: it shows five."""
    told = subprocess.run(
        [sys.executable, "-c", VERIFY, release],
        cwd=workspace.root,
        capture_output=True,
        text=True,
        check=True,
        preexec_fn=obey_permissions,
    )
    return json.loads(told.stdout)


def obey_permissions() -> None:
    """Take from this process, and those it starts, root's right to pass over file permissions."""
    if os.geteuid() == 0:
        for capability in (CAP_DAC_OVERRIDE, CAP_DAC_READ_SEARCH):
            assert ctypes.CDLL(None).prctl(PR_CAPBSET_DROP, capability, 0, 0, 0) == 0


def jobs_begun(workspace: Workspace) -> int:
    """Jobs of a run that have a log."""
    return sum(1 for _ in workspace.root.glob("logs/**/*.log"))


def kill(run: subprocess.Popen, whole_group: bool) -> None:
    """End a run by SIGKILL: all its processes, or only the first, whose jobs live on."""
    (os.killpg if whole_group else os.kill)(run.pid, signal.SIGKILL)
    if whole_group:
        run.communicate(timeout=60)
    else:
        run.stdout.close()
        run.wait(60)


def kill_at(
    workspace: Workspace, jobs: int, chance: random.Random, *arguments, whole_group=True, **options
) -> bool:
    """Start a run and kill it soon after ``jobs`` jobs have begun; False if it ended before."""
    run = start(workspace, *arguments, **options)
    while jobs_begun(workspace) < jobs and run.poll() is None:
        time.sleep(0.02)
    time.sleep(chance.uniform(0.0, 1.0))
    alive = run.poll() is None
    kill(run, whole_group) if alive else run.communicate()
    return alive


def products(root: Path) -> dict[str, bytes]:
    """Content of each product under ``root``, without what the clock wrote into it."""
    files = (path for path in sorted(root.rglob("*")) if is_product(path))
    return {str(path.relative_to(root)): _lasting(path) for path in files}


def _lasting(path: Path) -> bytes:
    content = path.read_bytes()
    if "solver_cost" not in str(path):
        return content
    rows = csv.DictReader(io.StringIO(content.decode()))
    kept = [{name: row[name] for name in row if name not in MEASURED} for row in rows]
    return repr(kept).encode()


def assert_same(root: Path, undisturbed: dict[str, bytes]) -> None:
    """Every product under ``root`` is there, byte for byte that of ``undisturbed``; no others.

    Each has a record that says what it is.
    """
    found = products(root)
    assert set(found) == set(undisturbed)
    assert not [name for name in found if found[name] != undisturbed[name]]
    assert not [name for name in found if not _is_recorded(root, name)]


def _is_recorded(root: Path, name: str) -> bool:
    digest = hashlib.sha256((root / name).read_bytes()).hexdigest()
    record = root / CUSTODY / f"{name}{SUFFIX}"
    return record.read_text(encoding="utf-8") == f"{digest}  results/{name}\n"


def _overwrite(change):
    return lambda product: product.write_bytes(change(product.read_bytes()))


DAMAGE = {
    "truncated to half": _overwrite(lambda content: content[: len(content) // 2]),
    "truncated to zero": _overwrite(lambda content: b""),
    "overwritten": _overwrite(lambda content: random.Random(0).randbytes(len(content))),
    "unreadable": lambda product: product.chmod(0),
    "deleted": lambda product: product.unlink(),
}
