"""Rows that repeat are told once; a beam of many elements fits a page."""

from __future__ import annotations

import re
from math import cos, sin

import numpy as np
import pytest

import lagdsl
from lagdsl.derivation.textbook.steps.assembled import AssembledRow, assembled_rows
from lagdsl.documents.report.sections.families import rolled
from lagdsl.foundation.diagnostics import Sink
from lagdsl.foundation.source import SourceFile
from lagdsl.language.flat import expression as fx
from lagdsl.language.flat.evaluate import Evaluator, Values
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


def test_rows_vanish_with_the_accelerations_of_the_motion() -> None:
    """Forces that the runtime computes by another derivation; the only load is the weight, which the rows have."""
    text = BEAM.replace("64", "5").replace("L = 1 m", "L = 1 m, zeta = 0.1")
    model, sink = lagdsl.compile(text), Sink()
    flat = flatten_file(SourceFile("beam.lag", text), sink)
    assert flat is not None
    rng = np.random.default_rng(2)
    q, qd = rng.uniform(-0.1, 0.1, 15), rng.uniform(-1, 1, 15)
    qdd = model.forward_dynamics(0.0, q, qd)
    rows = assembled_rows(flat)
    assert [row.coordinate for row in rows] == model.coordinates

    def value(row: AssembledRow, accelerations: np.ndarray) -> float:
        given = [dict(zip(model.coordinates, each.tolist(), strict=True)) for each in (q, qd, accelerations)]
        at = Evaluator(flat, Values(variables=given[0], rates=given[1], accelerations=given[2]))

        def number(match: re.Match[str]) -> str:
            found: fx.FlatExpression = fx.Variable(match["name"])
            for _ in range(match[0].count("der(")):
                found = fx.Derivative(found)
            return f"({at.scalar(found)!r})"

        name = re.compile(r"(?P<a>der\()?(?P<b>der\()?(?P<name>beam[\w.\[\]]+)(?(b)\))(?(a)\))")
        return float(eval(name.sub(number, row.left), {"sin": sin, "cos": cos}))

    for row in rows:
        assert abs(value(row, qdd)) < 1e-9 * abs(value(row, np.zeros(15))), row


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
