"""Programs made by hand on the graph, without the floors above: what backends and engines are tested with."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, field

from lagdsl.algebra.graph import Graph, Group, Op
from lagdsl.algebra.graph.differentiate import Tangent, jacobian
from lagdsl.derivation.program.functions import DIRECTIONS, SIGNATURES, SOLVED_DIRECTIONS
from lagdsl.derivation.program.program import Block, Function, Layout, Program, Slot, whole_block

_VARIABLE = {
    Group.DIRECTION_Q: Group.Q,
    Group.DIRECTION_QD: Group.QD,
    Group.DIRECTION_Z: Group.Z,
    Group.DIRECTION_U: Group.U,
    Group.DIRECTION_P: Group.P,
    Group.DIRECTION_QDD: Group.QDD,
    Group.DIRECTION_LAMBDA: Group.LAMBDA,
}


@dataclass
class Sample:
    """Nodes of a model; whatever is left empty is zero or absent. `phi` are position constraints."""

    name: str
    graph: Graph
    n: int
    mass: list[list[int]]
    force: list[int]
    phi: list[int] = field(default_factory=list)
    rates: list[int] = field(default_factory=list)
    outputs: list[int] = field(default_factory=list)
    inputs: int = 0
    defaults: tuple[float, ...] = ()
    start_q: tuple[float, ...] = ()
    redundant: tuple[bool, ...] = ()
    coordinates: tuple[Slot, ...] = ()
    assertions: tuple[str, ...] = ()


def program(sample: Sample) -> Program:
    """All functions of the sample."""
    g, n = sample.graph, sample.n
    q, qd, qdd = (g.symbols(group, n) for group in (Group.Q, Group.QD, Group.QDD))
    m = len(sample.phi)
    lam = g.symbols(Group.LAMBDA, m)
    rows = [[row.get(j, g.zero) for j in range(n)] for row in jacobian(g, sample.phi, q)]
    velocity = Tangent(g, (Group.Q,), lambda symbol: g.symbol(Group.QD, g.b[symbol]))
    rate = [velocity.of(x) for x in sample.phi]
    gamma = [g.negate(velocity.of(x)) for x in rate]
    tau = [g.subtract(g.dot(sample.mass[i], qdd), sample.force[i]) for i in range(n)]
    motion = [g.subtract(tau[i], g.dot([row[i] for row in rows], lam)) for i in range(n)]
    row_rest = [g.subtract(g.dot(row, qdd), x) for row, x in zip(rows, gamma, strict=True)]
    kinetic = g.multiply(g.constant(0.5), g.dot(qd, [g.dot(row, qd) for row in sample.mass]))
    start = [g.constant(x) for x in sample.start_q or (0.0,) * n]

    def blocks(*arrays: tuple[Sequence[int], tuple[int, ...]]) -> tuple[Block, ...]:
        return tuple(whole_block(f"r{i}", s, tuple(a)) for i, (a, s) in enumerate(arrays))

    flat_mass = [x for row in sample.mass for x in row]
    flat_rows = [x for row in rows for x in row]
    nz, nu = len(sample.rates), sample.inputs
    zero = g.zero
    results = {
        "start": blocks((start, (n,)), ([zero] * n, (n,)), ([zero] * nz, (nz,)), ([g.one] * nu, (nu,))),
        "position_constraint": blocks((sample.phi, (m,)), (flat_rows, (m, n))),
        "velocity_constraint": blocks((rate, (m,)), (flat_rows, (m, n))),
        "constraint_tangent": blocks(
            (_directional(g, sample.phi, DIRECTIONS), (m,)), (_directional(g, rate, DIRECTIONS), (m,))
        ),
        "mass_matrix": blocks((flat_mass, (n, n))),
        "dynamics": blocks((flat_mass, (n, n)), (sample.force, (n,)), (flat_rows, (m, n)), (gamma, (m,))),
        "inverse_dynamics": blocks((tau, (n,))),
        "residual": blocks((motion, (n,)), (row_rest, (m,))),
        "residual_tangent": blocks(
            (_directional(g, motion, DIRECTIONS), (n,)), (_directional(g, row_rest, DIRECTIONS), (m,))
        ),
        "state_derivative": blocks((sample.rates, (nz,))),
        "state_derivative_tangent": blocks((_directional(g, sample.rates, SOLVED_DIRECTIONS), (nz,))),
        "output": blocks((sample.outputs, (len(sample.outputs),))),
        "output_tangent": blocks((_directional(g, sample.outputs, SOLVED_DIRECTIONS), (len(sample.outputs),))),
        "energies": blocks(([kinetic], ()), ([kinetic], ()), ([zero], ()), ([kinetic], ())),
        "momenta": blocks(([g.dot(row, qd) for row in sample.mass], (n,))),
        "power": blocks(([g.multiply(x, v) for x, v in zip(sample.force, qd, strict=True)], (n,)), ([zero] * n, (n,))),
        "monitor": blocks(
            ([kinetic], (1,)), ([kinetic], (1,)), ([g.one] * len(sample.assertions), (len(sample.assertions),))
        ),
        "initial_equation": blocks((sample.phi, (m,))),
    }
    functions = tuple(Function(name=name, arguments=a, results=results[name]) for name, a in SIGNATURES.items())
    return Program(name=sample.name, layout=_layout(sample), graph=g, functions=functions)


def _directional(g: Graph, nodes: Sequence[int], directions: Sequence[Group]) -> list[int]:
    of = {_VARIABLE[d]: d for d in directions}
    tangent = Tangent(g, tuple(of), lambda symbol: g.symbol(of[g.group(symbol)], g.b[symbol]))
    return [tangent.of(node) for node in nodes]


def _layout(sample: Sample) -> Layout:
    m = len(sample.phi)
    return Layout(
        coordinates=sample.coordinates or tuple(Slot(name=f"q[{i + 1}]", unit="rad") for i in range(sample.n)),
        states=tuple(Slot(name=f"z{i}") for i in range(len(sample.rates))),
        inputs=tuple(Slot(name=f"u{i}") for i in range(sample.inputs)),
        discretes=(),
        parameters=tuple(Slot(name=f"p{i}", unit="kg") for i in range(len(sample.defaults))),
        defaults=sample.defaults,
        outputs=tuple(Slot(name=f"y{i}") for i in range(len(sample.outputs))),
        constraints=tuple(Slot(name=f"c[{i + 1}]", unit="m", place=f"model.lag:{i + 7}") for i in range(m)),
        position_level=(True,) * m,
        redundant=sample.redundant or (False,) * m,
        invariants=(Slot(name="E", unit="J"),),
        assertions=sample.assertions,
    )


# ---- models ----------------------------------------------------------------------------------------------------------


def pendulum(name: str = "Pendulum") -> Program:
    """m l^2 qdd = -m g l sin q + u0 - d z0; zd = (qd - z)/T; parameters m, l, d, T."""
    g = Graph()
    q, qd, z, u = (g.symbol(group) for group in (Group.Q, Group.QD, Group.Z, Group.U))
    m, length, d, lag = g.symbols(Group.P, 4)
    inertia = g.multiply(m, g.multiply(length, length))
    weight = g.multiply(g.multiply(g.multiply(m, g.constant(9.80665)), length), g.unary(Op.SIN, q))
    sample = Sample(
        name=name,
        graph=g,
        n=1,
        mass=[[inertia]],
        force=[g.subtract(g.subtract(u, weight), g.multiply(d, z))],
        rates=[g.divide(g.subtract(qd, z), lag)],
        outputs=[g.symbol(Group.QDD), g.multiply(length, g.unary(Op.COS, q))],
        inputs=1,
        defaults=(1.5, 0.7, 0.1, 0.3),
        start_q=(0.5,),
        coordinates=(Slot(name="theta", unit="rad", place="pendulum.lag:4"),),
        assertions=("stays inside",),
    )
    return program(sample)


def chain(count: int, name: str = "Chain") -> Program:
    """`count` equal point masses on rods, absolute angles; parameters m, l, g."""
    g = Graph()
    q, qd = g.symbols(Group.Q, count), g.symbols(Group.QD, count)
    m, length, gravity = g.symbols(Group.P, 3)
    s, c = [g.unary(Op.SIN, x) for x in q], [g.unary(Op.COS, x) for x in q]
    unit = g.multiply(m, g.multiply(length, length))
    mass = [[g.zero] * count for _ in range(count)]
    force = []
    for i in range(count):
        total = g.negate(
            g.multiply(g.multiply(g.multiply(g.constant(float(count - i)), m), g.multiply(gravity, length)), s[i])
        )
        for j in range(count):
            weight = g.multiply(g.constant(float(count - max(i, j))), unit)
            cosine = g.add(g.multiply(c[i], c[j]), g.multiply(s[i], s[j]))
            sine = g.subtract(g.multiply(s[i], c[j]), g.multiply(c[i], s[j]))
            mass[i][j] = weight if i == j else g.multiply(weight, cosine)
            total = g.subtract(total, g.multiply(g.multiply(weight, sine), g.multiply(qd[j], qd[j])))
        force.append(total)
    return program(
        Sample(name=name, graph=g, n=count, mass=mass, force=force, defaults=(0.3, 0.5, 9.81), outputs=[s[-1]])
    )


def closed_chain(copies: int = 1, name: str = "Loop", flagged: bool = False) -> Program:
    """Three links pinned at both ends (a four-bar); with `copies` the closure is stated that many times, scaled."""
    g = Graph()
    q = g.symbols(Group.Q, 3)
    lengths = [g.constant(x) for x in (0.4, 1.0, 0.8)]
    x = g.dot(lengths, [g.unary(Op.COS, angle) for angle in q])
    y = g.dot(lengths, [g.unary(Op.SIN, angle) for angle in q])
    m = g.symbol(Group.P)
    mass = [[g.zero] * 3 for _ in range(3)]
    for i in range(3):
        for j in range(3):
            weight = g.multiply(m, g.multiply(g.constant(3.0 - max(i, j)), g.multiply(lengths[i], lengths[j])))
            mass[i][j] = g.multiply(weight, g.unary(Op.COS, g.subtract(q[i], q[j]))) if i != j else weight
    qd = g.symbols(Group.QD, 3)
    force = [g.negate(g.multiply(g.constant(9.81 - i), g.unary(Op.COS, q[i]))) for i in range(3)]
    force = [g.subtract(f, g.multiply(qd[i], qd[(i + 1) % 3])) for i, f in enumerate(force)]
    phi = []
    for k in range(copies):
        scale = g.constant(10.0**k)
        phi += [g.multiply(scale, g.subtract(x, g.constant(1.2))), g.multiply(scale, y)]
    flags = (False, False) + (True,) * (2 * copies - 2) if flagged else ()
    return program(
        Sample(
            name=name,
            graph=g,
            n=3,
            mass=mass,
            force=force,
            phi=phi,
            outputs=g.symbols(Group.LAMBDA, 2 * copies),
            defaults=(2.0,),
            redundant=flags,
        )
    )


def quaternion_body(name: str = "Free body") -> Program:
    """A free rigid body in quaternion coordinates e: M = 4 G' I G of rank 3, constraint e.e = 1."""
    g = Graph()
    e, ed = g.symbols(Group.Q, 4), g.symbols(Group.QD, 4)

    def transfer(v: list[int]) -> list[list[int]]:
        w, x, y, z = v
        n = g.negate
        return [[n(x), w, z, n(y)], [n(y), n(z), w, x], [n(z), y, n(x), w]]

    inertia = [g.constant(x) for x in (1.0, 2.0, 4.0)]
    t, td = transfer(e), transfer(ed)
    four, eight = g.constant(4.0), g.constant(8.0)

    def product(a: list[list[int]], i: int, b: list[list[int]], j: int) -> int:
        return g.sum(g.multiply(inertia[k], g.multiply(a[k][i], b[k][j])) for k in range(3))

    mass = [[g.multiply(four, product(t, i, t, j)) for j in range(4)] for i in range(4)]
    rate = [g.dot(row, ed) for row in t]
    # T = 2 (G ed)' I (G ed); d/dt dT/ded - dT/de at qdd = 0 is 8 Gd' I G ed
    force = [
        g.negate(g.multiply(eight, g.sum(g.multiply(td[k][j], g.multiply(inertia[k], rate[k])) for k in range(3))))
        for j in range(4)
    ]
    phi = [g.subtract(g.dot(e, e), g.one)]
    return program(Sample(name=name, graph=g, n=4, mass=mass, force=force, phi=phi, start_q=(1.0, 0.0, 0.0, 0.0)))
