"""The tree as canonical text: two blanks a level, long statements wrapped, comments and single blank lines kept."""

from __future__ import annotations

import re
from collections.abc import Iterable
from itertools import takewhile
from typing import assert_never

from lark import Token

from lagdsl.foundation.diagnostics import Sink
from lagdsl.foundation.source import SourceFile
from lagdsl.language.syntax import nodes
from lagdsl.language.syntax.layout import fill, flat
from lagdsl.language.syntax.parser import parse
from lagdsl.language.syntax.print_expressions import ExpressionWriter, quoted
from lagdsl.language.syntax.print_statements import dotted, statement
from lagdsl.language.syntax.recursion import deep_recursion
from lagdsl.language.syntax.tokens import comments, end_of, plain_tokens, start_of

_STEP = 2
_BLANK_LINE = re.compile(r"\n[ \t]*\n")


def print_expression(expression: nodes.Expression) -> str:
    """An expression on one line, for messages and reports."""
    with deep_recursion():
        writer = ExpressionWriter()
        writer.expression(expression)
    return flat(writer.pieces)


def format_text(file: SourceFile, sink: Sink) -> str | None:
    """Canonical text of a file, or None after errors.

    Its tree is that of the file, but for names after `end`, which are filled in; formatting it again changes nothing. A
    statement that holds a comment keeps its lines and is only indented anew.
    """
    unit = parse(file, sink)
    if unit is None:
        return None
    with deep_recursion():
        return _Formatter(file).unit(unit)


