"""Circuits, alone and coupled to shafts and slides: linear systems, written with currents and voltages as unknowns."""

from collections.abc import Mapping

import numpy as np

from models.references.integrate import G_N, Floats, linear

Parameters = Mapping[str, float]


def rlc_circuit(p: Parameters, t: Floats) -> dict[str, Floats]:
    """Damped oscillation: q = q0 exp(-d t) (cos w t + d/w sin w t), i = -q'."""
    C, L, R, q0 = p["C1.C"], p["L1.L"], p["R1.R"], 1e-3
    d = R / (2 * L)
    w = np.sqrt(1 / (L * C) - d**2)
    fading = q0 * np.exp(-d * t)
    q = fading * (np.cos(w * t) + d / w * np.sin(w * t))
    return {"C1.q": q, "u": q / C, "i": fading * (w + d**2 / w) * np.sin(w * t)}


def coupled_circuits(p: Parameters, t: Floats) -> dict[str, Floats]:
    """w^2 from (1 - w^2 L1 C1)(1 - w^2 L2 C2) = w^4 M^2 C1 C2; both modes start with the charge of the first ring."""
    L1, L2, C1, C2 = p["core.L1"], p["core.L2"], p["C1.C"], p["C2.C"]
    M = p["core.coupling"] * np.sqrt(L1 * L2)
    squares = np.roots([(L1 * L2 - M**2) * C1 * C2, -(L1 * C1 + L2 * C2), 1])
    shape = (1 - squares * L1 * C1) / (squares * M * C1)  # q2/q1 of each mode
    parts = np.linalg.solve([[1, 1], shape], [1e-3, 0])
    modes = np.cos(np.sqrt(squares)[:, None] * t)
    return {"u1": parts @ modes / C1, "u2": (parts * shape) @ modes / C2}


def ladder_filter(p: Parameters, t: Floats) -> dict[str, Floats]:
    """States: currents of the three coils, voltages of the two capacitors; the source by its own oscillator."""
    L1, L2, L3 = p["L1.L"], p["L2.L"], p["lead.L"]
    C1, C2, inner, load, omega = p["C1.C"], p["C2.C"], p["inner.R"], p["load.R"], p["omega"]
    a = np.array(
        [
            [-inner / L1, 0, 0, -1 / L1, 0, 1 / L1, 0],
            [0, 0, 0, 1 / L2, -1 / L2, 0, 0],
            [0, 0, -load / L3, 0, 1 / L3, 0, 0],
            [1 / C1, -1 / C1, 0, 0, 0, 0, 0],
            [0, 1 / C2, -1 / C2, 0, 0, 0, 0],
            [0, 0, 0, 0, 0, 0, omega],
            [0, 0, 0, 0, 0, -omega, 0],
        ]
    )
    x = linear(a, [0, 0, 0, 0, 0, 0, p["u0"]], t)
    return {"u1": x[3], "u2": x[4], "i": x[2]}


def tank_circuit(p: Parameters, t: Floats) -> dict[str, Floats]:
    """C u'' + u/L = -i0 w sin w t, u(0) = 0, C u'(0) = i0: free and forced part."""
    L, C, i0, w = p["L1.L"], p["C1.C"], p["i0"], p["omega"]
    w0 = 1 / np.sqrt(L * C)
    forced = -i0 * w / (C * (w0**2 - w**2))
    return {"u": forced * np.sin(w * t) + (i0 / C - forced * w) / w0 * np.sin(w0 * t)}


def dc_motor(p: Parameters, t: Floats) -> dict[str, Floats]:
    """L i' = v - R i - k w, J w' = k i - c w + load: steady state and two exponentials."""
    R, L, k, J, c = p["motor.R"], p["motor.L"], p["motor.k"], p["motor.J"] + p["wheel.J"], p["bearing.c"]
    a = np.array([[-R / L, -k / L], [k / J, -c / J]])
    steady = -np.linalg.solve(a, [12 / L, -0.05 / J])
    poles = np.roots([1, -np.trace(a), np.linalg.det(a)])
    slope = a @ -steady  # at the start, from rest
    first = (slope + poles[1] * steady) / (poles[0] - poles[1])
    x = steady[:, None] + np.outer(first, np.exp(poles[0] * t)) - np.outer(steady + first, np.exp(poles[1] * t))
    return {"i": np.real(x[0]), "w": np.real(x[1])}


