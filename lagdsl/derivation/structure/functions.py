"""The functions of a program by the meaning of its graph: what `lag check` evaluates before there is an engine."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import field, replace

import numpy as np

from lagdsl.algebra.graph.evaluate import evaluate
from lagdsl.algebra.graph.graph import ZERO
from lagdsl.algebra.graph.linear_steps import linear_steps
from lagdsl.algebra.graph.occurrence import occurrences
from lagdsl.algebra.graph.operation import Group
from lagdsl.algebra.graph.tape import Tape
from lagdsl.derivation.program.program import Block, Layout, Program
from lagdsl.foundation.numerics.disjoint_columns import disjoint_columns
from lagdsl.foundation.numerics.rank import Floats
from lagdsl.foundation.numerics.sparse_matrix import SparseMatrix, sparse_at
from lagdsl.foundation.record import record

# Columns of M that are found together: each node has as many values then.
_AT_ONCE = 256


@record()
class ProgramFunctions:
    """`evaluate` as an engine has it, for one state at a time."""

    program: Program
    _tapes: dict[str, Tape] = field(default_factory=dict, compare=False, repr=False)

    @property
    def layout(self) -> Layout:
        return self.program.layout

    @property
    def by_columns(self) -> bool:
        """True if M is not written out."""
        return not self.program.has("mass_matrix")

    def momentum_is_finite(self, *state: Floats | float) -> bool:
        """True if M times a vector is, where M is not written out."""
        vector = np.ones(len(self.layout.coordinates))
        return bool(np.all(np.isfinite(self.evaluate("momentum_tangent", *state, vector)[0])))

    def momentum_steps(self, *state: Floats | float) -> SparseMatrix | None:
        """M times a vector by its steps, where M is not written out (see `linear_steps`)."""
        definition = self.program.function("momentum_tangent")
        (momentum,) = definition.results
        *groups, vector = definition.arguments
        return linear_steps(self.program.graph, momentum.elements, vector, momentum.size, _symbols(groups, state))

    def restricted(self, rows: list[int]) -> ProgramFunctions:
        """The same with all other rows of the position constraints, and of J there, zero."""
        program, kept = self.program, set(rows)
        definition = program.function("position_constraint")
        count = max(len(program.layout.constraints), 1)
        blocks = []
        for block in definition.results:
            width = max(block.size // count, 1)
            places = block.places if block.is_sparse else range(block.size)
            own = zip(places, block.nodes, strict=True)
            blocks.append(block.with_nodes([node if place // width in kept else ZERO for place, node in own]))
        changed = replace(definition, results=tuple(blocks))
        functions = tuple(changed if f is definition else f for f in program.functions)
        return ProgramFunctions(replace(program, functions=functions))

    def evaluate(self, function: str, *arguments: Floats | float) -> tuple[Floats, ...]:
        """Result blocks of `function`; what is not a number comes out as nan or inf."""
        if function == "mass_matrix" and self.by_columns:
            return (self.mass(*arguments).dense(),)
        return self._results(function, self.program.function(function).results, *arguments)

    def result(self, function: str, number: int, *arguments: Floats | float) -> Floats:
        """One of its result blocks alone."""
        (found,) = self._results(f"{function} {number}", (self.program.function(function).results[number],), *arguments)
        return found

    def rows(self, function: str, *arguments: Floats | float) -> tuple[Floats, SparseMatrix]:
        """The residuals and J of a function of constraints."""
        residual, matrix = self.program.function(function).results
        values = self._values(function, (residual, matrix), *arguments)
        return values[: residual.size], _matrix(matrix, values[residual.size :])

    def mass(self, *state: Floats | float) -> SparseMatrix:
        """M."""
        if self.by_columns:
            return self._mass_by_columns(*state)
        (block,) = self.program.function("mass_matrix").results
        return _matrix(block, self._values("mass_matrix", (block,), *state))

    def _values(self, name: str, results: Sequence[Block], *arguments: Floats | float) -> Floats:
        """Values of the nodes of these blocks of the function whose name begins so, by the tape of that name."""
        tape = self._tapes.get(name)
        if tape is None:
            tape = Tape(self.program.graph, [node for block in results for node in block.nodes])
            self._tapes[name] = tape
        return tape(_symbols(self.program.function(name.partition(" ")[0]).arguments, arguments))

    def _results(self, name: str, results: Sequence[Block], *arguments: Floats | float) -> tuple[Floats, ...]:
        """The same with all elements of the blocks."""
        values = self._values(name, results, *arguments)
        blocks, first = [], 0
        for block in results:
            own = values[first : first + len(block.nodes)]
            first += len(block.nodes)
            if block.is_sparse:
                whole = np.zeros(block.size)
                whole[list(block.places)] = own
                own = whole
            blocks.append(own.reshape(block.shape))
        return tuple(blocks)

    def _mass_by_columns(self, *state: Floats | float) -> SparseMatrix:
        """M, from its products with many vectors at once. Columns that share no row are the ones of one vector."""
        definition = self.program.function("momentum_tangent")
        (momentum,) = definition.results
        graph, n = self.program.graph, len(momentum.elements)
        rows, columns = occurrences(graph, momentum.elements, definition.arguments[-1])
        groups = disjoint_columns(rows, columns, (n, n))
        mass = np.zeros(len(rows))
        for first in range(0, int(np.max(groups, initial=-1)) + 1, _AT_ONCE):
            vectors = (groups == np.arange(first, min(first + _AT_ONCE, int(np.max(groups)) + 1))[:, None]) * 1.0
            symbols = dict(zip(definition.arguments, (*state, vectors), strict=True))
            found = evaluate(graph, momentum.elements, symbols)
            products = np.array([np.broadcast_to(row, len(vectors)) for row in found])
            here = (groups[columns] >= first) & (groups[columns] < first + len(vectors))
            mass[here] = products[rows[here], groups[columns[here]] - first]
        return SparseMatrix((n, n), rows, columns, mass)

    def along(self, function: str, result: int, *arguments: Floats | float) -> Floats:
        """The result of this number for many directions: (k, n) where the last argument has k rows."""
        definition = self.program.function(function)
        symbols = dict(zip(definition.arguments, arguments, strict=True))
        elements = definition.results[result].elements
        count = max(len(x) if isinstance(x, np.ndarray) and x.ndim > 1 else 1 for x in arguments)
        values = evaluate(self.program.graph, elements, symbols)
        return np.array([np.broadcast_to(value, count) for value in values]).reshape(len(elements), count).T


def _symbols(groups: Sequence[Group], arguments: Sequence[Floats | float]) -> dict[Group, list[float] | float]:
    """Arguments as tapes take them."""
    return {
        group: argument.tolist() if isinstance(argument, np.ndarray) else float(argument)
        for group, argument in zip(groups, arguments, strict=True)
    }


def _matrix(block: Block, values: Floats) -> SparseMatrix:
    """A matrix with these values of its nodes."""
    return sparse_at(np.array(block.places, dtype=np.intp), block.shape, values)
