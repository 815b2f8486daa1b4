"""Motion against closed forms, with engines written by hand."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest
from scipy.integrate import solve_ivp
from scipy.special import ellipj, ellipk
from simulate.hand import FourBar, Hand, Pendulum, TwiceTied, constraint, coordinate, flat_model, four_bar, length

from lagdsl.engines.runtime.library import METHODS
from lagdsl.foundation.diagnostics import CompilationFailed, Sink
from lagdsl.motion.signals.trajectory import Trajectory
from lagdsl.motion.simulate.simulate import grid, simulate


def run(engine: Hand, **more: Any) -> Trajectory:
    return simulate(engine, engine.flat, **more)


def pendulum(start: float = 1.0, **more: Any) -> Pendulum:
    return Pendulum(flat_model([coordinate("theta", start)], **more))


def pendulum_angle(t: np.ndarray, amplitude: float) -> np.ndarray:
    """Source: Landau and Lifshitz, Mechanics, section 11; with Jacobi's functions."""
    k2 = np.sin(amplitude / 2) ** 2
    sn = ellipj(ellipk(k2) - np.sqrt(9.81 / 0.5) * t, k2)[0]
    return np.asarray(2 * np.arcsin(np.sqrt(k2) * sn))


# Methods of fixed steps have tests of their own.
ADAPTIVE = ("auto", *METHODS)


@pytest.mark.parametrize("solver", ADAPTIVE)
def test_pendulum_follows_jacobi_with_every_solver(solver: str) -> None:
    motion = run(pendulum(2.0), stop=3.0, interval=0.01, tolerance=1e-8, solver=solver)
    assert np.max(np.abs(motion["theta"] - pendulum_angle(motion.time, 2.0))) < 3e-7
    assert motion.statistics.solver == ("dop853" if solver == "auto" else solver)
    assert (motion.statistics.jacobians > 0) is (solver == "radau")


@pytest.mark.parametrize("tolerance", [1e-4, 1e-6, 1e-8, 1e-10])
def test_the_error_follows_the_tolerance(tolerance: float) -> None:
    motion = run(pendulum(2.0), stop=5.0, interval=0.05, tolerance=tolerance)
    error = np.max(np.abs(motion["theta"] - pendulum_angle(motion.time, 2.0)))
    assert error < tolerance


def test_energy_is_kept_within_ten_tolerances_at_any_size_of_the_motion() -> None:
    """A small motion is resolved as well as a large one: scales follow the motion."""

    class Oscillator(Hand):
        def force(self, t, q, qd, z, u):  # type: ignore[no-untyped-def]
            return -q

        def potential(self, q):  # type: ignore[no-untyped-def]
            return 0.5 * q @ q

    for amplitude in (1e3, 1.0, 1e-3):
        engine = Oscillator(flat_model([length("x", amplitude)]))
        motion = run(engine, stop=30.0, tolerance=1e-10)
        assert np.max(np.abs(motion.energy / motion.energy[0] - 1.0)) < 1e-9


def test_columns_stand_in_the_order_of_result_files() -> None:
    engine = pendulum(states=["s"], outputs=["y"])
    engine.start_z = (0.5,)
    motion = run(engine)
    assert motion.names == ("time", "theta", "der(theta)", "s", "y")
    assert [c.kind for c in motion.columns] == ["time", "coordinate", "rate", "state", "output"]
    assert [c.unit for c in motion.columns] == ["s", "rad", "rad/s", "1", "1"]
    assert len(motion) == 21 and motion.time[-1] == 1.0
    assert np.all(motion["s"] == 0.5)
    assert motion.events == ()
    with pytest.raises(KeyError, match="no column `thta`; did you mean `theta`"):
        motion["thta"]