def generator(p: Parameters, t: Floats) -> dict[str, Floats]:
    """i = k w/R (1 - exp(-R t/L)); the turbine feels k i."""
    k, R = p["machine.k"], p["load.R"]
    i = k * p["turbine.w"] / R * -np.expm1(-R / p["armature.L"] * t)
    return {"i": i, "effort": k * i}


def voice_coil(p: Parameters, t: Floats) -> dict[str, Floats]:
    R, L, K, m = p["coil.R"], p["coil.L"], p["coil.k"], p["coil.m"] + p["membrane.m"]
    k, c = p["rim.k"], p["rim.c"]
    a = np.array([[0, 1, 0, 0], [-k / m, -c / m, K / m, 0], [0, -K / L, -R / L, 5 / L], [0, 0, 0, 0]])
    x = linear(a, [0, 0, 0, 1], t)
    return {"coil.s": x[0], "i": x[2], "holder": -(k * x[0] + c * x[1])}


def geophone(p: Parameters, t: Floats) -> dict[str, Floats]:
    """m s'' = -k r - K i, L i' = K r' - R i with r = s - y; states s, s', i, y, y'."""
    m, k, K, L, R = p["proof.m"], p["suspension.k"], p["coil.k"], p["winding.L"], p["shunt.R"]
    omega, amplitude = p["omega"], p["amplitude"]
    a = np.array(
        [
            [0, 1, 0, 0, 0],
            [-k / m, 0, -K / m, k / m, 0],
            [0, K / L, -R / L, 0, -K / L],
            [0, 0, 0, 0, 1],
            [0, 0, 0, -(omega**2), 0],
        ]
    )
    x = linear(a, [0, 0, 0, 0, amplitude * omega], t)
    return {"proof.s": x[0], "u": R * x[2]}


def u_tube(p: Parameters, t: Floats) -> dict[str, Floats]:
    """One volume moves: rho l/a V'' = -rho g (V/A1 - V'/A2); the sum of the volumes stays (Bernoulli, unsteady)."""
    left, right = p["left.area"], p["right.area"]
    length, area = p["pipe.length"], p["pipe.area"]
    stiffness = G_N * (1 / left + 1 / right)
    w = np.sqrt(stiffness * area / length)
    level = 50e-6 / (1 + left / right)  # of the right vessel, when both are at one height
    moved = level * (1 - np.cos(w * t))
    bottom = p["left.rho"] * G_N / left * (50e-6 - moved)
    return {"left.V": 50e-6 - moved, "right.V": moved, "pipe.V": moved, "bottom": bottom}


def delay_line(p: Parameters, t: Floats) -> dict[str, Floats]:
    """States: currents of the coils, voltages of the capacitors, current of the load; one section after the other."""
    n = sum(name.startswith("section[") and name.endswith("].R") for name in p)
    a = np.zeros((2 * n + 2, 2 * n + 2))
    for k in range(n):
        L, R, C = (p[f"section[{k + 1}].{name}"] for name in "LRC")
        a[k, k] = -R / L
        a[k, n + k - 1 if k else 2 * n + 1] = 1 / L
        a[k, n + k] = -1 / L
        a[n + k, k] = 1 / C
        a[n + k, k + 1 if k < n - 1 else 2 * n] = -1 / C
    a[2 * n, 2 * n - 1] = 1 / p["tail.L"]
    a[2 * n, 2 * n] = -p["load.R"] / p["tail.L"]
    x = linear(a, [0.0] * (2 * n + 1) + [10.0], t)
    return {f"u[{k + 1}]": x[n + k] for k in range(n)} | {"i": x[2 * n]}
