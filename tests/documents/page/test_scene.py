"""Shapes that follow from declarations."""

from __future__ import annotations

from collections import Counter
from typing import Any

import numpy as np
import pytest
from matplotlib.path import Path
from named_models import compiled

from lagdsl.derivation.scene import machine as rules
from lagdsl.derivation.scene.forms import form
from lagdsl.derivation.scene.living import living, scene_of
from lagdsl.derivation.scene.posed import Posed
from lagdsl.derivation.scene.shapes import Scene, Shape
from lagdsl.derivation.scene.stage import stage_of
from lagdsl.language.flat.evaluate import Evaluator, Values


def scene(body: str) -> Scene:
    return scene_of(compiled(f"model M\n{body}\nend M;\n").flat)


def kinds(found: Scene) -> Counter[str]:
    return Counter(shape.kind for shape in found.shapes if shape.kind not in ("frame", "support"))


def shape(found: Scene, kind: str) -> Shape:
    (one,) = [each for each in found.shapes if each.kind == kind]
    return one


PENDULUM = "coordinate Angle q; gravity = -g_n*world.y; point P = 2*{sin(q), -cos(q)}*1 m; mass 1 kg at P;"


def test_a_mass_at_a_constant_distance_hangs_on_a_rod() -> None:
    assert kinds(scene(PENDULUM)) == {"mass": 1, "rod": 1}


def test_a_mass_that_slides_is_a_cart_on_its_rail() -> None:
    """Carts on one line have one rail; a mass that falls, or that a contact stops, is a ball."""
    slides = "coordinate Length x, y(start = 1 m); gravity = -g_n*world.y;"
    found = scene(slides + "mass 1 kg at {x, 0}; mass 1 kg at {y, 0};")
    assert kinds(found) == {"mass": 2, "rail": 1}
    assert {part.form for each in found.shapes if each.kind == "mass" for part in each.parts} == {"cart", "cart wheels"}
    assert kinds(scene(slides + "mass 1 kg at {0, y}; mass 1 kg at {1 m, x};")) == {"mass": 2}
    stopped = "mass 1 kg at {x, 0}; mass 1 kg at {0, y}; contact c: x >= 0 with restitution = 1;"
    assert "rail" not in kinds(scene(slides + stopped))


def test_rods_go_down_to_the_world() -> None:
    found = scene(PENDULUM + "coordinate Angle r; point R = P + 1 m*{sin(r), -cos(r)}; mass 1 kg at R;")
    assert kinds(found) == {"mass": 2, "rod": 2}


def test_a_circle_holds_its_bead_without_a_rod() -> None:
    """Of one coordinate or of two with a constraint, by squares or by a norm; other circles hold nothing."""
    for own in (
        PENDULUM,
        "coordinate Length x, y(start = -2 m); mass 1 kg at {x, y}; constraint wire: x^2 + y^2 = (2 m)^2;",
        "coordinate Length x, y(start = -2 m); mass 1 kg at {x, y}; constraint wire: norm({x, y, 0}) = 2 m;",
    ):
        assert kinds(scene(own + "draw circle(radius = 2 m) at world.origin;")) == {"mass": 1, "circle": 1}
        for other in ("circle(radius = 1 m) at world.origin", "circle(radius = 2 m) at {1 m, 0}"):
            found = kinds(scene(f"{own} draw {other};"))
            assert found["rod"] + found["rope"] == 1


def test_what_is_drawn_takes_the_place_of_what_follows() -> None:
    assert kinds(scene(PENDULUM + "draw sphere(radius = 10 cm) at P;")) == {"sphere": 1, "rod": 1}
    assert kinds(scene(PENDULUM + "draw rod from world.origin to P;")) == {"mass": 1, "rod": 1}
    assert kinds(scene(PENDULUM + "draw trace at P;")) == {"mass": 1, "rod": 1, "trace": 1}


