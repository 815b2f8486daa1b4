"""A state in the user's names."""

from __future__ import annotations

from lagdsl.derivation.program.program import Layout
from lagdsl.foundation.numerics.rank import Floats
from lagdsl.language.flat.display import display_rate, quantity_text
from lagdsl.language.flat.evaluate import Evaluator, NotEvaluable, Values
from lagdsl.language.flat.expression import Norm
from lagdsl.language.flat.model import FlatModel
from lagdsl.language.flat.quantity import Item
from lagdsl.language.flat.traversal import records

_ZERO_NORM = 1e-150


def time_text(t: float) -> str:
    """Six digits."""
    return f"{t:.6g}"


def component_name(flat: FlatModel, index: int) -> str:
    """Name of a component of x = (q, qd, z)."""
    n = len(flat.coordinates)
    if index < n:
        return flat.coordinates[index].name
    if index < 2 * n:
        return f"der({flat.coordinates[index - n].name})"
    return flat.states[index - 2 * n].name


def state_text(flat: FlatModel, x: Floats) -> str:
    """The first few coordinates and rates, in display units."""
    n = len(flat.coordinates)
    parts = []
    for index, c in list(enumerate(flat.coordinates))[:4]:
        rate = display_rate(c)
        parts.append(f"{c.name} = {quantity_text(float(x[index]), c)}")
        parts.append(f"der({c.name}) = {rate(float(x[n + index])):.4g} {rate.unit}")
    parts += [f"{s.name} = {quantity_text(float(x[2 * n + i]), s)}" for i, s in list(enumerate(flat.states))[:4]]
    return ", ".join(parts)


def state_values(flat: FlatModel, x: Floats) -> dict[str, float]:
    """The state by name, SI units."""
    return {component_name(flat, index): float(value) for index, value in enumerate(x)}


def evaluator_at(flat: FlatModel, layout: Layout, t: float, x: Floats, u: Floats, p: Floats) -> Evaluator:
    """Values of expressions at a state, for words."""
    n = len(flat.coordinates)
    names = [c.name for c in flat.coordinates]
    variables = dict(zip(names, x[:n].tolist(), strict=True))
    variables |= dict(zip([s.name for s in flat.states], x[2 * n :].tolist(), strict=True))
    variables |= dict(zip([i.name for i in flat.inputs], u.tolist(), strict=True))
    variables |= dict(zip([s.name for s in layout.parameters], p.tolist(), strict=True))
    moment = Values(variables={**variables, "time": t}, rates=dict(zip(names, x[n : 2 * n].tolist(), strict=True)))
    return Evaluator(flat, moment)


def zero_norm(flat: FlatModel, evaluator: Evaluator) -> tuple[Item, str] | None:
    """The first norm of the model that is zero at this state, with the item it stands in."""
    for item in (*flat.named, *flat.energies, *flat.loads, *flat.constraints):
        for norm in (part for part in records(item) if isinstance(part, Norm)):
            try:
                length = evaluator.scalar(norm)
            except NotEvaluable:
                continue
            if not length > _ZERO_NORM:
                return item, norm.element
    return None
