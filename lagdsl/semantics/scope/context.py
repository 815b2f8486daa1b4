"""What one run of the semantics shares: the sink, the flat elements made so far, the conventions of the class."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping, Sequence
from contextlib import contextmanager
from dataclasses import field
from typing import Protocol

from lagdsl.diagnostics import Sink
from lagdsl.flat import model as flat_model
from lagdsl.flat.expression import FlatExpression
from lagdsl.flat.quantity import Spans
from lagdsl.record import mutable_record, record
from lagdsl.semantics.scope.occurrences import Mode, Occurrences
from lagdsl.semantics.scope.scope import Indices, Instance, Scope, Symbol
from lagdsl.semantics.scope.values import AnyDimension, ContactValue, Order, Value
from lagdsl.source import SourceFile, Span
from lagdsl.syntax import nodes
from lagdsl.units import Dimension
from lagdsl.units.dimension import DIMENSIONLESS, TIME


@record()
class Met:
    """An expression with a corner where `distance` passes zero; not `sharp`: its slope is continuous there."""

    expression: FlatExpression
    distance: FlatExpression
    spans: Spans
    order: Order
    sharp: bool


class Resolver(Protocol):
    """Gives symbols their values; made by the floor's upper half, used by the elaboration of expressions."""

    def shape(self, symbol: Symbol) -> tuple[int, ...] | None: ...

    def whole(self, symbol: Symbol, span: Span) -> Value: ...

    def part(self, symbol: Symbol, chosen: Sequence[int | tuple[int, ...]], span: Span) -> Value: ...

    def element(self, symbol: Symbol, indices: Indices, span: Span) -> Value: ...

    def constraint(self, symbol: Symbol, indices: Indices) -> flat_model.Constraint | None: ...

    def contact(self, symbol: Symbol, indices: Indices) -> ContactValue | None: ...


class Places(Protocol):
    """What the kinematic assembly knows of frames, coordinates and components."""

    def frame(self, symbol: Symbol, indices: Indices) -> Value | None: ...

    def is_open(self, symbol: Symbol, indices: Indices) -> bool: ...

    def is_computed(self, symbol: Symbol) -> bool: ...

    def quantity(self, symbol: Symbol, indices: Indices) -> Value | None: ...

    def reaction(self, instance: Instance, span: Span) -> Value: ...


@mutable_record()
class Context:
    """Mutable state of one flattening; every product is collected here in the order in which it is complete.

    `home` is the file of the model: advice is not given about texts of libraries.
    `splits` are modifiers whose values are split over an array of components, `split_values` what they are worth: by
    the scope in which they stand, as every instance of a class has its own, and the identity of their node.
    `corners` are what has one along the motion.
    `incomplete`: names may come from what is not supported yet, so unknown ones are not reported.
    `withheld` is an unknown name about which nothing was said, as something before must have been.
    `named` is therefore sorted: what a definition uses was complete before it.
    """

    sink: Sink
    resolver: Resolver
    elaborate: Callable[[Context, Scope, nodes.Expression, bool], Value]
    home: SourceFile | None = None
    units: bool = True
    overrides: Mapping[str, float] = field(default_factory=dict)
    parameters: list[flat_model.Parameter] = field(default_factory=list)
    named: list[flat_model.Named] = field(default_factory=list)
    observed: list[flat_model.Definition] = field(default_factory=list)
    constraints: list[flat_model.Constraint] = field(default_factory=list)
    names: set[str] = field(default_factory=set)
    active: list[tuple[Symbol, Indices | None]] = field(default_factory=list)
    scopes: list[Scope] = field(default_factory=list)
    splits: list[tuple[nodes.Modifier, Indices, Scope]] = field(default_factory=list)
    split_values: dict[tuple[Scope, int], Value] = field(default_factory=dict)
    jump: nodes.Call | None = None
    corners: list[Met] = field(default_factory=list)
    quiet: bool = False
    mode: Mode = Mode.ALWAYS
    occurrences: Occurrences = field(default_factory=Occurrences)
    unlabelled: int = 0
    unlabelled_contacts: int = 0
    incomplete: bool = False
    functions: list[nodes.Function] = field(default_factory=list)
    turns: int = 0
    calls: int = 0
    components: int = 0
    exceeded: set[str] = field(default_factory=set)
    reported: set[str] = field(default_factory=set)
    withheld: Span | None = None
    assembly: Places | None = None

    def dimension(self, dimension: Dimension) -> Dimension:
        """The dimension as the class counts: 1 for all under `annotation(units = "none")`."""
        return dimension if self.units else DIMENSIONLESS

    def rate(self, dimension: AnyDimension) -> AnyDimension:
        return dimension / self.dimension(TIME) if dimension is not None else None

    @contextmanager
    def inside(self, scope: Scope) -> Iterator[None]:
        """What is reported meanwhile about the text of a class belongs to this instance of it."""
        self.scopes.append(scope)
        try:
            yield
        finally:
            self.scopes.pop()

    @contextmanager
    def without_relations(self) -> Iterator[None]:
        """Relations inside are taken as they stand, not located as events."""
        before, self.quiet = self.quiet, True
        try:
            yield
        finally:
            self.quiet = before

    @contextmanager
    def standing(self, mode: Mode) -> Iterator[None]:
        """What is elaborated meanwhile stands there: a definition, which holds always, a `when` or its condition."""
        before, self.quiet, self.mode = (self.quiet, self.mode), False, mode
        try:
            yield
        finally:
            self.quiet, self.mode = before

    def unique(self, name: str) -> str:
        """A name for something the user did not name."""
        count = 1
        while f"{name}_{count}" in self.names:
            count += 1
        self.names.add(f"{name}_{count}")
        return f"{name}_{count}"