def test_springs_dampers_and_ropes_follow_from_distances() -> None:
    two = "coordinate Length x(start = 1 m), y; point A = {x, 0}; point B = {0, y + 2 m}; gravity = 0;"
    two += "mass 1 kg at A; mass 1 kg at B;"
    spring = "potential 1/2*(10 N/m)*(norm(B - A) - 1 m)^2;"
    damper = "dissipation 1/2*(1 N.s/m)*der(norm(B - A))^2;"
    assert kinds(scene(two + spring + damper)) == {"mass": 2, "spring": 1, "damper": 1, "rail": 2}
    named = "Length s = norm(B - A); potential 1/2*(10 N/m)*s^2;"
    assert kinds(scene(two + named))["spring"] == 1
    assert kinds(scene(two + "constraint rope: norm(B - A) = sqrt(5)*1 m;"))["rope"] == 1


def test_a_contact_has_its_ground() -> None:
    ball = "parameter Angle a = 30 deg; coordinate Length x, h(start = 1 m); gravity = -g_n*world.y;"
    ball += "point P = {x*cos(a) - h*sin(a), x*sin(a) + h*cos(a)}; mass 1 kg at P;"
    ball += "contact floor: h >= 0 with restitution = 0.5;"
    flat = compiled(f"model M\n{ball}\nend M;\n").flat
    found = scene_of(flat)
    ground = shape(found, "ground")
    at = Evaluator(flat, Values(variables={"x": 3.0, "h": 0.7}))
    normal, foot = at.vector(ground.parts[0].numbers["z"]), at.vector(ground.numbers["at"])
    up = np.array([-np.sin(np.pi / 6), np.cos(np.pi / 6), 0.0])
    assert np.abs(normal - up).max() < 1e-12
    assert abs(foot @ up) < 1e-12


def test_a_gap_that_is_no_plane_has_no_ground() -> None:
    bodies = "coordinate Length x(start = 2 m), y; gravity = 0; mass 1 kg at {x, y};"
    assert "ground" not in kinds(scene(bodies + "contact post: sqrt(x^2 + y^2) - 1 m >= 0 with restitution = 0.5;"))


def test_loads_stand_at_their_points() -> None:
    found = scene(PENDULUM + "force {1 N, 0} at P;" + "frame f = world.rotz(q); torque (1 N.m)*f.z on f;")
    assert kinds(found)["force"] == 1
    assert kinds(found)["torque"] == 1


def test_coordinates_without_a_place_have_gauges() -> None:
    """Only angles have a dial; charges flow in a diagram."""
    found = scene(
        "coordinate Angle a; coordinate Length s; coordinate Charge q; gravity = 0;"
        "kinetic (1 kg.m2)/2*der(a)^2 + (1 kg)/2*der(s)^2 + (1 H)/2*der(q)^2;"
    )
    assert kinds(found) == {"dial": 1, "slider": 1, "branch": 1}


def test_bodies_are_shown_by_their_inertia() -> None:
    found = scene(
        "coordinate Angle q; frame f = world.rotz(q); gravity = 0; body b(m = 2 kg, I = {1, 2, 3}*1 kg.m2) on f;"
    )
    assert kinds(found) == {"body": 1}
    [part] = shape(found, "body").parts
    assert part.form == "cube" and part.opacity < 1.0


def test_the_body_of_a_component_is_seen_by_its_inertia_and_a_point_by_a_ball_on_an_arm() -> None:
    found = scene(
        "import Lag.Spatial.*; Revolute joint; Body wheel(m = 2 kg, I = {1, 1, 2}), weight(m = 1 kg, com = {0, 0, 1});"
        "gravity = 0; connect(world, joint, wheel); connect(joint.frame_b, weight);"
    )
    assert kinds(found)["body"] == kinds(found)["sphere"] == kinds(found)["rope"] == 1
    arm, ball = shape(found, "rope"), shape(found, "sphere")
    assert arm.numbers["to"] is ball.numbers["at"]


def test_bodies_of_an_array_have_arms_of_their_own() -> None:
    found = scene(
        "import Lag.Spatial.*; Revolute joint[2]; Body weight[2](each m = 1 kg, each com = {1, 0, 0}); gravity = 0;"
        "for i in 1:2 loop connect(world, joint[i], weight[i]); end for;"
    )
    arms = [each.numbers for each in found.shapes if each.kind == "rope"]
    assert len(arms) == len({each["at"] for each in arms}) == len({each["to"] for each in arms}) == 2


