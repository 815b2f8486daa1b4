"""Islands move by themselves: each as it moves alone, with the rows and the events of all."""

from __future__ import annotations

import pickle

import numpy as np
import pytest

import lagdsl
from lagdsl.foundation.numerics.rank import Floats
from lagdsl.motion.simulate.failure import SimulationFailed
from lagdsl.motion.simulate.islands.runs import Runs

G = 9.80665
HEIGHTS = (0.2, 0.35, 0.5, 1.0)
STOP = 0.9
# Behind so many a ball of these is at rest, as far as anybody sees.
FLIGHTS = 30
BALLS = """
model Balls
  coordinate Length h[4](start = {0.2 m, 0.35 m, 0.5 m, 1 m});
  discrete Integer falls[4](each start = 0);
  gravity = -g_n*world.y;
  for i in 1:4 loop
    mass 1 kg at {i*(1 m), h[i]};
    contact floor: h[i] >= 0 with restitution = 0.5;
    when h[i] < 0.1 m then
      falls[i] = pre(falls[i]) + 1;
    end when;
  end for;
  output Energy e[4] = {1/2*(1 kg)*der(h[i])^2 + (1 kg)*g_n*h[i] for i in 1:4};
end Balls;
"""


@pytest.fixture(scope="module")
def balls() -> lagdsl.Model:
    return lagdsl.compile(BALLS, engine="tape")


@pytest.fixture(scope="module")
def motion(balls: lagdsl.Model) -> lagdsl.Trajectory:
    return balls.simulate(stop=STOP, interval=0.1)


def bounces(height: float) -> tuple[list[float], Floats, Floats]:
    """Times of the first impacts before the end; start and speed upward of each flight, the first one from its top."""
    times, speeds = [-((2.0 * height / G) ** 0.5)], [(2.0 * height * G) ** 0.5]
    while times[-1] + 2.0 * speeds[-1] / G < STOP and len(times) < FLIGHTS:
        times.append(times[-1] + 2.0 * speeds[-1] / G)
        speeds.append(0.5 * speeds[-1])
    return times[1:], np.array(times), np.array(speeds)


@pytest.mark.parametrize("k", range(4))
def test_each_moves_by_its_closed_form_at_the_events_of_others_too(motion: lagdsl.Trajectory, k: int) -> None:
    impacts, begins, speeds = bounces(HEIGHTS[k])
    found = [each.time for each in motion.events if each.name == f"floor[{k + 1}]" and each.kind == "impact"]
    np.testing.assert_allclose(found[:10], impacts[:10], rtol=1e-9)
    flight = np.searchsorted(begins, motion.time * (1.0 + 1e-9), side="right") - 1
    since = motion.time - begins[flight]
    expected = np.maximum(speeds[flight] * since - 0.5 * G * since**2, 0.0)
    np.testing.assert_allclose(motion[f"h[{k + 1}]"], expected, rtol=0.0, atol=1e-7)


def test_rows_and_events_are_those_of_all_in_the_order_of_time(motion: lagdsl.Trajectory) -> None:
    assert np.all(np.diff(motion.time) >= 0.0)
    assert [each.time for each in motion.events] == sorted(each.time for each in motion.events)
    for each in motion.events:
        assert np.count_nonzero(motion.time == each.time) == 2
    assert np.all(np.diff(motion.time[np.isin(motion.time, np.linspace(0.0, STOP, 10))]) > 0.0)
    np.testing.assert_allclose(motion.energy, motion["e"].sum(axis=1), rtol=1e-12)


def test_an_island_moves_as_it_moves_alone(balls: lagdsl.Model, motion: lagdsl.Trajectory) -> None:
    """To the bit, whatever the others do; rows of a motion that is read as a whole are those of its columns."""
    other = balls.simulate(stop=STOP, interval=0.1, start={"h[1]": 2.0, "h[2]": 0.01})
    shared = np.intersect1d(motion.time, other.time)
    for name in ("h[4]", "der(h[4])", "falls[4]", "e[4]"):
        one, two = (each[name][np.searchsorted(each.time, shared, side="right") - 1] for each in (motion, other))
        np.testing.assert_array_equal(one, two)
    column = motion.column("h[2]")
    assert column.lowest <= column.values.min() and column.highest >= column.values.max()


