"""A release against the validators of its formats, and the verification against damage."""

import ast
import csv
import filecmp
import json
import os
import random
import re
import shutil
import socket
import subprocess
import sys
import zipfile
from importlib.resources import files
from importlib.util import find_spec
from pathlib import Path
from runpy import run_path
from types import SimpleNamespace

import bagit
import frictionless
import jsonschema
import netCDF4
import numpy as np
import pytest
import yaml
from rocrate.rocrate import ROCrate
from rocrate_validator.models import Severity
from rocrate_validator.services import ValidationSettings, validate
from rocrate_validator.utils.http import HttpRequester
from small_release import SCENES, make_release

from thirdbody.dataset import RELEASE_DATE
from thirdbody.release.bag import files_in, seal
from thirdbody.release.citation import Release
from thirdbody.release.codecheck import codecheck_text, targets
from thirdbody.release.datapackage import data_package, table_schema
from thirdbody.release.provenance import provenance
from thirdbody.release.sources import source_files
from thirdbody.release.staging import whole_folder

ROOT = Path(__file__).resolve().parents[2]
VERIFICATION = ROOT / "verification"
SCHEMAS = ROOT / "tests" / "schemas"
KINDS = ("datasets", "tables", "figures")


@pytest.fixture(scope="module", autouse=True)
def in_root():
    """The paths of sources are relative to the root of the repository."""
    before = Path.cwd()
    os.chdir(ROOT)
    yield
    os.chdir(before)


@pytest.fixture(scope="module")
def built(tmp_path_factory):
    """The folder of a release; tests leave it as it is."""
    return make_release(tmp_path_factory.mktemp("release"))


@pytest.fixture
def copy(built, tmp_path):
    """A copy of the folder of a release, to damage."""
    return Path(shutil.copytree(built, tmp_path / built.name))


@pytest.fixture(scope="module")
def verify():
    """The program that checks an archive, as a module."""
    sys.path.insert(0, str(VERIFICATION))
    import verify

    yield verify
    sys.path.remove(str(VERIFICATION))


@pytest.fixture(scope="module")
def release():
    return Release.of(ROOT / "pyproject.toml", ROOT / "CITATION.cff")


def read_json(path):
    return json.loads(path.read_text(encoding="utf-8"))


# --- formats ---


def test_bag_is_valid(built):
    bag = bagit.Bag(str(built))
    bag.validate()
    assert set(bag.algorithms) == {"sha256", "sha512"}


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
        table_schema(tmp_path / "odd.csv")


@pytest.fixture(scope="module")
def terms():
    """The vocabulary of RO-Crate, and of schema.org in it: the edition that ``rocrate`` ships.

    In that edition the terms of Bioschemas lie one folder deeper than in 1.1.
    """
    text = files("rocrate").joinpath("data/ro-crate.jsonld").read_text(encoding="utf-8")
    return json.loads(text.replace("https://bioschemas.org/terms/", "https://bioschemas.org/"))


@pytest.mark.filterwarnings("ignore:ConjunctiveGraph:DeprecationWarning")
@pytest.mark.parametrize("profile", ["ro-crate-1.1", "workflow-run-crate-0.5"])
def test_crate_is_valid(built, terms, profile, monkeypatch):
    answer = SimpleNamespace(status_code=200, headers={"Content-Type": "application/ld+json"})
    answer.json = lambda: terms
    monkeypatch.setattr(HttpRequester, "get", lambda *_, **__: answer, raising=False)
    found = validate(
        ValidationSettings(
            rocrate_uri=str(built / "data"),
            profile_identifier=profile,
            requirement_severity=Severity.REQUIRED,
        )
    )
    assert found.passed(), [issue.message for issue in found.get_issues()]


