"""The verification of an archive: passes where it is whole, and finds every kind of damage."""

import ctypes
import json
import os
import random
import re
import shutil
import subprocess
import sys
import warnings
import zipfile
from dataclasses import asdict, replace
from importlib.util import find_spec
from pathlib import Path
from runpy import run_path

import netCDF4
import numpy as np
import pytest
import small_release

import thirdbody as tb
from chenhorng.archive.crate import METADATA, crate
from chenhorng.archive.descriptions import table_schemas
from chenhorng.archive.files import files_in, write_json
from chenhorng.archive.staging import pack, seal
from chenhorng.scenes import scene_dataset
from thirdbody.files import digest
from thirdbody.netcdf import declare, write_dataset

ROOT = Path(__file__).resolve().parents[2]
VERIFICATION = ROOT / "verification"
FOLDERS = ("datasets", "tables", "figures")


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
        archive.extractall(tmp_path / built.name)
    assert [one.filename for one in members] == files_in(built, built)
    assert len({(one.date_time, one.external_attr, one.create_system) for one in members}) == 1
    assert verify.main([str(tmp_path / built.name), "--points", "3"]) == 0
    assert capsys.readouterr().out.startswith(f"whole: {built.name}: ")


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


def flipped(content, chance):
    """``content`` with one bit changed."""
    place = chance.randrange(len(content))
    changed = bytes([content[place] ^ 1 << chance.randrange(8)])
    return content[:place] + changed + content[place + 1 :]


