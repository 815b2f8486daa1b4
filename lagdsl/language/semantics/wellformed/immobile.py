"""Models in which nothing is free to move, and what they have instead (N0513)."""

from __future__ import annotations

from collections.abc import Iterator

from lagdsl.foundation.diagnostics import Sink
from lagdsl.foundation.source import Span
from lagdsl.language.flat import expression as fx
from lagdsl.language.flat import model as fm
from lagdsl.language.flat.dependence import Dependence
from lagdsl.language.flat.quantity import Item
from lagdsl.language.flat.traversal import postorder, step_expressions


def check_freedom(flat: fm.FlatModel, dependence: Dependence, sink: Sink) -> None:
    """N0513 for a model without coordinates and states: the time, its inputs and its events determine all of it."""
    if flat.coordinates or flat.states:
        return
    prescribed = [item for item, expressions in _placed(flat) if _driven(flat, dependence, expressions)]
    prescribed.sort(key=lambda item: item.spans[-1].start if item.spans else 0)
    discretes, outputs = flat.events.discretes, flat.outputs
    counts = (
        (len(prescribed), "prescribed motion"),
        (len(discretes), "discrete variable"),
        (len(outputs), "output"),
    )
    told = [f"{count} {noun}{'' if count == 1 else 's'}" for count, noun in counts if count]
    has = " and ".join([", ".join(told[:-1]), told[-1]] if len(told) > 1 else told) or "nothing to compute"
    sink.report("N0513", _first_place((*prescribed, *discretes, *outputs, *_others(flat))), has=has)


def _placed(flat: fm.FlatModel) -> Iterator[tuple[Item, list[fx.FlatExpression]]]:
    """Frames, points and masses with the expressions that place them against what carries them; of frames that coincide
    the first."""
    frames = [named for named in flat.named if isinstance(named, fm.Frame)]
    for frame in {(frame.parent, frame.steps): frame for frame in reversed(frames)}.values():
        yield frame, [each for step in frame.steps for each in step_expressions(step)]
    for named in flat.named:
        if isinstance(named, fm.Point):
            yield named, [named.position]
    for mass in flat.masses:
        yield mass, [mass.position]


def _driven(flat: fm.FlatModel, dependence: Dependence, expressions: list[fx.FlatExpression]) -> bool:
    """True if they depend on the time, on inputs or on events by themselves, not through a frame or a point."""
    changing = {"time", *(item.name for item in flat.inputs), *(item.name for item in flat.events.discretes)}
    nodes = (node for expression in expressions for node in postorder(expression))
    return any(isinstance(node, fx.Variable) and not changing.isdisjoint(dependence.of(node)) for node in nodes)


def _others(flat: fm.FlatModel) -> tuple[Item, ...]:
    return (*flat.bodies, *flat.masses, *flat.inputs, *flat.named, *flat.parameters)


def _first_place(items: tuple[Item, ...]) -> Span | None:
    return next((item.spans[-1] for item in items if item.spans), None)
