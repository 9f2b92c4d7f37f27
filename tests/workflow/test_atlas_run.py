"""`snakemake atlas` on few points: its products, and a run that is killed and goes on."""

import csv
import json
import re

import yaml
from workspace import ROOT

import thirdbody as tb
from chenhorng.atlas.catalogue import open_atlas

SETTINGS = yaml.safe_load((ROOT / "config" / "atlas_minimal.yaml").read_text(encoding="utf-8"))
CHUNKS = [f"{number}-of-{SETTINGS['chunks']}" for number in range(1, SETTINGS["chunks"] + 1)]
# the library notes by a name of its own to how many digits it has rounded
WRITTEN_BY_NETCDF = re.compile(
    r"attribute \w+:_QuantizeGranularBitRoundNumberOfSignificantDigits\b"
)
PRODUCTS = {f"atlas/chunks/{chunk}.nc" for chunk in CHUNKS}


def test_what_was_solved_before_the_kill_is_not_solved_again(atlas_run):
    workspace, kept = atlas_run
    chunks = {file: stamp for file, stamp in kept.items() if file in PRODUCTS}
    assert 2 <= len(chunks) < len(CHUNKS)
    first = min(chunks, key=chunks.get)
    assert workspace.stamps()[first] == chunks[first]


def test_it_makes_its_products_and_no_others(atlas_run):
    assert set(atlas_run[0].stamps()) == PRODUCTS


def test_every_condition_is_solved_for_every_member(atlas_run):
    root = atlas_run[0].root
    with open_atlas(root / "results" / "atlas" / "chunks") as atlas:
        assert atlas["solution_status"].size == 9 * 4 * 6 * 3 * 2
        assert (atlas["solution_status"].values >= 0).all()
        members = json.loads(atlas.attrs["ensemble"])
    assert len(members) == len(tb.ensemble()) > 10
    for chunk in CHUNKS:
        record = (root / "logs" / "solve_chunk" / f"{chunk}.tsv").read_text(encoding="utf-8")
        (row,) = csv.DictReader(record.splitlines(), delimiter="\t")
        assert float(row["max_rss"]) < 1000


def test_cf_and_acdd_find_nothing_but_what_the_library_writes(findings_in, atlas_run, tmp_path):
    """In a chunk, and in all chunks together."""
    atlas = atlas_run[0].root / "results" / "atlas"
    with open_atlas(atlas / "chunks") as whole:
        whole.to_netcdf(tmp_path / "whole.nc")
    for path in (atlas / "chunks" / f"{CHUNKS[1]}.nc", tmp_path / "whole.nc"):
        found = findings_in(path)
        assert [text for text in found["CF"] if not WRITTEN_BY_NETCDF.match(text)] == []
        assert found["ACDD"] == []
