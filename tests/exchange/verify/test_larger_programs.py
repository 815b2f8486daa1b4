"""Models whose program leaves the mass matrix to be formed column by column."""

from __future__ import annotations

from pathlib import Path

import lagdsl
from lagdsl.derivation.program.passes.written_out import written_out
from lagdsl.engines.runtime.engines.selection import engine_of
from lagdsl.exchange.verify.equations import solutions
from lagdsl.exchange.verify.states import random_states

MODEL = Path(__file__).parents[3] / "models" / "library" / "flexible_strip.lag"


def test_its_accelerations_satisfy_the_equations() -> None:
    compilation = lagdsl.compile(MODEL)._compilation
    program = compilation.program
    assert not program.has("dynamics")
    states = random_states(compilation.flat, program, 2)
    line = solutions(written_out(program), engine_of(program, "tape"), states)
    assert line.figure is not None and line.limit is not None and line.figure <= line.limit
