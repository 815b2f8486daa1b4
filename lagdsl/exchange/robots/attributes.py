"""Numbers, vectors and names in attributes: what is missing or no number is reported at its place."""

from __future__ import annotations

import math
import re
from collections import Counter
from collections.abc import Callable, Iterator
from contextlib import contextmanager

from lagdsl.exchange.robots.description import ZERO, Pose, Vector
from lagdsl.exchange.robots.findings import Findings
from lagdsl.exchange.robots.mesh_faults import MeshFault, tell_faults
from lagdsl.exchange.robots.xml_tree import Element
from lagdsl.foundation.source import Span

_NUMBER = re.compile(r"[+-]?(\d+\.?\d*|\.\d+)([eE][+-]?\d+)?", re.ASCII)
LARGEST = 1e100  # of lengths, angles, masses and inertias: squares and products of larger ones are not finite
LONGEST = 60  # characters of a text that a message repeats


class Attributes:
    """Reads the values of elements; counts the elements that nobody reads, collects meshes that cannot be taken."""

    def __init__(self, findings: Findings) -> None:
        self.findings = findings
        self.left_out: Counter[str] = Counter()
        self.first_left_out: dict[str, Span] = {}
        self.untaken: list[MeshFault] = []
        self.instead: str | None = None
        self.faults = 0

    @contextmanager
    def or_else(self, instead: str) -> Iterator[Callable[[], bool]]:
        """Read a part that a lenient import can do without; `instead` is what it writes. The value asks if anything is
        wrong."""
        before, begun = self.instead, self.faults
        self.instead = instead
        try:
            yield lambda: self.faults > begun
        finally:
            self.instead = before

    def text(self, element: Element, name: str) -> str | None:
        """The value of an attribute that must be there and not be empty; None after E1005."""
        value = element.attributes.get(name, "").strip()
        if not value:
            self._missing(element, f"attribute `{name}`")
            return None
        return value

    def number(self, element: Element, name: str, default: float | None = None) -> float | None:
        """A finite number; None after an error, or where `default` is None and there is no such attribute."""
        if name not in element.attributes:
            return default
        found = self._numbers(element, name, 1)
        return None if found is None else found[0]

    def required(self, element: Element | None, name: str, owner: Element, tag: str) -> float:
        """The number of the element `tag` of `owner`, at most 1e100; 0 after E1005 or E1006."""
        if element is None:
            self._missing(owner, f"element `<{tag}>`")
            return 0.0
        if name not in element.attributes:
            self._missing(element, f"attribute `{name}`")
            return 0.0
        found = self._numbers(element, name, 1, LARGEST)
        return 0.0 if found is None else found[0]

    def value(self, element: Element) -> float | None:
        """The number in the attribute `value`, or else between the tags; None after E1006."""
        found = (
            self._numbers(element, "value", 1, LARGEST) if "value" in element.attributes else self.content(element, 1)
        )
        return None if found is None else found[0]

    def vector(self, element: Element | None, name: str, default: Vector = ZERO) -> Vector:
        """Three numbers of at most 1e100; `default` where there are none, and after an error."""
        if element is None or name not in element.attributes:
            return default
        found = self._numbers(element, name, 3, LARGEST)
        return default if found is None else (found[0], found[1], found[2])

    def pose(self, owner: Element) -> Pose:
        """The `<origin>` of an element."""
        origin = self.only(owner, "origin")
        return Pose(xyz=self.vector(origin, "xyz"), rpy=self.vector(origin, "rpy"))

    def only(self, owner: Element, tag: str) -> Element | None:
        """The one child of this tag; reports a second one, E1007."""
        found = owner.all(tag)
        if len(found) > 1:
            name = owner.attributes.get("name", owner.tag)
            self.findings.error("E1007", found[1].head, what=f"`<{tag}>` of", name=name)
        return found[0] if found else None

    def leave_out(self, element: Element) -> None:
        """Count an element that has no counterpart in the text."""
        self.left_out[element.tag] += 1
        self.first_left_out.setdefault(element.tag, element.head)

    def tell_left_out(self) -> None:
        """One note, N1019, for every tag that was counted."""
        for tag, count in self.left_out.items():
            times = "once" if count == 1 else f"{count} times"
            self.findings.note("N1019", self.first_left_out[tag], tag=tag, times=times)

    def tell_untaken(self) -> None:
        """One error, E1013, for each reason against meshes."""
        tell_faults(self.untaken, self.findings, "the shape is left out")

    def content(self, element: Element | None, count: int) -> tuple[float, ...] | None:
        """So many numbers between the tags of an element; None where there is none, and after E1006."""
        if element is None:
            return None
        found = self._numbers(element, f"<{element.tag}>", count, LARGEST, element.text)
        return None if found is None else tuple(found)

    def _missing(self, element: Element, what: str) -> None:
        self.faults += 1
        self.findings.error("E1005", element.head, element=element.tag, what=what, instead=self.instead)

    def _numbers(
        self, element: Element, name: str, count: int, most: float = math.inf, text: str | None = None
    ) -> list[float] | None:
        written = element.attributes[name] if text is None else text
        words = written.split()
        values = [float(word) for word in words if _NUMBER.fullmatch(word)]
        if len(values) == len(words) == count and all(math.isfinite(value) and abs(value) <= most for value in values):
            return values
        expected = "a finite number" if count == 1 else f"{count} finite numbers"
        if any(math.isfinite(value) and abs(value) > most for value in values):
            expected = f"{'a number' if count == 1 else f'{count} numbers'} of at most {most:g}"
        self.faults += 1
        words_of = {"name": name, "text": written[:LONGEST], "expected": expected}
        self.findings.error("E1006", element.place(name), instead=self.instead, **words_of)
        return None
