"""Everything that happens at instants during one run: found in a step, carried out at its time."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, field

import numpy as np

from lagdsl.flat.model import FlatModel
from lagdsl.mechanics.rank import Floats
from lagdsl.simulate.events.accumulation import Accumulation
from lagdsl.simulate.events.clocks import Clocks
from lagdsl.simulate.events.contacts import Contacts
from lagdsl.simulate.events.discretes import Discretes
from lagdsl.simulate.events.location import Look, first_change
from lagdsl.simulate.events.passes import AHEAD, Passes, Result
from lagdsl.simulate.events.time_events import TimeEvents
from lagdsl.simulate.projection import Projection
from lagdsl.simulate.right_hand_side import RightHandSide
from lagdsl.simulate.trajectory import Event

# Steps of a run in which something is to be located, at least.
LEAST_STEPS = 50


@dataclass(slots=True)
class Found:
    """What changes at a time: relations, contacts by their entry in `contacts`, clocks."""

    t: float
    relations: list[int] = field(default_factory=list)
    contacts: list[int] = field(default_factory=list)
    clocks: list[int] = field(default_factory=list)
    timed: bool = False


class Happenings:
    """Owns w, which is that of the system, between events."""

    def __init__(
        self, flat: FlatModel, system: RightHandSide, projection: Projection, span: tuple[float, float]
    ) -> None:
        self._discretes = Discretes(flat, system)
        self._system, self._span = system, span
        self.events: list[Event] = []
        self._accumulation = Accumulation()
        self.active = self._discretes.any
        self._locates = len(self._discretes.relations) + len(self._discretes.contacts) > 0
        self._time_events = TimeEvents(system, span)
        if self.active:
            self._contacts = Contacts(self._discretes, span[1] - span[0])
            self._passes = Passes(self._discretes, self._contacts, projection)
            self._clocks = Clocks(*self._discretes.clock(span[0]), span[0])

    # ---- the start and the end ---------------------------------------------------------------------------------------

    def begin(self, t: float, y: Floats) -> Result:
        """What holds at the start: relations as they stand, contacts that carry, then what is to be done there."""
        w = self._passes.settled(t, y, self._time_events.changed(t, self._discretes.started(t)))
        pierced = self._contacts.pierced(t, y, w)
        if pierced:
            return Result(y, w, failed=self._passes.blame("E0834", self._discretes.contacts[pierced].tolist()))
        w = self._contacts.settled(t, y, w)
        return self._carry_out(t, y, w, Found(t, clocks=self._clocks.ticking(t)), self._discretes.instant(initial=True))

    def end(self, t: float, y: Floats) -> Result:
        """`terminal()`."""
        return self._carry_out(t, y, self._system.w, Found(t), self._discretes.instant(initial=False))

    @property
    def ends(self) -> bool:
        return self._discretes.instant(initial=False) is not None

    # ---- on the way --------------------------------------------------------------------------------------------------

    @property
    def longest_step(self) -> float:
        """What is to be located must not be stepped over, however little the motion shows of it."""
        return (self._span[1] - self._span[0]) / LEAST_STEPS if self._locates else np.inf

    def next_tick(self) -> float:
        return min(self._clocks.next(), self._time_events.next) if self.active else np.inf

    def find(self, before: float, after: float, dense_output: Callable[[], Callable[[float], Floats]]) -> Found | None:
        """What happens first in a step, if anything does."""
        if not self._locates:
            return None
        dense = dense_output()
        self._passes.moment = AHEAD * (after - before)
        w, relations = self._system.w, len(self._discretes.relations)

        inside = self._contacts.inside(before, np.asarray(dense(before)), w)

        def look(t: float) -> Look:
            y = np.asarray(dense(t))
            indicators = self._discretes.indicators(t, y, w)
            turned = self._discretes.holds(indicators) != (w[self._discretes.relations] != 0.0)
            values, changed = self._contacts.look(t, y, w, inside)
            return Look(np.append(indicators, values), np.flatnonzero(np.append(turned, changed)).tolist())

        found = first_change(before, after, look)
        if found is None:
            return None
        t, indices = found
        return Found(t, [i for i in indices if i < relations], [i - relations for i in indices if i >= relations])

    def jumped(self, t: float, y: Floats) -> Found | None:
        """Relations that are other now that inputs have jumped at t."""
        if not self.active:
            return None
        w = self._system.w
        other = self._discretes.truths(t, y, w) != (w[self._discretes.relations] != 0.0)
        return Found(t, np.flatnonzero(other).tolist()) if other.any() else None

    def tick(self, t: float) -> Found | None:
        """The clocks that tick at t."""
        found = self._clocks.ticking(t) if self.active else []
        timed = self._time_events.next <= t
        return Found(t, clocks=found, timed=timed) if found or timed else None

    def carry_out(self, found: Found, y: Floats) -> Result:
        result = self._carry_out(found.t, y, self._system.w, found, None)
        if not found.clocks and not found.timed and self._accumulation.reached(found.t, bool(found.relations)):
            changed = [*self._discretes.relations[found.relations], *self._discretes.contacts[found.contacts]]
            result.failed = result.failed or self._passes.blame("E0833", [int(k) for k in changed])
        return result

    def _carry_out(self, t: float, y: Floats, w: Floats, found: Found, pulse: int | None) -> Result:
        w = w.copy()
        flipped = self._discretes.relations[found.relations]
        w[flipped] = 1.0 - w[flipped]
        w[self._discretes.clocks[found.clocks]] = 1.0
        before, w = w, self._time_events.changed(t, w) if found.timed else w
        self.events += self._triggers(found, w) + self._turned(t, before, w)
        if pulse is not None:
            w[pulse] = 1.0
        result = self._passes.run(t, y, w, found.relations, found.contacts)
        self.events += result.events
        self._time_events.seek(t, result.w)
        return result

    def _turned(self, t: float, before: Floats, after: Floats) -> list[Event]:
        """Relations and jumps of time alone."""
        timed = zip(self._discretes.flat.events.timed, self._time_events.entries.tolist(), strict=True)
        return [
            Event(time=t, name=each.name, kind="jump" if each.kind == "jump" else "true" if after[k] else "false")
            for each, k in timed
            if each.kind != "corner" and before[k] != after[k]
        ]

    def _triggers(self, found: Found, w: Floats) -> list[Event]:
        """What brings the event, where it is no contact; relations that follow from it are not told."""
        events = self._discretes.flat.events
        ticks = [Event(time=found.t, name=events.clocks[k].name, kind="tick") for k in found.clocks]
        truths = w[self._discretes.relations] != 0.0
        return ticks + [
            Event(time=found.t, name=events.relations[k].name, kind="true" if truths[k] else "false")
            for k in found.relations
        ]
