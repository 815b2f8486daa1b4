"""Rows of constraints that are far smaller than others are multiplied; what is told of them is that of the text."""

from __future__ import annotations

import numpy as np
import pytest
from attack.rows import model

import lagdsl

# Two masses of 1 that three rods of a parallelogram hold in one direction, pushed by 1.
TEXT = (
    "coordinate Real x, y, z; parameter Real e = {e}; kinetic 1/2*(der(x)^2 + der(y)^2 + der(z)^2); force 1 on x;"
    "constraint big: x = y; constraint small: {row};"
)


def _factors(text: str) -> tuple[float, ...]:
    return lagdsl.compile(text)._compilation.program.layout.row_factors


@pytest.mark.parametrize("small", [1e-5, 1e-12, 1e-30, 1e-200])
@pytest.mark.parametrize("row", ["{0}*y = {0}*z", "e*(y - z) = 0", "(if time < 1 then 0 else e*(y - z)) = 0"])
def test_small_rows_become_as_long_as_others(small: float, row: str) -> None:
    one, factor = _factors(model(TEXT.format(e=small, row=row.format(small))))
    assert one == 1.0
    assert 0.5 <= factor * small <= 2.0
    assert np.log2(factor) == round(np.log2(factor))


def test_rows_of_like_size_stay() -> None:
    assert _factors(model(TEXT.format(e=1e-3, row="e*y = e*z"))) == ()


def test_round_off_is_no_row() -> None:
    """The velocity of the point of contact along the axis of a coin is a sum of terms of size 1 that is zero."""
    assert _factors("models/rolling_coin.lag") == ()


def test_both_derivations_tell_the_multiplier_of_the_text() -> None:
    text = model(TEXT.format(e=1e-12, row="e*y = e*z") + "output Real force = -e*multiplier(small);")
    for derivation in ("graph", "textbook"):
        motion = lagdsl.compile(text, derivation=derivation).simulate(stop=1.0)
        assert motion["force"][-1] == pytest.approx(1 / 3, rel=1e-12)
        assert motion["x"][-1] == pytest.approx(1 / 6, rel=1e-9)


def test_the_derivation_shows_the_row_of_the_text() -> None:
    small = lagdsl.compile(model(TEXT.format(e=1e-12, row="e*y = e*z")))
    assert "e (y − z) = 0" in small.derive().to("text")


@pytest.mark.parametrize(("compiled", "given", "name"), [(1, 1e-9, "small"), (1, 1e-30, "small"), (1e-13, 1, "big")])
@pytest.mark.parametrize("row", ["e*y = e*z", "(if time < 1 then 0 else e*(der(y) - der(z))) = 0"])
def test_parameters_that_make_a_row_small_are_refused(compiled: float, given: float, name: str, row: str) -> None:
    text = model(TEXT.format(e=compiled, row=row))
    with pytest.raises(lagdsl.CompilationFailed, match=rf"E0842.*`{name}`"):
        lagdsl.compile(text).simulate(stop=2.0, parameters={"e": given})


def test_functions_of_the_model_are_those_of_the_text() -> None:
    small = lagdsl.compile(model(TEXT.format(e=1e-12, row="e*y = e*z")))
    q, qd = np.zeros(3), np.zeros(3)
    jacobian, multipliers = small.constraint_jacobian(0.0, q), small.multipliers(0.0, q, qd)
    assert np.allclose(jacobian, [[1, -1, 0], [0, 1e-12, -1e-12]], rtol=1e-14, atol=0)
    assert np.allclose(multipliers, [-2 / 3, -1e12 / 3], rtol=1e-12)


BOUNCES = """coordinate Real y(start = 1), z(start = 1.5); kinetic 1/2*(der(y)^2 + der(z)^2);
force -8 on y; force -8 on z; contact low: {e:g}*y >= 0 with restitution = 0.5, v_stick = {stick:g};
contact high: z >= y with restitution = 0.5; output Real f = {e:g}*multiplier(low);"""


@pytest.mark.parametrize("stick", [1e-3, 1.5])
def test_a_factor_of_a_gap_changes_nothing(stick: float) -> None:
    def happened(e: float) -> tuple[list[tuple[str, str]], np.ndarray]:
        motion = lagdsl.compile(model(BOUNCES.format(e=e, stick=e * stick))).simulate(stop=3.0, tolerance=1e-10)
        assert abs(motion["f"][-1] - 16.0) < 1e-9
        return [(each.name, each.kind) for each in motion.events], np.array([each.time for each in motion.events])

    events, times = happened(1.0)
    for e in (1e-6, 1e-12, 1e-30, 1e9):
        others, when = happened(e)
        assert others == events
        assert np.max(np.abs(when - times)) < 1e-8
