"""Runs that C makes together are those that are made one by one, to the bit: events, loops, control, contacts."""

from __future__ import annotations

import gc
import tracemalloc
from pathlib import Path

import numpy as np
import pytest
from choice import spread

import lagdsl
from lagdsl.engines.runtime.engines.tape_engine import TapeEngine
from lagdsl.engines.runtime.ensemble import Bench, Stop
from lagdsl.interfaces.api.model import Model
from lagdsl.motion.pipeline import Compilation
from lagdsl.motion.sweep.ensemble import Ensemble
from lagdsl.motion.sweep.plan import Task
from lagdsl.motion.sweep.run import Options, Runner, SweptModel

MODELS = Path(__file__).resolve().parents[3] / "models"
RUNS = 4

# File, seconds; the first parameters of the model and the start of its first coordinate are varied.
VARIED = [
    ("double_pendulum.lag", 3.0),
    ("bouncing_ball.lag", 1.5),
    ("newtons_cradle.lag", 0.5),
    ("clutch.lag", 0.5),
    ("escapement.lag", 0.5),
    ("four_bar.lag", 0.5),
    ("four_bar_points.lag", 0.5),
    ("slider_crank_components.lag", 0.2),
    ("pick_and_place.lag", 0.2),
    ("watt_governor.lag", 0.3),
    ("rimless_wheel.lag", 0.5),
    ("bead_on_circular_wire_redundant.lag", 1.0),
    ("rolling_coin.lag", 0.5),
    ("van_der_pol.lag", 5.0),
    ("library/blocks_pid.lag", 0.5),
    ("library/planar_trammel.lag", 0.5),
]


@pytest.mark.parametrize(("file", "stop"), spread(VARIED, 8))
def test_runs_are_those_made_alone(file: str, stop: float) -> None:
    compilation = lagdsl.compile(MODELS / file)._compilation
    flat, program = compilation.flat, compilation.program
    options = Options(stop=stop, interval=stop / 20, tolerance=1e-7, solver="auto", engine="tape", inputs={})
    engine, tasks = TapeEngine(program, together=True), _tasks(compilation, RUNS)
    made = Ensemble(flat, engine, options).run(tasks, Bench(), Stop())
    alone = Runner([SweptModel(flat=flat, program=program)], options)
    assert len(made) == RUNS
    assert made[0] is not None
    for task, outcome in zip(tasks, made, strict=True):
        single = alone(task)
        if outcome is None:
            assert single.status == "failed"
            continue
        assert (outcome.status, outcome.ended, outcome.names, outcome.units) == (
            single.status,
            single.ended,
            single.names,
            single.units,
        )
        assert outcome.values.tobytes() == single.values.tobytes()


def test_a_lane_that_is_free_takes_the_next_run() -> None:
    compilation = lagdsl.compile(MODELS / "double_pendulum.lag")._compilation
    flat, program = compilation.flat, compilation.program
    options = Options(stop=1.0, interval=0.1, tolerance=1e-6, solver="auto", engine="tape", inputs={})
    engine, alone = TapeEngine(program, together=True), Runner([SweptModel(flat=flat, program=program)], options)
    tasks = _tasks(compilation, engine.native.at_once + 2)
    made = Ensemble(flat, engine, options).run(tasks, Bench(), Stop())
    assert len(tasks) > 2
    assert [each and each.values.tobytes() for each in made] == [alone(task).values.tobytes() for task in tasks]


def _tasks(compilation: Compilation, runs: int) -> list[Task]:
    """The defaults, then others: the first two parameters a little larger, the first coordinate from elsewhere."""
    layout, flat = compilation.program.layout, compilation.flat
    chosen = {slot.name: value for slot, value in zip(layout.parameters[:2], layout.defaults, strict=False)}
    free = [c.name for c in flat.coordinates[:1] if not c.fixed]
    q = TapeEngine(compilation.program).evaluate("start", flat.experiment.start_time, np.array(layout.defaults))[0]
    real = {p.name for p in flat.parameters if p.kind == "Real"}
    return [
        Task(
            index=k,
            swept=0,
            parameters={name: value * (1 + 0.01 * k * (name in real)) for name, value in chosen.items()},
            start={name: float(q[0]) + 0.001 * k for name in free},
        )
        for k in range(runs)
    ]


