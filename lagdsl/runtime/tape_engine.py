"""The engine over a tape: the functions of a program interpreted by the C runtime, at once and without a compiler."""

from __future__ import annotations

from lagdsl.backends.tape.emit import PARTS, tape
from lagdsl.runtime.c_engine import CEngine
from lagdsl.runtime.native_model import NativeModel
from lagdsl.runtime.tape_model import load_tape


class TapeEngine(CEngine):
    """As CEngine. Nothing is compiled."""

    def _provide(self, part: str | None = None) -> NativeModel:
        return load_tape(tape(self._program, parts=() if part not in PARTS else (part,)), part)
