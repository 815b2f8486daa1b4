"""Starts found in C against those found in Python, which share no line: any parameters, any start values."""

from __future__ import annotations

import os
from pathlib import Path

import numpy as np
import pytest
from initial_in_c import Initial

import lagdsl
from lagdsl.diagnostics import Severity, Sink
from lagdsl.mechanics.rank import Floats
from lagdsl.mechanics.structure_points import natural_sizes
from lagdsl.pipeline import Compilation, engine_of
from lagdsl.simulate.initialize import InitialState, initial_state

MODELS = Path(__file__).parents[2] / "models"
# Closures in the plane and in space, redundant rows, wires, rolling, states of first order.
CHOSEN = (
    "bead_on_cosine_wire",
    "bead_on_circular_wire_redundant",
    "centrifugal_governor",
    "double_wishbone",
    "four_bar",
    "four_bar_spatial",
    "knife_edge",
    "rolling_coin",
    "slider_crank_components",
    "watt_governor",
)
EXPLORE = os.environ.get("LAGDSL_EXPLORE") == "1"
EVERY = sorted(path.stem for path in MODELS.glob("*.lag"))

# An instance of lag_initial_fault.
POSITIONS, RATES, EQUATIONS, RANK = 2, 3, 4, 5
OF_CODE = {"E0801": POSITIONS, "E0802": POSITIONS, "E0803": RATES, "E0815": EQUATIONS, "E0831": RANK}

CRANK = """
model Crank "a crank of two rods on a rail"
  parameter Length a = 1 m, b = 2 m;
  coordinate Angle A(start = 40 deg{A}), B(start = -20 deg);
  point P = {{a*cos(A) + b*cos(B), a*sin(A) + b*sin(B)}};
  mass 1 kg at P;
  mass 1 kg at {{a*cos(A), a*sin(A)}};
  gravity = -g_n*world.x;
  constraint rail: P.y = 0 m;
{initial}
end Crank;
"""


def _compiled(text: str) -> Compilation:
    return lagdsl.compile(text)._compilation


class _Starts:
    """Both ways to the start of one model."""

    def __init__(self, compilation: Compilation) -> None:
        flat, program = compilation.flat, compilation.program
        self.flat, self.engine, self.in_c = flat, engine_of(program, "numpy"), Initial(compilation)
        self.defaults = np.array(program.layout.defaults, dtype=np.float64)
        coordinates = [c.name for c in flat.coordinates]
        self.names = [*coordinates, *(f"der({name})" for name in coordinates), *(s.name for s in flat.states)]
        q = self.starts(self.defaults)[: len(coordinates)]
        sizes = natural_sizes(flat.coordinates, q)
        self.sizes = np.concatenate([sizes, sizes, np.ones(len(flat.states))])

    def starts(self, p: Floats) -> Floats:
        return np.concatenate(self.engine.evaluate("start", self.flat.experiment.start_time, p)[:3])

    def in_python(self, p: Floats, start: dict[int, float]) -> tuple[InitialState, list[str]]:
        sink = Sink()
        named = {self.names[entry]: value for entry, value in start.items()}
        with np.errstate(all="ignore"):
            found = initial_state(self.flat, self.engine, p, start=named, sink=sink)
        return found, [d.code for d in sink.diagnostics if d.severity is Severity.ERROR]

    def agree(self, p: Floats, start: dict[int, float]) -> None:
        found, codes = self.in_python(p, start)
        other = self.in_c.find(p, start)
        if codes:
            assert (other.status, other.fault) == (6, OF_CODE[codes[-1]])
            return
        assert (other.status, other.fault) == (0, 0)
        x = np.concatenate([found.q, found.qd, found.z])
        assert np.all(np.abs(other.x - x) <= 1e-6 * (self.sizes + np.abs(x)))


@pytest.mark.parametrize("name", EVERY if EXPLORE else CHOSEN)
def test_starts_agree_for_any_parameters(name: str) -> None:
    compilation = lagdsl.compile(MODELS / f"{name}.lag")._compilation
    if not compilation.flat.constraints and not compilation.flat.initial_equations:
        pytest.skip("nothing moves its start values")
    starts = _Starts(compilation)
    generator = np.random.default_rng(3)
    starts.agree(starts.defaults, {})
    for _ in range(2):
        p = starts.defaults * (1.0 + 0.05 * generator.standard_normal(len(starts.defaults)))
        starts.agree(p, {})
        chosen = generator.choice(len(starts.names), size=min(2, len(starts.names)), replace=False).tolist()
        moved = {
            entry: starts.starts(p)[entry] + 0.2 * starts.sizes[entry] * generator.standard_normal() for entry in chosen
        }
        starts.agree(p, moved)


def test_what_cannot_be_satisfied() -> None:
    """The crank is fixed where the second rod, once it is short, does not reach down to the rail."""
    starts = _Starts(_compiled(CRANK.format(A=", fixed = true", initial="")))
    short = np.array([1.0, 0.5])
    assert starts.in_python(short, {})[1] == ["E0802"]
    starts.agree(short, {})
    found = starts.in_c.find(short, {})
    assert found.residual == pytest.approx(np.sin(np.deg2rad(40.0)) - 0.5, rel=1e-6)


THREE_CRANKS = """
model Beam "on three parallel cranks"
  parameter Length l = 0.3 m, k = 0.3 m, d = 0.6 m, g = 0.6 m;
  parameter Inertia I = 1 kg.m2;
  coordinate Angle a(start = 40 deg), b(start = 40 deg), c(start = 40 deg), e(start = 0);
  kinetic I/2*(der(a)^2 + der(b)^2 + der(c)^2 + der(e)^2);
  constraint right_x: l*cos(a) + 2*d*cos(e) = 2*d + l*cos(c);
  constraint right_y: l*sin(a) + 2*d*sin(e) = l*sin(c);
  constraint middle_x: l*cos(a) + d*cos(e) = g + k*cos(b);
  constraint middle_y: l*sin(a) + d*sin(e) = k*sin(b);
end Beam;
"""


def test_more_independent_rows_than_before() -> None:
    """A beam on three equal cranks moves; with the middle one of another length, elsewhere, it fits but is stuck."""
    starts = _Starts(_compiled(THREE_CRANKS))
    assert starts.engine.layout.redundant.count(False) == 3
    alike, unlike = np.array([0.35, 0.35, 0.5, 0.5, 1.0]), np.array([0.3, 0.33, 0.6, 0.65, 1.0])
    starts.agree(alike, {})
    assert starts.in_c.find(alike, {}).rank == 3
    assert starts.in_python(unlike, {})[1] == ["E0831"]
    starts.agree(unlike, {})


def test_initial_equations() -> None:
    """At rest where the rods are in balance, from any parameters: hanging or standing upright."""
    rest = "initial equation\n  der(A) = 0;\n  der(B) = 0;\n  der(der(A)) = 0;\n"
    starts = _Starts(_compiled(CRANK.format(A="", initial=rest)))
    starts.agree(starts.defaults, {})
    for p in (starts.defaults, np.array([1.3, 2.2]), np.array([0.7, 1.9])):
        found = starts.in_c.find(p, {})
        x = found.x
        assert (found.status, found.fault) == (0, 0)
        assert np.sin(x[:2]) == pytest.approx([0.0, 0.0], abs=1e-8)
        assert x[2:] == pytest.approx([0.0, 0.0], abs=1e-9)
        assert p[0] * np.sin(x[0]) + p[1] * np.sin(x[1]) == pytest.approx(0.0, abs=1e-9)