def test_memory_stays() -> None:
    """Runs leave nothing behind: of four hundred of them no more memory is kept than of two hundred, after the free
    lists of the interpreter have grown."""
    compilation = lagdsl.compile(MODELS / "bouncing_ball.lag")._compilation
    options = Options(stop=1.0, interval=0.5, tolerance=None, solver="auto", engine="tape", inputs={})
    ensemble, bench = Ensemble(compilation.flat, TapeEngine(compilation.program), options), Bench()
    tasks = _tasks(compilation, RUNS) * 5
    gc.collect()
    gc.freeze()  # or each collection would walk the objects of all tests before
    tracemalloc.start()
    sizes = []
    for _ in range(20):
        ensemble.run(tasks, bench, Stop())
        gc.collect()
        sizes.append(tracemalloc.get_traced_memory()[0])
    tracemalloc.stop()
    gc.unfreeze()
    assert sizes[-1] - sizes[9] < 20_000


class TestSimulateMany:
    @pytest.fixture
    def model(self) -> Model:
        return lagdsl.compile(MODELS / "bouncing_ball.lag", engine="tape")

    def test_rows_are_those_of_simulate(self, model: Model) -> None:
        (name,) = model.coordinates
        heights = [0.5, 1.0, 1.5]
        motions = model.simulate_many(start={name: heights}, stop=1.0, interval=0.1, threads=2)
        assert len(motions) == 3
        assert motions.failures == {}
        for k, height in enumerate(heights):
            alone = model.simulate(start={name: height}, stop=1.0, interval=0.1)
            rows = np.searchsorted(alone.time, motions.time, side="right") - 1
            for column in motions.names:
                assert motions[column][k].tobytes() == alone[column][rows].tobytes()

    def test_a_failure_is_told_by_its_number(self) -> None:
        model = lagdsl.compile(
            """model Drop
                 parameter Acceleration g = 1 m/s2; parameter Mass m(min = 0.1 kg) = 1 kg;
                 coordinate Length h(start = 1 m); gravity = -g*world.y; mass m at {0, h};
               equation assert(h > 0, "on the floor"); end Drop;"""
        )
        motions = model.simulate_many(
            parameters={"g": [1, 100, 1], "m": [1, 1, 0.01]}, stop=0.5, interval=0.1, columns=["h"]
        )
        assert list(motions.failures) == [1, 2]
        assert "on the floor" in motions.failures[1]
        assert "at least 0.1 kg" in motions.failures[2]
        np.testing.assert_allclose(motions["h"][0], 1 - motions.time**2 / 2)
        assert np.isnan(motions["h"][1, -1])
        assert motions.names == ["h"]
        assert motions.ended[0] == 0.5

    @pytest.mark.parametrize(
        ("given", "error", "words"),
        [
            ({"parameters": {"x": [1, 2]}}, KeyError, "no parameter"),
            ({"start": {"x": [1, 2]}}, KeyError, "no start value"),
            ({"start": {"h": 1.0}}, ValueError, "there is none"),
            ({"start": {"h": [[1.0]]}}, ValueError, "sequence of numbers"),
            ({"start": {"h": [1, 2], "der(h)": [1, 2, 3]}}, ValueError, "`h` has 2, `der"),
            ({"start": {"h": [1, 2]}, "threads": 0}, ValueError, "at least 1"),
            ({"start": {"h": [1] * 1_000_001}}, ValueError, "at most 1000000"),
            ({"start": {"h": [1] * 1_000_000}, "stop": 1, "interval": 1e-6}, ValueError, "fewer runs, fewer rows"),
        ],
    )
    def test_what_does_not_fit_is_told(
        self, model: Model, given: dict[str, object], error: type[Exception], words: str
    ) -> None:
        with pytest.raises(error, match=words):
            model.simulate_many(**given)  # type: ignore[arg-type]
