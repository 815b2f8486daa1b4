"""Formulas in MathML Core, which browsers set without help."""

from __future__ import annotations

from html import escape
from typing import assert_never

from lagdsl.documents.report import boxes
from lagdsl.documents.report.unit_text import readable_unit

_THIN = '<mspace width="0.17em"></mspace>'


_BOLD_ITALIC = {"A": 0x1D468, "a": 0x1D482, "Α": 0x1D71C, "α": 0x1D736}  # first of a row: the letter, its bold form
_LETTERS = 25


def bold_italic(text: str) -> str:
    """A letter as Unicode has it among the mathematical alphabets; any other text as it is."""
    for first, row in _BOLD_ITALIC.items():
        if len(text) == 1 and 0 <= ord(text) - ord(first) <= _LETTERS:
            return chr(row + ord(text) - ord(first))
    return text


def mathml(box: boxes.Box, *, display: bool = False) -> str:
    block = ' display="block"' if display else ""
    return f"<math{block}>{element(box)}</math>"


def element(box: boxes.Box) -> str:  # noqa: C901, PLR0912
    """The box as one element."""
    match box:
        case boxes.VectorName(text):
            return f"<mi>{escape(bold_italic(text))}</mi>"
        case boxes.Name(text):
            return f"<mi>{escape(text)}</mi>" if len(text) == 1 else f'<mi class="word">{escape(text)}</mi>'
        case boxes.Upright(text):
            return f'<mi mathvariant="normal">{escape(text)}</mi>' if len(text) == 1 else f"<mi>{escape(text)}</mi>"
        case boxes.Number(text):
            return f"<mn>{escape(text)}</mn>"
        case boxes.Operator(text):
            return f"<mo>{escape(text)}</mo>"
        case boxes.Row(items):
            return _row(items)
        case boxes.Sum(terms):
            first, *others = terms
            head = f'<mo form="prefix">−</mo>{_term(first[1])}' if first[0] == "-" else element(first[1])
            tail = "".join(f'<mo form="infix">{"−" if s == "-" else "+"}</mo>{_term(term)}' for s, term in others)
            return f"<mrow>{head}{tail}</mrow>"
        case boxes.Fraction(above, below):
            return f"<mfrac>{element(above)}{element(below)}</mfrac>"
        case boxes.Power(base, exponent):
            return f"<msup>{element(base)}{element(exponent)}</msup>"
        case boxes.Subscript(base, index):
            return f"<msub>{element(base)}{element(index)}</msub>"
        case boxes.Root(inside):
            return f"<msqrt>{element(inside)}</msqrt>"
        case boxes.Dotted(base, dots):
            accent = {1: "˙", 2: "¨"}.get(dots, "˙" * dots)
            return f'<mover>{element(base)}<mo class="dot" stretchy="false">{accent}</mo></mover>'
        case boxes.Derivative(letter, of, by):
            d = f'<mi mathvariant="normal">{letter}</mi>'
            over = d if of is None else f"<mrow>{d}{element(of)}</mrow>"
            return f"<mfrac>{over}<mrow>{d}{element(by)}</mrow></mfrac>"
        case boxes.Call(function, arguments):
            listed = "<mo>,</mo>".join(element(argument) for argument in arguments)
            simple = len(arguments) == 1 and isinstance(arguments[0], boxes.Name | boxes.Subscript)
            return f"<mrow>{element(function)}{_THIN + listed if simple else _bracketed(listed)}</mrow>"
        case boxes.Bracket(inside, left, right):
            return f"<mrow>{'<mo>(</mo>' if left else ''}{element(inside)}{'<mo>)</mo>' if right else ''}</mrow>"
        case boxes.Marked(inside, sources):
            return f'<mrow class="term" data-from="{" ".join(str(each) for each in sources)}">{element(inside)}</mrow>'
        case boxes.Cases(value, condition, otherwise):
            rows = _cells((value, boxes.Row((boxes.Upright("if"), condition)))) + _cells(
                (otherwise, boxes.Upright("otherwise"))
            )
            return f'<mrow><mo stretchy="true">{{</mo><mtable class="cases">{rows}</mtable></mrow>'
        case boxes.Column(components):
            return f"<mrow>{_bracketed(_table(tuple((x,) for x in components)))}</mrow>"
        case boxes.Unit(text):
            return f'<mspace width="1.5em"></mspace><mtext class="unit">[{escape(readable_unit(text))}]</mtext>'
        case boxes.Joined(items):
            return f"<mrow>{''.join(element(item) for item in items)}</mrow>"
        case boxes.Matrix(rows):
            return f"<mrow><mo>[</mo>{_table(rows)}<mo>]</mo></mrow>"
        case _:
            assert_never(box)


def _bracketed(inside: str) -> str:
    return f"<mo>(</mo>{inside}<mo>)</mo>"


def _term(box: boxes.Box) -> str:
    return _bracketed(element(box)) if isinstance(box, boxes.Sum) else element(box)


def _row(items: tuple[boxes.Box, ...]) -> str:
    pieces: list[str] = []
    for previous, item in zip((None, *items), items, strict=False):
        if previous is not None and not isinstance(item, boxes.Operator) and not isinstance(previous, boxes.Operator):
            pieces.append(_THIN)
        pieces.append(element(item))
    return f"<mrow>{''.join(pieces)}</mrow>"


def _cells(row: tuple[boxes.Box, ...]) -> str:
    return f"<mtr>{''.join(f'<mtd>{element(x)}</mtd>' for x in row)}</mtr>"


def _table(rows: tuple[tuple[boxes.Box, ...], ...]) -> str:
    return f"<mtable>{''.join(_cells(row) for row in rows)}</mtable>"
