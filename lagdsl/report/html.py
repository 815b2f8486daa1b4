"""Reports as one self-contained HTML page: MathML and a style sheet, no script, nothing from a network."""

from __future__ import annotations

from collections.abc import Sequence
from html import escape
from typing import assert_never

from lagdsl.report.boxes import EQUALS, Row
from lagdsl.report.broken import lines, starts_with_minus
from lagdsl.report.document import (
    Block,
    Bullets,
    Code,
    Document,
    Equation,
    Equations,
    Heading,
    Inline,
    Math,
    Paragraph,
    Strong,
    Table,
    Text,
)
from lagdsl.report.html_style import STYLE
from lagdsl.report.mathml import element, mathml

_WIDTH = 80


def html(document: Document) -> str:
    subtitle = f'\n<p class="subtitle">{escape(document.subtitle)}</p>' if document.subtitle else ""
    return f"""<!DOCTYPE html>
<html lang="en">
<head>
<meta charset="utf-8">
<meta name="viewport" content="width=device-width, initial-scale=1">
<meta http-equiv="Content-Security-Policy" content="default-src 'none'; style-src 'unsafe-inline'">
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
{_sections(document.blocks)}
</main>
</body>
</html>
"""


def _sections(blocks: Sequence[Block]) -> str:
    """A section from each heading to the next."""
    pieces: list[str] = []
    is_open = False
    for block in blocks:
        if isinstance(block, Heading) or not is_open:
            pieces += ["</section>"] if is_open else []
            pieces.append("<section>")
            is_open = True
        pieces.append(_block(block))
    return "\n".join([*pieces, "</section>"] if is_open else pieces)


def _block(block: Block) -> str:
    match block:
        case Heading(title, step):
            number = "" if step is None else f'<span class="step">{escape(step)}</span>'
            return f"<h2>{number}{escape(title)}</h2>"
        case Paragraph(content):
            return f"<p>{_inline(content)}</p>"
        case Equations(equations):
            return _equations(equations)
        case Table(header, rows):
            return _table(header, rows)
        case Bullets(items):
            return "<ul>" + "".join(f"<li>{_inline(item)}</li>" for item in items) + "</ul>"
        case _:
            assert_never(block)


def _equations(equations: tuple[Equation, ...]) -> str:
    """One aligned table of formulas; results stand in a frame."""
    kind = "equations final" if all(equation.final for equation in equations) else "equations"
    rows = "".join(_equation(equation) for equation in equations)
    return f'<div class="{kind}"><math display="block"><mtable class="aligned">{rows}</mtable></math></div>'


def _equation(equation: Equation) -> str:
    rows = []
    for part in lines(equation, _WIDTH):
        if part.left is not None:
            rows.append(_aligned(element(part.left), element(Row((EQUALS, part.right)))))
        elif part.continued:
            plus = "" if starts_with_minus(part.right) else '<mo form="prefix">+</mo>'
            rows.append(_alone(f'<mrow><mspace width="2em"></mspace>{plus}{element(part.right)}</mrow>'))
        else:
            rows.append(_alone(element(part.right)))
    return "".join(rows)


def _aligned(left: str, right: str) -> str:
    return f'<mtr><mtd class="left">{left}</mtd><mtd class="right">{right}</mtd></mtr>'


def _alone(box: str) -> str:
    return f'<mtr><mtd class="right" columnspan="2">{box}</mtd></mtr>'


def _table(header: tuple[str, ...], rows: tuple[tuple[Inline, ...], ...]) -> str:
    cells = [[_inline(cell) for cell in row] for row in rows]
    keep = [i for i in range(len(header)) if any(row[i] for row in cells)]
    head = "".join(f"<th>{escape(header[i])}</th>" for i in keep)
    body = "".join(f"<tr>{''.join(f'<td>{row[i]}</td>' for i in keep)}</tr>" for row in cells)
    return f'<div class="scroll"><table><thead><tr>{head}</tr></thead><tbody>{body}</tbody></table></div>'


def _inline(content: Inline) -> str:
    pieces = []
    for piece in content:
        match piece:
            case Math(box):
                pieces.append(mathml(box))
            case Text(words):
                pieces.append(escape(words))
            case Strong(words):
                pieces.append(f"<strong>{escape(words)}</strong>")
            case Code(words):
                pieces.append(f"<code>{escape(words)}</code>")
    return "".join(pieces)
