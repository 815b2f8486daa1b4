"""Rows of a matrix: defined by one equation each, from the row before, and read without their neighbors."""

from __future__ import annotations

import numpy as np
import pytest

import lagdsl

MODEL = """
model Recursion
  coordinate Length x;
  kinetic 1/2*(1 kg)*der(x)^2;
  Real w[4, 3];
  output Real last[3] = w[4];
  output Real column[4] = w[:, 2];
equation
  w[1] = {1, 2, 3};
  for i in 1:2 loop
    w[i + 1{all}] = {w[i, 2], w[i, 3], w[i]*w[i]};
  end for;
  w[4, 1] = w[3]*{1, 0, 0};
  w[4, 2] = w[4, 1] + 1;
  w[4, 3] = time/(1 s);
end Recursion;
"""


@pytest.mark.parametrize("colon", ["", ", :"])
def test_a_row_follows_from_the_one_before(colon: str) -> None:
    model = lagdsl.compile(MODEL.replace("{all}", colon))
    rows = [[1.0, 2.0, 3.0]]
    for _ in range(2):
        rows.append([rows[-1][1], rows[-1][2], float(np.dot(rows[-1], rows[-1]))])
    rows.append([rows[2][0], rows[2][0] + 1, 0.25])
    out = model.output(0.25, [0.0], [0.0])
    np.testing.assert_allclose(out[:3], rows[3], rtol=1e-15)
    np.testing.assert_allclose(out[3:], np.array(rows)[:, 1], rtol=1e-15)


@pytest.mark.parametrize(
    ("second", "code"),
    [
        ("w[2, 2] = 5;", "E0319"),  # inside a row that is given
        ("w[4] = {0, 0, 0};", "E0319"),  # around elements that are given
        ("w[2, 1, 1] = 5;", "E0341"),
    ],
)
def test_an_element_has_one_definition(second: str, code: str) -> None:
    text = MODEL.replace("{all}", "").replace("end Recursion", f"  {second}\nend Recursion")
    assert code in [found.code for found in lagdsl.check(text)]


def test_a_row_that_needs_itself_is_a_circle() -> None:
    text = MODEL.replace("{all}", "").replace("w[1] = {1, 2, 3};", "w[1] = {1, w[1, 1], 3};")
    codes = [found.code for found in lagdsl.check(text) if found.severity == "error"]
    assert codes == ["E0305"]


def test_a_faulty_row_is_told_once() -> None:
    text = MODEL.replace("{all}", "").replace("w[1] = {1, 2, 3};", "w[1] = {1, 2};")
    errors = [found for found in lagdsl.check(text) if found.severity == "error"]
    assert len(errors) == 1
