"""Engines by name."""

from __future__ import annotations

from typing import TYPE_CHECKING

from lagdsl.engines.runtime.engines.engine import ENGINES, EngineName

if TYPE_CHECKING:
    from lagdsl.derivation.program.program import Program
    from lagdsl.engines.runtime.engines.broadcast import BatchEngine


def engine_of(program: Program, name: EngineName = "auto", *, together: bool = False) -> BatchEngine:
    """Engine of the functions of `program`: `tape` at once and without a compiler, `c` compiled for this processor,
    `auto` the tape, and C where that pays; `numpy` functions in Python, to compare with. `together`: for many runs.

    Raises CompilationFailed where `c` is asked for and no C compiler is found.
    """
    match name:
        case "auto":
            from lagdsl.engines.runtime.engines.auto_engine import AutoEngine

            return AutoEngine(program, together=together)
        case "tape":
            from lagdsl.engines.runtime.engines.tape_engine import TapeEngine

            return TapeEngine(program, together=together)
        case "numpy":
            from lagdsl.engines.runtime.engines.numpy_engine import NumpyEngine

            return NumpyEngine(program)
        case "c":
            from lagdsl.engines.runtime.engines.c_engine import CEngine

            return CEngine(program, together=together)
        case _:
            raise ValueError(f"there is no engine `{name}`; there are {', '.join(ENGINES)}")
