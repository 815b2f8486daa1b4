"""Random moments at which a flat model is tried, always the same ones."""

from __future__ import annotations

from random import Random

from lagdsl.foundation.record import record
from lagdsl.language.flat import model as fm
from lagdsl.language.flat.evaluate import Evaluator, NotEvaluable, Values


@record()
class ProbeState:
    """Values and rates of the coordinates, values of states, inputs and time."""

    variables: dict[str, float]
    rates: dict[str, float]


def probes(flat: fm.FlatModel, count: int) -> list[ProbeState]:
    """`count` moments around the start, spread by the nominal size of each coordinate (1 where none is given)."""
    random = Random(20240229)
    at_start = Evaluator(flat, Values())
    starts = {c.name: _start(at_start, c) for c in flat.coordinates}
    moments = []
    for _ in range(count):
        variables = {c.name: starts[c.name] + (c.nominal or 1.0) * random.uniform(-1, 1) for c in flat.coordinates}
        variables.update({item.name: random.uniform(0.1, 1) for item in (*flat.states, *flat.inputs)})
        variables["time"] = random.uniform(0, 1)
        rates = {c.name: (c.nominal or 1.0) * random.uniform(-1, 1) for c in flat.coordinates}
        moments.append(ProbeState(variables, rates))
    return moments


def _start(evaluator: Evaluator, coordinate: fm.Coordinate) -> float:
    try:
        return evaluator.scalar(coordinate.start)
    except NotEvaluable:
        return 0.0
