"""Ranks at other parameters and starts than those the model was compiled with.

A linkage that moves because of its special dimensions (Bennett's) is rigid with others, and one that does not may get
them. On another branch of the constraint set the rank may be another, too.
"""

from __future__ import annotations

from dataclasses import replace

from lagdsl.diagnostics import Sink
from lagdsl.mechanics.rank import Floats
from lagdsl.mechanics.structure_dependence import dependence
from lagdsl.mechanics.structure_names import located, place
from lagdsl.mechanics.structure_points import probes
from lagdsl.simulate.initial_problem import Problem


def redundant_rows(task: Problem, q: Floats, sink: Sink) -> tuple[bool, ...]:
    """Which rows depend on others near positions `q`; E0831 where more are independent than the solver counts with."""
    compiled = task.engine.layout.redundant
    if not any(task.engine.layout.position_level):
        return compiled
    space = replace(task.space, q=q)
    points = probes(task.flat, space, space.position_rows)
    found = dependence(space, points).redundant if points else compiled
    before, now = compiled.count(False), found.count(False)
    if now > before:
        row = next(row for row, (was, is_) in enumerate(zip(compiled, found, strict=True)) if was and not is_)
        item = next(item for item in located(task.flat) if row in item.rows)
        name = task.engine.layout.constraints[row].name
        freedom = max(len(q) - now, 0)
        sink.report("E0831", place(item.constraint), name=name, before=before, now=now, freedom=freedom)
    return found
