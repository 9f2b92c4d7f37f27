"""Configuration files that went wrong: each a file, its content, and the words that name the fault."""

from __future__ import annotations

import random
from collections.abc import Iterator
from dataclasses import dataclass
from functools import partial

import yaml
from workspace import ABSENT, ROOT

FILES = {
    "config/config.yaml": 110,
    "config/scenes.yaml": 110,
    "config/inputs.yaml": 50,
    "config/calibration.yaml": 60,
    "config/sensitivity.yaml": 60,
    "config/paper_tables.yaml": 20,
    "config/claims.yaml": 60,
}
WRONG_TYPES = ("word", 17.5, [], {}, None, True, [["a"]], {"a": {"b": 1}}, 10**400)
WRONG_NUMBERS = (float("nan"), float("inf"), float("-inf"), -1.0, 0.0, 1e300, [1.0] * 2000)
HOSTILE = (
    *("a b", "it's", 'say "no"', "a\nb", "../../x", "/etc/passwd", "config/../../x.yaml"),
    *("$(touch pwned)", "`touch pwned`", "x; touch pwned", "x | touch pwned", "> pwned"),
    *("{input}", "{wildcards.figure}", "%s%n", "\x1b[31m", "~", "*", "x" * 10_000),
)
BOMB = "a0: &a0 [x, x]\n" + "".join(f"a{n}: &a{n} [*a{n - 1}, *a{n - 1}]\n" for n in range(1, 40))
# of a whole file; test_configuration.py has more that is no plain data
SYNTAX = {
    "tag that runs a command": b'\nx: !!python/object/apply:os.system ["touch pwned"]\n',
    "bomb": b"\n" + BOMB.encode(),
    "template": b"\n__use_yte__: true\n?__import__('os').system('touch pwned'): 1\n",
    "not UTF-8": b"\nx: \xff\xfe\n",
    "null byte": b"\nx: \x00\n",
    "escape": b"\nx: \x1b[2J\n",
    "open quote": b"\nx: 'y\n",
    "deep mappings": b"\nx: " + b"{y: " * 200 + b"}" * 200 + b"\n",
    "empty": b"",
    "list": b"- a\n",
    "noise": random.Random(0).randbytes(2000),
}


# what people write: the way to an entry, and its value
SLIPS = {
    "config/config.yaml": (
        (("inputs",), "soft.yaml"),
        (("inputs",), "/tmp/soft.yaml"),
        (("inputs",), "../config/inputs.yaml"),
        (("inputs",), "config/none.yaml"),
        (("inputs",), "config/claims.yaml"),
        (("inputs",), ["truncation"]),
        (("inputs",), {"truncation": "2.5"}),
        (("inputs",), {"hardness_surface_1": "3e9"}),
        (("inputs",), {"hardness_surface_1": 3.0}),
        (("inputs",), {"spread_ratio": 0.0}),
        (("inputs",), {"summit_offset": True, "summit_parameter": 0.0195}),
        (("inputs",), {"summit_offset": True, "summit_parameter_exponent": -1.38}),
        (("calibrated",), "config/inputs.yaml"),
        (("calibrated",), "config/none.yaml"),
        (("rtol",), "1e-9"),
        (("windows", "particle_diameter_per_roughness"), [2.5, 0.3]),
        (("windows", "count"), 10**12),
    ),
    "config/scenes.yaml": (
        (("load_axis", "load_N"), [80, 0.04]),
        (("load_axis", "load_N"), ["1e-2", 80]),
        (("load_axis", "count"), 10**12),
        (("scenes", "fig03", "curves", 0, "particle_density_per_m2"), ["1e11"]),
        (("scenes", "fig03", "curves", 0, "particle_density_per_m2"), [10**400]),
        (("scenes", "fig03", "curves", 0, "roughness_nm"), [3e-7]),
        (("scenes", "fig03", "title"), ""),
    ),
}


