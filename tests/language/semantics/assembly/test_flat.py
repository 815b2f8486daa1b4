"""Results of assembly: frames, cut joints, merged coordinates, nodes."""

from __future__ import annotations

import math
from time import process_time

import pytest

from lagdsl.foundation.diagnostics import Sink
from lagdsl.foundation.source import SourceFile
from lagdsl.language.flat.dependence import Dependence
from lagdsl.language.flat.model import FlatModel, Frame
from lagdsl.language.flat.text import flat_text
from lagdsl.language.semantics.flatten import flatten
from lagdsl.language.semantics.scope.constants import evaluate
from lagdsl.language.syntax.parser import parse

PARTS = """
  import Lag.Planar.*;
  Link crank(l = 0.4 m, m = 1 kg), coupler(l = 1 m, m = 2 kg), rocker(l = 0.8 m, m = 1.5 kg);
  Fixed pin(r = {1 m, 0});
  gravity = -g_n*world.y;
  connect(world, A, crank, B, coupler, C, rocker, D, pin);
"""


def flat_of(text: str) -> tuple[FlatModel, list[str]]:
    sink = Sink()
    unit = parse(SourceFile("x.lag", text), sink)
    assert unit is not None
    flat = flatten(unit, sink)
    assert flat is not None, [diagnostic.message for diagnostic in sink.diagnostics]
    return flat, [diagnostic.code for diagnostic in sink.diagnostics]


def four_bar(joints: str, more: str = "") -> tuple[FlatModel, list[str]]:
    return flat_of(f"model FourBar\n{PARTS}\n{joints}\n{more}\nend FourBar;\n")


def cut(flat: FlatModel) -> list[str]:
    return [joint.name for joint in flat.joints if joint.cut]


def names(flat: FlatModel) -> list[str]:
    return [coordinate.name for coordinate in flat.coordinates]


# ---- which joint is cut ----------------------------------------------------------------------------------------------


@pytest.mark.parametrize(
    ("joints", "expected"),
    [
        ("Revolute A, B, C, D;", "D"),
        ("Revolute D, C, B, A;", "A"),
        ("Revolute A, B, C, D(q(start = 1 rad));", "C"),
        ("Revolute A, B(q(start = 1 rad)), C, D(q(fixed = true));", "C"),
        ("Revolute A, B, C, D(q(prefer = always));", "C"),
        ("Revolute A, B(q(prefer = never)), C, D;", "B"),
        ('Revolute A, B(q(prefer = "never")), C, D;', "B"),
    ],
)
def test_the_joint_that_is_cut(joints, expected):
    flat, _ = four_bar(joints)
    assert cut(flat) == [expected]
    assert sorted(names(flat)) == [f"{joint}.q" for joint in "ABCD" if joint != expected]
    (output,) = flat.outputs
    assert (output.name, output.joint) == (f"{expected}.q", expected)
    assert output.turn is not None and evaluate(output.turn) == 2.0 * math.pi


def test_a_joint_whose_angle_a_spring_winds_stays_in_the_tree():
    flat, _ = four_bar("Revolute A, B, C, D;", "potential 1/2*(3 N.m/rad)*D.q^2;")
    assert cut(flat) == ["C"]


@pytest.mark.parametrize("more", ["torque (2 N.m) on D.q;", "dissipation 1/2*(1 N.m.s/rad)*der(D.q)^2;"])
def test_a_joint_whose_angle_is_only_turned_may_be_cut(more):
    flat, _ = four_bar("Revolute A, B, C, D;", more)
    assert cut(flat) == ["D"]
    assert "D.q" not in names(flat)


def test_a_torsion_spring_on_every_joint_keeps_the_coordinate_of_the_cut_one():
    springs = "".join(f"TorsionSpring s{joint}(q = {joint}.q, k = 1 N.m/rad);\n" for joint in "ABCD")
    flat, _ = four_bar("Revolute A, B, C, D;", springs)
    assert cut(flat) == ["D"]
    assert names(flat) == ["A.q", "B.q", "C.q", "D.q"]
    assert [len(constraint.rows) for constraint in flat.constraints] == [3, 3]


def test_fixed_starts_in_all_joints_are_kept():
    flat, _ = four_bar("Revolute A, B, C, D;".replace(",", "(q(fixed = true)),").replace(";", "(q(fixed = true));"))
    assert names(flat) == ["A.q", "B.q", "C.q", "D.q"]
    assert all(coordinate.fixed for coordinate in flat.coordinates)


