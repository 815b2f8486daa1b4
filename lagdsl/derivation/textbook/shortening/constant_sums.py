"""Sums of constants that a model writes as factors, as R - r: people leave them whole, and with that sign."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence

from sympy import Expr, Mul

from lagdsl.language.flat import expression as fx
from lagdsl.language.flat.model import Definition, FlatModel, Frame, Point, PointForce
from lagdsl.language.flat.traversal import operands, postorder, step_expressions


def constant_sums(
    flat: FlatModel, constants: frozenset[str], scalar: Callable[[fx.FlatExpression], Expr]
) -> frozenset[Expr]:
    """Sums of `constants` that are factors in the text; `scalar` converts them."""
    found = set()
    seen: dict[int, None] = {}
    for expression in _expressions(flat):
        for node in postorder(expression, seen):
            seen[id(node)] = None
            if isinstance(node, fx.Binary) and node.operator in "*/^":
                found |= {scalar(each) for each in (node.left, node.right) if _is_constant_sum(each, constants)}
    return frozenset(each for each in found if each.is_Add)


def _is_constant_sum(node: fx.FlatExpression, constants: frozenset[str]) -> bool:
    if not (isinstance(node, fx.Binary) and node.operator in "+-"):
        return False
    leaves = [each for each in postorder(node) if not operands(each)]
    plain = all(isinstance(each, fx.Binary | fx.Number | fx.Variable | fx.Unary) for each in postorder(node))
    return plain and all(
        isinstance(e, fx.Number) or (isinstance(e, fx.Variable) and e.name in constants) for e in leaves
    )


def _expressions(flat: FlatModel) -> Iterator[fx.FlatExpression]:
    for item in flat.named:
        match item:
            case Definition(value=value):
                yield value
            case Point(position=position):
                yield position
            case Frame(steps=steps):
                yield from (expression for step in steps for expression in step_expressions(step))
    yield from (term.value for term in flat.energies)
    yield from (mass.position for mass in flat.masses)
    for body in flat.bodies:
        yield from (*body.com, *body.inertia)
    for constraint in flat.constraints:
        yield from constraint.residuals
    yield from (load.point for load in flat.loads if isinstance(load, PointForce))


def oriented(expression: Expr, sums: frozenset[Expr]) -> Expr:
    """The negative of one of the `sums` as a factor with its sign before the product."""
    if not sums or expression.is_Atom:
        return expression
    inner = [oriented(argument, sums) for argument in expression.args]
    same = all(one is other for one, other in zip(inner, expression.args, strict=True))
    node = expression if same else _rebuilt(expression, inner)
    return _turned(node, sums) if node.is_Mul else node


def _rebuilt(expression: Expr, inner: Sequence[Expr]) -> Expr:
    return _product(inner) if expression.is_Mul else expression.func(*inner)


def _product(factors: Sequence[Expr]) -> Expr:
    """A number before a sum stays there, which SymPy would multiply out."""
    kept = len(factors) == 2 and factors[0].is_Rational and factors[1].is_Add
    return Mul(*factors, evaluate=False) if kept else Mul(*factors)


def _turned(product: Expr, sums: frozenset[Expr]) -> Expr:
    factors = list(product.args)
    sign = 1
    for place, factor in enumerate(factors):
        base, power = factor.as_base_exp()
        if base.is_Add and power.is_Integer and -base in sums:
            factors[place] = (-base) ** power
            sign *= -1 if power % 2 else 1
    if factors == list(product.args):
        return product
    if sign < 0:
        number = [factor for factor in factors if factor.is_Rational]
        factors = [factor for factor in factors if not factor.is_Rational]
        lead = -number[0] if number else -1
        factors = ([] if lead == 1 else [lead]) + factors
    return _product(factors)


def known_sums(expression: Expr, sums: frozenset[Expr]) -> int:
    """Number of places in it at which one of them is a factor."""
    if not sums or expression.is_Atom:
        return 0
    own = sum(factor.as_base_exp()[0] in sums for factor in expression.args) if expression.is_Mul else 0
    return own + sum(known_sums(argument, sums) for argument in expression.args)
