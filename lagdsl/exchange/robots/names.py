"""Names of links, joints and inputs in the text: the original ones, where the language has room for them."""

from __future__ import annotations

from collections.abc import Iterator
from itertools import count

from lagdsl.exchange.model_text.identifiers import TAKEN, identifier
from lagdsl.exchange.robots.findings import Findings
from lagdsl.foundation.source import Span

_OURS = "Body Revolute Prismatic Spherical FreeQuaternion Planar Weld FixedTranslation"
_TAKEN = TAKEN.union(_OURS.split())


class Names:
    """Gives every part of a robot a name of its own; tells each that is not the original one, N1020."""

    def __init__(self, findings: Findings) -> None:
        self._findings = findings
        self._used: set[str] = set()
        self._numbers: dict[tuple[str, str], int] = {}

    def of(self, original: str, kind: str, span: Span | None = None) -> str:
        """A new name: `original` if it is free, else one that says more; told if the original has the place `span`."""
        plain = identifier(original, kind)
        free = next(name for name in self._proposals(plain, kind) if name not in self._used and name not in _TAKEN)
        self._used.add(free)
        if free != original and span is not None:
            self._findings.note("N1020", span, kind=kind, old=original, new=free)
        return free

    def _proposals(self, plain: str, kind: str) -> Iterator[str]:
        """Numbers go on from the last one that was given to names of this spelling."""
        yield plain
        yield f"{plain}_{kind}"
        for number in count(self._numbers.get((plain, kind), 2)):
            self._numbers[plain, kind] = number
            yield f"{plain}_{kind}_{number}"
