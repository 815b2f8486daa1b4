"""Entries of matrices: none is missing, and those of a chain are a band."""

from __future__ import annotations

import numpy as np
import pytest
from choice import examples
from hypothesis import given, settings
from hypothesis import strategies as st

import lagdsl
from lagdsl.derivation.program.passes.pattern import equations_pattern, patterns
from lagdsl.engines.runtime.engines.tape_engine import TapeEngine
from lagdsl.foundation.diagnostics import Sink
from lagdsl.foundation.numerics.reverse_cuthill_mckee import reverse_cuthill_mckee
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


NET = """
model Net "masses in a row, each before a lag, two tied, and a double pendulum: equations of one read its neighbours"
  structural parameter Integer N = 24;
  coordinate Length x[N](start = {0.01 m*i for i in 1:N});
  state Length z[N];
  coordinate Angle a(start = 0.3 rad), b(start = 0.2 rad);
  mass 1 kg at {(1 m)*cos(a), (1 m)*sin(a)};
  mass 1 kg at {(1 m)*(cos(a) + cos(b)), (1 m)*(sin(a) + sin(b))};
  for i in 1:N loop
    kinetic 1/2*(1 kg)*der(x[i])^2;
    dissipation 1/2*(3 N.s/m)*der(x[i])^2;
  end for;
  for i in 1:N-1 loop
    potential 1/2*(50 N/m)*(x[i+1] - x[i])^2*(1 + x[i]*(1 m^-1));
  end for;
  force (2 N/m)*z[1] on x[1];
equation
  for i in 1:N loop
    der(z[i]) = (x[i] - z[i])/(0.1 s);
  end for;
  constraint x[1] + x[2] = 0.03 m;
end Net;
"""


def told_derivatives(model: lagdsl.Model, rng: np.random.Generator) -> np.ndarray:
    """Of r, zd - g and s by q, qd, z, qdd and lam at a state, by differences."""
    engine, layout = model._engine, model._compilation.program.layout
    nq, nz, nc = len(layout.coordinates), len(layout.states), len(layout.constraints)
    given = rng.uniform(0.1, 0.5, 3 * nq + nz + nc)

    def equations(x: np.ndarray) -> np.ndarray:
        q, qd, z, qdd, lam = np.split(x, np.cumsum([nq, nq, nz, nq]))
        solved = (0.0, q, qd, z, np.zeros(0), np.zeros(0), np.array(layout.defaults), qdd, lam)
        r, s = engine.evaluate("residual", *solved)
        return np.concatenate([r, engine.evaluate("state_derivative", *solved)[0], s])

    steps = 1e-6 * np.eye(len(given))
    return np.array([(equations(given + step) - equations(given - step)) / 2e-6 for step in steps]).T


def test_equations_depend_on_what_is_told() -> None:
    model = lagdsl.compile(NET)
    told = equations_pattern(model._compilation.program)
    nq, nz, nc = len(model.coordinates), len(model.states), 1
    rng = np.random.default_rng(1)
    slopes = sum(abs(told_derivatives(model, rng)) for _ in range(2))
    expected = dense(slopes.shape, told.entries)
    assert not np.any((slopes > 1e-6) & ~expected)
    assert np.sum(expected & (slopes <= 1e-6)) == 2  # an arm's own rate, whose terms cancel
    assert sorted(told.places) == list(range(nq + nz + nc))
    state = 2 * nq + nz
    of_values = expected[:, state:].copy()
    of_values[:nq, nq:] = of_values[nq + nz :] = False  # J' and J
    for groups, entries in ((told.groups, expected[:, :state]), (told.value_groups, of_values)):
        for group in range(max(groups) + 1):
            assert np.max(np.sum(entries[:, np.array(groups) == group], axis=1)) <= 1


def test_what_saves_little_is_not_told() -> None:
    assert not equations_pattern(compiled(ARMS).program).places


@settings(max_examples=examples(20), deadline=None)
@given(st.integers(2, 30), st.integers(0, 2**31))
def test_a_ladder_has_its_least_band(rungs: int, seed: int) -> None:
    """Two rails: its least band is 2, and one triangle tells the graph. Rows alone are parts by themselves."""
    name = np.random.default_rng(seed).permutation(2 * rungs + 3).tolist()
    rungs_and_rails = [(2 * i, 2 * i + 1) for i in range(rungs)] + [(i, i + 2) for i in range(2 * rungs - 2)]
    entries = [(name[i], name[j]) for i, j in rungs_and_rails]
    order = reverse_cuthill_mckee(len(name), entries)
    assert sorted(order) == list(range(len(name)))
    place = np.argsort(order)
    assert max(abs(int(place[i] - place[j])) for i, j in entries) == 2
