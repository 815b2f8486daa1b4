"""Names, units and places of the arrays of a program."""

from __future__ import annotations

from collections.abc import Sequence

from lagdsl.program.program import Layout, Slot
from lagdsl.semantics.flat_model import FlatModel, Item, Quantity


def layout(flat: FlatModel) -> Layout:
    """In the order of the flat model; no row is known to be redundant yet."""
    independent = [parameter for parameter in flat.parameters if not parameter.structural]
    rows = [(constraint, row) for constraint in flat.constraints for row in constraint.rows]
    return Layout(
        coordinates=_slots(flat.coordinates),
        states=_slots(flat.states),
        inputs=_slots(flat.inputs),
        discretes=(),
        parameters=_slots(independent),
        defaults=tuple(parameter.value for parameter in independent),
        outputs=_slots(flat.outputs),
        constraints=tuple(Slot(name=row, place=_place(constraint)) for constraint, row in rows),
        position_level=tuple(constraint.level == "position" for constraint, _ in rows),
        redundant=(False,) * len(rows),
        invariants=tuple(Slot(name=item.name, place=_place(item)) for item in flat.invariants),
        assertions=tuple(item.message for item in flat.assertions),
    )


def _slots(items: Sequence[Quantity]) -> tuple[Slot, ...]:
    return tuple(Slot(name=item.name, unit=item.unit, place=_place(item)) for item in items)


def _place(item: Item) -> str | None:
    if not item.spans:
        return None
    span = item.spans[0]
    return f"{span.file.name}:{span.first.line}"
