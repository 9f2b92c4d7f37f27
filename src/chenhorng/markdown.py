"""Texts in Markdown."""

import re

MARKUP = re.compile(r"[\\`*_<>\[\]|&~$]")  # characters with a meaning in Markdown


def markdown_text(text: str) -> str:
    """A text as one line of Markdown, in which its signs have no meaning."""
    return MARKUP.sub(r"\\\g<0>", " ".join(text.split()))
