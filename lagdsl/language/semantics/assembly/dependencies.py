"""Dependencies of an expression: frames without a binding, and coordinates, also through definitions."""

from __future__ import annotations

from typing import TypeAlias

from lagdsl.language.semantics.assembly.paths import Element, inner_texts, target_of
from lagdsl.language.semantics.scope.context import Context
from lagdsl.language.semantics.scope.scope import Binding, Indices, Scope, Symbol
from lagdsl.language.semantics.variables.resolver import every
from lagdsl.language.syntax import nodes

Key: TypeAlias = "tuple[Symbol, Indices]"
# Dictionaries are used as ordered sets.
Needs: TypeAlias = "tuple[dict[Key, None], dict[Symbol, None]]"


class Dependencies:
    """Finds what expressions mention; every symbol is searched once."""

    def __init__(self, ctx: Context) -> None:
        self._ctx = ctx
        self._of: dict[Symbol, Needs] = {}

    def of(self, scope: Scope, node: nodes.Node) -> Needs:
        """The frames without a binding and the coordinates below `node`, in the order of the text."""
        frames: dict[Key, None] = {}
        coordinates: dict[Symbol, None] = {}
        stack = [(scope, node)]
        while stack:
            at, current = stack.pop()
            target = None
            if isinstance(current, nodes.Reference | nodes.Member | nodes.Index):
                target = target_of(self._ctx, at, current)
            if isinstance(target, Element):
                self._element(target, frames, coordinates)
            else:
                stack.extend(reversed(list(inner_texts(self._ctx, at, current))))
        return frames, coordinates

    def of_binding(self, binding: Binding) -> Needs:
        return self.of(binding.scope, binding.node)

    def _element(self, target: Element, frames: dict[Key, None], coordinates: dict[Symbol, None]) -> None:
        symbol = target.symbol
        if symbol.kind == "coordinate":
            coordinates[symbol] = None
            return
        if symbol.kind == "frame":
            wanted = (
                [target.indices]
                if target.indices is not None
                else every(self._ctx.resolver.shape(self._ctx, symbol) or ())
            )
            frames.update({(symbol, each): None for each in wanted if each not in symbol.given.bindings})
        if symbol.kind in ("frame", "point", "algebraic", "output", "input"):
            further = self._behind(symbol)
            frames.update(further[0])
            coordinates.update(further[1])

    def _behind(self, symbol: Symbol) -> Needs:
        """Dependencies of a symbol's bindings. One that needs itself (an array built along itself) adds nothing."""
        if symbol not in self._of:
            found: Needs = ({}, {})
            self._of[symbol] = found
            for binding in symbol.given.bindings.values():
                frames, coordinates = self.of_binding(binding)
                found[0].update(frames)
                found[1].update(coordinates)
        return self._of[symbol]
