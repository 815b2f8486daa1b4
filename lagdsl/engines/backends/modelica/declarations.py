"""The variables of the file."""

from __future__ import annotations

from collections.abc import Iterator

from lagdsl.algebra.graph.operation import Group
from lagdsl.engines.backends.modelica.body import Body
from lagdsl.engines.backends.modelica.expressions import literal
from lagdsl.engines.backends.modelica.names import quoted
from lagdsl.engines.backends.modelica.variables import (
    STABILIZATION,
    acceleration,
    bounds,
    declaration,
    independent,
    multiplier,
    rate,
    typed,
    unit,
    units_of_motion,
)
from lagdsl.foundation.units.naming import unit_text
from lagdsl.language.flat.events import entries
from lagdsl.language.flat.listing import computed_outputs, discrete_outputs

_FIXED = ("fixed", "true")
_PER_LINE = 8


def declarations(body: Body) -> list[str]:
    """All of them, one a line; intermediate results several."""
    return [
        *_parameters(body),
        *_inputs(body),
        *_states(body),
        *_unknowns(body),
        *_outputs(body),
        *_discretes(body),
        *_shared(body),
    ]


def _parameters(body: Body) -> Iterator[str]:
    for item in independent(body.flat):
        kind, value = typed(item.kind, item.value)
        attributes = [*(unit(item.unit) if kind == "Real" else ()), *bounds(item)]
        yield declaration(f"parameter {kind}", quoted(item.name), attributes, value, item.doc)
    if body.nodes.motion.stabilized:
        experiment = body.flat.experiment
        length = experiment.stop_time - experiment.start_time
        value = literal(100.0 / length if experiment.stop_time_explicit and length > 0.0 else 10.0)[0]
        doc = "rate at which errors of the constraints decay (Baumgarte)"
        yield declaration("parameter Real", STABILIZATION, unit("1/s"), value, doc)


def _inputs(body: Body) -> Iterator[str]:
    for item, node in zip(body.flat.inputs, body.nodes.inputs, strict=True):
        kind, _ = typed(item.base, 0.0)
        start = body.expressions.condition(node) if kind == "Boolean" else body.expressions.number(node)
        attributes = [("start", start), *(unit(item.unit) if kind == "Real" else ()), *bounds(item)]
        yield declaration(f"input {kind}", quoted(item.name), attributes, doc=item.doc)


def _states(body: Body) -> Iterator[str]:
    flat = body.flat
    if body.nodes.starts is None:
        assert body.start is not None
        starts = [literal(value)[0] for value in body.start.x]
    else:
        starts = [body.expressions.number(node) for node in body.nodes.starts]
    count = len(flat.coordinates)
    of_q, of_qd, of_z = starts[:count], starts[count : 2 * count], starts[2 * count :]
    for item, start in zip(flat.coordinates, of_q, strict=True):
        yield _state(quoted(item.name), start, item.unit, item.nominal, item.doc)
    for item, start in zip(flat.coordinates, of_qd, strict=True):
        yield _state(rate(item.name), start, units_of_motion(item)[1], None, None)
    for state, start in zip(flat.states, of_z, strict=True):
        yield _state(quoted(state.name), start, state.unit, state.nominal, state.doc)


def _state(name: str, start: str, of: str, nominal: float | None, doc: str | None) -> str:
    sizes = [] if nominal is None else [("nominal", literal(nominal)[0])]
    return declaration("Real", name, [("start", start), _FIXED, *unit(of), *sizes], doc=doc)


def _unknowns(body: Body) -> Iterator[str]:
    for item in body.flat.coordinates:
        yield declaration("Real", acceleration(item.name), unit(units_of_motion(item)[2]))
    for slot in body.program.layout.constraints:
        yield declaration("Real", multiplier(slot.name), [], doc=f"force per unit of the constraint, in {slot.unit}")


def _outputs(body: Body) -> Iterator[str]:
    for item in computed_outputs(body.flat):
        if item.base == "Boolean":
            yield declaration("output Boolean", quoted(item.name), [], doc=item.doc)
        else:
            yield declaration("output Real", quoted(item.name), unit(item.unit), doc=item.doc)


def _discretes(body: Body) -> Iterator[str]:
    outputs = discrete_outputs(body.flat)
    for item in body.flat.events.discretes:
        node, word = body.nodes.discrete_starts[item.name], "output " if item.name in outputs else ""
        if item.kind == "Boolean":
            attributes = [("start", body.expressions.condition(node)), _FIXED]
            yield declaration(f"{word}Boolean", quoted(item.name), attributes, doc=item.doc)
        else:
            attributes = [("start", body.expressions.number(node)), _FIXED, *unit(item.unit)]
            yield declaration(f"discrete {word}Real", quoted(item.name), attributes, doc=item.doc)
    for delay in body.flat.events.delays:
        yield declaration("Real", quoted(delay.name), unit(unit_text(delay.dimension)))
    for index, entry in enumerate(entries(body.flat.events)):
        if entry.name in body.nodes.standing:
            truth = body.expressions.is_truth(body.graph.symbol(Group.W, index))
            yield declaration("Boolean" if truth else "discrete Real", quoted(entry.name), [])


def _shared(body: Body) -> Iterator[str]:
    """Intermediate results; those of parameters alone are parameters."""
    continuous: dict[str, list[str]] = {"Real": [], "Boolean": []}
    for node, name in body.shared.items():
        kind = "Boolean" if body.expressions.is_truth(node) else "Real"
        if body.depends_on_parameters_only(node):
            yield declaration(f"parameter {kind}", name, [], body.expressions.definition(node))
        elif node not in body.solved:
            continuous[kind].append(name)
    for kind, names in continuous.items():
        for first in range(0, len(names), _PER_LINE):
            yield f"{kind} {', '.join(names[first : first + _PER_LINE])};"
