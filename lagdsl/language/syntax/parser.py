"""Text to syntax tree, with as many errors from one text as have causes of their own."""

from __future__ import annotations

from lagdsl.foundation.diagnostics import Sink
from lagdsl.foundation.source import SourceFile
from lagdsl.language.syntax import limits, nodes
from lagdsl.language.syntax.builder import TooDeep
from lagdsl.language.syntax.direction import turned_text
from lagdsl.language.syntax.faults import ends_outer_class, recover
from lagdsl.language.syntax.session import Session


def parse(file: SourceFile, sink: Sink) -> nodes.Unit | None:
    """The tree of a whole text, or None after errors, which are in `sink`."""
    unit = _run(file, sink, "start")
    assert unit is None or isinstance(unit, nodes.Unit)
    if unit is not None and not unit.items:
        sink.report("E0135", None, name=file.name)
        return None
    return unit


def parse_expression(file: SourceFile, sink: Sink) -> nodes.Expression | None:
    """The tree of a text that is one expression, or None after errors."""
    expression: nodes.Expression | None = _run(file, sink, "expr")  # type: ignore[assignment]
    return expression


def parse_recovered(file: SourceFile, sink: Sink) -> nodes.Unit | None:
    """The tree of all statements of a text that were understood, those of unfinished classes included; errors are in
    `sink`. None for a text that is not read: one that is too large, or turns its direction."""
    found = Sink()
    session = _session(file, sink, found, "start")
    if session is None:
        return None
    if session.tree is None:
        session.close_all()
    _tell(found, sink)
    assert session.tree is None or isinstance(session.tree, nodes.Unit)
    return session.tree


def _run(file: SourceFile, sink: Sink, start: str) -> object | None:
    found = Sink()
    session = _session(file, sink, found, start)
    if session is None:
        return None
    _tell(found, sink)
    return session.tree if not found.has_errors else None


def _session(file: SourceFile, sink: Sink, found: Sink, start: str) -> Session | None:
    """The text, read; its errors are in `found`. None, with the reason in `sink`, for a text that is not read."""
    if len(file.text) > limits.MAX_CHARACTERS:
        sink.report("E0130", None, name=file.name, limit=limits.MAX_CHARACTERS)
        return None
    if turned_text(file, sink):
        return None
    session = Session(file, found, start)
    try:
        _read(session)
    except TooDeep as fault:
        if fault.brackets:
            found.report("E0138", fault.span, limit=limits.MAX_BRACKETS)
        else:
            found.report("E0109", fault.span, limit=limits.MAX_DEPTH)
    return session


def _tell(found: Sink, sink: Sink) -> None:
    if len(found.diagnostics) >= limits.MAX_ERRORS:
        found.report("N0199", None, count=limits.MAX_ERRORS)
    for diagnostic in found.diagnostics:
        sink.add(diagnostic)


def _read(session: Session) -> None:
    while not session.finished:
        if len(session.sink.diagnostics) >= limits.MAX_ERRORS:
            return
        token = session.take()
        if ends_outer_class(session, token) or session.shift(token):
            continue
        recover(session, token)
