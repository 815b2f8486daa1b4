"""Passes over the `when` clauses at one instant, until nothing changes."""

from __future__ import annotations

from dataclasses import dataclass, field

import numpy as np

from lagdsl.flat.event_flow import branches
from lagdsl.flat.events import Check, Contact, Impact, Reset, Terminate, entries
from lagdsl.flat.quantity import Item
from lagdsl.mechanics.rank import Floats
from lagdsl.mechanics.structure_names import located
from lagdsl.simulate.events.contacts import ROUNDING, Contacts, size
from lagdsl.simulate.events.discretes import Discretes, Outcome
from lagdsl.simulate.projection import Projection
from lagdsl.simulate.trajectory import Event

MOST_PASSES = 100
# At an event relations are zero. They are looked at this part of the last step later, which is long against round-off
# and short against everything else. What passes zero within this part of that moment does so at the event.
AHEAD = 1e-4
_PASSING = 1e-3
# Positions off a constraint by this part of the natural size of its row are not those of the event's time.
_TORN = 1e-6


@dataclass(slots=True)
class Result:
    """The state after an event; `stop` is the message of `terminate`, `failed` what ends the run as an error."""

    y: Floats
    w: Floats
    events: list[Event] = field(default_factory=list)
    stop: str | None = None
    failed: tuple[str, Item, str] | None = None


