"""Choices between numbers, made: SymPy keeps the language's own functions whole, whatever their arguments are."""

from __future__ import annotations

from collections.abc import Callable

from sympy import Expr, Integer, Rational, igcd

from lagdsl.derivation.textbook import functions
from lagdsl.derivation.textbook.symbols import postorder

_RELATIONS: dict[type, Callable[[Expr, Expr], bool]] = {
    functions.Less: lambda x, y: bool(x < y),
    functions.LessEqual: lambda x, y: bool(x <= y),
    functions.Equal: lambda x, y: bool(x == y),
    functions.And: lambda x, y: bool(x != 0 and y != 0),
    functions.Or: lambda x, y: bool(x != 0 or y != 0),
}
_OF_NUMBERS: dict[type, Callable[..., Expr]] = {
    functions.Not: lambda x: Integer(x == 0),
    functions.Absolute: abs,
    functions.Sign: lambda x: Integer((x > 0) - (x < 0)),
    functions.Minimum: min,
    functions.Maximum: max,
}


def settled(expression: Expr) -> Expr:
    """The expression with every choice between rational numbers made; derivatives keep no steps of numbers."""
    known: dict[Expr, Expr] = {}
    for node in postorder(expression, known):
        known[node] = step(node if not node.args else _rebuilt(node, [known[each] for each in node.args]))
    return known[expression]


def _rebuilt(node: Expr, arguments: list[Expr]) -> Expr:
    return node if tuple(arguments) == node.args else node.func(*arguments)


def step(node: Expr) -> Expr:
    """The choice at the top of an expression, if numbers make it."""
    kind = type(node)
    if kind is functions.ArcTangent2:
        return _of_direction(*node.args)
    if kind is functions.Select and node.args[0].is_Rational:
        return node.args[1] if node.args[0] != 0 else node.args[2]
    if not (node.is_Function and node.args and all(argument.is_Rational for argument in node.args)):
        return node
    if kind in _RELATIONS:
        return Integer(_RELATIONS[kind](*node.args))
    return _OF_NUMBERS[kind](*node.args) if kind in _OF_NUMBERS else node


def _of_direction(y: Expr, x: Expr) -> Expr:
    """The angle of a direction without a common numerical factor."""
    (first, up), (second, along) = y.as_coeff_Mul(), x.as_coeff_Mul()
    if not (first.is_Rational and second.is_Rational) or 0 in (first, second) or up == 1 or along == 1:
        return functions.ArcTangent2(y, x)
    common = igcd(first.p * second.q, second.p * first.q)
    factor = Rational(common, first.q * second.q)
    return functions.ArcTangent2(first / factor * up, second / factor * along)
