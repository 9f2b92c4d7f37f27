"""codecheck.yml: which products an independent checker compares, and how (CODECHECK 1.0).

In the root of the repository, after a run:

    python -m thirdbody.release.codecheck results/*/* > codecheck.yml
"""

from __future__ import annotations

import sys
from collections.abc import Iterable
from pathlib import PurePosixPath

import yaml

from thirdbody.release.citation import Release

SPECIFICATION = "https://codecheck.org.uk/spec/config/1.0/"
# How a product is compared, by its folder and suffix.  Other files hold the same in another format.
COMPARED = {
    ("datasets", ".nc"): "every value is compared, to the relative error in the attribute rtol",
    ("tables", ".csv"): "every number is compared, to the error in its row if there is one",
    ("figures", ".png"): "compared by eye, with the figure of the paper where it has one",
    ("figures", ".csv"): "the points drawn; every number is compared",
    ("claims", ".csv"): "statements of the paper; every verdict is compared",
    ("claims", ".json"): "the same verdicts for programs; every one is compared",
    ("explorer", ".html"): "opened in a browser; its curves are those of the figures",
}


def codecheck_text(products: Iterable[str], release: Release) -> str:
    """Text of ``codecheck.yml``, to which a checker adds who checked and what was found.

    Parameters
    ----------
    products : iterable of str
        Files in ``results/``, in any order; those that are not compared are left out.
    release : Release
        What is checked.

    Returns
    -------
    str
        YAML, with the kinds of products in the order of ``COMPARED``.

    References
    ----------
    https://codecheck.org.uk/spec/config/1.0/
    """
    paths = [PurePosixPath(name) for name in sorted(products)]
    manifest = [
        {"file": str(path), "comment": comment}
        for (folder, suffix), comment in COMPARED.items()
        for path in paths
        if (path.parent.name, path.suffix) == (folder, suffix)
    ]
    content = {
        "version": SPECIFICATION,
        "source": f"{release.citation['title']}, version {release.version}",
        "paper": {
            "title": release.paper["title"],
            "authors": [
                {"name": f"{author['given-names']} {author['family-names']}"}
                for author in release.paper["authors"]
            ],
            "reference": release.paper_url,
        },
        "manifest": manifest,
    }
    text = yaml.safe_dump(content, sort_keys=False, allow_unicode=True, width=10**6)
    return f"---\n{text}"


if __name__ == "__main__":
    sys.stdout.write(codecheck_text(sys.argv[1:], Release.of("pyproject.toml", "CITATION.cff")))
