"""Starts from any parameters and any start values: what they satisfy, and what cannot be satisfied."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest
from choice import EXPLORE, spread

import lagdsl
from lagdsl.derivation.structure.points import geometry
from lagdsl.foundation.diagnostics import Severity, Sink
from lagdsl.motion.simulate.initialize import InitialState, initial_state

MODELS = Path(__file__).parents[3] / "models"
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
EVERY = sorted(path.stem for path in MODELS.glob("*.lag"))

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


class _Starts:
    """Starts of one model."""

    def __init__(self, model: lagdsl.Model) -> None:
        self.flat, self.engine = model._compilation.flat, model._engine
        self.defaults = np.array(self.engine.layout.defaults, dtype=np.float64)
        coordinates = [c.name for c in self.flat.coordinates]
        self.names = [*coordinates, *(f"der({name})" for name in coordinates), *(s.name for s in self.flat.states)]

    def declared(self, p: np.ndarray) -> np.ndarray:
        return np.concatenate(self.engine.evaluate("start", self.flat.experiment.start_time, p)[:3])

    def find(self, p: np.ndarray, start: dict[str, float]) -> tuple[InitialState, list[str]]:
        sink = Sink()
        found = initial_state(self.flat, self.engine, p, start=start, sink=sink)
        return found, [d.code for d in sink.diagnostics if d.severity is Severity.ERROR]

    def check(self, p: np.ndarray, start: dict[str, float]) -> None:
        """Constraints of both levels hold, and what is fixed is as it was; or it is said that this cannot be."""
        found, codes = self.find(p, start)
        if codes:
            assert set(codes) <= {"E0801", "E0802", "E0803", "E0815", "E0831", "E0839", "E0887"}
            return
        space = geometry(self.flat, self.engine, p)
        declared = self.declared(p)
        declared[[self.names.index(name) for name in start]] = list(start.values())
        n = len(self.flat.coordinates)
        assert np.all(np.abs(space.position(found.q)[0]) <= 1e-7 * space.row_sizes)
        assert np.all(np.abs(space.velocity(found.q, found.qd)[0]) <= 1e-7 * space.row_sizes)
        for place, coordinate in enumerate(self.flat.coordinates):
            assert not coordinate.fixed or found.q[place] == declared[place]
            assert not coordinate.rate_fixed or found.qd[place] == pytest.approx(declared[n + place], abs=1e-9)


@pytest.mark.parametrize("name", EVERY if EXPLORE else spread(CHOSEN, 5))
def test_starts_satisfy_what_is_asked_for_any_parameters(name: str) -> None:
    model = lagdsl.compile(MODELS / f"{name}.lag", engine="tape")
    flat = model._compilation.flat
    if not flat.constraints:
        pytest.skip("nothing moves its start values")
    starts = _Starts(model)
    generator = np.random.default_rng(3)
    starts.check(starts.defaults, {})
    for _ in range(2):
        p = starts.defaults * (1.0 + 0.05 * generator.standard_normal(len(starts.defaults)))
        starts.check(p, {})
        picked = generator.choice(len(starts.names), size=min(2, len(starts.names)), replace=False).tolist()
        starts.check(p, {starts.names[k]: starts.declared(p)[k] + 0.2 * generator.standard_normal() for k in picked})


def test_what_cannot_be_satisfied() -> None:
    """The crank is fixed where the second rod, once it is short, does not reach down to the rail."""
    starts = _Starts(lagdsl.compile(CRANK.format(A=", fixed = true", initial="")))
    sink = Sink()
    initial_state(starts.flat, starts.engine, np.array([1.0, 0.5]), sink=sink)
    (told,) = sink.diagnostics
    assert told.code == "E0802" and f"{np.sin(np.deg2rad(40.0)) - 0.5:.3g} m" in told.message


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
    starts = _Starts(lagdsl.compile(THREE_CRANKS))
    assert starts.engine.layout.redundant.count(False) == 3
    alike, unlike = np.array([0.35, 0.35, 0.5, 0.5, 1.0]), np.array([0.3, 0.33, 0.6, 0.65, 1.0])
    found, codes = starts.find(alike, {})
    assert not codes and found.redundant.count(False) == 3 and found.freedom == 1
    assert starts.find(unlike, {})[1] == ["E0831"]


def test_initial_equations() -> None:
    """At rest where the rods are in balance, from any parameters: hanging or standing upright."""
    rest = "initial equation\n  der(A) = 0;\n  der(B) = 0;\n  der(der(A)) = 0;\n"
    starts = _Starts(lagdsl.compile(CRANK.format(A="", initial=rest)))
    for p in (starts.defaults, np.array([1.3, 2.2]), np.array([0.7, 1.9])):
        found, codes = starts.find(p, {})
        assert not codes
        assert np.sin(found.q) == pytest.approx([0.0, 0.0], abs=1e-8)
        assert found.qd == pytest.approx([0.0, 0.0], abs=1e-9)
        assert p[0] * np.sin(found.q[0]) + p[1] * np.sin(found.q[1]) == pytest.approx(0.0, abs=1e-9)
