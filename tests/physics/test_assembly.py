"""Motions and reactions do not depend on how a mechanism is put together, and agree with statics by hand."""

from __future__ import annotations

from functools import cache

import numpy as np
import pytest
from choice import repeats, spread
from hypothesis import given, settings
from hypothesis import strategies as st

import lagdsl

JOINTS = ("A", "B", "C", "D")
LINKS = ("crank", "coupler", "rocker")
REACTIONS = tuple(f"{kind}_{part}[{k}]" for part in (*JOINTS, *LINKS) for kind in "ft" for k in (1, 2, 3))
# The chain from port to port, and each connection of two neighbors.
PORTS = ["world"] + [
    f"{part}.frame_{side}" for part in ("A", "crank", "B", "coupler", "C", "rocker", "D") for side in "ab"
]
PAIRS = list(zip(PORTS[::2], [*PORTS[1::2], "pin.frame_b"], strict=True))

LINES = {
    "crank": "Link crank(l = 0.4 m, m = 1 kg);",
    "coupler": "Link coupler(l = 1 m, m = 2 kg);",
    "rocker": "Link rocker(l = 0.8 m, m = 1.5 kg);",
    "A": "Revolute A(q(start = 60 deg, fixed = true, der(start = 2 rad/s){A}));",
    "B": "Revolute B(q(start = -33 deg{B}));",
    "C": "Revolute C(q(start = -123 deg{C}));",
    "D": "Revolute D(q(start = 96 deg{D}), tau = 1 N.m);",
    "pin": "Fixed pin(r = {{1 m, 0}});",
}
CHAIN = "connect(world, A, crank, B, coupler, C, rocker, D, pin);"


def four_bar(
    connects: str = CHAIN,
    order: tuple[str, ...] = tuple(LINES),
    library: str = "Planar",
    spring: str = "",
    **marks: str,
) -> str:
    wishes = {joint: f", prefer = {marks[joint]}" if joint in marks else "" for joint in JOINTS}
    parts = "\n  ".join(LINES[name].format(**wishes) for name in order)
    outputs = "\n  ".join(
        f"output {quantity} {kind}_{part}[3] = reaction({part}).{word};"
        for part in (*JOINTS, *LINKS)
        for kind, quantity, word in (("f", "Force", "force"), ("t", "Torque", "torque"))
    )
    return f"""model M
  import Lag.{library}.*;
  {parts}
  gravity = -g_n*world.y;
  dissipation 1/2*(0.1 N.m.s/rad)*der(B.q)^2;
  {spring}
  {connects}
  {outputs}
end M;
"""


@cache
def motion(text: str) -> lagdsl.Trajectory:
    return lagdsl.compile(text).simulate(stop=0.6, interval=0.1, tolerance=1e-11)


def assert_same(text: str, other: str, columns: tuple[str, ...] = REACTIONS) -> None:
    one, two = motion(text), motion(other)
    for column in (*(f"{joint}.q" for joint in JOINTS), *columns):
        size = 1e-9 if column.endswith("q") else 2e-8
        np.testing.assert_allclose(two[column], one[column], rtol=0, atol=size, err_msg=column)


# ---- the same mechanism, put together in other ways ------------------------------------------------------------------


@pytest.mark.parametrize("joint", spread(JOINTS, 2))
def test_any_joint_may_be_cut(joint):
    assert_same(four_bar(), four_bar(**{joint: "never"}))


@pytest.mark.parametrize("joint", spread(JOINTS, 2))
def test_a_spring_knows_how_far_it_is_wound_whatever_is_cut(joint):
    spring = "potential 1/2*(2 N.m/rad)*B.q^2 + 1/2*(1 N.m/rad)*(D.q - 1)^2;"
    assert_same(four_bar(spring=spring), four_bar(spring=spring, **{joint: "never"}))


