"""Functions of several states, or of several directions at one state, in the lanes of vectors."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass

from lagdsl.backends.c.dialect import LANES, PRIMAL, SINGLE, Dialect, Place, directions
from lagdsl.backends.c.function import Code, Head, braced, code
from lagdsl.backends.c.results import RESULTS, Results, definition, results
from lagdsl.backends.c.statement import Store
from lagdsl.graph.graph import Graph
from lagdsl.graph.operation import DIRECTION_OF, Op
from lagdsl.program.program import Program

_OF_STATES = ("dynamics", "elimination")
_OF_DIRECTIONS = "residual_tangent"


@dataclass(frozen=True, slots=True)
class Parallel:
    """Functions, the members of lag_model that name them, and the length of the workspace with them (C expression)."""

    definitions: str
    members: tuple[str, ...]
    workspace: str


def without_lanes(program: Program, prepared: Mapping[int, Place], scratch: int) -> Parallel:
    """One state, one direction at a time."""
    del program
    return Parallel("", (), str(len(prepared) + scratch))


def in_lanes(program: Program, prepared: Mapping[int, Place], scratch: int) -> Parallel:
    """The dynamics of several states, and the tangent of the residual in several directions.

    Operations and their order are those of the functions of one state: every lane gets the same bits.
    """
    names = [name for name in _OF_STATES if program.has(name)]
    beyond = f"at->workspace + {len(prepared)} * LAG_LANES"
    made_for = [_function(program, name, prepared, LANES, beyond) for name in names]
    states = "".join(text for text, _ in made_for)
    of_states = max((made.scratch for _, made in made_for), default=0)
    function = program.function(_OF_DIRECTIONS)
    shared = _shared(program.graph, results(program, function, SINGLE).stores, prepared)
    stores = tuple(Store(place, node) for node, place in shared.items())
    head = Head(f"model_{_OF_DIRECTIONS}_values", ["const lag_arguments *at", f"double *{PRIMAL}"], ["at", PRIMAL])
    made = code(program.graph, stores, prepared, SINGLE, head)
    start = len(prepared) + max(scratch, made.scratch)
    primal = definition(head, made, Results(), SINGLE, f"at->workspace + {len(prepared)}") + braced(
        f"static lag_status model_{_OF_DIRECTIONS}_primal(const lag_arguments *at)",
        [f"return {head.name}(at, at->workspace + {start});"],
    )
    end = start + len(shared)
    given = {**prepared, **shared}
    along, of_along = _function(program, _OF_DIRECTIONS, given, directions(start), f"at->workspace + {end}")
    members = (
        ".lanes = LAG_LANES",
        *(f".{name}_lanes = model_{name}_lanes" for name in names),
        f".{_OF_DIRECTIONS}_lanes = model_{_OF_DIRECTIONS}_lanes",
        f".workspace_lanes = {len(prepared) + of_states} * LAG_LANES",
        f".{_OF_DIRECTIONS}_primal = model_{_OF_DIRECTIONS}_primal",
    )
    definitions = f"#if LAG_LANES\n\n{states}{primal}{along}#endif\n"
    return Parallel(definitions, ("#if LAG_LANES", *members, "#endif"), f"{end} + {of_along.scratch} * LAG_LANES")


def _function(
    program: Program, name: str, given: Mapping[int, Place], dialect: Dialect, scratch: str
) -> tuple[str, Code]:
    """A function in lanes, behind one that takes its results as arrays of numbers."""
    function = program.function(name)
    names = RESULTS[name]
    parameters = ["const lag_arguments *at", *(f"{dialect.memory} *{result}" for result in names)]
    head = Head(f"model_{name}_in_lanes", parameters, ["at", *names])
    contents = results(program, function, dialect)
    made = code(program.graph, contents.stores, given, dialect, head)
    outer = ", ".join(["const lag_arguments *at", *(f"double *{result}" for result in names)])
    inner = ", ".join(["at", *(f"({dialect.memory} *){result}" for result in names)])
    wrapped = braced(f"static lag_status model_{name}_lanes({outer})", [f"return {head.name}({inner});"])
    return definition(head, made, contents, dialect, scratch) + wrapped, made


def _shared(graph: Graph, stores: tuple[Store, ...], prepared: Mapping[int, Place]) -> dict[int, Place]:
    """Places of the values that do not depend on a direction and that something else needs."""
    along = sum(1 << group for group in DIRECTION_OF.values())
    wanted: dict[int, None] = {}
    for node in graph.live([store.node for store in stores], prepared):
        if graph.groups[node] & along:
            wanted.update(dict.fromkeys(graph.arguments(node)))
    wanted.update(dict.fromkeys(store.node for store in stores))
    nodes = sorted(
        node
        for node in wanted
        if not graph.groups[node] & along and node not in prepared and graph.op[node] not in (Op.CONSTANT, Op.SYMBOL)
    )
    return {node: Place(PRIMAL, index) for index, node in enumerate(nodes)}
