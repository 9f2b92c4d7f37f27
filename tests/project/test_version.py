"""The version is that of the commit that runs, wherever the sources are."""

import io
import runpy
import shutil
import subprocess
import zipfile
from pathlib import Path

import pytest

import thirdbody.version

PLACE = Path("src/thirdbody")
PERSON = ("-c", "user.name=tests", "-c", "user.email=tests@localhost")


class Repository:
    """A repository with the module of the version, and other files."""

    def __init__(self, root):
        self.root = root
        (root / PLACE).mkdir(parents=True)
        for name in ("version.py", "version.json"):
            shutil.copyfile(Path(thirdbody.version.__file__).with_name(name), root / PLACE / name)
        shutil.copyfile(Path(__file__).parents[2] / ".gitattributes", root / ".gitattributes")
        self.git("init", "--quiet")
        self.commit("film.py")

    def git(self, *arguments):
        done = subprocess.run(["git", *PERSON, *arguments], cwd=self.root, capture_output=True)
        assert done.returncode == 0, done.stderr
        return done.stdout

    def commit(self, name):
        """Commit a change of a file; the first digits of the commit."""
        with open(self.root / name, "a") as file:
            file.write("changed\n")
        self.git("add", ".")
        self.git("commit", "--quiet", "--message", name)
        return self.git("rev-parse", "HEAD").decode()[:7]


def asked(root):
    """The version that the module at ``root`` says, in a fresh process as it were."""
    return runpy.run_path(str(root / PLACE / "version.py"))["current"]().text


@pytest.fixture
def repository(tmp_path, needs_git):
    return Repository(tmp_path / "repository")


def test_it_counts_commits_since_the_last_tag_and_says_what_is_not_committed(repository):
    commit = repository.commit("page.py")
    assert asked(repository.root) == f"0.1.0.dev2+g{commit}"
    repository.git("tag", "v0.1.0")
    assert asked(repository.root) == "0.1.0"
    commit = repository.commit("page.py")
    assert asked(repository.root) == f"0.2.0.dev1+g{commit}"
    (repository.root / "film.py").write_text("edited")
    assert asked(repository.root) == f"0.2.0.dev1+g{commit}.dirty"


def test_a_shallow_clone_without_a_tag_says_no_number(repository, tmp_path):
    repository.git("tag", "v0.2.0")
    commit = repository.commit("page.py")
    shallow = tmp_path / "shallow"
    repository.git("clone", "--quiet", "--depth=1", repository.root.as_uri(), str(shallow))
    assert asked(shallow) == f"0+g{commit}"
    (shallow / "film.py").write_text("edited")
    assert asked(shallow) == f"0+g{commit}.dirty"
    repository.git("tag", "v0.3.0")
    shutil.rmtree(shallow)
    repository.git("clone", "--quiet", "--depth=1", repository.root.as_uri(), str(shallow))
    assert asked(shallow) == "0.3.0"


def test_a_folder_of_another_user_says_its_version(repository, monkeypatch):
    expected = asked(repository.root)
    monkeypatch.setenv("GIT_TEST_ASSUME_DIFFERENT_OWNER", "1")
    assert asked(repository.root) == expected != thirdbody.version.UNKNOWN


def test_an_export_says_its_commit_and_another_copy_that_it_does_not_know(repository, tmp_path):
    repository.git("tag", "v0.1.0")
    commit = repository.commit("page.py")
    export = io.BytesIO(repository.git("archive", "--format=zip", "HEAD"))
    zipfile.ZipFile(export).extractall(tmp_path / "export")
    assert asked(tmp_path / "export") == f"0.2.0.dev1+g{commit}"
    shutil.copytree(repository.root / "src", tmp_path / "copy" / "src")
    assert asked(tmp_path / "copy") == thirdbody.version.UNKNOWN
