"""Laws under labels, each made once: constraints, contacts, frictions; and the guard against circles of definitions."""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import contextmanager
from itertools import pairwise

from lagdsl.foundation.diagnostics import Label
from lagdsl.foundation.source import Span
from lagdsl.language.flat import model as flat_model
from lagdsl.language.semantics.items import constraints, contacts, frictions
from lagdsl.language.semantics.scope.context import Context
from lagdsl.language.semantics.scope.naming import element_name
from lagdsl.language.semantics.scope.scope import Indices, LabelInstance, Symbol
from lagdsl.language.semantics.scope.values import POISON, ContactValue, FrictionValue
from lagdsl.language.syntax import nodes


class Laws:
    """The part of the resolver for laws that have labels."""

    def __init__(self) -> None:
        self._constraints: dict[tuple[Symbol, Indices], flat_model.Constraint | None] = {}
        self._contacts: dict[tuple[Symbol, Indices], ContactValue | None] = {}
        self._frictions: dict[tuple[Symbol, Indices], FrictionValue | None] = {}

    def constraint(self, ctx: Context, symbol: Symbol, indices: Indices) -> flat_model.Constraint | None:
        """The rows behind the label of a constraint, there or not."""
        key = (symbol, indices)
        if key not in self._constraints:
            self._constraints[key] = None
            instance = symbol.made.labels[indices]
            assert isinstance(instance.node, nodes.Constraint)
            with ctx.current.standing():
                self._constraints[key] = constraints.make(ctx, instance.scope, instance.node, instance.name)
        return self._constraints[key]

    def contact(self, ctx: Context, symbol: Symbol, indices: Indices) -> ContactValue | None:
        """Value of the label of a contact."""
        key = (symbol, indices)
        if key not in self._contacts:
            self._contacts[key] = None
            instance = symbol.made.labels.get(indices)
            if instance is not None:
                assert isinstance(instance.node, nodes.Contact)
                with ctx.current.standing():
                    self._contacts[key] = contacts.make(ctx, instance.scope, instance.node, instance.name)
        return self._contacts[key]

    def friction(self, ctx: Context, symbol: Symbol, indices: Indices, span: Span) -> FrictionValue | None:
        """Value of the label of a friction, or of the friction under the contact of that label; None if there is none,
        or after a diagnostic."""
        key = (symbol, indices)
        if key in self._frictions:
            return self._frictions[key]
        with self.entered(ctx, symbol, indices, span) as free:
            instance = symbol.made.labels.get(indices)
            if free and instance is not None:
                with ctx.current.standing():
                    self._frictions[key] = self._friction(ctx, symbol, indices, instance)
        return self._frictions.setdefault(key, None)

    def _friction(self, ctx: Context, symbol: Symbol, indices: Indices, label: LabelInstance) -> FrictionValue | None:
        if isinstance(label.node, nodes.Contact):
            contact = self.contact(ctx, symbol, indices)
            return frictions.under(ctx, label.scope, label.node, contact) if contact is not None else None
        assert isinstance(label.node, nodes.Friction)
        return frictions.make(ctx, label.scope, label.node, label.name)

    # ---- circles -----------------------------------------------------------------------------------------------------

    @contextmanager
    def entered(self, ctx: Context, symbol: Symbol, key: Indices | None, span: Span) -> Iterator[bool]:
        """Guards against definitions that need themselves: yields False after E0305."""
        active = ctx.current.active
        if (symbol, key) in active:
            circle = active[active.index((symbol, key)) :]
            names = [element_name(member.name, indices or ()) for member, indices in circle]
            names.append(names[0])
            links = [f"`{a}` on `{b}`" for a, b in pairwise(names)]
            path = ", ".join([links[0].replace(" on ", " depends on ", 1), *links[1:]])
            places = [Label(member.span, f"`{member.name}` is defined here") for member, _ in circle]
            ctx.sink.report("E0305", span, *places, path=path)
            for member, indices in circle:
                self.poison(member, indices)
            yield False
            return
        active.append((symbol, key))
        try:
            yield True
        finally:
            active.pop()

    def poison(self, symbol: Symbol, indices: Indices | None = None) -> None:
        """The symbol, or one element of it, has no value: it was reported."""
        if indices is not None:
            symbol.made.cells[indices] = POISON
        else:
            symbol.kind = "unknown"
