"""A release: valid in each of its formats, and the same bytes wherever it is made."""

import dataclasses
import filecmp
import json
import os
import re
import shutil
import subprocess
import sys
import zipfile
from html import unescape
from importlib.resources import files
from pathlib import Path
from types import SimpleNamespace

import bagit
import jsonschema
import netCDF4
import pytest
import yaml
from markdown_it import MarkdownIt
from rocrate_validator.models import Severity
from rocrate_validator.services import ValidationSettings, validate
from rocrate_validator.utils.http import HttpRequester
from small_release import SCENES

from chenhorng.archive.crate import METADATA, OF_BAG, WORKFLOW
from chenhorng.archive.descriptions import describe_content, schema_of
from chenhorng.archive.files import files_in, render, render_json, source_files
from chenhorng.tables import DRAWN_POINTS, TABLES, table_schema, write_csv
from thirdbody.core.particles import mean_and_largest

ROOT = Path(__file__).resolve().parents[2]
SCHEMAS = ROOT / "tests" / "schemas"
FOLDERS = ("datasets", "tables", "figures")


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


def test_each_link_of_a_page_leads_into_the_archive(built):
    pages = sorted(built.glob("data/**/*.html"))
    assert built / "data/index.html" in pages and len(pages) == 2
    for page in pages:
        (link,) = re.findall(r'href="([^"]+)"', page.read_text(encoding="utf-8"))
        assert (page.parent / link).is_file()


def test_the_guide_calls_the_particle_size_a_label(built, defaults):
    guide = (built / "README.md").read_text(encoding="utf-8")
    mean, largest = mean_and_largest(1.0, defaults.best)
    assert "mean diameter" not in guide
    assert f"the mean of the sizes is {mean:.3g} x_a, the largest, X_max, {largest:.3g} x_a" in (
        guide.replace("\\", "")
    )


def test_each_table_has_its_schema_once(built):
    schemas = read_json(built / "data" / "table-schemas.json")
    assert schemas == {
        "figures/fig03.csv": table_schema(DRAWN_POINTS),
        "tables/tpca_windows.csv": table_schema(TABLES["tpca_windows"]),
    }
    field = {"name": "diameter_over_roughness", "type": "number"}
    (found,) = (
        f for f in schemas["tables/tpca_windows.csv"]["fields"] if f["name"] == field["name"]
    )
    assert field.items() <= found.items() and found["description"].endswith(" [1]")


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
@pytest.mark.parametrize("profile", ["ro-crate-1.1", "workflow-ro-crate-1.0"])
def test_crate_is_valid(built, terms, monkeypatch, profile):
    answer = SimpleNamespace(status_code=200, headers={"Content-Type": "application/ld+json"})
    answer.json = lambda: terms
    monkeypatch.setattr(HttpRequester, "get", lambda *_, **__: answer, raising=False)
    found = validate(
        ValidationSettings(
            rocrate_uri=str(built),
            profile_identifier=profile,
            requirement_severity=Severity.REQUIRED,
        )
    )
    assert found.passed(), [issue.message for issue in found.get_issues()]


def test_crate_describes_each_file_and_a_workflow_that_others_can_import(built):
    graph = {entity["@id"]: entity for entity in read_json(built / METADATA)["@graph"]}
    described = {name for name, entity in graph.items() if "File" in entity["@type"]}
    assert described == set(files_in(built, built)) - {METADATA, *OF_BAG}
    profiles = {profile["@id"] for profile in graph[METADATA]["conformsTo"]}
    assert profiles == {
        "https://w3id.org/ro/crate/1.1",
        "https://w3id.org/workflowhub/workflow-ro-crate/1.0",
    }
    assert graph["README.md"]["encodingFormat"] == "text/markdown"
    assert graph["./"]["mainEntity"] == {"@id": WORKFLOW}
    workflow = graph[WORKFLOW]
    assert {"File", "SoftwareSourceCode", "ComputationalWorkflow"} == set(workflow["@type"])
    assert graph[workflow["programmingLanguage"]["@id"]]["name"] == "Snakemake"
    with zipfile.ZipFile(built.with_name(f"{built.name}.zip")) as packed:
        assert {METADATA, WORKFLOW} <= set(packed.namelist())


def test_every_reference_in_the_crate_leads_somewhere(built):
    graph = read_json(built / METADATA)["@graph"]
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


def test_codemeta_says_what_the_citation_says(built, release):
    described = read_json(built / "data" / "codemeta.json")
    assert (described["@context"], described["@type"]) == (
        "https://w3id.org/codemeta/3.0",
        "SoftwareSourceCode",
    )
    assert (described["version"], described["datePublished"]) == (release.version, release.date)
    assert described["author"] == [
        {"@type": "Organization", "name": author["name"]} for author in release.citation["authors"]
    ]
    assert described["codeRepository"] == release.citation["repository-code"]
    assert described["referencePublication"]["@id"] == release.paper_url
    assert not (ROOT / ".zenodo.json").exists(), "Zenodo would ignore CITATION.cff"


def test_persons_are_authors_by_their_names(release):
    cited = release.citation | {"authors": [{"given-names": "Ada", "family-names": "Byron"}]}
    by_a_person = dataclasses.replace(release, citation=cited)
    assert by_a_person.authors == ["Ada Byron"]
    described = render_json("codemeta.json", release=by_a_person)
    assert described["author"] == [{"@type": "Person", "name": "Ada Byron"}]
    assert "Source-Organization: Ada Byron\n" in render(
        "bag-info.txt", release=by_a_person, oxum="1.1"
    )


def test_sources_are_what_git_tracks(tmp_path, monkeypatch, needs_git):
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
    content = describe_content(data, dict.fromkeys(FOLDERS, "title"))
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
