"""Through singular positions on the branch the motion comes on, or not at all: never onto another one.

Energy is kept by a wrong turn, too: an integrator that misses the constraints by round-off sees a mechanism with
slightly other lengths, which does turn. So branches are compared, by closed forms.
"""

from __future__ import annotations

import sys
from ctypes import byref
from pathlib import Path

import linkages
import numpy as np
import pytest
from choice import engines

import lagdsl
from lagdsl.engines.runtime.engines.selection import engine_of
from lagdsl.engines.runtime.run import Run
from lagdsl.engines.runtime.structures import Status
from lagdsl.motion.simulate.failure import SimulationFailed
from lagdsl.motion.simulate.placed import placed

PARALLELOGRAM = """model Parallelogram
  coordinate Angle A(start = 60 deg, fixed = true, der(start = 2 rad/s)), B(start = -60 deg), C(start = 55 deg);
  frame bar = world.rotz(A).move({0.4 m, 0, 0});
  frame plate = bar.rotz(B);
  frame second = plate.move({1 m, 0, 0}).rotz(C).move({-0.4 m, 0, 0});
  gravity = -g_n*world.y;
  mass 1 kg at bar;
  body coupler(m = 2 kg, com = {0.5 m, 0, 0}, Izz = 0.2 kg.m2) on plate;
  mass 0.5 kg at second.point({0.2 m, 0, 0});
  constraint outer: second.origin = {1 m, 0, 0};
end Parallelogram;
"""

STACKED = (
    PARALLELOGRAM.replace("Parallelogram", "Stacked")
    .replace(
        "  frame bar",
        "  coordinate Angle D(start = 20 deg, fixed = true), F(start = -20 deg), G(start = 20 deg);\n  frame bar",
    )
    .replace(
        "end Stacked",
        """  frame bar2 = plate.move({0.1 m, 0, 0}).rotz(D).move({0.3 m, 0, 0});
  frame plate2 = bar2.rotz(F);
  frame second2 = plate2.move({0.5 m, 0, 0}).rotz(G).move({-0.3 m, 0, 0});
  body upper(m = 1 kg, com = {0.2 m, 0, 0}, Izz = 0.1 kg.m2) on plate2;
  mass 0.2 kg at second2.point({0.15 m, 0, 0});
  constraint inner: second2.origin = plate.point({0.6 m, 0, 0});
end Stacked""",
    )
)

# s + l = p + q: the links lie in one line once in a turn, stretched.
NEUTRAL = """model Neutral
  coordinate Angle A(start = 60 deg, fixed = true, der(start = 12 rad/s)), B(start = 0 deg), C(start = 60 deg);
  frame crank = world.rotz(A).move({1 m, 0, 0});
  frame coupler = crank.rotz(B).move({3 m, 0, 0});
  frame rocker = coupler.rotz(C).move({-2 m, 0, 0});
  gravity = -g_n*world.y;
  body a(m = 1 kg, com = {-0.5 m, 0, 0}, Izz = 4 kg.m2) on crank;
  body b(m = 2 kg, com = {-1.5 m, 0, 0}, Izz = 1 kg.m2) on coupler;
  body c(m = 1 kg, com = {1 m, 0, 0}, Izz = 0.3 kg.m2) on rocker;
  constraint outer: rocker.origin = {4 m, 0, 0};
end Neutral;
"""

SLIDER_CRANK = """model SliderCrank
  parameter Length r = 0.2 m, l = 0.2 m;
  coordinate Angle th(start = 60 deg, fixed = true, der(start = 6 rad/s)), ph(start = -60 deg);
  frame rod = world.rotz(th).move({r, 0, 0}).rotz(ph - th);
  point wrist = rod.point({l, 0, 0});
  gravity = -g_n*world.y;
  constraint wall: wrist*world.y = 0;
  body disc(Izz = 0.02 kg.m2) on world.rotz(th);
  body conrod(m = 0.5 kg, com = {l/2, 0, 0}, Izz = 2e-3 kg.m2) on rod;
  mass 0.4 kg at wrist;
end SliderCrank;
"""

# Rounding of a position leaves its square root open in the direction of a branch: so much energy is lost at each
# crossing, at any tolerance.
CROSSING = sys.float_info.epsilon**0.5


def drift(motion: lagdsl.Trajectory) -> float:
    energy = motion.energy
    return float(np.max(np.abs(energy - energy[0])) / np.max(np.abs(energy)))


