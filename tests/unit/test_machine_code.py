"""Machine code that an earlier process left on disk is used if it is whole and up to date."""

import os
from importlib.util import module_from_spec, spec_from_file_location
from pathlib import Path

import pytest

from thirdbody.solver.compiled import machine_code

SOURCE = "def twice(x):\n    return x + x\n"


@pytest.fixture
def twice(tmp_path):
    """A function in a folder of its own."""
    path = tmp_path / "doubling.py"
    path.write_text(SOURCE)
    spec = spec_from_file_location("doubling", path)
    module = module_from_spec(spec)
    spec.loader.exec_module(module)
    return module.twice


def called(function) -> int:
    """Call a function as a new process would; how often it was found on disk."""
    code = machine_code.MachineCode(function)
    assert code(float, 2.0) == 4.0
    return code.loaded


def kept_files(function, pattern):
    """The files that were left on disk."""
    (*found,) = Path(machine_code.KeptCode(function).cache_path).glob(f"doubling.{pattern}")
    return found


def test_it_is_kept_for_later_processes(twice):
    assert called(twice) == 0
    kept = sorted(path.name for path in Path(machine_code.KeptCode(twice).cache_path).iterdir())
    assert called(twice) == 1, kept


def test_it_is_up_to_date_whatever_the_clock_says(twice, tmp_path):
    called(twice)
    os.utime(tmp_path / "doubling.py", (0, 0))
    assert called(twice) == 1


def test_it_is_kept_where_numba_is_told_now(twice, tmp_path, monkeypatch):
    monkeypatch.setenv("NUMBA_CACHE_DIR", str(tmp_path / "elsewhere"))
    called(twice)
    assert list((tmp_path / "elsewhere").rglob("doubling.*.nbi"))
    monkeypatch.undo()
    assert called(twice) == 0
    assert called(twice) == 1


@pytest.mark.parametrize("share", [0.0, 0.1, 0.5, 0.99])
@pytest.mark.parametrize("pattern", ["*.nbc", "*.nbi"])
def test_half_a_file_is_compiled_anew(twice, pattern, share):
    called(twice)
    (path,) = kept_files(twice, pattern)
    whole = path.read_bytes()
    path.write_bytes(whole[: int(share * len(whole))])
    assert called(twice) == 0
    assert called(twice) == 1


@pytest.mark.parametrize("pattern", ["*.nbc", "*.nbi"])
def test_a_file_that_can_be_neither_read_nor_replaced_is_no_obstacle(twice, pattern):
    called(twice)
    (path,) = kept_files(twice, pattern)
    path.unlink()
    path.mkdir()
    assert called(twice) == 0


def test_a_file_beside_that_changes_makes_it_out_of_date(twice, tmp_path):
    called(twice)
    (tmp_path / "other.py").write_text("FACTOR = 2\n")
    assert called(twice) == 0
    assert called(twice) == 1