@repeats("test_any_joint_may_be_cut")
def test_a_chain_may_be_entered_from_behind():
    backward = "connect(pin, D.frame_b); connect(D.frame_a, rocker.frame_b); connect(rocker.frame_a, C.frame_b);"
    rest = (
        "connect(C.frame_a, coupler.frame_b); connect(coupler.frame_a, B.frame_b); connect(B.frame_a, crank.frame_b);"
    )
    ends = "connect(crank.frame_a, A.frame_b); connect(A.frame_a, world);"
    for joint in JOINTS:
        assert_same(four_bar(), four_bar(f"{backward}\n{rest}\n{ends}", **{joint: "never"}))


@settings(max_examples=6)
@given(st.permutations(list(LINES)), st.permutations(PAIRS), st.lists(st.booleans(), min_size=8, max_size=8))
def test_the_order_of_the_text_does_not_matter(order, pairs, swapped):
    connects = [
        f"connect({b}, {a});" if swap else f"connect({a}, {b});" for (a, b), swap in zip(pairs, swapped, strict=True)
    ]
    assert_same(four_bar(), four_bar("\n".join(connects), tuple(order)))


def test_spatial_revolutes_move_as_planar_ones():
    planar, spatial = four_bar(), four_bar(library="Spatial")
    spatial = spatial.replace("(r = {1 m, 0})", "(r = {1 m, 0, 0})")
    in_plane = tuple(f"f_{part}[{k}]" for part in (*JOINTS, *LINKS) for k in (1, 2))
    assert_same(planar, spatial, in_plane)


def test_a_third_bar_changes_nothing():
    """A parallelogram moves as its two cranks do; a massless third crank between them is redundant."""
    text = """model Parallelogram
  import Lag.Planar.*;
  Link left(l = 0.5 m, m = 1 kg), right(l = 0.5 m, m = 1 kg);
  FixedTranslation half(r = {0.5 m, 0}), rest(r = {0.5 m, 0});
  Body beam(m = 2 kg, com = {0.5 m, 0}, Izz = 0.1 kg.m2);
  Revolute A(q(start = 40 deg, fixed = true)), B(q(start = -40 deg)), C(q(start = -40 deg)), D;
  Fixed ground(r = {1 m, 0}), middle(r = {0.5 m, 0});
  gravity = -g_n*world.y;
  connect(world, A, left, B, half, rest);
  connect(half.frame_a, beam);
  connect(ground, D, right, C, rest.frame_b);
  %s
end Parallelogram;
"""
    third = "FixedTranslation bar(r = {0.5 m, 0});\n  Revolute E, F;\n  connect(middle, E, bar, F, half.frame_b);"
    two = lagdsl.compile(text % "").simulate(stop=1, interval=0.1, tolerance=1e-10)
    three = lagdsl.compile(text % third).simulate(stop=1, interval=0.1, tolerance=1e-10)
    np.testing.assert_allclose(three["A.q"], two["A.q"], rtol=0, atol=1e-8)
    np.testing.assert_allclose(three["E.q"] - three["E.q"][0], two["A.q"] - two["A.q"][0], rtol=0, atol=1e-8)


# ---- coordinates of cut joints ---------------------------------------------------------------------------------------

KINDS = {
    "Revolute": ("axis = {1, 2, 2}, q(start = 20 deg, der(start = 1 rad/s)%s)", ["q"]),
    "Prismatic": ("axis = {1, 2, 2}, s(start = 0.1 m, der(start = 0.3 m/s)%s)", ["s"]),
    "Cylindrical": ("axis = {1, 2, 2}, s(start = 0.1 m%s), q(start = 0.3 rad, der(start = 2 rad/s))", ["s", "q"]),
    "Universal": ("a(start = 20 deg, der(start = 1 rad/s)%s), b(start = -0.3 rad)", ["a", "b"]),
    "Planar": (
        "x(start = 0.2 m%s), y(der(start = 0.3 m/s)), q(start = 0.4 rad, der(start = 1 rad/s))",
        ["x", "y", "q"],
    ),
    "Spherical": ("e(start = {0.8, 0.6, 0, 0}%s)", ["e[1]", "e[2]", "e[3]", "e[4]"]),
}
ANY_SEQUENCE = """joint Turned
  frame frame_a, frame_b;
  coordinate Angle a, b, c;
  parameter Angle offset = 0.2 rad;
kinematics
  frame_b = frame_a.move({0.1 m, 0, 0}).euler("%s", a, -b, c + offset).rotx(0.3 rad);
closure
  frame_b.origin = frame_a.point({0.1 m, 0, 0});
end Turned;
"""
SEQUENCES = ("xyz", "xzy", "yxz", "yzx", "zxy", "zyx", "xyx", "xzx", "yxy", "yzy", "zxz", "zyz")


