"""Derivatives by state, inputs and parameters: both engines, against differences of the motion itself."""

from __future__ import annotations

from itertools import product
from pathlib import Path

import numpy as np
import pytest
from choice import chosen
from numpy.typing import NDArray

import lagdsl
from lagdsl.interfaces.api.model import Model

MODELS = Path(__file__).parents[3] / "models"
# Without constraints and with: kept for run time, solved before it, both; states, inputs and outputs.
NAMES = [
    "cart_double_pendulum",
    "robot_arm",
    "motor_pendulum",
    "four_bar",
    "bicycle",
    "rolling_coin",
    "free_rigid_body",
]
ENGINES = ["numpy", "c"]
# Compiling all functions of the other two takes a quarter of a minute each.
COMPILED = ["cart_double_pendulum", "motor_pendulum", "four_bar", "rolling_coin", "free_rigid_body"]
# In proportion to what is varied.
STEP = 1e-3
# Central differences of eighth order: -k and k steps count by these.
WEIGHTS = {1: 4 / 5, 2: -1 / 5, 3: 4 / 105, 4: -1 / 280}

State = dict[str, NDArray[np.float64]]


def _state(model: Model, seed: int) -> State:
    draw = np.random.default_rng(seed)
    start = model.initial_state()
    return {
        "q": start.q + 0.1 * draw.normal(size=start.q.shape),
        "qd": draw.normal(size=start.qd.shape),
        "z": start.z + 0.1 * draw.normal(size=start.z.shape),
        "u": 0.3 * draw.normal(size=len(model.inputs)),
        "p": model.defaults * draw.uniform(0.9, 1.1, len(model.defaults)),
    }


def _motion(model: Model, at: State) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
    """qd, qdd and y at many states."""
    given = {name: at[name] for name in ("z", "u", "p")}
    qdd = model.forward_dynamics(0.2, at["q"], at["qd"], **given)
    y = model.output(0.2, at["q"], at["qd"], **given)
    return np.concatenate([np.broadcast_to(at["qd"], qdd.shape), qdd], axis=-1), y


def _differences(model: Model, at: State, names: tuple[str, ...]) -> list[list[NDArray[np.float64]]]:
    """Of qd, qdd and of y, by the entries of `names` in a row: each with what rounding errors make of it."""
    columns: list[list[NDArray[np.float64]]] = [[], []]
    noise: list[list[NDArray[np.float64]]] = [[], []]
    levels = [np.max(np.abs(block), initial=0.0) for block in _motion(model, at)]
    for name in names:
        steps = STEP * np.maximum(np.abs(at[name]), 0.1 if name != "p" else 1e-9) * np.eye(len(at[name]))
        total: list[NDArray[np.float64]] | None = None
        for count, weight in WEIGHTS.items():
            above, below = (_motion(model, at | {name: at[name] + sign * count * steps}) for sign in (1.0, -1.0))
            change = [weight * (a - b) for a, b in zip(above, below, strict=True)]
            total = change if total is None else [x + y for x, y in zip(total, change, strict=True)]
        assert total is not None
        size = np.diag(steps)
        for which, (difference, level) in enumerate(zip(total, levels, strict=True)):
            columns[which].append((difference / size[:, None]).T)
            noise[which].append(1e-14 * level / size)
    return [[np.concatenate(c, axis=1), np.concatenate(e)] for c, e in zip(columns, noise, strict=True)]


@pytest.mark.parametrize(
    ("name", "engine"),
    chosen(product(NAMES, ENGINES), [(name, "numpy") for name in NAMES[::3]] + [(name, "c") for name in COMPILED[:1]]),
)
def test_derivatives_are_those_of_the_motion(name: str, engine: str) -> None:
    model = lagdsl.compile(MODELS / f"{name}.lag", engine=engine)  # type: ignore[arg-type]
    n = len(model.coordinates)
    wanted = {"state": ("q", "qd", "z"), "input": ("u",), "parameter": ("p",)}
    for seed in range(2):
        at = _state(model, seed)
        given = (0.2, at["q"], at["qd"], at["z"], at["u"], None, at["p"])
        found = {
            "state": model.state_jacobian(*given),
            "input": model.input_jacobian(*given),
            "parameter": model.parameter_jacobian(*given),
        }
        for by, names in wanted.items():
            rates, outputs = _differences(model, at, names)
            _assert_near(found[by][: 2 * n], *rates)
            _assert_near(model.output_jacobian(*given, by=by), *outputs)


def _assert_near(found: NDArray[np.float64], expected: NDArray[np.float64], noise: NDArray[np.float64]) -> None:
    assert found.shape == expected.shape
    size = np.abs(expected).max(axis=0, keepdims=True, initial=0.0)
    wrong = np.abs(found - expected) > 1e-9 * size + noise
    assert not wrong.any(), (found[wrong][:3], expected[wrong][:3])


@pytest.mark.parametrize("engine", ENGINES)
def test_derivatives_broadcast_over_leading_axes(engine: str) -> None:
    model = lagdsl.compile(MODELS / "motor_pendulum.lag", engine=engine)  # type: ignore[arg-type]
    n, k, m = len(model.coordinates), len(model.states), len(model.defaults)
    q = np.linspace(-1, 1, 6 * n).reshape(3, 2, n)
    p = model.defaults * np.array([[1.0], [1.1]])
    assert model.input_jacobian(0.0, q, np.zeros(n), p=p).shape == (3, 2, 2 * n + k, len(model.inputs))
    many = model.parameter_jacobian(0.0, q, np.zeros(n), p=p)
    assert many.shape == (3, 2, 2 * n + k, m)
    one = model.parameter_jacobian(0.0, q[2, 1], np.zeros(n), p=p[1])
    np.testing.assert_allclose(many[2, 1], one, rtol=1e-12, atol=1e-12)
    assert model.output_jacobian(0.0, q, np.zeros(n)).shape == (3, 2, len(model.outputs), 2 * n + k)


@pytest.mark.parametrize("engine", ENGINES)
def test_what_to_differentiate_by_is_one_of_three_words(engine: str) -> None:
    model = lagdsl.compile(MODELS / "pendulum.lag", engine=engine)  # type: ignore[arg-type]
    with pytest.raises(ValueError, match="by state, input, parameter, not by 'time'"):
        model.output_jacobian(0.0, [0.1], [0.0], by="time")
