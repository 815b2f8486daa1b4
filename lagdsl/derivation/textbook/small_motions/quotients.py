"""Quotients and linear systems of expressions, in lowest terms and short, with a bound on the work."""

from __future__ import annotations

from collections.abc import Sequence

from sympy import Add, Expr, Integer, Mul

from lagdsl.derivation.textbook.polynomial import Polynomial
from lagdsl.derivation.textbook.rational import divided, in_lowest_terms
from lagdsl.derivation.textbook.tidy import Tidy, TooLargeError, size

_LARGEST_BLOCK = 3
_LONGEST_DETERMINANT = 400


def ratio(tidy: Tidy, numerator: Expr, denominator: Expr) -> Expr:
    """numerator/denominator in lowest terms. Raises TooLargeError, ZeroDivisionError."""
    above, below = tidy.reduced(numerator), tidy.reduced(denominator)
    if not below:
        raise ZeroDivisionError
    if not above:
        return Integer(0)
    above, below = in_lowest_terms(above, below)
    if len(below) == 1:
        return tidy.collected(_over(above, below))
    up, down = tidy.collected(above), tidy.collected(below)
    return -up / -down if _negative(down) else up / down


def _negative(expression: Expr) -> bool:
    return expression.is_Add and all(term.as_coeff_Mul()[0].is_negative for term in expression.args)


def _over(above: Polynomial, below: Polynomial) -> Polynomial:
    [(monomial, coefficient)] = below.items()
    return {m: c / coefficient for m, c in divided(above, monomial).items()}


def blocks(pattern: Sequence[Sequence[bool]]) -> list[list[int]]:
    """Rows and columns that hang together, in ascending order."""
    left, result = set(range(len(pattern))), []
    while left:
        waiting, found = [min(left)], set[int]()
        while waiting:
            row = waiting.pop()
            found.add(row)
            waiting += [k for k in left - found if pattern[row][k] or pattern[k][row]]
        left -= found
        result.append(sorted(found))
    return result


def determinant(rows: Sequence[Sequence[Expr]]) -> Expr:
    """By the first row, zeros left out."""
    if len(rows) == 1:
        return rows[0][0]
    minors = (
        Mul((-1) ** j, entry, determinant([[*row[:j], *row[j + 1 :]] for row in rows[1:]]))
        for j, entry in enumerate(rows[0])
        if entry != 0
    )
    return Add(*minors)


def solved(tidy: Tidy, matrix: Sequence[Sequence[Expr]], right: Sequence[Expr]) -> list[Expr | None]:
    """x of matrix x = right by Cramer's rule, block by block; None for what is in a block too large or singular."""
    result: list[Expr | None] = [None] * len(right)
    for block in blocks([[entry != 0 for entry in row] for row in matrix]):
        part = [[matrix[i][j] for j in block] for i in block]
        extent = sum(size(entry) for row in part for entry in row) + sum(size(right[i]) for i in block)
        if len(block) > _LARGEST_BLOCK or (len(block) > 1 and extent > _LONGEST_DETERMINANT):
            continue
        below = determinant(part)
        for place, i in enumerate(block):
            replaced = [[*row[:place], right[k], *row[place + 1 :]] for row, k in zip(part, block, strict=True)]
            try:
                result[i] = ratio(tidy, determinant(replaced), below)
            except (TooLargeError, ZeroDivisionError):
                continue
    return result
