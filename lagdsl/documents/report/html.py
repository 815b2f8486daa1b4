"""Reports as one self-contained HTML page: MathML, a style sheet, a picture; no script, nothing from a network."""

from __future__ import annotations

from base64 import b64encode
from collections.abc import Sequence
from html import escape
from typing import assert_never

from lagdsl.documents.report.boxes import EQUALS, Row
from lagdsl.documents.report.broken import Line, lines, sign_and_rest
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
from lagdsl.documents.report.html_style import STYLE
from lagdsl.documents.report.mathml import element, mathml
from lagdsl.documents.report.unicode_math import line as unicode_line

_WIDTH = 92


def html(document: Document, picture: bytes | None = None) -> str:
    """`picture` is a PNG that stands before everything else."""
    allowed = "style-src 'unsafe-inline'" + ("" if picture is None else "; img-src data:")
    subtitle = f'\n<p class="subtitle">{escape(document.subtitle)}</p>' if document.subtitle else ""
    return f"""<!DOCTYPE html>
<html lang="en">
<head>
<meta charset="utf-8">
<meta name="viewport" content="width=device-width, initial-scale=1">
<meta http-equiv="Content-Security-Policy" content="default-src 'none'; {allowed}">
<title>{escape(document.title)}: equations of motion</title>
<style>
{STYLE}</style>
</head>
<body>
<main>
<header>
<p class="kicker">Equations of motion</p>
<h1>{escape(document.title)}</h1>{subtitle}
</header>
{_picture(picture, document.title)}{sections(document.blocks)}
</main>
</body>
</html>
"""


def _picture(picture: bytes | None, title: str) -> str:
    if picture is None:
        return ""
    data = f"data:image/png;base64,{b64encode(picture).decode()}"
    image = f'<img style="max-width: 100%" alt="A motion of {escape(title)}" src="{data}">'
    return f'<figure style="margin: 1.2rem 0">{image}</figure>\n'


def sections(blocks: Sequence[Block], width: int = _WIDTH) -> str:
    """A section from each heading to the next; equations in lines of about `width` letters."""
    pieces: list[str] = []
    is_open = False
    for block in blocks:
        if isinstance(block, Heading) or not is_open:
            pieces += ["</section>"] if is_open else []
            about_units = isinstance(block, Heading) and block.units
            pieces.append('<section class="units">' if about_units else "<section>")
            is_open = True
        pieces.append(_block(block, width))
    return "\n".join([*pieces, "</section>"] if is_open else pieces)


def _block(block: Block, width: int) -> str:
    match block:
        case Heading(title, step):
            number = "" if step is None else f'<span class="step">{escape(step)}</span>'
            return f"<h2>{number}{escape(title)}</h2>"
        case Paragraph(content):
            return f"<p>{_inline(content)}</p>"
        case Equations(equations):
            return _equations(equations, width)
        case Table(header, rows):
            return _table(header, rows)
        case Bullets(items):
            return "<ul>" + "".join(f"<li>{_inline(item)}</li>" for item in items) + "</ul>"
        case Drawing(figure, legend):
            return f"<figure>{svg(figure)}<figcaption>{_inline(legend)}</figcaption></figure>"
        case _:
            assert_never(block)


def _equations(equations: tuple[Equation, ...], width: int) -> str:
    """Formulas aligned at their equals signs; one with a long left-hand side stands by itself. Results are framed."""
    kind = "equations final" if all(equation.final for equation in equations) else "equations"
    tables: list[str] = []
    aligned: list[str] = []
    for equation in equations:
        parts = lines(equation, width)
        if parts[0].left is not None:
            aligned += [_aligned(part) for part in parts]
            continue
        tables += _tables(aligned)
        aligned = []
        tables += _tables([f"<tr>{_cell('right', _continued(part))}</tr>" for part in parts])
    letters = max((_letters(part) for equation in equations for part in lines(equation, width)), default=0)
    style = f' style="--letters: {letters}"' if letters > width else ""
    return f'<div class="{kind}"{style}>{"".join([*tables, *_tables(aligned)])}</div>'


def _letters(part: Line) -> int:
    return len(unicode_line(part.right)) + (0 if part.left is None else len(unicode_line(part.left)) + 3)


def _tables(rows: list[str]) -> list[str]:
    """At most one table. It is none of MathML: paper breaks between its rows, and through the middle of a formula."""
    return [f'<table class="aligned" role="presentation">{"".join(rows)}</table>'] if rows else []


def _cell(side: str, formula: str) -> str:
    return f'<td class="{side}"><math displaystyle="true">{formula}</math></td>' if formula else "<td></td>"


def _aligned(part: Line) -> str:
    left = "" if part.left is None else element(part.left)
    right = _continued(part) if part.left is None else element(Row((EQUALS, part.right)))
    return f"<tr>{_cell('left', left)}{_cell('right', right)}</tr>"


def _continued(part: Line) -> str:
    if not part.continued:
        return element(part.right)
    sign, rest = sign_and_rest(part.right)
    shown = "−" if sign == "-" else "+"
    return f'<mrow><mspace width="2em"></mspace><mo form="infix">{shown}</mo>{element(rest)}</mrow>'


def _table(header: tuple[str, ...], rows: tuple[tuple[Inline, ...], ...]) -> str:
    cells = [[_inline(cell) for cell in row] for row in rows]
    keep = [i for i in range(len(header)) if any(row[i] for row in cells)]
    head = "".join(f"<th>{escape(header[i])}</th>" for i in keep)
    body = "".join(f"<tr>{''.join(f'<td>{row[i]}</td>' for i in keep)}</tr>" for row in cells)
    return f'<div class="scroll"><table><thead><tr>{head}</tr></thead><tbody>{body}</tbody></table></div>'


def _inline(content: Inline) -> str:
    return inline(
        content,
        mathml,
        escape,
        strong=lambda words: f"<strong>{escape(words)}</strong>",
        code=lambda words: f"<code>{escape(words)}</code>",
    )
