"""Kinetic energies typed by hand: as cheap as declared bodies, and right whatever they say."""

import numpy as np
import pytest
from elimination_models import eliminated, flat_model, largest_residual

from lagdsl.algebra.graph.evaluate import evaluate
from lagdsl.algebra.graph.operation import Group
from lagdsl.language.flat.evaluate import Values
from lagdsl.language.flat.evaluate import evaluate as evaluate_flat

FRAMES = {
    "planar": "(if i == 1 then world else F[i-1].move({0 m, 0 m, -1 m})).roty(q[i])",
    "spatial": """(if i == 1 then world
        else F[i-1].move({0.1 m, 0.3 m, 0.2 m}).rotx(if mod(i, 2) == 0 then 90 deg else -90 deg)).rotz(q[i])""",
}
CHAIN = """model Chain
  structural parameter Integer N = {n};
  parameter Mass m = 1.5 kg;
  parameter Length c[3] = {{0.05 m, 0.1 m, 0.2 m}};
  parameter Inertia I[6] = {{0.02 kg.m2, 0.03 kg.m2, 0.025 kg.m2, 0.001 kg.m2, 0.002 kg.m2, 0.003 kg.m2}};
  coordinate Angle q[N];
  frame F[N];
  {declarations}
equation
  for i in 1:N loop
    frame F[i] = {frame};
    {body}
  end for;
end Chain;
"""
DECLARED = "body (m = m, com = c, I = I) on F[i];"
TYPED = """C[i] = F[i].point(c);
    w[i] = {omega(F[i])*F[i].x, omega(F[i])*F[i].y, omega(F[i])*F[i].z};
    kinetic 1/2*m*der(C[i])*der(C[i]);
    kinetic 1/2*(I[1]*w[i, 1]^2 + I[2]*w[i, 2]^2 + I[3]*w[i, 3]^2) + I[4]*w[i, 1]*w[i, 2] + I[5]*w[i, 1]*w[i, 3]
        + I[6]*w[i, 2]*w[i, 3];
    potential m*g_n*(C[i]*world.z);"""
NAMES = "point C[N]; AngularVelocity w[N, 3];"


def chain(kind: str, n: int, *, typed: bool) -> str:
    return CHAIN.format(
        n=n,
        frame=FRAMES[kind],
        body=TYPED if typed else DECLARED,
        declarations=NAMES if typed else "gravity = -g_n*world.z;",
    )


@pytest.mark.parametrize("kind", FRAMES)
@pytest.mark.parametrize("n", [1, 2, 6])
def test_typed_bodies_cost_what_declared_ones_cost(kind: str, n: int) -> None:
    typed, declared = flat_model(chain(kind, n, typed=True)), flat_model(chain(kind, n, typed=False))
    assert largest_residual(typed, states=5) < 1e-13
    assert eliminated(typed)[1].flops <= 1.03 * eliminated(declared)[1].flops


@pytest.mark.parametrize("kind", FRAMES)
def test_typed_bodies_accelerate_as_declared_ones(kind: str) -> None:
    rng = np.random.default_rng(3)
    state = {Group.Q: list(rng.normal(size=4)), Group.QD: list(rng.normal(size=4)), Group.TIME: 0.0}
    found = []
    for typed in (False, True):
        flat = flat_model(chain(kind, 4, typed=typed))
        derivation, solution = eliminated(flat)
        parameters = [item.value for item in flat.parameters if not item.structural]
        found.append(evaluate(derivation.graph, solution.own.accelerations, {**state, Group.P: parameters}))
    np.testing.assert_allclose(found[1], found[0], rtol=1e-12, atol=1e-12)


SUMS = {
    "angles and places, each written out anew from its end": """phi[i] = sum(q[i+1-k] for k in 1:i);
    x[i] = sum((0.3 m)*sin(phi[i+1-k]) for k in 1:i);
    y[i] = -sum((0.3 m)*cos(phi[i+1-k]) for k in 1:i);""",
    "middles of links": """phi[i] = q[i];
    x[i] = (0.15 m)*sin(q[i]) + sum((0.3 m)*sin(q[i-k]) for k in 1:i-1);
    y[i] = -(0.15 m)*cos(q[i]) - sum((0.3 m)*cos(q[i-k]) for k in 1:i-1);""",
}


