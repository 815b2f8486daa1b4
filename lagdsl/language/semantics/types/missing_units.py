"""Help for values of another dimension: a number that lacks its unit, a unit at the wrong place of a quotient."""

from __future__ import annotations

from collections.abc import Iterator

from lagdsl.foundation.record import record
from lagdsl.foundation.units import Dimension
from lagdsl.foundation.units.dimension import DIMENSIONLESS
from lagdsl.foundation.units.naming import unit_text
from lagdsl.foundation.units.parse import UnknownUnit, parse_unit
from lagdsl.foundation.units.written import literal_text
from lagdsl.language.semantics.scope.values import AnyDimension
from lagdsl.language.syntax import nodes


def unit_help(node: nodes.Node, found: AnyDimension, wanted: Dimension) -> str | None:
    """The text that gives `node`, of the dimension `found`, the dimension `wanted`: `(1 s)/30` for `1/30 s`, `86164 s`
    in `2*pi/86164`; None where no unit alone does it."""
    present = found or DIMENSIONLESS
    for part, below in _factors(node, below=False):
        quotient = _quotient(part)
        if quotient is not None and (present / quotient.square if below else present * quotient.square) == wanted:
            return f"`{part.span.text}` divides by the unit, too: write `{quotient.meant}`"
    if present != DIMENSIONLESS:
        return None  # a formula with units in it is more likely to be wrong as a whole
    numbers = [(part, below) for part, below in _factors(node, below=False) if isinstance(part, nodes.Number)]
    for number, below in sorted(numbers, key=lambda each: (not each[1], -each[0].span.start)):
        unit = unit_text(DIMENSIONLESS / wanted if below else wanted)
        literal = literal_text(number.text, unit)
        if "^" not in unit and not (below and "/" in unit):
            return f"a unit is missing: write `{f'({literal})' if '/' in unit else literal}` for `{number.text}`"
    return None


@record()
class _Quotient:
    """`1/30 s`: the text that is meant, and the square of the unit, by which the dimension of that is another one."""

    meant: str
    square: Dimension


def _quotient(node: nodes.Node) -> _Quotient | None:
    if not isinstance(node, nodes.Binary) or node.operator != "/":
        return None
    if not isinstance(node.left, nodes.Number) or not isinstance(node.right, nodes.Quantity):
        return None
    try:
        own = parse_unit(node.right.unit).dimension
    except UnknownUnit:
        return None
    return _Quotient(f"({literal_text(node.left.text, node.right.unit)})/{node.right.number}", own * own)


def _factors(node: nodes.Node, *, below: bool) -> Iterator[tuple[nodes.Node, bool]]:
    """The factors of a product, products and quotients in it included, and whether they divide."""
    yield node, below
    if isinstance(node, nodes.Parenthesized | nodes.Unary):
        yield from _factors(node.inner if isinstance(node, nodes.Parenthesized) else node.operand, below=below)
    elif isinstance(node, nodes.Binary) and node.operator in ("*", "/"):
        yield from _factors(node.left, below=below)
        yield from _factors(node.right, below=below != (node.operator == "/"))
