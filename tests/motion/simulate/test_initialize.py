"""Consistent initial states: positions, rates, initial equations, and what is said about them."""

from __future__ import annotations

from dataclasses import replace
from typing import Any

import numpy as np
import pytest
from simulate.hand import FourBar, Hand, TwiceTied, constraint, coordinate, flat_model, four_bar, length

from lagdsl.foundation.diagnostics import CompilationFailed, Sink
from lagdsl.language.flat.expression import Number
from lagdsl.motion.simulate.initialize import InitialState, initial_state


def start(engine: Hand, **more: Any) -> tuple[InitialState, list[str]]:
    sink = Sink()
    found = initial_state(engine.flat, engine, sink=sink, **more)
    return found, [d.code for d in sink.diagnostics]


def test_without_constraints_every_start_is_attained_exactly() -> None:
    engine = Hand(flat_model([coordinate("a", 0.3, 0.1), coordinate("b", -1.0)], states=["s"]))
    engine.start_z = (0.7,)
    found, codes = start(engine)
    assert found.q.tolist() == [0.3, -1.0] and found.qd.tolist() == [0.1, 0.0] and found.z.tolist() == [0.7]
    assert not codes and str(found) == ""


def test_four_bar_closes_with_the_fixed_crank_untouched() -> None:
    engine = four_bar()
    found, codes = start(engine)
    assert found.q[0] == 1.0
    assert np.max(np.abs(engine.phi(0.0, found.q))) < 1e-15
    assert found.freedom == 1
    assert codes == ["W0814", "W0814"]


class Line(Hand):
    """x and y tied by x + y = 1."""

    def phi(self, t, q):  # type: ignore[no-untyped-def]
        return np.array([q[0] + q[1] - 1.0])

    def rows(self, t, q):  # type: ignore[no-untyped-def]
        return np.array([[1.0, 1.0]])


def line(*coordinates: Any) -> Line:
    return Line(flat_model(coordinates, [constraint("tie")]))


def test_what_is_not_written_moves() -> None:
    """x + y = 1 from x = 2, which is written."""
    found, codes = start(line(length("x", 2.0), length("y")))
    assert found.q[0] == 2.0
    assert found.q[1] == pytest.approx(-1.0, abs=1e-14) and not codes


def test_nominal_values_are_the_weights() -> None:
    found, _ = start(line(length("x", nominal=1.0), length("y", nominal=3.0)))
    assert found.q == pytest.approx([0.1, 0.9], abs=1e-14)


def test_nearest_point_of_a_curve_and_not_just_any() -> None:
    """The point of the circle nearest to (0.6, 0.1) lies on the ray to it."""
    engine = TwiceTied(flat_model([length("x", 0.6), length("y", 0.1)], [constraint("a"), constraint("b")]))
    found, _ = start(engine)
    assert found.q == pytest.approx(0.5 * np.array([0.6, 0.1]) / np.hypot(0.6, 0.1), abs=1e-9)


class Wave(Hand):
    """y = sin(3 x)."""

    def phi(self, t, q):  # type: ignore[no-untyped-def]
        return np.array([q[1] - np.sin(3.0 * q[0])])

    def rows(self, t, q):  # type: ignore[no-untyped-def]
        return np.array([[-3.0 * np.cos(3.0 * q[0]), 1.0]])


def test_nearest_point_where_the_curve_bends_more_than_the_distance() -> None:
    """Compared with a fine scan of the curve; at this start plain projection steps do not converge."""
    engine = Wave(flat_model([length("x", nominal=1.0), length("y", -2.0, nominal=1.0)], [constraint("wave")]))
    found, _ = start(engine)
    x = np.linspace(-2.0, 1.0, 300_001)
    scan = x**2 + 100.0 * (np.sin(3.0 * x) + 2.0) ** 2
    reached = found.q[0] ** 2 + 100.0 * (found.q[1] + 2.0) ** 2
    assert reached <= scan.min() * (1.0 + 1e-8)


