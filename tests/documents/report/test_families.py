"""Rows that repeat are told once; a beam of many elements fits a page."""

from __future__ import annotations

import re
from math import cos, sin

import numpy as np
import pytest

import lagdsl
from lagdsl.derivation.textbook.steps.assembled import assembled_rows
from lagdsl.documents.report.sections.families import rolled
from lagdsl.foundation.diagnostics import Sink
from lagdsl.foundation.source import SourceFile
from lagdsl.language.flat import expression as fx
from lagdsl.language.flat.evaluate import Evaluator, Values
from lagdsl.language.flat.model import FlatModel
from lagdsl.motion.pipeline import flatten_file

BEAM = """model Many
  Lag.Flexible.ExactBeam beam(n = 64, L = 1 m, A = 1 cm^2, I = 100 mm^4);
  gravity = -g_n*world.y;
  connect(world, beam);
end Many;
"""


@pytest.mark.parametrize(
    ("rows", "shown"),
    [
        ([("a[1]", "x[1]"), ("a[2]", "x[2] - x[1]"), ("a[3]", "x[3] - x[2]")], ["a[1]", "a[k], k = 2…3 x[k] - x[k-1]"]),
        ([(f"p[{i},{j}]", f"m[{j + 2}]") for i in (1, 2, 3) for j in (1, 2)], ["p[k,j], k = 1…3, j = 1…2 m[j+2]"]),
        ([("p[1,1]", ""), ("p[2,1]", ""), ("p[2,2]", "")], ["p[k,1], k = 1…2", "p[2,2]"]),
        ([("a[1]", "b"), ("a[4]", "b")], ["a[k], k = 1, 4 b"]),
        ([("a", "b"), ("a[1]", "c[7]"), ("a[2]", "d")], ["a b", "a[1] c[7]", "a[2] d"]),
    ],
)
def test_rows_with_like_indices_are_one(rows: list[tuple[str, ...]], shown: list[str]) -> None:
    found = [" ".join(row).strip() for row in rolled(rows)]
    assert len(found) == len(shown)
    assert all(one.startswith(other) for one, other in zip(found, shown, strict=True)), found


def test_a_beam_of_many_elements_fits_a_page() -> None:
    told = str(lagdsl.compile(BEAM).derive())
    assert len(told.splitlines()) < 80
    assert told.count("beam.stretch[k]^2") == told.count("potential, k = 1…64") == 1
    for strain in (
        "beam.stretch[k], k = 1…64  (cos(beam.middle[k])*beam.dx[k] + sin(beam.middle[k])*beam.dy[k])/beam.l - 1",
        "beam.slide[k], k = 1…64    (cos(beam.middle[k])*beam.dy[k] - sin(beam.middle[k])*beam.dx[k])/beam.l",
        "beam.turn[k], k = 2…64     beam.q[k] - beam.q[k-1]",
    ):
        assert strain in told


def test_a_typical_row_of_a_beam_is_told_with_its_neighbours() -> None:
    """The mass matrix of linear shape functions: O. C. Zienkiewicz and R. L. Taylor, Finite Element Method, 16.2."""
    told = str(lagdsl.compile(BEAM).derive())
    left = "beam.density*beam.A*beam.l*der(der(beam.x["
    assert (
        told.count("beam.x[k], k = 2…63") == told.count("beam.y[k], k = 2…63") == told.count("beam.q[k], k = 2…63") == 1
    )
    assert f"{left}k-1]))/6 + 2*{left}k]))/3 + {left}k+1]))/6 + beam.E*beam.A*beam.stretch[k]" in told


SHORT = """model Short
  frame clamp = world.move({0.1 m, 0.2 m, 0}).rotz(40 deg);
  Lag.Flexible.%s;
  gravity = -g_n*world.y;
  connect(clamp, beam);
end Short;
"""
BEAMS = {
    "planar": "ExactBeam beam(n = 5, L = 1 m, zeta = 0.1, A = 1 cm^2, I = 100 mm^4)",
    "cable": "Cable beam(n = 3, dim = 2, clamped = true, L = 1 m, zeta = 0.1, A = 1 cm^2, E = 1 MPa)",
    "cable in space": "Cable beam(n = 2, L = 1 m, zeta = 0.1, A = 1 cm^2, E = 1 MPa)",
}


@pytest.mark.parametrize("beam", BEAMS.values(), ids=BEAMS)
def test_rows_vanish_with_the_accelerations_of_the_motion(beam: str) -> None:
    """Forces that the runtime computes by another derivation; the only load is the weight, which the rows have."""
    text = SHORT % beam
    model, sink = lagdsl.compile(text), Sink()
    flat = flatten_file(SourceFile("beam.lag", text), sink)
    assert flat is not None
    rng = np.random.default_rng(2)
    start = model.initial_state().q
    q, qd = start + rng.uniform(-0.05, 0.05, len(start)), rng.uniform(-1, 1, len(start))
    qdd = model.forward_dynamics(0.0, q, qd)
    rows = assembled_rows(flat)
    assert [row.coordinate for row in rows] == model.coordinates
    for row in rows:
        terms = _Terms(flat, dict(zip(model.coordinates, q.tolist(), strict=True)), qd.tolist())
        rest, whole = (terms.value(row.left, each.tolist()) for each in (qdd, np.zeros(len(q))))
        assert abs(rest) < 1e-7 * (abs(whole) + 1e-3), row


