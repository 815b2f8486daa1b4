"""The nodes of all equations, their order and their texts: both halves of the file are written from them."""

from __future__ import annotations

from collections.abc import Mapping

from lagdsl.algebra.graph.graph import Graph
from lagdsl.algebra.graph.operation import Group
from lagdsl.algebra.graph.substitute import Substitution
from lagdsl.derivation.mechanics.equations import Equations
from lagdsl.derivation.program.passes.schedule import schedule
from lagdsl.derivation.program.program import Program
from lagdsl.derivation.structure.structure import Structure
from lagdsl.engines.backends.modelica.clauses import Clauses, clauses, nodes_of, standing
from lagdsl.engines.backends.modelica.expressions import Expressions
from lagdsl.engines.backends.modelica.motion import Motion, motion
from lagdsl.engines.backends.modelica.names import own
from lagdsl.engines.backends.modelica.variables import acceleration, leaves, truths
from lagdsl.engines.backends.start import Start, free_parameters
from lagdsl.foundation.record import record
from lagdsl.language.flat.events import entries
from lagdsl.language.flat.model import FlatModel


@record(kw_only=True)
class Nodes:
    """All expressions of the file.

    `starts` are those of (q, qd, z); None where they are the numbers of a consistent start, because constraints,
    initial equations or free parameters decide on them. `inputs`, `discrete_starts` and `clocks` (first instant and
    period) are values at the start, too; `standing` are relations and what time alone changes, `delays` what is delayed
    and by how much.
    """

    motion: Motion
    state_rates: tuple[int, ...]
    outputs: tuple[int, ...]
    assertions: tuple[int, ...]
    standing: Mapping[str, int]
    whens: Clauses
    starts: tuple[int, ...] | None
    inputs: tuple[int, ...]
    discrete_starts: Mapping[str, int]
    clocks: Mapping[str, tuple[int, int]]
    delays: Mapping[str, tuple[int, int]]

    def roots(self) -> list[int]:
        """All of them."""
        found = self.motion
        return [
            *(*found.accelerations, *found.multipliers, *found.residuals),
            *(*self.state_rates, *self.outputs, *self.assertions, *self.standing.values(), *nodes_of(self.whens)),
            *(*(self.starts or ()), *self.inputs, *self.discrete_starts.values()),
            *(node for pairs in (self.clocks, self.delays) for pair in pairs.values() for node in pair),
        ]


@record(kw_only=True)
class Body:
    """A model as the file has it: `shared` are the identifiers of intermediate results by node, `solved` those of them
    that are accelerations; `expressions` prints all nodes."""

    flat: FlatModel
    graph: Graph
    program: Program
    start: Start | None
    nodes: Nodes
    shared: Mapping[int, str]
    solved: Mapping[int, str]
    expressions: Expressions

    def depends_on_parameters_only(self, node: int) -> bool:
        return _of_parameters(self.graph, node)


def body_of(equations: Equations, program: Program, structure: Structure, start: Start | None) -> Body:
    """The body of the file for `program`, one of `equations`; `start` is a consistent state for its defaults."""
    flat, graph = equations.flat, program.graph
    nodes = _nodes(equations, program, structure, start)
    shared = {node: own(str(k + 1)) for k, node in enumerate(schedule(graph, nodes.roots()).named)}
    solved = _solved(flat, graph, nodes.motion, shared)
    texts = {**shared, **solved, **leaves(graph, flat)}
    expressions = Expressions(graph, texts.get, truths(graph, flat))
    for index, entry in enumerate(entries(flat.events)):
        if entry.name in nodes.clocks:  # a clock is a call of `sample` wherever it is read
            first, period = map(expressions.number, nodes.clocks[entry.name])
            texts[graph.symbol(Group.W, index)] = f"sample({first}, {period})"
    return Body(
        flat=flat,
        graph=graph,
        program=program,
        start=start,
        nodes=nodes,
        shared={**shared, **solved},
        solved=solved,
        expressions=expressions,
    )


def _nodes(equations: Equations, program: Program, structure: Structure, start: Start | None) -> Nodes:
    flat, graph = equations.flat, program.graph
    at_start = Substitution(graph, {graph.symbol(Group.TIME): graph.constant(flat.experiment.start_time)})

    def at(name: str, *which: int) -> tuple[int, ...]:
        results = program.function(name).results
        return tuple(at_start.of_all([node for k in which for node in results[k].elements]))

    every = [entry.name for entry in entries(flat.events)]
    variables = {each.name for each in flat.events.discretes}
    values = zip(every, at("discrete_start", 0), strict=True) if every else ()
    decided = bool(flat.constraints or flat.initial_equations or free_parameters(flat))
    clocks = zip(at("clock", 0), at("clock", 1), strict=True) if flat.events.clocks else ()
    return Nodes(
        motion=motion(equations, program, structure),
        state_rates=program.function("state_derivative").results[0].elements,
        outputs=program.function("output").results[0].elements,
        assertions=program.function("monitor").results[2].elements,
        standing=standing(equations, program),
        whens=clauses(equations),
        starts=None if decided and start is not None else at("start", 0, 1, 2),
        inputs=at("start", 3),
        discrete_starts={name: node for name, node in values if name in variables},
        clocks=dict(zip((each.name for each in flat.events.clocks), clocks, strict=True)),
        delays=dict(zip((each.name for each in flat.events.delays), _delays(program), strict=True)),
    )


def _delays(program: Program) -> list[tuple[int, int]]:
    if not program.has("delayed"):
        return []
    values, times, _ = (block.elements for block in program.function("delayed").results)
    return list(zip(values, times, strict=True))


def _solved(flat: FlatModel, graph: Graph, found: Motion, shared: Mapping[int, str]) -> dict[int, str]:
    """Intermediate results that are accelerations have their names; those of parameters alone are parameters."""
    pairs = zip(found.accelerations, flat.coordinates, strict=False)
    names = {node: acceleration(item.name) for node, item in reversed(list(pairs))}
    return {node: names[node] for node in shared if node in names and not _of_parameters(graph, node)}


def _of_parameters(graph: Graph, node: int) -> bool:
    return not graph.groups[node] & ~(1 << Group.P)
