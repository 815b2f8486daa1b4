"""Text to syntax tree, with as many errors from one text as have causes of their own."""

from __future__ import annotations

from lagdsl.diagnostics import Sink
from lagdsl.source import SourceFile
from lagdsl.syntax import limits, nodes
from lagdsl.syntax.builder import TooDeep
from lagdsl.syntax.direction import turned_text
from lagdsl.syntax.faults import ends_outer_class, recover
from lagdsl.syntax.session import Session


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


def _run(file: SourceFile, sink: Sink, start: str) -> object | None:
    if len(file.text) > limits.MAX_CHARACTERS:
        sink.report("E0130", None, name=file.name, limit=limits.MAX_CHARACTERS)
        return None
    found = Sink()
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
    if len(found.diagnostics) >= limits.MAX_ERRORS:
        found.report("N0199", None, count=limits.MAX_ERRORS)
    for diagnostic in found.diagnostics:
        sink.add(diagnostic)
    return session.tree if not found.has_errors else None


def _read(session: Session) -> None:
    while not session.finished:
        if len(session.sink.diagnostics) >= limits.MAX_ERRORS:
            return
        token = session.take()
        if ends_outer_class(session, token) or session.shift(token):
            continue
        recover(session, token)
