"""A release: valid in each of its formats, and the same bytes wherever it is made."""

import filecmp
import json
import os
import re
import shutil
import subprocess
import sys
from html import unescape
from importlib.resources import files
from pathlib import Path
from types import SimpleNamespace

import bagit
import frictionless
import jsonschema
import netCDF4
import pytest
import yaml
from markdown_it import MarkdownIt
from rocrate_validator.models import Severity
from rocrate_validator.services import ValidationSettings, validate
from rocrate_validator.utils.http import HttpRequester
from small_release import SCENES

from chenhorng.archive.descriptions import describe_content, schema_of
from chenhorng.archive.files import files_in, render, source_files
from chenhorng.tables import TABLES, write_csv

ROOT = Path(__file__).resolve().parents[2]
SCHEMAS = ROOT / "tests" / "schemas"
KINDS = ("datasets", "tables", "figures")


@pytest.fixture(scope="module", autouse=True)
def in_root():
    """The paths of sources are relative to the root of the repository."""
    before = Path.cwd()
    os.chdir(ROOT)
    yield
    os.chdir(before)


def read_json(path):
    return json.loads(path.read_text(encoding="utf-8"))


def test_bag_is_valid(built):
    bagit.Bag(str(built)).validate()


def test_data_package_is_valid_and_holds_every_product(built):
    report = frictionless.validate(str(built / "data" / "datapackage.json"))
    assert report.valid, report.flatten(["title", "message"])
    package = read_json(built / "data" / "datapackage.json")
    described = {resource["path"] for resource in package["resources"]}
    assert described == {
        name for kind in KINDS for name in files_in(built / "data" / kind, built / "data")
    }
    tables = [one for one in package["resources"] if one["type"] == "table"]
    assert {one["path"] for one in tables} == {"tables/tpca_windows.csv", "figures/fig03.csv"}


def test_a_table_that_nothing_describes_is_refused(tmp_path):
    (tmp_path / "odd.csv").write_text("a,b\n1,2\n")
    with pytest.raises(ValueError, match="odd.csv: nothing describes"):
        schema_of(tmp_path / "odd.csv")


def test_the_wide_table_of_a_figure_has_numbers_under_headings_of_its_own(tmp_path):
    names = ["A: load [1]", "A: film_thickness [1], nu = 0 cSt"]
    (tmp_path / "fig04_wide.csv").write_text('"' + '","'.join(names) + '"\n1e-7,2e-4\n')
    fields = schema_of(tmp_path / "fig04_wide.csv")["fields"]
    assert fields == [{"name": name, "type": "number"} for name in names]


def test_what_holds_a_table_for_programs_is_no_schema_of_it(tmp_path):
    write_csv(tmp_path / "claims.csv", [], TABLES["claims"])
    (tmp_path / "claims.json").write_text('{"statements": []}')
    names = [field["name"] for field in schema_of(tmp_path / "claims.csv")["fields"]]
    assert names == [column.name for column in TABLES["claims"]]


@pytest.fixture(scope="module")
def terms():
    """The vocabulary of RO-Crate, and of schema.org in it: the edition that ``rocrate`` ships.

    In that edition the terms of Bioschemas lie one folder deeper than in 1.1.
    """
    text = files("rocrate").joinpath("data/ro-crate.jsonld").read_text(encoding="utf-8")
    return json.loads(text.replace("https://bioschemas.org/terms/", "https://bioschemas.org/"))


@pytest.mark.filterwarnings("ignore:ConjunctiveGraph:DeprecationWarning")
def test_crate_is_valid(built, terms, monkeypatch):
    answer = SimpleNamespace(status_code=200, headers={"Content-Type": "application/ld+json"})
    answer.json = lambda: terms
    monkeypatch.setattr(HttpRequester, "get", lambda *_, **__: answer, raising=False)
    found = validate(
        ValidationSettings(
            rocrate_uri=str(built / "data"),
            profile_identifier="ro-crate-1.1",
            requirement_severity=Severity.REQUIRED,
        )
    )
    assert found.passed(), [issue.message for issue in found.get_issues()]


def test_every_reference_in_the_crate_leads_somewhere(built):
    graph = read_json(built / "data" / "ro-crate-metadata.json")["@graph"]
    known = {entity["@id"] for entity in graph}
    assert len(known) == len(graph)
    references = re.findall(r'\{"@id": "([^"]+)"\}', json.dumps(graph))
    assert {one for one in references if not one.startswith("http")} <= known


