"""Finds expressions that contain a symbol but do not depend on it: the derivative is zero to rounding at random points.

Kinetic energies are sums of squares of velocities, in which many angles cancel. An analytic expression that is zero at
a random point is zero everywhere; expressions with kinks keep all that stands in them.
"""

from __future__ import annotations

import numpy as np

from lagdsl.algebra.graph.evaluate import evaluate_with_size
from lagdsl.algebra.graph.graph import Graph
from lagdsl.algebra.graph.operation import DIRECTION_OF, STEPS, Group, Op
from lagdsl.derivation.program.program import Program
from lagdsl.foundation.record import record

_POINTS = 2
# Sizes are bounds, and may be too large by far: what is zero must be nothing beside its neighbors, too.
_ROUNDING = 1e-14
_NOTHING = 1e-9
_CLOSER = 0.25
_KINKS = STEPS | {Op.SELECT, Op.ABS, Op.MIN, Op.MAX, Op.MOD}
# Directions at once, and the numbers that a search may take; where there are more, what stands there counts.
_TOGETHER = 64
_MOST = 3e7

# The values and, beside them, their derivatives along directions: function and number of the result.
_PAIRS = (
    ("residual", 0, "residual_tangent", 0),
    ("residual", 1, "residual_tangent", 1),
    ("position_constraint", 0, "constraint_tangent", 0),
    ("velocity_constraint", 0, "constraint_tangent", 1),
    ("state_derivative", 0, "state_derivative_tangent", 0),
    ("output", 0, "output_tangent", 0),
    ("energies", 0, "energies_tangent", 0),
    ("energies", 1, "energies_tangent", 1),
    ("energies", 2, "energies_tangent", 2),
    ("definition", 0, "definition_tangent", 0),
)


@record(kw_only=True)
class PrunedDependencies:
    """`derivatives`: pairs of a value, that is a result of a function, and a symbol on which it does not depend;
    `factors`: elements of M and J that are zero."""

    derivatives: frozenset[tuple[int, int]]
    factors: frozenset[int]


def pruned_dependencies(program: Program) -> PrunedDependencies:
    """Of a program with all its named values."""
    search = _Search(program)
    blocks = program.function("dynamics").results if program.has("dynamics") else ()
    factors = [node for block in blocks if len(block.shape) == 2 for node in block.elements]
    return PrunedDependencies(
        derivatives=frozenset(search.along_directions() | search.in_time()),
        factors=frozenset(search.zero_nodes(tuple(factors))),
    )


