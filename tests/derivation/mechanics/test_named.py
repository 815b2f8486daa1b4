"""Every named value of a model and how it changes: closed forms, differences with fifty digits, all engines alike."""

from __future__ import annotations

import math
from pathlib import Path
from typing import Any

import mpmath
import numpy as np
import pytest
from choice import chosen, spread
from named_models import compiled

from lagdsl.algebra.graph.evaluate import evaluate
from lagdsl.algebra.graph.operation import DIRECTION_OF, Group
from lagdsl.derivation.program.program import Program
from lagdsl.derivation.program.verify import verify
from lagdsl.engines.runtime.engines.c_engine import CEngine
from lagdsl.engines.runtime.engines.numpy_engine import NumpyEngine
from lagdsl.motion.pipeline import with_names

SWING = """
model Swing
  parameter Length l = 2 m;
  parameter Mass m = 0.5 kg;
  input Torque tau(start = 0.3 N.m);
  structural parameter Integer n = 3;
  coordinate Angle theta(start = 0.4 rad, der(start = 1 rad/s));
  state Real charge(unit = "m", start = l + 1 m);
  Velocity v = l*der(theta);
  Length half = l/2;
  AngularAcceleration a = der(der(theta));
  Real thrice = n*half/(1 m);
  Velocity w = count*v;
  discrete Real count(start = 0);
  gravity = -g_n*world.y;
  mass m at {l*sin(theta), -l*cos(theta)};
  torque tau on theta;
equation
  der(charge) = l*der(theta)*sin(theta);
  when theta > half/(1 m) then
    count = pre(count) + 1;
  end when;
end Swing;
"""

MODELS = ("four_bar", "quarter_car", "furuta_swing_up", "newtons_cradle", "rolling_coin", "maglev")
STEP = mpmath.mpf("1e-17")
TANGENTS = {
    "definition_tangent": "definition",
    "start_tangent": "start",
    "energies_tangent": "energies",
    "initial_equation_tangent": "initial_equation",
}


def state(program: Program) -> dict[Group, np.ndarray]:
    """A state in general position with directions of everything; discretes as at the start."""
    rng = np.random.default_rng(11)
    layout = program.layout
    groups = [group for group in Group if group not in (Group.TIME, Group.RELEASE, Group.RELEASE_RATE)]
    found = {group: rng.uniform(0.2, 0.9, layout.size(group)) for group in groups}
    found[Group.P] = np.array(layout.defaults)
    found[Group.W] = np.zeros(layout.size(Group.W))
    return found


def arguments(program: Program, function: str, at: dict[Group, np.ndarray]) -> list[float | np.ndarray]:
    return [0.3 if group is Group.TIME else at[group] for group in program.function(function).arguments]


def test_values_by_closed_form() -> None:
    program = with_names(compiled(SWING))
    verify(program)
    assert [slot.name for slot in program.layout.definitions][:2] == ["half", "thrice"]
    at = state(program)
    at[Group.W][0] = 4.0
    (l, _), (theta,), (rate,) = at[Group.P], at[Group.Q], at[Group.QD]
    expected = {"half": l / 2, "thrice": 3 * l / 2, "v": l * rate, "a": at[Group.QDD][0], "w": 4 * l * rate}
    dl, dtheta, drate = at[Group.DIRECTION_P][0], at[Group.DIRECTION_Q][0], at[Group.DIRECTION_QD][0]
    dv = dl * rate + l * drate
    changes = {"half": dl / 2, "thrice": 1.5 * dl, "v": dv, "a": at[Group.DIRECTION_QDD][0], "w": 4 * dv}
    names = [slot.name for slot in program.layout.definitions]
    assert set(names) == set(expected)
    for engine in (NumpyEngine(program), CEngine(program)):
        (values,) = engine.evaluate("definition", *arguments(program, "definition", at))
        assert values == pytest.approx([expected[name] for name in names], rel=1e-14)
        (along,) = engine.evaluate("definition_tangent", *arguments(program, "definition_tangent", at))
        assert along == pytest.approx([changes[name] for name in names], rel=1e-14)
        start = engine.evaluate("start_tangent", *arguments(program, "start_tangent", at))
        assert [list(block) for block in start] == [[0.0], [0.0], [dl], [0.0]]
        _, _, potential, _ = engine.evaluate("energies_tangent", *arguments(program, "energies_tangent", at))
        m, dm, g = at[Group.P][1], at[Group.DIRECTION_P][1], 9.80665
        change = -g * ((dm * l + m * dl) * math.cos(theta) - m * l * math.sin(theta) * dtheta)
        assert float(potential) == pytest.approx(change, rel=1e-13)


def test_simulations_go_without() -> None:
    compilation = compiled(SWING)
    assert not compilation.program.has("definition")
    assert compilation.program.layout.definitions == ()


@pytest.mark.parametrize("name", chosen(MODELS, ("quarter_car", "furuta_swing_up", "maglev")))
def test_tangents_by_differences_with_fifty_digits(root: Path, name: str) -> None:
    program = with_names(compiled(root / "models" / f"{name}.lag"))
    verify(program)
    at = state(program)
    with mpmath.workdps(50):
        ahead, behind = (moved(at, sign * STEP) for sign in (1, -1))
        for tangent, function in TANGENTS.items():
            blocks = program.function(tangent).results
            of = [n for block in program.function(function).results[: len(blocks)] for n in block.elements]
            plus, minus = (evaluate(program.graph, of, given) for given in (ahead, behind))
            expect(program, tangent, at, plus, minus)


@pytest.mark.parametrize("name", spread((*MODELS, "kapitza_pendulum", "ball_on_moving_table"), 3))
def test_change_in_time_by_differences_with_fifty_digits(root: Path, name: str) -> None:
    program = with_names(compiled(root / "models" / f"{name}.lag"))
    at = state(program)
    timed = ("residual", "position_constraint", "velocity_constraint", "state_derivative", "output", "energies")
    firsts = ("position_constraint", "velocity_constraint")
    functions = [(program.function(f).results, f in firsts) for f in (*timed, "definition")]
    of = [n for blocks, first in functions for block in blocks[: 1 if first else None] for n in block.elements]
    with mpmath.workdps(50):
        given = moved(at, mpmath.mpf(0))
        ahead, behind = ({**given, Group.TIME: given[Group.TIME] + sign * STEP} for sign in (1, -1))
        plus, minus = (evaluate(program.graph, of, there) for there in (ahead, behind))
        expect(program, "time_tangent", at, plus, minus)


def expect(program: Program, tangent: str, at: dict[Group, np.ndarray], plus: list[Any], minus: list[Any]) -> None:
    """Both engines give the difference quotient."""
    expected = [float((a - b) / (2 * STEP)) for a, b in zip(plus, minus, strict=True)]
    for engine in (NumpyEngine(program), CEngine(program)):
        found = engine.evaluate(tangent, *arguments(program, tangent, at))
        ours = np.concatenate([np.ravel(block) for block in found])
        np.testing.assert_allclose(ours, expected, rtol=1e-11, atol=1e-11 * max([1.0, *map(abs, expected)]))


def moved(at: dict[Group, np.ndarray], step: mpmath.mpf) -> dict[Group, Any]:
    """Every argument moved along its direction; time and discretes stay."""
    given: dict[Group, Any] = {group: [mpmath.mpf(float(x)) for x in values] for group, values in at.items()}
    for group, direction in DIRECTION_OF.items():
        given[group] = [x + step * d for x, d in zip(given[group], given[direction], strict=True)]
    given[Group.TIME] = mpmath.mpf(0.3)
    return given