# A sum without one inside: weights and their letter, summand, letter, last index.
SUM = r"sum\((?:\{([^}]*)\}\[(?:[ic])\]\*)?((?:(?!sum\().)*?) for ([ic]) in 1:(\d+)\)"


class _Terms:
    """Values of rows as they are printed."""

    NAME = r"beam(?:\.\w+(?:\[[\d,]+\])?)+"

    def __init__(self, flat: FlatModel, places: dict[str, float], rates: list[float]) -> None:
        self.flat, self.places, self.rates = flat, places, dict(zip(places, rates, strict=True))

    def value(self, left: str, accelerations: list[float]) -> float:
        self.accelerations = dict(zip(self.places, accelerations, strict=True))
        text, before = left, ""
        while text != before:  # inner sums first
            text, before = re.sub(SUM, self._sum, text), text
        text = re.sub(rf"d\(({self.NAME})\)/d\(({self.NAME})\)", self._partial, text)
        text = re.sub(rf"(?P<a>der\()?(?P<b>der\()?(?P<name>{self.NAME})(?(b)\))(?(a)\))", self._number, text)
        return float(eval(text.replace("^", "**"), {"sin": sin, "cos": cos}))

    def _sum(self, match: re.Match[str]) -> str:
        weights, inner, letter, count = match[1], match[2], match[3], int(match[4])
        factors = weights.split(",") if weights else ["1"] * count
        index = rf"(?<=[\[,]){letter}(?=[,\]])"
        terms = [f"{weight}*{re.sub(index, str(k + 1), inner)}" for k, weight in enumerate(factors)]
        return f"({'+'.join(terms)})"

    def _partial(self, match: re.Match[str]) -> str:
        step = 1e-5
        values = []
        for shift in (step, -step):
            places = {**self.places, match[2]: self.places[match[2]] + shift}
            values.append(Evaluator(self.flat, Values(variables=places)).scalar(fx.Variable(match[1])))
        return f"({(values[0] - values[1]) / (2 * step)!r})"

    def _number(self, match: re.Match[str]) -> str:
        found: fx.FlatExpression = fx.Variable(match["name"])
        for _ in range(match[0].count("der(")):
            found = fx.Derivative(found)
        at = Values(variables=self.places, rates=self.rates, accelerations=self.accelerations)
        return f"({Evaluator(self.flat, at).scalar(found)!r})"


def test_a_typical_row_of_a_cable_has_the_masses_of_cubic_functions() -> None:
    """The consistent mass matrix of Hermite's cubics, rho A l/420 (156, 54, 22 l, 13 l, 4 l^2, 3 l^2): J. S.
    Przemieniecki, Theory of Matrix Structural Analysis, section 11.4; and the virtual work of strains: J. Gerstmayr and
    H. Irschik, J. Sound Vib. 318 (2008) 461."""
    told = str(lagdsl.compile(BEAM.replace("ExactBeam", "Cable").replace(", I = 100 mm^4", "")).derive())
    line = next(line for line in told.splitlines() if "beam.r[k,j], k = 2…63, j = 1, 3" in line)
    mass = "beam.density*beam.A*beam.l"
    for part in (
        f"9*{mass}*der(der(beam.r[k-1,j]))/70 + 13*{mass}^2*der(der(beam.s[k-1,j]))/420",
        f"26*{mass}*der(der(beam.r[k,j]))/35",
        f"9*{mass}*der(der(beam.r[k+1,j]))/70 - 13*{mass}^2*der(der(beam.s[k+1,j]))/420",
        "beam.element[k].EA*beam.element[k].strain[i]*d(beam.element[k].strain[i])/d(beam.r[k,j])",
        "beam.element[k+1].EI*beam.element[k+1].curvature[c,i]*d(beam.element[k+1].curvature[c,i])/d(beam.r[k,j])",
    ):
        assert part in line
    (last,) = (line for line in told.splitlines() if "beam.s[64,k], k = 1, 3" in line)
    assert f"- 11*{mass}^2*der(der(beam.r[64,k]))/210 + {mass}^3*der(der(beam.s[64,k]))/105" in last
    assert f"- {mass}^3*der(der(beam.s[63,k]))/140" in last


def test_rows_of_another_form_are_not_told() -> None:
    """A pendulum turns: its mass matrix in other coordinates is not constant."""
    pendulum = """model Swing
  coordinate Angle q;
  mass 1 kg at {(1 m)*sin(q), -(1 m)*cos(q), 0};
end Swing;
"""
    flat = flatten_file(SourceFile("swing.lag", pendulum), Sink())
    assert flat is not None and assembled_rows(flat) == []
    assert "Equations of the coordinates" not in str(lagdsl.compile(swinging_chain()).derive())


def swinging_chain() -> str:
    """Seven coordinates, which are too many to be written out."""
    return """model Chain
  coordinate Angle q[7];
  gravity = -g_n*world.y;
  for i in 1:7 loop
    mass 1 kg at {sum(sin(q[j]) for j in 1:i)*(1 m), -sum(cos(q[j]) for j in 1:i)*(1 m), 0};
  end for;
end Chain;
"""