def test_states_and_outputs() -> None:
    """z' = -3 z + x, y = the acceleration and the multiplier's place."""

    class Filtered(Pendulum):
        def zdot(self, t, q, qd, z, u):  # type: ignore[no-untyped-def]
            return np.array([-3.0 * z[0]])

        def output(self, t, q, qd, z, u, qdd, lam):  # type: ignore[no-untyped-def]
            return np.array([qdd[0], z[0] * t])

    engine = Filtered(flat_model([coordinate("theta", 1.0)], states=["z"], outputs=["a", "b"]))
    engine.start_z = (2.0,)
    motion = run(engine, tolerance=1e-9)
    assert np.allclose(motion["z"], 2.0 * np.exp(-3.0 * motion.time), atol=1e-9)
    assert np.allclose(motion["a"], -9.81 / 0.5 * np.sin(motion["theta"]), atol=1e-12)
    assert np.array_equal(motion["b"], motion["z"] * motion.time)


def test_model_of_states_only() -> None:
    class Decay(Hand):
        def zdot(self, t, q, qd, z, u):  # type: ignore[no-untyped-def]
            return -z

    engine = Decay(flat_model(states=["z"]))
    engine.start_z = (1.0,)
    assert run(engine)["z"][-1] == pytest.approx(np.exp(-1.0), abs=1e-9)


def test_grid_ends_at_the_stop_time() -> None:
    assert grid(0.0, 1.0, 0.25).tolist() == [0.0, 0.25, 0.5, 0.75, 1.0]
    assert grid(1.0, 2.0, 0.4).tolist() == pytest.approx([1.0, 1.4, 1.8, 2.0])
    assert len(grid(0.0, 1.0, 0.1)) == 11 and grid(0.0, 1.0, 0.1)[-1] == 1.0
    assert len(grid(0.0, 1.0, None)) == 501
    assert grid(0.0, 1.0, 50.0).tolist() == [0.0, 1.0]
    for interval in (0.0, -1.0, 1e-12, float("nan")):
        with pytest.raises(ValueError, match="interval"):
            grid(0.0, 1.0, interval)


@pytest.mark.parametrize(
    ("options", "text"),
    [
        ({"stop": -1.0}, "must be after the start time"),
        ({"stop": float("nan")}, "must be after the start time"),
        ({"tolerance": 0.0}, "tolerance"),
        ({"tolerance": 1.0}, "tolerance"),
        ({"solver": "euler"}, "no solver `euler`; there are auto, dop853, radau, rk4, leapfrog, ros2"),
    ],
)
def test_bad_options(options: dict[str, Any], text: str) -> None:
    with pytest.raises(ValueError, match=text):
        run(pendulum(), **options)


def test_progress_runs_from_nothing_to_one() -> None:
    seen: list[float] = []
    run(pendulum(), stop=20.0, progress=seen.append)
    assert seen == sorted(seen) and seen[-1] == 1.0 and len(seen) <= 502


def test_an_interrupt_passes_through() -> None:
    def stop(part: float) -> None:
        raise KeyboardInterrupt

    with pytest.raises(KeyboardInterrupt):
        run(pendulum(), progress=stop)


def test_errors_of_the_start_are_raised_before_the_first_step() -> None:
    engine = four_bar()
    engine.d = 3.0
    with pytest.raises(CompilationFailed, match="E0802"):
        run(engine)


def test_start_values_and_moved_rows_are_kept() -> None:
    motion = run(four_bar(), stop=0.01, start={"B": 0.4})
    assert {row.name for row in motion.moved} == {"A", "B", "C"}
    assert run(pendulum(), start={"theta": 0.5, "der(theta)": 1.0})["der(theta)"][0] == 1.0


# ---- staying on the constraints --------------------------------------------------------------------------------------


def test_four_bar_stays_closed_and_keeps_its_energy() -> None:
    motion = run(four_bar(), stop=2.0, tolerance=1e-10, interval=0.01)
    assert np.max(motion.position_residual) < 1e-12
    assert np.max(motion.velocity_residual) < 1e-11
    assert np.max(np.abs(motion.energy - motion.energy[0])) < 1e-9 * np.max(np.abs(motion.energy))
    assert motion.statistics.projections > 0


@pytest.mark.parametrize("solver", ["dop853", "radau"])
def test_projection_works_with_every_method(solver: str) -> None:
    motion = run(four_bar(), stop=1.0, tolerance=1e-6, solver=solver)
    reference = run(four_bar(), stop=1.0, tolerance=1e-11)
    assert np.max(motion.position_residual) < 1e-9
    assert np.max(np.abs(motion["A"] - reference["A"])) < 1e-5


