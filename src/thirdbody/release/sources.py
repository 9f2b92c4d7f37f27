"""Which files are the sources, as they are published: nothing that a run writes is among them."""

from __future__ import annotations

from pathlib import Path

SOURCES = (
    ".ci/*",
    ".dockerignore",
    ".gitignore",
    ".snakemake-workflow-catalog.yml",
    "CHANGELOG.md",
    "CITATION.cff",
    "CONTRIBUTING.md",
    "Dockerfile",
    "LICENSE",
    "LICENSE-DATA",
    "Makefile",
    "README.md",
    "codecheck.yml",
    "pyproject.toml",
    "benchmarks/*.py",
    "config/*.md",
    "config/**/*.yaml",
    "docs/*.md",
    "docs/*.py",
    "docs/*.png",
    "docs/notebooks/*.ipynb",
    "locks/*.txt",
    "src/**/*.LICENSE",
    "src/**/*.css",
    "src/**/*.html",
    "src/**/*.js",
    "src/**/*.md",
    "src/**/*.mplstyle",
    "src/**/*.py",
    "src/**/*.pyi",
    "src/**/py.typed",
    "tests/**/*.c",
    "tests/**/*.csv",
    "tests/**/*.json",
    "tests/**/*.py",
    "verification/*.py",
    "workflow/Snakefile",
    "workflow/**/*.py",
    "workflow/**/*.rst",
    "workflow/**/*.sh",
    "workflow/**/*.smk",
    "workflow/**/*.yaml",
)


def source_files() -> list[str]:
    """Sorted paths of all sources, relative to the current folder: the root of the repository."""
    return sorted({path.as_posix() for pattern in SOURCES for path in Path().glob(pattern)})
