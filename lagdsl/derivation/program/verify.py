"""Checks that a program is well formed. `python -X dev` runs it on every program that compiles.

A fault that it finds is a mistake of the compiler, never of a model text.
"""

from __future__ import annotations

from collections.abc import Mapping

from lagdsl.algebra.graph.operation import Group, Op
from lagdsl.derivation.program.functions import BY_NAME, OPTIONAL, SIGNATURES, WRITTEN_OUT
from lagdsl.derivation.program.lengths import counted, sizes
from lagdsl.derivation.program.program import Function, Layout, Program


class InvalidProgram(AssertionError):  # noqa: N818  it is an assertion
    """A program broke its own contract."""


def verify(program: Program) -> None:
    """Raise InvalidProgram unless every function is there once, with its signature, shapes and symbols."""
    _verify_layout(program.layout)
    _verify_rows(program)
    _verify_graph(program)
    names = [function.name for function in program.functions]
    by_columns = set(WRITTEN_OUT if program.has("momentum_tangent") else ())
    needed = SIGNATURES.keys() - by_columns
    complete = needed <= set(names) <= needed | OPTIONAL.keys()
    _require(complete and len(names) == len(set(names)), f"functions are {names}")
    lengths = {**sizes(program.layout), "nk": len(program.kept_rows), **counted(program)}
    for function in program.functions:
        _require(function.arguments == BY_NAME[function.name].arguments, f"signature of {function.name}")
        _verify_shapes(function, lengths)
        _verify_symbols(function, program)


def _verify_layout(layout: Layout) -> None:
    _require(len(layout.defaults) == len(layout.parameters), "one default per parameter")
    _require(len(layout.position_level) == len(layout.constraints), "one level per constraint row")
    _require(len(layout.redundant) == len(layout.constraints), "one redundancy flag per constraint row")
    members = len(layout.coordinates) + len(layout.states)
    _require(len(layout.components) in (0, members), "one component per coordinate and state")


def _verify_rows(program: Program) -> None:
    kept = program.kept_rows
    _require(list(kept) == sorted(set(kept)), "kept rows are not in order")
    _require(all(0 <= row < len(program.layout.constraints) for row in kept), "a kept row is no row")


def _verify_graph(program: Program) -> None:
    graph = program.graph
    for node in range(len(graph)):
        for argument in graph.arguments(node):
            _require(0 <= argument < node, f"node {node} is computed from node {argument}")


def _verify_shapes(function: Function, lengths: Mapping[str, int]) -> None:
    expected = BY_NAME[function.name].results
    _require(len(function.results) == len(expected), f"number of results of {function.name}")
    for block, result in zip(function.results, expected, strict=True):
        wanted = tuple(lengths[length] for length in result.shape)
        _require(block.shape == wanted, f"{block.name} of {function.name} has shape {block.shape}, not {wanted}")


def _verify_symbols(function: Function, program: Program) -> None:
    graph = program.graph
    roots = [node for block in function.results for node in block.nodes]
    _require(all(0 <= node < len(graph) for node in roots), f"a result of {function.name} is no node")
    for node in graph.live(roots):
        if graph.op[node] is Op.SYMBOL:
            group = graph.group(node)
            _require(group not in (Group.RELEASE, Group.RELEASE_RATE), f"{function.name} holds a release symbol")
            _require(group in function.arguments, f"{function.name} depends on {group.name}")
            _require(graph.b[node] < program.layout.size(group), f"{group.name}[{graph.b[node]}] in {function.name}")


def _require(condition: bool, what: str) -> None:
    if not condition:
        raise InvalidProgram(f"internal error: invalid program: {what}")
