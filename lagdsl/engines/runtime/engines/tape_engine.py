"""The engine over a tape: the functions of a program interpreted by the C runtime, at once and without a compiler."""

from __future__ import annotations

from lagdsl.derivation.program.program import Program
from lagdsl.engines.backends.tape.emit import PARTS
from lagdsl.engines.runtime.engines.c_engine import CEngine
from lagdsl.engines.runtime.engines.engine import EngineName
from lagdsl.engines.runtime.engines.native_model import NativeModel
from lagdsl.engines.runtime.engines.tape_model import load_tape
from lagdsl.foundation.collection import without_collection

# Two vectors of states.
_CROWD = 16


class TapeEngine(CEngine):
    """As CEngine. Nothing is compiled."""

    name: EngineName = "tape"

    def __init__(self, program: Program, *, together: bool = False) -> None:
        super().__init__(program, together=together)

    def worked(self, seconds: float, left: float = 0.0) -> None:
        """Nothing more is made for what is to come."""

    def _provide(self, part: str | None = None) -> NativeModel:
        return load_tape(self._made(part), *((part,) if part else self._parts_of_native))

    def along(self) -> NativeModel:
        return self._part("tangents")

    def along_parameters(self) -> NativeModel:
        return self._part("parameter_tangents")

    @without_collection()
    def _made(self, part: str | None) -> bytes:
        """The tape with the functions that are called `part`; those of several states are on every tape."""
        return self._tapes.tape(parts=(part,) if part in PARTS else ())

    @property
    def _crowd(self) -> int:
        """Functions of several states are on every tape."""
        return _CROWD
