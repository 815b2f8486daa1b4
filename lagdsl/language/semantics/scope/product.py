"""Elements of the flat model, collected in the order in which they are complete."""

from __future__ import annotations

from collections import Counter
from dataclasses import field

from lagdsl.foundation.record import mutable_record, record
from lagdsl.foundation.units import Dimension
from lagdsl.language.flat import model as flat_model
from lagdsl.language.flat.expression import FlatExpression
from lagdsl.language.flat.quantity import Spans
from lagdsl.language.semantics.scope.occurrences import Occurrences
from lagdsl.language.semantics.scope.values import Order


@record()
class Pieces:
    """`values[k]` from `borders[k - 1]` on, up to `borders[k]`. Not `sharp`: the slope is continuous there."""

    x: FlatExpression
    borders: tuple[float, ...]
    values: tuple[FlatExpression, ...]
    sharp: bool


@record(kw_only=True)
class Met:
    """A discontinuity as it stands in the text: a relation, `abs`, `floor`, `sign`, a table between values that move.

    `expression` is its node in the flat model, which the pass knows by identity, `text` the name of the guard,
    `function` what the text calls ("" of relations), `order` that of the operands. Not `located`: in `noEvent`, or the
    cut of `atan2`. A table has `pieces`; every other function shows its operands itself. It `moves` between events, or
    only clauses may meet it.
    """

    expression: FlatExpression
    function: str
    text: str
    spans: Spans
    dimension: Dimension
    order: Order
    located: bool = True
    pieces: Pieces | None = None
    moves: bool = True


@mutable_record()
class Product:
    """`named` is sorted by its order of completion: what a definition uses was complete before it.

    `forces` are those of compliant contacts and of friction. `solved` are the loads that depend on the motion that
    they cause, each with the dimension of its value. `met` are the discontinuities, operands before what reads them.
    `names` are taken; `unlabelled` counts the constraints, contacts and frictions that get a number for a name.
    """

    parameters: list[flat_model.Parameter] = field(default_factory=list)
    named: list[flat_model.Named] = field(default_factory=list)
    observed: list[flat_model.Definition] = field(default_factory=list)
    constraints: list[flat_model.Constraint] = field(default_factory=list)
    forces: list[flat_model.GeneralizedForce | flat_model.RateForce] = field(default_factory=list)
    solved: list[tuple[flat_model.Load, Dimension]] = field(default_factory=list)
    occurrences: Occurrences = field(default_factory=Occurrences)
    met: list[Met] = field(default_factory=list)
    names: set[str] = field(default_factory=set)
    unlabelled: Counter[str] = field(default_factory=Counter)

    def number(self, what: str) -> str:
        """The name of the next `what` without a label: `contact_2`."""
        self.unlabelled[what] += 1
        return f"{what}_{self.unlabelled[what]}"

    def unique(self, name: str) -> str:
        """A name for something the user did not name."""
        count = 1
        while f"{name}_{count}" in self.names:
            count += 1
        self.names.add(f"{name}_{count}")
        return f"{name}_{count}"
