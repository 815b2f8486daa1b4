"""The terms that a sum consists of."""

from __future__ import annotations

from lagdsl.algebra.graph.differentiate import mask_of
from lagdsl.algebra.graph.graph import Graph
from lagdsl.algebra.graph.operation import Group, Op
from lagdsl.foundation.record import record

_HELD = mask_of((Group.P,))


@record()
class Term:
    """`node` times `weight`, which depends on parameters only."""

    node: int
    weight: int


def terms_of(graph: Graph, total: int) -> list[Term]:
    """Terms of `total` with what multiplies whole sums multiplied out, where that is a parameter."""
    found: list[Term] = []
    stack = [Term(total, graph.one)]
    while stack:
        term = stack.pop()
        a, b, weight = graph.a[term.node], graph.b[term.node], term.weight
        op = graph.op[term.node]
        if op is Op.ADD:
            stack += (Term(b, weight), Term(a, weight))
        elif op is Op.SUBTRACT:
            stack += (Term(b, graph.negate(weight)), Term(a, weight))
        elif op is Op.NEGATE:
            stack.append(Term(a, graph.negate(weight)))
        elif op is Op.MULTIPLY and not graph.groups[a] & ~_HELD:
            stack.append(Term(b, graph.multiply(weight, a)))
        elif op is Op.MULTIPLY and not graph.groups[b] & ~_HELD:
            stack.append(Term(a, graph.multiply(weight, b)))
        elif op is Op.DIVIDE and not graph.groups[b] & ~_HELD:
            stack.append(Term(a, graph.divide(weight, b)))
        else:
            found.append(term)
    return found
