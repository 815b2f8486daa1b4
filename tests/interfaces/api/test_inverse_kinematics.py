"""Coordinates that place frames and points."""

from __future__ import annotations

from functools import cache

import numpy as np
import pytest
from scipy.spatial.transform import Rotation

import lagdsl
from lagdsl.foundation.numerics.rotations import inverse_right_jacobian, rotation_vector

UPPER, LOWER = 0.7, 0.5
TWO_LINKS = """model Arm "Two links that turn about z"
  parameter Length upper_length = 0.7 m, lower_length = 0.5 m;
  coordinate Angle a, b;
  frame upper = world.rotz(a);
  frame lower = upper.move({upper_length, 0, 0}).rotz(b);
  frame tool = lower.move({lower_length, 0, 0});
  point tip = lower.point({lower_length, 0, 0});
  body first(m = 1 kg, com = {0, 0, 0}, I = {0, 0, 1 kg.m2}) on upper;
  body second(m = 1 kg, com = {0, 0, 0}, I = {0, 0, 1 kg.m2}) on lower;
end Arm;
"""
LIMITED = TWO_LINKS.replace("Angle a, b;", "Angle a; coordinate Angle b(min = -90 deg, max = 60 deg);")
PANDA = "models/robots/panda.lag"
FOUR_BAR = "models/four_bar_angles.lag"
STEWART = "models/stewart_platform.lag"


@cache
def model(source: str) -> lagdsl.Model:
    return lagdsl.compile(source)


def elbow(x: float, y: float, sign: float) -> tuple[float, float]:
    """Angles of both links, by the law of cosines."""
    b = sign * np.arccos((x**2 + y**2 - UPPER**2 - LOWER**2) / (2 * UPPER * LOWER))
    return np.arctan2(y, x) - np.arctan2(LOWER * np.sin(b), UPPER + LOWER * np.cos(b)), b


@pytest.mark.parametrize("sign", [1.0, -1.0])
@pytest.mark.parametrize("place", [(0.6, 0.5), (-0.3, 0.4), (0.1, -1.1)])
def test_two_links_reach_a_place_with_either_elbow(place: tuple[float, float], sign: float) -> None:
    start = {"a": np.arctan2(place[1], place[0]) - 0.5 * sign, "b": sign}
    for part in (model(TWO_LINKS).frame("tool"), model(TWO_LINKS).point("tip")):
        found = part.solve(position=[*place, 0.0], start=start)
        assert found.converged and found.reason == "" and found.starts == 1
        np.testing.assert_allclose(found.q, elbow(*place, sign), atol=1e-12)
        assert found.position_error < 1e-14 and found.residual < 1e-14
        assert found.coordinates == {"a": found.q[0], "b": found.q[1]}


def test_a_straight_arm_reaches_inside_from_another_start() -> None:
    """From a = b = 0 every step along the arm stays on it."""
    found = model(TWO_LINKS).frame("tool").solve(position=[0.3, 0.0, 0.0])
    assert found.converged and found.starts > 1
    np.testing.assert_allclose(np.abs(found.q), np.abs(elbow(0.3, 0.0, 1.0)), atol=1e-12)
    again = model(TWO_LINKS).frame("tool").solve(position=[0.3, 0.0, 0.0])
    assert np.array_equal(again.q, found.q)


def test_the_edge_of_the_reach() -> None:
    found = model(TWO_LINKS).frame("tool").solve(position=[0.0, UPPER + LOWER, 0.0], start=[1.0, 0.5])
    assert found.converged
    np.testing.assert_allclose(found.q, [np.pi / 2, 0.0], atol=1e-6)  # the distance is of second order there


def test_out_of_reach() -> None:
    """The nearest place is that of the straight arm."""
    found = model(TWO_LINKS).frame("tool").solve(position=[0.0, 2.0, 0.0], start=[0.2, 0.3])
    assert not found.converged
    np.testing.assert_allclose(found.q, [np.pi / 2, 0.0], atol=1e-4)
    assert found.position_error == pytest.approx(2.0 - UPPER - LOWER, rel=1e-9)
    assert found.reason == "the nearest configuration found, from 25 starts, is 0.8 m away"