@pytest.mark.parametrize(("x0", "y0"), [(0.0, -2.0), (1.2, -3.0)])
def test_the_nearest_of_several_troughs_is_found(x0: float, y0: float) -> None:
    """From (0, -2) the wave is reached by following, from (1.2, -3), high above the crest between two troughs, by
    search."""
    x = np.linspace(-6.0, 6.0, 300_001)
    coordinates = [length("x", x0, nominal=1.0), length("y", y0, nominal=1.0)]
    found, _ = start(Wave(flat_model(coordinates, [constraint("wave")])))
    widths = np.where(np.array([x0, y0]) != 0.0, 0.1, 1.0)  # what cannot be held weighs a hundred times more
    reached = float(np.sum(((found.q - [x0, y0]) / widths) ** 2))
    scan = ((x - x0) / widths[0]) ** 2 + ((np.sin(3.0 * x) - y0) / widths[1]) ** 2
    assert reached <= scan.min() * (1.0 + 1e-8)


def test_a_farthest_point_is_no_nearest_one() -> None:
    """On the circle of radius 2 about (1, 0), (3, 0) is stationary too: Newton's method leaves it."""

    class Circle(Hand):
        def phi(self, t, q):  # type: ignore[no-untyped-def]
            return np.array([(q[0] - 1.0) ** 2 + q[1] ** 2 - 4.0])

        def rows(self, t, q):  # type: ignore[no-untyped-def]
            return np.array([[2.0 * (q[0] - 1.0), 2.0 * q[1]]])

    found, _ = start(Circle(flat_model([length("x"), length("y")], [constraint("circle")])))
    assert found.q == pytest.approx([-1.0, 0.0], abs=1e-9)


def test_start_overrides_count_as_explicit() -> None:
    found, codes = start(line(length("x"), length("y")), start={"x": 2.0, "der(y)": 0.5})
    assert found.q == pytest.approx([2.0, -1.0])
    assert found.qd == pytest.approx([-0.5, 0.5])
    assert not codes


def test_state_overrides_and_unknown_names() -> None:
    engine = Hand(flat_model([coordinate("a")], states=["s"]))
    engine.start_z = (0.0,)
    assert start(engine, start={"s": 2.0})[0].z.tolist() == [2.0]
    sink = Sink()
    initial_state(engine.flat, engine, start={"sa": 1.0}, sink=sink)
    assert sink.diagnostics[0].code == "E0805"
    assert sink.diagnostics[0].help is not None and "a, der(a), s" in sink.diagnostics[0].help


def test_overdetermined_by_a_second_fixed_angle_points_at_it() -> None:
    flat = four_bar().flat
    second = replace(flat.coordinates[1], fixed=True)
    engine = FourBar(replace(flat, coordinates=(flat.coordinates[0], second, flat.coordinates[2])))
    sink = Sink()
    initial_state(engine.flat, engine, sink=sink)
    (error,) = sink.diagnostics
    assert error.code == "E0801" and error.message.endswith("by 1")
    assert error.labels[0].span == second.spans[0]
    assert "has 1 degree of freedom, so one coordinate can be fixed" in error.notes[0]


def test_all_fixed_and_consistent_is_accepted() -> None:
    q = start(four_bar())[0].q
    flat = four_bar(tuple(q)).flat  # type: ignore[arg-type]
    fixed = replace(flat, coordinates=tuple(replace(c, fixed=True) for c in flat.coordinates))
    found, codes = start(FourBar(fixed))
    assert not codes and np.array_equal(found.q, q)


def test_all_fixed_and_inconsistent_is_overdetermined() -> None:
    flat = four_bar().flat
    fixed = replace(flat, coordinates=tuple(replace(c, fixed=True) for c in flat.coordinates))
    assert start(FourBar(fixed))[1] == ["E0801"]


def test_position_not_found_names_constraint_and_configuration() -> None:
    engine = four_bar()
    engine.d = 3.0
    sink = Sink()
    initial_state(engine.flat, engine, sink=sink)
    (error,) = [d for d in sink.diagnostics if d.severity == "error"]
    assert error.code == "E0802" and "`loop[1]`" in error.message
    assert "configuration reached: A = 57.3 deg" in error.notes[0]


def test_without_sink_errors_are_raised() -> None:
    engine = four_bar()
    engine.d = 3.0
    with pytest.raises(CompilationFailed, match="E0802"):
        initial_state(engine.flat, engine)


def test_far_start_is_found_by_another_beginning() -> None:
    """From here plain Newton stalls in a local minimum; the search goes on from elsewhere."""

    class Valley(Hand):
        def phi(self, t, q):  # type: ignore[no-untyped-def]
            return np.array([q[0] ** 3 - 2.0 * q[0] + 2.0])

        def rows(self, t, q):  # type: ignore[no-untyped-def]
            return np.array([[3.0 * q[0] ** 2 - 2.0]])

    engine = Valley(flat_model([length("x", 1.0)], [constraint("c")]))
    found, _ = start(engine)
    assert found.q[0] == pytest.approx(-1.7692923542386314)


