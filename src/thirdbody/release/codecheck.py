"""codecheck.yml: which products an independent checker compares, and how (CODECHECK 1.0).

In the root of the repository ``python -m thirdbody.release.codecheck > codecheck.yml`` writes it
anew from the list of products in the Snakefile.
"""

from __future__ import annotations

import ast
import re
import sys
from os import PathLike
from pathlib import Path, PurePosixPath

import yaml

from thirdbody.release.citation import Release

SPECIFICATION = "https://codecheck.org.uk/spec/config/1.0/"
# How a product is compared, by its folder and ending.  Files with other endings hold the same in
# another format and are not compared.
COMPARED = {
    ("datasets", ".nc"): "every value is compared, to the relative error in the attribute rtol",
    ("tables", ".csv"): "every number is compared, to the error in its row if there is one",
    ("figures", ".png"): "compared by eye, with the figure of the paper where it has one",
    ("figures", ".csv"): "the points drawn; every number is compared",
    ("claims", ".csv"): "statements of the paper; every verdict is compared",
    ("claims", ".json"): "the same verdicts for programs; every one is compared",
    ("explorer", ".html"): "opened in a browser; its curves are those of the figures",
    ("accuracy", ".csv"): "time of solving; its order of magnitude is compared, as machines differ",
}


def targets(snakefile: str | PathLike) -> list[str]:
    """The products that the workflow makes by default.

    Parameters
    ----------
    snakefile : path
        A Snakefile whose ``rule all`` lists file names, and calls of ``multiext``, literally.  They
        begin with ``<results>``, which is ``results`` in a run without a name.

    Returns
    -------
    list of str
        File names, in the order of the list.
    """
    text = Path(snakefile).read_text(encoding="utf-8")
    after = text.partition("\nrule all:\n")[2].partition("    input:\n")[2]
    items = re.match(r"(?: {8}.*\n)*", after)[0]
    return [
        name
        for element in ast.parse(f"[\n{items}]", mode="eval").body.elts
        for name in _names(element)
    ]


def _names(element: ast.expr) -> list[str]:
    """File names that an element of the list stands for: itself, or those of a ``multiext``."""
    if isinstance(element, ast.Call):
        stem, *endings = map(ast.literal_eval, element.args)
        names = [f"{stem}{ending}" for ending in endings]
    else:
        names = [ast.literal_eval(element)]
    return [name.replace("<results>", "results") for name in names]


def codecheck_text(products: list[str], release: Release) -> str:
    """Text of ``codecheck.yml``, to which a checker adds who checked and what was found.

    Parameters
    ----------
    products : list of str
        File names in ``results/``; those that are not compared are left out.
    release : Release
        What is checked.

    Returns
    -------
    str
        YAML.

    References
    ----------
    https://codecheck.org.uk/spec/config/1.0/
    """
    content = {
        "version": SPECIFICATION,
        "source": f"{release.citation['title']}, version {release.version}",
        "paper": {
            "title": release.paper["title"],
            "authors": [
                {"name": f"{author['given-names']} {author['family-names']}"}
                for author in release.paper["authors"]
            ],
            "reference": f"https://doi.org/{release.paper['doi']}",
        },
        "manifest": [
            {"file": product, "comment": COMPARED[_sort(product)]}
            for product in products
            if _sort(product) in COMPARED
        ],
    }
    text = yaml.safe_dump(content, sort_keys=False, allow_unicode=True, width=10**6)
    return f"---\n{text}"


def _sort(product: str) -> tuple[str, str]:
    """Folder below ``results/`` and ending of a product."""
    path = PurePosixPath(product)
    return path.parts[1], path.suffix


if __name__ == "__main__":
    release = Release.of("pyproject.toml", "CITATION.cff")
    sys.stdout.write(codecheck_text(targets("workflow/Snakefile"), release))
