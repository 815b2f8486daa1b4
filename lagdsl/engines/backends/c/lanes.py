"""Functions of several states, or of several directions at one state, in the lanes of vectors: files of their own."""

from __future__ import annotations

from collections.abc import Mapping, Sequence

from lagdsl.algebra.graph.graph import Graph
from lagdsl.algebra.graph.operation import FIRST_UNARY, Group
from lagdsl.derivation.program.passes.along import along, shared
from lagdsl.derivation.program.passes.hoist import hoisted
from lagdsl.derivation.program.program import Block, Function, Program
from lagdsl.engines.backends.c.dialect import LANES, PREPARED, PRIMAL, SINGLE, Dialect, Place, directions
from lagdsl.engines.backends.c.function import FUSED, Code, Head, braced, code
from lagdsl.engines.backends.c.results import Results, definition, names_of, results
from lagdsl.engines.backends.c.statement import Store
from lagdsl.engines.backends.identifier import comment_text

_FUSED = (*FUSED, "acceleration_tangent")
# Numbers in the longest vector: arrays of vectors start at multiples of it.
_WIDEST = 8


def states_source(program: Program, stem: str) -> str:
    """Text of a file that defines `stem`_states, of type lag_states."""
    prepared = _prepared(program)
    beyond = f"at->workspace + {len(prepared)} * LAG_LANES"
    stores = tuple(Store(Place("result", place.index), node) for node, place in prepared.items())
    head = Head("model_prepare_from", ["const lag_arguments *at", "lag_lanes_memory *result"], ["at", "result"])
    made = code(program.graph, stores, {}, LANES, head)
    body = ["return model_prepare_from(at, (lag_lanes_memory *)at->workspace);"]
    texts = [
        definition(head, made, Results(), LANES, beyond),
        braced("static lag_status model_prepare(const lag_arguments *at)", body),
    ]
    scratch, members = made.scratch, [".prepare = model_prepare"]
    for name in _of_states(program):
        text, made = _function(program, program.function(name), prepared, LANES, beyond)
        texts.append(text)
        scratch = max(scratch, made.scratch)
        members.append(f".{name} = model_{name}_lanes")
    members.append(f".workspace = {len(prepared) + scratch} * LAG_LANES")
    return _file(program, stem, "states", texts, members)


def tangents_source(program: Program, stem: str, *, parameters: bool) -> str:
    """Text of a file that defines `stem`_tangents or, along directions dp only, `stem`_parameter_tangents."""
    found = along(program, parameters=parameters)
    functions, motion = found.functions, found.motion
    prepared = _prepared(program)
    values = _shared(program.graph, [results(program, f, SINGLE) for f in functions.values()], prepared)
    start = len(prepared)
    end = -(-(start + len(values)) // _WIDEST) * _WIDEST
    primal, alone = _primal(program, prepared, values, motion, f"at->workspace + {end}")
    texts, members, scratch = [primal], [f".{'motion' if motion else 'primal'} = model_primal"], 0
    for name, function in functions.items():
        text, made = _function(program, function, {**prepared, **values}, directions(start), f"at->workspace + {end}")
        texts.append(text)
        scratch = max(scratch, made.scratch)
        members.append(f".{name} = model_{function.name}_lanes")
    members.append(f".workspace = {end + alone} + {scratch} * LAG_LANES")
    return _file(program, stem, "parameter_tangents" if parameters else "tangents", texts, members)


def _primal(
    program: Program,
    prepared: Mapping[int, Place],
    values: Mapping[int, Place],
    motion: tuple[Block, ...],
    scratch: str,
) -> tuple[str, int]:
    """A function that leaves the shared values behind what is prepared, and tells the motion; and its scratch."""
    names = ("qdd", "lam", "pivot") if motion else ()
    stores = [Store(place, node) for node, place in values.items()]
    for name, block in zip(names, motion, strict=True):
        stores += [Store(Place(name, index), node) for index, node in enumerate(block.elements)]
    results = [f"double *{name}" for name in names]
    head = Head("model_values", ["const lag_arguments *at", f"double *{PRIMAL}", *results], ["at", PRIMAL, *names])
    made = code(program.graph, tuple(stores), prepared, SINGLE, head)
    signature = f"static lag_status model_primal({', '.join(['const lag_arguments *at', *results])})"
    call = f"return model_values({', '.join(['at', f'at->workspace + {len(prepared)}', *names])});"
    return definition(head, made, Results(), SINGLE, scratch) + braced(signature, [call]), made.scratch


def _of_states(program: Program) -> tuple[str, ...]:
    """Nobody asks for the equations where elimination solves them, nor for rates of states and conditions where there
    are none."""
    equations = "elimination" if program.has("elimination") else "dynamics"
    rates = ("state_derivative",) if program.layout.size(Group.Z) else ()
    return (equations, *rates, *(("monitor",) if program.has("monitor") else ()))


def _prepared(program: Program) -> dict[int, Place]:
    return {node: Place(PREPARED, index) for index, node in enumerate(hoisted(program))}


def _function(
    program: Program, function: Function, given: Mapping[int, Place], dialect: Dialect, scratch: str
) -> tuple[str, Code]:
    """A function in lanes, behind one that takes its results as arrays of numbers."""
    contents = results(program, function, dialect)
    names = names_of(function.name)
    parameters = ["const lag_arguments *at", *(f"{dialect.memory} *{result}" for result in names)]
    head = Head(f"model_{function.name}_in_lanes", parameters, ["at", *names], function.name in _FUSED)
    made = code(program.graph, contents.stores, given, dialect, head)
    outer = ", ".join(["const lag_arguments *at", *(f"double *{result}" for result in names)])
    inner = ", ".join(["at", *(f"({dialect.memory} *){result}" for result in names)])
    wrapped = braced(f"static lag_status model_{function.name}_lanes({outer})", [f"return {head.name}({inner});"])
    return definition(head, made, contents, dialect, scratch) + wrapped, made


def _shared(graph: Graph, contents: Sequence[Results], prepared: Mapping[int, Place]) -> dict[int, Place]:
    """Places of the values that do not depend on a direction and that something else needs."""
    roots = [store.node for each in contents for store in each.stores]
    nodes = [node for node in shared(graph, roots, prepared) if graph.op[node] >= FIRST_UNARY]
    return {node: Place(PRIMAL, index) for index, node in enumerate(nodes)}


def _file(program: Program, stem: str, kind: str, texts: Sequence[str], members: Sequence[str]) -> str:
    name = f"const lag_{kind.removeprefix('parameter_')} {stem}_{kind}"
    table = "".join(f"    {member},\n" for member in (".lanes = LAG_LANES", ".width = LAG_LANES", *members))
    return "\n".join(
        [
            f"/* {kind.replace('_', ' ')} of {comment_text(program.name)} in lanes, generated: see lag/parallel.h. */",
            "#include <math.h>\n",
            '#include "lag/parallel.h"\n#include "lag/trigonometry.h"\n',
            f"extern {name};\n",
            "#if LAG_LANES\n",
            *texts,
            f"{name} = {{\n{table}}};\n",
            "#else\n",
            f"{name} = {{0}};\n",
            "#endif\n",
        ]
    )