class _Formatter:
    """Writes lines in source order; `end` is the place in the source up to which all is written."""

    def __init__(self, file: SourceFile) -> None:
        self.file = file
        self.source = file.text
        self.comments = comments(file.text)
        self.written = 0  # of the comments
        self.lines: list[str] = []
        self.end = 0

    def unit(self, unit: nodes.Unit) -> str:
        if unit.has_within:
            self._gap(start_of(self._next(0, "within")), 0)
            self._line(f"within{'' if unit.within is None else f' {dotted(unit.within)}'};", 0)
            self.end = end_of(self._next(self.end, ";"))
        self._items(unit.items, 0)
        self._gap(len(self.source), 0)
        while self.lines and not self.lines[-1]:
            self.lines.pop()
        return "\n".join(self.lines) + "\n"

    # ---- structure -------------------------------------------------------------------------------------------------

    def _items(self, items: Iterable[nodes.Item], indent: int) -> None:
        for item in items:
            self._gap(item.span.start, indent)
            match item:
                case nodes.Class():
                    self._class(item, indent)
                case nodes.For():
                    self._for(item, indent)
                case nodes.If():
                    self._if(item, indent)
                case nodes.When():
                    self._when(item, indent)
                case (
                    nodes.Import()
                    | nodes.Definition()
                    | nodes.Declaration()
                    | nodes.Physics()
                    | nodes.Relation()
                    | nodes.Extends()
                    | nodes.Annotation()
                ):
                    if self._holds_comment(item):
                        self._as_written(item, indent)
                    else:
                        self.lines += fill(statement(item), indent)
                case _:
                    assert_never(item)
            self.end = item.span.end

    def _class(self, node: nodes.Class, indent: int) -> None:
        head = " ".join((*node.prefixes, node.kind, node.name))
        self._line(head if node.doc is None else f"{head} {quoted(node.doc)}", indent)
        self.end = node.name_span.end
        self._items(node.items, indent + _STEP)
        for section in node.sections:
            self._gap(section.span.start, indent + _STEP if self._comment_is_indented(indent) else indent)
            self._line(section.keyword, indent)
            self.end = end_of(self._next(section.span.start, section.keyword.split()[-1]))
            self._items(section.items, indent + _STEP)
        self._ending(node.name, indent)

    def _for(self, node: nodes.For, indent: int) -> None:
        writer = ExpressionWriter()
        writer.text("for ")
        writer.iterators(node.iterators)
        writer.text(" loop")
        self.lines += fill(writer.pieces, indent)
        self.end = end_of(self._next(node.iterators[-1].span.end, "loop"))
        self._items(node.body, indent + _STEP)
        self._ending("for", indent)

    def _if(self, node: nodes.If, indent: int) -> None:
        self._branches("if", node.branches, indent)
        if node.otherwise is not None:
            self._keyword("else", indent)
            self._items(node.otherwise, indent + _STEP)
        self._ending("if", indent)

    def _when(self, node: nodes.When, indent: int) -> None:
        self._branches("when", node.branches, indent)
        self._ending("when", indent)

    def _branches(self, word: str, branches: tuple[nodes.IfBranch | nodes.WhenBranch, ...], indent: int) -> None:
        for position, branch in enumerate(branches):
            if position:
                self._gap(start_of(self._next(self.end, f"else{word}")), indent + _STEP)
            writer = ExpressionWriter()
            writer.text(f"else{word} " if position else f"{word} ")
            writer.expression(branch.condition)
            writer.text(" then")
            self.lines += fill(writer.pieces, indent)
            self.end = end_of(self._next(branch.condition.span.end, "then"))
            self._items(branch.body, indent + _STEP)

    def _keyword(self, word: str, indent: int) -> None:
        token = self._next(self.end, word)
        self._gap(start_of(token), indent + _STEP)
        self._line(word, indent)
        self.end = end_of(token)

    def _ending(self, name: str, indent: int) -> None:
        self._gap(start_of(self._next(self.end, "end")), indent + _STEP)
        self._line(f"end {name};", indent)

    def _next(self, position: int, word: str) -> Token:
        """The first token spelled `word` from `position` on."""
        return next(token for token in plain_tokens(self.source, position) if token.value == word)

    # ---- lines, comments, blank lines ------------------------------------------------------------------------------

    def _line(self, text: str, indent: int) -> None:
        self.lines.append(" " * indent + text)

    def _gap(self, start: int, indent: int) -> None:
        """Comments before the place `start` in the source, and a blank line if there was one."""
        while self.written < len(self.comments) and self.comments[self.written].start < start:
            comment = self.comments[self.written]
            self.written += 1
            between = self.source[self.end : comment.start]
            if self.lines and "\n" not in between and "\n" not in comment.text:
                self.lines[-1] += f"  {comment.text}"
            else:
                self._blank(between)
                self.lines += f"{' ' * indent}{comment.text}".split("\n")
            self.end = max(self.end, comment.end)
        self._blank(self.source[self.end : start])

    def _blank(self, between: str) -> None:
        if self.lines and self.lines[-1] and _BLANK_LINE.search(between):
            self.lines.append("")

    def _comment_is_indented(self, indent: int) -> bool:
        """True if the next comment stands deeper than the class: then it belongs to the items above it."""
        if self.written == len(self.comments):
            return False
        start = self.comments[self.written].start
        return start - self.source.rfind("\n", 0, start) - 1 > indent

    def _holds_comment(self, item: nodes.Item) -> bool:
        return self.written < len(self.comments) and self.comments[self.written].start < item.span.end

    def _as_written(self, item: nodes.Item, indent: int) -> None:
        """The lines of the source, moved so that the first one begins at `indent`."""
        start, end = item.span.start, item.span.end
        first, *rest = self.source[start:end].split("\n")
        shift = indent - (start - self.source.rfind("\n", 0, start) - 1)
        tokens = takewhile(lambda token: start_of(token) < end, plain_tokens(self.source, start))
        movable = not any(token.type == "STRING" and "\n" in token.value for token in tokens)
        self._line(first.rstrip() if movable else first, indent)
        self.lines += [_moved(line, shift) if movable else line for line in rest]
        while self.written < len(self.comments) and self.comments[self.written].start < end:
            self.written += 1


def _moved(line: str, shift: int) -> str:
    text = line.expandtabs().rstrip()
    indent = len(text) - len(text.lstrip())
    return " " * max(indent + shift, 0) + text.lstrip()