@pytest.mark.parametrize(
    ("body", "planar"),
    [
        (PENDULUM, True),
        ("coordinate Length z; mass 1 kg at {0, 0, z}; gravity = 0;", False),
        ("coordinate Angle q; frame f = world.rotx(q); gravity = 0; body b(m = 1, I = {1, 1, 1}) on f;", False),
        ("coordinate Angle q; frame f = world.rotz(q); gravity = 0; body b(m = 1, I = {1, 1, 1}) on f;", True),
    ],
)
def test_planar_machines_are_known(body: str, planar: bool) -> None:
    assert scene(body).planar == planar


def test_start_values_are_parameters_unless_they_follow_from_some() -> None:
    flat = compiled("""model M
  parameter Length l = 2 m;
  coordinate Length x(start = 3 m), y(start = 2*l);
  mass 1 kg at {x, y}; gravity = 0;
end M;
""").flat
    own = {p.name: p.value for p in living(flat).flat.parameters}
    assert own == {"l": 2.0, "x.start": 3.0, "der(x).start": 0.0, "der(y).start": 0.0}
    chosen = {p.name: p.value for p in living(flat, ["y"]).flat.parameters}
    assert chosen["y.start"] == 4.0


def test_frames_that_are_built_elsewhere_hang_on_arms() -> None:
    arm = "coordinate Angle a, b; frame f = world.rotz(a); frame g = f.move({1 m, 0, 0}).rotz(b); gravity = 0;"
    arm += "body c(m = 1 kg, I = {1, 1, 1}*1 kg.m2) on f; body d(m = 1 kg, I = {1, 1, 1}*1 kg.m2) on g;"
    assert kinds(scene(arm)) == {"body": 2, "rope": 1}
    assert kinds(scene(arm + "draw rod from f.origin to g.origin;")) == {"body": 2, "rod": 1}
    drawn = {"body": 2, "rope": 1, "box": 1}
    assert kinds(scene(arm + "draw box(size = 1 cm) on f.move({0, 2 m, 0});")) == drawn
    placed = arm.replace("f.move({1 m, 0, 0})", "f.at((1 m)*f.x)")
    assert kinds(scene(placed)) == {"body": 2, "rope": 1}
    rolls = "coordinate Length x(start = 1 m); coordinate Angle a; frame f = world.rotz(a); gravity = 0;"
    rolls += "frame g = f.at({x, 1 m, 0}).rotx(a); body c(m = 1 kg, I = {1, 1, 1}*1 kg.m2) on g;"
    assert kinds(scene(rolls)) == {"body": 1}
    free = "coordinate Length x(start = 1 m); frame f = world.move({x, 0, 0}); gravity = 0;"
    assert kinds(scene(free + "body c(m = 1 kg, I = {1, 1, 1}*1 kg.m2) on f;")) == {"body": 1}


def test_contacts_look_at_their_own_coordinates_only(monkeypatch: pytest.MonkeyPatch) -> None:
    """A row of balls over the floor: each of its contacts asks for as many positions as that of one ball; the floor is
    drawn once."""
    asked: list[int] = []
    evaluator = rules.Machine.at

    def counted(*arguments: Any, **options: Any) -> Evaluator:
        asked.append(1)
        return evaluator(*arguments, **options)

    monkeypatch.setattr(rules.Machine, "at", counted)
    counts = []
    for n in (2, 12):
        ball = "coordinate Length x{k}, h{k}(start = 1 m); mass 1 kg at {{x{k}, h{k}}};"
        ball += "contact floor{k}: h{k} >= 0 with restitution = 0.5;"
        asked.clear()
        found = scene("gravity = -g_n*world.y;" + "".join(ball.format(k=k) for k in range(n)))
        assert kinds(found)["ground"] == 1
        counts.append(len(asked))
    few, many = counts
    assert many <= 6 * few