@pytest.mark.parametrize("engine", engines(["numpy", "c"]))
@pytest.mark.parametrize("tolerance", [1e-6, 1e-10])
@pytest.mark.parametrize(
    ("text", "pairs"),
    [
        (PARALLELOGRAM, [("A", "B")]),
        (linkages.THREE_BARS, [("A", "B")]),
        (STACKED, [("A", "B"), ("D", "F")]),
        (SLIDER_CRANK, [("th", "ph")]),
    ],
    ids=["parallelogram", "third bar", "stacked", "slider-crank"],
)
def test_crossing_keeps_the_branch(engine: str, tolerance: float, text: str, pairs: list[tuple[str, str]]) -> None:
    """Each pair of angles stays opposite, whole turns long."""
    motion = lagdsl.compile(text, engine=engine).simulate(stop=1.2, tolerance=tolerance)  # type: ignore[arg-type]
    for first, second in pairs:
        assert np.max(np.abs(motion[first] + motion[second])) < 1e-8
    assert drift(motion) < max(4.0 * CROSSING, 10.0 * tolerance)


def test_parallelogram_keeps_its_energy() -> None:
    """Through its flat position again and again."""
    motion = lagdsl.compile(PARALLELOGRAM).simulate(stop=3.0, tolerance=1e-9)
    assert drift(motion) < 1e-8 and np.ptp(motion["A"]) > np.pi


def test_neutral_four_bar_crosses_its_flat_position() -> None:
    """The rocker goes on with its rate; on the other branch it would turn back at once: (A - pi) and C pass zero
    together, along dC/dA = const."""
    coarse, fine = (
        lagdsl.compile(NEUTRAL).simulate(stop=1.5, interval=0.01, tolerance=tolerance) for tolerance in (1e-7, 1e-10)
    )
    assert drift(fine) < 1e-8 and np.ptp(fine["A"]) > 2.0 * np.pi
    assert np.max(np.abs(coarse["B"] - fine["B"])) < 1e-4
    assert np.max(np.abs(np.diff(fine["der(C)"]))) < 2.0


@pytest.mark.parametrize("error", [1e-4, 1e-8, 1e-9])
def test_rod_longer_by_little_turns_back(error: float) -> None:
    """With l > r the rod never passes -90 deg: from there on the slider stays near the shaft. One degree of freedom, so
    branch and energy are the motion."""
    motion = lagdsl.compile(SLIDER_CRANK).simulate(parameters={"l": 0.2 + error}, stop=0.4, tolerance=1e-8)
    assert motion["th"].max() > 2.0 and np.all(np.cos(motion["ph"]) > 0.0)
    assert drift(motion) < 1e-7


def test_rod_shorter_by_little_turns_the_crank_back() -> None:
    motion = lagdsl.compile(SLIDER_CRANK).simulate(parameters={"l": 0.2 - 1e-8}, stop=0.4, tolerance=1e-8)
    assert np.all(np.cos(motion["th"]) > 0.0) and motion["ph"].min() < -2.0
    assert drift(motion) < 1e-7


@pytest.mark.parametrize("error", [1e-10, 1e-11])
def test_near_the_limit_of_resolution_the_motion_is_right_or_ends(error: float) -> None:
    model = lagdsl.compile(SLIDER_CRANK)
    try:
        motion = model.simulate(parameters={"l": 0.2 + error}, stop=0.4, tolerance=1e-6)
    except SimulationFailed as failed:
        assert failed.diagnostic.code == "E0830"
        motion = failed.trajectory  # type: ignore[assignment]
    assert np.all(np.cos(motion["ph"]) > 0.0) and drift(motion) < 1e-5


def test_special_dimensions_are_looked_at_again_with_other_parameters() -> None:
    """Bennett's linkage with a wrong length is rigid; it must not move on the rank of the right one."""
    for text in (linkages.bennett(), linkages.bennett().replace("fixed = true, der(start = 3.0)", "der(start = 3.0)")):
        model = lagdsl.compile(text)
        for error in (1e-3, 1e-5, 1e-7):
            with pytest.raises((lagdsl.CompilationFailed, SimulationFailed)) as failed:
                model.simulate(parameters={"b": linkages.BENNETT_LENGTH[1] + error}, stop=0.1)
            assert isinstance(failed.value, (lagdsl.CompilationFailed, SimulationFailed))
            assert failed.value.diagnostics[-1].code in ("E0801", "E0802", "E0811", "E0831")


def test_parameters_may_make_dimensions_special() -> None:
    """A double four-bar with general lengths of its bars becomes the parallelogram with a third bar."""
    text = linkages.THREE_BARS.replace("Length r = 0.4 m;", "Length r = 0.4 m, x = 0.45 m;")
    text = text.replace("constraint inner: third.origin = {0.5 m, 0, 0}", "constraint inner: third.origin = {x, 0, 0}")
    model = lagdsl.compile(text.replace("D(start = 55 deg)", "D(start = 50 deg)"))
    assert model.redundant.count(False) == 4
    motion = model.simulate(parameters={"x": 0.5}, stop=1.2, tolerance=1e-8)
    assert np.max(np.abs(motion["A"] + motion["B"])) < 1e-7 and motion["A"].min() < -1.0