class Passes:
    """Carries out what one instant brings."""

    def __init__(self, discretes: Discretes, contacts: Contacts, projection: Projection) -> None:
        self._discretes, self._contacts, self._projection = discretes, contacts, projection
        actions = [action for branch in branches(discretes.flat) for action in branch.actions]
        self._resets = [action for action in actions if isinstance(action, Reset)]
        self._impacts = [action for action in actions if isinstance(action, Impact)]
        self._stops = [action for action in actions if isinstance(action, Terminate)]
        self._checks = [action for action in actions if isinstance(action, Check)]
        coordinates = {item.name: index for index, item in enumerate(discretes.flat.coordinates)}
        states = {item.name: index for index, item in enumerate(discretes.flat.states)}
        n = len(coordinates)
        self.moment = 1e-9
        self._switched = list(discretes.system.engine.layout.instants.switched_rows)
        # what constraints may depend on
        self._shaping = np.concatenate([discretes.variables, discretes.relations])
        self._places = [n + coordinates[r.name] if r.rate else 2 * n + states[r.name] for r in self._resets]

    def settled(self, t: float, y: Floats, w: Floats) -> Floats:
        """w with relations and conditions as they stand, nothing carried out."""
        for _ in range(MOST_PASSES):
            after = w.copy()
            after[self._discretes.relations] = self._discretes.truths(t, y, w)
            after[self._discretes.conditions] = self._discretes.one_pass(t, y, after).w[self._discretes.conditions]
            if np.array_equal(after, w):
                break
            w = after
        return w

    def run(self, t: float, y: Floats, w: Floats, relations: list[int], contacts: list[int]) -> Result:
        """Until a pass changes nothing; `relations`, turned in w already, and `contacts` were found to change."""
        result = Result(y, w)
        self._change_contacts(t, result, contacts, turned=bool(relations))
        for _ in range(MOST_PASSES):
            before = result.w.copy()
            outcome = self._discretes.one_pass(t, result.y, result.w)
            result.w = outcome.w.copy()
            result.w[self._discretes.pulses] = 0.0
            acted = self._act(t, result, outcome)
            if not acted and not np.array_equal(result.w[self._shaping], before[self._shaping]):
                self._take_hold(t, result)
            acted |= self._strike(t, result, outcome)
            result.w[self._discretes.relations] = self._ahead(t, result, relations)
            if result.failed is not None or (not acted and np.array_equal(result.w, before)):
                break
        else:
            result.failed = self.blame("E0804", np.flatnonzero(before != result.w).tolist())
        self._discretes.system.with_discretes(result.w)
        result.failed = result.failed or self.torn(t, result.y)
        return result

    def torn(self, t: float, y: Floats) -> tuple[str, Item, str] | None:
        """A failure where a constraint that discretes switch asks for other positions than there are."""
        if not self._switched or not np.any(self._projection.distances(t, y)[self._switched] > _TORN):
            return None
        return self.tears(t, y)

    def tears(self, t: float, y: Floats) -> tuple[str, Item, str]:
        """The switched constraint that is farthest off."""
        row = self._switched[int(np.argmax(self._projection.distances(t, y)[self._switched]))]
        constraint = next(item.constraint for item in located(self._discretes.flat) if row in item.rows)
        return "E0835", constraint, f"`{self._discretes.system.engine.layout.constraints[row].name}`"

    # ---- contacts ----------------------------------------------------------------------------------------------------

    def _change_contacts(self, t: float, result: Result, contacts: list[int], *, turned: bool) -> None:
        """Those that pull open; the others strike."""
        entries = self._discretes.contacts
        meeting = [index for index in contacts if result.w[entries[index]] == 0.0]
        pulling = [index for index in contacts if index not in meeting]
        if turned and pulling:
            pulling = self._still_pulling(t, result, pulling)
        result.w[entries[pulling]] = 0.0
        result.events += [Event(time=t, name=self._name(index), kind="opened") for index in pulling]
        if (meeting or pulling) and not self._collide(t, result, {}):
            self._press(t, result, meeting)

    def _still_pulling(self, t: float, result: Result, contacts: list[int]) -> list[int]:
        """Those that pull a moment later: relations that turned with them may have taken the pull away."""
        force = self._discretes.multipliers(t + self.moment, self._later(t, result), result.w)
        return [index for index in contacts if force[index] < -self._contacts.slack[1]]

    def _press(self, t: float, result: Result, contacts: list[int]) -> None:
        """Contacts that meet without speed: closed as far as they push."""
        before = result.w
        result.w = self._contacts.pushing(t, result.y, before, contacts)
        closed = [index for index in contacts if result.w[self._discretes.contacts[index]] != 0.0]
        result.events += [Event(time=t, name=self._name(index), kind="closed") for index in closed]

    def _strike(self, t: float, result: Result, outcome: Outcome) -> bool:
        """Impacts of clauses, and contacts that something drives in now."""
        count = len(self._discretes.contacts)
        struck = {count + k: float(outcome.restitution[k]) for k in np.flatnonzero(outcome.impact).tolist()}
        return self._collide(t, result, struck) if struck or count else False

    def _collide(self, t: float, result: Result, struck: dict[int, float]) -> bool:
        result.y, result.w, happened = self._contacts.strike(t, result.y, result.w, struck)
        result.events += [Event(time=t, name=self._name(index), kind=what) for index, what in happened]
        if happened:
            self._project(t, result, ())
        return bool(struck) or bool(happened)

    def _name(self, index: int) -> str:
        return self._discretes.flat.events.contacts[index].name

    # ---- clauses -----------------------------------------------------------------------------------------------------

    def _act(self, t: float, result: Result, outcome: Outcome) -> bool:
        """Resets, ends and failures of one pass."""
        for k in np.flatnonzero(outcome.fail).tolist():
            result.failed = ("E0810", self._checks[k], self._checks[k].message)
        for k in np.flatnonzero(outcome.stop).tolist():
            result.stop = self._stops[k].message
            result.events.append(Event(time=t, name=self._stops[k].message, kind="terminate"))
        acting = np.flatnonzero(outcome.reset).tolist()
        held: dict[int, float] = {}
        for k in acting:
            place, value = self._places[k], float(outcome.value[k])
            if held.setdefault(place, value) != value:
                result.failed = ("E0832", self._resets[k], self._resets[k].name)
        if not acting:
            return False
        result.y = result.y.copy()
        for place, value in held.items():
            result.y[place] = value
        result.events += [Event(time=t, name=self._reset_name(k), kind="reinit") for k in acting]
        n = self._discretes.system.n
        self._pulled(t, result)
        self._project(t, result, tuple(place - n for place in held if place < 2 * n))
        return True

    def _pulled(self, t: float, result: Result) -> None:
        """Opens closed contacts that a reset moves apart."""
        before = result.w
        result.w = before.copy()
        self._contacts.apart(t, result.y, result.w)
        opened = np.flatnonzero(before[self._discretes.contacts] != result.w[self._discretes.contacts])
        result.events += [Event(time=t, name=self._name(index), kind="opened") for index in opened.tolist()]

    def _reset_name(self, k: int) -> str:
        return f"der({self._resets[k].name})" if self._resets[k].rate else self._resets[k].name

    def _take_hold(self, t: float, result: Result) -> None:
        """Discretes in constraints may have changed: rates onto what holds now; contacts follow, they only push."""
        opened = result.w.copy()
        opened[self._discretes.contacts] = 0.0
        self._discretes.system.with_discretes(opened)
        result.y = self._projection.onto_rates(t, result.y, ())

    def _project(self, t: float, result: Result, held: tuple[int, ...]) -> None:
        """Rates onto the constraints; those that were reset stay, as far as the constraints let them."""
        self._discretes.system.with_discretes(result.w)
        result.y = self._projection.onto_rates(t, result.y, held)

    # ---- relations ---------------------------------------------------------------------------------------------------

    def _later(self, t: float, result: Result) -> Floats:
        """The state a moment later, as w has it."""
        rate = self._discretes.system.with_discretes(result.w)(t, result.y)
        return result.y + self.moment * rate if np.all(np.isfinite(rate)) else result.y

    def _ahead(self, t: float, result: Result, turned: list[int]) -> Floats:
        """Relations as they stand; those that pass zero here are what they are a moment later, those that stay at zero
        what they have `turned` to."""
        discretes, y = self._discretes, result.y
        now = discretes.indicators(t, y, result.w)
        then = discretes.indicators(t + self.moment, self._later(t, result), result.w)
        passing = np.abs(now) <= _PASSING * np.abs(then - now)
        truths = discretes.holds(np.where(passing, then, now)).astype(np.float64)
        staying = [i for i in turned if not passing[i] and abs(now[i]) <= ROUNDING * size(y)]
        truths[staying] = result.w[discretes.relations[staying]]
        return truths

    def blame(self, code: str, indices: list[int]) -> tuple[str, Item, str]:
        """A failure of what changes, or of the clause that resets the same thing for ever."""
        known = entries(self._discretes.flat.events)
        changing = [known[k] for k in indices]
        items = [entry.item for entry in changing if entry.item is not None]
        place = items[0] if items else self._resets[0]
        names = [entry.item.name if isinstance(entry.item, Contact) else entry.name for entry in changing]
        return code, place, ", ".join(f"`{name}`" for name in dict.fromkeys(names)) or "rates"
