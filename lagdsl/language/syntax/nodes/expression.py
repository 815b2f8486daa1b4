"""The syntax tree: its root class and the expressions.

Source shape only: nothing is resolved. Every node carries its span, which does not take part in comparison, so
`parse(print(tree)) == tree`. Trees are immutable; children are tuples.
"""

from __future__ import annotations

from dataclasses import field
from typing import TypeAlias

from lagdsl.foundation.record import record
from lagdsl.foundation.source import Span


@record(kw_only=True)
class Node:
    span: Span = field(compare=False, repr=False)


# ---- groups: a case over all expressions names those it treats alike by these ----------------------------------------


class Literal(Node):
    """A value as it is spelled."""

    __slots__ = ()


class Designator(Node):
    """A name, or a part of what is named."""

    __slots__ = ()


class Compound(Node):
    """A value made of others."""

    __slots__ = ()


# ---- expressions -----------------------------------------------------------------------------------------------------


@record(kw_only=True)
class Number(Literal):
    """`1.5e3`; `text` keeps the spelling."""

    text: str


@record(kw_only=True)
class Quantity(Literal):
    """`9.81 m/s2`: number and unit as spelled, the unit without the blank (`m/s2`, `/s`)."""

    number: str
    unit: str


@record(kw_only=True)
class String(Literal):
    """Text between the quotes, escapes resolved."""

    value: str


@record(kw_only=True)
class Boolean(Literal):
    value: bool


@record(kw_only=True)
class Reference(Designator):
    """One identifier."""

    name: str


@record(kw_only=True)
class Member(Designator):
    """`target.name`; `name_span` covers the identifier after the dot."""

    target: Expression
    name: str
    name_span: Span = field(compare=False, repr=False)


@record(kw_only=True)
class Index(Designator):
    """`target[i, j]`."""

    target: Expression
    subscripts: tuple[Subscript, ...]


@record(kw_only=True)
class Range(Node):
    """`start:stop` or `start:step:stop`. A single expression is not wrapped in a Range."""

    start: Expression
    step: Expression | None
    stop: Expression


@record(kw_only=True)
class All(Node):
    """`:` as a subscript or array size."""


@record(kw_only=True)
class Named(Node):
    """`name = value` as an argument."""

    name: str
    value: Expression


@record(kw_only=True)
class Call(Compound):
    """`function(arguments)`; `function` is a Reference or, for methods, a Member."""

    function: Expression
    arguments: tuple[Expression | Named, ...]


@record(kw_only=True)
class Iterator(Node):
    """`i in range` of a loop, comprehension or reduction."""

    name: str
    range: Expression | Range


@record(kw_only=True)
class Reduction(Compound):
    """`sum(body for i in 1:n)`; `function` as in Call."""

    function: Expression
    body: Expression
    iterators: tuple[Iterator, ...]


@record(kw_only=True)
class Comprehension(Compound):
    """`{body for i in 1:n}`."""

    body: Expression
    iterators: tuple[Iterator, ...]


@record(kw_only=True)
class Array(Compound):
    """`{a, b, c}`."""

    elements: tuple[Expression, ...]


@record(kw_only=True)
class Matrix(Compound):
    """`[a, b; c, d]`."""

    rows: tuple[tuple[Expression, ...], ...]


@record(kw_only=True)
class Tuple(Compound):
    """`(a, b)`: parsed, not yet given a meaning."""

    elements: tuple[Expression, ...]


@record(kw_only=True)
class Unary(Compound):
    """`operator` is one of `-`, `+`, `not`."""

    operator: str
    operand: Expression


@record(kw_only=True)
class Binary(Compound):
    """`operator` is one of `+ - * / .* ./ ^ and or < <= > >= == <>`."""

    operator: str
    left: Expression
    right: Expression


@record(kw_only=True)
class Branch(Node):
    condition: Expression
    value: Expression


@record(kw_only=True)
class Conditional(Compound):
    """`if c then a elseif d then b else e`."""

    branches: tuple[Branch, ...]
    otherwise: Expression


@record(kw_only=True)
class Parenthesized(Node):
    """`(inner)`: kept, so that text prints back as written."""

    inner: Expression


Expression: TypeAlias = (
    "Number | Quantity | String | Boolean | Reference | Member | Index | Call | Reduction | Comprehension "
    "| Array | Matrix | Tuple | Unary | Binary | Conditional | Parenthesized"
)
Subscript: TypeAlias = "Expression | Range | All"
