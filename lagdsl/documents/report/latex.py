"""Reports as a complete LaTeX document (article, amsmath): `pdflatex` needs nothing else."""

from __future__ import annotations

import re
from collections.abc import Callable
from typing import assert_never

from lagdsl.documents.report.boxes import Box
from lagdsl.documents.report.document import (
    Block,
    Bullets,
    Document,
    Drawing,
    Equations,
    Heading,
    Inline,
    Paragraph,
    Table,
    inline,
)
from lagdsl.documents.report.figure.tikz import DEFINITIONS, tikz
from lagdsl.documents.report.latex_math import escape, tex
from lagdsl.documents.report.markdown import aligned
from lagdsl.documents.report.unicode_math import line

_WIDTH = 68
_SHORT_CELL = 14
_LETTERS_OF_A_LINE = 80
_BREAKABLE = re.compile(r"(?<=[_.,()\[\]{}*/+=:-])")
_HEAD = r"""\documentclass[11pt,a4paper]{article}
\usepackage[T1]{fontenc}
\usepackage[utf8]{inputenc}
\usepackage{lmodern}
\usepackage{textcomp}
\usepackage{amsmath,amssymb}
\usepackage[margin=25mm]{geometry}
\usepackage{array,longtable,graphicx}
\newcommand{\fit}[1]{\resizebox{\ifdim\width>0.66\linewidth 0.66\linewidth\else\width\fi}{!}{$\displaystyle #1$}}
\allowdisplaybreaks
\emergencystretch=3em
\setlength{\parindent}{0pt}
\setlength{\parskip}{0.6em}
"""
_FIGURES = f"\\usepackage{{tikz}}\n{DEFINITIONS}\n"


def latex(document: Document) -> str:
    subtitle = rf"\\[0.4em]\large {escape(document.subtitle)}" if document.subtitle else ""
    title = rf"\title{{{escape(document.title)}{subtitle}}}"
    body = "\n\n".join(_block(block) for block in document.blocks)
    return "\n".join(
        [
            _HEAD + (_FIGURES if any(isinstance(b, Drawing) for b in document.blocks) else "") + title,
            r"\author{}",
            r"\date{}",
            r"\begin{document}",
            r"\maketitle",
            body,
            r"\end{document}",
            "",
        ]
    )


def _block(block: Block) -> str:
    match block:
        case Heading(title, step):
            return rf"\section*{{{title if step is None else f'{step}. {title}'}}}".replace("–", "--")
        case Paragraph(content):
            return _inline(content)
        case Equations(lines):
            rows = " \\\\\n".join(aligned(equation, _WIDTH, _narrowed) for equation in lines)
            return f"\\begin{{align*}}\n{rows}\n\\end{{align*}}"
        case Table(header, rows):
            return _table(header, rows)
        case Bullets(items):
            return "\n".join([r"\begin{itemize}", *(rf"\item {_inline(item)}" for item in items), r"\end{itemize}"])
        case Drawing(figure, legend):
            return f"{tikz(figure)}\n\n{_inline(legend)}"
        case _:
            assert_never(block)


def _narrowed(source: str) -> str:
    """A formula that has no place to be broken, made smaller where it is wider than the line."""
    return rf"\fit{{{source}}}"


def _table(header: tuple[str, ...], rows: tuple[tuple[Inline, ...], ...]) -> str:
    keep = [i for i in range(len(header)) if any(row[i] for row in rows)]
    if not keep:
        return ""
    lengths = [max(len(header[i]), *(_letters(row[i]) for row in rows)) for i in keep]
    head = " & ".join(rf"\textit{{{escape(header[i])}}}" for i in keep)
    body = [" & ".join(_inline(row[i], _in_cell) for i in keep) for row in rows]
    lines = " \\\\\n".join([head, *body])
    return f"\\begin{{longtable}}[l]{{@{{}}{_columns(lengths)}@{{}}}}\n{lines}\n\\end{{longtable}}"


def _columns(lengths: list[int]) -> str:
    """Columns of short words as wide as these, the others share the rest of the line."""
    long = [length for length in lengths if length > _SHORT_CELL]
    if sum(lengths) <= _LETTERS_OF_A_LINE or not long:
        return "l" * len(lengths)
    rest = 0.94 - sum(length for length in lengths if length <= _SHORT_CELL) / _LETTERS_OF_A_LINE
    rest -= 0.03 * (len(lengths) - 1)
    shares = (max(rest * min(length, 60) / sum(min(each, 60) for each in long), 0.12) for length in lengths)
    return "".join(
        "l" if length <= _SHORT_CELL else rf">{{\raggedright\arraybackslash}}p{{{share:.3f}\linewidth}}"
        for length, share in zip(lengths, shares, strict=True)
    )


def _letters(cell: Inline) -> int:
    """Length of a cell; letters of code are wider."""
    return len(inline(cell, line, str, str, lambda words: words + " " * (len(words) // 5)))


def _code(words: str) -> str:
    """Lines break behind operators, brackets and dots of code."""
    pieces = r"\allowbreak{}".join(escape(piece) for piece in _BREAKABLE.split(words))
    return rf"\texttt{{{pieces}}}"


_AT_MOST_A_COLUMN = r"\ifdim\width>\linewidth\linewidth\else\width\fi"


def _in_line(box: Box) -> str:
    return f"${tex(box).strip()}$"


def _in_cell(box: Box) -> str:
    """Cases have no place to be broken: they are made smaller where they are wider than their column."""
    shown = _in_line(box)
    return rf"\resizebox{{{_AT_MOST_A_COLUMN}}}{{!}}{{{shown}}}" if r"\begin{cases}" in shown else shown


def _inline(content: Inline, math: Callable[[Box], str] = _in_line) -> str:
    return inline(
        content,
        math,
        escape,
        strong=lambda words: rf"\textbf{{{escape(words)}}}",
        code=_code,
    )
