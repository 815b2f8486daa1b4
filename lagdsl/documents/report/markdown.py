"""Reports in Markdown with TeX formulas between dollars, as GitHub, GitLab and pandoc read them."""

from __future__ import annotations

import re
from base64 import b64encode
from collections.abc import Callable
from html import escape
from typing import assert_never

from lagdsl.documents.report.boxes import Box, Matrix
from lagdsl.documents.report.broken import lines, sign_and_rest
from lagdsl.documents.report.document import (
    Block,
    Bullets,
    Document,
    Drawing,
    Equation,
    Equations,
    Heading,
    Inline,
    Paragraph,
    Table,
    inline,
)
from lagdsl.documents.report.figure.svg import svg
from lagdsl.documents.report.latex_math import tex
from lagdsl.documents.report.unicode_math import line

_WIDTH = 90
_SPECIAL = re.compile(r"([\\`*_\[\]$|~])")


def markdown(document: Document) -> str:
    parts = [f"# {_escape(document.title)}"]
    if document.subtitle:
        parts.append(f"*{_escape(document.subtitle.strip())}*")
    return "\n\n".join([*parts, *(_block(block) for block in document.blocks)]).rstrip() + "\n"


def _block(block: Block) -> str:
    match block:
        case Heading(title, step):
            return f"## {title}" if step is None else f"## {step}. {title}"
        case Paragraph(content):
            return _inline(content)
        case Equations(equations):
            rows = " \\\\\n".join(_equation(equation) for equation in equations)
            return f"$$\n\\begin{{aligned}}\n{rows}\n\\end{{aligned}}\n$$"
        case Table(header, rows):
            head = [" | ".join(header), " | ".join("---" for _ in header)]
            body = [" | ".join(_inline(cell) for cell in row) for row in rows]
            return "\n".join(f"| {row} |" for row in [*head, *body])
        case Bullets(items):
            return "\n".join(f"- {_inline(item)}" for item in items)
        case Drawing(figure, legend):
            image = b64encode(svg(figure, alone=True).encode()).decode()
            return f"![{_escape(figure.words)}](data:image/svg+xml;base64,{image})\n\n{_inline(legend)}"
        case _:
            assert_never(block)


def _equation(equation: Equation) -> str:
    return aligned(equation, _WIDTH)


def aligned(equation: Equation, width: int, narrowed: Callable[[str], str] = str) -> str:
    """Lines of an `aligned` environment, further ones indented; `narrowed` makes those small that are too wide."""
    rows = []

    def shown(box: Box) -> str:
        return narrowed(tex(box)) if len(line(box)) > width or isinstance(box, Matrix) else tex(box)

    for part in lines(equation, width):
        if part.left is not None:
            rows.append(f"{tex(part.left)} &= {shown(part.right)}")
        elif part.continued:
            sign, rest = sign_and_rest(part.right)
            rows.append(rf"&\quad {sign} {shown(rest)}")
        else:
            rows.append(f"&{shown(part.right)}")
    return " \\\\\n".join(rows)


def _inline(content: Inline) -> str:
    return inline(content, lambda box: f"${tex(box).strip()}$", _escape, lambda words: f"**{_escape(words)}**", _code)


def _escape(text: str) -> str:
    """Words without any meaning to Markdown or HTML."""
    plain = " ".join("".join(c if c.isprintable() else " " for c in text).split(" "))
    return escape(_SPECIAL.sub(r"\\\1", plain), quote=False)


def _code(text: str) -> str:
    """A code span; a table cell must not hold a bare bar."""
    words = "".join(c if c.isprintable() else " " for c in text).replace("|", "¦")
    longest = max((len(run) for run in re.findall("`+", words)), default=0)
    fence = "`" * (longest + 1)
    return f"{fence} {words} {fence}" if longest else f"{fence}{words}{fence}"
