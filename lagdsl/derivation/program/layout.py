"""The layout of a program from the flat model alone: names, units and places by index. One for both derivations."""

from __future__ import annotations

from collections.abc import Sequence

from lagdsl.derivation.program.program import Instants, Layout, Slot
from lagdsl.foundation.units.dimension import TIME
from lagdsl.foundation.units.naming import unit_text
from lagdsl.language.flat.dependence import Dependence
from lagdsl.language.flat.event_flow import branches, reset_states
from lagdsl.language.flat.events import Check, Delay, Discrete, Entry, Reset, Terminate, entries
from lagdsl.language.flat.model import Constraint, FlatModel
from lagdsl.language.flat.quantity import Item, Quantity


def layout(flat: FlatModel) -> Layout:
    """No row is flagged redundant: that is found numerically, later."""
    independent = [p for p in flat.parameters if not p.structural]
    rows = [(row, constraint) for constraint in flat.constraints for row in constraint.rows]
    return Layout(
        coordinates=slots(flat.coordinates),
        states=slots(flat.states),
        inputs=slots(flat.inputs),
        discretes=tuple(_discrete(entry) for entry in entries(flat.events)),
        kinds=tuple(entry.kind for entry in entries(flat.events)),
        instants=_instants(flat, rows),
        parameters=slots(independent),
        defaults=tuple(item.value for item in independent),
        outputs=slots(flat.outputs),
        constraints=tuple(Slot(name=row, unit=unit_text(c.dimension), place=_place(c)) for row, c in rows),
        position_level=tuple(constraint.level == "position" for _, constraint in rows),
        redundant=(False,) * len(rows),
        invariants=tuple(Slot(name=i.name, unit=unit_text(i.dimension), place=_place(i)) for i in flat.invariants),
        assertions=tuple(assertion.message for assertion in flat.assertions),
        aliases=tuple((alias.name, alias.of) for alias in flat.aliases),
    )


def _discrete(entry: Entry) -> Slot:
    unit = entry.item.unit if isinstance(entry.item, Discrete) else "1"
    if isinstance(entry.item, Delay):
        unit = unit_text(entry.item.dimension if entry.kind == "delay" else entry.item.dimension / TIME)
    return Slot(name=entry.name, unit=unit, place=_place(entry.item))


def _instants(flat: FlatModel, rows: Sequence[tuple[str, Constraint]]) -> Instants:
    named = [name for name, _ in rows]
    whole = tuple(item.base != "Real" for item in flat.inputs)
    actions = [action for branch in branches(flat) for action in branch.actions]
    resets = [action for action in actions if isinstance(action, Reset)]
    places = {f"der({c.name})": len(flat.coordinates) + index for index, c in enumerate(flat.coordinates)}
    places |= {state.name: 2 * len(flat.coordinates) + index for index, state in enumerate(flat.states)}
    contacts = {contact.name: index for index, contact in enumerate(flat.events.contacts)}
    one_way = tuple(contact.one_way for contact in flat.events.contacts)
    names = tuple(f"der({reset.name})" if reset.rate else reset.name for reset in resets)
    return Instants(
        strict=tuple(relation.strict for relation in flat.events.relations),
        jumping=_jumping(flat),
        whole_inputs=whole if any(whole) else (),
        contact_rows=tuple(named.index(contact.name) for contact in flat.events.contacts),
        one_way=one_way if any(one_way) else (),
        frictions=tuple(each.name for each in flat.events.frictions),
        friction_rows=_friction_rows(flat, rows),
        friction_slips=tuple(len(each.slips) for each in flat.events.frictions),
        friction_contacts=tuple(
            len(contacts) if each.contact is None else contacts[each.contact] for each in flat.events.frictions
        ),
        switched_rows=_switched_rows(flat, rows),
        resets=names,
        reset_places=tuple(places[name] for name in names),
        stops=tuple(action.message for action in actions if isinstance(action, Terminate)),
        failures=tuple(action.message for action in actions if isinstance(action, Check)),
    )


def _jumping(flat: FlatModel) -> tuple[bool, ...]:
    """Relations that energies, masses or rows of constraints read, and those that such relations read."""
    dependence = Dependence(flat)
    lasting = [x for each in flat.constraints if not (each.contact or each.friction) for x in each.residuals]
    read = dependence.of_mechanism().merged(dependence.of_all(lasting)) if flat.events.relations else ()
    found = set(read)
    unread = list(flat.events.relations)
    while inner := [each for each in unread if each.name in found]:
        unread = [each for each in unread if each.name not in found]
        found.update(dependence.of_all(each.difference for each in inner))
    return tuple(each.name in found for each in flat.events.relations)


def _friction_rows(flat: FlatModel, rows: Sequence[tuple[str, Constraint]]) -> tuple[int, ...]:
    """In the order of the frictions, which need not be that of the constraints."""
    held: dict[str, list[int]] = {}
    for index, (_, constraint) in enumerate(rows):
        if constraint.friction:
            held.setdefault(constraint.name, []).append(index)
    return tuple(index for each in flat.events.frictions for index in held[each.name])


def _switched_rows(flat: FlatModel, rows: Sequence[tuple[str, Constraint]]) -> tuple[int, ...]:
    """Rows on positions that discretes switch or move, or states that clauses set."""
    states = reset_states(flat)
    dependence = Dependence(flat)

    def is_switched(each: Constraint) -> bool:
        if each.contact or each.level != "position":
            return False
        return each.switched or bool(states and not states.isdisjoint(dependence.of_all(each.residuals)))

    return tuple(i for i, (_, constraint) in enumerate(rows) if is_switched(constraint))


def slots(items: Sequence[Quantity]) -> tuple[Slot, ...]:
    """Names, units and places of declared things."""
    return tuple(Slot(name=item.name, unit=item.unit, place=_place(item)) for item in items)


def _place(item: Item | None) -> str | None:
    """File and line of the declaration."""
    if item is None or not item.spans:
        return None
    span = item.spans[0]
    return f"{span.file.name}:{span.first.line}"
