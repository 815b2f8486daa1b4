"""State of one run of the semantics, in parts by what writes them."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import field
from typing import Protocol, TypeAlias

from lagdsl.foundation.diagnostics import Sink
from lagdsl.foundation.record import mutable_record, record
from lagdsl.foundation.source import SourceFile, Span
from lagdsl.foundation.units import Dimension
from lagdsl.foundation.units.dimension import DIMENSIONLESS, TIME
from lagdsl.language.flat import model as flat_model
from lagdsl.language.semantics.scope.current import Current
from lagdsl.language.semantics.scope.product import Product
from lagdsl.language.semantics.scope.scope import Indices, Instance, Scope, Symbol
from lagdsl.language.semantics.scope.values import AnyDimension, ContactValue, FrictionValue, Value
from lagdsl.language.syntax import nodes


class Resolver(Protocol):
    """Gives symbols their values; made by the floor's upper half, used by the elaboration of expressions."""

    def shape(self, ctx: Context, symbol: Symbol) -> tuple[int, ...] | None: ...

    def whole(self, ctx: Context, symbol: Symbol, span: Span) -> Value: ...

    def part(self, ctx: Context, symbol: Symbol, chosen: Sequence[int | tuple[int, ...]], span: Span) -> Value: ...

    def element(self, ctx: Context, symbol: Symbol, indices: Indices, span: Span) -> Value: ...

    def constraint(self, ctx: Context, symbol: Symbol, indices: Indices) -> flat_model.Constraint | None: ...

    def contact(self, ctx: Context, symbol: Symbol, indices: Indices) -> ContactValue | None: ...

    def friction(self, ctx: Context, symbol: Symbol, indices: Indices, span: Span) -> FrictionValue | None: ...


Structural: TypeAlias = Callable[[flat_model.Parameter, Callable[[], Sequence[str]]], "float | None"]
"""The value of a structural parameter from outside, in SI units; None: that of the model. The second argument gives the
names of the parameter in all elements of the arrays of components around it."""


class Places(Protocol):
    """State of the kinematic assembly: frames, coordinates and components."""

    def frame(self, symbol: Symbol, indices: Indices) -> Value | None: ...

    def is_open(self, symbol: Symbol, indices: Indices) -> bool: ...

    def is_computed(self, symbol: Symbol) -> bool: ...

    def quantity(self, symbol: Symbol, indices: Indices) -> Value | None: ...

    def reaction(self, instance: Instance, span: Span) -> Value: ...


@mutable_record()
class Conventions:
    """Options that the caller and the class set for the whole model.

    `home` is the file of the model: advice is not given about texts of libraries. `units` is False under
    `annotation(units = "none")`. `structural` sets values from outside. `plain` are
    structural parameters that are elaborated as parameters. `unknowns` are coordinates whose starts are set from
    outside: they stay unknowns where their joint is cut.
    """

    home: SourceFile
    structural: Structural = lambda parameter, alike: None
    units: bool = True
    plain: frozenset[str] = frozenset()
    unknowns: frozenset[str] = frozenset()

    def dimension(self, dimension: Dimension) -> Dimension:
        """The dimension as the class counts: 1 for all without units."""
        return dimension if self.units else DIMENSIONLESS

    def rate(self, dimension: AnyDimension) -> AnyDimension:
        return dimension / self.dimension(TIME) if dimension is not None else None


@mutable_record()
class Counts:
    """Sizes of the expansion so far; `limits` has the bounds. `exceeded` are the bounds that were reported. `motions`
    are those whose forces are read."""

    turns: int = 0
    calls: int = 0
    components: int = 0
    coordinates: int = 0
    motions: int = 0
    exceeded: set[str] = field(default_factory=set)


@record()
class Written:
    """The text of a value of a declared quantity, the whole that it is an element of, the coherent unit of the
    quantity, and the number that stands there without a unit, or None."""

    node: nodes.Node
    whole: Span
    unit: str
    bare: float | None


@mutable_record()
class Reports:
    """State on which later reports depend.

    `reported` are keys of faults that are told once. `incomplete`: names may come from what is not supported yet, so
    unknown ones are not reported. `withheld` is an unknown name about which nothing was said, as something before must
    have been. `absent` has the places of names that a false condition leaves undeclared, by qualified name. `written`
    are the values that the text of the model writes as numbers, by where they begin.
    """

    reported: set[str] = field(default_factory=set)
    incomplete: bool = False
    withheld: Span | None = None
    absent: dict[str, Span] = field(default_factory=dict)
    written: dict[int, Written] = field(default_factory=dict)


@mutable_record()
class Splits:
    """Modifiers whose values are split over an array of components, and what the values are worth: by the scope in
    which a modifier stands, as every instance of a class has its own, and the identity of its node."""

    modifiers: list[tuple[nodes.Modifier, Indices, Scope]] = field(default_factory=list)
    values: dict[tuple[Scope, int], Value] = field(default_factory=dict)


@mutable_record()
class Context:
    """One flattening. `resolver` and `elaborate` lie above most of the modules that need them; `assembly` is there from
    the end of the kinematic assembly on."""

    sink: Sink
    resolver: Resolver
    elaborate: Callable[[Context, Scope, nodes.Expression, bool], Value]
    conventions: Conventions
    current: Current
    product: Product = field(default_factory=Product)
    counts: Counts = field(default_factory=Counts)
    reports: Reports = field(default_factory=Reports)
    splits: Splits = field(default_factory=Splits)
    assembly: Places | None = None

    @property
    def effects(self) -> int:
        """Count of what elaborations left behind beside their values: reports, discontinuities, turns, calls."""
        counts = self.counts
        done = counts.turns + counts.calls + counts.motions + counts.components
        return done + len(self.product.met) + self.sink.count + len(self.reports.reported)