def test_limits_choose_the_elbow() -> None:
    arm, place = model(LIMITED).frame("tool"), (0.8, 0.6)
    wanted = elbow(*place, -1.0)
    assert wanted[1] > np.radians(-90)
    found = arm.solve(position=[*place, 0.0], start={"b": "50 deg"})
    assert found.converged and np.radians(-90) <= found.q[1] <= np.radians(60)
    folded = elbow(0.6, 0.55, -1.0)
    assert -np.radians(90) > folded[1]
    outside = arm.solve(position=[0.6, 0.55, 0.0], start=[0.2, -1.0])
    assert not outside.converged and outside.at_limits == ("b",)
    assert outside.q[1] == np.radians(-90)  # the more open of both ends reaches less far in
    distance = np.hypot(UPPER, LOWER) - np.hypot(0.6, 0.55)
    assert outside.position_error == pytest.approx(distance, rel=1e-6)
    assert "beyond limits, it would take `b` = " in outside.reason


def test_panda_goes_back_to_its_poses() -> None:
    """Position and rotation of random postures within the limits, which the search does not know."""
    panda = model(PANDA)
    hand = panda.frame("panda_hand_tcp")
    flat = panda._compilation.flat
    lower, upper = np.array([(c.minimum, c.maximum) for c in flat.coordinates], dtype=float).T
    random = np.random.default_rng(4)
    for q in lower + (upper - lower) * random.random((8, len(lower))):
        found = hand.solve(position=hand.position(0.0, q), rotation=hand.rotation(0.0, q))
        assert found.converged and found.position_error < 1e-9 and found.rotation_error < 1e-9
        np.testing.assert_allclose(hand.position(0.0, found.q), hand.position(0.0, q), atol=1e-9)
        np.testing.assert_allclose(hand.rotation(0.0, found.q), hand.rotation(0.0, q), atol=1e-9)
        assert np.all(lower <= found.q) and np.all(found.q <= upper)
        assert np.array_equal(found.q[-2:], [0.0, 0.0])  # the fingers move nothing of it


def test_rotation_alone_and_coordinates_that_are_held() -> None:
    arm = model(TWO_LINKS).frame("tool")
    half = arm.solve(rotation=np.diag([-1.0, -1.0, 1.0]), hold=["a"], start={"a": 0.4})
    assert half.converged and half.q[0] == 0.4
    assert abs(half.q[1]) + np.sign(half.q[1]) * 0.4 == pytest.approx(np.pi)
    stuck = arm.solve(position=[0.0, 1.2, 0.0], hold=["a"])
    assert not stuck.converged and stuck.reason.endswith("m away; `a` held")


def test_closed_loops_stay_closed() -> None:
    """The rocker's angle of a four-bar, from the crank's: two circles that meet (Freudenstein)."""
    bars = model(FOUR_BAR)
    crank, l2, l3, d = 0.4 * np.array([np.cos(2.0), np.sin(2.0)]), 1.0, 0.8, np.array([1.0, 0.0])
    way = d - crank
    length = np.linalg.norm(way)
    inside = np.arccos((length**2 + l3**2 - l2**2) / (2 * length * l3))
    rocker = np.arctan2(-way[1], -way[0]) - inside
    found = bars.frame("coupler").solve(position=[*crank, 0.0])
    assert found.converged and found.coordinates["a"] == pytest.approx(2.0, abs=1e-12)
    assert found.coordinates["c"] == pytest.approx(rocker, abs=1e-9)
    tip = crank + l2 * np.array([np.cos(found.q[1]), np.sin(found.q[1])])
    np.testing.assert_allclose(tip, d + l3 * np.array([np.cos(rocker), np.sin(rocker)]), atol=1e-9)
    away = bars.frame("coupler").solve(position=[0.0, 0.6, 0.0])  # the crank has 0.4 m; the loop stays closed
    assert not away.converged and away.position_error == pytest.approx(0.2, rel=1e-6)
    assert np.linalg.norm(bars._engine.evaluate("position_constraint", *_at(bars, away.q))[0]) < 1e-9


def _at(subject: lagdsl.Model, q: np.ndarray) -> tuple[object, ...]:
    return 0.0, q, np.zeros_like(q), np.zeros(0), np.zeros(0), np.zeros(0), subject.defaults


