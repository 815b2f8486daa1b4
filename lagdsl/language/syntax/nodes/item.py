"""The syntax tree: items of files and classes, with their sections."""

from __future__ import annotations

from dataclasses import field
from typing import TypeAlias

from lagdsl.foundation.record import record
from lagdsl.foundation.source import Span
from lagdsl.language.syntax.nodes.declarator import AnyModifier, Declarator, Name
from lagdsl.language.syntax.nodes.expression import (
    Expression,
    Iterator,
    Named,
    Node,
    Subscript,
)

# ---- groups: a case over all items names those it treats alike by these ----------------------------------------------


class Definition(Node):
    """A class, a type or a function."""

    __slots__ = ()


class Declaration(Node):
    """Named quantities, components or geometry."""

    __slots__ = ()


class Physics(Node):
    """A term of the mechanics."""

    __slots__ = ()


class Relation(Node):
    """An equation, a call as an equation, or `connect`."""

    __slots__ = ()


class Block(Node):
    """Items under an index or a condition."""

    __slots__ = ()


# ---- declarations and physics items ----------------------------------------------------------------------------------


@record(kw_only=True)
class Component(Declaration):
    """`parameter Mass m = 1, n = 2;`: prefixes, type name, declarators."""

    prefixes: tuple[str, ...]
    type_name: Name
    declarators: tuple[Declarator, ...]


@record(kw_only=True)
class Coordinate(Declaration):
    """`coordinate Angle q(start = 1);`."""

    type_name: Name
    declarators: tuple[Declarator, ...]


@record(kw_only=True)
class Geometry(Declaration):
    """`point P = ...;` or `frame F = ...;`: `keyword` is `point` or `frame`."""

    keyword: str
    declarators: tuple[Declarator, ...]


@record(kw_only=True)
class Energy(Physics):
    """`kinetic T = ...;`: `keyword` is kinetic, potential, dissipation or lagrangian."""

    keyword: str
    label: str | None
    value: Expression
    condition: Expression | None
    doc: str | None


@record(kw_only=True)
class Gravity(Physics):
    value: Expression
    doc: str | None


@record(kw_only=True)
class PointMass(Physics):
    """`mass m at P;`."""

    mass: Expression
    at: Expression
    condition: Expression | None
    doc: str | None


@record(kw_only=True)
class RigidBody(Physics):
    """`body b(m = ..., I = {...}) on A;`."""

    label: str | None
    modifiers: tuple[AnyModifier, ...]
    on: Expression
    condition: Expression | None
    doc: str | None


@record(kw_only=True)
class Load(Physics):
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
class Constraint(Physics):
    label: str | None
    left: Expression
    right: Expression
    condition: Expression | None
    doc: str | None


@record(kw_only=True)
class Contact(Physics):
    label: str | None
    value: Expression
    options: tuple[Named, ...]
    condition: Expression | None
    doc: str | None


@record(kw_only=True)
class Friction(Physics):
    """`friction brake: der(q) with limit = r;`."""

    label: str | None
    value: Expression
    options: tuple[Named, ...]
    condition: Expression | None
    doc: str | None


@record(kw_only=True)
class Invariant(Physics):
    label: str | None
    value: Expression
    options: tuple[Named, ...]
    condition: Expression | None
    doc: str | None


@record(kw_only=True)
class Measure(Physics):
    """`measure encoder: theta with sigma = 0.2 deg;`: `column` is the name in data, None: that of the value."""

    column: str | None
    value: Expression
    options: tuple[Named, ...]
    doc: str | None


@record(kw_only=True)
class Draw(Physics):
    """`draw rod(radius = r) from A to B;`: `place` is at, on, between or None with one or two expressions."""

    shape: str
    arguments: tuple[Expression | Named, ...]
    place: str | None
    anchors: tuple[Expression, ...]
    condition: Expression | None


@record(kw_only=True)
class Connect(Relation):
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
class Equation(Relation):
    left: Expression
    right: Expression
    doc: str | None


@record(kw_only=True)
class CallEquation(Relation):
    """An expression standing as an equation: `assert(...)`, `reinit(...)`."""

    call: Expression
    doc: str | None


@record(kw_only=True)
class For(Block):
    iterators: tuple[Iterator, ...]
    body: tuple[Item, ...]


@record(kw_only=True)
class IfBranch(Node):
    condition: Expression
    body: tuple[Item, ...]


@record(kw_only=True)
class If(Block):
    branches: tuple[IfBranch, ...]
    otherwise: tuple[Item, ...] | None


@record(kw_only=True)
class WhenBranch(Node):
    condition: Expression
    body: tuple[Item, ...]


@record(kw_only=True)
class When(Block):
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
class Class(Definition):
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
class ShortClass(Definition):
    """`model S = Lib.Spring(k = 2);`."""

    prefixes: tuple[str, ...]
    kind: str
    name: str
    base: Name
    subscripts: tuple[Subscript, ...]
    modifiers: tuple[AnyModifier, ...]
    doc: str | None


@record(kw_only=True)
class TypeDefinition(Definition):
    """`type T = Real[3](unit = "m");` or, with `literals` and what their texts say, an enumeration (then `base` is
    None)."""

    name: str
    base: Name | None
    subscripts: tuple[Subscript, ...]
    modifiers: tuple[AnyModifier, ...]
    literals: tuple[str, ...]
    literal_docs: tuple[str | None, ...]
    doc: str | None


@record(kw_only=True)
class FunctionParameter(Node):
    type_name: Name
    name: str
    subscripts: tuple[Subscript, ...]
    default: Expression | None


@record(kw_only=True)
class Function(Definition):
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
    "| Gravity | PointMass | RigidBody | Load | Constraint | Contact | Friction | Invariant | Measure | Draw "
    "| Connect | Extends | Annotation | Equation | CallEquation | For | If | When"
)


@record(kw_only=True)
class Unit(Node):
    """A compilation unit: one file."""

    within: Name | None
    has_within: bool
    items: tuple[Item, ...]
