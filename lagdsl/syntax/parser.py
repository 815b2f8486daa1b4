"""Text to syntax tree."""

from __future__ import annotations

from lagdsl.diagnostics import Sink
from lagdsl.source import SourceFile
from lagdsl.syntax import nodes
from lagdsl.syntax.build import actions
from lagdsl.syntax.lexer import Lexer
from lagdsl.syntax.machine import Machine


def parse(file: SourceFile, sink: Sink) -> nodes.Unit | None:
    """The tree of a whole text, or None after errors, which are in `sink`."""
    lexer, machine = Lexer(file, sink), Machine(file, "start", actions(sink))
    while not machine.finished:
        token = lexer.next(machine.accepted)
        if not machine.feed(token):
            sink.report("E0100", lexer.span(token.start, token.end), found=f"`{token.text}`", expected="something else")
            return None
    unit = machine.values[-1]
    assert isinstance(unit, nodes.Unit)
    return unit


def parse_expression(file: SourceFile, sink: Sink) -> nodes.Expression | None:
    """The tree of a text that is one expression, or None after errors."""
    lexer, machine = Lexer(file, sink), Machine(file, "expr", actions(sink))
    while not machine.finished:
        token = lexer.next(machine.accepted)
        if not machine.feed(token):
            sink.report("E0100", lexer.span(token.start, token.end), found=f"`{token.text}`", expected="something else")
            return None
    return machine.values[-1]  # type: ignore[return-value]
