"""Shapes that follow from declarations."""

from __future__ import annotations

from collections import Counter
from typing import Any

import numpy as np
import pytest
from named_models import compiled

from lagdsl.derivation.scene import machine as rules
from lagdsl.derivation.scene.living import living, scene_of
from lagdsl.derivation.scene.shapes import Scene, Shape
from lagdsl.language.flat.evaluate import Evaluator, Values


def scene(body: str) -> Scene:
    return scene_of(compiled(f"model M\n{body}\nend M;\n").flat)


def kinds(found: Scene) -> Counter[str]:
    return Counter(shape.kind for shape in found.shapes if shape.kind != "frame")


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
    values = np.array([at.scalar(column) for column in found.columns])
    normal = values[dict(ground.numbers)["normal"] :][:3]
    foot = values[dict(ground.numbers)["at"] :][:3]
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
    """Only angles have a dial: as an angle, a charge of a millicoulomb moved no hand."""
    found = scene(
        "coordinate Angle a; coordinate Length s; coordinate Charge q; gravity = 0;"
        "kinetic (1 kg.m2)/2*der(a)^2 + (1 kg)/2*der(s)^2 + (1 H)/2*der(q)^2;"
    )
    assert kinds(found) == {"dial": 1, "slider": 2}


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
    assert dict(arm.numbers)["to"] == dict(ball.numbers)["at"]


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
    evaluator = rules.evaluator_at

    def counted(*arguments: Any, **options: Any) -> Evaluator:
        asked.append(1)
        return evaluator(*arguments, **options)

    monkeypatch.setattr(rules, "evaluator_at", counted)
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
