"""Nodes of expressions."""

from __future__ import annotations

import re
from typing import Any, NamedTuple

from lagdsl.foundation.diagnostics import Sink
from lagdsl.foundation.source import Span
from lagdsl.language.syntax import nodes
from lagdsl.language.syntax.reductions.action import Action, listed, token_span, unquote
from lagdsl.language.syntax.tokens import unit_of
from lagdsl.language.syntax.unknown_unit import report_unknown_unit

_OPERATORS = {"add": "+", "sub": "-", "mul": "*", "div": "/", "emul": ".*", "ediv": "./", "pow": "^"}
_OPERATORS |= {"or_": "or", "and_": "and"}
_FUNCTION_BEFORE = re.compile(r"\b(sin|cos|tan|log|exp|sqrt|abs)\^$")
_POWER = re.compile(r"[eE][0-9]+")
_LONGEST = 60  # characters of a text that a message shows
_SIGNS = {"neg": "-", "pos": "+", "not_": "not"}


def _power_of_function(function: nodes.Expression, arguments: str) -> str | None:
    """Help for `sin^2(x)`."""
    text, start = function.span.file.text, function.span.start
    found = _FUNCTION_BEFORE.search(text, max(start - _LONGEST, 0), start)
    return None if found is None else f"the power stands behind: `{found[1]}{arguments}^{function.span.text}`"


def _remainder(number: nodes.Expression, brackets: str) -> str | None:
    """Help for `7 % (a)`, of which `7 %` is a percentage."""
    if not isinstance(number, nodes.Quantity) or number.unit != "%":
        return None
    return f"the remainder is `mod({number.number}, {brackets.strip('() ')})`"


def expression_actions(sink: Sink) -> dict[str, Action]:
    """Actions of expressions; a call of what cannot be called and a member of a number go to `sink`."""

    def call(c: list[Any], span: Span) -> nodes.Call | nodes.Reduction:
        function, arguments = c
        if not isinstance(function, nodes.Reference | nodes.Member):
            rest = span.text[function.span.end - span.start :].strip()
            product = f"{function.span.text}*{rest}"
            short = len(product) <= _LONGEST and product.isprintable()
            way = (
                _power_of_function(function, rest)
                or _remainder(function, rest)
                or _unit_in_brackets(function, rest)
                or f"for a product write `{product}`"
            )
            sink.report("E0121", function.span, help=way if short else None)
        if isinstance(arguments, _Reduced):
            return nodes.Reduction(span=span, function=function, body=arguments.body, iterators=arguments.iterators)
        return nodes.Call(span=span, function=function, arguments=arguments or ())

    def member(c: list[Any], span: Span) -> nodes.Member:
        target, name = c
        if isinstance(target, nodes.Quantity):
            start = target.span.end - len(target.unit)
            report_unknown_unit(sink, Span(span.file, start, span.end), target.number, f"{target.unit}.{name.value}")
        elif isinstance(target, nodes.Number):
            from lagdsl.foundation.units.vocabulary import UNITS

            power = name.value if _POWER.fullmatch(name.value) else ""
            unit = f" {name.value}" if name.value in UNITS else ""
            short = len(target.text + power) <= _LONGEST
            way = f"digits must follow the decimal point: `{target.text}.0{power}{unit}`" if short else None
            dot = Span(span.file, target.span.end, target.span.end + 1)
            sink.report("E0127", dot, help=way)
        return nodes.Member(span=span, target=target, name=name.value, name_span=token_span(name, span))

    binary = {rule: _binary(operator) for rule, operator in _OPERATORS.items()}
    unary = {rule: _unary(operator) for rule, operator in _SIGNS.items()}
    return {**_PLAIN, **binary, **unary, "call": call, "member": member}


def _unit_in_brackets(number: nodes.Expression, brackets: str) -> str | None:
    """`1 (N.m)`."""
    from lagdsl.foundation.units.parse import UnknownUnit, parse_unit

    unit = brackets.strip("() ")
    if not unit[:1].isalpha():
        return None
    try:
        parse_unit(unit)
    except UnknownUnit:
        return None
    is_number = isinstance(number, nodes.Number)
    return f"a unit stands behind its number without brackets: `{number.span.text} {unit}`" if is_number else None


class _Reduced(NamedTuple):
    """`body for i in 1:n` between the brackets of a call."""

    body: nodes.Expression
    iterators: tuple[nodes.Iterator, ...]


def pairs(items: list[Any]) -> list[tuple[Any, Any]]:
    """(a, b), (c, d) of a, b, c, d."""
    return list(zip(items[::2], items[1::2], strict=True))


def _binary(operator: str) -> Action:
    return lambda c, span: nodes.Binary(span=span, operator=operator, left=c[0], right=c[1])


def _unary(operator: str) -> Action:
    return lambda c, span: nodes.Unary(span=span, operator=operator, operand=c[0])


def _quantity(c: list[Any], span: Span) -> nodes.Quantity:
    unit = unit_of(c[0].value)
    return nodes.Quantity(span=span, number=c[0].value[: -len(unit)].rstrip(" \t"), unit=unit)


def _conditional(c: list[Any], span: Span) -> nodes.Conditional:
    branches = tuple(
        nodes.Branch(span=condition.span.to(value.span), condition=condition, value=value)
        for condition, value in pairs(c[:-1])
    )
    return nodes.Conditional(span=span, branches=branches, otherwise=c[-1])


def _range(c: list[Any], span: Span) -> object:
    """`a`, `a:b` or `a:step:b`."""
    first, second, third = c
    if second is None:
        return first
    step, stop = (None, second) if third is None else (second, third)
    return nodes.Range(span=span, start=first, step=step, stop=stop)


_PLAIN: dict[str, Action] = {
    "if_expr": _conditional,
    "relation": lambda c, span: nodes.Binary(span=span, operator=c[1].value, left=c[0], right=c[2]),
    "index_": lambda c, span: nodes.Index(span=span, target=c[0], subscripts=c[1]),
    "ref": lambda c, span: nodes.Reference(span=span, name=c[0].value),
    "quantity": _quantity,
    "number": lambda c, span: nodes.Number(span=span, text=c[0].value),
    "string": lambda c, span: nodes.String(span=span, value=unquote(c[0])),
    "true": lambda c, span: nodes.Boolean(span=span, value=True),
    "false": lambda c, span: nodes.Boolean(span=span, value=False),
    "parenthesized": lambda c, span: nodes.Parenthesized(span=span, inner=c[0]),
    "tuple": lambda c, span: nodes.Tuple(span=span, elements=tuple(c)),
    "vector": lambda c, span: nodes.Array(span=span, elements=tuple(c)),
    "comprehension": lambda c, span: nodes.Comprehension(span=span, body=c[0], iterators=c[1]),
    "matrix": lambda c, span: nodes.Matrix(span=span, rows=tuple(c)),
    "row": listed,
    "args": listed,
    "reduction": lambda c, span: _Reduced(c[0], c[1]),
    "named": lambda c, span: nodes.Named(span=span, name=c[0].value, value=c[1]),
    "named_args": listed,
    "range": _range,
    "all_": lambda c, span: nodes.All(span=span),
    "dims": listed,
    "indices": listed,
    "index": lambda c, span: nodes.Iterator(span=span, name=c[0].value, range=c[1]),
    "name": lambda c, span: nodes.Name(span=span, parts=(*(c[0].parts if len(c) == 2 else ()), c[-1].value)),
}
