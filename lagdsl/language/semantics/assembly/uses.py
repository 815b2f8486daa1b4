"""Finds the coordinates whose values matter, not only their rates or virtual displacements.

An angle computed from frames is known up to whole turns: good for a torque on it and for its rate, wrong for a spring
that is wound up further.
"""

from __future__ import annotations

from lagdsl.language.semantics.assembly.paths import Element, inner_texts, target_of, texts_of
from lagdsl.language.semantics.scope.contents import Contents
from lagdsl.language.semantics.scope.context import Context
from lagdsl.language.semantics.scope.scope import Binding, Scope, Symbol
from lagdsl.language.syntax import nodes
from lagdsl.language.syntax.walk import children

_READ = ("frame", "point", "algebraic", "output", "input", "energy", "load")


class Uses:
    """Searches all that acts on the motion, through definitions; outputs and drawings do not count.

    `values` are the angles found, `required` those that must be unknowns whatever it costs.
    """

    def __init__(self, ctx: Context) -> None:
        self._ctx = ctx
        self._seen: set[tuple[Symbol, bool]] = set()
        self.values: set[Symbol] = set()
        self.required: set[Symbol] = set()

    def search(self, contents: Contents) -> None:
        for placed in (*contents.items, *contents.initial, *contents.closure):
            if not isinstance(placed.node, nodes.Draw):
                self._item(placed.scope, placed.node)
            self._momenta(placed.scope, placed.node)
        for symbol in contents.symbols:
            for binding in symbol.given.derivatives.values():
                self._walk(binding.scope, binding.node)
            for binding in symbol.given.bindings.values():
                self._momenta(binding.scope, binding.node)
                if symbol.kind == "output":
                    self._walk(binding.scope, binding.node)

    def _momenta(self, scope: Scope, node: nodes.Node) -> None:
        """`momentum(q)` belongs to an unknown of the equations of motion."""
        if "momentum" not in node.span.text:  # most texts: no need to walk them
            return
        for at, part in texts_of(self._ctx, scope, node):
            if _is_call(part, "momentum"):
                assert isinstance(part, nodes.Call)
                argument = part.arguments[0]
                target = target_of(self._ctx, at, argument) if not isinstance(argument, nodes.Named) else None
                if isinstance(target, Element):
                    self.required.add(target.symbol)

    def _item(self, scope: Scope, item: nodes.Item) -> None:
        targets = [item.on, item.origin] if isinstance(item, nodes.Load) and item.at is None else []
        for part in children(item):
            if any(part is target for target in targets):
                self._displaced(scope, part)
            else:
                self._walk(scope, part)

    def _walk(self, scope: Scope, node: nodes.Node) -> None:
        stack = [(scope, node)]
        while stack:
            at, current = stack.pop()
            target = None
            if isinstance(current, nodes.Reference | nodes.Member | nodes.Index):
                target = target_of(self._ctx, at, current)
            if isinstance(target, Element):
                self._read(target.symbol, displaced=False)
            elif _is_call(current, "der"):
                assert isinstance(current, nodes.Call)
                self._displaced(at, current.arguments[0])
            else:
                stack.extend(inner_texts(self._ctx, at, current))

    def _displaced(self, scope: Scope, node: nodes.Node) -> None:
        """A text of which only the derivative matters: harmless where it is the name of a coordinate."""
        target = None
        if isinstance(node, nodes.Reference | nodes.Member | nodes.Index | nodes.Parenthesized):
            target = target_of(self._ctx, scope, node)
        if isinstance(target, Element):
            self._read(target.symbol, displaced=True)
        else:
            self._walk(scope, node)

    def _read(self, symbol: Symbol, *, displaced: bool) -> None:
        if symbol.kind == "coordinate":
            if not displaced and _may_wind(symbol):
                self.values.add(symbol)
            return
        if symbol.kind not in _READ or (symbol, displaced) in self._seen:
            return
        self._seen.add((symbol, displaced))
        for binding in symbol.given.bindings.values():
            self._behind(binding, displaced=displaced)
        for label in symbol.made.labels.values():
            self._item(label.scope, label.node)

    def _behind(self, binding: Binding, *, displaced: bool) -> None:
        if displaced:
            self._displaced(binding.scope, binding.node)
        else:
            self._walk(binding.scope, binding.node)


def _may_wind(symbol: Symbol) -> bool:
    """True if whole turns may be counted in it: angles and quaternions, not lengths."""
    return symbol.info is None or symbol.info.dimension is None or symbol.info.dimension.is_dimensionless


def _is_call(node: nodes.Node, function: str) -> bool:
    return (
        isinstance(node, nodes.Call)
        and isinstance(node.function, nodes.Reference)
        and node.function.name == function
        and len(node.arguments) == 1
    )