def test_out_of_a_singular_start() -> None:
    """Both cranks of a parallelogram that starts flat turn with the same rate for good."""
    text = (Path(__file__).parents[2] / "models" / "parallelogram.lag").read_text(encoding="utf-8")
    motion = lagdsl.compile(text).simulate(stop=0.7, tolerance=1e-10)
    assert np.max(np.abs(motion["a"] - motion["c"])) < 1e-8 and np.max(np.abs(motion["b"])) < 1e-8
    assert motion["a"] == pytest.approx(4.0 * motion.time, abs=1e-8)


def test_rows_inside_of_a_crossing_are_on_the_motion() -> None:
    """At other times than those of steps, as many as there are: the constraints hold at each row."""
    model = lagdsl.compile(PARALLELOGRAM)
    motion = model.simulate(stop=1.2, tolerance=1e-10, interval=1.2 / 5_000)
    assert motion.statistics.steps < 1_000
    assert np.max(np.abs(motion["A"] + motion["B"])) < 1e-9
    reference = model.simulate(stop=1.2, tolerance=1e-10, interval=1.2 / 100)
    assert motion["A"][::50] == pytest.approx(reference["A"], abs=1e-7)


REST = """model Rest
  annotation(units = "none");
  coordinate Real a(start = 1, fixed = true, der(start = 0, fixed = true)), b(start = -1);
  kinetic 1/2*(der(a)^2 + der(b)^2);
  {forces}
  constraint c: sin(a) + sin(b) = 0;
end Rest;
"""


def test_a_motion_that_comes_to_rest_in_a_singular_position_is_not_determined() -> None:
    """On the branch b = -a about pi/2, where the branch b = a - pi crosses: a swings through for good, and damped comes
    to rest there by exp(-t/2)."""
    spring = "potential 1/2*((a - asin(1))^2 + (b + asin(1))^2);"
    swings = lagdsl.compile(REST.format(forces=spring)).simulate(stop=20.0, tolerance=1e-10)
    assert swings["a"] == pytest.approx(np.pi / 2 + (1 - np.pi / 2) * np.cos(swings.time), abs=1e-7)
    assert swings["b"] == pytest.approx(-swings["a"], abs=1e-7)
    damped = lagdsl.compile(REST.format(forces=spring + "dissipation 1/2*(der(a)^2 + der(b)^2);"))
    with pytest.raises(SimulationFailed) as failed:
        damped.simulate(stop=200.0)
    assert failed.value.diagnostic.code == "E0830" and failed.value.name == "c"
    assert abs(failed.value.state["a"] - np.pi / 2) < 1e-4
    assert failed.value.trajectory["b"] == pytest.approx(-failed.value.trajectory["a"], abs=1e-7)


def test_a_motion_that_is_driven_out_of_reach_ends_there() -> None:
    text = """model Reach
  annotation(units = "none");
  coordinate Real a(start = 0.451);
  kinetic 1/2*der(a)^2;
  constraint c: cos(a) = 0.9 + 0.2*time;
end Reach;
"""
    with pytest.raises(SimulationFailed) as failed:
        lagdsl.compile(text).simulate(stop=1.0)
    assert failed.value.diagnostic.code == "E0830" and failed.value.time == pytest.approx(0.5, abs=1e-6)


def test_a_run_that_is_saved_anywhere_goes_on_as_it_was() -> None:
    """Before every step and behind it, also in front of a crossing and on it."""
    model = lagdsl.compile(SLIDER_CRANK, engine="tape")
    flat, engine = model._compilation.flat, engine_of(model._compilation.program, "tape")
    start = model.simulate(stop=1e-9)
    x = np.array([start[name][0] for name in start.names[1:] if name not in model.outputs])

    def begun() -> Run:
        run = placed(flat, engine, model.defaults, np.zeros(0))
        assert run.begin(0.0, x) == Status.OK
        return run

    one, other = begun(), begun()
    library, options = one._library, byref(one._told.structure)
    saved = np.zeros(int(library.run_saved_size(one._model.model, options)), dtype=np.uint8)
    while one.t < 0.4:
        library.run_save(one._run, saved.ctypes.data)
        assert library.run_load(other._run, saved.ctypes.data) == Status.OK
        for run in (one, other):
            assert run.to(0.4, 1) in (Status.OK, Status.TOO_LONG)
        assert one.t == other.t and one.x.tolist() == other.x.tolist()
    assert one.x[0] == pytest.approx(-one.x[1], abs=1e-8) and one.x[0] > np.pi / 2
