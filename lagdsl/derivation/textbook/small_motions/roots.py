"""Roots of short equations in one unknown: linear, quadratic, or a sine and a cosine of one angle."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Literal

import sympy
from sympy import Expr, Integer, Symbol, pi

from lagdsl.derivation.textbook.differentiate import partial
from lagdsl.derivation.textbook.tidy import Tidy


@dataclass(frozen=True, slots=True)
class Condition:
    """A root is real if `value` is between -1 and 1, or not negative; a place is one of rest if `value` is zero."""

    kind: Literal["unit", "nonnegative", "zero"]
    value: Expr


@dataclass(frozen=True, slots=True)
class Root:
    value: Expr
    condition: Condition | None = None


class NotSolvedError(Exception):
    """An equation has none of the forms whose roots are written down, or there are too many of them."""


def roots(tidy: Tidy, equation: Expr, x: Symbol) -> list[Root]:
    """All real roots, those of angles up to whole turns; raises NotSolvedError where that is not certain."""
    angle = _angle(equation, x)
    return _of_polynomial(tidy, equation, x) if angle is None else _of_angle(tidy, equation, x, angle)


def _angle(equation: Expr, x: Symbol) -> Expr | None:
    """The argument of all sines and cosines that hold x; None if there are none."""
    found: Expr | None = None
    for node in equation.atoms(sympy.sin, sympy.cos):
        argument = node.args[0]
        if x not in argument.free_symbols:
            continue
        if found is not None and found != argument:
            raise NotSolvedError
        found = argument
    return found


def _of_polynomial(tidy: Tidy, equation: Expr, x: Symbol) -> list[Root]:
    if any(x in node.free_symbols for node in equation.atoms(sympy.Function, sympy.Pow) if not _is_power(node, x)):
        raise NotSolvedError
    first = tidy(partial(equation, x))
    second = tidy(partial(first, x))
    if x in second.free_symbols:
        raise NotSolvedError
    at_zero = {x: Integer(0)}
    a, b, c = second / 2, first.xreplace(at_zero), tidy(equation.xreplace(at_zero))
    if a == 0:
        return [Root(tidy(-c / b))]
    inside = tidy(b**2 - 4 * a * c)
    if inside == 0:
        return [Root(tidy(-b / (2 * a)))]
    condition = None if inside.is_positive else Condition("nonnegative", inside)
    return [Root(tidy((-b + sign * sympy.sqrt(inside)) / (2 * a)), condition) for sign in (1, -1)]


def _is_power(node: Expr, x: Symbol) -> bool:
    """x squared, or x to another small whole power."""
    return bool(node.is_Pow and node.base == x and node.exp.is_Integer and node.exp > 0)


def _of_angle(tidy: Tidy, equation: Expr, x: Symbol, angle: Expr) -> list[Root]:
    """A sin y + B cos y + C = 0 with y = x + c or y = c - x, where one of A, B, C is zero."""
    slope = partial(angle, x)
    s, c = sympy.Dummy("s"), sympy.Dummy("c")
    plain = equation.xreplace({sympy.sin(angle): s, sympy.cos(angle): c})
    by_s, by_c = tidy(partial(plain, s)), tidy(partial(plain, c))
    rest = tidy(plain.xreplace({s: Integer(0), c: Integer(0)}))
    if slope not in (1, -1) or {s, c, x} & {*by_s.free_symbols, *by_c.free_symbols, *rest.free_symbols}:
        raise NotSolvedError
    shift = angle - slope * x
    return [Root(tidy(slope * (root.value - shift)), root.condition) for root in _of_sine(tidy, by_s, by_c, rest)]


def _of_sine(tidy: Tidy, by_s: Expr, by_c: Expr, rest: Expr) -> list[Root]:
    if rest == 0 and by_c == 0:
        return [Root(Integer(0)), Root(pi)]
    if rest == 0 and by_s == 0:
        return [Root(pi / 2), Root(-pi / 2)]
    if rest == 0:
        one = sympy.atan(tidy(-by_c / by_s))
        return [Root(one), Root(one + pi)]
    if by_s == 0:
        value = tidy(-rest / by_c)
        one = sympy.acos(value)
        return _real(value, one, -one)
    if by_c == 0:
        value = tidy(-rest / by_s)
        one = sympy.asin(value)
        return _real(value, one, pi - one)
    raise NotSolvedError


def _real(value: Expr, one: Expr, other: Expr) -> list[Root]:
    """Both angles of a sine or cosine; of a number those that there are, the same one once."""
    if not value.is_Rational:
        return [Root(one, Condition("unit", value)), Root(other, Condition("unit", value))]
    if abs(value) > 1:
        return []
    return [Root(one)] if abs(value) == 1 else [Root(one), Root(other)]
