"""Symbols of a program as variables of Modelica, and their declarations."""

from __future__ import annotations

from collections.abc import Iterable

from lagdsl.algebra.graph.graph import Graph
from lagdsl.algebra.graph.operation import Group
from lagdsl.engines.backends.modelica.clauses import is_truth, previous
from lagdsl.engines.backends.modelica.expressions import literal
from lagdsl.engines.backends.modelica.names import own, quoted, text
from lagdsl.foundation.units.dimension import TIME
from lagdsl.foundation.units.naming import rate_text
from lagdsl.language.flat.events import Delay, entries
from lagdsl.language.flat.model import FlatModel, Input, Parameter
from lagdsl.language.flat.quantity import Quantity

STABILIZATION = own("stabilization")


def rate(name: str) -> str:
    """The identifier of the rate of a coordinate."""
    return quoted(f"der({name})")


def acceleration(name: str) -> str:
    """The identifier of the acceleration of a coordinate."""
    return quoted(f"der(der({name}))")


def multiplier(row: str) -> str:
    """The identifier of the multiplier of a constraint row."""
    return quoted(f"multiplier({row})")


def independent(flat: FlatModel) -> list[Parameter]:
    """The parameters that are not numbers of the equations, in the order of p."""
    return [each for each in flat.parameters if not each.structural]


def leaves(graph: Graph, flat: FlatModel) -> dict[int, str]:
    """The text of every symbol; of entries of w that Modelica knows by itself, what it says for them."""
    rows = [row for constraint in flat.constraints for row in constraint.rows]
    groups: dict[Group, Iterable[str]] = {
        Group.TIME: ["time"],
        Group.Q: [quoted(each.name) for each in flat.coordinates],
        Group.QD: [rate(each.name) for each in flat.coordinates],
        Group.QDD: [acceleration(each.name) for each in flat.coordinates],
        Group.Z: [quoted(each.name) for each in flat.states],
        Group.U: [quoted(each.name) for each in flat.inputs],
        Group.P: [*(quoted(each.name) for each in independent(flat)), STABILIZATION],
        Group.LAMBDA: [multiplier(row) for row in rows],
    }
    found = {graph.symbol(group, k): name for group, names in groups.items() for k, name in enumerate(names)}
    for index, entry in enumerate(entries(flat.events)):
        name = entry.name if entry.kind == "instant" else quoted(entry.name)
        if entry.kind == "delay_rate" and isinstance(entry.item, Delay):
            name = f"der({quoted(entry.item.name)})"
        found[graph.symbol(Group.W, index)] = name
        found[previous(graph, flat, index)] = f"pre({name})"
    return found


def truths(graph: Graph, flat: FlatModel) -> list[int]:
    """The symbols that are Boolean."""
    found = [graph.symbol(Group.U, k) for k, each in enumerate(flat.inputs) if each.base == "Boolean"]
    found += [graph.symbol(Group.P, k) for k, each in enumerate(independent(flat)) if each.kind == "Boolean"]
    for index, entry in enumerate(entries(flat.events)):
        if is_truth(entry, flat):
            found += [graph.symbol(Group.W, index), previous(graph, flat, index)]
    return found


def declaration(
    kind: str, name: str, attributes: list[tuple[str, str]], value: str = "", doc: str | None = None
) -> str:
    """`kind name(attributes) = value "doc";`."""
    inside = ", ".join(f"{key} = {given}" for key, given in attributes)
    words = f" {text(doc)}" if doc else ""
    return f"{kind} {name}{f'({inside})' if inside else ''}{f' = {value}' if value else ''}{words};"


def unit(of: str) -> list[tuple[str, str]]:
    return [("unit", text(of))]


def bounds(item: Parameter | Input) -> list[tuple[str, str]]:
    """`min`, `max` and `nominal` as they are given."""
    given = (("min", item.minimum), ("max", item.maximum), ("nominal", item.nominal))
    return [(key, literal(value)[0]) for key, value in given if value is not None]


def typed(base: str, value: float) -> tuple[str, str]:
    """Type and value of an input or a parameter; an enumeration is the number of its literal."""
    match base:
        case "Boolean":
            return "Boolean", "true" if value != 0.0 else "false"
        case "Integer" | "Enumeration":
            return "Integer", literal(value)[0]
        case _:
            return "Real", literal(value)[0]


def units_of_motion(item: Quantity) -> tuple[str, str, str]:
    """Units of a coordinate, its rate and its acceleration."""
    rate_unit = rate_text(item.dimension, item.unit)
    return item.unit, rate_unit, rate_text(item.dimension / TIME, rate_unit)
