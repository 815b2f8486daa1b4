"""A transformer with little leakage: a fast decay beside a slow one, which an implicit method steps over."""

from __future__ import annotations

import pytest
from mpmath import cos, eig, lu_solve, matrix, mp, mpf, sin

import lagdsl

STOP = 0.02
TEXT = """
model Loaded
  import Lag.Electrical.*;
  CoupledInductors core(L1 = 1 H, L2 = 0.25 H, coupling = 1 - {leak});
  VoltageSource source(v = 10 V*sin(314 rad/s*time));
  Resistor Ri(R = 0.1 Ohm), load(R = 10 Ohm);
  Ground ground1, ground2;
  connect(source.p, Ri.p);
  connect(Ri.n, core.p1);
  connect(source.n, core.n1, ground1.p);
  connect(load.p, core.p2);
  connect(load.n, core.n2, ground2.p);
  output Voltage u2 = load.p.v;
end Loaded;
"""


def voltage(leak: float) -> float:
    """L i' + R i = {{10 sin(314 t), 0}}: a forced oscillation, and the two decays that cancel it at the start."""
    with mp.workdps(60):
        k, omega, t = 1 - mpf(repr(leak)), mpf(314), mpf(repr(STOP))
        mutual = k * mpf("0.5")
        inductance = matrix([[1, mutual], [mutual, mpf("0.25")]])
        resistance = matrix([[mpf("0.1"), 0], [0, 10]])
        whole = matrix(4, 4)  # sine and cosine parts of i
        for i in range(2):
            for j in range(2):
                whole[i, j] = whole[2 + i, 2 + j] = resistance[i, j]
                whole[i, 2 + j], whole[2 + i, j] = -omega * inductance[i, j], omega * inductance[i, j]
        found = lu_solve(whole, matrix([10, 0, 0, 0]))
        rates, ways = eig(-(inductance**-1) * resistance)
        parts = lu_solve(ways, -matrix([found[2], found[3]]))
        current = found[1] * sin(omega * t) + found[3] * cos(omega * t)
        current += sum(ways[1, m] * parts[m] * mp.exp(rates[m] * t) for m in range(2))
        return float((-10 * current).real)


@pytest.mark.parametrize("leak", [1e-3, 1e-7])
@pytest.mark.parametrize("tolerance", [1e-8, 1e-11])
def test_voltage_and_number_of_steps(leak: float, tolerance: float) -> None:
    motion = lagdsl.compile(TEXT.format(leak=leak)).simulate(stop=STOP, tolerance=tolerance)
    assert motion["u2"][-1] == pytest.approx(voltage(leak), rel=0, abs=0.01 * tolerance)
    if leak == 1e-7:
        assert motion.statistics.steps < 200
