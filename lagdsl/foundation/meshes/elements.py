"""XML of strangers as a tree: no document type, bounded in number and depth."""

from __future__ import annotations

import warnings
from typing import NoReturn
from xml.etree import ElementTree
from xml.etree.ElementTree import Element
from xml.parsers import expat

import numpy as np

from lagdsl.foundation.meshes.triangles import MeshError
from lagdsl.foundation.numerics.rank import Floats

_MOST_ELEMENTS, _DEEPEST = 200_000, 100


class _Bounded(ElementTree.TreeBuilder):
    """Elements by their names without namespaces."""

    def __init__(self) -> None:
        super().__init__()
        self.count = self.depth = 0

    def start(self, tag: str, attributes: dict[str, str], /) -> Element:
        self.count += 1
        self.depth += 1
        if self.count > _MOST_ELEMENTS or self.depth > _DEEPEST:
            raise MeshError(f"it has more than {_MOST_ELEMENTS} elements, or more than {_DEEPEST} levels")
        return super().start(tag.rpartition("}")[2], attributes)

    def end(self, tag: str, /) -> Element:
        self.depth -= 1
        return super().end(tag.rpartition("}")[2])

    def doctype(self, *_: str | None) -> NoReturn:
        raise MeshError("its document type brings declarations")


def elements(content: bytes) -> Element:
    """The root element; raises MeshError. No entity is expanded, and nothing outside of the file is read."""
    try:
        return ElementTree.fromstring(content, ElementTree.XMLParser(target=_Bounded()))
    except ElementTree.ParseError as fault:
        reason = expat.ErrorString(fault.code)
        raise MeshError(f"it is not valid XML: {reason} in line {fault.position[0]}") from None
    except (LookupError, ValueError) as fault:  # an encoding that Python does not have
        raise MeshError(f"it is not valid XML: {fault}") from None


def numbers(text: str | None) -> Floats:
    """The numbers of a text, between blanks."""
    try:
        with warnings.catch_warnings():
            warnings.simplefilter("error")
            return np.fromstring(text or "", dtype=np.float64, sep=" ")
    except (ValueError, DeprecationWarning):
        raise MeshError("a list of numbers has another word in it") from None