def test_crate_says_who_made_what_from_what(built):
    crate = ROCrate(str(built / "data"))
    assert crate.mainEntity.id == "source/Snakefile"
    assert "ComputationalWorkflow" in crate.mainEntity.type
    metadata = read_json(built / "data" / "ro-crate-metadata.json")
    assert metadata["@context"] == "https://w3id.org/ro/crate/1.1/context"
    conforms = {one["@id"] for one in crate.root_dataset.as_jsonld()["conformsTo"]}
    assert "https://w3id.org/ro/wfrun/workflow/0.5" in conforms
    actions = crate.get_by_type("CreateAction")
    assert len(actions) == 1 + len(SCENES)
    assert [one for one in actions if one["instrument"].id == crate.mainEntity.id]
    made = {one["result"].id: one["instrument"].id for one in actions if one.id != "#run"}
    script = "source/workflow/scripts/compute_dataset.py"
    assert made == {f"datasets/{name}.nc": script for name in SCENES}
    software = {one["name"]: one["version"] for one in crate.get_by_type("SoftwareApplication")}
    assert {"numpy", "scipy", "snakemake"} <= software.keys()


def test_every_reference_in_the_crate_leads_somewhere(built):
    graph = read_json(built / "data" / "ro-crate-metadata.json")["@graph"]
    known = {entity["@id"] for entity in graph}
    assert len(known) == len(graph)
    local = {one for one in references(graph) if not one.startswith("http")}
    assert local <= known


def references(value):
    """Every ``@id`` that is referred to in ``value``."""
    if isinstance(value, dict):
        if set(value) == {"@id"}:
            yield value["@id"]
        value = list(value.values())
    if isinstance(value, list):
        for item in value:
            yield from references(item)


@pytest.mark.parametrize("place", ["repository", "archive"])
def test_citation_is_valid(built, place):
    folder = {"repository": ROOT, "archive": built / "data"}[place]
    schema = read_json(SCHEMAS / "citation-file-format-1.2.0.json")
    content = yaml.safe_load((folder / "CITATION.cff").read_text(encoding="utf-8"))
    jsonschema.Draft7Validator(schema).validate(content)


def test_codemeta_speaks_in_its_own_terms(built, terms):
    """CodeMeta 3.0 takes its terms from schema.org, but for a few such as this one."""
    known = terms["@context"].keys() | {"@context", "@type", "referencePublication"}
    codemeta = read_json(built / "data" / "codemeta.json")
    assert codemeta["@context"] == "https://w3id.org/codemeta/3.0"
    assert codemeta["@type"] == "SoftwareSourceCode"
    used = [codemeta, codemeta["referencePublication"]]
    used += codemeta["author"] + codemeta["softwareRequirements"]
    assert {key for part in used for key in part} <= known
    assert {part["@type"] for part in used} <= known


def test_codemeta_and_zenodo_describe_the_same_release(built, release):
    codemeta = read_json(built / "data" / "codemeta.json")
    zenodo = read_json(built / "data" / "zenodo.json")["metadata"]
    required = {"upload_type", "title", "creators", "description", "publication_date"}
    assert required | {"access_right", "license"} <= zenodo.keys()
    assert zenodo["version"] == codemeta["version"] == release.version
    assert zenodo["publication_date"] == codemeta["datePublished"] == release.date
    assert [one["name"] for one in zenodo["creators"]] == release.authors
    assert not (ROOT / ".zenodo.json").exists(), "Zenodo would ignore CITATION.cff"


def test_datasets_are_dated_as_the_release(release):
    assert release.date == RELEASE_DATE


@pytest.mark.skipif(not (ROOT / ".git").exists(), reason="not a clone")
def test_the_sources_are_the_repository():
    def listed(*options):
        told = subprocess.run(["git", "ls-files", *options], capture_output=True, text=True)
        return {name for name in told.stdout.splitlines() if Path(name).exists()}

    kept = listed()
    assert kept <= set(source_files())
    assert set(source_files()) <= kept | listed("--others", "--exclude-standard")


def test_codecheck_lists_the_targets_of_the_workflow(release):
    text = (ROOT / "codecheck.yml").read_text(encoding="utf-8")
    products = targets(ROOT / "Snakefile")
    assert len(products) > 20
    renew = "renew it: python -m thirdbody.release.codecheck > codecheck.yml"
    assert text == codecheck_text(products, release), renew
    content = yaml.safe_load(text)
    assert text.startswith("---\n")
    compared = {item["file"].rpartition(".")[0] for item in content["manifest"]}
    assert compared == {name.rpartition(".")[0] for name in products}
    assert all(author["name"] for author in content["paper"]["authors"])


