"""Bytecode that a full disk cut off is removed before it stops a run."""

import compileall
import os
import py_compile
import subprocess
import sys

import pytest

from thirdbody.run import bytecode
from thirdbody.run.bytecode import Bytecode

FILE = bytecode.__file__
# as the Snakefile does
LEAVE = (
    "import runpy, sys; bytecode = runpy.run_path(sys.argv[1])['Bytecode'](sys.argv[2]); "
    "bytecode.leave_as_it_is()"
)


@pytest.fixture
def package(tmp_path, monkeypatch):
    """A folder of two modules, one of them in a package, where bytecode may be written."""
    monkeypatch.setattr(sys, "dont_write_bytecode", False)
    monkeypatch.setenv("PYTHONDONTWRITEBYTECODE", "")
    monkeypatch.setattr(sys, "pycache_prefix", None)
    inner = tmp_path / "package" / "inner"
    inner.mkdir(parents=True)
    for folder in (inner, inner.parent):
        (folder / "module.py").write_text("VALUE = [str(n) for n in range(3)]\n")
    return inner.parent


def compiled(package):
    """The files of bytecode of both modules."""
    return [
        folder / "__pycache__" / f"module.{sys.implementation.cache_tag}.pyc"
        for folder in (package, package / "inner")
    ]


def imports(package, code="import module"):
    """Whether a new interpreter can import the module, or run other ``code``."""
    environment = os.environ | {"PYTHONPATH": str(package)}
    command = [sys.executable, "-c", code, FILE, str(package)]
    return subprocess.run(command, env=environment, check=False).returncode == 0


def test_every_module_is_compiled_once(package):
    Bytecode(package).prepare()
    before = [path.stat().st_mtime_ns for path in compiled(package)]
    Bytecode(package).prepare()
    assert [path.stat().st_mtime_ns for path in compiled(package)] == before
    assert not sys.dont_write_bytecode


@pytest.mark.parametrize("share", [0.0, 0.1, 0.5, 0.99])
def test_bytecode_that_was_cut_off_is_made_again(package, share):
    Bytecode(package).prepare()
    whole = compiled(package)[0].read_bytes()
    compiled(package)[0].write_bytes(whole[: int(share * len(whole))])
    assert imports(package) == (share == 0.0)  # Python itself looks at the header alone
    Bytecode(package).prepare()
    assert compiled(package)[0].read_bytes() == whole
    assert imports(package)


@pytest.mark.parametrize("share", [0.0, 0.1, 0.5, 0.99, 1.0])
def test_who_leaves_bytecode_as_it_is_can_import_all_the_same(package, share):
    Bytecode(package).prepare()
    whole = compiled(package)[0].read_bytes()
    cut = whole[: int(share * len(whole))]
    compiled(package)[0].write_bytes(cut)
    compiled(package)[1].unlink()
    assert imports(package, f"{LEAVE}; import module; from inner import module")
    assert compiled(package)[0].read_bytes() == cut
    assert not compiled(package)[1].exists()


def test_who_left_bytecode_as_it_was_can_prepare_it_later(package):
    Bytecode(package).prepare()
    compiled(package)[0].write_bytes(compiled(package)[0].read_bytes()[:30])
    assert imports(package, f"{LEAVE}; import module; bytecode.prepare()")
    assert imports(package)


def test_where_bytecode_does_not_fit_nobody_tries(package, monkeypatch):
    def keep_half(folder, **_):
        for path in compiled(package):
            py_compile.compile(str(path.parents[1] / "module.py"), str(path))
            path.write_bytes(path.read_bytes()[:30])
        return True

    monkeypatch.setattr(compileall, "compile_dir", keep_half)
    Bytecode(package).prepare()
    assert not [path for path in compiled(package) if path.exists()]
    assert sys.dont_write_bytecode
    assert os.environ["PYTHONDONTWRITEBYTECODE"] == "1"


def test_who_wants_no_bytecode_gets_none(package, monkeypatch):
    monkeypatch.setattr(sys, "dont_write_bytecode", True)
    Bytecode(package).prepare()
    assert not [path for path in compiled(package) if path.exists()]