@pytest.mark.parametrize("place", ["repository", "archive"])
def test_citation_is_valid(built, place):
    folder = {"repository": ROOT, "archive": built / "data"}[place]
    schema = read_json(SCHEMAS / "citation-file-format-1.2.0.json")
    content = yaml.safe_load((folder / "CITATION.cff").read_text(encoding="utf-8"))
    jsonschema.Draft7Validator(schema).validate(content)


def test_zenodo_describes_the_same_release(built, release):
    zenodo = read_json(built / "data" / "zenodo.json")["metadata"]
    required = {"upload_type", "title", "creators", "description", "publication_date"}
    assert required | {"access_right", "license"} <= zenodo.keys()
    assert zenodo["version"] == release.version
    assert zenodo["publication_date"] == release.date
    assert [one["name"] for one in zenodo["creators"]] == [
        author["name"] for author in release.citation["authors"]
    ]
    assert not (ROOT / ".zenodo.json").exists(), "Zenodo would ignore CITATION.cff"


def test_sources_are_what_git_tracks(tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    for name in ("tracked.py", "new.py", "results/made.csv", ".gitignore", "docs/own name é.md"):
        (tmp_path / name).parent.mkdir(exist_ok=True)
        (tmp_path / name).write_text("/results/\n")
    expected = [".gitignore", "docs/own name é.md", "new.py", "tracked.py"]
    assert source_files() == expected, "without a repository"
    subprocess.run(["git", "init", "--quiet"], check=True)
    subprocess.run(["git", "add", "tracked.py", "docs"], check=True)
    assert source_files() == ["docs/own name é.md", "tracked.py"]
    (tmp_path / "tracked.py").unlink()
    assert source_files() == ["docs/own name é.md"]


def test_guide_names_every_dataset_quantity_and_column(built):
    guide = (built / "README.md").read_text(encoding="utf-8")
    with netCDF4.Dataset(built / "data/datasets/fig04.nc") as dataset:
        for name, variable in dataset.variables.items():
            assert f"| `{name}` | {variable.symbol} | {variable.units} |" in guide
        for name in json.loads(dataset.model_parameters):
            assert f"| `{name}` | " in guide
    words = *(f"`{name}.nc`" for name in SCENES), "`diameter_over_roughness`"
    assert all(word in guide for word in (*words, "verification/verify.py"))


@pytest.mark.parametrize(
    "title", ["a|b", "<script>alert(1)</script>", "[x](javascript:y)", "one\n\n# two", "`code` $x$"]
)
def test_the_title_of_a_dataset_is_no_markup_in_the_guide(built, tmp_path, release, title):
    data = shutil.copytree(built / "data", tmp_path / "data")
    with netCDF4.Dataset(data / "datasets/fig04.nc", "a") as dataset:
        dataset.title = title
    content = describe_content(data, dict.fromkeys(KINDS, "title"))
    guide = render("README.md", release=release, software={}, **content)
    (row,) = (line for line in guide.splitlines() if line.startswith("| `fig04.nc` |"))
    html = MarkdownIt("gfm-like", {"linkify": False}).render(f"| a | b |\n|---|---|\n{row}")
    cell = html.split("<td>")[2].partition("</td>")[0]
    assert "<" not in cell
    assert unescape(cell) == " ".join(title.split())


def test_same_bytes_under_another_locale_zone_seed_and_folder(built, tmp_path):
    environment = os.environ | {"TZ": "Pacific/Kiritimati", "PYTHONHASHSEED": "1"}
    environment |= {"LC_ALL": "C", "PYTHONUTF8": "0", "PYTHONCOERCECLOCALE": "0"}
    script = Path(__file__).with_name("small_release.py")
    subprocess.run([sys.executable, script, tmp_path / "there"], env=environment, check=True)
    again = tmp_path / "there" / built.name
    names = files_in(built, built)
    assert files_in(again, again) == names
    assert filecmp.cmpfiles(built, again, names, shallow=False) == (names, [], [])
    archives = (folder.with_name(f"{folder.name}.zip").read_bytes() for folder in (built, again))
    assert len(set(archives)) == 1
