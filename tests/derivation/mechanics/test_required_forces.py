"""`inverse_dynamics` and `bias` in a model: the values of the functions of the same names, in the right motions."""

from __future__ import annotations

from functools import cache

import numpy as np
import pytest
from choice import together
from sympy import Symbol, cos, sin

import lagdsl
from lagdsl.derivation.mechanics.equations import form_equations
from lagdsl.foundation.diagnostics import CompilationFailed, Sink
from lagdsl.foundation.source import SourceFile
from lagdsl.language.semantics.flatten import flatten
from lagdsl.language.syntax.parser import parse
from lagdsl.motion.pipeline import Route

ARM = """
model Arm
  import Lag.Planar.*;
  parameter Length l = 0.5 m;
  parameter Mass m = 2 kg, nominal = 3 kg;
  Revolute A(tau = tau[1]), B(tau = tau[2]);
  Link upper(l = l, m = m), lower(l = 0.4 m, m = 1 kg);
  gravity = -g_n*world.y;
  dissipation 1/2*(0.1 N.m.s)*der(A.q)^2 + 1/2*(0.2 N.m.s)*(der(A.q) - der(B.q))^2;
  potential 1/2*(3 N.m)*B.q^2;
  connect(world, A, upper, B, lower);
  Angle q[2] = {A.q, B.q};
CONTROLLER
end Arm;
"""
DRIVEN = "  input Torque tau[2] = {0, 0};\n"
Q, QD, QDD = np.array([0.3, -0.7]), np.array([1.1, 0.4]), np.array([2.0, -5.0])


def text(controller: str) -> str:
    return ARM.replace("CONTROLLER", controller)


@cache
def arm(controller: str = DRIVEN) -> lagdsl.Model:
    return lagdsl.compile(text(controller), engine="tape")


ASKED = """
  AngularAcceleration a = -5;
  output Torque f[2] = inverse_dynamics(q, {2, a});
  output Torque b[2] = bias({A.q, B.q});
  output Torque other[2] = inverse_dynamics(q, {2, -5}, m = nominal, lower(m = 2.5 kg));
  output Torque ahead[2] = inverse_dynamics(q, {2, -5}, positions = {1, 2}, rates = {0, 3});
  output Torque weight[2] = bias(q, rates = 0);
"""


@pytest.mark.parametrize(("derivation", "fix"), [("graph", False), ("graph", True), ("textbook", True)])
def test_values_are_those_of_the_functions_of_the_model(derivation: Route, fix: bool) -> None:
    plain = arm()
    model = lagdsl.compile(text(DRIVEN + ASKED), derivation=derivation, fix=fix, engine="tape")
    heavy = {"m": 3.0, "lower.m": 2.5}
    expected = {
        "f": plain.inverse_dynamics(0.4, Q, QD, QDD),
        "b": plain.bias_forces(0.4, Q, QD),
        "other": plain.inverse_dynamics(0.4, Q, QD, QDD, parameters=heavy),
        "ahead": plain.inverse_dynamics(0.4, np.array([1.0, 2.0]), np.array([0.0, 3.0]), QDD),
        "weight": plain.bias_forces(0.4, Q, np.zeros(2)),
    }
    found = model.named_outputs(0.4, Q, QD)
    for name, value in expected.items():
        np.testing.assert_allclose(found[name], value, rtol=1e-12, atol=1e-12, err_msg=name)


def test_symbols_are_those_of_the_two_link_arm() -> None:
    """M. W. Spong, M. Vidyasagar, *Robot Dynamics and Control* (1989), example 6.4.2, with uniform links."""
    torque = text("  Torque tau[2] = inverse_dynamics(q, {2, -5});\n  output Torque t = tau[2] - tau[1];\n")
    lag = lagdsl.compile(torque).equations.outputs["t"]
    l, m, k, r = Symbol("l"), Symbol("m"), Symbol("lower.m"), Symbol("lower.l")
    a, b, ad, bd = (Symbol(name) for name in ("A.q", "B.q", "der(A.q)", "der(B.q)"))
    g, c = Symbol("g_n"), k * l * r / 2
    first = (m / 3 + k) * l**2 * 2 + k * r**2 / 3 * (2 - 5) + c * (cos(b) * (2 * 2 - 5) - sin(b) * (2 * ad + bd) * bd)
    first += (m / 2 + k) * g * l * cos(a) + k * g * r / 2 * cos(a + b) + 0.1 * ad + 0.2 * (ad - bd)
    second = k * r**2 / 3 * (2 - 5) + c * (2 * cos(b) + sin(b) * ad**2) + k * g * r / 2 * cos(a + b)
    second += 3 * b - 0.2 * (ad - bd)
    numbers = {g: 9.80665, l: 0.5, m: 2.0, k: 1.0, r: 0.4, a: 0.3, b: -0.7, ad: 1.1, bd: 0.4}
    assert abs((lag - (second - first)).subs(numbers)) < 1e-12


