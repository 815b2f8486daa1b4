"""One version of a text with what the compiler knows of it, each part computed when it is first asked for."""

from __future__ import annotations

from bisect import bisect_right
from threading import RLock

from lagdsl.foundation.diagnostics import Diagnostic, Severity, Sink
from lagdsl.foundation.source import SourceFile
from lagdsl.interfaces.lsp.names.classes import Classes, ClassNames
from lagdsl.interfaces.lsp.names.declarations import Declaration
from lagdsl.interfaces.lsp.names.occurrences import Occurrence, occurrences
from lagdsl.language.flat.model import FlatModel
from lagdsl.language.semantics.classes.inheritance import items_of
from lagdsl.language.semantics.flatten import scope_of
from lagdsl.language.semantics.scope.scope import ClassSymbol, Scope
from lagdsl.language.syntax import nodes
from lagdsl.language.syntax.parser import parse_recovered
from lagdsl.language.syntax.recursion import deep_recursion


class Snapshot:
    """`flats` holds the flat models by name once diagnostics are known. Threads may share a snapshot."""

    def __init__(self, name: str, text: str, version: int) -> None:
        plain = text.removeprefix("\ufeff").replace("\r\n", "\n").replace("\r", "\n")
        self.file = SourceFile(name, plain)
        self.version = version
        self.flats: dict[str, FlatModel] = {}
        self._lock = RLock()
        self._syntax: tuple[nodes.Unit | None, tuple[Diagnostic, ...]] | None = None
        self._scope: Scope | None = None
        self._occurrences: tuple[Occurrence, ...] | None = None
        self.classes = Classes()

    @property
    def text(self) -> str:
        return self.file.text

    @property
    def unit(self) -> nodes.Unit | None:
        """The tree of the statements that were understood; None for a text that is not read."""
        return self._parsed()[0]

    @property
    def syntax_diagnostics(self) -> tuple[Diagnostic, ...]:
        """Diagnostics of the parser."""
        return self._parsed()[1]

    @property
    def is_whole(self) -> bool:
        """True if every statement was understood."""
        return self.unit is not None and not any(each.severity is Severity.ERROR for each in self.syntax_diagnostics)

    def _parsed(self) -> tuple[nodes.Unit | None, tuple[Diagnostic, ...]]:
        with self._lock:
            if self._syntax is None:
                sink = Sink()
                with deep_recursion():
                    unit = parse_recovered(self.file, sink)
                self._syntax = unit, sink.diagnostics
            return self._syntax

    @property
    def scope(self) -> Scope | None:
        with self._lock:
            if self._scope is None and self.unit is not None:
                self._scope = scope_of(self.unit)
            return self._scope

    @property
    def occurrences(self) -> tuple[Occurrence, ...]:
        """All names of the text, in its order."""
        with self._lock:
            if self._occurrences is None:
                unit, scope = self.unit, self.scope
                with deep_recursion():
                    self._occurrences = () if unit is None or scope is None else occurrences(unit, scope, self.classes)
            return self._occurrences

    def occurrence_at(self, offset: int) -> Occurrence | None:
        """The name that holds the character at `offset`, or that ends there."""
        found = self.occurrences
        at = bisect_right(found, offset, key=lambda each: each.span.start)
        return next((each for each in reversed(found[:at]) if each.span.start <= offset <= each.span.end), None)

    def class_at(self, offset: int) -> ClassNames | None:
        """The names of the innermost class around a place."""
        if self.unit is None or self.scope is None:
            return None
        scope, items, found = self.scope, list(self.unit.items), None
        while True:
            inner = next(
                (i for i in items if isinstance(i, nodes.Class) and i.span.start <= offset <= i.span.end), None
            )
            if inner is None:
                return found
            entry = scope.entries.get(inner.name)
            symbol = entry if isinstance(entry, ClassSymbol) and entry.node is inner else ClassSymbol(inner, scope)
            found = self.classes.names(symbol)
            if found is None:
                return None
            scope, items = found.scope, [item for item, _ in items_of(inner)]

    def declarations(self) -> tuple[Declaration, ...]:
        """The declarations of the text, in its order."""
        found = (each.declaration for each in self.occurrences if each.is_declaration)
        return tuple(each for each in found if each is not None)