def posed(body: str, **places: float) -> list[Posed]:
    """The parts of a model where its coordinates have these values."""
    flat = compiled(f"model M\n{body}\nend M;\n").flat
    found = scene_of(flat)
    at = Evaluator(flat, Values(variables=places))
    row = np.array([[at.scalar(column) for column in found.columns]])
    stage = stage_of(found, row, (0.0, 1.0, 0.0))
    return [Posed(stage, part, 0) for each in found.shapes for part in each.parts if each.kind != "frame"]


def test_springs_stay_within_their_ends() -> None:
    """At ten lengths: from the point A to the mass P, with a hatched wall at A."""
    spring = "coordinate Length x(start = 1.2 m); point A = {0, 0}; point P = {x, 0}; mass 1 kg at P; gravity = 0;"
    spring += "potential 1/2*(20 N/m)*(norm(P - A) - 1 m)^2;"
    for x in np.linspace(0.1, 3.0, 10):
        [coil] = [each for each in posed(spring, x=float(x)) if each.part.form == "coil"]
        along = coil.line()[:, 0]
        assert along.min() == pytest.approx(0.0, abs=1e-12) and along.max() == pytest.approx(x)
        assert np.ptp(coil.line()[:, 1]) == pytest.approx(2.0 * coil.size(coil.part.sizes[0]), rel=0.1)
    assert "plane wall" in {each.part.form for each in posed(spring, x=1.0)}


@pytest.mark.parametrize(
    ("energy", "ends"),
    [
        ("potential 1/2*k*x^2;", {(-3.0, 0.2)}),  # a wall on the side without masses, as far away as the next mass
        ("potential 1/2*k*(x - 0.5 m)^2;", {(0.0, 0.2)}),
        ("potential 1/2*k*(y - x)^2;", {(0.2, 3.1)}),
        ("potential 1/2*k*(x^2 + (y - x)^2);", {(-3.0, 0.2), (0.2, 3.1)}),
        ("dissipation 1/2*c*(der(y) - der(x))^2;", {(0.2, 3.1)}),
        ("potential k*(1 m)*x;", set()),  # a force
        ("potential -k*(1 m3)/x;", set()),  # an attraction: it has no stiffness
    ],
)
def test_springs_follow_from_coordinates(energy: str, ends: set[tuple[float, float]]) -> None:
    body = "parameter Stiffness k = 5 N/m; parameter Damping c = 1 N.s/m; coordinate Length x, y; gravity = 0;"
    body += "mass 1 kg at {x, 0}; mass 1 kg at {3 m + y, 0};" + energy
    links = [each for each in posed(body, x=0.2, y=0.1) if each.part.form in ("coil", "piston")]
    assert {(round(each.vector("at")[0], 9), round(each.vector("to")[0], 9)) for each in links} == ends


def test_a_bar_is_as_long_as_its_inertia_and_mass_centre_say() -> None:
    """I = m l^2/12 at l/2 from its pivot: from the pivot to l, whatever else the picture holds."""
    pole = "parameter Length l = 1 m; coordinate Length x; coordinate Angle q; frame F = world.at({x, 0}).rotz(q);"
    pole += "body pole(m = 1 kg, com = {0, -l/2, 0}, Izz = (1 kg)*l^2/12) on F; mass 1 kg at {x, 0};"
    [bar] = [each for each in posed(pole + "gravity = -g_n*world.y;", x=2.0, q=0.0) if each.part.form == "beam"]
    assert np.abs(sorted([bar.vector("at")[1], bar.vector("to")[1]]) - np.array([-1.0, 0.0])).max() < 1e-12


def test_a_ladder_ends_where_it_touches() -> None:
    """Walls follow from constraints, and the points at which the body touches them."""
    ladder = "parameter Length l = 3 m; coordinate Length x, y; coordinate Angle a; gravity = -g_n*world.y;"
    ladder += "frame F = world.at({x, y}).rotz(-a); body beam(m = 1 kg, Izz = (1 kg)*l^2/12) on F;"
    ladder += "constraint wall: x - l/2*cos(a) = 0; constraint ground: y - l/2*sin(a) = 0;"
    parts = posed(ladder, x=1.5 * np.cos(1.0), y=1.5 * np.sin(1.0), a=1.0)
    assert sorted(tuple(each.vector("z").round(9)) for each in parts if each.part.form == "plane ground") == [
        (0.0, 1.0, 0.0),
        (1.0, 0.0, 0.0),
    ]
    [bar] = [each for each in parts if each.part.form == "beam"]
    ends = sorted(tuple(bar.vector(role).round(9)) for role in ("at", "to"))
    assert ends == [(0.0, pytest.approx(3.0 * np.sin(1.0)), 0.0), (pytest.approx(3.0 * np.cos(1.0)), 0.0, 0.0)]


