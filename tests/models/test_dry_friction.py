"""The purpose of the models with dry friction: what sticks does not creep, what slides follows Coulomb's law, and
what has no motion is told. Their motions by default are compared in test_motions."""

from __future__ import annotations

from functools import cache

import numpy as np
import pytest
from choice import ALL, chosen

import lagdsl
from lagdsl.engines.runtime.engines.engine import EngineName
from models.corpus import path_of
from models.references import REFERENCES
from models.references.integrate import G_N

SLOPE = np.radians(20)
EXACT = 1e-9


@cache
def _model(name: str, engine: EngineName = "tape") -> lagdsl.Model:
    return lagdsl.compile(path_of(name), engine=engine)


def _happened(motion: lagdsl.Trajectory, name: str) -> list[tuple[float, str]]:
    return [(event.time, event.kind) for event in motion.events if event.name == name and event.time > 0]


def _as_derived(name: str, stop: float, **changed: float) -> lagdsl.Trajectory:
    """The motion with other parameters, compared with the reference for those."""
    model = _model(name)
    motion = model.simulate(parameters=changed, stop=stop, tolerance=1e-10)
    values = dict(zip(model.parameters, model.defaults, strict=True)) | changed
    for column, expected in REFERENCES[name](values, motion.time).items():
        np.testing.assert_allclose(motion[column], expected, rtol=0, atol=1e-8 * max(1e-3, np.max(np.abs(expected))))
    return motion


# ---- it sticks -------------------------------------------------------------------------------------------------------


@pytest.mark.parametrize("engine", chosen(["tape", "c", "numpy"], ["tape"]))
@pytest.mark.parametrize("tolerance", chosen([1e-3, 1e-6, 1e-10], [1e-6]))
def test_a_block_stays_on_a_slope_for_a_hundred_seconds(engine: EngineName, tolerance: float) -> None:
    motion = _model("block_on_slope", engine).simulate(parameters={"v0": 0.0}, stop=100.0, tolerance=tolerance)
    assert np.max(np.abs(motion["s"])) <= 1e-12
    assert np.max(np.abs(motion["h"])) <= 1e-12
    assert not _happened(motion, "ground")


@pytest.mark.parametrize("solver", chosen(["rk4", "leapfrog", "ros2"], ["rk4"]))
def test_it_stays_with_fixed_steps(solver: str) -> None:
    try:
        motion = _model("block_on_slope").simulate(parameters={"v0": 0.0}, stop=100.0, solver=solver, step=0.1)
    except ValueError:  # a method that does not take forces of this kind says so
        pytest.skip(f"{solver} does not run it")
    assert np.max(np.abs(motion["s"])) <= 1e-12


def test_the_angle_of_friction_divides_sliding_from_rest() -> None:
    """tan 20 deg = 0.36397."""
    slides, stays = (
        _model("block_on_slope").simulate(parameters={"v0": 0.0, "mu": mu}, stop=100.0) for mu in (0.3639, 0.3641)
    )
    way = -G_N * (np.sin(SLOPE) - 0.3639 * np.cos(SLOPE)) * 100.0**2 / 2
    assert slides["s"][-1] == pytest.approx(way, rel=1e-10)
    assert np.max(np.abs(stays["s"])) <= 1e-12


def test_it_slides_stops_and_stays() -> None:
    motion = _model("block_on_slope").simulate(stop=100.0)
    brake = G_N * (np.sin(SLOPE) + 0.5 * np.cos(SLOPE))
    (told,) = [event for event in motion.events if event.kind == "sticks" and event.time > 0]
    assert told.time == pytest.approx(2.0 / brake, rel=1e-11)
    assert motion["s"][-1] == pytest.approx(2.0**2 / (2 * brake), rel=1e-10)
    resting = motion.time > told.time
    assert np.ptp(motion["s"][resting]) <= 1e-12


def test_a_pinched_capsule_does_not_creep() -> None:
    motion = _model("pinched_capsule").simulate(stop=100.0)
    assert np.max(np.abs(motion["y"])) <= 1e-12
    assert np.max(np.abs(motion["x"])) <= 1e-9  # nothing but the round-off of two forces moves all three along
    np.testing.assert_allclose(motion["N_left"], 10.0, rtol=1e-10)