class _Search:
    def __init__(self, program: Program) -> None:
        self._program, self._graph = program, program.graph
        self._points, self._kinked = _random_points(program), _kinked(program.graph)

    def along_directions(self) -> set[tuple[int, int]]:
        graph, layout = self._graph, self._program.layout
        triples = self._smooth_values()
        tangents = list(dict.fromkeys(tangent for _, tangent, _ in triples))
        columns = [(group, index) for group in DIRECTION_OF for index in range(layout.size(group))]
        if len(graph.live(tangents)) * len(columns) * _POINTS > _MOST:
            return set()
        zero = self._zero_slopes(tangents, columns)
        return {
            (value, graph.symbol(*columns[column]))
            for value, tangent, moved in triples
            for column in np.flatnonzero(zero[tangent])
            if DIRECTION_OF[columns[column][0]] in moved
        }

    def _zero_slopes(self, tangents: list[int], columns: list[tuple[Group, int]]) -> dict[int, np.ndarray]:
        """For each of `tangents` the columns along which it is zero."""
        values, sizes = (np.zeros((len(tangents), _POINTS, len(columns))) for _ in range(2))
        for first in range(0, len(columns), _TOGETHER):
            part = columns[first : first + _TOGETHER]
            there = slice(first, first + len(part))
            for row, (value, size) in enumerate(evaluate_with_size(self._graph, tangents, self._given(part))):
                values[row, :, there], sizes[row, :, there] = value, size
        largest = np.max(np.abs(values), axis=2, keepdims=True, initial=0.0)
        return dict(zip(tangents, np.all(_is_zero(values, sizes, largest), axis=1), strict=True))

    def in_time(self) -> set[tuple[int, int]]:
        program, time = self._program, self._graph.symbol(Group.TIME)
        values = [
            *(program.function("residual").results),
            *(program.function(name).results[0] for name in ("position_constraint", "velocity_constraint")),
            *(block for name in ("state_derivative", "output", "energies") for block in program.function(name).results),
            *program.function("definition").results,
        ]
        found = set[tuple[int, int]]()
        for value, tangent in zip(values, program.function("time_tangent").results, strict=True):
            zero = self.zero_nodes(tangent.elements)
            for node, change in zip(value.elements, tangent.elements, strict=True):
                if change in zero and not self._kinked[node]:
                    found.add((node, time))
        return found

    def zero_nodes(self, nodes: tuple[int, ...]) -> set[int]:
        """Members of `nodes`, results of one function, that are identically zero."""
        wanted = [node for node in dict.fromkeys(nodes) if not self._kinked[node]]
        sized = evaluate_with_size(self._graph, wanted, self._given([]))
        largest = max((np.max(np.abs(value)) for value, _ in sized), default=0.0)
        zero = (bool(np.all(_is_zero(value, size, largest))) for value, size in sized)
        return {node for node, is_zero in zip(wanted, zero, strict=True) if is_zero}

    def _smooth_values(self) -> list[tuple[int, int, tuple[Group, ...]]]:
        """Values, their derivatives, and the directions that these know."""
        program = self._program
        found = []
        for function, result, tangent, change in _PAIRS:
            values = program.function(function).results[result].elements
            changes = program.function(tangent).results[change].elements
            moved = program.function(tangent).arguments
            found += [(v, d, moved) for v, d in zip(values, changes, strict=True) if not self._kinked[v]]
        return found

    def _given(self, columns: list[tuple[Group, int]]) -> dict[Group, np.ndarray]:
        """Points along the first axis, directions along the second."""
        given = {g: x[:, None] if g is Group.TIME else x[:, None, :] for g, x in self._points.items()}
        for group, direction in DIRECTION_OF.items():
            along = np.zeros((1, max(len(columns), 1), self._program.layout.size(group)))
            for column, (own, index) in enumerate(columns):
                if own is group:
                    along[0, column, index] = 1.0
            given[direction] = along
        return given


def _is_zero(value: np.ndarray, size: np.ndarray, largest: np.ndarray | float) -> np.ndarray:
    zero = np.isfinite(size) & np.isfinite(largest)
    return np.asarray(zero & (np.abs(value) <= _ROUNDING * size) & (np.abs(value) <= _NOTHING * largest))


def _kinked(graph: Graph) -> bytearray:
    """1 for what is computed from something with a kink, or is that itself."""
    flags = bytearray(len(graph))
    for node in range(len(graph)):
        flags[node] = graph.op[node] in _KINKS or any(flags[other] for other in graph.operands[node])
    return flags


def _random_points(program: Program) -> dict[Group, np.ndarray]:
    """Near the start, where the model is meant; the same in every run. Parameters are not zero, and of magnitudes that
    are nearer to each other than those of the model: beside the speed of light, what is slow must not vanish."""
    layout, graph, random = program.layout, program.graph, np.random.default_rng(20)
    defaults = np.array(layout.defaults)
    starts = program.function("start").results[0].elements
    known = evaluate_with_size(graph, starts, {Group.P: defaults, Group.TIME: 0.0})
    centre = np.array([float(value) for value, _ in known])
    spread = random.uniform(-1.0, 1.0, (2, _POINTS, len(centre)))
    given = {group: random.uniform(0.2, 1.0, (_POINTS, layout.size(group))) for group in DIRECTION_OF}
    given[Group.TIME] = random.uniform(0.1, 2.0, _POINTS)
    given[Group.W] = random.uniform(0.2, 1.0, (_POINTS, layout.size(Group.W)))
    given[Group.Q] = centre * (1.0 + 0.3 * spread[0]) + 0.7 * spread[1]
    scale = np.where((defaults != 0.0) & np.isfinite(defaults), defaults, 1.0)
    scale = np.sign(scale) * np.abs(scale) ** _CLOSER
    given[Group.P] = scale * random.uniform(0.6, 1.4, (_POINTS, len(defaults)))
    return given