def test_all_loads_together_make_the_accelerations() -> None:
    """Loads of the mechanism itself are not in the value: what it asks of loads, all of them give."""
    controller = """
  torque -(0.7 N.m.s)*der(B.q) on B.q;
  Torque needed[2] = inverse_dynamics(q, {2, -5});
  Torque tau[2] = {needed[1], needed[2] + (0.7 N.m.s)*der(B.q)};
"""
    np.testing.assert_allclose(arm(controller).forward_dynamics(0.4, Q, QD), QDD, rtol=1e-12)


CONTROL = """
  Angle wanted[2] = {sin(2 /s*time), cos(3 /s*time)};
  Control control(q = q, wanted = wanted);
  Torque tau[2] = control.tau;
"""
CLASS = """
model Control "Knows the coordinates by its inputs"
  parameter Real kp = 64, kd = 20;
  input Angle q[2], wanted[2];
  Angle e[2] = {wanted[i] - q[i] for i in 1:2};
  Torque tau[2] = inverse_dynamics(q, {der(der(wanted[i])) + kd*der(e[i])/(1 s) + kp*e[i]/(1 s2) for i in 1:2});
end Control;
"""


def test_the_error_of_computed_torque_is_that_of_an_oscillator() -> None:
    """e'' + 20 e' + 64 e = 0 has the rates -4 and -16."""
    model = lagdsl.compile(CLASS + text(CONTROL))
    motion = model.simulate(stop=1.0, start={"A.q": "50 deg", "der(B.q)": 1.0}, tolerance=1e-11)
    t = motion["time"]
    for name, wanted, rate in (("A.q", np.sin(2 * t), 2.0), ("B.q", np.cos(3 * t), 0.0)):
        e = wanted - motion[name]
        d0 = rate - motion[f"der({name})"][0]
        fast = -(d0 + 4 * e[0]) / 12
        expected = (e[0] - fast) * np.exp(-4 * t) + fast * np.exp(-16 * t)
        np.testing.assert_allclose(e, expected, atol=1e-9)


SAMPLED = """
  discrete Torque tau[2];
  discrete AngularAcceleration a[2];
equation
  when sample(0, 100 ms) then
    a = {-(2 /s)*der(q[i]) - (1 /s2)*q[i] for i in 1:2};
    tau = inverse_dynamics(q, a);
  end when;
"""


def test_a_clause_reads_the_state_of_its_tick_and_new_values() -> None:
    start = {"A.q": Q[0], "B.q": Q[1], "der(A.q)": QD[0], "der(B.q)": QD[1]}
    motion = arm(SAMPLED).simulate(stop=0.35, start=start, interval=0.05)
    for k in np.flatnonzero(np.diff(motion["tau[1]"])) + 1:
        q, qd = (np.array([motion[form.format(c)][k] for c in ("A.q", "B.q")]) for form in ("{}", "der({})"))
        expected = arm().inverse_dynamics(motion["time"][k], q, qd, -2 * qd - q)
        np.testing.assert_allclose([motion["tau[1]"][k], motion["tau[2]"][k]], expected, rtol=1e-12)


def test_coordinates_of_two_kinds_are_pairs() -> None:
    cart = """
model Cart
  coordinate Length s;
  coordinate Angle q;
  gravity = -g_n*world.y;
  mass 2 kg at {s, 0};
  mass 1 kg at {s + (0.5 m)*sin(q), (0.5 m)*cos(q)};
  output Force F = inverse_dynamics(s, 1.5, q, -2);
  output Torque M = inverse_dynamics(q, -2, s, 1.5);
end Cart;
"""
    model = lagdsl.compile(cart)
    found = model.named_outputs(0.0, Q, QD)
    expected = model.inverse_dynamics(0.0, Q, QD, np.array([1.5, -2.0]))
    np.testing.assert_allclose([found["F"], found["M"]], expected, rtol=1e-12)


