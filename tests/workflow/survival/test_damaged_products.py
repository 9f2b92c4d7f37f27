"""A damaged product is found by `make verify`, named and made again by the next run."""

import re
import shutil
from pathlib import Path

import pytest
from harm import (
    DAMAGE,
    LONG,
    assert_same,
    complete,
    ended,
    found_by_verify,
    obey_permissions,
    products,
    release_in,
    start,
)

ROUNDS = range(len(DAMAGE) if LONG else 1)
FEW = (
    "tables/table1.md",
    "figures/fig01.png",
    "tables/tpca_windows.tex",
    "figures/fig13.svg",
    "tables/table2.json",
)
UNRELEASED = ("extracted/", "accuracy/solver_cost/")  # what tables are gathered from
long = pytest.mark.skipif(not LONG, reason="make test-survival")


def assert_noticed(damaged, said):
    """The run names each product that is there and is not what was made."""
    assert not [
        product
        for product, kind in damaged.items()
        if kind != "deleted" and f"results/{product} is not as it was made" not in said
    ]


@pytest.mark.parametrize("number", ROUNDS)
def test_every_damaged_product_is_named_and_made_again(
    workspace, released, undisturbed, number, tell
):
    """In each round every product is damaged, in the next kind of damage in turn."""
    chosen = sorted(undisturbed) if LONG else FEW
    kinds = list(DAMAGE)
    damaged = {
        product: kinds[(place + number) % len(kinds)] for place, product in enumerate(chosen)
    }
    for product, kind in damaged.items():
        DAMAGE[kind](workspace.root / "results" / product)
    found = found_by_verify(workspace, release_in(released))
    assert set(found) == {f"results/{name}" for name in damaged if not name.startswith(UNRELEASED)}
    stamps = workspace.stamps()
    assert_noticed(damaged, complete(workspace, "--dry-run", prepare=obey_permissions))
    assert workspace.stamps() == stamps
    assert_noticed(damaged, complete(workspace, prepare=obey_permissions))
    assert_same(workspace.root / "results", undisturbed)
    assert found_by_verify(workspace, release_in(released)) == {}
    tell(
        f"round {number}: {len(damaged)} products damaged in {len(kinds)} kinds, {len(found)} of "
        "them released, all of these found by verify, all made again"
    )


def test_a_product_replaced_by_a_folder_is_made_again_unless_somebody_keeps_files_there(
    workspace, undisturbed
):
    product = workspace.root / "results/tables/table1.md"
    product.unlink()
    product.mkdir()
    (product / "kept").write_text("somebody's own")
    code, said = ended(start(workspace))
    assert code != 0
    assert "results/tables/table1.md is not as it was made" in said
    assert re.search(r"results/tables/table1.md, .+ cannot be written \(Is a directory\)", said)
    assert (product / "kept").read_text() == "somebody's own"
    (product / "kept").unlink()
    complete(workspace)
    assert_same(workspace.root / "results", undisturbed)


@long
def test_make_verify_names_each_file_of_the_release_that_cannot_be_read(released, tmp_path, tell):
    copy = Path(shutil.copytree(release_in(released).parent, tmp_path / "release"))
    folder = copy / release_in(released).name
    files = [path for path in copy.rglob("*") if path.is_file()]
    for path in files:
        path.chmod(0)
    found = found_by_verify(released, folder)
    packed, record = str(copy / f"{folder.name}.zip"), "provenance.json"
    inside = {path.relative_to(folder).as_posix() for path in files if folder in path.parents}
    assert found.keys() >= inside | {packed, record}
    tell(f"release: each of {len(files)} files named when unreadable")


@long
def test_no_damaged_product_is_released(released, tmp_path):
    """Neither one that differs from its record, nor one without a record."""
    workspace = released.copied_to(tmp_path / "thirdbody")
    whole = products(release_in(workspace))
    results = workspace.root / "results"
    for product, harm in zip(FEW, DAMAGE.values(), strict=True):
        harm(results / product)
    complete(workspace, "release", prepare=obey_permissions)
    assert products(release_in(workspace)) == whole

    (results / ".custody/figures/fig05.svg.sha256").unlink()
    DAMAGE["truncated to half"](results / "figures/fig05.svg")
    code, said = ended(start(workspace, "release"))
    assert code != 0
    assert "results/figures/fig05.svg is not known to be whole" in said
    complete(workspace, "--force", "results/figures/fig05.svg")
    complete(workspace, "release")
    assert products(release_in(workspace)) == whole
