"""Reports as a complete LaTeX document (article, amsmath): `pdflatex` needs nothing else."""

from __future__ import annotations

from typing import assert_never

from lagdsl.report.document import (
    Block,
    Bullets,
    Document,
    Equations,
    Heading,
    Inline,
    Paragraph,
    Table,
    inline,
)
from lagdsl.report.latex_math import escape, tex
from lagdsl.report.markdown import aligned

_WIDTH = 78
_HEAD = r"""\documentclass[11pt,a4paper]{article}
\usepackage[T1]{fontenc}
\usepackage[utf8]{inputenc}
\usepackage{lmodern}
\usepackage{textcomp}
\usepackage{amsmath,amssymb}
\usepackage[margin=25mm]{geometry}
\usepackage{array}
\allowdisplaybreaks
\setlength{\parindent}{0pt}
\setlength{\parskip}{0.6em}
"""


def latex(document: Document) -> str:
    subtitle = rf"\\[0.4em]\large {escape(document.subtitle)}" if document.subtitle else ""
    title = rf"\title{{{escape(document.title)}{subtitle}}}"
    body = "\n\n".join(_block(block) for block in document.blocks)
    return "\n".join(
        [_HEAD + title, r"\author{}", r"\date{}", r"\begin{document}", r"\maketitle", body, r"\end{document}", ""]
    )


def _block(block: Block) -> str:
    match block:
        case Heading(title, step):
            return rf"\section*{{{title if step is None else f'{step}. {title}'}}}".replace("–", "--")
        case Paragraph(content):
            return _inline(content)
        case Equations(lines):
            rows = " \\\\\n".join(aligned(equation, _WIDTH) for equation in lines)
            return f"\\begin{{align*}}\n{rows}\n\\end{{align*}}"
        case Table(header, rows):
            return _table(header, rows)
        case Bullets(items):
            return "\n".join([r"\begin{itemize}", *(rf"\item {_inline(item)}" for item in items), r"\end{itemize}"])
        case _:
            assert_never(block)


def _table(header: tuple[str, ...], rows: tuple[tuple[Inline, ...], ...]) -> str:
    share = round(0.9 / len(header), 3)
    columns = "l" + rf"p{{{share}\linewidth}}" * (len(header) - 1)
    head = " & ".join(rf"\textit{{{title}}}" for title in header)
    body = [" & ".join(_inline(cell) for cell in row) for row in rows]
    lines = " \\\\\n".join([head, *body])
    return f"\\begin{{tabular}}{{@{{}}{columns}@{{}}}}\n{lines}\n\\end{{tabular}}"


def _inline(content: Inline) -> str:
    return inline(
        content,
        lambda box: f"${tex(box).strip()}$",
        escape,
        strong=lambda words: rf"\textbf{{{escape(words)}}}",
        code=lambda words: rf"\texttt{{{escape(words)}}}",
    )