def test_a_joint_with_a_written_start_keeps_its_coordinate():
    flat, _ = four_bar("Revolute A(q(start = 1 rad)), B(q(start = 1 rad)), C(q(start = 1 rad)), D(q(start = 1 rad));")
    assert names(flat) == ["A.q", "B.q", "C.q", "D.q"]
    assert all(coordinate.start_explicit for coordinate in flat.coordinates)


def test_the_loop_and_its_rows_have_names():
    flat, _ = four_bar("Revolute A, B, C, D;")
    rows = [row for constraint in flat.constraints for row in constraint.rows]
    assert rows == [f"closure(D)[{k}]" for k in range(1, len(rows) + 1)]
    closure = flat.constraints[0].closure
    assert closure is not None
    assert closure.joint == "D"
    assert closure.loop == ("A", "crank", "B", "coupler", "C", "rocker", "D")
    assert closure.span.text.startswith("connect(world, A")


# ---- frames ----------------------------------------------------------------------------------------------------------


def test_frames_stand_in_the_order_of_need_whatever_the_order_of_the_text():
    text = """model M
  import Lag.Planar.*;
  connect(a, lower);
  connect(upper, a.frame_b);
  connect(world.move({0.1 m, 0}), b, upper.frame_a);
  gravity = -g_n*world.y;
  Link lower(l = 1 m, m = 1 kg), upper(l = 1 m, m = 1 kg);
  Revolute a, b;
end M;
"""
    text = text.replace("connect(a, lower);", "connect(a.frame_a, lower.frame_b);").replace(
        "connect(upper, a.frame_b);", "connect(upper.frame_b, a.frame_b);"
    )
    flat, _ = flat_of(text)
    frames = {item.name: item for item in flat.named if isinstance(item, Frame)}
    known = {"world"}
    for item in flat.named:
        if isinstance(item, Frame):
            assert item.parent in known
            known.add(item.name)
    assert frames["a.frame_a"].parent == "a.frame_b"
    assert "a.frame_b" in frames
    assert names(flat) == ["a.q", "b.q"]


def test_ports_that_nothing_needs_have_no_place():
    flat, codes = flat_of(
        """model M
  import Lag.Planar.*;
  Body ball(m = 1 kg, com = {1 m, 0});
  Revolute pin;
  gravity = -g_n*world.y;
  connect(world, pin);
  connect(pin.frame_b, ball);
end M;
"""
    )
    assert codes == []
    assert names(flat) == ["pin.q"]


def test_composites_arrays_loops_and_conditions():
    flat, codes = flat_of(
        """model Arm
  import Lag.Planar.*;
  frame frame_a, frame_b;
  Revolute pin(q(start = 10 deg));
  Link rod(l = 1 m, m = 1 kg);
  connect(frame_a, pin, rod, frame_b);
end Arm;
model Chain
  structural parameter Integer N = 3;
  structural parameter Boolean loaded = false;
  Arm arm[N];
  Lag.Planar.Body load(m = 5 kg) if loaded;
  gravity = -g_n*world.y;
  connect(world, arm[1]);
  for i in 2:N loop
    connect(arm[i-1], arm[i]);
  end for;
  connect(arm[N].frame_b, load);
end Chain;
"""
    )
    assert codes == []
    assert names(flat) == ["arm[1].pin.q", "arm[2].pin.q", "arm[3].pin.q"]
    assert len(flat.bodies) == 3


def test_two_places_of_one_frame_are_tied_by_six_rows():
    flat, _ = flat_of(
        """model M
  coordinate Angle a, b;
  frame F = world.rotz(a);
  frame G = world.rotz(b);
  gravity = -g_n*world.y;
  body one(m = 1 kg, Izz = 1 kg.m2) on F;
  body two(m = 1 kg, Izz = 1 kg.m2) on G;
  connect(F, G);
end M;
"""
    )
    assert [constraint.name for constraint in flat.constraints] == ["closure(G)", "closure(G)"]
    assert flat.constraints[0].closure is not None
    assert flat.constraints[0].closure.joint is None


# ---- coordinates and nodes -------------------------------------------------------------------------------------------


def test_merged_coordinates_take_the_stronger_start():
    flat, codes = flat_of(
        """model M
  coordinate Angle a[2], b[2](start = {0.1, 0.2}), c(start = 0.2, fixed = true);
  kinetic 1/2*(1 kg.m2)*(der(a[1])^2 + der(a[2])^2 + der(b[2])^2 + der(c)^2);
  output Angle last = c;
  connect(a, b);
  connect(a[2], c);
end M;
"""
    )
    assert names(flat) == ["a[1]", "a[2]"]
    assert [coordinate.fixed for coordinate in flat.coordinates] == [False, True]
    assert "Angle last [rad, shown in deg] = a[2]" in flat_text(flat)
    assert codes == []