def against_a_free_body(head: str, joint: str, names: list[str]) -> None:
    """The joint in the tree against the joint cut, both with a body that has six coordinates of its own."""
    text = f"""{head}
model M
  import Lag.Spatial.*;
  {joint}
  FreeQuaternion k(r(start = {{0.1, 0.1, 0.1}}));
  BodyShape b(r = {{0.3, 0.1, 0}}, m = 2, I = {{0.1, 0.2, 0.15}});
  gravity = -g_n*world.y;
  connect(world.move({{0.1 m, 0, 0}}).rotx(0.3 rad), j, b);
  connect(world, k, b.frame_a);
  output Force f[3] = reaction(j).force;
  output Torque t[3] = reaction(j).torque;
end M;
"""
    tree, cut = (lagdsl.compile(text.replace("%s", f", prefer = {wish}")) for wish in ("always", "never"))
    assert f"j.{names[0]}" in tree.coordinates
    assert not any(name.startswith("j.") for name in cut.coordinates)
    states = tree.simulate(stop=0.4, interval=0.1, tolerance=1e-10)
    q = np.column_stack([states[name] for name in cut.coordinates])
    qd = np.column_stack([states[f"der({name})"] for name in cut.coordinates])
    found = dict(zip(cut.outputs, cut.output(states.time, q, qd).T, strict=True))
    for name in names:
        difference = states[f"j.{name}"] - found[f"j.{name}"]
        np.testing.assert_allclose(np.sin(difference / 2), 0, atol=1e-9, err_msg=name)
    for name in (*(f"f[{k}]" for k in (1, 2, 3)), *(f"t[{k}]" for k in (1, 2, 3))):
        np.testing.assert_allclose(found[name], states[name], rtol=0, atol=1e-7, err_msg=name)


@pytest.mark.parametrize("kind", spread(KINDS, 2))
def test_coordinates_and_reactions_of_cut_joints(kind):
    modifiers, names = KINDS[kind]
    against_a_free_body("", f"{kind} j({modifiers});", names)


@pytest.mark.parametrize("sequence", spread(SEQUENCES, 1))
def test_angles_of_every_sequence(sequence):
    starts = "a(start = 0.3 rad, der(start = 1 rad/s)%s), b(start = -0.7 rad), c(start = 0.5 rad)"
    against_a_free_body(ANY_SEQUENCE % sequence, f"Turned j({starts});", ["a", "b", "c"])


def test_the_column_of_a_cut_angle_is_continuous():
    text = """model Spun
  import Lag.Planar.*;
  Revolute a(q(der(start = 30 rad/s))), b;
  Link rod(l = 1 m, m = 1 kg);
  gravity = 0;
  connect(world, a, rod);
  connect(world.rotz(1 rad), b, rod.frame_a);
end Spun;
"""
    found = lagdsl.compile(text).simulate(stop=2, interval=0.05)
    np.testing.assert_allclose(found["b.q"], found["a.q"] - 1, rtol=0, atol=1e-7)
    assert found["b.q"][-1] > 50


# ---- reactions by hand -----------------------------------------------------------------------------------------------