def test_guide_names_every_dataset_quantity_and_column(built):
    guide = (built / "README.md").read_text(encoding="utf-8")
    with netCDF4.Dataset(built / "data/datasets/fig04.nc") as dataset:
        for name, variable in dataset.variables.items():
            assert f"| `{name}` | {variable.symbol} | {variable.units} |" in guide
        for name in json.loads(dataset.model_parameters):
            assert f"| `{name}` | " in guide
    for word in (*(f"`{name}.nc`" for name in SCENES), "`diameter_over_roughness`", "verification/verify.py"):
        assert word in guide


def test_versions_that_differ_are_refused(tmp_path):
    text = (
        (ROOT / "CITATION.cff").read_text(encoding="utf-8").replace("\nversion: ", "\nversion: 9")
    )
    (tmp_path / "CITATION.cff").write_text(text, encoding="utf-8")
    with pytest.raises(ValueError, match="version is 9"):
        Release.of("pyproject.toml", tmp_path / "CITATION.cff")


# --- same bytes ---


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


def test_archive_file_has_fixed_members_and_is_whole(built, tmp_path, verify, capsys):
    with zipfile.ZipFile(built.with_name(f"{built.name}.zip")) as archive:
        members = archive.infolist()
        archive.extractall(tmp_path)
    assert [one.filename for one in members] == [
        f"{built.name}/{name}" for name in files_in(built, built)
    ]
    assert len({(one.date_time, one.external_attr, one.create_system) for one in members}) == 1
    assert verify.main([str(tmp_path / built.name), "--points", "3"]) == 0
    assert capsys.readouterr().out.startswith(f"whole: {built.name}: ")


def test_no_trace_of_where_it_was_made(built):
    traces = [str(ROOT).encode(), str(built.parent).encode(), socket.gethostname().encode()]
    for name in files_in(built, built):
        content = (built / name).read_bytes()
        assert not [trace for trace in traces if len(trace) > 5 and trace in content], name


def test_provenance_holds_what_the_archive_does_not(built):
    record = provenance(built.with_name(f"{built.name}.zip"), [])
    assert record["archive"]["sha256"] and record["host"] and record["time"] and record["user"]


def test_folder_appears_whole_or_not_at_all(tmp_path):
    place = tmp_path / "release"
    with whole_folder(place) as part:
        (part / "first").write_text("1")
    with pytest.raises(OSError), whole_folder(place) as part:
        (part / "second").write_text("2")
        raise OSError
    assert files_in(tmp_path, tmp_path) == ["release/first"]


# --- verification ---


def test_verification_needs_no_more_than_it_says():
    own = {path.stem for path in VERIFICATION.glob("*.py")}
    for path in VERIFICATION.glob("*.py"):
        for node in ast.walk(ast.parse(path.read_text(encoding="utf-8"))):
            names = [alias.name for alias in node.names] if isinstance(node, ast.Import) else []
            names += [node.module] if isinstance(node, ast.ImportFrom) else []
            for name in (name.partition(".")[0] for name in names):
                allowed = sys.stdlib_module_names | own | {"numpy", "scipy", "netCDF4"}
                assert name in allowed, f"{path.name} imports {name}"


@pytest.fixture(scope="module")
def bare(tmp_path_factory):
    """Runs Python where nothing but numpy, scipy, netCDF4 and what that needs can be imported."""
    folder = tmp_path_factory.mktemp("bare")
    for name in ("numpy", "scipy", "netCDF4", "cftime", "certifi", "packaging"):
        package = Path(find_spec(name).origin).parent
        (folder / name).symlink_to(package)
        for libraries in package.parent.glob(f"{name.lower()}*.libs"):
            (folder / libraries.name).symlink_to(libraries)
    environment = {"PYTHONPATH": str(folder), "PATH": ""}

    def run(*arguments):
        command = [sys.executable, "-S", *arguments]
        return subprocess.run(command, env=environment, cwd="/", capture_output=True, text=True)

    return run


@pytest.mark.parametrize("name", ["thirdbody", "xarray", "pandas"])
def test_verification_runs_where_the_project_is_absent(bare, name):
    assert f"No module named '{name}'" in bare("-c", f"import {name}").stderr


def test_verification_passes_in_the_archive_itself_and_leaves_it_alone(bare, built):
    before = files_in(built, built)
    done = bare(built / "verification/verify.py")
    assert (done.returncode, done.stderr) == (0, "")
    assert done.stdout.count("\n") == 1
    assert done.stdout.startswith(f"whole: {built.name}: {len(before)} files")
    assert "3 datasets, 84 points" in done.stdout
    assert files_in(built, built) == before


