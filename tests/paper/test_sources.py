"""What a job depends on: the files that its script runs, by content; settings without comments."""

import os

import pytest

from chenhorng.sources import Sources, settings_text

FILES = {
    "engine/__init__.py": "",
    "engine/film.py": "from engine.oil import density\n",
    "engine/oil.py": "",
    "engine/oil.csv": "850\n",
    "engine/oil.html": "a template",
    "engine/dry.py": "",
    "script.py": "from engine.film import density\n",
}


@pytest.fixture
def home(tmp_path, monkeypatch):
    """A folder with a script and the package that it imports."""
    for name, text in FILES.items():
        (tmp_path / name).parent.mkdir(exist_ok=True)
        (tmp_path / name).write_text(text)
    monkeypatch.syspath_prepend(tmp_path)
    return tmp_path


def texts(home):
    """The texts of the script by the names of their files."""
    found = Sources(home, home, "engine").of_script(home / "script.py")
    return dict(text.split(" ") for text in found)


def changed(home, name, content):
    """The files whose texts change with the content of a file, whose date becomes older."""
    before = texts(home)
    (home / name).write_text(content)
    os.utime(home / name, (0, 0))
    return dict(before.items() ^ texts(home).items()).keys()


def test_a_script_runs_itself_its_imports_theirs_and_the_data_beside_them(home):
    names = {"script.py", "engine/__init__.py", "engine/film.py", "engine/oil.py", "engine/oil.csv"}
    assert texts(home).keys() == names


@pytest.mark.parametrize("name", ["script.py", "engine/oil.py", "engine/oil.csv"])
def test_other_content_changes_the_text_of_that_file_though_its_date_is_older(home, name):
    assert changed(home, name, FILES[name] + "# a remark\n") == {name}


@pytest.mark.parametrize("name", ["engine/dry.py", "engine/oil.html"])
def test_what_a_script_does_not_run_changes_nothing(home, name):
    assert not changed(home, name, "# changed\n")


def test_the_same_content_with_another_date_changes_nothing(home):
    assert not changed(home, "engine/film.py", FILES["engine/film.py"])


LATE = "def late():\n    import engine.dry"


@pytest.mark.parametrize("name", ["script.py", "engine/oil.py"])
@pytest.mark.parametrize("line", ["import engine.dry", "from engine import dry", LATE])
def test_a_new_import_adds_its_module(home, name, line):
    assert changed(home, name, f"{FILES[name]}{line}\n") == {name, "engine/dry.py"}


def test_files_of_the_project_are_relative_in_its_folder_alone(home, tmp_path_factory, monkeypatch):
    sources = Sources(home / "packages", home, "engine")
    monkeypatch.chdir(tmp_path_factory.mktemp("elsewhere"))
    assert sources.project_file("src/engine/oil.html") == str(home / "packages/engine/oil.html")
    assert sources.project_file("config") == str(home / "config")
    monkeypatch.chdir(home)
    assert sources.project_file("src/engine/oil.html") == "packages/engine/oil.html"


def test_settings_are_their_content_without_comments(tmp_path):
    path = tmp_path / "settings.yaml"
    path.write_text("rtol: 1.0e-9\n")
    text = settings_text(path)
    path.write_text("# a remark\nrtol:   1.0e-9  # another\n")
    assert settings_text(path) == text and text.startswith(f"{path} ")
    path.write_text("rtol: 1.0e-8\n")
    assert settings_text(path) != text
    with pytest.raises(ValueError, match="allowed: a readable YAML file"):
        settings_text(tmp_path / "none.yaml")
