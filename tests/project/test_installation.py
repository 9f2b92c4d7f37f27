"""The library as it is installed: a wheel beside what it requires, in an environment of its own."""

import json
import os
import re
import runpy
import subprocess
import sys
import sysconfig
import tomllib
import venv
import zipfile
from importlib.metadata import distribution
from pathlib import Path

import pytest

import thirdbody

ROOT = Path(__file__).resolve().parents[2]
# what is asked for, the modules that it lacks beside numpy and scipy, the extra that brings them
LACKING = {
    "import thirdbody; thirdbody.stream": ("xarray, netCDF4", "data"),
    "from thirdbody import Solution; Solution().to_dataframe()": ("xarray, netCDF4", "data"),
    "import thirdbody; thirdbody.Interface": ("xarray, netCDF4", "data"),
    "import thirdbody.plotting.panel": ("matplotlib", "figures"),
    "import thirdbody.paper.calibration.search": ("cma, emcee, jinja2, pandas, tabulate", "study"),
}


def minimal():
    """What an installation without extras brings, by the requirements of its packages."""
    found, left = set(), list(project()["dependencies"])
    while left:
        requirement = left.pop()
        name = re.match(r"[\w.-]+", requirement)[0]
        if ";" not in requirement and name not in found:
            found.add(name)
            left += distribution(name).requires or ()
    return found


@pytest.fixture(scope="module")
def installed(tmp_path_factory):
    """Function that runs a program where the wheel is installed without extras."""
    folder = tmp_path_factory.mktemp("installed")
    built = [sys.executable, "-m", "hatchling", "build", "-t", "wheel", "-d", str(folder)]
    subprocess.run(built, cwd=ROOT, check=True, capture_output=True)
    venv.create(folder / "venv", with_pip=False)
    (packages,) = (folder / "venv").glob("lib/python*/site-packages")
    (wheel,) = folder.glob("*.whl")
    zipfile.ZipFile(wheel).extractall(packages)
    for name in minimal():
        for top in {file.parts[0] for file in distribution(name).files if file.parts[0] != ".."}:
            (packages / top).symlink_to(distribution(name).locate_file(top))

    def run(code, *arguments, beside=folder):
        """``beside`` is one more folder of packages."""
        command = [folder / "venv" / "bin" / "python", "-c", code, *arguments]
        environment = os.environ | {"PYTHONPATH": str(beside)}
        return subprocess.run(command, cwd=folder, env=environment, capture_output=True, text=True)

    return run


def test_the_example_of_the_readme_needs_no_more(installed, capsys):
    readme = (ROOT / "README.md").read_text(encoding="utf-8")
    (example,) = re.findall(r"```python\n(.*?)```", readme, re.DOTALL)
    done = installed(example)
    assert done.stderr == ""
    exec(example, {})
    assert done.stdout == capsys.readouterr().out


@pytest.mark.parametrize("code", LACKING)
def test_a_missing_extra_is_named_in_one_line(installed, code):
    modules, extra = LACKING[code]
    done = installed(code)
    assert done.returncode == 1
    message = f'this part of thirdbody needs {modules}: pip install "thirdbody[{extra}]"'
    assert done.stderr.splitlines()[-1] == f"ModuleNotFoundError: {message}"
    assert extra in project()["optional-dependencies"]


def test_the_command_has_help_and_says_what_it_needs(installed):
    done = installed(COMMAND, "--help")
    assert done.returncode == 0 and "turning-point" in done.stdout
    done = installed(COMMAND, "bearing")
    assert done.returncode == 2
    message = 'this part of thirdbody needs xarray, netCDF4: pip install "thirdbody[data]"'
    assert done.stderr == f"thirdbody bearing: {message}\n"


def project():
    return tomllib.loads((ROOT / "pyproject.toml").read_text(encoding="utf-8"))["project"]


def test_an_editor_sees_the_names_where_they_are():
    stub = runpy.run_path(str(Path(thirdbody.__file__).with_suffix(".pyi")))
    seen = {name: value for name, value in stub.items() if not name.startswith("__")}
    given = {name: getattr(thirdbody, name) for name in thirdbody.__all__ if name != "__version__"}
    assert seen == given


COMMAND = "import sys; from thirdbody.__main__ import run; sys.exit(run())"


def test_the_wheel_brings_the_calibrated_inputs_and_the_command(installed):
    packages = sysconfig.get_path("platlib")
    code = "import thirdbody as tb; print(repr(tb.load_parameters()), tb.__version__)"
    done = installed(code, beside=packages)
    assert done.stderr == ""
    assert done.stdout == f"{thirdbody.load_parameters()!r} {distribution('thirdbody').version}\n"
    assert project()["scripts"]["thirdbody"] == "thirdbody.__main__:run"
    done = installed(COMMAND, "bearing", "--json", beside=packages)
    assert done.stderr == "" and json.loads(done.stdout)["found"]