def found(verify, folder, points=0):
    return verify.verify(folder, points, seed=1)[0]


def test_flipped_byte_is_found_in_every_file(copy, verify, tell):
    rng = random.Random(7)
    names = files_in(copy, copy)
    missed = []
    for name in names:
        path = copy / name
        content = path.read_bytes()
        place = rng.randrange(len(content))
        flipped = bytes([content[place] ^ 1 << rng.randrange(8)])
        path.write_bytes(content[:place] + flipped + content[place + 1 :])
        missed += [] if found(verify, copy) else [name]
        path.write_bytes(content)
    assert missed == []
    assert found(verify, copy) == {}
    tell(f"archive: a flipped byte found in each of {len(names)} files")


def test_every_missing_file_is_named(copy, verify, tell):
    names = files_in(copy, copy)
    for name in names:
        content = (copy / name).read_bytes()
        (copy / name).unlink()
        assert name in found(verify, copy)
        (copy / name).write_bytes(content)
    tell(f"archive: each of {len(names)} missing files named")


def test_extra_file_is_named_in_every_folder(copy, verify, tell):
    folders = [copy, *(path for path in copy.rglob("*") if path.is_dir())]
    for folder in folders:
        extra = folder / "note.txt"
        extra.write_text("one too many")
        assert extra.relative_to(copy).as_posix() in found(verify, copy)
        extra.unlink()
    tell(f"archive: an extra file named in each of {len(folders)} folders")


