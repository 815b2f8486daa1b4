"""Expressions of arrays as one writes them: vectors by their names, sums of like terms with an index."""

from __future__ import annotations

import math
import re
from collections.abc import Callable, Sequence
from functools import reduce
from typing import TypeAlias, TypeGuard

from lagdsl.language.flat import expression as fx
from lagdsl.language.flat.expression_text import flat_expression_text
from lagdsl.language.flat.traversal import rewritten

_Of: TypeAlias = Callable[[fx.FlatExpression], fx.FlatExpression]

_LAST_INDEX = re.compile(r"^(.*?)(?:,(\d+)\]|\[(\d+)\])$")
_VARYING = re.compile(r"(?<=[\[,])\d+(?=[,\]])|(?<![\w.])-?\d+(?:\.\d+)?(?:e[+-]?\d+)?(?![\w.\]])")
_LETTERS = "ica"
_AXES = 3
_FEWEST = 3  # two terms are shorter than their sum


def condensed(expression: fx.FlatExpression) -> str:
    """The text of the expression. `norm(d)` is `norm({d[1], d[2], d[3]})`, `sum(w[i]*x[i] for i in 1:3)` for
    its three terms; numbers that differ from term to term are a list, `{1, 4, 1}[i]`."""
    return flat_expression_text(rewritten(expression, _short))


def condensed_vector(parts: Sequence[fx.FlatExpression]) -> str:
    """Of components: one expression of names without their last index, or a list."""
    whole = _whole(parts)
    return "{" + ", ".join(map(condensed, parts)) + "}" if whole is None else condensed(whole)


def condensed_place(position: fx.FlatExpression) -> str:
    """`frame.point(r)` for the origin of a frame and lengths along its axes."""
    lengths: list[fx.FlatExpression] = [fx.ZERO, fx.ZERO, fx.ZERO]
    rest, frame = position, None
    while isinstance(rest, fx.Binary) and rest.operator == "+" and isinstance(rest.right, fx.Binary):
        along = rest.right.right
        if rest.right.operator != "*" or not isinstance(along, fx.FrameAxis) or frame not in (None, along.frame):
            return condensed(position)
        lengths[along.axis], frame, rest = rest.right.left, along.frame, rest.left
    if frame is None or rest != fx.FrameOrigin(frame):
        return condensed(position)
    return f"{frame}.point({condensed_vector(lengths)})"


def _short(node: object, of: _Of) -> fx.FlatExpression | None:
    if isinstance(node, fx.Vector):
        whole = _whole((node.x, node.y, node.z))
        return None if whole is None else of(whole)
    if isinstance(node, fx.Component):
        return _component(node.vector, node.axis, of)
    if isinstance(node, fx.Binary):
        return _binary(node, of)
    return fx.Variable("pi") if node == fx.Number(math.pi) else None


def _component(vector: fx.FlatExpression, axis: int, of: _Of) -> fx.FlatExpression | None:
    """Of what a vector is made of."""
    if isinstance(vector, fx.Cross):
        return fx.Variable(f"{flat_expression_text(of(vector))}[{axis + 1}]")
    if isinstance(vector, fx.Vector):
        return of((vector.x, vector.y, vector.z)[axis])
    if not isinstance(vector, fx.Binary):
        return None
    left, right = vector.left, vector.right
    if vector.operator != "*":
        left = fx.Component(left, axis)
    if vector.operator != "/":
        right = fx.Component(right, axis)
    return of(fx.Binary(vector.operator, left, right))


def _binary(node: fx.Binary, of: _Of) -> fx.FlatExpression | None:
    """Sums by an index; the number of a sum or a quotient of numbers that have many digits."""
    left, right = node.left, node.right
    if node.operator == "-" and right == fx.ZERO:
        return of(left)
    if node.operator == "/" and isinstance(right, fx.Number):
        number = of(left)
        return fx.Number(number.value / right.value) if _is_long(number) else None
    if node.operator != "+":
        return None
    if isinstance(left, fx.Number) and isinstance(right, fx.Number) and (_is_long(left) or _is_long(right)):
        return fx.Number(left.value + right.value)
    return _summed([of(term) for term in _terms(node) if term != fx.ZERO] or [fx.ZERO])


def _is_long(number: fx.FlatExpression) -> TypeGuard[fx.Number]:
    return isinstance(number, fx.Number) and not number.value.is_integer()


