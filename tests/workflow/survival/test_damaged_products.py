"""A damaged product is named and made again by the next run."""

import pytest
from harm import DAMAGE, LONG, assert_same, complete, obey_permissions

ROUNDS = range(len(DAMAGE) if LONG else 1)
FEW = (
    "tables/table1.md",
    "figures/fig01.png",
    "tables/tpca_windows.tex",
    "figures/fig13.svg",
    "tables/table2.json",
)


def assert_noticed(damaged, said):
    """The run names each product that is there and is not what was made."""
    assert not [
        product
        for product, kind in damaged.items()
        if kind != "deleted" and f"results/{product} is not as it was made" not in said
    ]


@pytest.mark.parametrize("number", ROUNDS)
def test_every_damaged_product_is_named_and_made_again(workspace, undisturbed, number, tell):
    """In each round every product is damaged, in the next kind of damage in turn."""
    chosen = sorted(undisturbed) if LONG else FEW
    kinds = list(DAMAGE)
    damaged = {
        product: kinds[(place + number) % len(kinds)] for place, product in enumerate(chosen)
    }
    for product, kind in damaged.items():
        DAMAGE[kind](workspace.root / "results" / product)
    said = complete(workspace, prepare=obey_permissions)
    assert_noticed(damaged, said)
    assert_same(workspace.root / "results", undisturbed)
    tell(f"round {number}: {len(damaged)} products damaged in {len(kinds)} kinds, all made again")


def test_a_product_replaced_by_a_folder_stops_the_run_with_its_name(workspace):
    product = workspace.root / "results/tables/table1.md"
    product.unlink()
    product.mkdir()
    run = workspace.snakemake()
    assert run.returncode != 0
    assert "results/tables/table1.md" in run.stderr.splitlines()[-1]
