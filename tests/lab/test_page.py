"""The page on measurements shows what its examples print, and its data are those of their generator."""

import re
from pathlib import Path

import pytest

DOCS = Path(__file__).parents[2] / "docs"
PAGE = (DOCS / "compare.md").read_text(encoding="utf-8")


@pytest.mark.filterwarnings("error::UserWarning")
def test_the_examples_print_what_the_page_shows(monkeypatch, capsys):
    pytest.importorskip("SurfaceTopography")
    monkeypatch.chdir(DOCS / "examples")
    names = {}
    blocks = re.findall(r"```python\n(.*?)```\n(?:\n```text\n(.*?)```)?", PAGE, re.DOTALL)
    assert len(blocks) == PAGE.count("```python") and all(code for code, _ in blocks)
    for code, shown in blocks:
        exec(code, names)
        assert capsys.readouterr().out == shown


def test_the_data_are_what_their_generator_writes(tmp_path):
    source = (DOCS / "examples" / "make_measured.py").read_text(encoding="utf-8")
    exec(compile(source, "make", "exec"), {"__file__": str(tmp_path / "make_measured.py")})
    written = (tmp_path / "measured.csv").read_text(encoding="utf-8")
    assert written == (DOCS / "examples" / "measured.csv").read_text(encoding="utf-8")
