"""Angles beside numbers: `theta > 90`, `theta = 45`, `mod(theta, 360)`."""

from __future__ import annotations

from itertools import permutations

from lagdsl.foundation.units.parse import counts_angles, parse_unit
from lagdsl.language.semantics.operators.paths import designated
from lagdsl.language.semantics.scope.context import Context
from lagdsl.language.semantics.scope.scope import Scope, Symbol
from lagdsl.language.semantics.types.bare_numbers import warn_turns
from lagdsl.language.semantics.types.dimensions import bare_number
from lagdsl.language.syntax import nodes

_COMPARED = ("+", "-", "<", "<=", ">", ">=", "==", "<>")
_FUNCTIONS = ("mod", "min", "max")


def check_operator(ctx: Context, scope: Scope, node: nodes.Binary) -> None:
    """W0421 for a number of more than a turn in a sum with an angle, or compared with one."""
    if node.operator in _COMPARED:
        check_beside(ctx, scope, node.left, node.right)


def stands_beside_number(node: nodes.Binary) -> bool:
    """True for operands of which it matters that one is an angle."""
    sides = (node.left, node.right)
    return node.operator in _COMPARED and any(bare_number(side) is not None for side in sides)


def check_call(ctx: Context, scope: Scope, node: nodes.Call) -> None:
    """The same for functions of quantities of one kind."""
    if isinstance(node.function, nodes.Reference) and node.function.name in _FUNCTIONS:
        check_beside(ctx, scope, *(part for part in node.arguments if not isinstance(part, nodes.Named)))


def check_beside(ctx: Context, scope: Scope, *sides: nodes.Expression) -> None:
    """W0421 for a number of more than a turn that stands beside an angle."""
    for side, other in permutations(sides, 2):
        bare = bare_number(side)
        if bare is not None and side.span.file is ctx.conventions.home and _is_angle(ctx, scope, other):
            warn_turns(ctx, side, float(bare.replace("--", "")))


def _is_angle(ctx: Context, scope: Scope, node: nodes.Node) -> bool:
    """True for a name that is declared as an angle, a literal of one, and sums with one."""
    if isinstance(node, nodes.Quantity):
        return counts_angles(node.unit) and parse_unit(node.unit).dimension.is_dimensionless
    if isinstance(node, nodes.Parenthesized | nodes.Unary):
        return _is_angle(ctx, scope, node.inner if isinstance(node, nodes.Parenthesized) else node.operand)
    if isinstance(node, nodes.Binary):
        return node.operator in ("+", "-") and any(_is_angle(ctx, scope, each) for each in (node.left, node.right))
    if not isinstance(node, nodes.Reference | nodes.Member | nodes.Index):
        return False
    entry = designated(ctx, scope, node.target if isinstance(node, nodes.Index) else node)
    return isinstance(entry, Symbol) and entry.info is not None and entry.info.unit == "rad"
