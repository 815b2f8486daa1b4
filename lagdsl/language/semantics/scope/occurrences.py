"""Sources of events of a model, in order of occurrence: clauses, force laws, clocks, the start and the end."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from dataclasses import field
from itertools import count
from typing import TypeVar

from lagdsl.foundation.record import mutable_record
from lagdsl.foundation.units import Dimension
from lagdsl.foundation.units.dimension import DIMENSIONLESS
from lagdsl.language.flat.events import (
    INITIAL,
    TERMINAL,
    Clock,
    Contact,
    Delay,
    Discrete,
    Events,
    Feedback,
    Friction,
    Limit,
    Memory,
    When,
)
from lagdsl.language.flat.expression import FlatExpression, Variable
from lagdsl.language.flat.quantity import Spans
from lagdsl.language.semantics.scope.scope import Indices, Scope, Symbol
from lagdsl.language.semantics.scope.values import Scalar
from lagdsl.language.syntax.nodes import Expression

# Names are the text, as far as this.
_LONGEST = 80

Entry = TypeVar("Entry")


@mutable_record()
class ForceLaws:
    """Laws that set in and cease at events; the values in loads that depend on the motion that they cause, by name."""

    contacts: list[Contact] = field(default_factory=list)
    frictions: list[Friction] = field(default_factory=list)
    feedbacks: dict[str, Feedback] = field(default_factory=dict)

    def feedback(self, text: str, spans: Spans, value: FlatExpression, dimension: Dimension) -> Variable:
        """The entry in place of a value in a load that depends on the motion that it causes."""
        name = next(name for name in _names(text) if name not in self.feedbacks)
        self.feedbacks[name] = Feedback(spans=spans, name=name, value=value, dimension=dimension)
        return Variable(name)


@mutable_record()
class Occurrences:
    """Collected in the order in which they are met, which is that of the text as far as nothing is needed earlier.

    `assumed` are variables that are delayed before they have values, with the dimensions that they are taken to
    have.
    """

    discretes: list[Discrete] = field(default_factory=list)
    laws: ForceLaws = field(default_factory=ForceLaws)
    whens: list[When] = field(default_factory=list)
    clocks: dict[str, Clock] = field(default_factory=dict)
    delays: dict[str, Delay] = field(default_factory=dict)
    assumed: list[tuple[Expression, Scope, Symbol, Indices, Dimension]] = field(default_factory=list)
    instants: set[str] = field(default_factory=set)
    limits: list[Limit] = field(default_factory=list)
    memories: dict[str, Memory] = field(default_factory=dict)
    conditions: int = 0

    def clock(self, text: str, spans: Spans, start: FlatExpression, period: FlatExpression) -> str:
        """The name of the clock; the same one again ticks at the same instants."""
        return entered(self.clocks, text, lambda name: Clock(spans=spans, name=name, start=start, period=period))

    def delay(self, text: str, spans: Spans, value: Scalar, time: FlatExpression) -> Variable:
        """The entry of a delayed value; the same one again is the same entry."""
        dimension = value.dimension or DIMENSIONLESS

        def make(name: str) -> Delay:
            return Delay(spans=spans, name=name, value=value.expression, time=time, dimension=dimension)

        return Variable(entered(self.delays, text, make))

    def condition(self, text: str) -> str:
        """A name for what a condition of a clause was before."""
        self.conditions += 1
        return f"when {text} ({self.conditions})"

    def memory(self, text: str, spans: Spans, value: FlatExpression, *, truth: bool) -> str:
        """The name of what a value that no clause assigns was before; the same value again has the same name."""
        return entered(
            self.memories, f"value {text}", lambda name: Memory(spans=spans, name=name, value=value, truth=truth)
        )

    def events(self) -> Events:
        return Events(
            discretes=tuple(self.discretes),
            contacts=tuple(self.laws.contacts),
            frictions=tuple(self.laws.frictions),
            feedbacks=tuple(self.laws.feedbacks.values()),
            delays=tuple(self.delays.values()),
            whens=tuple(self.whens),
            memories=tuple(self.memories.values()),
            clocks=tuple(self.clocks.values()),
            instants=tuple(name for name in (INITIAL, TERMINAL) if name in self.instants),
            limits=tuple(self.limits),
        )


def _names(text: str) -> Iterator[str]:
    """The text on one line, then the same with numbers."""
    plain = " ".join(text.split())
    plain = plain if len(plain) <= _LONGEST else f"{plain[: _LONGEST - 2]} …"
    yield plain
    for number in count(2):
        yield f"{plain} ({number})"


def entered(known: dict[str, Entry], text: str, make: Callable[[str], Entry]) -> str:
    """The name of what `make` gives, now among those that are `known`; the same one again has the same name."""
    return next(name for name in _names(text) if known.setdefault(name, own := make(name)) == own)