# ---- rates -----------------------------------------------------------------------------------------------------------


class Particle(Line):
    """Masses 1 and 3 on x and y, x + y = 1."""

    def mass(self, q):  # type: ignore[no-untyped-def]
        return np.diag([1.0, 3.0])


def test_defaulted_rates_minimise_kinetic_energy_of_the_change() -> None:
    """Neither rate is explicit; x + y = c t demands a sum of 1: shared inversely to the masses."""

    class Driven(Particle):
        def rate(self, t, q):  # type: ignore[no-untyped-def]
            return np.array([-1.0])

    found, codes = start(Driven(flat_model([length("x", 0.5), length("y", 0.5)], [constraint("tie")])))
    assert found.qd == pytest.approx([0.75, 0.25], abs=1e-15)
    assert not codes
    assert [row.name for row in found.moved] == ["der(x)", "der(y)"]


def test_explicit_rate_wins_and_two_dependent_ones_contradict() -> None:
    found, codes = start(Particle(flat_model([length("x", 0.5), length("y", 0.5, 2.0)], [constraint("tie")])))
    assert found.qd == pytest.approx([-2.0, 2.0], abs=1e-14) and not codes
    both = Particle(flat_model([length("x", 0.5, 1.0), length("y", 0.5, 2.0)], [constraint("tie")]))
    _, codes = start(both)
    assert codes == ["E0887"]


def test_fixed_rate_beats_an_explicit_one_declared_before_it() -> None:
    y = length("y", 0.5, 2.0, rate_fixed=True)
    found, _ = start(Particle(flat_model([length("x", 0.5, 1.0), y], [constraint("tie")])))
    assert found.qd == pytest.approx([-2.0, 2.0], abs=1e-14)


def test_contradicting_fixed_rates() -> None:
    x, y = length("x", 0.5, 1.0, rate_fixed=True), length("y", 0.5, 2.0, rate_fixed=True)
    sink = Sink()
    engine = Particle(flat_model([x, y], [constraint("tie")]))
    initial_state(engine.flat, engine, sink=sink)
    assert [d.code for d in sink.diagnostics] == ["E0803"]
    assert "`tie`" in sink.diagnostics[0].message or "der(" in sink.diagnostics[0].message


def test_massless_directions_keep_the_rate_nearest_to_the_start() -> None:
    class Light(Line):
        def mass(self, q):  # type: ignore[no-untyped-def]
            return np.zeros((2, 2))

    found, _ = start(
        Light(flat_model([length("x", 0.5, nominal=1.0), length("y", 0.5, 2.0, nominal=1.0)], [constraint("t")]))
    )
    assert found.qd == pytest.approx([-2.0, 2.0], abs=1e-14)


def flat_parallelogram(**rates: float) -> FourBar:
    coordinates = [
        coordinate(n, 0.0, rates.get(n, 0.0), fixed=True, rate_fixed=n == "A" and "A" in rates) for n in ("A", "B", "C")
    ]
    engine = FourBar(flat_model(coordinates, [constraint("loop", 2)]))
    engine.a = engine.c = 0.3
    engine.b = engine.d = 0.6
    return engine


def test_rates_in_a_singular_position_lie_on_a_branch() -> None:
    """Stretched out, a parallelogram may go on parallel (C = A, B = 0) or crossed: nothing between."""
    engine = flat_parallelogram(A=4.0)
    found, _ = start(engine)
    a, b, c = found.qd
    assert a == 4.0
    assert 0.3 * a + 0.6 * b == pytest.approx(0.3 * c, abs=1e-12)
    assert 0.3 * a**2 + 0.6 * b**2 == pytest.approx(0.3 * c**2, abs=1e-9)


def test_explicit_rates_off_every_branch_give_way() -> None:
    engine = flat_parallelogram(A=4.0, B=1.0)
    found, codes = start(engine)
    a, b, c = found.qd
    assert a == 4.0 and b != 1.0 and "W0814" in codes
    assert 0.3 * a**2 + 0.6 * b**2 == pytest.approx(0.3 * c**2, abs=1e-9)


