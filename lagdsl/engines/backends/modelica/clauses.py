"""`when` clauses and what they read, on the graph: a discrete variable means its new value there, `pre` its old one."""

from __future__ import annotations

from typing import TypeAlias

from lagdsl.algebra.graph.graph import Graph
from lagdsl.algebra.graph.operation import Group
from lagdsl.derivation.mechanics.equations import Equations
from lagdsl.derivation.mechanics.events import renamed
from lagdsl.derivation.program.program import Program
from lagdsl.foundation.record import record
from lagdsl.language.flat.events import Assign, Branch, Check, Entry, Impact, Memory, Reset, Terminate, entries
from lagdsl.language.flat.model import FlatModel


@record()
class Action:
    """An action of a branch with its nodes: `value` is what is assigned, where a state goes, or the condition of an
    assertion; a `guard` decides whether it acts."""

    item: Assign | Reset | Terminate | Check
    value: int | None
    guard: int | None


@record()
class Clause:
    """A branch: it acts where one of `conditions` becomes true."""

    conditions: tuple[int, ...]
    actions: tuple[Action, ...]


Clauses: TypeAlias = "tuple[tuple[Clause, ...], ...]"


def previous(graph: Graph, flat: FlatModel, index: int) -> int:
    """The symbol of the value that an entry of w had before the event: symbols after those of w."""
    return graph.symbol(Group.W, len(entries(flat.events)) + index)


def clauses(equations: Equations) -> Clauses:
    """Every `when` of the model, branch by branch. Models with `impact` have none of these forms."""
    flat, graph = equations.flat, equations.graph
    lowering = renamed(equations.lowering, flat, {})
    names = lowering.symbols.previous
    lowering.symbols.previous = {name: previous(graph, flat, index) for index, name in enumerate(names)}

    def branch_of(branch: Branch) -> Clause:
        actions = []
        for action in branch.actions:
            assert not isinstance(action, Impact)
            guard = None if action.guard is None else lowering.scalar(action.guard)
            actions.append(Action(action, value_of(action), guard))
        return Clause(tuple(lowering.scalar(each) for each in branch.conditions), tuple(actions))

    def value_of(action: Assign | Reset | Terminate | Check) -> int | None:
        match action:
            case Assign(value=value) | Reset(value=value) | Check(condition=value):
                return lowering.scalar(value)
            case Terminate():
                return None

    return tuple(tuple(branch_of(branch) for branch in when.branches) for when in flat.events.whens)


def nodes_of(found: Clauses) -> list[int]:
    """All nodes of clauses."""
    every = [clause for when in found for clause in when]
    conditions = [node for clause in every for node in clause.conditions]
    given = [node for clause in every for action in clause.actions for node in (action.value, action.guard)]
    return [*conditions, *(node for node in given if node is not None)]


def standing(equations: Equations, program: Program) -> dict[str, int]:
    """Entries of w that relations and the time decide, and values of which `pre` is read, as they are now, by name:
    truths, and numbers."""
    flat = equations.flat
    found: dict[str, int] = {}
    if not entries(flat.events):
        return found
    (after,) = program.function("standing").results
    for entry, node in zip(entries(flat.events), after.elements, strict=True):
        if entry.kind in ("relation", "timed"):
            found[entry.name] = node
    return found | {each.name: equations.lowering.scalar(each.value) for each in flat.events.memories}


def is_truth(entry: Entry, flat: FlatModel) -> bool:
    """True if an entry of w is Boolean in Modelica."""
    match entry.kind:
        case "variable":
            return any(each.name == entry.name and each.kind == "Boolean" for each in flat.events.discretes)
        case "timed":
            return any(each.name == entry.name and each.kind == "relation" for each in flat.events.timed)
        case "condition":
            return not isinstance(entry.item, Memory) or entry.item.truth
        case "contact" | "sticks" | "relation" | "clock" | "instant":
            return True
        case "impacts" | "direction" | "delay" | "delay_rate" | "load":
            return False
