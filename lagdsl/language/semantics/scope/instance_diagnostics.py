"""Diagnostics inside components: a fault in the text of a class is told once, with the components that lead there."""

from __future__ import annotations

import re
from collections.abc import Iterator
from dataclasses import replace

from lagdsl.foundation.diagnostics import Diagnostic, Label, Sink
from lagdsl.foundation.source import Span
from lagdsl.language.semantics.scope.context import Context
from lagdsl.language.semantics.scope.current import Current
from lagdsl.language.semantics.scope.scope import Instance, Scope, Symbol

_NUMBER = re.compile(r"\b\d+\b")  # turns of one loop, elements of one array: the same fault


class InstanceSink(Sink):
    """Adds the declarations of the components, innermost first, to what is said about the text of their class."""

    def __init__(self, current: Current) -> None:
        super().__init__()
        self._current = current
        self._told: set[tuple[str, str, int, int]] = set()

    def add(self, diagnostic: Diagnostic) -> None:
        """The same code at the same place of a class is kept for the first instance only; nothing is told twice."""
        if diagnostic.labels:
            span = diagnostic.labels[0].span
            said = (diagnostic.code + _NUMBER.sub("", diagnostic.message), span.file.name, span.start, span.end)
            if said in self._told:
                return
            self._told.add(said)
            places = list(_places(_instance_at(self._current, span)))
            if places:
                key = (diagnostic.code, span.file.name, span.start, span.end)
                if key in self._told:
                    return
                self._told.add(key)
            known = [label.span for label in diagnostic.labels]
            new = tuple(label for label in (*_modified(self._current, span), *places) if label.span not in known)
            diagnostic = replace(diagnostic, labels=(*diagnostic.labels, *new)) if new else diagnostic
        super().add(diagnostic)


def _instance_at(current: Current, span: Span) -> Instance | None:
    """The instance being worked on whose text holds the place."""
    for scope in (*(symbol.scope for symbol, _ in reversed(current.active)), *reversed(current.scopes)):
        step: Scope | None = scope
        while step is not None:
            owner = next((each for each in step.chain() if each.instance is not None), None)
            if owner is None or owner.instance is None:
                break
            if owner.text is not None and _holds(owner.text, span):
                return owner.instance
            step = owner.instance.around
    return None


def _modified(current: Current, span: Span) -> tuple[Label, ...]:
    """The component that gets its value where the fault is, if another class declares it."""
    if not current.active:
        return ()
    symbol = current.active[-1][0]
    owner = symbol.scope.owner
    if owner.text is None or _holds(owner.text, span) or owner.instance is None or owner.instance.around is None:
        return ()
    return (Label(symbol.span, f"`{symbol.short}` is declared here as {symbol.title}"),)


def _holds(text: Span, span: Span) -> bool:
    return text.file is span.file and text.start <= span.start and span.end <= text.end


def _places(instance: Instance | None) -> Iterator[Label]:
    while instance is not None and instance.around is not None:
        yield Label(instance.span, f"in component `{instance.name}`")
        instance = instance.around.owner.instance


def report_missing(ctx: Context, code: str, symbol: Symbol, name: str) -> None:
    """Reports a missing value at the declaration of the component, which must give it."""
    instance = symbol.scope.owner.instance
    if instance is None or instance.around is None:
        ctx.sink.report(code, symbol.span, name=name, kind=symbol.kind)
        return
    if instance.misfit:
        return
    short = instance.span.text
    each = "each " if instance.name.endswith("]") else ""
    label = Label(symbol.span, f"declared here as {symbol.title}")
    way = f"write `{short}({each}{name} = ...)`"
    ctx.sink.report(
        code, instance.span, label, name=f"{instance.around.prefix}{short}.{name}", kind=symbol.kind, help=way
    )
