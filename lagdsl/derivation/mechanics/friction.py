"""Dry friction on the graph, and loads that depend on the accelerations and multipliers that they cause."""

from __future__ import annotations

from lagdsl.algebra.graph.differentiate import jacobian
from lagdsl.algebra.graph.operation import Group
from lagdsl.derivation.mechanics.lowering.lowering import Lowering
from lagdsl.derivation.mechanics.tangents import SOLVED_GROUPS, directional
from lagdsl.derivation.program.functions import OPTIONAL
from lagdsl.derivation.program.program import Function, Program, matrix_block, vector_block
from lagdsl.language.flat.model import FlatModel


def friction_functions(lowering: Lowering, flat: FlatModel) -> tuple[Function, ...]:
    """`friction` of a model with dry friction; none for others."""
    frictions = flat.events.frictions
    if not frictions:
        return ()
    graph, symbols = lowering.graph, lowering.symbols
    slips, limits, sticking = [], [], []
    for each in frictions:
        lowering.place = each.spans
        slips += [lowering.scalar(slip) for slip in each.slips]
        limits.append(lowering.scalar(each.limit))
        sticking.append(lowering.scalar(each.limit if each.sticking is None else each.sticking))
    blocks = (
        vector_block("slip", slips),
        matrix_block("jacobian", jacobian(graph, slips, symbols.qd), len(symbols.qd)),
        vector_block("limit", limits),
        vector_block("sticking", sticking),
        matrix_block("gain", jacobian(graph, limits, symbols.lam), len(symbols.lam)),
        matrix_block("sticking_gain", jacobian(graph, sticking, symbols.lam), len(symbols.lam)),
    )
    return (Function(name="friction", arguments=OPTIONAL["friction"], results=blocks),)


def load_functions(lowering: Lowering, flat: FlatModel, program: Program) -> tuple[Function, ...]:
    """`load`, `load_tangent` and `load_gain` of a model with loads that depend on accelerations or multipliers; none
    for others. `program` has the equations of motion."""
    if not flat.events.feedbacks:
        return ()
    graph, symbols = lowering.graph, lowering.symbols
    loads = []
    for each in flat.events.feedbacks:
        lowering.place = each.spans
        loads.append(lowering.scalar(each.value))
    qdd = graph.symbols(Group.QDD, len(symbols.q))
    own = [symbols.previous[each.name] for each in flat.events.feedbacks]
    moved = [program.function(name).results[0].elements for name in ("residual", "state_derivative", "output")]
    blocks = {
        "load": (
            vector_block("load", loads),
            matrix_block("by_acceleration", jacobian(graph, loads, qdd), len(qdd)),
            matrix_block("by_multiplier", jacobian(graph, loads, symbols.lam), len(symbols.lam)),
        ),
        "load_tangent": (vector_block("load", directional(graph, loads, SOLVED_GROUPS)),),
        "load_gain": tuple(
            matrix_block(name, jacobian(graph, nodes, own), len(own))
            for name, nodes in zip(("motion", "rates", "y", "load"), (*moved, loads), strict=True)
        ),
    }
    return tuple(Function(name=name, arguments=OPTIONAL[name], results=found) for name, found in blocks.items())
