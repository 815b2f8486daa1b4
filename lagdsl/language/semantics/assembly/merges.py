"""Coordinates made one by `connect`."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import replace
from typing import TypeAlias

from lagdsl.foundation.diagnostics import Label
from lagdsl.foundation.numerics.disjoint_sets import DisjointSets
from lagdsl.foundation.source import Span
from lagdsl.foundation.units.dimension import DIMENSIONLESS
from lagdsl.language.flat import expression as flat
from lagdsl.language.flat.expression import FlatExpression
from lagdsl.language.flat.model import Alias, Coordinate
from lagdsl.language.flat.quantity import Variability
from lagdsl.language.semantics.scope.constants import NoValue, evaluate
from lagdsl.language.semantics.scope.context import Context
from lagdsl.language.semantics.scope.naming import element_name
from lagdsl.language.semantics.scope.scope import Indices, Symbol
from lagdsl.language.semantics.scope.values import Order, Scalar
from lagdsl.language.semantics.variables.resolver import every

Cell: TypeAlias = "tuple[Symbol, Indices]"


class Merges:
    """Merges elements of coordinates that are equal; `symbols` are those of the model in order."""

    def __init__(self, ctx: Context, symbols: Sequence[Symbol]) -> None:
        self._ctx = ctx
        self._symbols = [symbol for symbol in symbols if symbol.kind == "coordinate"]
        self._sets: DisjointSets[Cell] = DisjointSets()
        self._entered = False
        self._names: dict[str, str] = {}
        self.merged: dict[Symbol, None] = {}

    def _enter(self) -> None:
        """All coordinates in their order, once it is known that it matters."""
        if not self._entered:
            self._entered = True
            for symbol in self._symbols:
                for indices in every(self._ctx.resolver.shape(self._ctx, symbol) or ()):
                    self._sets.enter((symbol, indices))

    def unite(self, one: Symbol, first: Indices | None, two: Symbol, second: Indices | None, span: Span) -> bool | None:
        """Make coordinates one, whole (indices None) or by element; None after a diagnostic, False if they were."""
        self._enter()
        one.made.used = two.made.used = True
        if one.info is None or two.info is None or "unknown" in (one.kind, two.kind):
            return None
        shapes = [
            () if at is not None else self._ctx.resolver.shape(self._ctx, who)
            for who, at in ((one, first), (two, second))
        ]
        if shapes[0] is None or shapes[1] is None:
            return None
        here, there = Label(one.span, _title(one, shapes[0])), Label(two.span, _title(two, shapes[1]))
        fitting = one.info.dimension == two.info.dimension and one.info.unit == two.info.unit
        if not fitting or shapes[0] != shapes[1] or one.info.quaternion or two.info.quaternion:
            self._ctx.sink.report("E0711", span, here, there, first=one.name, second=two.name)
            return None
        joined = False
        for indices in every(shapes[0]):
            joined |= self._sets.join((one, first or indices), (two, second or indices))
        self.merged[one] = self.merged[two] = None
        return joined

    def settle(self) -> None:
        """Every merged coordinate is read under the name of the first."""
        for cells in self._sets.all():
            symbol, indices = cells[0]
            name = element_name(symbol.name, indices)
            dimension = symbol.info.dimension or DIMENSIONLESS if symbol.info is not None else DIMENSIONLESS
            value = Scalar(flat.Variable(name), dimension, Variability.CONTINUOUS, Order.CONFIGURATION)
            for other, at in cells[1:]:
                other.made.cells[at] = value
                self._names[element_name(other.name, at)] = name

    def name_of(self, name: str) -> str:
        """The name in the results."""
        return self._names.get(name, name)

    def listed(self, found: Sequence[Coordinate]) -> list[Coordinate]:
        """The coordinates of the model, each merged set as one with the starts and bounds of all."""
        kept: dict[str, Coordinate] = {}
        for item in found:
            name = self.name_of(item.name)
            kept[name] = self._both(kept[name], item) if name in kept else item
        return list(kept.values())

    def aliases(self, found: Sequence[Coordinate]) -> list[Alias]:
        """Names of merged coordinates that are not those of the results, in the order of the text."""
        return [
            Alias(spans=item.spans, name=item.name, of=own, doc=item.doc, protected=item.protected)
            for item in found
            if (own := self.name_of(item.name)) != item.name
        ]

    def _both(self, a: Coordinate, b: Coordinate) -> Coordinate:
        start = self._stronger(
            a, b, (a.start, a.start_explicit, a.fixed), (b.start, b.start_explicit, b.fixed), "start"
        )
        rate = self._stronger(
            a,
            b,
            (a.rate_start, a.rate_start_explicit, a.rate_fixed),
            (b.rate_start, b.rate_start_explicit, b.rate_fixed),
            "start rate",
        )
        return replace(
            a,
            start=b.start if start else a.start,
            start_explicit=a.start_explicit or b.start_explicit,
            fixed=a.fixed or b.fixed,
            start_span=b.start_span if start else a.start_span,
            rate_start=b.rate_start if rate else a.rate_start,
            rate_start_explicit=a.rate_start_explicit or b.rate_start_explicit,
            rate_fixed=a.rate_fixed or b.rate_fixed,
            rate_start_span=b.rate_start_span if rate else a.rate_start_span,
            nominal=a.nominal if a.nominal is not None else b.nominal,
            minimum=_extreme(max, a.minimum, b.minimum),
            maximum=_extreme(min, a.maximum, b.maximum),
        )

    def _stronger(
        self,
        a: Coordinate,
        b: Coordinate,
        one: tuple[FlatExpression, bool, bool],
        two: tuple[FlatExpression, bool, bool],
        what: str,
    ) -> bool:
        """True if the second start counts: a fixed one before a guess, a guess before none. Equals must agree."""
        if one[1] and two[1] and one[2] == two[2] and not _same(one[0], two[0]):
            spans = [item.start_span if what == "start" else item.rate_start_span for item in (a, b)]
            labels = [Label(spans[0], f"one {what}")] if spans[0] is not None else []
            code = "E0712" if one[2] else "W0713"
            self._ctx.sink.report(code, spans[1], *labels, first=a.name, second=b.name, what=what)
        return (two[2], two[1]) > (one[2], one[1])


def _same(one: FlatExpression, two: FlatExpression) -> bool:
    if one == two:
        return True
    try:
        return evaluate(one) == evaluate(two)
    except NoValue:
        return False


def _extreme(choose: Callable[[list[float]], float], one: float | None, two: float | None) -> float | None:
    known = [value for value in (one, two) if value is not None]
    return choose(known) if known else None


def _title(symbol: Symbol, shape: tuple[int, ...]) -> str:
    size = " by ".join(str(extent) for extent in shape)
    words = symbol.info.name if symbol.info is not None else "a coordinate"
    return words if not shape else f"{size} of {words}"