def test_legs_of_a_stewart_platform() -> None:
    """Lengths of the legs are distances of their ends, for any place and rotation of the plate."""
    platform = model(STEWART)
    place, turn = np.array([0.05, -0.03, 0.75]), Rotation.from_rotvec([0.1, -0.15, 0.2]).as_matrix()
    found = platform.frame("plate").solve(position=place, rotation=turn)
    assert found.converged
    base, top = (np.radians(angles) for angles in ([-12, 12, 108, 132, 228, 252], [-50, 50, 70, 170, 190, 290]))
    feet = 0.6 * np.stack([np.cos(base), np.sin(base), 0 * base], -1)
    balls = place + 0.35 * np.stack([np.cos(top), np.sin(top), 0 * top], -1) @ turn.T
    lengths = [found.coordinates[f"leg[{i}].slide.s"] for i in range(1, 7)]
    np.testing.assert_allclose(lengths, np.linalg.norm(balls - feet, axis=1), atol=1e-9)


def test_other_parameters() -> None:
    found = model(TWO_LINKS).point("tip").solve(position=[2.0, 0.0, 0.0], parameters={"upper_length": "1.5 m"})
    np.testing.assert_allclose(found.q, 0.0, atol=1e-7)


BEADS = """model Beads
  coordinate Length x(start = 1 m), y;
  constraint tie: {row};
  frame second = world.move({{x, y, 0}});
  mass 1 kg at {{x, y, 0}};
end Beads;
"""


def test_a_position_that_the_motion_before_decides_is_refused() -> None:
    tied = lagdsl.compile(BEADS.format(row="der(y) = 2*der(x)"))
    with pytest.raises(lagdsl.CompilationFailed, match=r"E0867.*constraint `tie` restricts positions"):
        tied.frame("second").solve(position=[2.0, 2.0, 0.0])
    stated = lagdsl.compile(BEADS.format(row="y = 2*(x - 1 m)"))
    assert stated.frame("second").solve(position=[2.0, 2.0, 0.0]).q == pytest.approx([2.0, 2.0])
    assert not stated.frame("second").solve(position=[2.0, 2.5, 0.0]).converged


def test_rows_that_restrict_no_position_are_no_obstacle() -> None:
    """A skate gets everywhere."""
    skate = lagdsl.compile("models/knife_edge.lag")
    plane = Rotation.from_euler("y", 20, degrees=True)
    turn = (plane * Rotation.from_euler("z", 1.0)).as_matrix()
    found = skate.frame("skate").solve(position=plane.apply([0.3, -0.2, 0.0]), rotation=turn)
    np.testing.assert_allclose(found.q, [0.3, -0.2, 1.0], atol=1e-12)


@pytest.mark.parametrize(
    ("arguments", "said"),
    [
        ({}, "give a position, a rotation, or both"),
        ({"position": [1.0, 2.0]}, r"position must have the shape \(3,\)"),
        ({"position": [1.0, np.nan, 0.0]}, "position must be made of finite numbers"),
        ({"rotation": 2 * np.eye(3)}, "rotation is no rotation matrix"),
        ({"rotation": np.diag([1.0, 1.0, -1.0])}, "rotation is no rotation matrix"),
        ({"position": [1.0, 0.0, 0.0], "hold": ["aa"]}, "did you mean `a`|there are a, b|there are `a`"),
        ({"position": [1.0, 0.0, 0.0], "start": [1.0]}, "start must have 2 entries"),
    ],
)
def test_arguments_that_do_not_fit(arguments: dict[str, object], said: str) -> None:
    with pytest.raises((ValueError, lagdsl.UnknownName), match=said):
        model(TWO_LINKS).frame("tool").solve(**arguments)  # type: ignore[arg-type]


def test_vectors_of_rotations() -> None:
    """Against SciPy, half turns included; the derivative by central differences."""
    random = np.random.default_rng(8)
    vectors = [*random.normal(size=(20, 3)), np.zeros(3), 1e-9 * np.ones(3), *(np.pi * np.eye(3))]
    for vector in vectors:
        matrix = Rotation.from_rotvec(vector).as_matrix()
        np.testing.assert_allclose(Rotation.from_rotvec(rotation_vector(matrix)).as_matrix(), matrix, atol=1e-14)
    h = 1e-5
    for vector in vectors[:20]:
        size = np.linalg.norm(vector)
        r = vector if size < 3.0 else 2.5 * vector / size
        base = Rotation.from_rotvec(r)
        columns = [
            (base * Rotation.from_rotvec(h * e)).as_rotvec() - (base * Rotation.from_rotvec(-h * e)).as_rotvec()
            for e in np.eye(3)
        ]
        np.testing.assert_allclose(inverse_right_jacobian(r), np.transpose(columns) / (2 * h), atol=1e-8)
