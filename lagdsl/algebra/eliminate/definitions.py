"""Parts of velocities: read from their expressions, and shortened to those variables that several others use.

Griewank and Walther, *Evaluating Derivatives* (2nd ed., 2008), ch. 9: a node with one argument or one user is
eliminated at no cost.
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence

from lagdsl.algebra.eliminate.form import NotApplicable
from lagdsl.algebra.eliminate.rotations import Rotation, find_rotations
from lagdsl.algebra.graph.graph import Graph
from lagdsl.algebra.graph.operation import Group, Op
from lagdsl.foundation.record import record


@record(kw_only=True)
class Definitions:
    """`terms[v]` gives v as a sum of coefficients times other variables, which come before it; rates qd have none.

    `rotations` are the pairs of variables whose definition is a rotation of another pair in its plane.
    """

    terms: dict[int, dict[int, int]]
    rotations: tuple[Rotation, ...]


def find_definitions(graph: Graph, velocities: Iterable[int]) -> Definitions:
    """Definitions of all of `velocities` down to the rates. Raises NotApplicable where one is not linear in them."""
    kept = dict.fromkeys(velocities)
    terms: dict[int, dict[int, int]] = {}
    for node in graph.live(kept):
        if graph.depends(node, Group.QD) and graph.op[node] is not Op.SYMBOL:
            terms[node] = _terms(graph, node)
    candidates = find_rotations(graph, terms)
    for rotation in candidates:
        kept |= dict.fromkeys((*rotation.after, *rotation.before))
    _inline(graph, terms, kept)
    return Definitions(terms=terms, rotations=tuple(candidates))


def _terms(graph: Graph, node: int) -> dict[int, int]:
    """`node` by its arguments that depend on the rates."""
    op, a, b = graph.op[node], graph.a[node], graph.b[node]
    terms: dict[int, int] = {}

    def add(argument: int, coefficient: int) -> None:
        if graph.depends(coefficient, Group.QD):
            raise NotApplicable
        if graph.depends(argument, Group.QD) and coefficient != graph.zero:
            terms[argument] = graph.add(terms.get(argument, graph.zero), coefficient)

    if op is Op.NEGATE:
        add(a, graph.negate(graph.one))
    elif op in (Op.ADD, Op.SUBTRACT):
        add(a, graph.one)
        add(b, graph.one if op is Op.ADD else graph.negate(graph.one))
    elif op is Op.MULTIPLY:
        moving = graph.depends(a, Group.QD)
        add(a if moving else b, b if moving else a)
    elif op is Op.DIVIDE:
        add(a, graph.divide(graph.one, b))
        if graph.depends(b, Group.QD):
            raise NotApplicable
    elif op is Op.SELECT and not graph.depends(a, Group.QD):
        add(b, graph.select(a, graph.one, graph.zero))
        add(graph.c[node], graph.select(a, graph.zero, graph.one))
    else:
        raise NotApplicable
    return terms


def _inline(graph: Graph, terms: dict[int, dict[int, int]], kept: dict[int, None]) -> None:
    """Drop variables with one argument, then those with one user; those of `kept` stay."""
    users: dict[int, dict[int, None]] = {}
    for node, arguments in terms.items():
        for argument in arguments:
            users.setdefault(argument, {})[node] = None
    order: Sequence[int] = list(terms)
    for node in order:
        if node not in kept and len(terms[node]) == 1:
            _replace(graph, terms, users, node)
    for node in reversed(order):
        if node not in kept and node in terms and len(users.get(node, ())) <= 1:
            _replace(graph, terms, users, node)


def _replace(graph: Graph, terms: dict[int, dict[int, int]], users: dict[int, dict[int, None]], node: int) -> None:
    arguments = terms.pop(node)
    for argument in arguments:
        users[argument].pop(node, None)
    for user in users.pop(node, {}):
        row = terms[user]
        factor = row.pop(node)
        for argument, coefficient in arguments.items():
            total = graph.add(row.get(argument, graph.zero), graph.multiply(factor, coefficient))
            if total == graph.zero:
                row.pop(argument, None)
                users[argument].pop(user, None)
                continue
            row[argument] = total
            users[argument][user] = None