def test_a_quadruped_stands() -> None:
    """Its feet do not move; the loads are the weight."""
    motion = _model("standing_quadruped").simulate(stop=10.0)
    for column in ("motion.r[1]", "motion.r[2]", "motion.angles[1]", "motion.angles[2]", "motion.angles[3]"):
        assert np.max(np.abs(motion[column])) <= 1e-9
    assert not [event for event in motion.events if event.kind == "slips" and event.time > 0]
    weight = (12 + 4 * 1.4) * G_N
    assert sum(motion[f"N[{i}]"][-1] for i in range(1, 5)) == pytest.approx(weight, rel=1e-6)


def test_a_pushed_quadruped_leans_and_keeps_its_feet() -> None:
    """The springs of twelve joints bear the push: the trunk goes aside and comes to rest."""
    motion = _model("standing_quadruped").simulate(parameters={"push": 10.0}, stop=10.0)
    assert motion["motion.r[2]"][-1] > 1e-3
    assert abs(motion["der(motion.r[2])"][-1]) < 1e-3
    assert not [event for event in motion.events if event.kind == "slips" and event.time > 0]


# ---- it slides -------------------------------------------------------------------------------------------------------


@pytest.mark.parametrize("beyond", [1e-6, -1e-6])
def test_a_ladder_slips_below_its_angle(beyond: float) -> None:
    lean = float(np.arctan((1 - 0.4 * 0.3) / (2 * 0.4))) + beyond
    motion = _model("ladder_with_friction").simulate(parameters={"lean": lean}, stop=0.5, tolerance=1e-10)
    moved = abs(motion["phi"][-1] - (np.pi - lean))
    assert moved <= 1e-12 if beyond > 0 else 1e-6 < moved < 1e-5


def test_a_box_with_little_friction_slides_instead_of_tipping() -> None:
    motion = _model("tipping_box").simulate(parameters={"mu": 0.15}, stop=2.4, tolerance=1e-10)
    begin = 0.15 * 20 * G_N / 20
    x = 20 * np.maximum(motion.time - begin, 0.0) ** 3 / 6 / 20
    np.testing.assert_allclose(motion["x"], x, atol=EXACT)
    np.testing.assert_allclose(motion["phi"], 0.0, atol=1e-12)
    slips = [event.time for event in motion.events if event.kind == "slips"]
    np.testing.assert_allclose(slips, [begin, begin], rtol=1e-11)


def test_both_corners_break_away_at_the_limit_of_all() -> None:
    """Corners that share a load which the motion does not determine leave together, and not before mu m g."""
    told = [event for event in _model("tipping_box").simulate().events if event.kind == "opened"]
    assert [event.time for event in told] == [pytest.approx(20 * G_N * 0.2 / 20, rel=1e-11)]


def test_a_capsule_falls_when_the_pads_relax() -> None:
    motion = _as_derived("pinched_capsule", 1.8, relax=5.5)
    begin = (10 - 0.045 * G_N) / 5.5
    slips = [event.time for event in motion.events if event.kind == "slips"]
    np.testing.assert_allclose(slips, [begin, begin], rtol=1e-11)


def test_a_hand_that_is_too_fast_leaves_the_workpiece_behind() -> None:
    motion = _model("gripper").simulate(parameters={"f": 25.0}, stop=0.02, tolerance=1e-10)
    lifted = (2 * 0.6 * 12 / 0.5 - G_N) * motion.time**2 / 2
    np.testing.assert_allclose(motion["y"], lifted, atol=EXACT * lifted[-1])


def test_a_wedge_on_a_rough_floor_stays() -> None:
    motion = _model("wedge").simulate(parameters={"mu_floor": 0.5}, stop=0.5, tolerance=1e-10)
    alpha = np.radians(40)
    s = G_N * (np.sin(alpha) - 0.15 * np.cos(alpha)) * motion.time**2 / 2
    np.testing.assert_allclose(motion["X"], 0.0, atol=1e-12)
    np.testing.assert_allclose(motion["s"], s, atol=EXACT * s[-1])


def test_a_wedge_breaks_away_where_both_faces_are_at_their_limits() -> None:
    told = [(event.time, event.kind) for event in _model("wedge_under_load").simulate().events if event.time > 0]
    slips = [time for time, kind in told if kind == "slips"]
    rho = np.arctan(0.2)
    push = 100 * G_N * (np.tan(np.radians(8) + rho) + 0.2) + 0.2 * 2 * G_N
    np.testing.assert_allclose(slips, [push / 400] * 2, rtol=1e-11)


