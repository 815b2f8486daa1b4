"""Random circuits against the equations of their graph; the order of a text does not matter."""

from __future__ import annotations

import numpy as np
import pytest
from choice import spread
from scipy.linalg import null_space

import lagdsl

BRANCH = """
model Branch
  extends Lag.Electrical.OnePort;
  parameter Inductance L;
  parameter Resistance R;
  parameter Capacitance C;
  kinetic 1/2*L*der(q)^2;
  dissipation 1/2*R*der(q)^2;
  potential q^2/(2*C);
end Branch;
"""


class _Circuit:
    """A ring with random chords: branch b leads from `ends[b][0]` to `ends[b][1]`, node 0 is grounded."""

    def __init__(self, seed: int) -> None:
        random = np.random.default_rng(seed)
        self.nodes, self.branches = 5, 8
        ring = [(k, (k + 1) % self.nodes) for k in range(self.nodes)]
        chords = [random.choice(self.nodes, 2, replace=False).tolist() for _ in range(self.branches - self.nodes)]
        self.ends = ring + [(int(start), int(end)) for start, end in chords]
        self.L, self.R, self.C = random.uniform(0.5, 2.0, (3, self.branches))
        incidence = np.zeros((self.nodes, self.branches))
        for b, (start, end) in enumerate(self.ends):
            incidence[start, b] += 1
            incidence[end, b] -= 1
        self.incidence = incidence[1:]
        self.q = random.normal(size=self.branches)
        self.i = null_space(self.incidence) @ random.normal(size=self.branches - self.nodes + 1)

    def text(self, order: np.random.Generator) -> str:
        pins: list[list[str]] = [[] for _ in range(self.nodes)]
        for b, (start, end) in enumerate(self.ends):
            pins[start].append(f"b{b + 1}.p")
            pins[end].append(f"b{b + 1}.n")
        pins[0].append("ground.p")
        joined = []
        for pin in pins:
            order.shuffle(pin)
            cut = int(order.integers(1, len(pin)))  # one node in two statements that share a pin
            joined += [pin] if cut == 1 else [pin[:cut], pin[cut - 1 :]]
        order.shuffle(joined)
        lines = [f"  Branch b{b + 1}(L = {self.L[b]}, R = {self.R[b]}, C = {self.C[b]});" for b in range(self.branches)]
        lines += ["  Lag.Electrical.Ground ground;", *(f"  connect({', '.join(pin)});" for pin in joined)]
        lines += [f"  output Voltage v{k} = {pins[k][0]}.v;" for k in range(1, self.nodes)]
        return f"{BRANCH}model Circuit\n" + "\n".join(lines) + "\nend Circuit;\n"

    def solved(self) -> tuple[np.ndarray, np.ndarray]:
        """Rates of the currents and potentials: L i' + R i + q/C = A' v, A i' = 0."""
        a, n = self.incidence, self.nodes - 1
        matrix = np.block([[np.diag(self.L), -a.T], [a, np.zeros((n, n))]])
        found = np.linalg.solve(matrix, np.concatenate([-self.R * self.i - self.q / self.C, np.zeros(n)]))
        return found[: self.branches], found[self.branches :]


@pytest.mark.parametrize("seed", spread(range(6), 2))
def test_currents_and_potentials_of_a_random_circuit(seed: int) -> None:
    circuit = _Circuit(seed)
    rates, potentials = circuit.solved()
    for shuffle in range(2):
        model = lagdsl.compile(circuit.text(np.random.default_rng(100 * seed + shuffle)))
        q, qd = np.append(circuit.q, 0.0), np.append(circuit.i, 0.0)
        np.testing.assert_allclose(model.forward_dynamics(0.0, q, qd), np.append(rates, 0.0), atol=1e-11)
        np.testing.assert_allclose(model.output(0.0, q, qd), potentials, atol=1e-11)


SHAFTS = """
model Shafts
  import Lag.Rotational.*;
  {components}
  {connections}
end Shafts;
"""


@pytest.mark.parametrize("seed", spread(range(4), 2))
def test_the_order_of_components_and_connections_does_not_change_the_motion(seed: int) -> None:
    components = [
        "Rotor engine(J = 2 kg.m2, phi(start = 0.1));",
        "Rotor wheel(J = 1 kg.m2, phi(der(start = 3 rad/s)));",
        "SpringDamper shaft(k = 50 N.m/rad, c = 1 N.m.s/rad);",
        "Gear gear(ratio = 3);",
        "Bearing bearing(c = 0.5 N.m.s/rad);",
    ]
    sets = [["engine.phi", "shaft.phi_a"], ["shaft.phi_b", "gear.phi_a"], ["gear.phi_b", "wheel.phi", "bearing.phi"]]
    known = _end_of_shafts(components, sets)
    order = np.random.default_rng(seed)
    order.shuffle(components)
    for each in sets:
        order.shuffle(each)
    order.shuffle(sets)
    np.testing.assert_allclose(_end_of_shafts(components, sets), known, rtol=1e-9)


def _end_of_shafts(components: list[str], sets: list[list[str]]) -> list[float]:
    connections = "\n  ".join(f"connect({', '.join(each)});" for each in sets)
    outputs = "\n  output Angle a = engine.phi, b = wheel.phi, c = shaft.phi_b;"
    text = SHAFTS.format(components="\n  ".join(components), connections=connections + outputs)
    motion = lagdsl.compile(text).simulate(stop=1.0, interval=1.0, tolerance=1e-11)
    return [float(motion[name][-1]) for name in "abc"]


MOTOR_ON_A_LOOP = """
model MotorOnALoop
  import Lag.Planar.*;
  import Lag.Electrical.*;
  Link crank(l = 0.4 m, m = 1 kg), coupler(l = 1 m, m = 2 kg), rocker(l = 0.8 m, m = 1.5 kg);
  Revolute A(q(start = 60 deg, fixed = true)), B(q(start = -30 deg)), C(q(start = -110 deg)), D;
  Lag.Planar.Fixed pin(r = {1 m, 0});
  DCMotor motor(R = 1 Ohm, L = 20 mH, k = 0.2 N.m/A, J = 0.01 kg.m2);
  VoltageSource source(v = 5 V);
  Ground ground;
  gravity = -g_n*world.y;
  connect(world, A, crank, B, coupler, C, rocker, D, pin);
  connect(source.p, motor.p);
  connect(source.n, motor.n, ground.p);
  MERGED
  output Current i = motor.p.i;
end MotorOnALoop;
"""


@pytest.mark.parametrize("joint", ["A", "C"])
def test_a_motor_on_a_joint_of_a_loop_is_one_tied_to_it_by_a_constraint(joint: str) -> None:
    """Whether the joint is kept or cut, its coordinate is that of the motor."""
    found = []
    for text in (f"connect(motor.phi, {joint}.q);", f"constraint shaft: der(motor.phi) = der({joint}.q);"):
        model = lagdsl.compile(MOTOR_ON_A_LOOP.replace("MERGED", text), engine="tape")
        motion = model.simulate(stop=0.2, interval=0.1, tolerance=1e-9)
        found.append(np.array([motion["A.q"], motion["i"]]))
    np.testing.assert_allclose(found[0], found[1], atol=1e-8)