@dataclass(frozen=True)
class Mutation:
    """New ``content`` of ``file``; a refusal must say one of ``words``."""

    name: str
    file: str
    content: bytes
    words: tuple[str, ...]


def mutations(step: int = 1) -> list[Mutation]:
    """The same files every time: those of the syntax, and a choice of those of keys and values; of
    all these every so many."""
    chance = random.Random(300)
    planned = []
    for file, count in FILES.items():
        before = (ROOT / file).read_bytes()
        for name, added in SYNTAX.items():
            content = before + added if added.startswith(b"\n") else added
            words = file.rpartition("/")[2], "'x'", "'__use_yte__'"
            planned.append(partial(Mutation, f"{file}: {name}", file, content, words))
        changes = list(_changes(yaml.safe_load(before)))
        for change in chance.sample(changes, count):
            planned.append(partial(_changed, file, before.decode(), *change))
    return [make() for make in planned[::step]]


def slips() -> list[Mutation]:
    """The files of ``SLIPS``."""
    return [
        _changed(file, (ROOT / file).read_text(encoding="utf-8"), way, "replaced", new)
        for file, changes in SLIPS.items()
        for way, new in changes
    ]


def _changes(content) -> Iterator[tuple[tuple, str, object]]:
    """The way to an entry, what is done to it, and its new value or name."""
    for way, value in _places(content):
        if isinstance(content, list) and len(way) == 1:
            continue
        yield way, "dropped", ABSENT
        if isinstance(way[-1], str):
            yield way, "renamed", f"{way[-1]}_um"
        if len(way) == 1:
            yield way, "doubled", value
        wrong = [new for new in WRONG_TYPES if type(new) is not type(value)]
        if isinstance(value, (int, float)) and not isinstance(value, bool):
            wrong += [*WRONG_NUMBERS, -value, str(value)]
        if isinstance(value, list):
            wrong += [value * 1000, [*value, "word"], [*value, float("nan")]]
        if isinstance(value, str):
            wrong += HOSTILE
        for new in wrong:
            yield way, "replaced", new
        if isinstance(value, dict):
            for name in HOSTILE:
                yield (*way, name), "added", next(iter(value.values()), 1)


def _changed(file, text, way, what, new) -> Mutation:
    """The text of a file after one change."""
    shown = repr(new)[:40] if what == "replaced" else ""
    name = f"{file}: {'/'.join(map(str, way))[:80]} {what} {shown}"
    words = tuple(
        repr(part)[1:-1][:20] if isinstance(part, str) else f"[{part}]" for part in way[-3:]
    )
    if what == "renamed":
        words = (new, way[-1])
    if what == "replaced" and isinstance(new, str):
        words += (repr(new)[1:-1][:20] or "''",)
    if isinstance(
        way[0], int
    ):  # a statement: what else it must have, or another that it contradicts
        words += ("must be given", "contradicts")
    if what == "doubled":
        changed = f"{text}\n{_dumped({way[-1]: new})}"
    else:
        content = yaml.safe_load(text)
        place = content
        for part in way[:-1]:
            place = place[part]
        if new is ABSENT:
            del place[way[-1]]
        elif what == "renamed":
            place[new] = place.pop(way[-1])
        else:
            place[way[-1]] = new
        changed = _dumped(content)
    return Mutation(name, file, changed.encode(), words)


class _Plain(yaml.SafeDumper):
    """YAML without anchors."""

    def ignore_aliases(self, data):
        return True


def _dumped(content) -> str:
    return yaml.dump(content, Dumper=_Plain, sort_keys=False, allow_unicode=True)


def _places(content, way=()) -> Iterator[tuple[tuple, object]]:
    """Each entry of nested mappings and lists, with its way from the top."""
    entries = content.items() if isinstance(content, dict) else enumerate(content)
    for key, value in entries:
        yield (*way, key), value
        if isinstance(value, (dict, list)):
            yield from _places(value, (*way, key))
