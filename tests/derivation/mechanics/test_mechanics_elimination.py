"""Accelerations by elimination: those of the dense system for any Lagrangian, at a cost that grows with the links."""

import pytest
from choice import chosen
from elimination_models import PLANAR, SCALARS, SPATIAL, eliminated, flat_model, largest_residual
from mechanics_models import body, constraint, definition, energy, expression, frame, mass, model, point, triple

from lagdsl.algebra.graph.evaluate import evaluate
from lagdsl.algebra.graph.operation import Group
from lagdsl.language.flat.model import FlatModel, Move, Place, Rotate, RotateAbout


@pytest.mark.no_cover
@pytest.mark.parametrize(("text", "per_link"), [(PLANAR, 75), (SPATIAL, 400), (SCALARS, 90)])
def test_cost_per_link_is_bounded(text: str, per_link: int) -> None:
    costs = {n: eliminated(flat_model(text.format(n=n)))[1].flops for n in (20, 40, 60)}
    assert costs[60] < 60 * per_link
    assert costs[60] - costs[40] == costs[40] - costs[20]


@pytest.mark.parametrize("text", [PLANAR, SPATIAL, SCALARS])
@pytest.mark.parametrize("n", chosen([1, 2, 3, 7, 20], [1, 2, 7]))
def test_accelerations_solve_the_dense_system(text: str, n: int) -> None:
    assert largest_residual(flat_model(text.format(n=n)), states=5) < 1e-13


INERTIA = (0.1, 0.2, 0.15, 0.01, 0.02, 0.03)
GENERAL = {
    "relativistic particle with a magnetic term": model(
        coordinates=("r", "phi"),
        energies=(
            energy(
                "lagrangian",
                "-4*sqrt(1 - (der(r)^2 + (r*der(phi))^2)/100) + 0.7*r^2*der(phi) + cos(phi)/(2 + r^2)",
            ),
        ),
    ),
    "inertia that depends on the position, quartic terms": model(
        coordinates=("a", "b"),
        named=(definition("s", "sin(a) + 2*b"), definition("v", "a*b")),
        energies=(
            energy("kinetic", "0.5*(2 + cos(a)^2)*der(s)^2 + 0.5*(3 + b^2)*der(v)^2 + 0.25*der(s)^4 + der(a)^2"),
            energy("potential", "s*v"),
            energy("dissipation", "0.1*der(v)^2"),
        ),
    ),
    "a moving base and a slide": model(
        coordinates=("x", "phi"),
        named=(
            frame(
                "A",
                "world",
                Rotate(2, expression("0.3*sin(2*time)")),
                Move(triple(("x", 0.2, 0.1))),
            ),
            frame("B", "A", Rotate(1, expression("phi")), Move(triple((0.1, "x", 0.3)))),
        ),
        gravity="v(0, -9.81, 0)",
        bodies=(body("A", 2, (0.1, 0, 0.2), INERTIA), body("B", 1, (0, 0, 0), INERTIA)),
        masses=(mass(0.5, "B.origin + 0.2*B.x"),),
    ),
    "skew axes": model(
        coordinates=("a", "b"),
        named=(
            frame("A", "world", RotateAbout(triple((1, 2, 2)), expression("a"))),
            frame("B", "A", Move(triple((1, 0, 0))), RotateAbout(triple((0.3, -1, 0.5)), expression("b"))),
        ),
        gravity="v(0, -9.81, 0)",
        bodies=(body("A", 1, (0, 0, 0), INERTIA), body("B", 1, (0.3, 0.1, 0), INERTIA)),
    ),
    "beads on a turning arm": model(
        coordinates=("a", "b", "s"),
        named=(
            frame(
                "A",
                "world",
                Rotate(2, expression("0.3*sin(2*time) + b")),
                Move(triple((0.1, 0.2, 0))),
                Rotate(1, expression("a")),
            ),
            point("P", "A.origin + s*A.x"),
        ),
        gravity="v(0.5, 0, -9.81)",
        masses=(mass(0.5, "p(P) + 0.3*A.z"), mass(0.7, "A.origin + 0.2*A.y"), mass(0.3, "p(P) + v(0, s, 0)")),
    ),
    "a mass on a rod about the origin of the world": model(
        coordinates=("a", "b", "s"),
        named=(
            frame("A", "world", Rotate(2, expression("a")), Rotate(1, expression("b"))),
            frame("B", "A", Move(triple((0, 0.2, 0)))),
        ),
        gravity="v(0.5, 0, -9.81)",
        masses=(mass(0.5, "-0.7*A.z"), mass(0.2, "s*B.x + 0.1*A.y"), mass(0.3, "0.1*A.x + B.origin")),
    ),
    "frames put at places of others": model(
        coordinates=("a", "b", "c"),
        named=(
            frame("A", "world", Rotate(1, expression("a"))),
            frame("B", "world", Place(expression("A.origin + A.x")), Rotate(1, expression("b"))),
            frame("C", "B", Move(triple((0, 0, 0.4))), Rotate(1, expression("c"))),
            frame(
                "D",
                "world",
                Place(expression("C.origin + 0.3*C.z")),
                Rotate(2, expression("a")),
                Rotate(0, expression("c")),
            ),
        ),
        gravity="v(0, 0, -9.81)",
        bodies=tuple(body(name, 1 + k, (0.3, 0.1, 0.2), INERTIA) for k, name in enumerate("ABCD")),
        masses=(mass(0.5, "C.origin + 0.2*C.x"), mass(0.2, "D.origin + 0.2*D.x + b*D.y")),
    ),
    "a closed loop": model(
        coordinates=("a", "b", "c"),
        named=(point("P", "v(cos(a), sin(a), 0)"), point("Q", "p(P) + 2*v(cos(b), sin(b), 0)")),
        masses=(mass(1, "p(P)"), mass(2, "p(Q)")),
        energies=(energy("kinetic", "0.5*der(c)^2"),),
        constraints=(constraint("x", "cos(a) + 2*cos(b) - 2 - cos(c)"), constraint("y", "sin(a) + 2*sin(b) - sin(c)")),
    ),
}


