"""Pages that the search of the site leaves out: records of decisions, and pages of single diagnostics.

They repeat the words of the pages that users look for. Links reach them: their indexes stay in the search.
"""

from __future__ import annotations

import re

from docutils import nodes
from sphinx.application import Sphinx

_LEFT_OUT = re.compile(r"adr/\d{4}-.*|diagnostics/[EWN]\d{4}")


def leave_out(app: Sphinx, _doctree: nodes.document) -> None:
    """Mark the page that was read. Pages could bear this mark as a field, but `lag explain` would print it."""
    page = app.env.current_document.docname
    if _LEFT_OUT.fullmatch(page):
        app.env.metadata[page]["no-search"] = ""


def setup(app: Sphinx) -> dict[str, bool]:
    """Mark pages behind Sphinx's own reading of their fields."""
    app.connect("doctree-read", leave_out, priority=900)
    return {"parallel_read_safe": True, "parallel_write_safe": True}