DAMAGE = {
    "emptied": lambda content, chance: b"",
    "halved": lambda content, chance: content[: len(content) // 2],
    "overwritten": lambda content, chance: chance.randbytes(len(content)),
    "changed in one bit": flipped,
    "linked": None,
    "missing": None,
}


@pytest.mark.parametrize("damage", DAMAGE)
def test_every_damaged_file_is_named(copy, verify, damage, tell):
    """By the sums alone, which are looked at first."""
    names, chance = files_in(copy, copy), random.Random(7)
    for name in names:
        path = copy / name
        content = path.read_bytes()
        path.unlink()
        if damage == "linked":
            path.symlink_to(copy / "bagit.txt")
        elif damage != "missing":
            path.write_bytes(DAMAGE[damage](content, chance))
        faults = verify.Faults()
        verify.check_bag(copy, verify.list_files(copy, faults), faults)
        assert faults if damage == "changed in one bit" else name in faults
        path.unlink(missing_ok=True)
        path.write_bytes(content)
    assert found(verify, copy) == {}
    tell(f"archive: each of {len(names)} files named when {damage}")


def test_an_extra_file_is_named_in_every_folder(copy, verify):
    extra = [path / "note.txt" for path in (copy, *copy.rglob("*")) if path.is_dir()]
    for path in extra:
        path.write_text("one too many")
    assert set(found(verify, copy)) >= {path.relative_to(copy).as_posix() for path in extra}


def test_a_file_that_is_not_listed_is_not_read(copy, verify, monkeypatch):
    """It may be of any size."""
    (copy / "data/huge.bin").write_bytes(b"0")
    read, sha256 = [], verify.sha256
    monkeypatch.setattr(verify, "sha256", lambda path: read.append(path) or sha256(path))
    assert found(verify, copy)["data/huge.bin"] == "is not part of the archive"
    assert copy / "data/datasets/fig03.nc" in read and copy / "data/huge.bin" not in read


@pytest.mark.parametrize("name", ["data/a:b", "data/a\\b", "data/ends.", "data/a b", "data/é"])
def test_name_that_some_system_cannot_write_is_found(copy, verify, release, name):
    (copy / name).write_text("")
    mend(copy, release)
    assert found(verify, copy) == {name: "has a name that not every system can write"}


def test_two_names_that_are_one_on_some_systems_are_found(copy, verify, release):
    (copy / "data/figures/FIG03.svg").write_text("<svg/>")
    mend(copy, release)
    fault = {"data/figures/fig03.svg": "is data/figures/FIG03.svg on some systems"}
    assert found(verify, copy) == fault


SPACES = 'xmlns="http://www.w3.org/2000/svg" xmlns:xlink="http://www.w3.org/1999/xlink"'
SVG = f"<svg {SPACES} {{}}>{{}}</svg>"
LOADS = {
    "picture": ("", '<image xlink:href="https://example.org/a.png"/>'),
    "picture beside it": ("", '<image href="a.png"/>'),
    "program": ("", "<script>x()</script>"),
    "program of an event": ('onload="x()"', ""),
    "style sheet": ("", "<style>@import 'a.css';</style>"),
    "picture of a style": ("", '<rect style="fill: url(https://example.org/a.svg#b)"/>'),
    "hidden word": ("", r"<style>rect { fill: u\72l(a.svg) }</style>"),
    "other base": ('xml:base="https://example.org/"', '<use href="#a"/>'),
    "set later": ("", '<image><set attributeName="href" to="a.png"/></image>'),
    "page": ("", '<img xmlns="http://www.w3.org/1999/xhtml" srcset="a.png"/>'),
}


@pytest.mark.parametrize(("attributes", "content"), LOADS.values(), ids=LOADS)
def test_drawing_that_loads_from_elsewhere_is_found(copy, verify, release, attributes, content):
    own = '<defs><g id="a"/></defs><use xlink:href="#a"/><image href="data:image/png;base64,AA"/>'
    drawing = copy / "data/figures/fig03.svg"
    drawing.write_text(SVG.format("", own))
    mend(copy, release)
    assert found(verify, copy) == {}
    drawing.write_text(SVG.format(attributes, own + content))
    mend(copy, release)
    fault = {"data/figures/fig03.svg": "may load what lies elsewhere"}
    assert found(verify, copy) == fault


def test_page_that_may_load_from_elsewhere_is_found(copy, verify, release):
    """Each page of the project begins with the words that keep a browser from it."""
    templates = [
        ROOT / "src/chenhorng" / name
        for name in ("page/web/index.html", "claims/claims.html.j2", "sheets.html")
    ]
    for template in templates:
        text = template.read_text(encoding="utf-8")
        text = text[text.lower().index("<!doctype") :]
        page = copy / "data/tables/page.html"
        page.write_text(text, encoding="utf-8")
        mend(copy, release)
        assert found(verify, copy) == {}
        page.write_text(text.replace("img-src 'self' data:", "img-src *"), encoding="utf-8")
        mend(copy, release)
        assert found(verify, copy) == {"data/tables/page.html": "may load what lies elsewhere"}


DESCRIPTIONS = "bagit.txt", "data/table-schemas.json", METADATA
DESCRIPTIONS += "data/datasets/content-sha256.json", "manifest-sha256.txt"


@pytest.mark.parametrize("name", DESCRIPTIONS)
def test_rubbish_and_missing_descriptions_give_one_line(copy, verify, capsys, name):
    (copy / name).write_bytes(bytes(range(256)))
    assert verify.main([str(copy)]) == 1
    (copy / name).unlink()
    assert verify.main([str(copy)]) == 1
    lines = capsys.readouterr().out.splitlines()
    assert len(lines) == 2
    assert all(line.startswith("not whole: ") and name in line for line in lines)


# ---- forgeries: an archive is changed, and all sums and descriptions are made again


def mend(folder, release):
    """Make every description and all sums of the archive agree with what is in it."""
    data = folder / "data"
    content_sha256 = run_path(str(VERIFICATION / "content_hash.py"))["content_sha256"]
    contents = {path.name: content_sha256(path) for path in sorted(data.glob("datasets/*.nc"))}
    write_json(data / "datasets/content-sha256.json", contents)
    write_json(data / "table-schemas.json", table_schemas(data, FOLDERS))
    titles = {name: name for name in FOLDERS}
    write_json(folder / METADATA, crate(folder, titles, release))
    seal(folder, release)


CONTRACT = run_path(str(VERIFICATION / "contract.py"))
COORDINATES = tuple(CONTRACT["COORDINATES"])
NUMBERS, FLAGS = tuple(CONTRACT["NUMBERS"]), tuple(CONTRACT["FLAGS"])
QUANTITIES = tuple(name for name in NUMBERS if name != "error_bound")
FILL_VALUE = CONTRACT["FILL_VALUE"]


def attribute(variable, name, value):
    """Set an attribute of a variable, or of the dataset."""
    return lambda dataset: (dataset[variable] if variable else dataset).setncattr(name, value)


def scaled(*variables, by, once=False):
    """Multiply all shown numbers of variables, or ``once`` one of the larger ones."""

    def forge(dataset):
        for variable in variables:
            values = dataset[variable][:]
            shown = np.where(values == FILL_VALUE, 0.0, np.abs(values))
            places = np.argwhere(shown > (1e-3 * np.nanmax(shown) if once else 0.0))
            chosen = places[len(places) // 2][None] if once else places
            values[tuple(chosen.T)] *= by
            dataset[variable][:] = values

    return forge


def at(place, **numbers):
    """Set variables at one place, or at several, of a dataset."""

    def forge(dataset):
        for name, value in numbers.items():
            values = dataset[name][:]
            values[place] = value
            dataset[name][:] = values

    return forge


def restated(status, unsolved=False, **numbers):
    """Give the last shown point another status, without values if it is ``unsolved``."""

    def forge(dataset):
        missing = dict.fromkeys(NUMBERS, np.nan) if unsolved else {}
        missing |= dict.fromkeys(("lubrication_regime", "contact_mode"), -1) if unsolved else {}
        code = dataset["solution_status"].flag_meanings.split().index(status)
        at(last_shown(dataset), **{**missing, "solution_status": code, **numbers})(dataset)

    return forge


def last_shown(dataset):
    """The place of the last shown point."""
    return tuple(np.argwhere(dataset["solution_status"][:] >= 0)[-1])


def all_unresolved(error_bound):
    """Declare all points that have values not converged."""

    def forge(dataset):
        status, bound = dataset["solution_status"][:], dataset["error_bound"][:]
        has_values = np.isin(status, (0, 1, 4))
        at(
            has_values, solution_status=3, error_bound=np.full(bound.shape, error_bound)[has_values]
        )(dataset)

    return forge


def moved_by(factor):
    """Multiply all numbers of a few points, which are declared not converged with any bound."""

    def forge(dataset):
        place = (slice(None), 1, 1, 1, 0)
        for name in ("separation", "film_thickness", "total_contact_area"):
            dataset[name][place] = dataset[name][place] * factor
        at(place, solution_status=3, error_bound=1e12)(dataset)

    return forge


def next_flag(flag):
    """Give the last shown point the next value of a flag."""

    def forge(dataset):
        last = last_shown(dataset)
        at(last, **{flag: (dataset[flag][last] + 1) % 3})(dataset)

    return forge


def hidden(place):
    """Hide points as those that a figure does not show."""
    return at(place, **dict.fromkeys(NUMBERS, FILL_VALUE), **dict.fromkeys(FLAGS, -127))


def shown_too(dataset):
    """Show the points of one curve once more, where the figure shows none."""
    for name in (*NUMBERS, *FLAGS):
        dataset[name][:, 1, 0, 0] = dataset[name][:, 1, 1, 1]


def inputs(**changed):
    """Change entries of ``model_parameters``: numbers by a factor, others are set."""

    def forge(dataset):
        model = json.loads(dataset.model_parameters)
        for key, value in changed.items():
            is_factor = isinstance(value, float) and key in model
            model[key] = np.multiply(model[key], value).tolist() if is_factor else value
        dataset.model_parameters = json.dumps(model)

    return forge


IN_FIG04 = {
    # what programs apply to numbers when they read them
    "scale_factor": attribute("separation", "scale_factor", 1e-3),
    "add_offset": attribute("total_contact_area", "add_offset", 0.1),
    "valid_min": attribute("solid_load_fraction", "valid_min", 0.5),
    "valid_range": attribute("film_thickness", "valid_range", np.array([0.0, 1e-9])),
    "missing_value": attribute("solid_load_fraction", "missing_value", 1.0),
    "scale_factor of an axis": attribute("viscosity", "scale_factor", 2.0),
    "unsigned flags": attribute("solution_status", "_Unsigned", "true"),
    "units in kN": attribute("normal_load", "units", "kN"),
    "units of an axis": attribute("viscosity", "units", "mm2 s-1"),
    "no units": lambda dataset: dataset["particle_density"].delncattr("units"),
    "flag_meanings": attribute("lubrication_regime", "flag_meanings", "mixed boundary x y z"),
    "flag_values": attribute("contact_mode", "flag_values", np.array([1, 0, 2, 3, -1, -127], "i1")),
    "ancillary_variables": attribute("separation", "ancillary_variables", "contact_mode"),
    "attribute of the dataset": attribute("", "scale_factor", 2.0),
    "unknown attribute": attribute("", "software_version", "9.9"),
    "unknown attribute of a variable": attribute("separation", "standard_name", "depth"),
    "configuration_sha256": attribute("", "configuration_sha256", "0" * 64),
    "id": attribute("", "id", "thirdbody-0000000000000000"),
    "title": attribute("", "title", "Other points"),
    "variable": lambda dataset: dataset.createVariable("true_load", "f8", ("load",)),
    "group": lambda dataset: dataset.createGroup("corrected"),
    "dimension": lambda dataset: dataset.createDimension("member", 2),
    # points and conditions that are not those of the configuration
    "hidden curve": hidden((slice(None), 1, 1, 1, 0)),
    "hidden load": hidden((3,)),
    "curve that is not shown": shown_too,
    "viscosity where L_f is 0": at(1, viscosity=2e-6),
    "density without particles": at(0, particle_density=2e11),
    "loads and newtons": scaled("load", "normal_load", by=1.001),
    "rtol": attribute("", "rtol", 1e-3),
    # bounds of errors
    "error_bound / 1000": scaled("error_bound", by=1e-3),
    "error_bound x 1000": scaled("error_bound", by=1e3),
    "error_bound of nan": scaled("error_bound", by=np.nan),
    "error_bound / 1000 at a point": scaled("error_bound", by=1e-3, once=True),
    "error_bound of 0": scaled("error_bound", by=0.0),
    "converged beyond rtol": restated("converged", error_bound=1e-8),
    "converged without bound": restated("converged", error_bound=np.inf),
    # flags and statuses
    "lubrication regime": next_flag("lubrication_regime"),
    "contact mode": next_flag("contact_mode"),
    "status": next_flag("solution_status"),
    "false area_exceeded": restated("area_exceeded"),
    "false coverage_exceeded": restated("coverage_exceeded", unsolved=True),
    "false load_exceeded": restated("load_exceeded", unsolved=True),
    "not_converged with a bound": restated("not_converged", unsolved=True, error_bound=1e-9),
    "false not_converged": restated("not_converged", error_bound=np.inf),
    "false not_converged without values": restated("not_converged", unsolved=True),
    "all not_converged with good values": all_unresolved(error_bound=0.5),
    "all not_converged and moved": moved_by(1.08),
    # inputs of the model
    "another k": inputs(k=1.0001),
    "another sigma_s": inputs(sigma_s=1.0001),
    "another interpretation": inputs(film_load="total"),
    "another word for the sizes": inputs(phi_a="centred"),
    "unknown input": inputs(friction=0.1),
    "no inputs": lambda dataset: dataset.delncattr("model_parameters"),
    "rubbish for inputs": attribute("", "model_parameters", "rubbish"),
}
# in fig04 a film carries some of the load and none, in fig07 particles cover too much
FIGURES = dict.fromkeys(QUANTITIES, "fig04") | dict.fromkeys(COORDINATES, "fig07")
IN_NUMBERS = {
    variable: (figure, scaled(variable, by=1.0 + 1e-6, once=True))
    for variable, figure in FIGURES.items()
}
FORGERIES = {name: ("fig04", forge) for name, forge in IN_FIG04.items()} | IN_NUMBERS


def forge_dataset(folder, figure, forge, release):
    with netCDF4.Dataset(folder / "data/datasets" / f"{figure}.nc", "a") as dataset:
        dataset.set_auto_maskandscale(False)
        forge(dataset)
    mend(folder, release)


@pytest.mark.parametrize(("figure", "forge"), FORGERIES.values(), ids=FORGERIES)
def test_forged_dataset_is_found(copy, verify, release, figure, forge):
    forge_dataset(copy, figure, forge, release)
    assert list(found(verify, copy)) == [f"data/datasets/{figure}.nc"]


def linked_elsewhere(path, other):
    """Replace the separation in a dataset by a link to that in another file, which netCDF4 cannot
    do itself."""
    maps = Path("/proc/self/maps").read_text(encoding="utf-8")
    (library,) = set(re.findall(r"/\S+/libhdf5[-.]\S+", maps))
    hdf5 = ctypes.CDLL(library)
    hdf5.H5Fopen.restype = ctypes.c_int64
    place = ctypes.c_int64(hdf5.H5Fopen(bytes(path), 1, ctypes.c_int64(0)))
    name, default = b"separation", ctypes.c_int64(0)
    assert hdf5.H5Ldelete(place, name, default) == 0
    assert hdf5.H5Lcreate_external(bytes(other), name, place, name, default, default) == 0
    assert hdf5.H5Fclose(place) == 0


def without_chunks(path, other):
    """Store the separation as HDF5 stores numbers in other files, and virtual datasets."""
    dataset = small_release.solved("fig04", tb.load_parameters().best)
    storage = {name: {"zlib": True} for name in dataset.data_vars}
    storage["separation"] = {"contiguous": True}
    with netCDF4.Dataset(path, "w") as file:
        for name, stored in declare(file, dataset, storage).items():
            stored[:] = dataset[name].values


@pytest.mark.parametrize(
    ("forge", "fault"),
    [(linked_elsewhere, "cannot be recomputed"), (without_chunks, "separation has no chunks")],
)
def test_numbers_that_may_lie_in_another_file_are_found(
    copy, verify, release, tmp_path, forge, fault
):
    path, other = copy / "data/datasets/fig04.nc", tmp_path / "other.nc"
    shutil.copyfile(path, other)
    forge(path, other)
    mend(copy, release)
    faults = found(verify, copy)
    assert list(faults) == ["data/datasets/fig04.nc"]
    assert faults["data/datasets/fig04.nc"].startswith(fault)


def test_bound_of_errors_that_promises_too_much_is_found(verify, tmp_path):
    """Interpolated points are as exact as their bound says, and no more."""
    genuine = GENUINE["rtol 0.01"]
    assert outcome_of(verify, tmp_path, *genuine).findings == []
    forged = outcome_of(verify, tmp_path, *genuine, forge=scaled("error_bound", by=1e-9))
    assert any("is off by" in finding for finding in forged.findings)


USUAL = ([0, 90], [0, 300], [300], [1e11])
CROWD = {"participation": 1.0, "mean_ratio": 1.0, "spread_ratio": 1.0, "apparent_area": 5e-7}
GENUINE = {
    # as many points as the library interpolates
    **{f"rtol {rtol:g}": (USUAL, (0.04, 80.0), rtol, {}) for rtol in (1e-11, 1e-5, 1e-3, 1e-2)},
    # covered by particles, and a load that they do not bear at any separation
    "two statuses": (([0, 90], [300], [300], [1e13]), (10.0, 10000.0), 1e-9, CROWD),
    # solids that bear less than float64 holds
    "full film": (([1000, 10000], [0, 30], [10], [1e11]), (0.001, 1.0), 1e-9, {}),
    "full film of the total": (
        *(([1000], [0, 30], [10], [1e11]), (0.001, 1.0), 1e-9),
        {"film_load": "total"},
    ),
    # next to X_max, where float64 does not hold the digits: none of these points converges
    "narrow sizes": (
        *(([0], [1000], [10], [1e11]), (0.04, 80.0), 1e-11),
        {"mean_ratio": 1.0, "spread_ratio": 1e-4, "truncation": 3.0},
    ),
}


@pytest.mark.parametrize(("conditions", "loads", "rtol", "changes"), GENUINE.values(), ids=GENUINE)
def test_what_the_workflow_allows_is_no_forgery(verify, tmp_path, conditions, loads, rtol, changes):
    outcome = outcome_of(verify, tmp_path, conditions, loads, rtol, changes)
    assert outcome.findings == []
    assert outcome.evaluated > 0


def outcome_of(verify, tmp_path, conditions, loads, rtol, changes, forge=None):
    """What the check finds in the dataset of these conditions, forged or not."""
    curves = [dict(zip(small_release.KEYS, conditions, strict=True))]
    scene = {"title": "x", "rtol": rtol, "load_axis": {"load_N": loads, "count": 30}}
    parameters = replace(tb.load_parameters().best, **changes)
    path = tmp_path / "mine.nc"
    write_dataset(scene_dataset(scene | {"curves": curves}, parameters, rtol), path)
    config = {"scenes": {"mine": scene | {"curves": curves}}}
    if forge:
        with netCDF4.Dataset(path, "a") as dataset:
            dataset.set_auto_maskandscale(False)
            forge(dataset)
    check = verify.own_module("recompute").check
    return check(path, config, asdict(parameters), 10, random.Random(1))


def test_scene_of_a_user_need_not_be_in_the_archive(copy, verify, release):
    def add(config):
        config["scenes"]["mine"] = config["scenes"]["fig04"] | {"title": "Mine"}

    edit_json(SCENE, add)(copy)
    mend(copy, release)
    assert not found(verify, copy)


def test_datasets_of_other_inputs_are_found(copy, verify, release):
    """They fulfil the equations, but with inputs that are not those of the configuration."""
    other = replace(tb.load_parameters().best, yield_pressure_ratio=0.5)
    write_dataset(small_release.solved("fig04", other), copy / "data/datasets/fig04.nc")
    mend(copy, release)
    assert "k is 0.5" in found(verify, copy)["data/datasets/fig04.nc"]


def edit_json(name, change):
    """Change what a JSON file of the payload holds."""

    def forge(folder):
        content = json.loads((folder / "data" / name).read_text(encoding="utf-8"))
        change(content)
        write_json(folder / "data" / name, content)

    return forge


@pytest.mark.parametrize(
    ("key", "factor"),
    [("k", 1.0001), ("G", 1.0001), ("truncation", 1.0001), ("participation", 0.0), ("H_s1", 0.0)],
)
def test_input_that_is_changed_everywhere_is_found_by_the_equations(
    copy, verify, release, key, factor
):
    name = verify.own_module("contract").INPUTS[key]
    edit_json(INPUTS, lambda values: values.update({name: values[name] * factor}))(copy)
    forge_dataset(copy, "fig04", inputs(**{key: factor}), release)
    forge_dataset(copy, "fig04", identified(verify, copy, "fig04"), release)
    fault = found(verify, copy)["data/datasets/fig04.nc"]
    assert re.search(r"is off by|cannot be recomputed \((ZeroDivision|Value)Error", fault), fault


def identified(verify, folder, figure):
    """Give a dataset the attributes that follow from the configuration beside it."""

    def forge(dataset):
        config, values = (
            json.loads((folder / "data" / name).read_text(encoding="utf-8"))
            for name in (SCENE, INPUTS)
        )
        data, scene = verify.own_module("recompute").read(dataset), config["scenes"][figure]
        contract = verify.own_module("contract")
        dataset.configuration_sha256, dataset.id = contract.identity(data, scene, values)

    return forge


NAMES = {
    "a line break": ("a\nwhole: thirdbody: 592 files", "utf-8"),
    "not UTF-8": (os.fsdecode(b"\xff\xfe"), "utf-8:strict"),
    "not of the terminal": ("\u4e2d", "latin-1"),
    "controls of the terminal": ("a\x1b[2K\rwhole", "utf-8"),
}


@pytest.mark.parametrize(("name", "encoding"), NAMES.values(), ids=NAMES)
def test_no_name_forges_a_line(copy, name, encoding):
    (copy / "data" / name).write_text("one too many")
    command = [sys.executable, VERIFICATION / "verify.py", copy, "--sums"]
    environment = os.environ | {"PYTHONIOENCODING": encoding}
    done = subprocess.run(command, capture_output=True, env=environment)
    assert (done.returncode, done.stderr) == (1, b"")
    assert done.stdout.startswith(b"not whole: ")
    assert done.stdout.count(b"\n") == 1
    assert done.stdout.isascii() and done.stdout.strip().decode().isprintable()


def add(name, content, **attributes):
    """Adds a member to a packed archive."""

    def change(packed):
        member = zipfile.ZipInfo(name)
        for key, value in attributes.items():
            setattr(member, key, value)
        with warnings.catch_warnings(), zipfile.ZipFile(packed, "a") as archive:
            warnings.simplefilter("ignore")  # of names that stand twice
            archive.writestr(member, content)

    return change


def comment(packed):
    with zipfile.ZipFile(packed, "a") as archive:
        archive.comment = b"see elsewhere"


LINK = {"create_system": 3, "external_attr": 0o120777 << 16}
PACKED = {
    "leaves the bag": add("../bagit.txt", b""),
    "leaves a folder": add("data/../bagit.txt", b""),
    "in another bag": add("other/bagit.txt", b""),
    "absolute": add("/bagit.txt", b""),
    "twice": add("bagit.txt", b""),
    "on other systems twice": add("BAGIT.TXT", b""),
    "link": add("data/link", b"/etc/passwd", **LINK),
    "folder": add("data/folder/", b""),
    "before": lambda packed: packed.write_bytes(b"#!/bin/sh\n" + packed.read_bytes()),
    "behind": lambda packed: packed.write_bytes(packed.read_bytes() + b"behind"),
    "comment": comment,
    # the directory at the end no longer lists it, which some programs do not read
    "not in the directory": lambda packed: packed.write_bytes(
        b"PK\x03\x04" + bytes(26) + packed.read_bytes()
    ),
}


@pytest.mark.parametrize("change", PACKED.values(), ids=PACKED)
def test_packed_archive_that_holds_anything_else_is_found(copy, built, verify, change):
    packed = copy.with_name(f"{copy.name}.zip")
    shutil.copyfile(built.with_name(packed.name), packed)
    record = copy.with_name(f"{copy.name}-provenance.json")

    def faults():
        write_json(record, {"archive": {"sha256": digest(packed)}})
        return verify.verify(copy, 0, seed=1, packed_too=True, sums_alone=True)[0]

    assert faults() == {}
    change(packed)
    assert faults() == {str(packed): "holds something else than the folder"}


def test_description_too_large_to_be_one_is_not_read(copy, verify, release):
    with open(copy / METADATA, "ab") as file:
        file.truncate(verify.LARGEST_TEXT + 1)
    seal(copy, release)
    assert "is larger than" in found(verify, copy)[METADATA]


def test_dataset_that_claims_more_points_than_memory_is_not_read(copy, verify, release):
    path = copy / "data/datasets/fig04.nc"
    path.unlink()
    with netCDF4.Dataset(path, "w") as dataset:
        for name in COORDINATES[:-1]:
            dataset.createDimension(name, 10**4)
        for name in NUMBERS:
            dataset.createVariable(name, "f8", COORDINATES[:-1], zlib=True)
    outcome = verify.own_module("recompute").check(path, {}, {}, 0, random.Random(1))
    assert not outcome.has_form
    assert any("points, more than" in finding for finding in outcome.findings)


def test_configured_rtol_that_the_workflow_does_not_allow_is_found(copy, verify, release):
    """It would be the tolerance."""
    edit_json(SCENE, lambda config: config.update(rtol=0.5))(copy)
    for path in (copy / "data/datasets").glob("*.nc"):
        with netCDF4.Dataset(path, "a") as dataset:
            dataset.rtol = 0.5
    mend(copy, release)
    faults = found(verify, copy)
    assert len(faults) == 3
    assert all("does not allow" in fault for fault in faults.values())


def write(name, content="raise SystemExit('whole')\n"):
    return lambda folder: (folder / name).write_text(content, encoding="utf-8")


def swap(first, second):
    def forge(folder):
        (folder / first).rename(folder / "kept")
        (folder / second).rename(folder / first)
        (folder / "kept").rename(folder / second)

    return forge


SCENE, INPUTS = "configuration/config.json", "configuration/parameters.json"
IN_FOLDER = {
    "dataset left out": lambda folder: (folder / "data/datasets/fig03.nc").unlink(),
    "dataset added": lambda folder: shutil.copy(
        folder / "data/datasets/fig03.nc", folder / "data/datasets/fig05.nc"
    ),
    "datasets exchanged": swap("data/datasets/fig03.nc", "data/datasets/fig04.nc"),
    "configured viscosity": edit_json(
        SCENE, lambda config: config["scenes"]["fig04"]["curves"][0].update(viscosity_cSt=[0, 1, 2])
    ),
    "configured loads": edit_json(SCENE, lambda config: config["load_axis"].update(count=8)),
    "configured rtol": edit_json(SCENE, lambda config: config.update(rtol=1e-6)),
    "configured input": edit_json(INPUTS, lambda values: values.update(truncation=3.5)),
    "no configuration": lambda folder: (folder / "data" / SCENE).unlink(),
    "numpy.py": write("verification/numpy.py"),
    "json.py": write("verification/json.py"),
    "netCDF4 as a folder": lambda folder: shutil.copytree(
        folder / "data/figures", folder / "verification/netCDF4"
    ),
    "sitecustomize.py": write("sitecustomize.py"),
    "fetch.txt": write("fetch.txt", "https://example.org/a 1 data/a\n"),
    "no plain model": lambda folder: (folder / "verification/plain_model.py").unlink(),
}


@pytest.mark.parametrize("forge", IN_FOLDER.values(), ids=IN_FOLDER)
def test_forged_archive_is_found(bare, copy, release, forge):
    """By the program in the archive, so that a module beside it would be run."""
    forge(copy)
    mend(copy, release)
    done = bare(copy / "verification/verify.py", "--points", "0")
    assert done.returncode == 1, done.stderr
    assert done.stdout.startswith(f"not whole: {copy.name}: ")


def test_table_of_other_columns_is_found(copy, verify, release):
    (copy / "data/tables/tpca_windows.csv").write_text("a,b\n1,2\n")
    seal(copy, release)
    assert "other columns" in found(verify, copy)["data/tables/tpca_windows.csv"]


def edit_crate(change):
    """Change the list of entities of the crate."""

    def forge(folder):
        content = json.loads((folder / METADATA).read_text(encoding="utf-8"))
        change(content["@graph"])
        write_json(folder / METADATA, content)

    return forge


UNDESCRIBED = {
    "table without a schema": (
        edit_json("table-schemas.json", lambda schemas: schemas.pop("figures/fig03.csv")),
        "data/figures/fig03.csv",
    ),
    "schema without a table": (
        edit_json("table-schemas.json", lambda schemas: schemas.update({"tables/x.csv": {}})),
        "data/tables/x.csv",
    ),
    "file that the crate leaves out": (
        edit_crate(lambda graph: graph.remove(next(e for e in graph if e["@id"] == "README.md"))),
        "README.md",
    ),
    "file that the crate alone has": (
        edit_crate(lambda graph: graph.append({"@id": "data/x.csv", "@type": "File"})),
        "data/x.csv",
    ),
}


@pytest.mark.parametrize(("forge", "name"), UNDESCRIBED.values(), ids=UNDESCRIBED)
def test_description_of_other_files_is_found(copy, verify, release, forge, name):
    forge(copy)
    seal(copy, release)
    assert "is in only one of" in found(verify, copy)[name]


@pytest.mark.parametrize("command", [["verification/verify.py"], ["-m", "verification.verify"]])
def test_module_beside_the_program_is_not_run_from_any_folder(copy, command):
    """Python would import it from the folder of the program or from the current one."""
    for name in ("numpy", "json", "argparse", "netCDF4"):
        for folder in (copy, copy / "verification"):
            (folder / f"{name}.py").write_text("print('whole: forged')\n")
    done = subprocess.run([sys.executable, *command], cwd=copy, capture_output=True, text=True)
    assert (done.returncode, done.stderr) == (1, "")
    assert "forged" not in done.stdout


def test_damaged_folder_is_not_packed(copy, tmp_path, monkeypatch):
    monkeypatch.chdir(ROOT)
    (copy / "data/datasets/fig03.nc").write_bytes(b"damaged")
    with pytest.raises(ValueError, match="is not packed: .*fig03.nc is changed"):
        pack(copy, tmp_path / "archive.zip")
    assert not (tmp_path / "archive.zip").exists()
