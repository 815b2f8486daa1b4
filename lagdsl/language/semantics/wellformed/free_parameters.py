"""Parameters that are found with the start, and what decides them (E0349, E0350, W0353)."""

from __future__ import annotations

from lagdsl.foundation.diagnostics import Sink
from lagdsl.language.flat import expression as fx
from lagdsl.language.flat import model as fm
from lagdsl.language.flat.spans import place
from lagdsl.language.flat.traversal import postorder


def check_free_parameters(model: fm.FlatModel, sink: Sink) -> None:
    """E0349 for fewer initial equations than free parameters, E0350 for a fixed start that moves with one,
    W0353 for another one."""
    free = [parameter for parameter in model.parameters if parameter.free]
    if not free:
        return
    count = len(model.initial_equations)
    if count < len(free):
        equations = f"{count} initial equation{'' if count == 1 else 's'}" if count else "no initial equation"
        sink.report("E0349", place(free[-1]), free=_counted(free), equations=equations)
    moved = {parameter.name for parameter in free}
    for item in model.named:
        if isinstance(item, fm.Definition) and _uses(item.value, moved):
            moved.add(item.name)
    for coordinate in model.coordinates:
        for fixed, start, name in (
            (coordinate.fixed, coordinate.start, coordinate.name),
            (coordinate.rate_fixed, coordinate.rate_start, f"der({coordinate.name})"),
        ):
            if _uses(start, moved):
                sink.report("E0350" if fixed else "W0353", place(coordinate), name=name)
    for state in model.states:
        if _uses(state.start, moved):
            sink.report("E0350" if state.fixed else "W0353", place(state), name=state.name)


def _counted(free: list[fm.Parameter]) -> str:
    return "a free parameter" if len(free) == 1 else f"{len(free)} free parameters"


def _uses(expression: fx.FlatExpression, names: set[str]) -> bool:
    return any(isinstance(node, fx.Variable) and node.name in names for node in postorder(expression))
