"""Programs with M written out, for targets that do not form it column by column."""

from __future__ import annotations

from dataclasses import replace

from lagdsl.algebra.graph.graph import Graph
from lagdsl.algebra.graph.operation import Group
from lagdsl.algebra.graph.substitute import Substitution
from lagdsl.derivation.program.functions import SIGNATURES
from lagdsl.derivation.program.program import Block, Function, Program, matrix_block


def written_out(program: Program) -> Program:
    """`program` with the functions `mass_matrix` and `dynamics`."""
    if program.has("mass_matrix"):
        return program
    graph, size = program.graph, program.layout.size(Group.Q)
    (momenta,) = program.function("momentum_tangent").results
    columns = [_along_one(graph, momenta, k, size) for k in range(size)]
    mass = matrix_block("M", list(zip(*columns, strict=True)), size)
    at_rest = Substitution(graph, {graph.symbol(Group.QDD, k): graph.zero for k in range(size)})
    (missing,) = program.function("inverse_dynamics").results
    _, rows = program.function("residual").results
    _, jacobian = program.function("velocity_constraint").results
    formed = {
        "mass_matrix": (mass,),
        "dynamics": (mass, _negative(graph, missing, at_rest), jacobian, _negative(graph, rows, at_rest)),
    }
    added = (Function(name=name, arguments=SIGNATURES[name], results=blocks) for name, blocks in formed.items())
    return replace(program, functions=(*program.functions, *added))


def _along_one(graph: Graph, momenta: Block, k: int, size: int) -> list[int]:
    unit = {graph.symbol(Group.DIRECTION_QD, i): graph.one if i == k else graph.zero for i in range(size)}
    return Substitution(graph, unit).of_all(momenta.elements)


def _negative(graph: Graph, block: Block, at_rest: Substitution) -> Block:
    return block.with_nodes([graph.negate(node) for node in at_rest.of_all(block.nodes)])
