"""Quantities that may be constant, as nodes of the graph, each with its rate along the motion.

All conserved quantities that are searched for are linear combinations of these: the energy and Jacobi's integral, the
linear and angular momentum of the whole, the generalized momenta p, their products p_i q_j with coordinates, and the
coordinates. By Noether's theorem (Landau and Lifshitz, *Mechanics*, section 7; Goldstein, *Classical Mechanics*, 13.7)
a combination of momenta sum_ij p_i (A_ij q_j + b_i) belongs to the infinitesimal symmetry q -> q + eps (A q + b); terms
in q alone stand for a Lagrangian that changes by a total derivative.
"""

from __future__ import annotations

from collections.abc import Iterator
from typing import Literal, TypeAlias

from lagdsl.algebra.graph.operation import STEPS, Group, Op
from lagdsl.derivation.mechanics.constraints import constraint_forces
from lagdsl.derivation.mechanics.equations import Equations
from lagdsl.foundation.diagnostics import CompilationFailed
from lagdsl.foundation.record import record
from lagdsl.foundation.units import Dimension
from lagdsl.foundation.units.dimension import DIMENSIONLESS, ENERGY, INERTIA, LENGTH, MASS, TIME
from lagdsl.language.flat import expression as fx
from lagdsl.language.flat.expression_text import flat_expression_text
from lagdsl.language.flat.model import Coordinate, FlatModel
from lagdsl.language.flat.quantity import Spans

Family: TypeAlias = Literal["energy", "momentum", "linear", "angular", "product", "coordinate"]

MOST_COORDINATES = 8
"""Beyond so many, no products of momenta and coordinates: there are as many as the square of this."""

_ORIGIN = fx.FrameOrigin("world")
_HELD = (Group.Z, Group.U, Group.W)  # what a conserved quantity may not depend on: they move as they like, or jump
_KINKS = STEPS | {Op.ABS, Op.MIN, Op.MAX, Op.MOD}


@record(kw_only=True)
class Candidate:
    """`value` and `rate` are nodes; `text` is the expression in the language; `moved` names the coordinate that the
    symmetry of a momentum changes, `by` the one that it is changed by (None: by a constant)."""

    text: str
    value: int
    rate: int
    dimension: Dimension
    family: Family
    spans: tuple[Spans, ...]
    moved: str = ""
    by: str | None = None


def candidates(equations: Equations) -> list[Candidate]:
    """All of a model, simple ones first; those that inputs, states or events change by themselves, or that may jump in
    `noEvent`, are left out.

    Where forces have corners only quantities are left whose rate has none: states at random may lie on one side.
    """
    graph = equations.graph
    found = [*_momenta(equations), *_energies(equations), *_of_the_whole(equations)]
    found += [*_coordinates(equations)]
    if len(equations.flat.coordinates) <= MOST_COORDINATES:
        found += _products(equations)
    found = [each for each in found if not graph.depends(each.value, *_HELD)]
    forces = _forces(equations)
    kinked = _kinked(equations, [*forces, *(node for each in found for node in (each.value, each.rate))])
    found = [each for each in found if each.value not in kinked]
    if not kinked.isdisjoint(forces):
        solved = (Group.QDD, Group.LAMBDA)
        found = [each for each in found if not (each.rate in kinked or graph.depends(each.rate, *solved))]
    return found


def _momenta(equations: Equations) -> Iterator[Candidate]:
    """dL/dqd_j, which changes by dL/dq_j + Q_j - dD/dqd_j + (J' lam)_j."""
    rates = _forces(equations)
    action = _dimension(equations.flat, ENERGY * TIME)
    for item, value, rate in zip(equations.flat.coordinates, equations.dynamics.terms.momentum, rates, strict=True):
        text = flat_expression_text(fx.GeneralizedMomentum(item.name))
        own = action / item.dimension
        yield Candidate(
            text=text, value=value, rate=rate, dimension=own, family="momentum", spans=(item.spans,), moved=item.name
        )


def _forces(equations: Equations) -> list[int]:
    graph, symbols, terms = equations.graph, equations.symbols, equations.dynamics.terms
    guided = constraint_forces(graph, equations.rows, symbols.lam, symbols.directions)
    return [
        graph.add(graph.add(graph.subtract(load, drag), push), own)
        for load, drag, push, own in zip(terms.load, terms.drag, terms.push, guided, strict=True)
    ]


