"""How the pages of `docs/` become a site: `make docs`, without a network."""

import os
import sys
import sysconfig
from pathlib import Path

from docutils.nodes import SkipNode
from latex2mathml.converter import convert
from pygments.lexers.special import TextLexer

sys.path.insert(0, str(Path(__file__).parent))
import configuration_reference

import thirdbody

# where pages find the command `thirdbody`
os.environ["PATH"] = os.pathsep.join([sysconfig.get_path("scripts"), os.environ["PATH"]])

project = "thirdbody"
author = "The thirdbody developers"
copyright = "2026, the thirdbody developers (code MIT, texts and data CC BY 4.0)"
release = thirdbody.__version__

extensions = ["myst_nb", "sphinx.ext.autodoc", "sphinx.ext.autosummary", "sphinx.ext.napoleon"]
myst_enable_extensions = ["colon_fence", "dollarmath"]
myst_heading_anchors = 3
html_theme = "furo"
html_title = "thirdbody"
html_math_renderer = "mathml"
html_static_path = ["site.css"]
html_css_files = ["site.css"]
templates_path = ["templates"]
exclude_patterns = ["_build", "templates"]

nb_execution_mode = "force"
nb_execution_raise_on_error = True
nb_execution_timeout = 300

autodoc_member_order = "bysource"
autodoc_typehints = "none"  # docstrings say the types with their units
napoleon_google_docstring = False
napoleon_use_rtype = False
napoleon_use_ivar = True
toc_object_entries = False


def _inline(self, node):
    self.body.append(convert(node.astext()))
    raise SkipNode


def _block(self, node):
    formula = convert(node.astext(), display="block")
    self.body.append(
        f'<p style="overflow-x: auto; padding: 0.4em 0">{formula}</p>'
    )  # where the window is narrow
    raise SkipNode


def setup(app):
    """Write formulas as MathML, which browsers show without a script from elsewhere."""
    app.connect("source-read", configuration_reference.fill)
    app.add_lexer("mermaid", TextLexer)  # a graph, which stays text in the site
    app.add_html_math_renderer("mathml", (_inline, None), (_block, None))
