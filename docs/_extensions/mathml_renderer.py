"""Formulas of the pages as MathML: browsers draw it without scripts, fonts or network."""

from __future__ import annotations

import re

from docutils import nodes
from latex2mathml.converter import convert
from sphinx.application import Sphinx
from sphinx.writers.html5 import HTML5Translator

FUNCTION = re.compile(r"<mi>((?:arc)?(?:sin|cos|tan|cot)h?|exp|ln|log)</mi>")
THIN_SPACE = "0.167em"


def mathml(formula: str, display: str) -> str:
    """Names of functions have thin spaces around them, as TeX sets them: `R sin x`, not `Rsinx`."""
    operator = rf'<mo form="prefix" lspace="{THIN_SPACE}" rspace="{THIN_SPACE}">\1</mo>'
    return FUNCTION.sub(operator, convert(formula, display=display))


def visit_math(self: HTML5Translator, node: nodes.math) -> None:
    """A formula in a line of text."""
    self.body.append(mathml(node.astext(), "inline"))
    raise nodes.SkipNode


def visit_displaymath(self: HTML5Translator, node: nodes.math_block) -> None:
    """A formula on lines of its own."""
    self.body.append(f'<div class="formula">{mathml(node.astext(), "block")}</div>')
    raise nodes.SkipNode


def setup(app: Sphinx) -> dict[str, bool]:
    """Register the renderer as `mathml`."""
    app.add_html_math_renderer("mathml", (visit_math, None), (visit_displaymath, None))
    return {"parallel_read_safe": True, "parallel_write_safe": True}
