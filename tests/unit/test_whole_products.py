"""Products appear whole or not at all: all that is written for them goes through ``whole``."""

import ast
from pathlib import Path

import pytest

ROOT = Path(__file__).resolve().parents[2]
LIBRARY = sorted((ROOT / "src" / "thirdbody").rglob("*.py"))
SCRIPTS = sorted((ROOT / "workflow" / "scripts").glob("*.py"))
WHOLE = {"whole", "whole_folder"}
NO_PRODUCTS = {  # write a log, a record of a product, the lock and the record of a run
    *("logged", "_write_record"),
    *("_lock", "_put_record", "_count_on"),
}
WRITERS = {
    *("write_text", "write_bytes", "savefig", "to_netcdf", "to_csv", "to_json", "to_zarr"),
    *("savetxt", "savez", "tofile", "imsave", "copyfile", "copy2", "copytree"),
}
LIBRARY_WRITERS = {  # write where they are told to; write_text is one more
    *("write_csv", "write_schema", "write_dataset", "write_drawn_data"),
    *("write_netcdf", "write_sections", "write_chunk", "write_catalogue"),
    *("stage", "seal", "pack", "_copy", "_write_json", "_write_manifest"),
}
OPENERS = {"open", "Dataset", "File", "ZipFile", "TarFile"}
MODES = {"w", "a", "x", "wb", "ab", "xb", "w+", "r+", "a+", "wt", "wb+", "r+b"}


class Writes(ast.NodeVisitor):
    """``bare``: line and function of each call that writes to no place which ``whole`` gave."""

    def __init__(self, tree, writers):
        self.writers, self.given, self.function, self.bare = writers, set(), None, []
        self.visit(tree)

    def visit_FunctionDef(self, node):
        before, self.function = self.function, self.function or node.name
        self.generic_visit(node)
        self.function = before

    def visit_With(self, node):
        before = self.given
        for item in node.items:
            self.visit(item.context_expr)
            if called(item.context_expr) in WHOLE and item.optional_vars:
                self.given = self.given | names(item.optional_vars)
        for statement in node.body:
            self.visit(statement)
        self.given = before

    def visit_For(self, node):
        before = self.given
        if names(node.iter) & self.given:
            self.given = self.given | names(node.target)
        self.generic_visit(node)
        self.given = before

    def visit_Call(self, node):
        arguments = [*node.args, *(keyword.value for keyword in node.keywords)]
        texts = {one.value for one in arguments if isinstance(one, ast.Constant)}
        opened = called(node) in OPENERS and texts & MODES
        if (opened or called(node) in self.writers) and not names(node) & self.given:
            self.bare.append((node.lineno, self.function))
        self.generic_visit(node)


def called(node):
    """Name of the function or method that is called, if ``node`` is a call of one."""
    function = getattr(node, "func", None)
    return getattr(function, "attr", None) or getattr(function, "id", None)


def names(node):
    """All names in an expression."""
    return {one.id for one in ast.walk(node) if isinstance(one, ast.Name)}


def parsed(path):
    return ast.parse(path.read_text(encoding="utf-8"))


@pytest.fixture(scope="module")
def writers():
    """What writes where it is told to: of Python, of libraries, and of this one, by name."""
    trees = [parsed(path) for path in LIBRARY]
    known = set(WRITERS)
    while True:
        bare = {name for tree in trees for _, name in Writes(tree, known).bare}
        more = bare - NO_PRODUCTS - known
        if not more:
            return known
        known |= more


def test_the_library_has_no_other_writers(writers):
    assert writers - WRITERS == LIBRARY_WRITERS


@pytest.mark.parametrize("script", SCRIPTS, ids=lambda script: script.stem)
def test_a_script_writes_products_through_whole_alone(script, writers):
    assert Writes(parsed(script), writers).bare == []


WRONG = {
    "open": "open(place, 'w')",
    "open by keyword": "open(place, mode='ab')",
    "of a path": "Path(place).write_text(text)",
    "of a library": "dataset.to_netcdf(place)",
    "of this library": "write_csv(place, rows, columns)",
    "figure": "figure.savefig(place)",
    "elsewhere within whole": "with whole(place) as part:\n    np.savetxt(place, rows)",
    "after whole": "with whole(place) as part:\n    pass\npart.write_text(text)",
    "another file": "with whole(place) as part, netCDF4.Dataset(other, 'w') as file:\n    pass",
}
RIGHT = {
    "within whole": "with whole(place) as part:\n    np.savetxt(part, rows)",
    "several": "with whole(a, b) as (first, second):\n    write_csv(second, rows, columns)",
    "each of several": "with whole(*a) as parts:\n    for p in parts:\n        p.write_text(text)",
    "nested": "with whole(a) as part, netCDF4.Dataset(part, 'w') as file:\n    pass",
    "reading": "with open(place, 'rb') as file:\n    file.read()",
}


@pytest.mark.parametrize("text", WRONG.values(), ids=WRONG)
def test_a_bare_write_is_found(text, writers):
    assert len(Writes(ast.parse(text), writers).bare) == 1


@pytest.mark.parametrize("text", RIGHT.values(), ids=RIGHT)
def test_a_write_beside_its_place_is_right(text, writers):
    assert Writes(ast.parse(text), writers).bare == []