def test_islands_that_strike_at_one_time_share_their_rows() -> None:
    alike = BALLS.replace("0.35 m, 0.5 m, 1 m", "0.2 m, 0.2 m, 0.2 m")
    motion = lagdsl.compile(alike, engine="tape").simulate(stop=0.25, interval=0.05)
    impacts = [each for each in motion.events if each.kind == "impact"]
    assert [each.name for each in impacts] == [f"floor[{k}]" for k in range(1, 5)]
    assert np.count_nonzero(motion.time == impacts[0].time) == 2


def test_columns_are_made_when_they_are_read(balls: lagdsl.Model, monkeypatch: pytest.MonkeyPatch) -> None:
    again, asked = Runs.again, list[int]()

    def count(self: Runs, number: int, times: Floats) -> Floats:
        asked.append(number)
        return again(self, number, times)

    monkeypatch.setattr(Runs, "again", count)
    motion = balls.simulate(stop=STOP, interval=0.1)
    assert len(motion.events) > 20 and motion.column("h[3]").highest == pytest.approx(0.5) and asked == []
    assert len(motion["h[3]"]) == len(motion.time) and len(motion["der(h[3])"]) == len(motion.time) and asked == [2]


def test_islands_that_are_alike_have_one_motion(monkeypatch: pytest.MonkeyPatch) -> None:
    """Two of four balls fall from one height: three runs tell the rows and the events of all."""
    alike = lagdsl.compile(BALLS.replace("{0.2 m, 0.35 m, 0.5 m, 1 m}", "{0.2 m, 0.5 m, 0.5 m, 1 m}"), engine="tape")
    made: list[object] = []
    run = Runs._result
    monkeypatch.setattr(Runs, "_result", lambda own, piece: [made.append(piece), run(own, piece)][1])
    motion = alike.simulate(stop=STOP, interval=0.1)
    assert len(made) == 3
    times = [[each.time for each in motion.events if each.name == f"floor[{k}]"] for k in (1, 2, 3)]
    assert times[0] != times[1] == times[2] and len(times[1]) > 3
    np.testing.assert_array_equal(motion["h[2]"], motion["h[3]"])
    assert motion.column("e[2]").highest == pytest.approx(0.5 * G)


def test_it_is_taken_to_other_processes(motion: lagdsl.Trajectory) -> None:
    copy = pickle.loads(pickle.dumps(motion))
    assert copy.events == motion.events
    for name in motion.names:
        np.testing.assert_array_equal(copy[name], motion[name])
    np.testing.assert_array_equal(copy.energy, motion.energy)


def test_a_failure_of_one_ends_the_motion_of_all() -> None:
    text = BALLS.replace("end Balls;", 'equation\n  assert(h[2] > -1 m, "ball 2 is lost");\nend Balls;')
    lost = text.replace("contact floor: h[i] >= 0", "contact floor: h[i] >= -2 m")
    with pytest.raises(SimulationFailed) as failed:
        lagdsl.compile(lost, engine="tape").simulate(stop=STOP)
    assert "ball 2 is lost" in str(failed.value)
    reached = (2.0 * 1.35 / G) ** 0.5
    assert failed.value.time == pytest.approx(reached, abs=0.05)
    assert failed.value.trajectory.time[-1] == pytest.approx(reached, abs=0.05)


def test_each_tells_its_own_warnings() -> None:
    text = BALLS.replace(
        "end Balls;",
        """equation
  assert(h[1] > 0.1 m, "ball 1 is low", AssertionLevel.warning);
  assert(h[3] > 0.2 m, "ball 3 is low", AssertionLevel.warning);
end Balls;""",
    )
    motion = lagdsl.compile(text, engine="tape").simulate(stop=0.3, interval=0.01)
    told = [(each.name, each.time) for each in motion.events if each.kind == "warning"]
    assert [name for name, _ in told] == ["ball 1 is low", "ball 3 is low"]
    fallen = [(2.0 * fall / G) ** 0.5 for fall in (0.1, 0.3)]
    assert [time for _, time in told] == pytest.approx(fallen, abs=0.011)
    impacts = [each.name for each in motion.events if each.kind == "impact"]
    assert impacts == ["floor[1]", "floor[2]"]
