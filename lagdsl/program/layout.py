"""The layout of a program from the flat model alone: names, units and places by index. One for both derivations."""

from __future__ import annotations

from collections.abc import Sequence

from lagdsl.flat.events import entries
from lagdsl.flat.model import FlatModel
from lagdsl.flat.quantity import Item, Quantity
from lagdsl.program.program import Layout, Slot
from lagdsl.units.naming import unit_text


def layout(flat: FlatModel) -> Layout:
    """No row is flagged redundant: that is found numerically, later."""
    independent = [p for p in flat.parameters if not p.structural]
    rows = [(row, constraint) for constraint in flat.constraints for row in constraint.rows]
    return Layout(
        coordinates=_slots(flat.coordinates),
        states=_slots(flat.states),
        inputs=_slots(flat.inputs),
        discretes=tuple(Slot(name=entry.name, place=_place(entry.item)) for entry in entries(flat.events)),
        kinds=tuple(entry.kind for entry in entries(flat.events)),
        parameters=_slots(independent),
        defaults=tuple(item.value for item in independent),
        outputs=_slots(flat.outputs),
        constraints=tuple(Slot(name=row, unit=unit_text(c.dimension), place=_place(c)) for row, c in rows),
        position_level=tuple(constraint.level == "position" for _, constraint in rows),
        redundant=(False,) * len(rows),
        invariants=tuple(Slot(name=i.name, unit=unit_text(i.dimension), place=_place(i)) for i in flat.invariants),
        assertions=tuple(assertion.message for assertion in flat.assertions),
    )


def _slots(items: Sequence[Quantity]) -> tuple[Slot, ...]:
    return tuple(Slot(name=item.name, unit=item.unit, place=_place(item)) for item in items)


def _place(item: Item | None) -> str | None:
    """File and line of the declaration."""
    if item is None or not item.spans:
        return None
    span = item.spans[0]
    return f"{span.file.name}:{span.first.line}"