@pytest.mark.parametrize("name", SUMS)
def test_cost_of_sums_written_out_grows_with_the_links(name: str) -> None:
    def chain(n: int) -> str:
        return f"""model Chain
  structural parameter Integer N = {n};
  coordinate Angle q[N];
  Angle phi[N];
  Length x[N], y[N];
equation
  for i in 1:N loop
    {SUMS[name]}
    kinetic 0.5*(0.7 kg)*(der(x[i])^2 + der(y[i])^2) + 0.5*(0.02 kg.m2)*der(phi[i])^2;
    potential (0.7 kg)*g_n*y[i];
  end for;
end Chain;
"""

    flops = {n: eliminated(flat_model(chain(n)))[1].flops for n in (5, 10, 15)}
    assert flops[15] < 15 * 75
    assert flops[15] - flops[10] == flops[10] - flops[5]
    assert largest_residual(flat_model(chain(5))) < 1e-12


FREE = """coordinate Length x, y, z;
  coordinate Angle a, b, c;
  frame B = world.move({x, y, z}).rotz(a).roty(b).rotx(c);
  gravity = 0;
  """
OMEGA = "{omega(B)*B.x, omega(B)*B.y, omega(B)*B.z}"
OWN = "{der(B.origin)*B.x, der(B.origin)*B.y, der(B.origin)*B.z}"
ANY = {
    "a body in a perfect fluid, added mass and inertia fully coupled": FREE
    + f"""parameter Mass m[3] = {{2, 5, 7}};
  parameter Inertia I[3] = {{0.3, 0.4, 0.6}};
  AngularVelocity w[3] = {OMEGA};
  Velocity v[3] = {OWN};
  kinetic 1/2*(m[1]*v[1]^2 + m[2]*v[2]^2 + m[3]*v[3]^2) + (0.4 kg)*v[1]*v[2];
  kinetic 1/2*(I[1]*w[1]^2 + I[2]*w[2]^2 + I[3]*w[3]^2) + (0.3 kg.m)*w[1]*v[3] + (0.2 kg.m)*w[2]*v[2];""",
    "beside a body with weight": FREE.replace("gravity = 0", "gravity = -g_n*world.z")
    + """body (m = 2 kg, com = {0.1 m, 0.2 m, 0.3 m}, I = {0.3 kg.m2, 0.4 kg.m2, 0.5 kg.m2}) on B;
  kinetic (1 kg)*der(B.origin)*der(B.origin) + (0.2 kg.m2)*(omega(B)*B.z)^2;""",
    "weights of other masses, at other places, along other directions": FREE
    + """parameter Mass m = 2 kg;
  point P = B.point({0.1 m, 0.2 m, 0.3 m});
  point Q = B.point({0, 0.3 m, 0.1 m});
  frame D = B.move({0, 0.2 m, 0.5 m});
  kinetic 1/2*m*der(P)*der(P) + (0.2 kg.m2)*omega(B)*omega(B) + (1 kg)*der(D.origin)*der(D.origin);
  kinetic 1/2*(3 kg)*der(Q)*der(Q) + (0.2 kg.m2)*omega(D)*omega(D);
  potential (2 kg)*g_n*(P*world.z) + m*(3 m/s2)*(P*world.x + Q*world.y) + (3 kg)*g_n*(Q*world.z);
  potential (2 kg)*g_n*(D.origin*world.z) + (1 N/m)*(P*world.z)^2;""",
    "two bodies under two gravities": """coordinate Angle a, b;
  frame A = world.rotz(a).rotx(b);
  frame B = A.move({0.5 m, 0, 0}).roty(a + b);
  point P = A.point({0.1 m, 0.2 m, 0.3 m});
  kinetic (1 kg)*der(P)*der(P) + (0.2 kg.m2)*omega(A)*omega(A);
  kinetic (2 kg)*der(B.origin)*der(B.origin) + (0.2 kg.m2)*(omega(B)*B.y)^2;
  potential (2 kg)*(3 m/s2)*(P*world.z);
  potential (4 kg)*(1 m/s2)*(B.origin*world.x);""",
    "a bead on a turning arm": """coordinate Angle a, b;
  coordinate Length s(start = 1);
  frame A = world.rotz(a).rotx(b);
  point P = A.point({s, 0.2 m, 0});
  kinetic 1/2*(2 kg)*der(P)*der(P) + 1/2*(3 kg)*vel(P, A)*vel(P, A);
  kinetic 1/2*(0.3 kg.m2)*(omega(A)*A.x)^2 + (0.2 kg.m2)*(omega(A)*omega(A));""",
    "a turning base, mass that changes": """coordinate Angle a, b;
  frame A = world.rotz(0.3*sin((2 rad/s)*time)).move({1 m, 0, 0}).rotx(a);
  frame B = A.move({0.2 m, 0.3 m, 0}).roty(b);
  kinetic 1/2*(2 kg + (0.1 kg/s)*time)*der(B.point({0.1 m, 0, 0.2 m}))*der(B.point({0.1 m, 0, 0.2 m}));
  kinetic 1/2*(0.3 kg.m2)*omega(A)*omega(A) + 1/2*(0.1 kg.m2)*(1 + cos(b)^2)*(omega(B)*B.x)^2;""",
    "relativistic, of a point carried about": """coordinate Angle a, b;
  parameter Velocity c = 20 m/s;
  frame A = world.rotz(a).move({1 m, 0, 0}).rotx(b);
  point P = A.point({0, 0.7 m, 0.2 m});
  lagrangian -(1 kg)*c^2*sqrt(1 - der(P)*der(P)/c^2) - (0.3 kg.m/s)*der(P)*A.y*sin(a);""",
    "velocity between two frames": """coordinate Angle a, b, c;
  frame A = world.rotz(a).move({1 m, 0, 0}).rotx(b);
  frame B = A.move({0, 0.5 m, 0}).roty(c);
  kinetic (1 kg)*der(A.origin)*der(A.origin);
  point P = B.point({0.1 m, 0.2 m, 0.3 m});
  kinetic (0.5 kg)*(der(P) - der(A.origin))*(der(P) - der(A.origin));
  kinetic (0.3 kg.m2)*(omega(B) - omega(A))*(omega(B) - omega(A));
  kinetic (0.2 kg.m2)*cross(omega(B), B.x)*cross(omega(B), B.x) + (0.2 kg)*der(-P/2)*der(-P/2);
  kinetic (0.4 kg)*(der(B.origin)*world.y)^2 + (0.1 kg)*norm(der(A.origin))^2 + (0.1 kg.m2)*(omega(B)*A.y)^2;""",
    "frames that share axes": """coordinate Angle a, b;
  coordinate Length s;
  frame A = world.rotz(a).rotx(b);
  frame B = A.move({0, 1 m, 0});
  frame C = B.move({s, 0, 0});
  kinetic (1 kg)*der(B.origin)*der(B.origin) + (2 kg)*der(C.origin)*der(C.origin);
  kinetic (0.2 kg.m2)*(omega(C)*A.x)^2 + (0.1 kg.m2)*(omega(A)*B.y)^2;
  kinetic (0.3 kg.m)*(omega(A)*A.z)*(der(C.origin)*A.y);""",
    "skew axes": """coordinate Angle a, b;
  frame A = world.rotate({1, 2, 2}, a);
  frame B = A.move({1 m, 0, 0}).rotate({0.3, -1, 0.5}, b);
  kinetic (1 kg)*der(B.point({0.3 m, 0.1 m, 0}))*der(B.point({0.3 m, 0.1 m, 0}));
  kinetic (0.1 kg.m2)*(omega(B)*B.x)^2 + (0.2 kg.m2)*(omega(B)*B.y)*(omega(B)*B.z) + (0.3 kg.m2)*omega(A)*omega(A);""",
}


@pytest.mark.parametrize("name", ANY)
def test_any_energy_in_velocities_of_frames(name: str) -> None:
    """Against the dense equations, whose energies are evaluated from the flat model by other means."""
    flat = flat_model(f"model M\n  {ANY[name]}\nend M;\n")
    assert largest_residual(flat) < 1e-12
    derivation, _ = eliminated(flat)
    rng = np.random.default_rng(4)
    names = [item.name for item in flat.coordinates]
    for _ in range(5):
        q, qd = rng.uniform(-1.0, 1.0, len(names)), rng.normal(size=len(names))
        symbols = {Group.Q: list(q), Group.QD: list(qd), Group.TIME: 0.3}
        symbols[Group.P] = [item.value for item in flat.parameters if not item.structural]
        values = Values(
            variables={"time": 0.3, **dict(zip(names, q, strict=True))}, rates=dict(zip(names, qd, strict=True))
        )
        for term in flat.energies:
            (found,) = evaluate(derivation.graph, [derivation.lowering.scalar(term.value)], symbols)
            assert found == pytest.approx(evaluate_flat(flat, term.value, values), rel=1e-12, abs=1e-14)
