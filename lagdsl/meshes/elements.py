"""XML of strangers as a tree with its texts: no declarations, bounded in number and depth."""

from __future__ import annotations

import warnings
from collections.abc import Iterator
from typing import Any
from xml.parsers import expat

import numpy as np

from lagdsl.meshes.triangles import MeshError
from lagdsl.numerics.rank import Floats
from lagdsl.record import record

_MOST_ELEMENTS, _DEEPEST = 200_000, 100


@record(kw_only=True)
class Element:
    """`<tag name="value">text</tag>`, children in their order."""

    tag: str
    attributes: dict[str, str]
    texts: list[str]
    children: list[Element]

    @property
    def text(self) -> str:
        return "".join(self.texts)

    def all(self, tag: str) -> list[Element]:
        """The children of this tag."""
        return [child for child in self.children if child.tag == tag]

    def first(self, tag: str) -> Element | None:
        """The first child of this tag."""
        return next((child for child in self.children if child.tag == tag), None)

    def every(self, tag: str | None = None) -> Iterator[Element]:
        """This element and all below it, of one tag or of any."""
        stack = [self]
        while stack:
            found = stack.pop()
            if tag in (None, found.tag):
                yield found
            stack += reversed(found.children)


def elements(content: bytes) -> Element:
    """The root element; raises MeshError. No entity is expanded, and nothing outside of the file is read."""
    outside = Element(tag="", attributes={}, texts=[], children=[])
    stack, count = [outside], 0

    def start(tag: str, attributes: dict[str, str]) -> None:
        nonlocal count
        count += 1
        if count > _MOST_ELEMENTS or len(stack) > _DEEPEST:
            raise MeshError(f"it has more than {_MOST_ELEMENTS} elements, or more than {_DEEPEST} levels")
        made = Element(tag=tag.rpartition(":")[2], attributes=attributes, texts=[], children=[])
        stack[-1].children.append(made)
        stack.append(made)

    def declared(*_: object) -> None:
        raise MeshError("its document type brings declarations")

    def end(_: str) -> None:
        stack.pop()

    def words(text: str) -> None:
        stack[-1].texts.append(text)

    parser: Any = expat.ParserCreate()
    parser.buffer_text = True
    parser.StartElementHandler = start
    parser.EndElementHandler = end
    parser.CharacterDataHandler = words
    parser.StartDoctypeDeclHandler = declared
    try:
        parser.Parse(content, True)
    except expat.ExpatError as fault:
        raise MeshError(f"it is no XML: {expat.ErrorString(fault.code)} in line {fault.lineno}") from None
    return outside.children[0]


def numbers(text: str) -> Floats:
    """The numbers of a text, between blanks."""
    try:
        with warnings.catch_warnings():
            warnings.simplefilter("error")
            return np.fromstring(text, dtype=np.float64, sep=" ")
    except (ValueError, DeprecationWarning):
        raise MeshError("a list of numbers has another word in it") from None
