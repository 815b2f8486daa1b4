"""State of the elaboration: the stack of symbols, instances and functions, and how relations are taken."""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import contextmanager
from dataclasses import field

from lagdsl.foundation.record import mutable_record
from lagdsl.language.semantics.scope.alike import Alike
from lagdsl.language.semantics.scope.common import Common
from lagdsl.language.semantics.scope.scope import Indices, Scope, Symbol
from lagdsl.language.semantics.scope.template import Templates
from lagdsl.language.syntax import nodes


@mutable_record()
class Current:
    """`active` are the symbols that get their values, `scopes` the instances whose items are elaborated, `functions`
    those that are expanded, outermost first. Relations are not located while `quiet`. `in_clause`: it is the text of a
    `when`. `common` are texts that are spelled alike, `alike` operations on operands of types that were checked,
    `templates` those of the texts of loops."""

    active: list[tuple[Symbol, Indices | None]] = field(default_factory=list)
    scopes: list[Scope] = field(default_factory=list)
    functions: list[nodes.Function] = field(default_factory=list)
    quiet: bool = False
    in_clause: bool = False
    common: Common = field(default_factory=Common)
    alike: Alike = field(default_factory=Alike)
    templates: Templates = field(default_factory=Templates)

    @property
    def mode(self) -> tuple[bool, ...]:
        """A text has one value in one mode."""
        return self.quiet, self.in_clause

    @contextmanager
    def inside(self, scope: Scope) -> Iterator[None]:
        """Diagnostics of the text of a class meanwhile belong to this instance of it."""
        self.scopes.append(scope)
        try:
            yield
        finally:
            self.scopes.pop()

    @contextmanager
    def without_relations(self) -> Iterator[None]:
        """Relations inside are taken as they stand, not located as events."""
        before, self.quiet = self.quiet, True
        try:
            yield
        finally:
            self.quiet = before

    @contextmanager
    def standing(self, *, in_clause: bool = False) -> Iterator[None]:
        """Place of the elaboration meanwhile: a definition, which holds always, or a `when`."""
        before, self.quiet, self.in_clause = (self.quiet, self.in_clause), False, in_clause
        try:
            yield
        finally:
            self.quiet, self.in_clause = before
