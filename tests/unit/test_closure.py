"""The modules that a script needs, found from its import statements."""

import subprocess
import sys
from pathlib import Path

import pytest

from thirdbody.run.closure import HOMES, import_closure

ROOT = Path(__file__).parents[2]
SCRIPTS = sorted((ROOT / "workflow" / "scripts").glob("*.py"))


@pytest.fixture
def closure_of(tmp_path):
    """Names of the package's modules that a script with the given text needs."""

    def names(text):
        script = tmp_path / "script.py"
        script.write_text(text)
        # results are relative to the repository, one of a script elsewhere as well
        return {Path(path).stem for path in import_closure(script)}

    return names


FORMS = {
    "from a module": "from thirdbody.model.film import Film",
    "of a module": "import thirdbody.model.film",
    "of a module under a name": "import thirdbody.model.film as f",
    "of a module from the package": "from thirdbody.model import film",
    "among others": "import os, thirdbody.model.film, sys",
    "inside a function": "def f():\n    from thirdbody.model.film import Film\n",
    "under a condition": "if True:\n    import thirdbody.model.film\n",
    "over several lines": "from thirdbody.model.film import (\n    Film,\n)\n",
}


@pytest.mark.parametrize("form", FORMS)
def test_every_form_of_import_is_followed(closure_of, form):
    # the film needs the parameters, these their bounds, readings and messages, and all the package
    assert closure_of(FORMS[form]) == {
        "__init__",
        "bounds",
        "computed_once",
        "film",
        "load_unit",
        "messages",
        "parameters",
        "readings",
    }


def test_a_script_that_imports_nothing_of_the_package_needs_nothing(closure_of):
    assert closure_of("import numpy\nfrom os import path\n") == set()


def test_names_that_only_look_like_the_package_are_not_followed(closure_of):
    text = "import thirdbody_tools.film\n'import thirdbody.model.film'\n# import thirdbody.model.film\n"
    assert closure_of(text) == set()


def test_a_package_inside_the_package_is_followed(closure_of):
    needed = closure_of("from thirdbody.figures.registry import CURVE_FIGURES")
    assert {"registry", "__init__"} <= needed


def test_each_script_of_the_workflow_needs_what_it_really_imports():
    code = (
        "import runpy, sys\n"
        "for script in sys.argv[1:]:\n"
        "    for name in [n for n in sys.modules if n.startswith(('thirdbody', 'benchmarks'))]:\n"
        "        del sys.modules[name]\n"
        "    runpy.run_path(script)\n"
        "    print(script, *(n for n in sys.modules if n.startswith(('thirdbody', 'benchmarks'))))\n"
    )
    given = [sys.executable, "-c", code, *map(str, SCRIPTS)]
    output = subprocess.run(given, capture_output=True, text=True, check=True, cwd=ROOT)
    lines = output.stdout.splitlines()
    assert len(lines) == len(SCRIPTS)
    for line in lines:
        script, *names = line.split()
        listed = set(import_closure(Path(script).relative_to(ROOT)))
        for name in names:
            path = HOMES[name.partition(".")[0]].joinpath(*name.split("."))
            files = path.with_suffix(".py"), path / "__init__.py"
            assert any(str(file.relative_to(ROOT)) in listed for file in files), (script, name)


def test_the_result_is_sorted_and_relative_to_the_repository():
    listed = import_closure("workflow/scripts/solve_scene.py")
    assert listed == sorted(set(listed))
    assert all((ROOT / path).is_file() and not Path(path).is_absolute() for path in listed)
    assert "src/thirdbody/solver/solve.py" in listed


def test_solving_does_not_need_the_figures():
    solving = import_closure("workflow/scripts/solve_scene.py")
    assert not [path for path in solving if "figures" in path]


@pytest.mark.parametrize("script", ["render_figure", "render_schematic", "render_claims"])
def test_drawing_does_not_need_the_solver(script):
    drawing = import_closure(f"workflow/scripts/{script}.py")
    assert any("figures" in path for path in drawing)
    assert not [path for path in drawing if {"solver", "curves", "study"} & set(Path(path).parts)]