def _products(equations: Equations) -> Iterator[Candidate]:
    graph, symbols = equations.graph, equations.symbols
    for momentum in _momenta(equations):
        for item, q, qd in zip(equations.flat.coordinates, symbols.q, symbols.qd, strict=True):
            rate = graph.add(graph.multiply(momentum.rate, q), graph.multiply(momentum.value, qd))
            yield Candidate(
                text=f"{_name(item)}*{momentum.text}",
                value=graph.multiply(momentum.value, q),
                rate=rate,
                dimension=momentum.dimension * item.dimension,
                family="product",
                spans=(*momentum.spans, item.spans),
                moved=momentum.moved,
                by=item.name,
            )


def _coordinates(equations: Equations) -> Iterator[Candidate]:
    symbols = equations.symbols
    for item, q, qd in zip(equations.flat.coordinates, symbols.q, symbols.qd, strict=True):
        yield Candidate(
            text=_name(item), value=q, rate=qd, dimension=item.dimension, family="coordinate", spans=(item.spans,)
        )


def _name(item: Coordinate) -> str:
    return flat_expression_text(fx.Variable(item.name))


def _energies(equations: Equations) -> Iterator[Candidate]:
    flat = equations.flat
    items = (*flat.masses, *flat.bodies, *flat.energies)
    for expression in (fx.SystemEnergy("total"), fx.SystemEnergy("jacobi")):
        node = equations.energies.of(expression.kind)
        yield from _along_the_motion(equations, expression, node, ENERGY, "energy", tuple(item.spans for item in items))


def _of_the_whole(equations: Equations) -> Iterator[Candidate]:
    """World components of the linear momentum and of the angular momentum about the origin. A Lagrangian of the user's
    own has momenta that masses and bodies do not show."""
    flat = equations.flat
    if any(term.kind in {"kinetic", "lagrangian"} for term in flat.energies):
        return
    spans = tuple(item.spans for item in (*flat.masses, *flat.bodies))
    wholes: tuple[tuple[fx.FlatExpression, Dimension, Family], ...] = (
        (fx.LinearMomentum(), MASS * LENGTH / TIME, "linear"),
        (fx.AngularMomentum(None, _ORIGIN), INERTIA / TIME, "angular"),
    )
    for whole, own, family in wholes:
        nodes = equations.lowering.vector(whole)
        for axis, node in enumerate(nodes):
            yield from _along_the_motion(equations, fx.Component(whole, axis), node, own, family, spans)


def _along_the_motion(
    equations: Equations,
    expression: fx.FlatExpression,
    node: int,
    own: Dimension,
    family: Family,
    spans: tuple[Spans, ...],
) -> Iterator[Candidate]:
    """One whose rate is its time derivative; none where that needs the derivative of an input."""
    if equations.graph.depends(node, *_HELD):
        return
    try:
        rate = equations.lowering.rate.of(node)
    except CompilationFailed:
        return
    text, dimension = flat_expression_text(expression), _dimension(equations.flat, own)
    yield Candidate(text=text, value=node, rate=rate, dimension=dimension, family=family, spans=spans)


def _dimension(flat: FlatModel, own: Dimension) -> Dimension:
    """Models whose every quantity is a number have numbers for energies, too."""
    dimensions = [each.dimension for each in flat.coordinates] + [each.dimension for each in flat.parameters]
    dimensions += [each.dimension for each in flat.invariants] + [each.dimension for each in flat.outputs]
    return DIMENSIONLESS if all(each.is_dimensionless for each in dimensions) else own


def _kinked(equations: Equations, nodes: list[int]) -> set[int]:
    """Of all that `nodes` are made of, what has a corner or a step that is not an event. Relations, which states at
    random take both ways, are."""
    graph = equations.graph
    found: set[int] = set()
    for node in graph.live(nodes):
        op = graph.op[node]
        switch = graph.a[node] if op is Op.SELECT else node if op in _KINKS else None
        own = switch is not None and graph.depends(switch, Group.TIME, Group.Q, Group.QD, Group.Z)
        if own or any(argument in found for argument in graph.arguments(node)):
            found.add(node)
    return found
