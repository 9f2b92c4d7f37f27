"""Records of products, and products that are not what was made."""

import hashlib
import os
import subprocess
from pathlib import Path

import pytest

from thirdbody.data.files import whole
from thirdbody.run.custody import damaged_products, record_of, require_recorded

ROOT = Path(__file__).resolve().parents[2]


@pytest.fixture
def made(tmp_path, monkeypatch):
    """A folder in which a job made two products."""
    monkeypatch.chdir(tmp_path)
    (tmp_path / "results/tables").mkdir(parents=True)
    make("made")
    return tmp_path


def make(content):
    with whole("results/a.csv", "results/tables/b.csv") as parts:
        for part in parts:
            part.write_text(content)


def truncate(record):
    record.write_text(record.read_text()[:40])


def turn_into_binary(record):
    record.write_bytes(b"\xff\x00")


DAMAGE = {
    "overwritten": lambda product: product.write_text("harmed"),
    "truncated": lambda product: product.write_text(""),
    "a folder": lambda product: (product.unlink(), product.mkdir()),
    "a dangling link": lambda product: (product.unlink(), product.symlink_to("nowhere")),
}


def test_a_product_is_recorded_as_it_was_made(made):
    digest = hashlib.sha256(b"made").hexdigest()
    for product in ("results/a.csv", "results/tables/b.csv"):
        assert record_of(product).read_text() == f"{digest}  {product}\n"


def test_make_sums_names_what_differs(made):
    def check():
        command = ["make", "--no-print-directory", "--file", ROOT / "Makefile", "sums"]
        return subprocess.run(command, capture_output=True, text=True)

    assert (check().returncode, check().stdout) == (0, "")
    (made / "results/a.csv").write_text("harmed")
    assert check().returncode != 0
    assert check().stdout == "results/a.csv: FAILED\n"
    assert "results/tables" not in check().stderr


@pytest.mark.parametrize("harm", DAMAGE.values(), ids=DAMAGE)
def test_what_differs_from_its_record_is_damaged_and_left_where_it_is(made, harm):
    assert damaged_products() == []
    harm(made / "results/a.csv")
    (made / "results/unrecorded.csv").write_text("somebody's own")
    names = sorted(os.listdir("results"))
    assert damaged_products() == ["results/a.csv"]
    assert sorted(os.listdir("results")) == names


def test_what_cannot_be_read_is_damaged(made):
    (made / "results/a.csv").chmod(0)
    if os.access("results/a.csv", os.R_OK):
        pytest.skip("root reads everything")
    assert damaged_products() == ["results/a.csv"]


def test_what_was_deleted_is_missing_and_not_damaged(made):
    (made / "results/a.csv").unlink()
    assert damaged_products() == []


def test_what_is_made_anew_is_whole_again(made):
    (made / "results/a.csv").write_text("harmed")
    make("made anew")
    assert damaged_products() == []
    require_recorded(["results/a.csv", "results/tables/b.csv"])


@pytest.mark.parametrize("harm", [truncate, turn_into_binary])
def test_a_damaged_record_says_that_its_product_is(made, harm):
    harm(record_of("results/a.csv"))
    assert damaged_products() == ["results/a.csv"]
    make("made")
    assert damaged_products() == []


@pytest.mark.parametrize("renamed", range(4))
def test_a_process_killed_while_products_take_their_places_leaves_none_unnoticed(
    made, monkeypatch, renamed
):
    """After any number of renames, what is new is recorded and what is old differs."""
    replace, left = os.replace, iter(range(renamed))

    def killed(part, place):
        if next(left, None) is None:
            raise KeyboardInterrupt
        replace(part, place)

    with monkeypatch.context() as patch:
        patch.setattr(os, "replace", killed)
        with pytest.raises(KeyboardInterrupt):
            make("made anew")
    products = ("results/a.csv", "results/tables/b.csv")
    new = {product for product in products if (made / product).read_text() == "made anew"}
    assert not new & set(damaged_products())
    assert len(new) == max(0, renamed - 2)


def test_a_product_without_a_record_is_named_with_the_command_that_remakes_it(made):
    require_recorded(["results/a.csv", "results/tables/b.csv"])
    (made / "results/unrecorded.csv").write_text("somebody's own")
    (made / "results/tables/b.csv").write_text("harmed")
    for product in ("results/unrecorded.csv", "results/tables/b.csv", "results/absent.csv"):
        with pytest.raises(ValueError, match=f"^{product} .*; remake it: .* --force {product}$"):
            require_recorded(["results/a.csv", product])
