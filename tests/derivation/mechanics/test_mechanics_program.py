"""The program as a whole: layout, monitor, starts, refusals, and how it grows."""

import time

import numpy as np
import pytest
from derived_programs import derive
from mechanics_models import (
    SPANS,
    accelerations,
    body,
    constraint,
    coordinate,
    definition,
    drive,
    energy,
    force,
    frame,
    mass,
    model,
    output,
    point,
    run,
    state,
    torque,
    triple,
)

from lagdsl.algebra.graph import Graph, Group, Op
from lagdsl.algebra.graph.evaluate import evaluate
from lagdsl.derivation.mechanics.monitor import largest_term
from lagdsl.derivation.program.functions import SIGNATURES
from lagdsl.derivation.program.program import Program
from lagdsl.foundation.diagnostics import CompilationFailed
from lagdsl.foundation.units.dimension import DIMENSIONLESS
from lagdsl.language.flat.expression import Binary, Number, Variable
from lagdsl.language.flat.model import FlatModel, Move, Parameter, Rotate, SetAxes


def chain(n: int) -> FlatModel:
    points = [point("P1", "l*v(sin(q1), -cos(q1), 0)")]
    points += [point(f"P{i}", f"p(P{i - 1}) + l*v(sin(q{i}), -cos(q{i}), 0)") for i in range(2, n + 1)]
    return model(
        parameters={"l": 0.1, "m": 0.05, "g": 9.81},
        coordinates=tuple(f"q{i}" for i in range(1, n + 1)),
        named=tuple(points),
        gravity="v(0, -g, 0)",
        masses=tuple(mass("m", f"p(P{i})") for i in range(1, n + 1)),
        energies=(energy("dissipation", "0.5e-4*(" + " + ".join(f"der(q{i})^2" for i in range(1, n + 1)) + ")"),),
    )


def size(program: Program) -> int:
    roots = [node for function in program.functions for block in function.results for node in block.elements]
    return len(program.graph.live(roots))


@pytest.mark.no_cover
def test_chain_grows_slower_than_its_mass_matrix() -> None:
    """64 times the entries of M from 10 to 80 links; size and time stay well below."""
    models = {n: chain(n) for n in (10, 80)}
    programs = {n: derive(flat) for n, flat in models.items()}
    assert size(programs[80]) < 24 * size(programs[10])
    seconds = {}
    for n, flat in models.items():
        best = np.inf
        for _ in range(3):
            start = time.process_time()
            derive(flat)
            best = min(best, time.process_time() - start)
        seconds[n] = best
    assert seconds[80] < 32 * seconds[10]


def test_inverse_dynamics_and_residual_grow_with_the_energies() -> None:
    sizes = {}
    for n in (10, 80):
        program = derive(chain(n))
        for name in ("inverse_dynamics", "residual_tangent"):
            (block,) = program.function(name).results[:1]
            sizes[name, n] = len(program.graph.live(block.elements))
    assert sizes["inverse_dynamics", 80] < 9 * sizes["inverse_dynamics", 10]
    assert sizes["residual_tangent", 80] < 9 * sizes["residual_tangent", 10]


def test_long_chains_meet_no_recursion_limit() -> None:
    """Frames on frames on frames, and a sum nested as deep."""
    n = 1500
    frames = [frame("F0", "world", Rotate(2, Variable("a")))]
    frames += [frame(f"F{i}", f"F{i - 1}", Move(triple((0.001, 0, 0)))) for i in range(1, n)]
    nested = definition("s", "a")
    for _ in range(n):
        nested = definition("s", Binary("+", nested.value, Number(1.0)))
    program = derive(
        model(
            coordinates=("a",),
            named=(*frames, nested),
            bodies=(body(f"F{n - 1}", 1.0, inertia=(0, 0, 1.0, 0, 0, 0)),),
            energies=(energy("potential", "s"),),
        )
    )
    (m,) = run(program, "mass_matrix")
    assert m[0, 0] == pytest.approx(1.0 + ((n - 1) * 0.001) ** 2)


