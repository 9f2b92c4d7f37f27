"""`snakemake atlas` on few points: its products, and a run that is killed and goes on."""

import csv

import yaml
from workspace import ROOT

from chenhorng.atlas import open_atlas
from thirdbody.core.regimes import SOLUTION_STATUSES

SETTINGS = yaml.safe_load((ROOT / "config" / "minimal.yaml").read_text(encoding="utf-8"))["atlas"]
CHUNKS = [f"{roughness}nm" for roughness in SETTINGS["roughness_nm"]]
PRODUCTS = {f"atlas/chunks/{chunk}.nc" for chunk in CHUNKS}


def test_what_was_solved_before_the_kill_is_not_solved_again(atlas_run):
    workspace, kept = atlas_run
    chunks = {file: stamp for file, stamp in kept.items() if file in PRODUCTS}
    assert 2 <= len(chunks) < len(CHUNKS)
    first = min(chunks, key=chunks.get)
    assert workspace.stamps()[first] == chunks[first]


def test_it_makes_its_products_and_no_others(atlas_run):
    assert set(atlas_run[0].stamps()) == PRODUCTS


def test_every_condition_is_solved(atlas_run):
    root = atlas_run[0].root
    with open_atlas(root / "results" / "atlas" / "chunks") as atlas:
        assert atlas["solution_status"].size == 8 * 4 * 4 * 3 * 2
        assert set(atlas["solution_status"].values.ravel()) <= {*SOLUTION_STATUSES}
    for chunk in CHUNKS:
        record = (root / "logs" / "solve_chunk" / f"{chunk}.tsv").read_text(encoding="utf-8")
        (row,) = csv.DictReader(record.splitlines(), delimiter="\t")
        assert float(row["max_rss"]) < 1000


def test_cf_and_acdd_find_nothing(findings_in, atlas_run, tmp_path):
    """In a chunk, and in all chunks together."""
    atlas = atlas_run[0].root / "results" / "atlas"
    with open_atlas(atlas / "chunks") as whole:
        whole.to_netcdf(tmp_path / "whole.nc")
    for path in (atlas / "chunks" / f"{CHUNKS[1]}.nc", tmp_path / "whole.nc"):
        assert findings_in(path) == {"CF": [], "ACDD": []}