def test_dependent_constraints_move_as_one_rod() -> None:
    """Compared with the minimal coordinate, by Jacobi's functions."""
    x, y = length("x", 0.5 * np.sin(2.0)), length("y", -0.5 * np.cos(2.0))
    engine = TwiceTied(flat_model([x, y], [constraint("a"), constraint("b")]))
    motion = run(engine.with_redundant(False, True), stop=5.0, tolerance=1e-9, interval=0.05)
    angle = pendulum_angle(motion.time, 2.0)
    assert np.max(np.abs(motion["x"] - 0.5 * np.sin(angle))) < 1e-8
    assert np.max(motion.position_residual) < 1e-11
    assert motion.statistics.notes == ()


def parallelogram(g: float = 0.0, **rates: float) -> FourBar:
    coordinates = [coordinate(n, 0.0, rates.get(n, 0.0), fixed=True, rate_fixed=n == "A") for n in ("A", "B", "C")]
    engine = FourBar(flat_model(coordinates, [constraint("loop", 2)]))
    engine.a = engine.c = 0.3
    engine.b = engine.d = 0.6
    engine.g = g
    return engine


def test_parallelogram_started_flat_turns_uniformly_through_its_singular_positions() -> None:
    """Without weight the parallel cranks keep their rate; every half turn J loses rank."""
    sink = Sink()
    motion = run(parallelogram(A=4.0, C=4.0), stop=3.0, tolerance=1e-10, sink=sink)
    assert np.max(np.abs(motion["A"] - 4.0 * motion.time)) < 1e-9
    assert np.max(np.abs(motion["B"])) < 1e-9 and np.max(np.abs(motion["C"] - motion["A"])) < 1e-9
    warning = next(d for d in sink.diagnostics if d.code == "W0608")
    assert "at t = 0 s the constraints lose rank (1 instead of 2)" in warning.message
    assert motion.statistics.notes[0].startswith("the constraints lost rank at t = 0 s")


def test_parallelogram_started_flat_at_rest_falls_and_keeps_its_energy() -> None:
    motion = run(parallelogram(g=9.81), stop=0.7, tolerance=1e-10)
    assert np.max(np.abs(motion.energy - motion.energy[0])) < 1e-8
    assert np.max(motion.position_residual) < 1e-11
    assert motion["A"][-1] < -1.0


def test_parallelogram_departs_from_rest_on_the_parallel_branch() -> None:
    """The branch nearest to the free accelerations; compared with the pendulum it then is."""
    engine = parallelogram(g=9.81)
    motion = run(engine, stop=0.1, interval=0.001, tolerance=1e-11)
    inertia = (engine.m1 / 3 + engine.m2 + engine.m3 / 3) * engine.a**2
    weight = (engine.m1 / 2 + engine.m2 + engine.m3 / 2) * engine.g * engine.a
    fall = solve_ivp(
        lambda t, y: [y[1], -weight * np.cos(y[0]) / inertia],
        (0.0, 0.1),
        [0.0, 0.0],
        rtol=1e-12,
        atol=1e-15,
        t_eval=motion.time,
    )
    assert np.max(np.abs(motion["A"] - fall.y[0])) < 1e-9 and np.max(np.abs(motion["C"] - fall.y[0])) < 1e-9
    assert np.max(np.abs(motion["B"])) < 1e-9
    assert np.max(np.abs(motion["der(A)"] - fall.y[1])[5:]) < 1e-9  # nearer to the start rates magnify round-off


@pytest.mark.parametrize("size", [0.01, 1.0, 50.0])
def test_residuals_of_rows_stay_below_a_part_of_the_tolerance(size: float) -> None:
    """In meters, or as a part of the size of the mechanism where that is smaller."""
    engine = four_bar(rate=2.0)
    engine.a, engine.b, engine.c, engine.d = (size * each for each in (engine.a, engine.b, engine.c, engine.d))
    motion = run(engine, stop=1.0, interval=0.01, tolerance=1e-6)
    assert np.ptp(motion["A"]) > 1.0
    assert np.max(motion.position_residual) <= 2e-9 * min(1.0, size)