def test_equal_models_give_equal_programs() -> None:
    first, second = derive(chain(5)), derive(chain(5))
    assert first.functions == second.functions
    assert first.layout == second.layout
    assert (first.graph.op, first.graph.a, first.graph.b) == (second.graph.op, second.graph.a, second.graph.b)


def test_planar_code_is_planar() -> None:
    """A planar arm built with three-dimensional frames: nothing out of the plane, one sine and one cosine."""
    program = derive(
        model(
            coordinates=("a", "b"),
            named=(
                frame("A", "world", Rotate(2, Variable("a"))),
                frame("B", "A", Move(triple((1, 0, 0))), Rotate(2, Variable("b"))),
            ),
            bodies=(body("B", 1.0, ("0.5", 0, 0), (1, 1, 1, 0, 0, 0)),),
            outputs={
                "height": "component(B.origin + B.x, 2)",
                "tilt": "component(B.z, 0)",
                "wx": "component(omega(B), 0)",
                "wy": "component(omega(B), 1)",
            },
        )
    )
    graph = program.graph
    assert program.function("output").results[0].elements == (graph.zero,) * 4
    live = graph.live(program.function("dynamics").results[1].elements)
    assert sum(graph.op[node] in (Op.SIN, Op.COS) for node in live) == 2


# ---- what a program holds --------------------------------------------------------------------------------------------


def test_layout_names_everything_and_every_function_is_there() -> None:
    structural = Parameter(spans=SPANS, name="N", dimension=DIMENSIONLESS, value=3.0, structural=True)
    flat = model(
        parameters=(structural, Parameter(spans=(), name="m", dimension=DIMENSIONLESS, value=2.0, unit="kg")),
        coordinates=("x", "y"),
        states=(state("z", "-N*z"),),
        inputs=(("u", None),),
        energies=(energy("kinetic", "1/2*m*(der(x)^2 + der(y)^2)"),),
        constraints=(constraint("c", "x - y", "x + y"), constraint("w", "der(x) - 1", level="velocity")),
        outputs={"speed": "der(x)"},
        invariants={"E": "energy()"},
        assertions=("x < 1",),
    )
    program = derive(flat)
    layout = program.layout
    assert [slot.name for slot in layout.coordinates] == ["x", "y"]
    assert [slot.name for slot in layout.constraints] == ["c[1]", "c[2]", "w"]
    assert layout.position_level == (True, True, False)
    assert layout.redundant == (False, False, False)
    assert [(slot.name, slot.unit, slot.place) for slot in layout.parameters] == [("m", "kg", None)]
    assert layout.defaults == (2.0,)
    assert layout.coordinates[0].place == "model.lag:1"
    assert layout.assertions == ("broken",)
    assert [function.name for function in program.functions] == list(SIGNATURES)
    for function in program.functions:
        roots = [node for block in function.results for node in block.elements]
        groups = {
            program.graph.group(x)
            for x in program.graph.live(roots)
            if program.graph.depends(x, *Group) and not program.graph.arguments(x)
        }
        assert groups <= set(function.arguments), function.name
    (zd,) = run(program, "state_derivative", z=[2.0])
    assert zd[0] == -6.0


def test_scale_of_an_invariant_is_its_largest_term() -> None:
    flat = model(
        parameters={"m": 2.0, "g": 10.0},
        coordinates=("x", "y"),
        masses=(mass("m", "v(x, y, 0)"),),
        gravity="v(0, -g, 0)",
        invariants={"E": "energy()", "d": "-m*(x - y)/g", "p": "x*y", "one": "3"},
        assertions=("x < 1 and not (y > 5)", "x != 3 or y >= 100"),
    )
    invariant, scale, assertion = run(derive(flat), "monitor", q=[3.0, 4.0], qd=[1.0, -2.0])
    np.testing.assert_allclose(invariant, [5.0 + 80.0, 0.2, 12.0, 3.0])
    np.testing.assert_allclose(scale, [80.0, 0.8, 12.0, 3.0])
    np.testing.assert_array_equal(assertion, [0.0, 0.0])


