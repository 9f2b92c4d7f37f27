"""Texts in Markdown."""

import re

MARKUP = re.compile(r"[\\`*_<>\[\]|&~$]")  # characters with a meaning in Markdown


def markdown_text(text: str) -> str:
    """The ``text`` as a line of Markdown, with every character of ``MARKUP`` escaped."""
    return MARKUP.sub(r"\\\g<0>", " ".join(text.split()))