def test_rates_that_no_branch_allows_are_left_as_they_are() -> None:
    """x^2 + y^2 = 0 holds in one point only: no rates satisfy its second derivative with x' = 1."""

    class Point(Hand):
        def phi(self, t, q):  # type: ignore[no-untyped-def]
            return np.array([q[0] ** 2 + q[1] ** 2])

        def rows(self, t, q):  # type: ignore[no-untyped-def]
            return np.array([[2.0 * q[0], 2.0 * q[1]]])

    x = length("x", 0.0, 1.0, rate_fixed=True)
    found, _ = start(Point(flat_model([x, length("y")], [constraint("p")])))
    assert found.qd[0] == 1.0


# ---- initial equations -----------------------------------------------------------------------------------------------


class Spring(Hand):
    """x'' = 3 - 2 x - z; z' = x - 1."""

    def force(self, t, q, qd, z, u):  # type: ignore[no-untyped-def]
        return np.array([3.0 - 2.0 * q[0] - z[0]])

    def zdot(self, t, q, qd, z, u):  # type: ignore[no-untyped-def]
        return np.array([q[0] - 1.0])

    def initial(self, t, q, qd, z, u, qdd, lam):  # type: ignore[no-untyped-def]
        return np.array([qd[0], qdd[0]])[: len(self.flat.initial_equations)]


def test_equilibrium_start_moves_position_and_state() -> None:
    """der(x) = 0 and der(der(x)) = 0: 2 x + z = 3 nearest to x = 0, z = 0."""
    engine = Spring(flat_model([length("x", nominal=1.0)], states=["z"], initial_equations=2))
    engine.start_z = (0.0,)
    found, _ = start(engine)
    assert found.q == pytest.approx([1.2], abs=1e-9)
    assert found.z == pytest.approx([0.6], abs=1e-9)
    assert found.qd == pytest.approx([0.0], abs=1e-12)


def test_equilibrium_with_a_fixed_position_moves_the_rest() -> None:
    x = length("x", 1.5, 4.0, nominal=1.0, fixed=True)
    engine = Spring(flat_model([x], states=["z"], initial_equations=2))
    engine.start_z = (0.0,)
    found, codes = start(engine)
    assert found.q[0] == 1.5 and found.z == pytest.approx([0.0], abs=1e-9)
    assert not codes and [row.name for row in found.moved] == ["x", "der(x)"]


def test_equilibrium_that_fixed_values_exclude() -> None:
    x = length("x", 1.5, 4.0, nominal=1.0, fixed=True, rate_fixed=True)
    engine = Spring(flat_model([x], states=["z"], initial_equations=2))
    engine.start_z = (0.0,)
    assert start(engine)[1] == ["E0839"]


def test_equilibrium_that_does_not_exist() -> None:
    class Falling(Hand):
        def force(self, t, q, qd, z, u):  # type: ignore[no-untyped-def]
            return np.array([-9.81])

        def initial(self, t, q, qd, z, u, qdd, lam):  # type: ignore[no-untyped-def]
            return qdd

    engine = Falling(flat_model([length("x")], initial_equations=1))
    assert start(engine)[1] == ["E0815"]


def test_equilibrium_of_a_mechanism() -> None:
    """The four-bar at rest: constraints and accelerations together."""

    class Resting(FourBar):
        def initial(self, t, q, qd, z, u, qdd, lam):  # type: ignore[no-untyped-def]
            return np.array([qd[0], qdd[0]])

    flat = four_bar().flat
    free = replace(flat, coordinates=(replace(flat.coordinates[0], fixed=False), *flat.coordinates[1:]))
    engine = Resting(flat_model(free.coordinates, free.constraints, initial_equations=2))
    sink = Sink()
    found = initial_state(engine.flat, engine, sink=sink)
    assert not sink.has_errors
    qdd, _ = engine.solve(0.0, found.q, found.qd, found.z, np.zeros(0), np.zeros(0), np.zeros(0))
    assert np.max(np.abs(qdd)) < 1e-7 and np.max(np.abs(engine.phi(0.0, found.q))) < 1e-9


# ---- what is said ----------------------------------------------------------------------------------------------------


def test_not_a_number_at_the_start_is_named() -> None:
    bad = length("x", float("nan"))
    sink = Sink()
    engine = Hand(flat_model([bad]))
    initial_state(engine.flat, engine, sink=sink)
    assert [d.message for d in sink.diagnostics] == ["at the start `x` is not a number"]


def test_constraint_that_is_not_a_number_at_the_start_is_named() -> None:
    class Broken(Line):
        def phi(self, t, q):  # type: ignore[no-untyped-def]
            return np.array([np.nan])

    engine = Broken(flat_model([length("x"), length("y")], [constraint("tie")]))
    sink = Sink()
    initial_state(engine.flat, engine, sink=sink)
    assert [d.message for d in sink.diagnostics] == ["at the start `tie` is not a number"]


