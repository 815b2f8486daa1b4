"""XML files of strangers as trees with places: expat reads them, entities are refused, sizes are bounded."""

from __future__ import annotations

import re
from dataclasses import field
from pathlib import Path
from typing import Any
from xml.parsers import expat

from lagdsl.foundation.diagnostics import Sink
from lagdsl.foundation.record import record
from lagdsl.foundation.source import SourceFile, Span

MAX_BYTES = 16_000_000
MAX_ELEMENTS = 50_000
MAX_DEPTH = 200
MAX_ATTRIBUTES = 100
_ENCODING = re.compile(rb"""^<\?xml[^>]*?encoding\s*=\s*["']([A-Za-z0-9._-]+)["']""")
_ENCODINGS = frozenset({"utf-8", "utf8", "us-ascii", "ascii", "iso-8859-1", "latin1", "latin-1", "windows-1252"})


@record(kw_only=True)
class Element:
    """`<tag name="value">`: attributes as they are spelled, children in their order; `span` covers the start tag.

    `pieces` are the characters between the tags, as expat gives them.
    """

    tag: str
    attributes: dict[str, str]
    span: Span = field(compare=False, repr=False)
    children: list[Element]
    pieces: list[str]

    @property
    def text(self) -> str:
        """The characters between start tag and end tag, those of children left out."""
        return "".join(self.pieces).strip()

    def all(self, tag: str) -> list[Element]:
        """The children of this tag."""
        return [child for child in self.children if child.tag == tag]

    def first(self, tag: str) -> Element | None:
        """The first child of this tag."""
        return next((child for child in self.children if child.tag == tag), None)

    def place(self, attribute: str) -> Span:
        """The place of the value of an attribute, or of the whole tag where it has no such value."""
        found = re.search(rf"""\b{re.escape(attribute)}\s*=\s*("[^"]*"|'[^']*')""", self.span.text)
        if found is None:
            return self.head
        return Span(self.span.file, self.span.start + found.start(1), self.span.start + found.end(1))

    @property
    def head(self) -> Span:
        """`<tag`: the place of the element as a whole."""
        return Span(self.span.file, self.span.start, min(self.span.end, self.span.start + len(self.tag) + 1))


def read_xml(path: Path, sink: Sink) -> Element | None:
    """The root element of a file. Reports E1001 to E1003 and returns None where there is none that may be read.

    Time and memory are bounded by the size of the file, which is bounded: no entity is ever expanded, and nothing
    outside of the file is read.
    """
    text = _text(path, sink)
    if text is None:
        return None
    reader = _Reader(SourceFile(str(path), text))
    try:
        reader.parse()
    except _Refused as refusal:
        sink.report(refusal.code, refusal.span, **refusal.arguments)
        return None
    except expat.ExpatError as fault:
        place = reader.at(fault.lineno, fault.offset)
        sink.report("E1001", place, reason=expat.ErrorString(fault.code))
        return None
    return reader.root


def _text(path: Path, sink: Sink) -> str | None:
    """The characters of a file, in the encoding that it declares."""
    name = str(path)
    try:
        with path.open("rb") as file:
            content = file.read(MAX_BYTES + 1)
    except (OSError, ValueError) as fault:  # ValueError: a name that no file can have
        reason = fault.strerror if isinstance(fault, OSError) and fault.strerror else str(fault)
        sink.report("E1000", None, name=name, reason=reason)
        return None
    if len(content) > MAX_BYTES:
        sink.report("E1002", None, what=f"`{name}`", limit=MAX_BYTES, unit="bytes")
        return None
    declared = _ENCODING.match(content.removeprefix(b"\xef\xbb\xbf"))
    encoding = declared[1].decode("ascii").lower() if declared else "utf-8"
    try:
        if encoding not in _ENCODINGS:
            raise LookupError(encoding)
        text = content.decode(encoding)
    except (UnicodeDecodeError, LookupError):
        sink.report("E1000", None, name=name, reason=f"its text is not {encoding.upper()}")
        return None
    return text.removeprefix("\ufeff").replace("\r\n", "\n").replace("\r", "\n")


class _Refused(Exception):  # noqa: N818 it leaves the parser, nobody else sees it
    def __init__(self, code: str, span: Span, **arguments: Any) -> None:
        super().__init__(code)
        self.code = code
        self.span = span
        self.arguments = arguments


class _Reader:
    """Builds the tree from the calls of expat."""

    def __init__(self, file: SourceFile) -> None:
        self.file = file
        self.root: Element | None = None
        self.open: list[Element] = []
        self.count = 0
        self.parser = expat.ParserCreate("utf-8")  # the text is decoded already, whatever it declares

    def parse(self) -> None:
        parser: Any = self.parser
        parser.StartElementHandler = self._start
        parser.EndElementHandler = self._end
        parser.CharacterDataHandler = self._characters
        parser.StartDoctypeDeclHandler = self._document_type
        parser.Parse(self.file.text.encode("utf-8", "surrogatepass"), True)

    def at(self, line: int, column: int) -> Span:
        """The place that expat means: it counts lines from 1, characters of a line from 0."""
        start = min(self.file.line_starts[min(line, len(self.file.line_starts)) - 1] + column, len(self.file.text))
        return Span(self.file, start, min(start + 1, len(self.file.text)))

    def _here(self) -> Span:
        return self.at(self.parser.CurrentLineNumber, self.parser.CurrentColumnNumber)

    def _start(self, tag: str, attributes: dict[str, str]) -> None:
        start = self._here().start
        end = self.file.text.find(">", start)
        span = Span(self.file, start, len(self.file.text) if end < 0 else end + 1)
        self.count += 1
        for amount, limit, unit in (
            (self.count, MAX_ELEMENTS, "elements"),
            (len(self.open) + 1, MAX_DEPTH, "levels"),
            (len(attributes), MAX_ATTRIBUTES, "attributes of one element"),
        ):
            if amount > limit:
                head = Span(self.file, start, start + len(tag) + 1)
                raise _Refused("E1002", head, what="this file", limit=limit, unit=unit)
        element = Element(tag=tag, attributes=attributes, span=span, children=[], pieces=[])
        if self.open:
            self.open[-1].children.append(element)
        else:
            self.root = element
        self.open.append(element)

    def _characters(self, text: str) -> None:
        if self.open:
            self.open[-1].pieces.append(text)

    def _end(self, _: str) -> None:
        self.open.pop()

    def _document_type(self, _: str, system: str | None, public: str | None, has_declarations: int) -> None:
        """Declarations are refused before the first of them is read: entities that grow, and other files."""
        if system is not None or public is not None or has_declarations:
            raise _Refused("E1003", self._here())
