"""Diagnostics of a text while it is typed: those of the parser, and of each model before deriving."""

from __future__ import annotations

from lagdsl.diagnostics import Diagnostic, Severity, Sink
from lagdsl.flat.model import FlatModel
from lagdsl.lsp.snapshot import Snapshot
from lagdsl.semantics.classes.selection import complete_models
from lagdsl.semantics.flatten import flatten
from lagdsl.semantics.wellformed.check import check as check_physics
from lagdsl.syntax import nodes
from lagdsl.syntax.recursion import deep_recursion

_NO_MODEL = ("E0135", "E0218")
"""A file that holds no model is a fault for who runs it, not for who writes it."""

_OF_STATEMENTS = ("01", "02", "03", "04")
_ABSENT = frozenset({"E0201", "E0204", "E0210", "E0223", "E0318", "E0319", "E0320", "E0322", "E0384"})
"""Faults that may come from a statement that is missing, in families that else are about one statement."""


def findings(snapshot: Snapshot) -> tuple[Diagnostic, ...]:
    """Everything that is found before deriving, in all models of the text; the snapshot keeps their flat models.

    While a statement is not understood, only errors are told that are about another statement by itself.
    """
    unit = snapshot.unit
    if unit is None:
        return snapshot.syntax_diagnostics
    found: list[Diagnostic] = [each for each in snapshot.syntax_diagnostics if each.code not in _NO_MODEL]
    for name in complete_models(unit) or (None,):
        sink = Sink()
        if snapshot.is_whole:
            flat = _flat(unit, sink, name) if unit.items else None
            if flat is not None:
                snapshot.flats[flat.name] = flat
            found += [each for each in sink.diagnostics if each.code not in _NO_MODEL]
        elif unit.items:
            found += [each for each in _of_statements(unit, name) if each.code not in _NO_MODEL]
    return tuple(dict.fromkeys(found))


def _flat(unit: nodes.Unit, sink: Sink, name: str | None) -> FlatModel | None:
    """The flat model, checked as `lag check` does it, without what takes long."""
    with deep_recursion():
        flat = flatten(unit, sink, name)
        if flat is not None and not sink.has_errors:
            check_physics(flat, sink, sampled=False)
    return None if sink.has_errors else flat


def _of_statements(unit: nodes.Unit, name: str | None) -> list[Diagnostic]:
    sink = Sink()
    with deep_recursion():
        flatten(unit, sink, name, incomplete=True)
    return [each for each in sink.diagnostics if _is_of_one_statement(each)]


def _is_of_one_statement(found: Diagnostic) -> bool:
    return found.severity is Severity.ERROR and found.code[1:3] in _OF_STATEMENTS and found.code not in _ABSENT
