"""Instructions over strides: parts alike share their words, and give the bits of one instruction for each."""

from __future__ import annotations

import numpy as np
import pytest
from numpy.typing import NDArray

from lagdsl.derivation.program.program import Program
from lagdsl.engines.backends.tape import arrangement, nodes
from lagdsl.engines.backends.tape.emit import tape
from lagdsl.engines.backends.tape.listing import instructions
from lagdsl.engines.runtime.engines.tape_engine import TapeEngine
from lagdsl.foundation.diagnostics import Sink
from lagdsl.motion.pipeline import compile_flat, flatten_set, parse_file, read

FUNCTIONS = ("elimination", "residual", "residual_tangent", "energies")
# Masses on springs that stretch far, and a pendulum on each: sines, roots, quotients, sums of three.
ROW = """model Row
  structural parameter Integer n = 20;
  parameter Length l = 0.1 m;
  coordinate Length x[n](start = {i*l for i in 1:n}), y[n];
  coordinate Angle a[n];
  gravity = -g_n*world.y;
  for i in 1:n loop
    mass 1 kg at {x[i], y[i]};
    mass 0.2 kg at {x[i] + l*sin(a[i]), y[i] - l*cos(a[i])};
    potential 1/2*(80 N/m)*(sqrt((x[i] - (if i == 1 then 0 m else x[max(i - 1, 1)]))^2
        + (y[i] - (if i == 1 then 0 m else y[max(i - 1, 1)]))^2 + 1e-6 m2) - l)^2;
    dissipation 1/2*(0.1 N.s/m)*(der(x[i])^2 + der(y[i])^2);
  end for;
end Row;
"""


def _program(n: int) -> Program:
    sink = Sink()
    source = read(ROW, sink)
    unit = None if source is None else parse_file(source, sink)
    flat = None if unit is None else flatten_set(unit, sink, model=None, pairs={"n": str(n)})
    compilation = None if flat is None else compile_flat(flat, sink)
    assert compilation is not None, sink.diagnostics
    return compilation.program


def _solved(program: Program) -> list[NDArray[np.float64]]:
    """Accelerations of one state, of eleven states in lanes, and the Jacobian."""
    size, draw, empty = len(program.layout.coordinates), np.random.default_rng(1), np.zeros(0)
    q, qd = draw.normal(size=(11, size)), draw.normal(size=(11, size))
    p, engine = np.array(program.layout.defaults), TapeEngine(program)
    several = [np.zeros((11, 0))] * 3
    return [
        engine.solve(0.0, q[0], qd[0], empty, empty, empty, p)[0],
        engine.solve_many(np.zeros(11), q, qd, *several, np.tile(p, (11, 1)))[0],
        engine.jacobian(0.0, q[0], qd[0], empty, empty, empty, p),
    ]


@pytest.mark.parametrize("n", [17, 32, 45])
def test_parts_alike_have_the_bits_of_separate_instructions(n: int, monkeypatch: pytest.MonkeyPatch) -> None:
    program = _program(n)
    made = tape(program)
    over_strides = [each for name in FUNCTIONS for each in instructions(made, name) if each.name.startswith("STRIDED")]
    assert {each.name for each in over_strides} >= {"STRIDED_TWO_PRODUCTS", "STRIDED_MULTIPLY", "STRIDED_DIVIDE"}
    found = _solved(program)
    for module in (nodes, arrangement):
        monkeypatch.setattr(module, "LEAST", 10**9)
    assert not any(each.name.startswith("STRIDED") for each in instructions(tape(program), "elimination"))
    assert all(map(np.array_equal, found, _solved(program)))


def test_more_parts_take_few_more_words() -> None:
    """Only those of sines and results grow with their number: 15 for each part, in place of 176."""
    words = [sum(len(each.words) for each in instructions(tape(_program(n)), "elimination")) for n in (40, 80)]
    assert words[1] - words[0] < 20 * 40