@pytest.mark.parametrize("damage", ["empty", "halved", "link"])
@pytest.mark.parametrize(
    "name", ["data/datasets/fig03.nc", "data/tables/tpca_windows.csv", "README.md"]
)
def test_damaged_file_is_named(copy, verify, name, damage):
    path = copy / name
    content = path.read_bytes()
    path.unlink()
    if damage == "link":
        path.symlink_to(copy / "bagit.txt")
    else:
        path.write_bytes(content[: len(content) // 2] if damage == "halved" else b"")
    assert name in found(verify, copy)


@pytest.mark.parametrize(
    "name",
    [
        "bagit.txt",
        "data/datapackage.json",
        "data/ro-crate-metadata.json",
        "data/datasets/content-sha256.json",
        "manifest-sha256.txt",
    ],
)
def test_rubbish_and_missing_descriptions_give_one_line(copy, verify, capsys, name):
    (copy / name).write_bytes(bytes(range(256)))
    assert verify.main([str(copy)]) == 1
    (copy / name).unlink()
    assert verify.main([str(copy)]) == 1
    lines = capsys.readouterr().out.splitlines()
    assert len(lines) == 2
    assert all(line.startswith("not whole: ") and name in line for line in lines)


def change(path, variable, factor):
    """Change one shown number of ``variable`` in the NetCDF file ``path``; False if all are zero."""
    with netCDF4.Dataset(path, "a") as dataset:
        dataset.set_auto_maskandscale(False)
        values = dataset[variable][:]
        numbers = np.abs(np.where(np.isfinite(values) & (values < 1e30), values, 0.0))
        places = np.argwhere(numbers > 1e-3 * numbers.max())
        if not places.size:
            return False
        values[tuple(places[len(places) // 2])] *= factor
        dataset[variable][:] = values
    return True


def mend_sums(folder, release):
    """Make every description of the archive agree with what is in it."""
    data = folder / "data"
    content_sha256 = run_path(str(VERIFICATION / "content_hash.py"))["content_sha256"]
    contents = {path.name: content_sha256(path) for path in sorted(data.glob("datasets/*.nc"))}
    (data / "datasets/content-sha256.json").write_text(json.dumps(contents))
    package = data_package(data, KINDS, release)
    (data / "datapackage.json").write_text(json.dumps(package), encoding="utf-8")
    seal(folder, release)


QUANTITIES = (
    "total_contact_area",
    "particle_contact_area_ratio",
    "surface_contact_area_ratio",
    "solid_load_fraction",
    "fluid_load_fraction",
    "separation",
    "film_thickness",
)
COORDINATES = (
    "load",
    "viscosity",
    "particle_diameter",
    "roughness",
    "particle_density",
    "normal_load",
)


def test_make_verify_looks_at_this_release(release):
    command = ["make", "--dry-run", "verify"]
    told = subprocess.run(command, capture_output=True, text=True, check=True).stdout
    folder = f"results/release/{release.full_name}"
    assert told.endswith(f"python verification/verify.py {folder} --results results\n")


def test_changed_number_is_found_though_all_sums_agree(copy, verify, release, tell):
    changed = 0
    for name in SCENES:
        path = copy / "data/datasets" / f"{name}.nc"
        content = path.read_bytes()
        for variable in (*QUANTITIES, *COORDINATES):
            if change(path, variable, 1.0 + 1e-6):
                changed += 1
                mend_sums(copy, release)
                faults = found(verify, copy)
                assert list(faults) == [f"data/datasets/{name}.nc"], variable
                assert re.search("is off by|normal_load|roughness", faults[f"data/datasets/{name}.nc"])
            path.write_bytes(content)
    bagit.Bag(str(copy)).validate(fast=True)
    tell(f"archive: each of {changed} changed numbers found though all sums were made again")


@pytest.mark.parametrize("flag", ["lubrication_regime", "contact_mode", "solution_status"])
def test_changed_flag_is_found_though_all_sums_agree(copy, verify, release, flag):
    with netCDF4.Dataset(copy / "data/datasets/fig04.nc", "a") as dataset:
        dataset.set_auto_maskandscale(False)
        values = dataset[flag][:]
        shown = tuple(np.argwhere(values >= 0)[-1])
        values[shown] = (values[shown] + 1) % dataset[flag].flag_values.size
        dataset[flag][:] = values
    mend_sums(copy, release)
    assert list(found(verify, copy)) == ["data/datasets/fig04.nc"]


@pytest.mark.parametrize("factor", [1.0001, 0.0])
@pytest.mark.parametrize("key", ["E_ss", "k", "G", "truncation", "participation", "sigma_s"])
def test_changed_input_is_found_though_all_sums_agree(copy, verify, release, key, factor):
    with netCDF4.Dataset(copy / "data/datasets/fig04.nc", "a") as dataset:
        model = json.loads(dataset.model_parameters)
        scaled = np.multiply(model[key], factor)
        dataset.model_parameters = json.dumps(model | {key: scaled.tolist()})
    mend_sums(copy, release)
    assert list(found(verify, copy)) == ["data/datasets/fig04.nc"]


@pytest.mark.parametrize("model", [None, "{}", "rubbish"])
def test_dataset_that_cannot_be_recomputed_is_named(copy, verify, release, model):
    with netCDF4.Dataset(copy / "data/datasets/fig04.nc", "a") as dataset:
        dataset.delncattr("model_parameters")
        if model is not None:
            dataset.model_parameters = model
    mend_sums(copy, release)
    assert list(found(verify, copy)) == ["data/datasets/fig04.nc"]


def test_plain_model_agrees_with_mpmath(verify):
    import plain_model

    with open(ROOT / "tests/golden/solutions.csv", encoding="utf-8", newline="") as stream:
        rows = [{key: number(text) for key, text in row.items()} for row in csv.DictReader(stream)]
    errors = []
    for row in rows:
        solution = plain_model.solve(row, plain_model.Point(*(row[name] for name in POINT)))
        outside = row["outside_film_formula"] == 1.0
        assert solution.status == ("outside_film_formula" if outside else "converged")
        for name, value in {
            "total_contact_area": solution.state.total_area,
            "particle_contact_area_ratio": solution.state.particle_ratio,
            "surface_contact_area_ratio": solution.state.summit_ratio,
            "solid_load_fraction": solution.solid_fraction,
            "fluid_load_fraction": solution.fluid_fraction,
            "separation": solution.separation,
        }.items():
            errors.append(abs(value - row[name]) / max(abs(row[name]), sys.float_info.min))
    assert len(rows) >= 200
    assert max(errors) < 1e-9


POINT = (
    *("load", "viscosity", "particle_diameter", "roughness", "particle_density"),
    *("eta_s", "R", "sigma_s", "y_s"),
)


def number(text):
    """The number that ``text`` stands for, or the text itself."""
    try:
        return float(text)
    except ValueError:
        return text
