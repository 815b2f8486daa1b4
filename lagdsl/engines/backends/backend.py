"""Interface of a backend: a program in, named texts out. Backends write nothing to disk."""

from __future__ import annotations

from collections.abc import Mapping
from types import MappingProxyType
from typing import Protocol

from lagdsl.derivation.program.program import Program
from lagdsl.foundation.record import record


@record()
class Artifact:
    """Texts by relative path (`/` between folders), in the order of writing; the same program gives the same bytes."""

    files: Mapping[str, str]

    def __post_init__(self) -> None:
        object.__setattr__(self, "files", MappingProxyType(dict(self.files)))


class Backend(Protocol):
    """One target language."""

    name: str

    def emit(self, program: Program) -> Artifact:
        """Complete sources that stand alone."""
        ...
