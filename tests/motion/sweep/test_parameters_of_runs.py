"""Parameters of many runs are checked as those of a single one; columns of many runs come together by their names."""

from __future__ import annotations

import numpy as np
import pytest

import lagdsl
from lagdsl.engines.runtime.engines.tape_engine import TapeEngine
from lagdsl.motion.pipeline import Compilation
from lagdsl.motion.sweep.dataset import collect
from lagdsl.motion.sweep.ensemble import Ensemble
from lagdsl.motion.sweep.plan import Task
from lagdsl.motion.sweep.run import Options, Outcome

TEXT = """model Checked
  parameter Mass m = 1 kg;
  parameter Mass M(min = 0.1 kg, max = 5 kg) = 1 kg;
  parameter Length a = 1 m;
  parameter Acceleration g = 9.81 m/s2;
  parameter Real shift = 0.5;
  parameter Integer teeth = 3;
  Real ratio = 1/(teeth - 1);
  coordinate Length h(start = 1 m);
  gravity = -g*world.y;
  mass m at {0, h + shift*a};
  mass M at {1/a*(1 m2), h};
  mass (m + M)*(a/(1 m)) at {a, h};
end Checked;
"""
VALUES = {
    "m": (1.0, 0.0, -1.0),
    "M": (1.0, 0.1, 0.05, 5.0, 6.0),
    "a": (1.0, -1.0),
    "g": (9.81, 0.0),
    "shift": (0.5, -3.0),
    "teeth": (3.0, 2.5, 1.0),
}


@pytest.fixture(scope="module")
def compilation() -> Compilation:
    return lagdsl.compile(TEXT)._compilation


@pytest.mark.parametrize("names", [("m",), ("M",), ("a",), ("g",), ("shift",), ("teeth",), tuple(VALUES)])
def test_many_runs_are_allowed_as_each_of_them_alone(compilation: Compilation, names: tuple[str, ...]) -> None:
    options = Options(stop=1.0, interval=0.5, tolerance=None, solver="auto", engine="tape", inputs={})
    chosen = np.random.default_rng(5)
    longest = max(len(VALUES[name]) for name in names) if len(names) == 1 else 40
    tasks = [
        Task(
            index=k,
            swept=0,
            parameters={
                name: VALUES[name][k % len(VALUES[name])] if len(names) == 1 else float(chosen.choice(VALUES[name]))
                for name in names
            },
            start={},
        )
        for k in range(longest)
    ]
    ensemble = Ensemble(compilation.flat, TapeEngine(compilation.program), options)
    for first in range(len(tasks)):  # the first run is looked at by itself, so each takes its place
        order = tasks[first:] + tasks[:first]
        p, allowed = ensemble._parameters(order)
        assert allowed.tolist() == [ensemble._allows(task) for task in order]
        slots = [slot.name for slot in compilation.program.layout.parameters]
        for row, task in zip(p, order, strict=True):
            assert {name: row[slots.index(name)] for name in names} == task.parameters


def test_columns_of_several_models_are_told_apart() -> None:
    def outcome(index: int, names: tuple[str, ...], rows: int) -> Outcome:
        values = 100.0 * index + 10.0 * np.arange(rows)[:, None] + np.arange(len(names))
        return Outcome(
            index=index, status="ok", ended=1.0, message="", names=names, units=("m",) * len(names), values=values
        )

    given = [("x", "y"), (), ("y", "z"), ("x", "y"), ("u",)]
    found = collect(5, 3, [outcome(k, names, 2 + k % 2) for k, names in enumerate(given)])
    assert list(found.columns) == ["x", "y", "z", "u"]
    for k, names in enumerate(given):
        for name, column in found.columns.items():
            expected = np.full(3, np.nan)
            if name in names:
                rows = 2 + k % 2
                expected[:rows] = 100.0 * k + 10.0 * np.arange(rows) + names.index(name)
            np.testing.assert_array_equal(column[k], expected)
