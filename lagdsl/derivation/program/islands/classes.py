"""Islands that differ in numbers only share one program: of N balls on one floor there is one."""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from dataclasses import replace
from functools import cache

import numpy as np

from lagdsl.algebra.graph.graph import Graph
from lagdsl.algebra.graph.operation import FIRST_BINARY, FIRST_TERNARY, Group, Op
from lagdsl.derivation.program.islands.code import Code, Coder
from lagdsl.derivation.program.islands.partition import Island, partition
from lagdsl.derivation.program.islands.shares import NotSeparable
from lagdsl.derivation.program.program import Function, Instants, Layout, Program, Slot, whole_block
from lagdsl.foundation.numerics.rank import Floats
from lagdsl.foundation.record import record, remembered


@record()
class Member:
    """An island of a class. Its parameters are those of the whole program at the places `parameters`, then its own
    `numbers`; its inputs are those at the places `inputs`."""

    island: Island
    parameters: Sequence[int]
    inputs: Sequence[int]
    numbers: Floats


@record()
class IslandClass:
    """Islands with one program, whose names are numbers."""

    program: Program
    members: tuple[Member, ...]


@remembered
def island_classes(program: Program) -> tuple[IslandClass, ...]:
    """Empty where everything in the program moves together."""
    parts = partition(program)
    if parts is None:
        return ()
    coder = Coder(program, parts)
    alike: dict[object, list[tuple[Island, Code]]] = {}
    try:
        for number, island in enumerate(parts.islands):
            code = coder.code(number)
            layout = _layout(program.layout, island, code)
            key = code.instructions, code.roots, code.shapes, layout, _kept(program, island)
            alike.setdefault(key, []).append((island, code))
    except NotSeparable:
        return ()
    return tuple(_class(program, group) for group in alike.values())


def _class(program: Program, group: Sequence[tuple[Island, Code]]) -> IslandClass:
    island, code = group[0]
    table = np.array([each.constants for _, each in group])
    places = dict[bytes, int]()  # columns that are alike are one number
    columns: list[int | None] = []
    for column in table.T:
        same = bool(np.all(column == column[0]))
        columns.append(None if same else places.setdefault(column.tobytes(), len(places)))
    numbers = np.array([np.frombuffer(column) for column in places]).reshape(len(places), len(group)).T
    members = tuple(
        Member(each, own.parameters, own.inputs, values)
        for (each, own), values in zip(group, np.ascontiguousarray(numbers), strict=True)
    )
    graph = Graph()
    nodes = _nodes(graph, code, columns)
    functions = tuple(
        Function(
            name=function.name,
            arguments=function.arguments,
            results=tuple(
                whole_block(block.name, shape, [nodes[k] for k in roots])
                for block, shape, roots in zip(function.results, shapes, own, strict=True)
            ),
        )
        for function, shapes, own in zip(program.functions, code.shapes, code.roots, strict=True)
    )
    count = len(code.parameters) + len(places)
    slots = tuple(Slot(name=f"p{k}") for k in range(count))
    layout = replace(_layout(program.layout, island, code), parameters=slots, defaults=(0.0,) * count)
    kept = _kept(program, island)
    name = program.name
    return IslandClass(Program(name=name, layout=layout, graph=graph, functions=functions, kept_rows=kept), members)


def _nodes(graph: Graph, code: Code, columns: Sequence[int | None]) -> list[int]:
    """The node of each instruction; a constant that has a place in `columns` is a parameter."""
    nodes: list[int] = []
    constants = iter(zip(code.constants, columns, strict=True))
    for op, *operands in code.instructions:
        if op == Op.CONSTANT:
            value, place = next(constants)
            own = None if place is None else len(code.parameters) + place
            nodes.append(graph.constant(value) if own is None else graph.symbol(Group.P, own))
        elif op == Op.SYMBOL:
            nodes.append(graph.symbol(Group(operands[0]), operands[1]))
        else:
            nodes.append(_made(graph, Op(op), [nodes[k] for k in operands]))
    return nodes


def _made(graph: Graph, op: Op, operands: Sequence[int]) -> int:
    if op < FIRST_BINARY:
        return graph.unary(op, operands[0])
    if op < FIRST_TERNARY:
        return graph.binary(op, operands[0], operands[1])
    return graph.select(operands[0], operands[1], operands[2])


