"""Entries of the discretes for the guards of a model, each with a name of its own."""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from dataclasses import replace
from typing import Literal

from lagdsl.language.flat import expression as fx
from lagdsl.language.flat.events import Events, Relation, Timed
from lagdsl.language.flat.expression import FlatExpression
from lagdsl.language.semantics.operators.pieces import chosen, chosen_by_number
from lagdsl.language.semantics.scope.occurrences import entered
from lagdsl.language.semantics.scope.product import Met


class Entries:
    """Collected in the order in which they are met; the same one again has the same name."""

    def __init__(self) -> None:
        self._known: dict[str, Relation | Timed] = {}

    def added(self, events: Events) -> Events:
        """`events` with these."""
        known = self._known.values()
        relations = tuple(each for each in known if isinstance(each, Relation))
        return replace(events, relations=relations, timed=tuple(each for each in known if isinstance(each, Timed)))

    def relation(self, met: Met, text: str, difference: FlatExpression, *, strict: bool) -> fx.Variable:
        """The truth of `difference > 0` or, where it is not `strict`, of `difference >= 0`."""

        def make(name: str) -> Relation:
            return Relation(spans=met.spans, name=name, difference=difference, dimension=met.dimension, strict=strict)

        return fx.Variable(entered(self._known, text, make))

    def timed_truth(self, met: Met, text: str, difference: FlatExpression, *, strict: bool, told: bool) -> fx.Variable:
        """The same of time alone. Not `told`: a value has a corner there and no jump."""
        kind: Literal["relation", "corner"] = "relation" if told else "corner"

        def distances(entry: fx.Variable) -> tuple[FlatExpression, ...]:
            return (fx.Conditional(entry, difference, fx.Unary("-", difference)),)

        stands = fx.Binary(">" if strict else ">=", difference, fx.ZERO)
        return self._timed(met, text, kind, stands, distances)

    def whole(self, met: Met, text: str, x: FlatExpression) -> fx.Variable:
        """floor(x) of time alone."""

        def distances(entry: fx.Variable) -> tuple[FlatExpression, ...]:
            beyond = fx.Binary("-", x, entry)
            return beyond, fx.Binary("-", fx.ONE, beyond)

        return self._timed(met, text, "jump", fx.Function("floor", (x,)), distances)

    def piece(self, met: Met, text: str, x: FlatExpression, borders: Sequence[float]) -> fx.Variable:
        """The number of the interval between `borders` in which x, of time alone, is: k from borders[k - 1] on, up to
        borders[k]."""
        ends = [fx.Number(border) for border in borders]

        def distances(entry: fx.Variable) -> tuple[FlatExpression, ...]:
            below = chosen_by_number(entry, [fx.Number(-math.inf), *ends])
            above = chosen_by_number(entry, [*ends, fx.Number(math.inf)])
            return fx.Binary("-", x, below), fx.Binary("-", above, x)

        stands = chosen(x, borders, [fx.Number(float(k)) for k in range(len(borders) + 1)])
        return self._timed(met, text, "corner", stands, distances)

    def _timed(
        self,
        met: Met,
        text: str,
        kind: Literal["relation", "jump", "corner"],
        stands: FlatExpression,
        distances: Callable[[fx.Variable], tuple[FlatExpression, ...]],
    ) -> fx.Variable:
        def make(name: str) -> Timed:
            away = distances(fx.Variable(name))
            return Timed(spans=met.spans, name=name, kind=kind, value=stands, distances=away)

        return fx.Variable(entered(self._known, text, make))
