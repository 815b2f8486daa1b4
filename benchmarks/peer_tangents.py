"""Run in the peers' environment: CVODES by CasADi with forward sensitivities, of the double pendulum by all that its
text names."""

import time

import casadi as ca
import numpy as np

START = (np.radians(30), np.radians(-20), 0.0, 0.0)
VALUES = (1.0, 0.5, 0.5, 0.3)  # m1 m2 l1 l2
REPEATS = 3


def measure(stop, tolerances):
    """A row for every tolerance: CPU seconds of a run, and of one with its derivatives; dx/d(m1, m2, l1, l2, x0)."""
    x, p = ca.SX.sym("x", 4), ca.SX.sym("p", 4)
    start, values = ca.MX.sym("x", 4), ca.MX.sym("p", 4)
    rows = []
    for tolerance in tolerances:
        options = {"abstol": tolerance, "reltol": tolerance, "fsens_err_con": True, "max_num_steps": 1_000_000}
        run = ca.integrator("run", "cvodes", {"x": x, "p": p, "ode": _rates(x, p)}, 0, stop, options)
        end = run(x0=start, p=values)["xf"]
        both = ca.Function("both", [start, values], [ca.jacobian(end, values), ca.jacobian(end, start)])
        alone = min(_timed(lambda run=run: run(x0=START, p=VALUES))[0] for _ in range(REPEATS))
        taken = [_timed(lambda both=both: both(START, VALUES)) for _ in range(REPEATS)]
        found = np.hstack([np.array(block) for block in taken[0][1]])
        rows.append(
            {
                "tolerance": tolerance,
                "run": alone,
                "tangents": min(seconds for seconds, _ in taken),
                "derivatives": found.tolist(),
            }
        )
    return rows


def _rates(x, p):
    """Lagrange's equations of the second kind, from the energies."""
    m1, m2, l1, l2 = (p[k] for k in range(4))
    q, v = x[:2], x[2:]
    first = ca.vertcat(l1 * ca.sin(q[0]), -l1 * ca.cos(q[0]))
    second = first + ca.vertcat(l2 * ca.sin(q[1]), -l2 * ca.cos(q[1]))
    speeds = [ca.jtimes(point, q, v) for point in (first, second)]
    kinetic = (m1 * ca.dot(speeds[0], speeds[0]) + m2 * ca.dot(speeds[1], speeds[1])) / 2
    potential = 9.80665 * (m1 * first[1] + m2 * second[1])
    momenta = ca.gradient(kinetic, v)
    forces = ca.gradient(kinetic - potential, q) - ca.jtimes(momenta, q, v)
    return ca.vertcat(v, ca.solve(ca.jacobian(momenta, v), forces))


def _timed(call):
    start = time.process_time()
    found = call()
    return time.process_time() - start, found
