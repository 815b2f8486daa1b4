"""Formulas as one line of Unicode, for terminals."""

from __future__ import annotations

from typing import assert_never

from lagdsl.documents.report import boxes
from lagdsl.documents.report.unit_text import readable_unit

_SUPERSCRIPTS = str.maketrans("0123456789-", "⁰¹²³⁴⁵⁶⁷⁸⁹⁻")
_SUBSCRIPTS = str.maketrans("0123456789", "₀₁₂₃₄₅₆₇₈₉")
_VULGAR = {"1/2": "½", "1/3": "⅓", "2/3": "⅔", "1/4": "¼", "3/4": "¾", "1/8": "⅛", "3/8": "⅜", "5/8": "⅝", "7/8": "⅞"}
_DOTS = {1: "\u0307", 2: "\u0308"}


def line(box: boxes.Box) -> str:  # noqa: C901, PLR0912
    """The box in one line; brackets stand where a page would show structure by height."""
    match box:
        case boxes.Name(text) | boxes.Upright(text) | boxes.Number(text):
            return text
        case boxes.Operator(text):
            return f" {text} "
        case boxes.Row(items):
            return _row(items)
        case boxes.Sum(terms):
            first, *others = terms
            head = f"−{_term(first[1])}" if first[0] == "-" else line(first[1])
            return head + "".join(f" {'−' if sign == '-' else '+'} {_term(term)}" for sign, term in others)
        case boxes.Fraction(above, below):
            over = line(above) if isinstance(above, boxes.Row) else _guarded(above)
            plain = f"{over}/{_guarded(below)}"
            return _VULGAR.get(plain, plain)
        case boxes.Power(base, exponent):
            raised = line(exponent)
            plain = f"^({raised})" if len(raised) > 1 else f"^{raised}"
            return line(base) + (raised.translate(_SUPERSCRIPTS) if _is_integer(raised) else plain)
        case boxes.Subscript(base, index):
            low = line(index).replace(" , ", ",")
            plain = f"_({low})" if " " in low else f"_{low}"
            return line(base) + (low.translate(_SUBSCRIPTS) if low.isdigit() else plain)
        case boxes.Root(inside):
            return f"√({line(inside)})" if isinstance(inside, boxes.Power) else f"√{_guarded(inside)}"
        case boxes.Dotted(base, dots):
            name = line(base)
            return name + _DOTS[dots] if len(name) == 1 and dots in _DOTS else "der(" * dots + name + ")" * dots
        case boxes.Derivative(letter, of, by):
            return f"{letter}{'' if of is None else line(of)}/{letter}{line(by)}"
        case boxes.Call(function, arguments):
            listed = ", ".join(line(argument) for argument in arguments)
            simple = len(arguments) == 1 and isinstance(arguments[0], boxes.Name | boxes.Subscript)
            return f"{line(function)} {listed}" if simple else f"{line(function)}({listed})"
        case boxes.Bracket(inside, left, right):
            return f"{'(' if left else ''}{line(inside)}{')' if right else ''}"
        case boxes.Marked(inside):
            return line(inside)
        case boxes.Cases(value, condition, otherwise):
            return f"(if {line(condition)} then {line(value)} else {line(otherwise)})"
        case boxes.Column(components):
            return f"({', '.join(line(component) for component in components)})"
        case boxes.Unit(text):
            return f"  [{readable_unit(text)}]"
        case boxes.Joined(items):
            return "".join(line(item) for item in items)
        case boxes.Matrix(rows):
            return "[" + "; ".join(", ".join(line(x) for x in row) for row in rows) + "]"
        case _:
            assert_never(box)


def _row(items: tuple[boxes.Box, ...]) -> str:
    """Factors are set apart by a blank, which operators and brackets bring along."""
    result = ""
    for item in items:
        piece = line(item)
        tight = not result or result.endswith((" ", "(", "[")) or piece.startswith((" ", ",", "]")) or piece == ")"
        result += piece if tight else f" {piece}"
    return result


def _term(box: boxes.Box) -> str:
    return f"({line(box)})" if isinstance(box, boxes.Sum) else line(box)


def _guarded(box: boxes.Box) -> str:
    """In brackets unless it is one piece."""
    whole = isinstance(
        box,
        boxes.Name
        | boxes.Number
        | boxes.Upright
        | boxes.Subscript
        | boxes.Dotted
        | boxes.Bracket
        | boxes.Power
        | boxes.Root
        | boxes.Derivative,
    )
    return line(box) if whole else f"({line(box)})"


def _is_integer(text: str) -> bool:
    return text.lstrip("-−").isdigit()