def test_kirchhoff_sums_the_flows_of_a_node():
    flat, _ = flat_of(
        """model M
  import Lag.Electrical.*;
  VoltageSource V(v = 10 V);
  Resistor R(R = 2 Ohm);
  Inductor L(L = 1 H);
  Ground g;
  connect(V.p, R.p);
  connect(R.n, L.p);
  connect(L.n, V.n, g.p);
  output Voltage v = R.p.v - R.n.v;
end M;
"""
    )
    assert [(constraint.name, constraint.level, constraint.node) for constraint in flat.constraints] == [
        ("node(V.p)", "velocity", True),
        ("node(V.n)", "velocity", True),
        ("node(R.n)", "velocity", True),
    ]
    assert "v [V] = multiplier(node(V.p)) - multiplier(node(R.n))" in flat_text(flat)


def test_conditions_choose_kinematics_and_connections():
    text = """joint Slide
  structural parameter Boolean turned = true;
  frame frame_a, frame_b;
  coordinate Length s;
kinematics
  frame_b = if turned then frame_a.rotz(90 deg).move({s, 0}) else frame_a.move({s, 0});
end Slide;
model M
  import Lag.Planar.*;
  structural parameter Boolean hung = true;
  Slide a, b(turned = false);
  Body ball(m = 1 kg), other(m = 1 kg);
  gravity = -g_n*world.y;
  connect(world, a, ball);
  connect(world, b, other) if hung;
  connect(a.frame_b, b, other) if not hung;
end M;
"""
    flat, codes = flat_of(text)
    assert codes == []
    frames = {item.name: item for item in flat.named if isinstance(item, Frame)}
    assert [len(frames[f"{name}.frame_b"].steps) for name in "ab"] == [2, 1]
    assert frames["b.frame_a"].parent == "world"
    assert {item.name: item for item in flat_of(text.replace("hung = true", "hung = false"))[0].named}[
        "b.frame_a"
    ].parent == "a.frame_b"


def test_a_coordinate_with_a_momentum_is_an_unknown():
    flat, _ = four_bar("Revolute A, B, C, D;", "output AngularMomentum p = momentum(D.q);")
    assert "D.q" in names(flat)


def chain(count: int) -> str:
    """Four-bars, each on the rocker of the one before."""
    parts = []
    for k in range(count):
        ground = f"rocker{k - 1}.frame_b" if k else "world"
        parts.append(
            f"Link crank{k}(l = 0.4, m = 1), coupler{k}(l = 1, m = 2), rocker{k}(l = 0.8, m = 1.5);\n"
            f"Revolute A{k}(q(start = 60 deg)), B{k}, C{k}, D{k};\nFixedTranslation base{k}(r = {{1, 0}});\n"
            f"connect({ground}, A{k}, crank{k}, B{k}, coupler{k}, C{k}, rocker{k});\n"
            f"connect({ground}, base{k}); connect(base{k}.frame_b, D{k}); connect(D{k}.frame_b, rocker{k}.frame_b);\n"
        )
    return f"model Chain\nimport Lag.Planar.*;\ngravity = -g_n*world.y;\n{''.join(parts)}end Chain;\n"


def test_a_hundred_four_bars_in_a_chain():
    start = process_time()
    flat, _ = flat_of(chain(100))
    assert process_time() - start < 5
    assert len(flat.coordinates) == 300
    loops = [constraint.closure.loop for constraint in flat.constraints if constraint.closure is not None]
    assert loops[-1] == ("base99", "D99", "rocker99", "C99", "coupler99", "B99", "crank99", "A99")


def test_closures_depend_on_their_own_loop_only():
    flat, _ = flat_of(chain(4))
    dependence = Dependence(flat)
    for constraint in flat.constraints:
        assert constraint.closure is not None
        assert constraint.closure.joint is not None
        k = constraint.closure.joint[1:]
        found = {name for residual in constraint.residuals for name in dependence.of(residual) if name.endswith(".q")}
        assert found <= {f"{joint}{k}.q" for joint in "ABCD"}
    for output in flat.outputs:
        found = {name for name in dependence.of(output.value) if name.endswith(".q")}
        assert found <= {f"{joint}{output.name[1:-2]}.q" for joint in "ABCD"}
