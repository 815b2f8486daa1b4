"""The syntax tree: product of the syntax floor.

Source shape only: nothing is resolved. Every node carries its span, which does not take part in comparison, so
`parse(print(tree)) == tree`. Trees are immutable; children are tuples.
"""

from __future__ import annotations

from dataclasses import field
from typing import TypeAlias

from lagdsl.record import record
from lagdsl.source import Span


@record(kw_only=True)
class Node:
    span: Span = field(compare=False, repr=False)


# ---- expressions -----------------------------------------------------------------------------------------------------


@record(kw_only=True)
class Number(Node):
    """`1.5e3`; `text` keeps the spelling."""

    text: str


@record(kw_only=True)
class Quantity(Node):
    """`9.81 m/s2`: number and unit as spelled, the unit without the blank (`m/s2`, `/s`)."""

    number: str
    unit: str


@record(kw_only=True)
class String(Node):
    """Text between the quotes, escapes resolved."""

    value: str


@record(kw_only=True)
class Boolean(Node):
    value: bool


@record(kw_only=True)
class Reference(Node):
    """One identifier."""

    name: str


@record(kw_only=True)
class Member(Node):
    """`target.name`; `name_span` covers the identifier after the dot."""

    target: Expression
    name: str
    name_span: Span = field(compare=False, repr=False)


@record(kw_only=True)
class Index(Node):
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
class Call(Node):
    """`function(arguments)`; `function` is a Reference or, for methods, a Member."""

    function: Expression
    arguments: tuple[Expression | Named, ...]


@record(kw_only=True)
class Iterator(Node):
    """`i in range` of a loop, comprehension or reduction."""

    name: str
    range: Expression | Range


@record(kw_only=True)
class Reduction(Node):
    """`sum(body for i in 1:n)`; `function` as in Call."""

    function: Expression
    body: Expression
    iterators: tuple[Iterator, ...]


@record(kw_only=True)
class Comprehension(Node):
    """`{body for i in 1:n}`."""

    body: Expression
    iterators: tuple[Iterator, ...]


@record(kw_only=True)
class Array(Node):
    """`{a, b, c}`."""

    elements: tuple[Expression, ...]


@record(kw_only=True)
class Matrix(Node):
    """`[a, b; c, d]`."""

    rows: tuple[tuple[Expression, ...], ...]


@record(kw_only=True)
class Tuple(Node):
    """`(a, b)`: parsed, not yet given a meaning."""

    elements: tuple[Expression, ...]


@record(kw_only=True)
class Unary(Node):
    """`operator` is one of `-`, `+`, `not`."""

    operator: str
    operand: Expression


@record(kw_only=True)
class Binary(Node):
    """`operator` is one of `+ - * / .* ./ ^ and or < <= > >= == <>`."""

    operator: str
    left: Expression
    right: Expression


@record(kw_only=True)
class Branch(Node):
    condition: Expression
    value: Expression


@record(kw_only=True)
class Conditional(Node):
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

# ---- names, modifiers, declarators -----------------------------------------------------------------------------------


@record(kw_only=True)
class Name(Node):
    """Dotted name: `Lag.Planar.Revolute`."""

    parts: tuple[str, ...]


@record(kw_only=True)
class Modifier(Node):
    """`each final name[dims](nested) = value`; also `der(start = 2)` as name `der` with nested modifiers."""

    prefixes: tuple[str, ...]
    name: Name
    subscripts: tuple[Subscript, ...]
    modifiers: tuple[AnyModifier, ...]
    value: Expression | None


@record(kw_only=True)
class RedeclareComponent(Node):
    type_name: Name
    name: str
    subscripts: tuple[Subscript, ...]
    modifiers: tuple[AnyModifier, ...]


@record(kw_only=True)
class RedeclareClass(Node):
    kind: str
    name: str
    type_name: Name
    modifiers: tuple[AnyModifier, ...]


AnyModifier: TypeAlias = "Modifier | RedeclareComponent | RedeclareClass"


@record(kw_only=True)
class Declarator(Node):
    """`name[dims](modifiers) = value if condition "doc"`; `name_span` covers the identifier."""

    name: str
    name_span: Span = field(compare=False, repr=False)
    subscripts: tuple[Subscript, ...] = ()
    modifiers: tuple[AnyModifier, ...] = ()
    value: Expression | None = None
    condition: Expression | None = None
    doc: str | None = None


# ---- declarations and physics items ----------------------------------------------------------------------------------


@record(kw_only=True)
class Component(Node):
    """`parameter Mass m = 1, n = 2;`: prefixes, type name, declarators."""

    prefixes: tuple[str, ...]
    type_name: Name
    declarators: tuple[Declarator, ...]


@record(kw_only=True)
class Coordinate(Node):
    """`coordinate Angle q(start = 1);`."""

    type_name: Name
    declarators: tuple[Declarator, ...]


@record(kw_only=True)
class Geometry(Node):
    """`point P = ...;` or `frame F = ...;`: `keyword` is `point` or `frame`."""

    keyword: str
    declarators: tuple[Declarator, ...]


@record(kw_only=True)
class Energy(Node):
    """`kinetic T = ...;`: `keyword` is kinetic, potential, dissipation or lagrangian."""

    keyword: str
    label: str | None
    value: Expression
    condition: Expression | None
    doc: str | None


@record(kw_only=True)
class Gravity(Node):
    value: Expression
    doc: str | None