def test_a_wire_is_where_its_constraint_holds() -> None:
    wire = "coordinate Length x(start = 0.2 m), y; gravity = -g_n*world.y; mass 1 kg at {x, y};"
    [track] = [each for each in posed(wire + "constraint w: y = (0.1 m)*cos(x/(1 m));") if each.part.form == "points"]
    x, y, _ = track.line().T
    np.testing.assert_allclose(y, 0.1 * np.cos(x), atol=1e-12)
    assert x.min() < -1.0 and x.max() > 1.0


def test_the_ground_holds_what_turns_about_it() -> None:
    """Above what hangs, below what stands; nothing where a thing stands, and for links that slide or move away."""

    def ups(body: str) -> list[float]:
        walls = [each for each in posed(body) if each.part.form in ("wall", "plane wall")]
        return [float(each.matrix()[1, 2] / np.linalg.norm(each.matrix()[:3, 2])) for each in walls]

    assert ups(PENDULUM) == [-1.0]
    assert ups(PENDULUM.replace("Angle q;", "Angle q(start = 3 rad);")) == [1.0]
    assert ups(PENDULUM + "draw disc(radius = 10 cm) on world.rotz(q);") == []
    moves = "coordinate Length x(start = 1 m), y(start = 1 m); gravity = 0; point P = {x, y}; mass 1 kg at P;"
    assert ups(moves + "draw rod from {x, 0} to P;") == ups(moves + "draw rod from {0, 0} to {x, 0};") == []
    assert ups(moves + "draw rod from {0, 0} to P;") == [1.0]


def branches(body: str) -> dict[str, list[str]]:
    """Symbols by charge."""
    found = scene(body)
    return {
        each.name: [part.form for part in each.parts if part.form not in ("beam", "arrow")]
        for each in found.shapes
        if each.kind == "branch"
    }


def test_a_circuit_has_a_symbol_for_each_term() -> None:
    ring = "coordinate Charge q; input Voltage u; force u on q; kinetic (1 H)/2*der(q)^2; potential q^2/(2 F);"
    found = branches(ring + "dissipation (1 Ohm)/2*der(q)^2;")
    assert found == {"q": ["voltage source", "capacitor", "resistor", "inductor"]}
    parts = "import Lag.Electrical.*; VoltageSource s(v = 1 V); Resistor r(R = 1 Ohm); Inductor l(L = 1 H); Ground e;"
    joined = "connect(s.p, r.p); connect(r.n, l.p); connect(s.n, l.n, e.p);"
    assert branches(parts + joined) == {"s.q": ["voltage source", "earth"], "r.q": ["resistor"], "l.q": ["inductor"]}
    driven = parts.replace("VoltageSource s(v = 1 V)", "CurrentSource s(i = 1 A)")
    assert branches(driven + joined)["s.q"] == ["current source", "earth"]
    assert branches("coordinate Length x; mass 1 kg at {x, 0}; gravity = 0;") == {}


def test_symbols_and_wires_of_a_circuit_meet_and_do_not_lie_on_each_other() -> None:
    """Each end of a symbol is one of a wire or of another symbol; no two symbols have a place in common."""
    found = posed(
        "import Lag.Electrical.*; VoltageSource s(v = 1 V); Resistor a(R = 1 Ohm), b(R = 1 Ohm); Ground e;"
        "Resistor c(R = 1 Ohm), d(R = 1 Ohm); Inductor l(L = 1 H); connect(s.p, a.p, b.p); connect(a.n, c.p, l.p);"
        "connect(b.n, d.p, l.n); connect(s.n, c.n, d.n, e.p);"
    )
    strokes = [each for each in found if "to" in each.part.numbers]
    ends = [{tuple(np.round(each.vector(role), 9)) for role in ("at", "to")} for each in strokes]
    symbols = [k for k, each in enumerate(strokes) if each.part.form not in ("beam", "earth")]
    middles = {tuple(np.round(strokes[k].vector("at") + strokes[k].vector("to"), 9)) for k in symbols}
    assert len(middles) == len(symbols) == 6
    for k in symbols:
        assert all(any(end in other for j, other in enumerate(ends) if j != k) for end in ends[k])


