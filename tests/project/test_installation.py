"""The library as it is installed: a wheel beside the packages that it requires, and no others; and
without the package of the paper."""

import os
import re
import shlex
import subprocess
import sys
import tomllib
import venv
import zipfile
from importlib.metadata import distribution
from pathlib import Path

import pytest
import yaml
from packaging.requirements import Requirement

import thirdbody
from thirdbody import command

ROOT = Path(__file__).resolve().parents[2]
PROJECT = tomllib.loads((ROOT / "pyproject.toml").read_text(encoding="utf-8"))["project"]
README = (ROOT / "README.md").read_text(encoding="utf-8")
COMMANDS = "state", "transitions", "turning-point", "curve", "compare", "bearing"
# runs the command as its entry point does
COMMAND = """
import sys
from importlib.metadata import entry_points
(entry,) = entry_points(group="console_scripts", name="thirdbody")
sys.exit(entry.load()())
"""
# what needs the data in the wheel: calibrated inputs, attributes of datasets
NEEDS_DATA = """
import thirdbody as tb
layer = dict(particle_diameter_nm=300, roughness_nm=300, particle_density_per_m2=1e11)
tb.stream("points.nc", load_N=[1, 10], viscosity_cSt=90, **layer)
print(repr(tb.load_parameters()), tb.__version__)
"""
# the library where the package of the paper cannot be imported, and no file of it or of its
# configuration be read
ALONE = """
import sys
from pathlib import Path

sys.modules.update(dict.fromkeys(["chenhorng", "benchmarks", "snakemake"]))
root = Path(sys.argv[1])

def refuse(event, arguments):
    if event == "open" and isinstance(arguments[0], str):
        path = Path(arguments[0]).absolute()
        assert not path.is_relative_to(root / "config"), path
        assert not path.is_relative_to(root / "src" / "chenhorng"), path

sys.addaudithook(refuse)
import thirdbody as tb
layer = dict(viscosity_cSt=90, particle_diameter_nm=300, particle_density_per_m2=1e11)
one = tb.solve(load_N=10, roughness_nm=300, **layer, parameters=tb.load_parameters())
other = tb.solve(load_N=10, roughness_nm=300, **layer, parameters=tb.ensemble()[1])
print(float(one.solid_load_fraction), float(other.solid_load_fraction))
rig = tb.bearing(ball="silicon nitride", speed_m_per_s=2.0, oil_density_kg_per_m3=870)
tb.stream("points.nc", load_N=[1, 10], roughness_nm=300, **layer, parameters=rig)
tb.plot(tb.grid(load_N=[1, 3, 10], roughness_nm=[300], **layer), over="load_N")
import thirdbody.command
"""


def base_packages():
    """The packages that an installation without extras brings, and those that they require."""
    names, left = set(), list(map(Requirement, PROJECT["dependencies"]))
    while left:
        requirement = left.pop()
        applies = requirement.marker is None or requirement.marker.evaluate({"extra": ""})
        if applies and requirement.name not in names:
            names.add(requirement.name)
            left += map(Requirement, distribution(requirement.name).requires or ())
    return names


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
    for name in base_packages():
        for top in {file.parts[0] for file in distribution(name).files if file.parts[0] != ".."}:
            (packages / top).symlink_to(distribution(name).locate_file(top))
    one_set = yaml.safe_dump(thirdbody.load_parameters().as_dict())
    (folder / "one_set.yaml").write_text(one_set, encoding="utf-8")

    def run(code, *arguments):
        python = [folder / "venv" / "bin" / "python", "-c", code, *arguments]
        environment = os.environ | {"PYTHONPATH": ""}
        return subprocess.run(python, cwd=folder, env=environment, capture_output=True, text=True)

    return run


def example(installed, name):
    """The words of the example in the help of a command, after ``thirdbody``."""
    done = installed(COMMAND, name, "--help")
    return shlex.split(done.stdout.partition("example:")[2].replace("\\\n", ""))[1:]


def test_the_example_of_the_readme_prints_the_same_from_the_wheel(installed, capsys):
    (code,) = re.findall(r"```python\n(.*?)```", README, re.DOTALL)
    exec(code, {})
    done = installed(code)
    assert (done.stdout, done.stderr) == (capsys.readouterr().out, "")


@pytest.mark.parametrize("name", COMMANDS)
def test_each_command_answers_without_an_extra(installed, name):
    words = [
        *example(installed, name),
        "--inputs",
        "one_set.yaml",
    ]  # without an ensemble, to be quick
    if "--plot" in words:
        place = words.index("--plot")
        needs_matplotlib = installed(COMMAND, *words)
        assert needs_matplotlib.returncode == command.BAD_INPUT
        assert '"thirdbody[plot]"' in needs_matplotlib.stderr
        words = words[:place] + words[place + 2 :]
    done = installed(COMMAND, *words)
    assert (done.returncode, done.stderr) == (command.ANSWERED, "")


def test_the_wheel_has_the_data_that_the_library_needs(installed):
    done = installed(NEEDS_DATA)
    assert done.stderr == ""
    assert done.stdout == f"{thirdbody.load_parameters()!r} {thirdbody.__version__}\n"


def test_the_wheel_has_the_workflow_beside_the_modules_that_it_runs(installed):
    done = installed(
        "from chenhorng.home import config_directory; home = config_directory().parent; "
        "print(*sorted(path.name for path in home.iterdir() if path.suffix != '.py'))"
    )
    assert {"Snakefile", "config", "profiles", "workflow"} <= {*done.stdout.split()}, done.stderr


def test_the_library_needs_nothing_of_the_paper(tmp_path):
    library = {"PYTHONPATH": str(ROOT / "src"), "MPLBACKEND": "agg"}
    done = subprocess.run(
        [sys.executable, "-c", ALONE, ROOT],
        cwd=tmp_path,
        env=os.environ | library,
        capture_output=True,
        text=True,
    )
    assert done.returncode == 0, done.stderr
    first, second = map(float, done.stdout.split())
    layer = dict(viscosity_cSt=90, particle_diameter_nm=300, particle_density_per_m2=1e11)
    layer |= dict(load_N=10, roughness_nm=300)
    assert first == thirdbody.solve(**layer).solid_load_fraction
    assert (
        second == thirdbody.solve(**layer, parameters=thirdbody.ensemble()[1]).solid_load_fraction
    )


def test_a_missing_extra_is_named_in_one_line(installed):
    done = installed("import thirdbody as tb; tb.plot")
    assert done.returncode == 1
    assert '"thirdbody[plot]"' in done.stderr.splitlines()[-1]
    assert "plot" in PROJECT["optional-dependencies"]


def test_an_editor_sees_the_names_where_they_are():
    stub = {"__package__": "thirdbody"}
    exec(Path(thirdbody.__file__).with_suffix(".pyi").read_text(encoding="utf-8"), stub)
    seen = {name: value for name, value in stub.items() if not name.startswith("__")}
    given = {name: getattr(thirdbody, name) for name in thirdbody.__all__ if name != "__version__"}
    assert seen == given