# ---- the layout ------------------------------------------------------------------------------------------------------


def _slots(name: str, slots: Sequence[Slot], places: Iterable[int]) -> tuple[Slot, ...]:
    """The slots at `places`, numbered."""
    return tuple(_slot(f"{name}{k}", slots[place].unit) for k, place in enumerate(places))


@cache
def _slot(name: str, unit: str) -> Slot:
    return Slot(name=name, unit=unit)


def _kept(program: Program, island: Island) -> tuple[int, ...]:
    local = _local(island, "nc")
    return tuple(local[program.kept_rows[k]] for k in island.places["nk"].tolist())


def _local(island: Island, axis: str) -> Mapping[int, int]:
    return {place: k for k, place in enumerate(island.places[axis].tolist())}


def _layout(whole: Layout, island: Island, code: Code) -> Layout:
    """Without parameters."""

    def of(axis: str, values: Sequence[object]) -> tuple[object, ...]:
        return tuple(values[k] for k in island.places[axis].tolist()) if values else ()

    n = len(whole.coordinates)
    moving = [*island.places["nq"].tolist(), *(n + island.places["nz"]).tolist()]
    names: dict[int, int] = {}
    components = tuple(names.setdefault(whole.components[k], len(names)) for k in moving) if whole.components else ()

    def slots(axis: str, slots: Sequence[Slot]) -> tuple[Slot, ...]:
        return _slots(axis[1], slots, island.places[axis].tolist())

    return Layout(
        coordinates=slots("nq", whole.coordinates),
        states=slots("nz", whole.states),
        inputs=_slots("u", whole.inputs, code.inputs),
        discretes=slots("nw", whole.discretes),
        kinds=of("nw", whole.kinds),  # type: ignore[arg-type]
        instants=_instants(whole.instants, whole, island, code),
        parameters=(),
        defaults=(),
        outputs=slots("ny", whole.outputs),
        constraints=slots("nc", whole.constraints),
        position_level=of("nc", whole.position_level),  # type: ignore[arg-type]
        row_factors=of("nc", whole.row_factors),  # type: ignore[arg-type]
        redundant=of("nc", whole.redundant),  # type: ignore[arg-type]
        invariants=slots("ni", whole.invariants),
        assertions=("",) * island.count("na"),
        components=components,
        speeds=tuple(whole.speeds[k] for k in code.inputs) if whole.speeds else (),
    )


def _instants(whole: Instants, layout: Layout, island: Island, code: Code) -> Instants:
    rows, contacts = _local(island, "nc"), _local(island, "ncontact")
    n, own = len(layout.coordinates), island.count("nq")
    places = {place: k for k, place in enumerate(island.places["nq"].tolist())}
    places = places | {n + place: own + k for place, k in places.items()}
    places |= {2 * n + place: 2 * own + k for place, k in _local(island, "nz").items()}

    def flags(axis: str, values: Sequence[bool]) -> tuple[bool, ...]:
        found = tuple(values[k] for k in island.places[axis].tolist()) if values else ()
        return found if any(found) else ()

    def listed(axis: str, values: Sequence[int]) -> list[int]:
        return [values[k] for k in island.places[axis].tolist()] if values else []

    whole_inputs = tuple(whole.whole_inputs[k] for k in code.inputs) if whole.whole_inputs else ()
    return Instants(
        strict=tuple(whole.strict[k] for k in island.places["nindicator"].tolist()),
        jumping=tuple(whole.jumping[k] for k in island.places["nindicator"].tolist()),
        whole_inputs=whole_inputs if any(whole_inputs) else (),
        contact_rows=tuple(rows[row] for row in listed("ncontact", whole.contact_rows)),
        one_way=flags("ncontact", whole.one_way),
        frictions=("",) * island.count("nfriction"),
        friction_rows=tuple(rows[row] for row in listed("nslip", whole.friction_rows)),
        friction_slips=tuple(listed("nfriction", whole.friction_slips)),
        friction_contacts=tuple(
            contacts.get(each, len(contacts)) for each in listed("nfriction", whole.friction_contacts)
        ),
        switched_rows=tuple(rows[row] for row in whole.switched_rows if row in rows),
        resets=("",) * island.count("nreset"),
        reset_places=tuple(places[place] for place in listed("nreset", whole.reset_places)),
        failures=("",) * island.count("nfail"),
    )