def test_the_current_turns_the_arrow_of_its_branch() -> None:
    body = "coordinate Charge q; kinetic (1 H)/2*der(q)^2; potential q^2/(2 F);"
    found = scene(body)
    vector = shape(found, "branch").numbers["vector"]
    flat = compiled(f"model M\n{body}\nend M;\n").flat
    currents = []
    for rate in (2.0, -1.0):
        at = Evaluator(flat, Values(rates={"q": rate}))
        currents.append(at.vector(vector))
    np.testing.assert_allclose(currents[0], -2.0 * currents[1], atol=1e-12)
    assert np.linalg.norm(currents[1]) == pytest.approx(1.0)


def test_a_gear_has_its_teeth_and_gears_in_mesh_do_not_overlap() -> None:
    """24 teeth on 48 in any position, and inside of a ring of 72: no corner of one lies inside of the other."""

    def outside(pinion: np.ndarray, wheel: np.ndarray) -> bool:
        return not any(Path(wheel).contains_points(pinion))

    def rim(teeth: int, turn: float, x: float) -> np.ndarray:
        faces = form(f"gear of {teeth}")
        radius = abs(teeth) / 24.0
        edge = faces[np.ptp(faces[..., 2], axis=1) > 0.5][:, 0, :2]
        assert len(edge) == 4 * abs(teeth) * (1 if teeth > 0 else 2)
        c, s = np.cos(turn), np.sin(turn)
        return np.asarray(radius * edge @ np.array([[c, s], [-s, c]]) + np.array([x, 0.0]))

    for turn in np.linspace(0.0, 0.3, 7):
        wheel = rim(48, np.pi / 48 - turn / 2.0, 3.0)
        assert outside(rim(24, turn, 0.0), wheel)
    inner = np.linalg.norm(rim(-72, 0.0, 0.0), axis=1)
    assert inner.min() == pytest.approx(3.0 - 1.0 / 12.0)


def test_a_load_on_a_coordinate_acts_at_the_thing_that_it_moves() -> None:
    """A force along the way of a mass; a torque about the axis of a body, as a turning arrow."""
    body = "coordinate Length x; coordinate Angle q; gravity = 0; mass 1 kg at {2*x, 0}; force 3 N on x;"
    body += "frame f = world.rotx(q); body b(m = 1 kg, I = {1, 1, 1}*1 kg.m2) on f; torque 2 N.m on q;"
    found = {each.part.primitive + each.part.form: each for each in posed(body, x=1.0, q=0.3)}
    np.testing.assert_allclose(found["surfacearrow"].vector("z"), [6.0, 0.0, 0.0])
    np.testing.assert_allclose(found["surfaceturning arrow"].vector("z"), [2.0, 0.0, 0.0], atol=1e-12)


def test_wheels_have_the_radius_behind_their_inertia() -> None:
    """A disc, a hoop and a bar by their formulas; a moment of its own is that of a disc."""
    body = "coordinate Angle q; parameter Length r = 0.4 m; parameter Mass m = 2 kg; parameter Inertia J = 0.25 kg.m2;"
    body += "frame f = world.rotz(q); gravity = 0; body b(m = m, Izz = {}) on f;"
    for inertia, radius in (("m*r^2/2", 0.4), ("m*r^2", 0.4), ("J", 0.5)):
        [tire] = [each for each in posed(body.format(inertia)) if each.part.form == "tire"]
        assert tire.size(tire.part.sizes[0]) == pytest.approx(radius)
    assert "tire" not in {each.part.form for each in posed(body.format("m*r^2/12"))}
