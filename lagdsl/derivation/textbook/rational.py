"""Polynomial arithmetic over the rationals that is worth handing to SymPy's rings: factors, and exact division."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterable
from typing import Any

from sympy import QQ, Expr, Integer, Rational
from sympy.polys.rings import PolyRing

from lagdsl.derivation.textbook.polynomial import Monomial, Polynomial, exponents, times

_LARGEST_TO_CANCEL = 400
_MOST_KERNELS = 10


def lowest(polynomial: Polynomial) -> Monomial:
    """The monomial that divides every term (exponents may be negative)."""
    tables = [dict(monomial) for monomial in polynomial]
    kernels = sorted({kernel for table in tables for kernel in table})
    powers = ((kernel, min(table.get(kernel, 0) for table in tables)) for kernel in kernels)
    return tuple((kernel, power) for kernel, power in powers if power)


def divided(polynomial: Polynomial, monomial: Monomial) -> Polynomial:
    inverse = tuple((kernel, -power) for kernel, power in monomial)
    return {times(m, inverse): coefficient for m, coefficient in polynomial.items()}


def factors(polynomial: Polynomial) -> tuple[Expr, list[tuple[Polynomial, int]]]:
    """Content and factors of a polynomial without negative exponents."""
    kernels = _kernels(polynomial)
    whole = _to_ring(polynomial, kernels)
    content, parts = _primitive(whole) if _is_irreducible(polynomial) else whole.factor_list()
    result = [(_from_ring(part.terms(), kernels), power) for part, power in parts]
    return Rational(content.numerator, content.denominator), result


def _is_irreducible(polynomial: Polynomial) -> bool:
    """True for a x + r, where x is in no term of r and a is one monomial, if no monomial divides all terms: a factor
    without x would divide a, so that it is a monomial, too. All others may have factors."""
    counts = Counter(kernel for monomial in polynomial for kernel, _ in monomial)
    alone = any(power == 1 and counts[kernel] == 1 for monomial in polynomial for kernel, power in monomial)
    return alone and len(polynomial) > 1 and not lowest(polynomial)


def _primitive(whole: Any) -> tuple[Any, list[tuple[Any, int]]]:
    """As `factor_list` has it: content, and the rest with a positive leading coefficient."""
    content, rest = whole.primitive()
    return (-content, [(-rest, 1)]) if rest.LC < 0 else (content, [(rest, 1)])


def quotient(polynomial: Polynomial, divisor: Polynomial) -> Polynomial | None:
    """polynomial/divisor where that leaves no remainder; exponents of either sign."""
    common, other = lowest(polynomial), lowest(divisor)
    kernels = _kernels(polynomial, divisor)
    ring_quotient, remainder = _to_ring(divided(polynomial, common), kernels).div(
        _to_ring(divided(divisor, other), kernels)
    )
    if remainder:
        return None
    result = _from_ring(ring_quotient.terms(), kernels)
    shift = times(common, tuple((kernel, -power) for kernel, power in other))
    return {times(monomial, shift): coefficient for monomial, coefficient in result.items()}


def in_lowest_terms(above: Polynomial, below: Polynomial) -> tuple[Polynomial, Polynomial]:
    """A fraction without common factors, as far as the bound lets one look for them."""
    shared = lowest({**dict.fromkeys(above, Integer(1)), **dict.fromkeys(below, Integer(1))})
    above, below = divided(above, shared), divided(below, shared)
    kernels = _kernels(above, below)
    if len(below) == 1 or len(above) * len(below) > _LARGEST_TO_CANCEL or len(kernels) > _MOST_KERNELS:
        return above, below
    ring_above, ring_below = _to_ring(above, kernels), _to_ring(below, kernels)
    first, second = ring_above.cancel(ring_below)
    return _from_ring(first.terms(), kernels), _from_ring(second.terms(), kernels)


def _kernels(*polynomials: Polynomial) -> list[int]:
    return sorted({kernel for polynomial in polynomials for monomial in polynomial for kernel, _ in monomial})


def _to_ring(polynomial: Polynomial, kernels: list[int]) -> Any:
    ring = PolyRing([f"x{kernel}" for kernel in kernels], QQ)
    return ring.from_dict({exponents(monomial, kernels): QQ(c.p, c.q) for monomial, c in polynomial.items()})


def _from_ring(terms: Iterable[tuple[tuple[int, ...], object]], kernels: list[int]) -> Polynomial:
    return {
        tuple((kernel, power) for kernel, power in zip(kernels, powers, strict=True) if power): QQ.to_sympy(value)
        for powers, value in terms
    }
