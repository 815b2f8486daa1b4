"""The site of the documents: Sphinx with MyST (docs/adr/0034). `make docs` builds it into build/site."""

from __future__ import annotations

import sys
from pathlib import Path

HERE = Path(__file__).resolve().parent
sys.path[:0] = [str(HERE.parent), str(HERE / "_extensions"), str(HERE / "notebooks")]

from sphinx.application import Sphinx  # noqa: E402
from sphinx.util.inspect import TypeAliasForwardRef  # noqa: E402

import lagdsl  # noqa: E402
from lagdsl.language.highlight.pygments_lexer import LagLexer  # noqa: E402

project = "lagdsl"
author = "the authors of lagdsl"
release = version = lagdsl.__version__

extensions = [
    "myst_parser",
    "sphinx.ext.autodoc",
    "sphinx.ext.napoleon",
    "sphinx_click",
    "mathml_renderer",
    "generated_pages",
    "living_pages",
    "notebook_pages",
    "search_scope",
]
exclude_patterns = ["_extensions", "**/_*.md"]
smartquotes = False  # commands can be copied
default_role = "literal"  # docstrings write `names` as Markdown does
myst_enable_extensions = ["dollarmath", "deflist", "attrs_inline"]
myst_heading_anchors = 4
myst_links_external_new_tab = False
# Indexes link to the pages of diagnostics, decisions and components; they would make the sidebar too long.
# A page of diagnostics may show a character that no lexer knows.
suppress_warnings = ["toc.not_included", "misc.highlighting_failure"]

autodoc_class_signature = "separated"  # users do not call constructors
autodoc_member_order = "bysource"
autodoc_typehints = "description"
autodoc_typehints_format = "short"
# By their names: what they stand for takes two lines for each argument.
autodoc_type_aliases = {name: name for name in ("ArrayLike", "Entries", "Floats", "Given", "Signal", "Value")}
TypeAliasForwardRef.__repr__ = lambda alias: alias.name  # type: ignore[method-assign]  # Sphinx prints this in unions

html_theme = "furo"
html_title = "lagdsl"
html_static_path = ["_static", "../lagdsl/documents/page/web/font/math.woff2"]
html_css_files = ["site.css"]
html_math_renderer = "mathml"
html_copy_source = False
html_show_sphinx = False
html_show_copyright = False
html_theme_options = {"sidebar_hide_name": False, "navigation_with_keys": True}
highlight_language = "none"
pygments_style = "friendly"


def setup(app: Sphinx) -> None:
    """Model texts on GitHub are fenced as Modelica, whose colours it knows; here they have their own."""
    app.add_lexer("modelica", LagLexer)
    app.add_lexer("lag", LagLexer)