def hanging(way: str) -> lagdsl.Trajectory:
    """A rod of 1 m and 2 kg welded level to a clamp, a load of 3 kg at its end: at rest."""
    return lagdsl.compile(
        f"""model Beam
  import Lag.Planar.*;
  Link rod(l = 1 m, m = 2 kg);
  Revolute pin(q(fixed = true), tau = -(1 N.m.s/rad)*der(pin.q));
  Body load(m = 3 kg);
  gravity = -(10 m/s2)*world.y;
  {way}
  constraint rest: pin.q = 0;
  output Force F[3] = reaction(pin).force;
  output Torque T[3] = reaction(pin).torque;
  output Force E[3] = reaction(rod).force;
  output Torque M[3] = reaction(rod).torque;
end Beam;
"""
    ).simulate(stop=0.1, interval=0.1)


def test_reactions_of_a_cantilever():
    """The clamp holds 50 N; 1 m * 30 N + 0.5 m * 20 N; at the far end of the rod only the load is handed on."""
    found = hanging("connect(world, pin, rod, load);")
    assert [found[f"F[{k}]"][0] for k in (1, 2, 3)] == pytest.approx([0, 50, 0], abs=1e-9)
    assert [found[f"T[{k}]"][0] for k in (1, 2, 3)] == pytest.approx([0, 0, 40], abs=1e-9)
    assert [found[f"E[{k}]"][0] for k in (1, 2, 3)] == pytest.approx([0, 30, 0], abs=1e-9)
    assert [found[f"M[{k}]"][0] for k in (1, 2, 3)] == pytest.approx([0, 0, 0], abs=1e-9)


def test_reactions_of_a_reversed_cantilever():
    """Clamped at frame_b: the side of frame_a is carried, so all signs turn; the torque is about frame_b."""
    found = hanging("connect(world, pin.frame_b); connect(pin.frame_a, rod.frame_b); connect(rod.frame_a, load);")
    assert [found[f"F[{k}]"][0] for k in (1, 2, 3)] == pytest.approx([0, -50, 0], abs=1e-9)
    assert [found[f"T[{k}]"][0] for k in (1, 2, 3)] == pytest.approx([0, 0, 40], abs=1e-9)
    # rod.frame_b is at the clamp, the rod and the load hang on frame_a at x = -1 m
    assert [found[f"E[{k}]"][0] for k in (1, 2, 3)] == pytest.approx([0, -50, 0], abs=1e-9)
    assert [found[f"M[{k}]"][0] for k in (1, 2, 3)] == pytest.approx([0, 0, 40], abs=1e-9)


ON_A_SWING = """%s
model Swing
  import Lag.Planar.*;
  Revolute hinge(q(start = 20 deg, fixed = true, der(start = 1 rad/s)));
  Link arm(l = 0.7 m, m = 2 kg);
  Link crank(l = 0.4 m, m = 1 kg), coupler(l = 1 m, m = 2 kg), rocker(l = 0.8 m, m = 1.5 kg);
  Revolute A(q(start = 60 deg, fixed = true)), B(q(start = -33 deg)), C(q(start = -123 deg));
  %s D(q(prefer = %s));
  FixedTranslation base(r = {1 m, 0});
  gravity = -g_n*world.y;
  torque 2 N.m on D.q;
  connect(world, hinge, arm, A, crank, B, coupler, C, rocker, D, base.frame_b);
  connect(arm.frame_b, base);
  %s
end Swing;
"""
IN_THE_WORLD = """joint Pin "Its closure speaks of the world: nothing is seen from elsewhere"
  frame frame_a, frame_b;
  coordinate Angle q;
kinematics
  frame_b = frame_a.rotz(q);
closure
  frame_b.origin = frame_a.origin + (0 m)*world.x;
  frame_b.z = frame_a.z;
end Pin;
"""