@record(kw_only=True)
class PointMass(Node):
    """`mass m at P;`."""

    mass: Expression
    at: Expression
    condition: Expression | None
    doc: str | None


@record(kw_only=True)
class RigidBody(Node):
    """`body b(m = ..., I = {...}) on A;`."""

    label: str | None
    modifiers: tuple[AnyModifier, ...]
    on: Expression
    condition: Expression | None
    doc: str | None


@record(kw_only=True)
class Load(Node):
    """`force F = value at P on B from R on C if c;`: `keyword` is force or torque.

    `at` is given for `at P [on B]`; without it `on` is a frame or a scalar. `origin` follows `from`; `from R on C` has
    `origin_on` too.
    """

    keyword: str
    label: str | None
    value: Expression
    at: Expression | None
    on: Expression | None
    origin: Expression | None
    origin_on: Expression | None
    condition: Expression | None
    doc: str | None


@record(kw_only=True)
class Constraint(Node):
    label: str | None
    left: Expression
    right: Expression
    condition: Expression | None
    doc: str | None


@record(kw_only=True)
class Contact(Node):
    label: str | None
    value: Expression
    options: tuple[Named, ...]
    condition: Expression | None
    doc: str | None


@record(kw_only=True)
class Invariant(Node):
    label: str | None
    value: Expression
    options: tuple[Named, ...]
    condition: Expression | None
    doc: str | None


@record(kw_only=True)
class Draw(Node):
    """`draw rod(radius = r) from A to B;`: `place` is at, on, between or None with one or two expressions."""

    shape: str
    arguments: tuple[Expression | Named, ...]
    place: str | None
    anchors: tuple[Expression, ...]
    condition: Expression | None


@record(kw_only=True)
class Connect(Node):
    items: tuple[Expression, ...]
    condition: Expression | None


@record(kw_only=True)
class Extends(Node):
    base: Name
    modifiers: tuple[AnyModifier, ...]


@record(kw_only=True)
class Annotation(Node):
    modifiers: tuple[AnyModifier, ...]


# ---- equations and structure -----------------------------------------------------------------------------------------


@record(kw_only=True)
class Equation(Node):
    left: Expression
    right: Expression
    doc: str | None


@record(kw_only=True)
class CallEquation(Node):
    """An expression standing as an equation: `assert(...)`, `reinit(...)`."""

    call: Expression
    doc: str | None


@record(kw_only=True)
class For(Node):
    iterators: tuple[Iterator, ...]
    body: tuple[Item, ...]


@record(kw_only=True)
class IfBranch(Node):
    condition: Expression
    body: tuple[Item, ...]


@record(kw_only=True)
class If(Node):
    branches: tuple[IfBranch, ...]
    otherwise: tuple[Item, ...] | None


@record(kw_only=True)
class WhenBranch(Node):
    condition: Expression
    body: tuple[Item, ...]


@record(kw_only=True)
class When(Node):
    branches: tuple[WhenBranch, ...]


@record(kw_only=True)
class Section(Node):
    """A header and what follows it.

    `keyword` is public, protected, equation, kinematics, closure or `initial equation`.
    """

    keyword: str
    items: tuple[Item, ...]


# ---- classes and units -----------------------------------------------------------------------------------------------


@record(kw_only=True)
class Class(Node):
    """`model Name "doc" items sections end Name;`. `end_name` is None where the text leaves it out."""

    prefixes: tuple[str, ...]
    kind: str
    name: str
    name_span: Span = field(compare=False, repr=False)
    doc: str | None
    items: tuple[Item, ...]
    sections: tuple[Section, ...]
    end_name: str | None


@record(kw_only=True)
class ShortClass(Node):
    """`model S = Lib.Spring(k = 2);`."""

    prefixes: tuple[str, ...]
    kind: str
    name: str
    base: Name
    subscripts: tuple[Subscript, ...]
    modifiers: tuple[AnyModifier, ...]
    doc: str | None


@record(kw_only=True)
class TypeDefinition(Node):
    """`type T = Real[3](unit = "m");` or, with `literals`, an enumeration (then `base` is None)."""

    name: str
    base: Name | None
    subscripts: tuple[Subscript, ...]
    modifiers: tuple[AnyModifier, ...]
    literals: tuple[str, ...]
    doc: str | None


@record(kw_only=True)
class FunctionParameter(Node):
    type_name: Name
    name: str
    subscripts: tuple[Subscript, ...]
    default: Expression | None


@record(kw_only=True)
class Function(Node):
    """`function f(Real x) -> Real = x^2;`."""

    name: str
    parameters: tuple[FunctionParameter, ...]
    result: Name | None
    result_subscripts: tuple[Subscript, ...]
    value: Expression
    doc: str | None


@record(kw_only=True)
class Import(Node):
    """`import A.B;`, `import X = A.B;` (alias), `import A.*;` (wildcard), `import A.{b, c};` (names)."""

    name: Name
    alias: str | None = None
    wildcard: bool = False
    names: tuple[str, ...] = ()


Item: TypeAlias = (
    "Import | Class | ShortClass | TypeDefinition | Function | Component | Coordinate | Geometry | Energy "
    "| Gravity | PointMass | RigidBody | Load | Constraint | Contact | Invariant | Draw | Connect | "
    "Extends | Annotation | Equation | CallEquation | For | If | When"
)


@record(kw_only=True)
class Unit(Node):
    """A compilation unit: one file."""

    within: Name | None
    has_within: bool
    items: tuple[Item, ...]
