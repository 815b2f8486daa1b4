"""Entries of the discretes for the guards of a model, each with a name of its own."""

from __future__ import annotations

from collections.abc import Callable, Sequence

from lagdsl.flat import expression as fx
from lagdsl.flat.events import Relation, Timed
from lagdsl.flat.expression import FlatExpression
from lagdsl.semantics.operators.pieces import chosen, chosen_by_number
from lagdsl.semantics.scope.occurrences import names
from lagdsl.semantics.scope.product import Met


class Entries:
    """Collected in the order in which they are met; the same one again has the same name."""

    def __init__(self) -> None:
        self._relations: dict[str, Relation] = {}
        self._timed: dict[str, tuple[FlatExpression, Timed]] = {}

    @property
    def relations(self) -> tuple[Relation, ...]:
        return tuple(self._relations.values())

    @property
    def timed(self) -> tuple[Timed, ...]:
        return tuple(timed for _, timed in self._timed.values())

    def relation(self, met: Met, text: str, difference: FlatExpression, *, strict: bool) -> fx.Variable:
        """The truth of `difference > 0` or, where it is not `strict`, of `difference >= 0`."""
        for name in names(text):
            if name in self._timed:
                continue
            known = self._relations.get(name)
            if known is None:
                self._relations[name] = Relation(
                    spans=met.spans, name=name, difference=difference, dimension=met.dimension, strict=strict
                )
                return fx.Variable(name)
            if known.strict == strict and known.difference == difference:
                return fx.Variable(name)
        raise AssertionError("there is always one more name")

    def timed_truth(self, met: Met, text: str, difference: FlatExpression, *, strict: bool, told: bool) -> fx.Variable:
        """The same of time alone. Not `told`: a value has a corner there and no jump."""
        stands = fx.Binary(">" if strict else ">=", difference, fx.ZERO)

        def make(name: str) -> Timed:
            distance = fx.Conditional(fx.Variable(name), difference, fx.Unary("-", difference))
            return Timed(
                spans=met.spans,
                name=name,
                kind="relation" if told else "corner",
                value=stands,
                distances=(distance,),
                changes=(0,),
            )

        return self._timed_entry(text, stands, make)

    def whole(self, met: Met, text: str, x: FlatExpression) -> fx.Variable:
        """floor(x) of time alone."""
        stands = fx.Function("floor", (x,))

        def make(name: str) -> Timed:
            beyond = fx.Binary("-", x, fx.Variable(name))
            return Timed(
                spans=met.spans,
                name=name,
                kind="jump",
                value=stands,
                distances=(beyond, fx.Binary("-", fx.ONE, beyond)),
                changes=(-1, 1),
            )

        return self._timed_entry(text, stands, make)

    def piece(self, met: Met, text: str, x: FlatExpression, borders: Sequence[float]) -> fx.Variable:
        """The number of the interval between `borders` in which x, of time alone, is: k from borders[k - 1] on, up to
        borders[k]."""
        stands = chosen(x, borders, [fx.Number(float(k)) for k in range(len(borders) + 1)])

        def make(name: str) -> Timed:
            ends = [fx.Number(border) for border in borders]
            below = chosen_by_number(fx.Variable(name), [fx.Number(-float("inf")), *ends])
            above = chosen_by_number(fx.Variable(name), [*ends, fx.Number(float("inf"))])
            return Timed(
                spans=met.spans,
                name=name,
                kind="corner",
                value=stands,
                distances=(fx.Binary("-", x, below), fx.Binary("-", above, x)),
                changes=(-1, 1),
            )

        return self._timed_entry(text, stands, make)

    def _timed_entry(self, text: str, what: FlatExpression, make: Callable[[str], Timed]) -> fx.Variable:
        for name in names(text):
            if name in self._relations:
                continue
            known = self._timed.get(name)
            if known is None:
                self._timed[name] = (what, make(name))
                return fx.Variable(name)
            if known[0] == what:
                return fx.Variable(name)
        raise AssertionError("there is always one more name")
