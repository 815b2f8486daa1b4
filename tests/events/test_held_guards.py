"""Relations that the rows of their mode hold are not watched; those that merely stand still for an instant are."""

from __future__ import annotations

from math import pi

import numpy as np
import pytest
from attack.rows import model

import lagdsl

COUNT = "discrete Integer n(start = 0);"


def test_what_a_lock_holds_turns_once_however_its_value_drifts() -> None:
    """Three coordinates move on while h stays at its border: fixed steps leave it by more than round-off."""
    text = model(
        "coordinate Real a(start = 0.2, der(start = 2)), b(start = 1), c(start = 0.3);"
        "Real h = cos(a) + cos(b) + cos(c); kinetic 1/2*(der(a)^2 + 2*der(b)^2 + der(c)^2); potential -h;"
        f"discrete Boolean locked(start = false); {COUNT} constraint k: (if locked then der(h) else 0) = 0;",
        "when h < 2.3 then locked = true; n = pre(n) + 1; end when;",
    )
    motion = lagdsl.compile(text).simulate(stop=3.0, interval=0.1, solver="rk4", step=0.01)
    assert motion["n"][-1] == 1.0
    h = sum(np.cos(motion[name]) for name in "abc")
    assert np.abs(h[motion.time > 1.0] - 2.3).max() > 1e-12  # beyond round-off: a guard that is watched would turn


def test_a_row_that_prescribes_a_rate_holds_nothing() -> None:
    """x = sin t is at rest at its top, where an event is: it falls below 1 - 1e-9 all the same, four times in 25 s."""
    text = model(
        f"coordinate Real x; constraint x = sin(time); kinetic 1/2*der(x)^2; discrete Integer m(start = 0); {COUNT}",
        f"when time >= {pi / 2!r} then m = 1; end when; when x < 1 - 1e-9 then n = pre(n) + 1; end when;",
    )
    motion = lagdsl.compile(text).simulate(stop=25.0, interval=1.0)
    assert (motion["m"][-1], motion["n"][-1]) == (1.0, 4.0)


def test_a_corner_is_no_rest() -> None:
    """Another body is thrown back while this one is in the middle of its window, where |x - a| has no derivative."""
    text = model(
        "coordinate Real x(der(start = 1)), y(der(start = 1)); kinetic 1/2*(der(x)^2 + der(y)^2);" + COUNT,
        "when abs(x - 50) < 1e-7 then n = pre(n) + 1; end when; when y > 50 then reinit(der(y), -1); end when;",
    )
    motion = lagdsl.compile(text).simulate(stop=100.0, interval=50.0)
    window = [event for event in motion.events if "abs" in event.name]
    assert [event.kind for event in window] == ["true", "false"]
    assert window[1].time == pytest.approx(50 + 1e-7, abs=1e-12)
