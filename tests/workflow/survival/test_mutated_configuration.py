"""A mutated configuration file is refused in one line that names the fault, or means something."""

import collections
import random
import shutil

import numpy as np
import pytest
import yaml
from harm import LONG
from workspace import ROOT

from chenhorng.configuration.settings import read_settings
from chenhorng.scenes import scene_groups
from thirdbody.core.parameters import Parameters

FILES = {  # and how many mutations of each
    "config/config.yaml": 110,
    "config/scenes.yaml": 110,
}
UNREADABLE = ("\\Z", "(?", "^[")  # what is no line for people: regular expressions
WRONG_TYPES = ("word", 17.5, [], {}, None, True, [["a"]], {"a": {"b": 1}}, 10**400)
WRONG_NUMBERS = (float("nan"), float("inf"), float("-inf"), -1.0, 0.0, 1e300, 10**12, [1.0] * 2000)
HOSTILE = (
    *("a b", "it's", 'say "no"', "a\nb", "../../x", "/etc/passwd", "config/../../x.yaml"),
    *("$(touch pwned)", "`touch pwned`", "x; touch pwned", "x | touch pwned", "> pwned"),
    *("{input}", "{wildcards.figure}", "%s%n", "\x1b[31m", "~", "*", "x" * 10_000),
)


def wrong_values(value):
    """What is put in the place of a value."""
    yield from (new for new in WRONG_TYPES if type(new) is not type(value))
    if isinstance(value, (int, float)) and not isinstance(value, bool):
        yield from (*WRONG_NUMBERS, -value, str(value))
    if isinstance(value, list):
        yield from (value[::-1], value * 1000, [*value, "word"], [*value, float("nan")])
    if isinstance(value, str):
        yield from HOSTILE


def places(content, way=()):
    """The way to each entry of nested mappings and lists, and its value."""
    entries = content.items() if isinstance(content, dict) else enumerate(content)
    for key, value in entries:
        yield (*way, key), value
        if isinstance(value, (dict, list)):
            yield from places(value, (*way, key))


def changes(content):
    """The way to an entry, a new name or None where it is dropped, and its new value."""
    for way, value in places(content):
        if isinstance(content, list) and len(way) == 1:
            continue
        yield way, None, None
        if isinstance(way[-1], str):
            yield way, f"{way[-1]}_um", value
        for new in wrong_values(value):
            yield way, way[-1], new
        if isinstance(value, dict):
            for name in HOSTILE:
                yield (*way, name), name, next(iter(value.values()), 1)


class Plain(yaml.SafeDumper):
    """YAML without anchors."""

    def ignore_aliases(self, data):
        return True


def changed(text, way, name, new):
    """The text of a file after one change."""
    content = yaml.safe_load(text)
    place = content
    for part in way[:-1]:
        place = place[part]
    if name != way[-1]:
        del place[way[-1]]
    if name is not None:
        place[name] = new
    return yaml.dump(content, Dumper=Plain, sort_keys=False, allow_unicode=True)


def words_for(way, name, new):
    """Words of which a refusal must say one."""
    named = [*way[-3:], name, *([new] if isinstance(new, str) else [])]
    return {repr(part)[1:-1][:20] if isinstance(part, str) else f"[{part}]" for part in named}


@pytest.fixture
def in_folder(tmp_path, monkeypatch):
    """A folder with the configuration alone."""
    shutil.copytree(ROOT / "config", tmp_path / "config")
    monkeypatch.chdir(tmp_path)
    return tmp_path


def outcome():
    """How the configuration is taken: ``read``, or the line of its refusal."""
    try:
        settings = read_settings({}, "config")
    except ValueError as error:
        return str(error)
    inputs = Parameters(**settings["parameters"])
    for scene in settings["scenes"].values():
        assert np.isfinite(scene_groups(scene, inputs.newtons_per_load)[0]["load"]).all()
    return "read"


@pytest.mark.parametrize("file", FILES)
def test_each_is_read_or_refused_in_one_line_that_names_the_fault(in_folder, file, tell):
    place, count = in_folder / file, collections.Counter()
    original = place.read_text(encoding="utf-8")
    before = {path.name for path in in_folder.rglob("*")}
    every = list(changes(yaml.safe_load(original)))
    for change in random.Random(300).sample(every, FILES[file] // (1 if LONG else 8)):
        place.write_text(changed(original, *change), encoding="utf-8")
        message = outcome()
        count["read" if message == "read" else "refused"] += 1
        if message != "read":
            assert any(word in message for word in words_for(*change)), (change, message)
            assert len(message.splitlines()) == 1 and len(message) < 700, change
            assert not any(word in message for word in UNREADABLE), (change, message)
    assert {path.name for path in in_folder.rglob("*")} == before
    tell(f"mutated {file}: {dict(count)}")
    assert count["refused"]