def test_shared_sums_are_measured_once() -> None:
    """Fibonacci's numbers as nested sums: their terms are many, the nodes few."""
    graph = Graph()
    x, y = graph.symbols(Group.Q, 2)
    for _ in range(60):
        x, y = y, graph.add(x, y)
    before = len(graph)
    root = largest_term(graph, y)
    assert len(graph) - before < 130
    assert evaluate(graph, [root], {Group.Q: [-3.0, 2.0]}) == [3.0]
    product = graph.multiply(graph.symbol(Group.P), graph.symbol(Group.P, 1))
    assert evaluate(graph, [largest_term(graph, product)], {Group.P: [-3.0, 2.0]}) == [6.0]
    ratio = graph.divide(graph.symbol(Group.P), graph.symbol(Group.Q))
    assert evaluate(graph, [largest_term(graph, ratio)], {Group.P: [-3.0], Group.Q: [2.0]}) == [1.5]


def test_initial_equations_and_tangents_of_outputs_know_accelerations() -> None:
    flat = model(
        coordinates=("x",),
        masses=(mass(2.0, "v(x, 0, 0)"),),
        outputs={"a": "der(der(x))"},
        initial_equations=("der(der(x)) - 3",),
    )
    program = derive(flat)
    assert run(program, "initial_equation", qdd=[5.0])[0] == [2.0]
    assert run(program, "output_tangent", dqdd=[7.0])[0] == [7.0]
    assert output(flat)[0] == 0.0


def test_vectors_conditionals_and_functions() -> None:
    flat = model(
        coordinates=(coordinate("x", 1.0), "y"),
        masses=(mass(1.0, "v(x, y, 0)"),),
        outputs={
            "choice": "component(v(1, 2, 3) if x > 2 else -v(x, y, 7)/2, 2)",
            "scalar": "(1 if x >= 1 else 2) + (3 if x == 1 else 4)",
            "cross": "norm(cross(v(x, 0, 0), v(0, 2, 0)))",
            "sum": "component(v(1, 2, 3) - v(x, y, 1) + world.z + world.origin, 2)",
            "functions": "min(x, 2) + max(x, 2) + mod(7, 3*x) + atan2(0, x) + floor(1.5*x) + sqrt(4*x) + abs(-x)",
            "still": "omega(world) @ world.x + component(velocity(v(x, y, 0), world), 0)",
        },
    )
    y = output(flat, q=[1.0, 4.0], qd=[3.0, 0.0])
    np.testing.assert_allclose(y, [-3.5, 4.0, 2.0, 3.0, 1 + 2 + 1 + 0 + 1 + 2 + 1, 0.0])


def test_loads_on_the_world_and_reactions_at_the_world_change_nothing() -> None:
    flat = model(
        coordinates=("x",),
        masses=(mass(1.0, "v(x, 0, 0)"),),
        loads=(
            force("v(1, 0, 0)", "v(0, 0, 0)", on="world"),
            torque("v(1, 0, 0)", "world", origin="world"),
            force("v(2, 0, 0)", "v(x, 0, 0)", origin="world.origin", origin_frame="world"),
        ),
    )
    assert accelerations(derive(flat))[0] == [2.0]


def test_momenta_of_all_and_of_one_body() -> None:
    flat = model(
        coordinates=("x", "a"),
        named=(frame("B", "world", Move(triple(("x", 0, 0))), Rotate(2, Variable("a"))),),
        bodies=(body("B", 2.0, inertia=(0, 0, 3.0, 0, 0, 0), label="disc"),),
        masses=(mass(5.0, "v(x, 1, 0)"),),
        outputs={
            "disc": "component(angular_momentum(disc, v(0, -1, 0)), 2)",
            "all": "component(angular_momentum(everything, v(0, -1, 0)), 2)",
            "p": "component(linear_momentum(), 0)",
        },
    )
    y = output(flat, q=[0.5, 0.1], qd=[4.0, 7.0])
    np.testing.assert_allclose(y, [21.0 - 8.0, 21.0 - 8.0 - 40.0, 28.0])


