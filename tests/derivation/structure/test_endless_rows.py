"""Rows that are small far away: their zeros are elsewhere, or nowhere."""

from __future__ import annotations

import pytest

import lagdsl

TEXT = """model R
  parameter Length l = 1 m;
  coordinate Length x(start = START m), y(start = 0 m);
  kinetic 1/2*(1 kg)*(der(x)^2 + der(y)^2);
  constraint c: ROW = 0;
end R;
"""
BUMP = "(x/l)/(1 + (x/l)^2)"  # largest at x = l, zero at 0 alone


def model(row: str, start: float) -> str:
    return TEXT.replace("ROW", row).replace("START", str(start))


@pytest.mark.parametrize("start", [2, -3, 30, 100000])
def test_a_search_that_runs_away_is_told_as_such(start: float) -> None:
    """`x = 0` satisfies the row; it was said to hold never."""
    (error,) = [each for each in lagdsl.check(model(BUMP, start)) if each.severity.value == "error"]
    assert error.code == "E0802" and "without end" in error.notes[0]


def test_a_row_without_zeros_can_never_hold() -> None:
    (error,) = [each for each in lagdsl.check(model("l/x", 2)) if each.severity.value == "error"]
    assert error.code == "E0602" and "without end" in error.notes[0]


@pytest.mark.parametrize("start", [2.0, -30.0])
def test_a_start_that_is_given_to_a_run_does_not_run_away(start: float) -> None:
    """The run began at x = 4.7e14 m, with a warning that the start was moved."""
    made = lagdsl.compile(model(BUMP, 0.5), engine="tape")
    assert made.simulate(stop=0.1)["x"] == pytest.approx(0.0, abs=1e-12)
    with pytest.raises(lagdsl.CompilationFailed, match="initial position not found"):
        made.simulate(stop=0.1, start={"x": start})


def test_a_run_of_a_sweep_does_not_run_away() -> None:
    """The run with the start 2 m began at 5e14 m, and nothing was told."""
    made = lagdsl.compile(model(BUMP, 0.5), engine="tape")
    found = made.simulate_many(start={"x": [0.5, 2.0, -0.5]}, stop=0.1, interval=0.1)
    assert list(found.failures) == [1] and "initial position not found" in found.failures[1]
    assert found["x"][[0, 2]] == pytest.approx(0.0, abs=1e-12)