def test_reactions_of_a_model_with_such_a_load() -> None:
    ask = "  output Force r = reaction(upper.frame_a).force.x;\n"
    driven, controlled = arm(DRIVEN + ask), arm("  Torque tau[2] = inverse_dynamics(q, {2, -5});\n" + ask)
    tau = arm().inverse_dynamics(0.4, Q, QD, QDD)
    expected = driven.named_outputs(0.4, Q, QD, u=tau)["r"]
    np.testing.assert_allclose(controlled.named_outputs(0.4, Q, QD)["r"], expected, rtol=1e-12)


BODY = """
model T
  coordinate Length x(start = 0), y(start = 0);
  coordinate Angle q;
  parameter Length l = 1 m;
  parameter Mass m2 = l*(2 kg/m);
  gravity = -g_n*world.y;
  mass m2 at {x + l*sin(q), y};
  mass 1 kg at {x, y};
  STATEMENTS
end T;
"""


@together(
    ("statements", "reason"),
    [
        ("force inverse_dynamics(x, 1) on x;", "accelerations that it is not given: of `q`"),
        ("force inverse_dynamics({x, x}, 0)[1] on x;", "`x` is given twice"),
        ("constraint c: y = x; force inverse_dynamics(y, 1) on y;", "the constraint `c` holds `y`"),
        ("constraint der(y) = 2*der(x); force inverse_dynamics(y, 1) on y;", "`constraint_1` holds `y`"),
        ("input Length u = 0; output Force F = bias(u);", "`u` is no coordinate"),
        ("output Force F = bias(y, m2 = 2 kg);", "`m2` is no parameter whose value may be changed"),
        (
            "potential if y > 0 then 3 N*y else 5 N*y; output Force F = bias(y, positions = -1);",
            "it depends on `y > 0`, which is true or false for the present state",
        ),
        ("Force F = bias(y); potential F*(1 m);", "masses and energies depend on its value"),
        ("state Length z; mass 1 kg at {x, z}; equation der(z) = bias(y)*(1 m/N.s);", "masses and energies"),
    ],
)
def test_what_has_no_value_is_refused_with_its_reason(statements: str, reason: str) -> None:
    with pytest.raises(CompilationFailed) as raised:
        lagdsl.compile(BODY.replace("STATEMENTS", statements))
    assert {d.code for d in raised.value.diagnostics if d.severity == "error"} == {"E0528"}
    assert reason in str(raised.value)


def test_what_constraints_do_not_touch_has_a_value() -> None:
    held = lagdsl.compile(BODY.replace("STATEMENTS", "constraint x = l; force inverse_dynamics(y, 3) on y;"))
    np.testing.assert_allclose(held.forward_dynamics(0.0, [1.0, 0.2, 0.3], [0.0, 0.4, 0.0])[1], 3.0, rtol=1e-12)


def test_the_size_grows_with_the_number_of_links() -> None:
    """Each further link adds as many nodes as the one before: no mass matrix is formed."""

    def size(count: int) -> int:
        names = range(1, count + 1)
        chain = f"""
model Chain
  import Lag.Planar.*;
  {" ".join(f"Revolute j{k}(tau = tau[{k}]); Link l{k}(l = 1 m, m = 1 kg);" for k in names)}
  gravity = -g_n*world.y;
  connect(world, {", ".join(f"j{k}, l{k}" for k in names)});
  Angle q[{count}] = {{{", ".join(f"j{k}.q" for k in names)}}};
  Torque tau[{count}] = inverse_dynamics(q, {{-(1 /s)*der(q[k]) for k in 1:{count}}});
end Chain;
"""
        sink = Sink()
        flat = flatten(parse(SourceFile("chain.lag", chain), sink), sink)
        assert flat is not None, sink.diagnostics
        equations = form_equations(flat)
        return len(equations.graph.live(equations.dynamics.terms.load))

    small, middle, large = (size(count) for count in (6, 9, 12))
    assert large - middle == middle - small
