"""Numbers without a unit that were most likely meant in another one (W0421).

A bare number takes the declared unit. Two signs tell that it should not: an angle of more than a turn, which is degrees
read as radians, and a number that is the only one without a unit in its text.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from math import pi

from lagdsl.foundation.diagnostics import Label
from lagdsl.foundation.record import record
from lagdsl.foundation.units.written import literal_text
from lagdsl.language.flat.expression import FlatExpression
from lagdsl.language.flat.quantity import MORE_THAN_A_TURN
from lagdsl.language.semantics.scope.constants import NoValue, evaluate
from lagdsl.language.semantics.scope.context import Context, Written
from lagdsl.language.semantics.scope.scope import Scope
from lagdsl.language.semantics.scope.values import Array, Scalar
from lagdsl.language.semantics.types.dimensions import bare_number
from lagdsl.language.syntax import nodes
from lagdsl.language.syntax.walk import descendants

_ANGLES = {"rad": "deg", "rad/s": "deg/s"}


@record()
class _Piece:
    """A value of its own within a binding: the text, its numbers where they are known, indices of loops in it."""

    node: nodes.Node
    values: Sequence[FlatExpression] = ()
    indices: frozenset[str] = frozenset()


def collect(ctx: Context, scope: Scope, node: nodes.Node, value: Scalar | Array, unit: str) -> None:
    """Remember how the text of the model writes a value that is declared in `unit`; W0421 for angles of more than a
    turn."""
    if unit == "1" or node.span.file is not ctx.conventions.home:
        return
    whole = _Piece(node, value.elements if isinstance(value, Array) else (value.expression,))
    found: list[Written] = []
    for piece in _pieces(whole):
        if not _is_literal(scope, piece):
            continue
        bare = not any(isinstance(part, nodes.Quantity) for part in descendants(piece.node))
        number = _number(piece) if bare else None
        if number is not None and unit == "rad":
            warn_turns(ctx, piece.node, number)
        if number or not bare:
            found.append(Written(piece.node, node.span, unit, number))
    if not isinstance(node, nodes.Array | nodes.Matrix) or any(each.bare is None for each in found):
        ctx.reports.written.update({each.node.span.start: each for each in found})  # a table of numbers tells nothing


def warn_turns(ctx: Context, node: nodes.Node, number: float) -> None:
    """W0421 where `number`, which stands in the text as `node`, is more than a turn in radians."""
    if abs(number) > MORE_THAN_A_TURN:
        _report(ctx, Label(node.span), node, number, "rad")


def warn_unlike(ctx: Context) -> None:
    """W0421 for the numbers of the only value without a unit in the text, where others of its kind have one."""
    written = list(ctx.reports.written.values())
    bare = [each for each in written if each.bare is not None]
    if len({each.whole.start for each in bare}) != 1:
        return
    kinds = {each.unit for each in written if each.bare is None}
    for each in bare:
        if each.bare and each.unit in kinds and (each.unit != "rad" or abs(each.bare) <= MORE_THAN_A_TURN):
            label = Label(each.node.span, "the text writes all other values with a unit")
            _report(ctx, label, each.node, each.bare, each.unit)


def _report(ctx: Context, place: Label, node: nodes.Node, number: float, unit: str) -> None:
    text = node.span.text
    simple = text.replace(" ", "") == bare_number(node)
    reading = literal_text(f"{number:.6g}", unit)
    units = [unit]
    if unit in _ANGLES:
        reading += f" = {number * 180.0 / pi:.4g} {_ANGLES[unit]}"
        units.insert(0, _ANGLES[unit])
    ways = [literal_text(text, each) if simple else f"({text})*({literal_text('1', each)})" for each in units]
    if not ctx.conventions.units:  # where units are refused
        ways = [f"{text}*pi/180" if simple else f"({text})*pi/180", f"{number / pi:.6g}*pi"]
    ctx.sink.report("W0421", place, what=text, reading=reading, ways=" or ".join(f"`{way}`" for way in ways))


def _pieces(piece: _Piece) -> Iterator[_Piece]:
    node, values = piece.node, piece.values
    if isinstance(node, nodes.Parenthesized):
        yield from _pieces(_Piece(node.inner, values, piece.indices))
    elif isinstance(node, nodes.Array | nodes.Matrix):
        rows = (node.elements,) if isinstance(node, nodes.Array) else node.rows
        parts = [part for row in rows for part in row]
        size = len(values) // len(parts) if parts and len(values) % len(parts) == 0 else 0
        for k, part in enumerate(parts):
            yield from _pieces(_Piece(part, values[k * size : (k + 1) * size], piece.indices))
    elif isinstance(node, nodes.Conditional):
        for part in (*(branch.value for branch in node.branches), node.otherwise):
            yield from _pieces(_Piece(part, (), piece.indices))
    elif isinstance(node, nodes.Comprehension):
        indices = piece.indices | {iterator.name for iterator in node.iterators}
        yield from _pieces(_Piece(node.body, values, indices))
    elif isinstance(node, nodes.Call) and node.function.span.text == "fill" and node.arguments:
        yield from _pieces(_Piece(node.arguments[0], values[:1], piece.indices))
    else:
        yield piece


def _is_literal(scope: Scope, piece: _Piece) -> bool:
    """True if the text holds numbers, with or without units, and indices of loops only."""
    for part in descendants(piece.node):
        if isinstance(part, nodes.Reference):
            if part.name not in piece.indices and not _is_index(scope, part.name):
                return False
        elif not isinstance(part, nodes.Number | nodes.Quantity | nodes.Unary | nodes.Binary | nodes.Parenthesized):
            return False
    return True


def _is_index(scope: Scope, name: str) -> bool:
    for step in scope.chain():
        if step.kind != "local":
            return False
        if name in step.entries:
            return True
    return False


def _number(piece: _Piece) -> float | None:
    """The largest of the values; None where they are not known."""
    if not piece.values:
        text = bare_number(piece.node)
        return float(text.replace("--", "")) if text is not None else None
    try:
        return max((evaluate(value) for value in piece.values), key=abs)
    except NoValue:
        return None
