"""Why the motion cannot go on, told in the user's names."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import fields, is_dataclass

import numpy as np

from lagdsl.diagnostics import Label, Sink
from lagdsl.flat.evaluate import Evaluator, NotEvaluable, Values
from lagdsl.flat.expression import Norm
from lagdsl.flat.model import FlatModel
from lagdsl.flat.quantity import Item
from lagdsl.mechanics.rank import Floats
from lagdsl.mechanics.structure_display import display_rate, quantity_text
from lagdsl.simulate.right_hand_side import RightHandSide, Trouble

_ZERO_NORM = 1e-150


def time_text(t: float) -> str:
    """Six digits."""
    return f"{t:.6g}"


def component_name(flat: FlatModel, index: int) -> str:
    """Name of a component of y = (q, qd, z)."""
    n = len(flat.coordinates)
    if index < n:
        return flat.coordinates[index].name
    if index < 2 * n:
        return f"der({flat.coordinates[index - n].name})"
    return flat.states[index - 2 * n].name


def report_trouble(flat: FlatModel, system: RightHandSide, trouble: Trouble, sink: Sink) -> str:
    """E0806, E0813 or E0808: at this state there are no accelerations. Returns the name at fault."""
    if trouble.singular is not None:
        coordinate = flat.coordinates[trouble.singular]
        span = coordinate.spans[0] if coordinate.spans else None
        notes = (f"state: {state_text(flat, trouble.y)}",)
        sink.report("E0806", span, notes=notes, time=time_text(trouble.t), name=coordinate.name)
        return coordinate.name
    norm = zero_norm(flat, system, trouble.t, trouble.y)
    if norm is not None:
        item, element = norm
        span = item.spans[0] if item.spans else None
        sink.report("E0813", span, time=time_text(trouble.t), element=element)
        return element
    n = len(flat.coordinates)
    wrong = np.flatnonzero(~np.isfinite(trouble.derivative))
    index = int(wrong[0]) if len(wrong) else 0
    name = f"der({component_name(flat, index)})"
    owner = flat.coordinates[index % n] if index < 2 * n else flat.states[index - 2 * n]
    label = Label(owner.spans[0], "its acceleration" if index < 2 * n else "its derivative") if owner.spans else None
    notes = (f"state: {state_text(flat, trouble.y)}",)
    sink.report("E0808", label, notes=notes, time=time_text(trouble.t), name=name)
    return name


def state_text(flat: FlatModel, y: Floats) -> str:
    """The first few coordinates and rates, in display units."""
    n = len(flat.coordinates)
    parts = []
    for index, c in list(enumerate(flat.coordinates))[:4]:
        rate = display_rate(c)
        parts.append(f"{c.name} = {quantity_text(float(y[index]), c)}")
        parts.append(f"der({c.name}) = {rate(float(y[n + index])):.4g} {rate.unit}")
    parts += [f"{s.name} = {quantity_text(float(y[2 * n + i]), s)}" for i, s in list(enumerate(flat.states))[:4]]
    return ", ".join(parts)


def state_values(flat: FlatModel, y: Floats) -> dict[str, float]:
    """The state by name, SI units."""
    return {component_name(flat, index): float(value) for index, value in enumerate(y)}


def zero_norm(flat: FlatModel, system: RightHandSide, t: float, y: Floats) -> tuple[Item, str] | None:
    """The first norm of the model that is zero at this state, with the item it stands in."""
    q, qd, z = system.split(y)
    names = [c.name for c in flat.coordinates]
    variables = dict(zip(names, q.tolist(), strict=True))
    variables |= dict(zip([s.name for s in flat.states], z.tolist(), strict=True))
    variables |= dict(zip([i.name for i in flat.inputs], system.inputs(t).tolist(), strict=True))
    variables |= dict(zip([s.name for s in system.engine.layout.parameters], system.p.tolist(), strict=True))
    moment = Values(variables={**variables, "time": t}, rates=dict(zip(names, qd.tolist(), strict=True)))
    evaluator = Evaluator(flat, moment)
    for item in (*flat.named, *flat.energies, *flat.loads, *flat.constraints):
        for norm in norms(item):
            try:
                length = evaluator.scalar(norm)
            except NotEvaluable:
                continue
            if not length > _ZERO_NORM:
                return item, norm.element
    return None


def norms(node: object) -> Iterator[Norm]:
    """All norms inside an item or expression, in the order of its fields."""
    if isinstance(node, Norm):
        yield node
    if isinstance(node, tuple):
        for entry in node:
            yield from norms(entry)
    elif is_dataclass(node):
        for field in fields(node):
            if field.name != "spans" and not field.name.endswith("_span"):
                yield from norms(getattr(node, field.name))
