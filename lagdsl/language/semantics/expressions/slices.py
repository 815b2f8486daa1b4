"""Members of arrays of components: `wheel.spin` and `wheel[2:3].spin` are arrays of what each component has."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from itertools import product as cartesian

from lagdsl.language.semantics.operators import arrays
from lagdsl.language.semantics.operators.paths import designated, member_of
from lagdsl.language.semantics.scope.context import Context
from lagdsl.language.semantics.scope.scope import Entry, Indices, Instance, InstanceArray, Scope
from lagdsl.language.semantics.scope.values import Value
from lagdsl.language.syntax import nodes

Components = tuple[Indices, list[Instance]]
"""Components in row-major order, with the shape of their array."""


def of_several(
    ctx: Context, scope: Scope, node: nodes.Member, value: Callable[[Context, Entry, nodes.Expression], Value]
) -> Value | None:
    """The member of all components that the text before the dot names; None where that is not an array of them."""
    found = _components(ctx, scope, node.target)
    if found is None or not found[0]:
        return None
    shape, components = found
    values: list[tuple[nodes.Node, Value]] = []
    for component in components:
        entry = member_of(ctx, component, node.name, node.name_span)
        if isinstance(entry, Instance | InstanceArray):
            return None
        values.append((node, value(ctx, entry, node)))
    for extent in reversed(shape[1:]):
        rows = [values[k : k + extent] for k in range(0, len(values), extent)]
        values = [(node, arrays.stacked(ctx, scope, node, row)) for row in rows]
    return arrays.stacked(ctx, scope, node, values)


def _components(ctx: Context, scope: Scope, node: nodes.Expression) -> Components | None:
    """The components that `node` names; None where it names something else. Subscripts belong to the last name."""
    subscripts: Sequence[nodes.Subscript] = ()
    name = node
    if isinstance(node, nodes.Index):
        subscripts, name = node.subscripts, node.target
    around: Components = (), []
    if isinstance(name, nodes.Reference):
        entries = [designated(ctx, scope, name)]
    elif isinstance(name, nodes.Member):
        before = _components(ctx, scope, name.target)
        if before is None or any(name.name in each.protected for each in before[1]):
            return None
        around = before
        entries = [each.scope.entries.get(name.name) for each in before[1]]
    else:
        return None
    shapes: set[Indices] = set()
    found: list[Instance] = []
    for entry in entries:
        part = _chosen(ctx, scope, node, entry, tuple(subscripts))
        if part is None:
            return None
        shapes.add(part[0])
        found += part[1]
    if len(shapes) != 1:
        return None
    return (*around[0], *shapes.pop()), found


def _chosen(
    ctx: Context, scope: Scope, node: nodes.Expression, entry: Entry | None, subscripts: tuple[nodes.Subscript, ...]
) -> Components | None:
    if isinstance(entry, Instance):
        return ((), [entry]) if not subscripts and entry.present else None
    if not isinstance(entry, InstanceArray):
        return None
    found = arrays.subscript_indices(ctx, scope, subscripts, entry.shape, node) if subscripts else []
    if found is None:
        return None
    full = [*found, *(tuple(range(1, extent + 1)) for extent in entry.shape[len(found) :])]
    shape = tuple(len(each) for each in full if not isinstance(each, int))
    picked = [entry.elements.get(indices) for indices in _each(full)]
    present = [each for each in picked if each is not None and each.present]
    return (shape, present) if len(present) == len(picked) else None


def _each(full: Sequence[int | tuple[int, ...]]) -> Iterator[Indices]:
    yield from cartesian(*((each,) if isinstance(each, int) else each for each in full))