@pytest.mark.parametrize("name", GENERAL)
def test_any_lagrangian(name: str) -> None:
    assert largest_residual(GENERAL[name]) < 1e-12


@pytest.mark.parametrize(("axis", "sign"), [((0, 0, 3), ""), ((0, 0, -2), "-")])
def test_turning_about_a_vector_along_an_own_axis_is_turning_about_that_axis(
    axis: tuple[int, int, int], sign: str
) -> None:
    def pendulum(step: Rotate | RotateAbout) -> FlatModel:
        frames = (frame("A", "world", Rotate(0, expression("a"))), frame("B", "A", Move(triple((1, 0.2, 0))), step))
        bodies = (body("A", 1, (0, 0, 0), INERTIA), body("B", 1, (0.3, 0.1, 0), INERTIA))
        return model(coordinates=("a", "b"), named=frames, gravity="v(0, -9.81, 0)", bodies=bodies)

    by_vector = pendulum(RotateAbout(triple(axis), expression("b")))
    assert largest_residual(by_vector) < 1e-13
    by_axis = pendulum(Rotate(2, expression(f"{sign}b")))
    assert eliminated(by_vector)[1].flops == eliminated(by_axis)[1].flops


POINTS = """model Chain
  coordinate Angle a[N], b[N];
  structural parameter Integer N = 6;
  frame F[N];
  gravity = -g_n*world.z;
  for i in 1:N loop
    frame F[i] = (if i == 1 then world else F[i-1].move({0 m, 0 m, -1 m})).rotx(a[i]).roty(b[i]);
    ELEMENT;
  end for;
end Chain;
"""


def test_masses_at_places_of_frames_cost_what_bodies_cost() -> None:
    masses = flat_model(POINTS.replace("ELEMENT", "mass (1 kg) at F[i].point({0 m, 0 m, -1 m})"))
    bodies = flat_model(POINTS.replace("ELEMENT", "body (m = 1 kg, com = {0 m, 0 m, -1 m}) on F[i]"))
    assert largest_residual(masses) < 1e-13
    assert eliminated(masses)[1].flops == eliminated(bodies)[1].flops


def test_pivot_tells_where_the_mass_matrix_is_singular() -> None:
    """Masses on one line at x, x + y and x + 2 y: y has no inertia beside that of x where the last one is -1/5."""
    flat = model(
        parameters={"s": 1.0},
        coordinates=("x", "y"),
        masses=(mass(1, "v(x, 0, 0)"), mass(1, "v(x + y, 0, 0)"), mass("s", "v(x + 2*y, 0, 0)")),
    )
    derivation, solution = eliminated(flat)
    (regular,) = evaluate(derivation.graph, [solution.factor.pivot], {Group.P: [1.0]})
    (singular,) = evaluate(derivation.graph, [solution.factor.pivot], {Group.P: [-0.2]})
    assert regular > 0.1
    assert abs(singular) < 1e-15