def _whole(parts: Sequence[fx.FlatExpression]) -> fx.FlatExpression | None:
    """The vector whose components these are: of names without their last index, in sums and in products with what all
    components have."""
    found = _merged(parts)
    return None if found == parts[0] else found


def _merged(parts: Sequence[fx.FlatExpression]) -> fx.FlatExpression | None:
    first = parts[0]
    if all(part == first for part in parts):
        return first
    if isinstance(first, fx.Variable):
        return _name(parts)
    if isinstance(first, fx.Component):
        alike = all(part == fx.Component(first.vector, axis) for axis, part in enumerate(parts))
        return first.vector if alike and len(parts) == _AXES else None
    if isinstance(first, fx.Unary) and first.operator == "-":
        operands = [part.operand for part in parts if isinstance(part, fx.Unary) and part.operator == "-"]
        inner = _merged(operands) if len(operands) == len(parts) else None
        return None if inner is None else fx.Unary("-", inner)
    return _merged_two(first, parts) if isinstance(first, fx.Binary) else None


def _merged_two(first: fx.Binary, parts: Sequence[fx.FlatExpression]) -> fx.FlatExpression | None:
    likes = [part for part in parts if isinstance(part, fx.Binary) and part.operator == first.operator]
    if len(likes) < len(parts) or first.operator not in ("+", "-", "*", "/"):
        return None
    left, right = _merged([each.left for each in likes]), _merged([each.right for each in likes])
    if left is None or right is None:
        return None
    changed = (left != first.left, right != first.right)
    fits = all(changed) if first.operator in ("+", "-") else changed[0] != changed[1]
    return fx.Binary(first.operator, left, right) if fits and not (first.operator == "/" and changed[1]) else None


def _name(parts: Sequence[fx.FlatExpression]) -> fx.FlatExpression | None:
    names = [part.name for part in parts if isinstance(part, fx.Variable)]
    found = [_LAST_INDEX.match(name) for name in names]
    wholes = {f"{each[1]}]" if each[2] else each[1] for each in found if each is not None}
    counted = [int(each[2] or each[3]) for each in found if each is not None] == [*range(1, len(parts) + 1)]
    return fx.Variable(wholes.pop()) if counted and len(wholes) == 1 else None


def _summed(terms: Sequence[fx.FlatExpression]) -> fx.FlatExpression:
    """The sum; terms in a row that differ by an index 1, 2, 3 and so on, and by numbers, are one with an index."""
    found: list[fx.FlatExpression] = []
    rest = list(terms)
    while rest:
        counts = range(len(rest), _FEWEST - 1, -1)
        count, first = next(((n, run) for n in counts if (run := _run(rest[:n])) is not None), (1, rest[0]))
        found.append(first)
        rest = rest[count:]
    return reduce(lambda left, right: fx.Binary("+", left, right), found)


def _run(terms: Sequence[fx.FlatExpression]) -> fx.FlatExpression | None:
    texts = [flat_expression_text(each) for each in terms]
    letter = next((each for each in _LETTERS if f" for {each} in " not in texts[0]), None)
    if letter is None or len({_VARYING.sub("", text) for text in texts}) > 1:
        return None
    pattern = _pattern(texts, letter)
    if letter not in pattern:
        return None
    following = iter(pattern)
    return fx.Variable(f"sum({_VARYING.sub(lambda _: next(following), texts[0])} for {letter} in 1:{len(texts)})")


def _pattern(texts: Sequence[str], letter: str) -> list[str]:
    """The replacement of each number of the first text; none where the indices are not 1, 2, 3 and so on."""
    count = [str(number) for number in range(1, len(texts) + 1)]
    found: list[str] = []
    for place, column in zip(
        _VARYING.finditer(texts[0]), zip(*(_VARYING.findall(text) for text in texts), strict=True), strict=True
    ):
        is_index = texts[0][place.start() - 1] in "[,"
        if len(set(column)) == 1:
            found.append(column[0])
        elif is_index and list(column) == count:
            found.append(letter)
        elif is_index:
            return []
        else:
            found.append(f"{{{', '.join(column)}}}[{letter}]")
    return found


def _terms(expression: fx.FlatExpression) -> list[fx.FlatExpression]:
    if isinstance(expression, fx.Binary) and expression.operator == "+":
        return [*_terms(expression.left), *_terms(expression.right)]
    return [expression]
