"""Every `connect`: of frames, of coordinates, of connectors."""

from __future__ import annotations

from collections.abc import Sequence

from lagdsl.language.semantics.assembly.chains import Chains, refuse
from lagdsl.language.semantics.assembly.merges import Merges
from lagdsl.language.semantics.assembly.networks import Networks
from lagdsl.language.semantics.assembly.paths import Absent, Element, Target, target_of
from lagdsl.language.semantics.operators.conditions import condition_of
from lagdsl.language.semantics.scope.context import Context
from lagdsl.language.semantics.scope.scope import Instance, Scope
from lagdsl.language.semantics.scope.values import Scalar
from lagdsl.language.syntax import nodes


class Connections:
    """Tells the kinds of `connect` apart by what stands first."""

    def __init__(self, ctx: Context, chains: Chains, merges: Merges, networks: Networks) -> None:
        self._ctx, self._chains, self._merges, self._networks = ctx, chains, merges, networks

    def connect(self, scope: Scope, node: nodes.Connect) -> None:
        condition = condition_of(self._ctx, scope, node.condition)
        if isinstance(condition, Scalar) and node.condition is not None:
            self._ctx.sink.report("E0330", node.condition.span, what="a `connect`")
        if condition is not True:
            return
        targets = [(item, target_of(self._ctx, scope, item)) for item in node.items]
        there = [(item, target) for item, target in targets if not isinstance(target, Absent)]
        if there and (_is_coordinate(there[0][1]) or _is_connector(there[0][1])):
            self._unite(scope, node, there, complete=len(there) == len(targets))
        else:
            self._chains.connect(scope, node)

    def _unite(
        self,
        scope: Scope,
        node: nodes.Connect,
        items: Sequence[tuple[nodes.Expression, Target | None]],
        *,
        complete: bool,
    ) -> None:
        """Coordinates become one coordinate, connectors one node."""
        first = items[0][1]
        joined = not complete
        for item, target in items[1:]:
            done: bool | None = None
            if isinstance(first, Element) and isinstance(target, Element) and _is_coordinate(target):
                done = self._merges.unite(first.symbol, first.indices, target.symbol, target.indices, node.span)
            elif isinstance(first, Instance) and isinstance(target, Instance) and _is_connector(target):
                done = self._networks.unite(first, target, node.span)
            else:
                what = "connector" if isinstance(first, Instance) else "coordinate"
                refuse(self._ctx, scope, item, f"no {what} like `{items[0][0].span.text}`")
            if done is None:
                return
            joined |= done
        if not joined:
            self._ctx.sink.report("W0709", node.span)


def _is_coordinate(target: Target | None) -> bool:
    return isinstance(target, Element) and target.symbol.kind == "coordinate"


def _is_connector(target: Target | None) -> bool:
    return isinstance(target, Instance) and target.kind == "connector"