def test_a_loop_on_a_moving_base_is_seen_from_there():
    """The same motion and reactions in the world, whether the closure is formed there or on the swing."""

    def reactions(*parts: str) -> str:
        return "\n  ".join(
            f"output {quantity} {kind}_{part}[3] = reaction({part}).{word};"
            for part in parts
            for kind, quantity, word in (("f", "Force", "force"), ("t", "Torque", "torque"))
        )

    outputs = reactions("hinge", "arm", *JOINTS, *LINKS, "base")
    here = lagdsl.compile(ON_A_SWING % ("", "Revolute", "never", outputs))
    there = lagdsl.compile(ON_A_SWING % (IN_THE_WORLD, "Pin", "never", outputs))
    one, two = (model.simulate(stop=0.6, interval=0.1, tolerance=1e-11) for model in (here, there))
    assert np.ptp(one["hinge.q"]) > 0.5
    for name in here.coordinates:
        np.testing.assert_allclose(two[name], one[name], rtol=0, atol=1e-9, err_msg=name)
    for name in here.outputs:
        np.testing.assert_allclose(two[name], one[name], rtol=0, atol=3e-8, err_msg=name)
    by_text = lagdsl.compile(ON_A_SWING % ("", "Revolute", "never", reactions("hinge", "B")), derivation="textbook")
    q = np.array([[one[name][3] for name in here.coordinates]])
    qd = np.array([[one[f"der({name})"][3] for name in here.coordinates]])
    found, expected = by_text.output(0.3, q, qd)[0], here.output(0.3, q, qd)[0]
    for name in by_text.outputs:
        assert found[by_text.outputs.index(name)] == pytest.approx(expected[here.outputs.index(name)], abs=1e-9), name


def test_pin_forces_against_points_and_constraints():
    """The four-bar from rods between points, its pins as vector constraints: multipliers are the pin forces."""
    points = lagdsl.compile(
        """model Points
  coordinate Length x[3], y[3];
  coordinate Angle p[3];
  parameter Length l[3] = {0.4, 1, 0.8};
  parameter Mass m[3] = {1, 2, 1.5};
  frame F[3];
  for i in 1:3 loop
    frame F[i] = world.move({x[i], y[i], 0}).rotz(p[i]);
    body b(m = m[i], com = {l[i]/2, 0, 0}, Izz = m[i]*l[i]^2/12) on F[i];
  end for;
  gravity = -g_n*world.y;
  constraint A: F[1].origin = {0, 0, 0};
  constraint B: F[2].origin = F[1].point({l[1], 0, 0});
  constraint C: F[3].origin = F[2].point({l[2], 0, 0});
  constraint D: {1 m, 0, 0} = F[3].point({l[3], 0, 0});
  output Force A_[3] = multiplier(A);
  output Force B_[3] = multiplier(B);
  output Force C_[3] = multiplier(C);
  output Force D_[3] = multiplier(D);
end Points;
"""
    )
    text = four_bar().replace("dissipation 1/2*(0.1 N.m.s/rad)*der(B.q)^2;", "").replace(", tau = 1 N.m", "")
    built = motion(text)
    angles = np.cumsum(np.column_stack([built[f"{joint}.q"] for joint in "ABC"]), axis=1)
    rates = np.cumsum(np.column_stack([built[f"der({joint}.q)"] for joint in "ABC"]), axis=1)
    x, y, xd, yd = (np.zeros_like(angles) for _ in range(4))
    for k, length in enumerate((0.4, 1.0)):
        x[:, k + 1] = x[:, k] + length * np.cos(angles[:, k])
        y[:, k + 1] = y[:, k] + length * np.sin(angles[:, k])
        xd[:, k + 1] = xd[:, k] - length * np.sin(angles[:, k]) * rates[:, k]
        yd[:, k + 1] = yd[:, k] + length * np.cos(angles[:, k]) * rates[:, k]
    found = points.output(built.time, np.hstack([x, y, angles]), np.hstack([xd, yd, rates]))
    table = dict(zip(points.outputs, found.T, strict=True))
    for joint in JOINTS:
        for k in (1, 2):
            np.testing.assert_allclose(built[f"f_{joint}[{k}]"], table[f"{joint}_[{k}]"], rtol=0, atol=1e-6)