def test_the_cube_slides_on_and_does_not_jump() -> None:
    """6 m/s, mu = 0.5: v^2/(2 mu g)."""
    motion = _model("sliding_cube").simulate()
    assert motion["x"][-1] == pytest.approx(36 / G_N, rel=1e-9)
    assert np.max(np.abs(motion["y"] - 0.05)) <= 1e-12
    assert np.max(np.abs(motion["phi"])) <= 1e-12


# ---- events ----------------------------------------------------------------------------------------------------------


def test_a_coulomb_oscillator_tells_its_turns() -> None:
    """3.3, 2.8, ... 0.3 - 0.25: reversals of every half period, and rest where k x < R."""
    told = _happened(_model("coulomb_oscillator").simulate(tolerance=1e-10), "floor")
    assert [kind for _, kind in told] == ["reverses"] * 6 + ["sticks"]
    np.testing.assert_allclose([time for time, _ in told], np.pi / 2 * np.arange(1, 8), rtol=1e-9)


def test_a_belt_tells_when_it_takes_the_block_along() -> None:
    motion = _model("stick_slip_belt").simulate(tolerance=1e-10)
    swing = (np.pi + 2 * np.arctan2(0.5, np.sqrt(2) * 0.25)) / np.sqrt(2)
    times = np.cumsum([1.5] + [swing, 1.0] * 4)
    told = _happened(motion, "grip")
    assert [kind for _, kind in told] == (["slips", "sticks"] * 5)[: len(told)]
    np.testing.assert_allclose([time for time, _ in told], times[: len(told)], atol=1e-9)


def test_what_it_tells_of_its_force_is_the_force() -> None:
    """While it sticks the spring's, while it slides the limit, against the slip."""
    motion = _model("stick_slip_belt").simulate(tolerance=1e-10)
    sticks, near = motion["sticks"] > 0.5, 1e-9
    np.testing.assert_allclose(motion["carried"][sticks], 2 * motion["x"][sticks], atol=1e-8)
    np.testing.assert_allclose(np.abs(motion["carried"][~sticks]), 1.0, atol=near)
    assert np.all(motion["carried"] * (motion["der(x)"] - 0.5) <= near)


def test_a_rocking_block_loses_housners_part_at_each_blow() -> None:
    motion = _model("rocking_block").simulate(tolerance=1e-10)
    ratio = 1 - 1.5 * np.sin(np.arctan2(0.2, 0.5)) ** 2
    blows = sorted({event.time for event in motion.events if event.kind == "impact"})
    assert len(blows) >= 3
    for time in blows:
        before, after = motion["der(phi)"][motion.time == time][[0, -1]]
        assert after / before == pytest.approx(ratio, rel=1e-8)


@pytest.mark.skipif(not ALL, reason="a hundred blows")
def test_a_rocking_block_comes_to_rest() -> None:
    motion = _model("rocking_block").simulate(stop=10.0, tolerance=1e-10)
    rest = {"phi": 0.0, "x": 0.2, "y": 0.5}
    for name, value in rest.items():
        assert motion[name][-1] == pytest.approx(value, abs=1e-9)
    assert {event.kind for event in motion.events if event.time > motion.events[-1].time - 1e-9} >= {"closed"}


# ---- where no motion goes on -----------------------------------------------------------------------------------------


def test_painleves_rod_is_told_with_its_instant() -> None:
    """1 + 3 cos(phi)(cos(phi) - mu sin(phi)) = 0 at 0.82076 rad: there the normal force has no bound."""
    with pytest.raises(lagdsl.SimulationFailed) as found:
        _model("painleve_rod").simulate(stop=0.4, tolerance=1e-10)
    critical = (np.arcsin(2.5 / np.hypot(1.5, 2.4)) + np.arctan2(1.5, 2.4)) / 2
    assert found.value.state["phi"] == pytest.approx(critical, abs=1e-3)
    assert "ground" in str(found.value)


def test_a_rod_that_is_dragged_slides_on() -> None:
    """The other way there is no paradox."""
    motion = _model("painleve_rod").simulate(parameters={"v0": 20.0}, stop=0.2, tolerance=1e-10)
    assert np.all(motion["N"] > 0)
