"""Entries of matrices of the rows that are left to run time: none is missing, and those of a chain are a band."""

from __future__ import annotations

import numpy as np
import pytest

from lagdsl.derivation.program.passes.pattern import patterns
from lagdsl.engines.runtime.engines.tape_engine import TapeEngine
from lagdsl.foundation.diagnostics import Sink
from lagdsl.foundation.source import SourceFile
from lagdsl.motion.pipeline import Compilation, compile_flat, flatten_file

STACK = """
model Stack
  structural parameter Integer N = {count};
  coordinate Length h[N](start = {{0.1 m*i for i in 1:N}});
  gravity = -g_n*world.y;
  for i in 1:N loop
    mass 0.1 kg at {{0, h[i]}};
  end for;
  contact floor: h[1] >= 0.1 m with restitution = 0;
  for i in 1:N-1 loop
    contact c: h[i+1] - h[i] >= 0.1 m with restitution = 0;
  end for;
end Stack;
"""
ARMS = """
model Arms "two arms beside each other, each on a stop"
  coordinate Angle a, b, c(start = 1 rad);
  mass 1 kg at {(sin(a) + sin(b))*(1 m), (cos(a) + cos(b))*(1 m)};
  mass 1 kg at {sin(c)*(1 m), cos(c)*(1 m)};
  contact one: a + b >= 0 with restitution = 0;
  contact other: c >= 0 with restitution = 0;
end Arms;
"""


def compiled(text: str) -> Compilation:
    sink = Sink()
    flat = flatten_file(SourceFile("<text>", text), sink)
    assert flat is not None, sink.diagnostics
    made = compile_flat(flat, sink)
    assert made is not None, sink.diagnostics
    return made


def dense(shape: tuple[int, int], entries: tuple[list[int], list[int]]) -> np.ndarray:
    found = np.zeros(shape, dtype=bool)
    found[entries] = True
    return found


@pytest.mark.parametrize("count", [6, 12])
def test_a_chain_of_contacts_has_a_band(count: int) -> None:
    """Each body of its own mass: a force moves two, and each row meets its neighbours."""
    told = patterns(compiled(STACK.format(count=count)).program)
    number = np.arange(count)
    assert np.array_equal(dense(*told["coupling"]), abs(number[:, None] - number) <= 1)
    assert np.array_equal(dense(*told["response"]), (number[:, None] == number) | (number[:, None] - 1 == number))


@pytest.mark.parametrize("text", [STACK.format(count=5), ARMS], ids=["stack", "arms"])
def test_no_entry_is_missing(text: str) -> None:
    program = compiled(text).program
    engine, layout, rng = TapeEngine(program), program.layout, np.random.default_rng(1)
    told = patterns(program)
    for _ in range(3):
        q, qd = rng.normal(size=(2, len(layout.coordinates)))
        w = np.array([float(kind == "contact") for kind in layout.kinds])
        results = engine.evaluate("elimination", 0.0, q, qd, np.zeros(0), np.zeros(0), w, np.array(layout.defaults))
        response, jacobian = results[2], results[4]
        for name, matrix in (("response", response), ("coupling", jacobian @ response.T)):
            assert not np.any((abs(matrix) > 1e-12) & ~dense(*told[name])), name
            assert np.any(matrix)