def test_table_of_what_moved() -> None:
    flat = four_bar((np.deg2rad(60.0), np.deg2rad(30.0), np.deg2rad(80.0))).flat
    flat = replace(flat, coordinates=(*flat.coordinates[:2], replace(flat.coordinates[2], start_explicit=False)))
    found, _ = start(FourBar(flat))
    lines = str(found).splitlines()
    assert lines[0] == "initial state (Hand): 1 degree of freedom, 2 start values adjusted"
    assert lines[1].split() == ["A", "60.00", "deg", "fixed"]
    assert lines[2].split()[:5] == ["B", "30.00", "deg", "->", f"{np.rad2deg(found.q[1]):.2f}"]
    assert lines[2].endswith("deg") and "explicit start moved by" in lines[2]
    assert "guess moved by" in lines[3]
    assert len({line.index("->") for line in lines[2:]}) == 1


def test_small_numbers_keep_their_digits_in_the_table() -> None:
    x = length("x", nominal=1e-3)
    y = length("y", nominal=1e-3)

    class Small(Line):
        def phi(self, t, q):  # type: ignore[no-untyped-def]
            return np.array([q[0] + q[1] - 2e-3])

    found, _ = start(Small(flat_model([x, y], [constraint("tie")])))
    assert "-> 0.001 m" in str(found)


def test_time_and_inputs_of_the_start() -> None:
    class Moving(Line):
        def phi(self, t, q):  # type: ignore[no-untyped-def]
            return np.array([q[0] + q[1] - t])

    engine = Moving(flat_model([length("x", nominal=1.0), length("y", nominal=1.0)], [constraint("tie")], inputs=["u"]))
    engine.start_u = (0.0,)
    found, _ = start(engine, t0=3.0, u=np.array([5.0]))
    assert found.t == 3.0 and found.q == pytest.approx([1.5, 1.5])


def test_number_starts() -> None:
    assert coordinate("a", 0.5).start == Number(0.5)


def test_a_tight_curve_is_met_where_it_is_nearest() -> None:
    """Retractions from far along it come back longer: the steps are halved until they do not."""

    class Spiral(Hand):
        def phi(self, t, q):  # type: ignore[no-untyped-def]
            return np.array([q[1] - np.sin(8.0 * q[0]) - 2.0])

        def rows(self, t, q):  # type: ignore[no-untyped-def]
            return np.array([[-8.0 * np.cos(8.0 * q[0]), 1.0]])

    found, _ = start(Spiral(flat_model([length("x"), length("y")], [constraint("curve")])))
    x = np.linspace(-3.0, 3.0, 300_001)
    assert np.linalg.norm(found.q) <= np.sqrt(np.min(x**2 + (np.sin(8.0 * x) + 2.0) ** 2)) * (1.0 + 1e-8)


def test_inconsistent_velocity_rows_are_named() -> None:
    class Both(Hand):
        def rows(self, t, q):  # type: ignore[no-untyped-def]
            return np.array([[1.0], [1.0]])

        def phi(self, t, q):  # type: ignore[no-untyped-def]
            return np.zeros(2)

        def rate(self, t, q):  # type: ignore[no-untyped-def]
            return np.array([-1.0, -2.0])

    rows = [constraint("a", level="velocity"), constraint("b", level="velocity")]
    engine = Both(flat_model([length("x")], rows))
    sink = Sink()
    initial_state(engine.flat, engine, sink=sink)
    assert sink.diagnostics[0].code == "E0803" and "residual 0.5 m stalls at" in sink.diagnostics[0].message


def test_contradicting_fixed_rates_of_unequal_weight_name_the_rate() -> None:
    class Stopped(Hand):
        def rows(self, t, q):  # type: ignore[no-untyped-def]
            return np.array([[1.0, 0.0]])

        def phi(self, t, q):  # type: ignore[no-untyped-def]
            return np.zeros(1)

    x = length("x", 0.5, 1.0, rate_fixed=True, nominal=1.0)
    engine = Stopped(flat_model([x, length("y", nominal=1.0)], [constraint("stop", level="velocity")]))
    sink = Sink()
    initial_state(engine.flat, engine, sink=sink)
    assert [d.code for d in sink.diagnostics] == ["E0803"]
