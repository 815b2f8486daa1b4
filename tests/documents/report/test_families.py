"""Rows that repeat are told once; a beam of many elements fits a page."""

from __future__ import annotations

import pytest

import lagdsl
from lagdsl.documents.report.sections.families import rolled

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