def test_knife_edge_keeps_its_heading_rule() -> None:
    """A skate with x, y, th: no slip across; on a level plane it runs on a circle."""

    class Skate(Hand):
        def rows(self, t, q):  # type: ignore[no-untyped-def]
            return np.array([[np.sin(q[2]), -np.cos(q[2]), 0.0 * q[0]]])

        def phi(self, t, q):  # type: ignore[no-untyped-def]
            return np.zeros(1)

    coordinates = [length("x", rate=2.0), length("y"), coordinate("th", rate=0.5)]
    engine = Skate(flat_model(coordinates, [constraint("edge", level="velocity")]))
    motion = run(engine, stop=20.0, tolerance=1e-9)
    radius = 4.0
    assert np.max(np.abs(motion["x"] - radius * np.sin(0.5 * motion.time))) < 1e-7
    assert np.max(np.abs(motion["y"] - radius * (1.0 - np.cos(0.5 * motion.time)))) < 1e-7
    assert np.max(motion.velocity_residual) < 1e-11 and np.max(motion.position_residual) == 0.0


def test_driven_constraint_follows_time() -> None:
    """A point on a circle whose radius grows: x^2 + y^2 = (0.5 + t/10)^2, no other force."""

    class Growing(Hand):
        def phi(self, t, q):  # type: ignore[no-untyped-def]
            return np.array([q[0] ** 2 + q[1] ** 2 - (0.5 + t / 10) ** 2])

        def rows(self, t, q):  # type: ignore[no-untyped-def]
            return np.array([[2 * q[0], 2 * q[1]]])

        def rate(self, t, q):  # type: ignore[no-untyped-def]
            return np.array([-0.2 * (0.5 + t / 10)])

    engine = Growing(flat_model([length("x", 0.5, fixed=True), length("y", 0.0, 1.0)], [constraint("c")]))
    motion = run(engine, stop=5.0, tolerance=1e-9)
    radius = 0.5 + motion.time / 10
    # Angular momentum about the center stays 0.5 m2/s: phi = integral of 0.5 / r^2.
    angle = 0.5 / 0.1 * (1 / 0.5 - 1 / radius)
    assert np.max(np.abs(motion["x"] - radius * np.cos(angle))) < 1e-8
    assert motion["der(x)"][0] == pytest.approx(0.1)


# ---- stiffness -------------------------------------------------------------------------------------------------------


class Stiff(Hand):
    """x'' = -k x - c x' with an overdamped, fast direction: rates -1 and -1e5 1/s."""

    def force(self, t, q, qd, z, u):  # type: ignore[no-untyped-def]
        return -1e5 * q - (1e5 + 1.0) * qd


def test_auto_changes_to_an_implicit_method_and_says_so() -> None:
    engine = Stiff(flat_model([length("x", 1.0, -1.0)]))
    motion = run(engine, stop=10.0, tolerance=1e-6)
    assert motion.statistics.solver == "radau"
    assert motion.statistics.notes[0].startswith("changed from dop853 to radau at t = ")
    assert motion.statistics.steps < 500
    assert np.max(np.abs(motion["x"] - np.exp(-motion.time))) < 1e-6


class Calmed(Stiff):
    """Stiff for a second, then an oscillation, which demands short steps of any method."""

    def force(self, t, q, qd, z, u):  # type: ignore[no-untyped-def]
        part = 0.5 * (1.0 - np.tanh(50.0 * (t - 1.0)))
        return part * super().force(t, q, qd, z, u) - (1.0 - part) * 1e4 * q


def test_auto_returns_where_implicit_steps_are_not_longer() -> None:
    motion = run(Calmed(flat_model([length("x", 1.0, -1.0)])), stop=20.0, tolerance=1e-8)  # at 1e-6 they are
    changes = [note for note in motion.statistics.notes if note.startswith("changed")]  # the others speak of the rows
    assert [note.split(" at ")[0] for note in changes] == [
        "changed from dop853 to radau",
        "changed from radau to dop853",
    ]
    assert motion.statistics.solver == "dop853"


# ---- inputs ----------------------------------------------------------------------------------------------------------


