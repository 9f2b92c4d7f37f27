"""Where the files of a run go, and what they are called in a release of it."""

from types import SimpleNamespace

import pytest

from thirdbody.data.files import whole
from thirdbody.run.custody import damaged_products, record_of
from thirdbody.run.jobs import jobs_behind
from thirdbody.run.places import Places

PLAIN, SOFT = Places.of_run(None), Places.of_run("soft")


class Rule(SimpleNamespace):
    """A rule as Snakemake holds it, of one job."""

    params, script = {}, "rule.py"

    def is_producer(self, path):
        return path in self.outputs

    def get_wildcards(self, path):
        return {}

    def expand_input(self, wildcards):
        return Names(self.inputs), None

    def expand_output(self, wildcards):
        return self.outputs, None


class Names(list):
    """Inputs without modules."""

    def get(self, name, otherwise):
        return otherwise


def test_a_run_without_a_name_writes_where_all_runs_did():
    assert tuple(map(str, vars(PLAIN).values())) == (
        "results",
        "logs",
        ".snakemake/thirdbody.lock",
    )


def test_all_of_a_named_run_is_below_its_folder():
    assert all(str(place).startswith("results/soft") for place in vars(SOFT).values())


@pytest.mark.parametrize("places", [PLAIN, SOFT], ids=["without a name", "named"])
def test_a_release_calls_products_alike_whatever_the_run(places):
    table = str(places.products / "tables/table1.csv")
    part = str(places.products / "extracted/table1/all.csv")
    rules = [
        Rule(name="write", inputs=[part], outputs=[table]),
        Rule(name="compute", inputs=["config/paper_tables.yaml"], outputs=[part]),
    ]
    first, last = jobs_behind([table], rules, places)
    assert (first["rule"], last["rule"]) == ("compute", "write")
    assert first["inputs"] == ["config/paper_tables.yaml"]
    assert first["outputs"] == last["inputs"] == ["results/extracted/table1/all.csv"]
    assert last["outputs"] == ["results/tables/table1.csv"]


def test_products_of_a_named_run_have_records_of_their_own(tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    for places in (PLAIN, SOFT):
        product = places.products / "tables/a.csv"
        product.parent.mkdir(parents=True)
        places.lock.parent.mkdir(parents=True)  # as a run does that begins
        with whole(product) as part:
            part.write_text("made")
        assert record_of(product) == places.products / ".custody/tables/a.csv.sha256"
        assert damaged_products(places.products) == []
        product.write_text("harmed")
        assert damaged_products(places.products) == [str(product)]
