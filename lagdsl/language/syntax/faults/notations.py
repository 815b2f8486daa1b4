"""Numbers, comments and functions in the form of other languages."""

from __future__ import annotations

import re

from lark import Token

from lagdsl.foundation.source import Span
from lagdsl.language.syntax.expected import expected
from lagdsl.language.syntax.session import Session
from lagdsl.language.syntax.tokens import END_OF_TEXT, end_of, plain_tokens, start_of

_MOST = 400  # tokens of the body of a function that is left out
_RADIX = re.compile(r"0([xXbBoO])([0-9A-Fa-f]+)(?![A-Za-z0-9_])")
_BASES = {"x": 16, "o": 8, "b": 2}
_DOUBLE = re.compile(r"([0-9]+(?:\.[0-9]*)?)[dD]([+-]?[0-9]+)(?![A-Za-z0-9_])")
_POINTS = re.compile(r"[0-9]+(?:\.[0-9]*)?(?:[eE][+-]?[0-9]+)?\.(?:[0-9]+)?")
_GROUPED = re.compile(r"\d{1,3}(?:\.\d{3})+")
_OF_NUMBERS = tuple("0123456789.eE")
_LONGEST = 40  # characters of a number that is shown rewritten
_COMMENTS = {"--": "\n", "(*": "*)", "<!--": "-->", '"""': '"""'}


def foreign_number(session: Session, token: Token) -> bool:
    """`0x10`, `1d-3`, `5.`, `1.000.000`: no number of this language."""
    text, last = session.file.text, session.previous
    if last.type not in ("NUMBER", "QUANTITY") and last.value != ".":
        return False
    start = start_of(last)
    while text[start - 1 : start] in _OF_NUMBERS or (text[start - 1] in "+-" and text[start - 2] in "eE"):
        start -= 1
    if match := _RADIX.match(text, start):
        digits, base = match[2], _BASES[match[1].lower()]
        fits = len(digits) <= _LONGEST and all(int(digit, 16) < base for digit in digits)
        way = f"numbers are decimal: `{int(digits, base)}`" if fits else "numbers are decimal"
    elif match := _DOUBLE.match(text, start):
        way = f"powers of ten are written with `e`: `{match[1].rstrip('.')}e{match[2]}`"
    elif last.value == "." and (match := _POINTS.match(text, start)) and match.end() >= start_of(token):
        way = _points(match[0])
    else:
        return False
    span = Span(session.file, *match.span())
    session.sink.report("E0100", span, found=f"`{span.text[:_LONGEST]}`", expected="one number", help=way)
    session.panic(token)
    return True


def _points(number: str) -> str:
    """Help for a number that ends with a point, or has two of them."""
    if _GROUPED.fullmatch(number) and len(number) <= _LONGEST:
        return f"digits are not grouped: `{number.replace('.', '')}`"
    if "e" in number.lower():
        return "the exponent is a whole number"
    if number.endswith(".") and len(number) <= _LONGEST:
        return f"digits follow the decimal point: `{number}0`"
    return "a number has one decimal point"


def foreign_comment(session: Session, token: Token) -> bool:
    """`-- text`, `(* text *)`: leave it out."""
    if not session.stack.at_boundary() or token.type == END_OF_TEXT:
        return False
    text, start = session.file.text, start_of(token)
    mark = next((mark for mark in _COMMENTS if text.startswith(mark, start)), None)
    if mark is None:
        return False
    end = text.find(_COMMENTS[mark], start + len(mark))
    span = Span(session.file, start, start + len(mark))
    help_text = "a comment begins with `//`, or stands between `/*` and `*/`"
    session.sink.report("E0100", span, found=f"`{mark}`", expected=expected(session.stack), help=help_text)
    session.rewind(len(text) if end < 0 else end + len(_COMMENTS[mark]))
    return True


def foreign_function(session: Session, token: Token) -> bool:
    """`function y = f(x) ... end f;`: leave its body and its `end` out."""
    height = session.stack.boundary()
    unfinished = session.stack.above(height) if height else []
    if not unfinished or unfinished[0].value != "function" or session.starts_line(token):
        return False
    body = _end_of_function(session, end_of(token))
    if body is None:
        return False
    help_text = "a function is one expression: `function f(Real x) -> Real = 2*x;`"
    session.sink.report("E0100", session.span(token), found=f"`{token.value}`", expected="`(`", help=help_text)
    session.panic(token)
    session.rewind(body)
    return True


def _end_of_function(session: Session, start: int) -> int | None:
    """The place behind the `end` of a function; None if the next `end` is that of the class around."""
    known = session.open_classes()
    tokens = plain_tokens(session.file.text, start)
    for _, token in zip(range(_MOST), tokens, strict=False):
        if token.type == "CLASS_KIND":
            return None
        if token.value != "end":
            continue
        after = next(tokens, None)
        if after is None or after.value in known:
            return None
        if after.type == "IDENT" or after.value == "function":
            closing = next(tokens, None)
            return end_of(closing) if closing is not None and closing.value == ";" else end_of(after)
        return end_of(after) if after.value == ";" else end_of(token)
    return None