def test_massless_bodies_and_missing_gravity_cost_nothing() -> None:
    program = derive(
        model(
            coordinates=("a",),
            named=(frame("B", "world", Rotate(0, Variable("a"))),),
            bodies=(body("B", 0.0, inertia=(1.0, 0, 0, 0, 0, 0)), body("B")),
        )
    )
    (m,) = run(program, "mass_matrix")
    assert m[0, 0] == 1.0
    assert run(program, "energies")[2] == 0.0


# ---- refusals --------------------------------------------------------------------------------------------------------

FREE = {"coordinates": ("x", "y"), "masses": (mass(1.0, "v(x, y, 0)"),)}


@pytest.mark.parametrize(
    "parts",
    [
        {"loads": (drive("der(der(x))", "x"),)},
        {"loads": (force("v(0, der(der(x)), 0)", "v(x, y, 0)"),)},
        {"loads": (drive("slow", "x"),), "named": (definition("slow", "-der(der(y))"),)},
        {"energies": (energy("potential", "x*der(der(x))"),)},
        {"constraints": (constraint("c", "der(der(x)) - y", level="velocity"),)},
        {"outputs": {"jerk": "der(der(der(x)))"}},
        {"states": (state("z", "der(der(x))"),), "energies": (energy("lagrangian", "z*der(x)"),)},
    ],
)
def test_accelerations_in_what_makes_them_are_refused(parts) -> None:
    with pytest.raises(CompilationFailed) as failure:
        derive(model(**FREE, **parts))
    (diagnostic,) = failure.value.diagnostics
    assert diagnostic.code == "E0308"
    assert diagnostic.labels[0].span == SPANS[0]


def test_inputs_without_derivatives_are_refused_where_they_move_something() -> None:
    with pytest.raises(CompilationFailed) as failure:
        derive(model(coordinates=("x",), inputs=(("road", None),), masses=(mass(1.0, "v(x, road, 0)"),)))
    (diagnostic,) = failure.value.diagnostics
    assert diagnostic.code == "E0304"
    assert "road" in diagnostic.message


def test_derivative_inputs_count_towards_what_is_missing() -> None:
    flat = model(
        coordinates=("x",),
        inputs=(("road", None), ("der(road)", "road")),
        masses=(mass(1.0, "v(x, road, 0)"),),
        outputs={"a": "der(der(road))"},
    )
    with pytest.raises(CompilationFailed) as failure:
        derive(flat)
    (diagnostic,) = failure.value.diagnostics
    assert diagnostic.code == "E0304"
    assert "twice" in diagnostic.message


def test_body_on_a_carried_frame_with_axes_of_its_own() -> None:
    """Axes set anew after a move: the same kinetic energy as that of the point where the mass centre is."""
    named = (
        frame(
            "B",
            "world",
            Rotate(2, Variable("a")),
            Move(triple(("x", 0, "0.3"))),
            SetAxes(*triple(("v(0, 1, 0)", "v(0, 0, 1)", "v(1, 0, 0)"))),
            Rotate(1, Variable("b")),
        ),
        point("C", "B.origin + 0.2*B.x - 0.1*B.z"),
    )
    shared = {"coordinates": ("a", "b", "x"), "named": named}
    as_body = derive(model(**shared, bodies=(body("B", 2.0, ("0.2", 0, "-0.1")),)))
    as_point = derive(model(**shared, masses=(mass(2.0, "p(C)"),)))
    at = {"q": [0.3, 0.9, 0.5], "qd": [1.0, -2.0, 0.7]}
    for function in ("dynamics", "energies"):
        for one, other in zip(run(as_body, function, **at), run(as_point, function, **at), strict=True):
            np.testing.assert_allclose(one, other, atol=1e-14)
