"""The verification of an archive: passes where it is whole, and finds every kind of damage."""

import ast
import csv
import json
import random
import re
import shutil
import subprocess
import sys
import zipfile
from importlib.util import find_spec
from pathlib import Path
from runpy import run_path

import bagit
import netCDF4
import numpy as np
import pytest
from small_release import SCENES

from thirdbody.release.bag import files_in, seal
from thirdbody.release.datapackage import data_package

ROOT = Path(__file__).resolve().parents[2]
VERIFICATION = ROOT / "verification"
KINDS = ("datasets", "tables", "figures")


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
    assert "3 datasets, 98 points" in done.stdout
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


@pytest.mark.parametrize("damage", ["emptied", "halved", "overwritten", "linked"])
def test_every_damaged_file_is_named(copy, verify, damage, tell):
    """By the sums alone, which are looked at first."""
    names = files_in(copy, copy)
    for name in names:
        path = copy / name
        content = path.read_bytes()
        path.unlink()
        if damage == "linked":
            path.symlink_to(copy / "bagit.txt")
        elif damage == "overwritten":
            path.write_bytes(random.Random(name).randbytes(len(content)))
        else:
            path.write_bytes(content[: len(content) // 2] if damage == "halved" else b"")
        faults = verify.Faults()
        verify.check_bag(copy, verify.read_files(copy, faults), faults)
        assert name in faults
        path.unlink()
        path.write_bytes(content)
    tell(f"archive: each of {len(names)} files named when {damage}")


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
    command = ["make", "--no-print-directory", "--dry-run", "verify"]
    told = subprocess.run(command, cwd=ROOT, capture_output=True, text=True, check=True).stdout
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
                assert re.search(
                    "is off by|normal_load|roughness", faults[f"data/datasets/{name}.nc"]
                )
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


def restate(path, status, unsolved=False, **numbers):
    """Say of the last shown point of the dataset ``path`` that it is ``status``, perhaps unsolved, and
    that it has other ``numbers``."""
    with netCDF4.Dataset(path, "a") as dataset:
        dataset.set_auto_maskandscale(False)
        shown = tuple(np.argwhere(dataset["solution_status"][:] >= 0)[-1])
        missing = dict.fromkeys((*QUANTITIES, "error_bound"), np.nan) if unsolved else {}
        missing |= dict.fromkeys(("lubrication_regime", "contact_mode"), -1) if unsolved else {}
        meanings = dataset["solution_status"].flag_meanings.split()
        said = {**missing, "solution_status": meanings.index(status), **numbers}
        for name, value in said.items():
            values = dataset[name][:]
            values[shown] = value
            dataset[name][:] = values


@pytest.mark.parametrize(
    ("status", "unsolved"),
    [
        ("several_separations", False),
        ("area_exceeded", False),
        ("coverage_exceeded", True),
        ("load_exceeded", True),
    ],
)
def test_false_status_is_found_though_all_sums_agree(copy, verify, release, status, unsolved):
    restate(copy / "data/datasets/fig04.nc", status, unsolved)
    mend_sums(copy, release)
    assert list(found(verify, copy)) == ["data/datasets/fig04.nc"]


@pytest.mark.parametrize(("count", "wrong"), [(1, False), (2, True)])
def test_a_false_number_of_separations_is_found(copy, verify, release, count, wrong):
    with netCDF4.Dataset(copy / "data/datasets/fig04.nc", "a") as dataset:
        status = dataset["solution_status"]
        counts = dataset.createVariable("separation_count", "i1", status.dimensions)
        counts[:] = count
    mend_sums(copy, release)
    assert list(found(verify, copy, points=2)) == ["data/datasets/fig04.nc"] * wrong


@pytest.mark.parametrize("unsolved", [False, True])
def test_point_that_is_said_not_to_have_converged_may_have_values(copy, verify, release, unsolved):
    bound = np.nan if unsolved else np.inf
    restate(copy / "data/datasets/fig04.nc", "not_converged", unsolved, error_bound=bound)
    mend_sums(copy, release)
    assert not found(verify, copy)


@pytest.mark.parametrize("bound", [1e-8, np.inf])
def test_a_point_that_converged_is_bounded_as_was_asked(copy, verify, release, bound):
    restate(copy / "data/datasets/fig04.nc", "converged", error_bound=bound)
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
        assert solution.status == row["status"]
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