class Pushed(Hand):
    """x'' = u."""

    start_u = (0.0,)

    def force(self, t, q, qd, z, u):  # type: ignore[no-untyped-def]
        return np.array([u[0]])

    def output(self, t, q, qd, z, u, qdd, lam):  # type: ignore[no-untyped-def]
        return np.array([u[0]])


def pushed() -> Pushed:
    return Pushed(flat_model([length("x", 0.0)], inputs=["u"], outputs=["y"]))


def test_constant_and_function_inputs() -> None:
    assert run(pushed(), inputs={"u": 2.0})["x"][-1] == pytest.approx(1.0, abs=1e-12)
    motion = run(pushed(), inputs={"u": np.sin})
    assert np.max(np.abs(motion["x"] - (motion.time - np.sin(motion.time)))) < 1e-9
    assert run(pushed())["x"][-1] == 0.0


def test_table_with_kinks_and_a_jump_is_exact() -> None:
    """u = t up to 0.3, then falls to 0 at 0.5, jumps to 2: piecewise polynomial motion, steps end at the corners."""
    table = ([0.0, 0.3, 0.5, 0.5, 1.0], [0.0, 0.3, 0.0, 2.0, 2.0])
    motion = run(pushed(), inputs={"u": table}, tolerance=1e-6, interval=0.1)
    v, x = 0.045, 0.0045
    h = 0.2
    x, v = x + v * h + 0.3 * h**2 / 2 - 1.5 * h**3 / 6, v + 0.3 * h - 1.5 * h**2 / 2
    x, v = x + v * 0.5 + 2.0 * 0.5**2 / 2, v + 1.0
    assert motion["x"][-1] == pytest.approx(x, abs=1e-14)
    assert motion["der(x)"][-1] == pytest.approx(v, abs=1e-14)
    assert motion["y"][4] == pytest.approx(0.15) and motion["y"][6] == 2.0


def test_derivatives_of_a_table_are_those_of_monotone_cubics() -> None:
    class Carried(Hand):
        start_u = (0.0, 0.0, 0.0)

        def output(self, t, q, qd, z, u, qdd, lam):  # type: ignore[no-untyped-def]
            return u

    flat = flat_model([length("x")], inputs=["road", "der(road)", "der(der(road))"], outputs=["y", "dy", "ddy"])
    times = np.linspace(0.0, 1.0, 101)
    motion = run(Carried(flat), inputs={"road": (times, np.exp(3 * times))})
    assert np.max(np.abs(motion["y"] / np.exp(3 * motion.time) - 1)) < 1e-4
    assert np.max(np.abs(motion["dy"] / np.exp(3 * motion.time) / 3 - 1)) < 2e-2
    constant = run(Carried(flat), inputs={"road": 0.3})
    assert np.all(constant["y"] == 0.3) and np.all(constant["dy"] == 0.0)
    given = run(Carried(flat), inputs={"road": np.sin, "der(road)": np.cos, "der(der(road))": lambda t: -np.sin(t)})
    assert given["dy"][-1] == np.cos(1.0)
    lines = run(Carried(flat), inputs={"road": ([0, 1], [0, 1]), "der(road)": 1.0, "der(der(road))": 0.0})
    assert lines["y"][-1] == 1.0 and lines["dy"][-1] == 1.0


@pytest.mark.parametrize(
    ("inputs", "code"),
    [
        ({"v": 1.0}, "E0819"),
        ({"road": ([0.0, 0.5], [0.0, 0.0])}, "E0817"),
        ({"road": ([0.1, 2.0], [0.0, 0.0])}, "E0817"),
        ({"road": np.sin}, "E0818"),
    ],
)
def test_inputs_that_do_not_fit(inputs: dict[str, Any], code: str) -> None:
    flat = flat_model([length("x")], inputs=["road", "der(road)", "der(der(road))"])
    engine = Hand(flat)
    engine.start_u = (0.0, 0.0, 0.0)
    with pytest.raises(CompilationFailed) as failure:
        run(engine, inputs=inputs)
    assert {d.code for d in failure.value.diagnostics} == {code}


