"""A function that is linear in some symbols as a sparse system of its steps: the matrix of the function may be full."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping, Sequence
from typing import TypeAlias

import numpy as np

from lagdsl.algebra.graph.graph import Graph
from lagdsl.algebra.graph.operation import Group, Op
from lagdsl.algebra.graph.tape import Tape
from lagdsl.foundation.numerics.sparse_matrix import SparseMatrix

# An operand that moves, a node that does not, and the factor of the operand as a function of the value of that node.
_Term: TypeAlias = tuple[int, int, Callable[[float], float]]


def linear_steps(
    graph: Graph, elements: Sequence[int], vector: Group, size: int, symbols: Mapping[Group, list[float] | float]
) -> SparseMatrix | None:
    """The extended Jacobian (k + m, n + k) of m elements that are linear in the n = `size` symbols of `vector`.

    Each of the k steps, a node that moves with the vector, has a row that is zero where the step is what its operands
    give; the row of an element is the element. Columns are symbols, then steps. The matrix of the function is what is
    left without the steps (Schur), so for m = n both are regular or none is. `symbols` has the other groups. None where
    a step is no sum, no choice and no product or quotient with what does not move.

    Source: A. Griewank, A. Walther, Evaluating Derivatives, 2nd ed. (2008), on the extended Jacobian.
    """
    moved = [node for node in graph.live(elements) if graph.depends(node, vector)]
    steps = [node for node in moved if graph.op[node] is not Op.SYMBOL]
    terms = [(row, term) for row, node in enumerate(steps) for term in _terms(graph, node, vector)]
    if any(graph.depends(fixed, vector) for _, (_, fixed, _) in terms):
        return None
    columns = {node: graph.b[node] for node in moved if graph.op[node] is Op.SYMBOL}
    columns |= {node: size + row for row, node in enumerate(steps)}
    values = Tape(graph, [fixed for _, (_, fixed, _) in terms])(symbols).tolist()
    found = {(row, size + row): -1.0 for row in range(len(steps))}
    for (row, (operand, _, factor)), value in zip(terms, values, strict=True):
        place = row, columns[operand]
        found[place] = found.get(place, 0.0) + factor(value)
    found |= {(row, columns[node]): 1.0 for row, node in enumerate(elements, len(steps)) if node in columns}
    places = np.array(list(found), dtype=np.intp).reshape(-1, 2)
    shape = len(steps) + len(elements), size + len(steps)
    return SparseMatrix(shape, places[:, 0], places[:, 1], np.array(list(found.values())))


def _terms(graph: Graph, node: int, vector: Group) -> Iterator[_Term]:
    """The terms that a step is the sum of; the second node of one moves where the step is not linear."""
    op, operands, one = graph.op[node], graph.operands[node], graph.one
    found: tuple[_Term, ...]
    if op is Op.ADD:
        found = tuple((operand, one, _itself) for operand in operands)
    elif op is Op.SUBTRACT:
        found = (operands[0], one, _itself), (operands[1], one, _minus)
    elif op is Op.NEGATE:
        found = ((operands[0], one, _minus),)
    elif op is Op.MULTIPLY:
        first, second = operands if graph.depends(operands[0], vector) else operands[::-1]
        found = ((first, second, _itself),)
    elif op is Op.DIVIDE:
        found = ((operands[0], operands[1], _inverse),)
    elif op is Op.SELECT:
        condition, value, otherwise = operands
        found = (value, condition, _holds), (otherwise, condition, _fails)
    else:
        found = ((operands[0], node, _itself),)
    yield from (term for term in found if graph.depends(term[0], vector) or graph.depends(term[1], vector))


def _itself(value: float) -> float:
    return value


def _minus(value: float) -> float:
    return -value


def _inverse(value: float) -> float:
    return 1.0 / value if value else np.inf


def _holds(condition: float) -> float:
    return float(condition != 0.0)


def _fails(condition: float) -> float:
    return float(condition == 0.0)
