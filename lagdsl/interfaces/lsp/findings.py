"""Diagnostics of a text while it is typed: those of the parser, and of each model before deriving."""

from __future__ import annotations

from lagdsl.foundation.diagnostics import Diagnostic, Severity, Sink
from lagdsl.foundation.record import mutable_record
from lagdsl.interfaces.lsp.shape import Shape, moved, shape_of
from lagdsl.interfaces.lsp.snapshot import Snapshot
from lagdsl.interfaces.lsp.unfinished import without_unfinished
from lagdsl.language.flat.model import FlatModel
from lagdsl.language.semantics.classes.selection import complete_models
from lagdsl.language.semantics.flatten import flatten
from lagdsl.language.semantics.wellformed.check import check as check_physics
from lagdsl.language.syntax import nodes
from lagdsl.language.syntax.recursion import deep_recursion

_NO_MODEL = ("E0135", "E0218")
"""A file that holds no model is a fault for who runs it, not for who writes it."""

_OF_STATEMENTS = ("01", "02", "03", "04")
_ABSENT = frozenset({"E0201", "E0204", "E0210", "E0223", "E0303", "E0318", "E0319", "E0320", "E0322", "E0337", "E0384"})
"""Faults that may come from a statement that is missing, in families that else are about one statement.

A parameter has no value where the statement that gives it is missing: the component, or the `extends` of its class.
"""


@mutable_record()
class Memory:
    """`found` by themselves in the statements of `shape`, those of a text that was looked at before."""

    shape: Shape | None = None
    found: tuple[Diagnostic, ...] = ()


def findings(snapshot: Snapshot, memory: Memory | None = None) -> tuple[Diagnostic, ...]:
    """Everything that is found before deriving, in all models of the text; the snapshot keeps their flat models.

    While a statement is not understood, only errors are told that are about another statement by itself. They are
    taken from `memory` where the other statements are those of the text before; it is then that of this text.
    """
    unit = snapshot.unit
    if unit is None:
        return snapshot.syntax_diagnostics
    syntax = [each for each in snapshot.syntax_diagnostics if each.code not in _NO_MODEL]
    memory = Memory() if memory is None else memory
    if snapshot.is_whole:
        found = _of_models(snapshot, unit, memory)
    else:
        found = _of_statements(without_unfinished(unit, syntax), memory)
    return tuple(dict.fromkeys((*syntax, *found)))


def _of_models(snapshot: Snapshot, unit: nodes.Unit, memory: Memory) -> tuple[Diagnostic, ...]:
    found: list[Diagnostic] = []
    for name in complete_models(unit) or (None,) if unit.items else ():
        sink = Sink()
        flat = _flat(unit, sink, name)
        if flat is not None:
            snapshot.flats[flat.name] = flat
        found += [each for each in sink.diagnostics if each.code not in _NO_MODEL]
    # no error in all statements is no error in the same statements beside one that is not understood
    memory.shape = None if any(each.severity is Severity.ERROR for each in found) else shape_of(unit)
    memory.found = ()
    return tuple(found)


def _flat(unit: nodes.Unit, sink: Sink, name: str | None) -> FlatModel | None:
    """The flat model, checked as `lag check` does it, without what takes long."""
    with deep_recursion():
        flat = flatten(unit, sink, name)
        if flat is not None and not sink.has_errors:
            check_physics(flat, sink, sampled=False)
    return None if sink.has_errors else flat


def _of_statements(unit: nodes.Unit, memory: Memory) -> tuple[Diagnostic, ...]:
    shape = shape_of(unit)
    known = None
    if memory.shape is not None and memory.shape.has_statements_of(shape):
        known = moved(memory.found, memory.shape, shape)
    memory.shape, memory.found = shape, _errors_of_statements(unit) if known is None else known
    return memory.found


def _errors_of_statements(unit: nodes.Unit) -> tuple[Diagnostic, ...]:
    sink = Sink()
    for name in complete_models(unit) or (None,) if unit.items else ():
        with deep_recursion():
            flatten(unit, sink, name, incomplete=True)
    return tuple(each for each in sink.diagnostics if _is_of_one_statement(each))


def _is_of_one_statement(found: Diagnostic) -> bool:
    is_of_family = found.code[1:3] in _OF_STATEMENTS and found.code not in (*_ABSENT, *_NO_MODEL)
    return found.severity is Severity.ERROR and is_of_family