def test_a_table_is_also_two_rows_of_an_array() -> None:
    table = np.array([[0.0, 10.0], [0.0, 10.0]])
    motion = run(pushed(), inputs={"u": table}, stop=1.0)
    assert motion["x"][-1] == pytest.approx(1 / 6, rel=1e-6)
    assert run(pushed(), inputs={"u": table.tolist()}, stop=1.0)["x"][-1] == motion["x"][-1]


@pytest.mark.parametrize(
    ("signal", "words"),
    [
        (([0, 1], [0, 1, 2]), "as many values as times"),
        (([], []), "two at least"),
        (([0],), "must be a number, a function of time, a pair"),
        (np.zeros(5), "must be a number, a function of time, a pair"),
        (None, "must be a number, a function of time, a pair"),
        (([0, 2, 1], [0, 1, 2]), "time decreases"),
        (([0, 1], [0, np.nan]), "not numbers"),
    ],
)
def test_signals_that_are_none(signal: Any, words: str) -> None:
    with pytest.raises(ValueError, match=words):
        run(pushed(), inputs={"u": signal})


def test_a_jump_has_no_derivative() -> None:
    engine = Pushed(flat_model([length("x")], inputs=["road", "der(road)"]))
    engine.start_u = (0.0, 0.0)
    with pytest.raises(CompilationFailed, match="jumps"):
        run(engine, inputs={"road": ([0, 1, 1, 9], [0, 0, 1, 1])})


def test_the_nearest_input_is_told() -> None:
    with pytest.raises(CompilationFailed, match="did you mean `u`"):
        run(pushed(), inputs={"U": 1.0})


# ---- reading a trajectory --------------------------------------------------------------------------------------------


def test_a_motion_is_shown_in_one_line() -> None:
    assert repr(run(pendulum(), stop=1.0)).startswith("<Trajectory Hand: 21 rows, 0 s to 1 s, theta")


def test_an_unknown_column_is_answered_with_the_nearest() -> None:
    with pytest.raises(KeyError, match="did you mean `time`"):
        run(pendulum(), stop=0.1)["tiem"]


def test_crossings_are_the_times_of_passing() -> None:
    motion = run(pendulum(2.0), stop=10.0, interval=0.02, tolerance=1e-11)
    quarter = ellipk(np.sin(1.0) ** 2) / np.sqrt(9.81 / 0.5)
    times = motion.crossings("theta")
    assert np.allclose(times, quarter * np.arange(1, 2 * len(times), 2), atol=1e-9)
    assert np.array_equal(motion.crossings("theta", direction=-1), times[::2])
    assert np.array_equal(motion.crossings("theta", direction=1), times[1::2])
    assert len(motion.crossings("theta", 3.0)) == 0


def test_crossings_on_rows_count_once() -> None:
    from lagdsl.motion.signals.trajectory import crossing_times

    t = np.arange(5.0)
    assert crossing_times(t, np.array([-1.0, 0.0, 1.0, 0.0, -1.0]), 0).tolist() == [1.0, 3.0]
    assert crossing_times(t, np.array([-1.0, 0.0, -1.0, -1.0, 0.0]), 0).tolist() == [4.0]
    assert crossing_times(t, np.array([0.0, 1.0, 2.0, 3.0, 4.0]), 1).tolist() == [0.0]
    assert crossing_times(t, np.zeros(5), 1).tolist() == []


def test_crossings_do_not_reach_across_events() -> None:
    from lagdsl.motion.signals.trajectory import crossing_times

    t = np.array([0.0, 0.1, 0.2, 0.3, 0.4, 0.5, 0.55, 0.55, 0.6, 0.7, 0.8, 0.9, 1.0])
    before, after = t[:7], t[7:]
    x = np.concatenate([before**3 - 0.45**3, (after - 0.83) * (2.0 - after)])  # jumps at 0.55
    assert crossing_times(t, x, 0) == pytest.approx([0.45, 0.55, 0.83], abs=1e-12)
    assert crossing_times(t, x, 1) == pytest.approx([0.45, 0.83], abs=1e-12)
    assert crossing_times(t, x, -1).tolist() == [0.55]


def test_data_frame_has_the_columns() -> None:
    frame = run(pendulum()).to_dataframe()
    assert list(frame.columns) == ["time", "theta", "der(theta)"] and len(frame) == 21
