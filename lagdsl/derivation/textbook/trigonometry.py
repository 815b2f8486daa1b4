"""sin^2 + cos^2 = 1 and the addition theorems on polynomials, used only where they make terms fewer."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from dataclasses import dataclass

import sympy
from sympy import Expr

from lagdsl.derivation.textbook.polynomial import Monomial, Polynomial, add_term, times


@dataclass(frozen=True, slots=True)
class Angles:
    """Numbers of kernels and back."""

    kernel: Callable[[Expr], int]
    expression: Callable[[int], Expr]

    def sine_of(self, index: int) -> Expr | None:
        """The angle, if the kernel is a sine."""
        expression = self.expression(index)
        return expression.args[0] if isinstance(expression, sympy.sin) else None

    def cosine_of(self, index: int) -> Expr | None:
        expression = self.expression(index)
        return expression.args[0] if isinstance(expression, sympy.cos) else None


def reduce_trigonometry(polynomial: Polynomial, angles: Angles) -> Polynomial:
    """Squares of sines go, so that equal things look equal; then what got longer by that is made short again."""
    polynomial = without_squares(polynomial, angles)
    while True:
        shorter = _merge_angles(polynomial, angles)
        if shorter is None:
            return _restore_squares(polynomial, angles)
        polynomial = without_squares(shorter, angles)


def without_squares(polynomial: Polynomial, angles: Angles) -> Polynomial:
    """sin^2 = 1 - cos^2 everywhere."""
    result: Polynomial = {}
    waiting = list(polynomial.items())
    while waiting:
        monomial, coefficient = waiting.pop()
        square = next(((k, p) for k, p in monomial if p >= 2 and angles.sine_of(k) is not None), None)
        if square is None:
            add_term(result, monomial, coefficient)
            continue
        sine = square[0]
        rest = times(monomial, ((sine, -2),))
        cosine = angles.kernel(sympy.cos(angles.sine_of(sine)))
        waiting.append((rest, coefficient))
        waiting.append((times(rest, ((cosine, 2),)), -coefficient))
    return {monomial: result[monomial] for monomial in sorted(result)}


def _restore_squares(polynomial: Polynomial, angles: Angles) -> Polynomial:
    """a X - b X cos^2 = (a - b) X + b X sin^2 wherever a and b have one sign and a is not the smaller."""
    result = dict(polynomial)
    waiting = sorted(polynomial)
    while waiting:
        monomial = waiting.pop()
        for kernel, power in monomial:
            angle = angles.cosine_of(kernel)
            if angle is None or power < 2 or monomial not in result:
                continue
            rest = times(monomial, ((kernel, -2),))
            whole, part = result.get(rest, 0), -result[monomial]
            if whole * part > 0 and abs(whole) >= abs(part):
                del result[monomial]
                add_term(result, rest, -part)
                square = times(rest, ((angles.kernel(sympy.sin(angle)), 2),))
                add_term(result, square, part)
                waiting.append(square)
    return result


def _merge_angles(polynomial: Polynomial, angles: Angles) -> Polynomial | None:
    """One application of an addition theorem that turns two terms into one, or None."""
    for monomial, coefficient in polynomial.items():
        for a, b in _pairs(monomial, angles):
            rest = times(monomial, ((a, -1), (b, -1)))
            partner, merged = _theorem(a, b, angles)
            other = times(rest, partner)
            value = polynomial.get(other)
            if other == monomial or value is None or value not in (coefficient, -coefficient):
                continue
            result = dict(polynomial)
            del result[monomial], result[other]
            _add_function(result, rest, merged[0] if value == coefficient else merged[1], coefficient, angles)
            return result
    return None


def _pairs(monomial: Monomial, angles: Angles) -> Iterator[tuple[int, int]]:
    """Two cosines, or a sine and a cosine, of different angles."""
    cosines = [k for k, p in monomial if p > 0 and angles.cosine_of(k) is not None]
    sines = [k for k, p in monomial if p > 0 and angles.sine_of(k) is not None]
    for index, a in enumerate(cosines):
        yield from ((a, b) for b in cosines[index + 1 :])
    for a in sines:
        yield from ((a, b) for b in cosines if angles.sine_of(a) != angles.cosine_of(b))


def _theorem(a: int, b: int, angles: Angles) -> tuple[Monomial, tuple[Expr, Expr]]:
    """The partner of kernels a, b, and what the two are together if its coefficient is equal or opposite."""
    first, second = angles.cosine_of(a), angles.cosine_of(b)
    assert second is not None
    if first is not None:
        partner = _product(angles, sympy.sin(first), sympy.sin(second))
        return partner, (sympy.cos(first - second), sympy.cos(first + second))
    first = angles.sine_of(a)
    assert first is not None
    partner = _product(angles, sympy.cos(first), sympy.sin(second))
    return partner, (sympy.sin(first + second), sympy.sin(first - second))


def _product(angles: Angles, x: Expr, y: Expr) -> Monomial:
    return times(((angles.kernel(x), 1),), ((angles.kernel(y), 1),))


def _add_function(result: Polynomial, rest: Monomial, function: Expr, coefficient: Expr, angles: Angles) -> None:
    """Add coefficient*rest*function, where SymPy may have pulled a sign out of the function or made it a number."""
    sign, kernel = function.as_coeff_Mul()
    if kernel != 1:
        rest = times(rest, ((angles.kernel(kernel), 1),))
    if sign != 0:
        add_term(result, rest, coefficient * sign)
