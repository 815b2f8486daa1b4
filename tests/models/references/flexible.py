"""Beams, by their own equations: places as complex numbers, forces of elements as in the literature."""

from collections.abc import Mapping

import numpy as np

from models.references.integrate import G_N, Floats, solve

Parameters = Mapping[str, float]


def flexible_arm(p: Parameters, t: Floats) -> dict[str, Floats]:
    """Deflection by x^2 and x^3, the displaced axis to second order; mass and inertia forces from 20 points."""
    length, area, inertia = p["arm.L"], p["arm.A"], p["arm.I"]
    modulus, density, ball = p["arm.E"], p["arm.density"], p["weight.m"]
    points, weights = np.polynomial.legendre.leggauss(20)
    x = np.append((1 + points) / 2, 1.0) * length
    mass = np.append(weights / 2 * density * area * length, ball)
    turning = np.append(weights / 2 * density * inertia * length, 0.0)
    # w = L (q1 (s^2/2) + q2 (s^3/3 - s^2/2)) with s = x/L, w' = q1 s + q2 (s^2 - s)
    s = x / length
    deflection = length * np.array([s**2 / 2, s**3 / 3 - s**2 / 2])
    slope = np.array([s, s**2 - s])
    shortening = length * np.array(
        [
            [s**3 / 3, s**4 / 4 - s**3 / 3],
            [s**4 / 4 - s**3 / 3, s**5 / 5 - s**4 / 2 + s**3 / 3],
        ]
    )
    stiffness = modulus * inertia / length * np.array([1.0, 1 / 3])
    first = (1.8751040687119611 / length) ** 2 * np.sqrt(modulus * inertia / (density * area))
    damping = 2 * p["arm.zeta"] / first * stiffness
    # the load is spread over the beam, not over the ball
    force = np.append(weights / 2 * length, 0.0) * 0.4 - 1j * G_N * mass

    def rates(_: float, state: Floats) -> Floats:
        theta, q, v = state[0], state[1:3], state[3:]
        turn = np.exp(1j * theta)
        pulled = np.einsum("ijp,j->ip", shortening, q)
        place = turn * (x - q @ pulled / 2 + 1j * (q @ deflection))
        along = turn * (-pulled + 1j * deflection)
        jacobian = np.vstack([1j * place, along])
        # second derivatives along the rates
        bend = -turn * np.einsum("ijp,i,j->p", shortening, v[1:], v[1:])
        bias = -(v[0] ** 2) * place + 2j * v[0] * (v[1:] @ along) + bend
        turns = np.vstack([np.ones_like(x), slope])
        matrix = np.real(jacobian.conj() * mass @ jacobian.T) + turns * turning @ turns.T
        right = np.real(jacobian.conj() @ (force - mass * bias))
        right[1:] -= stiffness * q + damping * v[1:]
        return np.concatenate([v, np.linalg.solve(matrix, right)])

    found = solve(rates, [np.radians(-60), 0, 0, 0, 0, 0], t)
    surface = -modulus * (found[1] + found[2] * 0.0) / length * np.sqrt(3 * inertia / area)
    return {
        "pin.q": found[0],
        "arm.q[1]": found[1],
        "arm.q[2]": found[2],
        "root": modulus * inertia / length * (found[1] - found[2]),
        "surface": surface,
    }


def flexible_strip(p: Parameters, t: Floats) -> dict[str, Floats]:
    """Forces of Simo and Vu-Quoc's element and the consistent masses of linear elements."""
    count, length = 4, p["strip.L"]
    l, area, inertia = length / count, p["strip.A"], p["strip.I"]
    normal, side, bending = p["strip.E"] * area, p["strip.k_s"] * p["strip.G"] * area, p["strip.E"] * inertia
    twice, density = 2 * p["strip.zeta"], p["strip.density"]
    bends = twice * (length / 1.8751040687119611) ** 2 * np.sqrt(density * area / bending)
    stretches = twice * 2 * length / np.pi * np.sqrt(density / p["strip.E"])
    shears = twice * np.sqrt(density * inertia / side)
    element = density * l / 6 * np.array([[2.0, 1.0], [1.0, 2.0]])
    shape = np.zeros((count + 1, count + 1))
    for i in range(count):
        shape[i : i + 2, i : i + 2] += element
    masses, turning = (shape * area)[1:, 1:], (shape * inertia)[1:, 1:]
    weight = (shape * area).sum(axis=1)[1:] * G_N
    weight[1] += p["weight.m"] * G_N
    masses[1, 1] += p["weight.m"]

    def rates(_: float, state: Floats) -> Floats:
        x, y, q, vx, vy, vq = state.reshape(6, count)
        step = np.diff(np.append(0, x + 1j * y))
        speed = np.diff(np.append(0, vx + 1j * vy))
        angle, spin = np.append(0, q), np.append(0, vq)
        middle = np.exp(1j * (angle[1:] + angle[:-1]) / 2)
        strain = np.conj(middle) * step / l - 1
        changes = np.conj(middle) * (speed - 1j * step * (spin[1:] + spin[:-1]) / 2) / l
        tension = normal * (strain.real + stretches * changes.real)
        across = side * (strain.imag + shears * changes.imag)
        force = middle * (tension + 1j * across)
        moment = bending / l * (np.diff(angle) + bends * np.diff(spin))
        lever = np.imag(np.conj(step) * force) / 2
        on_nodes = np.append(force[1:], 0) - force - 1j * weight
        on_sections = np.append(moment[1:] + lever[1:], 0) - moment + lever
        a = np.linalg.solve(masses, on_nodes)
        return np.concatenate([vx, vy, vq, a.real, a.imag, np.linalg.solve(turning, on_sections)])

    places = np.arange(1, count + 1) * l
    found = solve(rates, [*places, *np.zeros(5 * count)], t)
    x, y, q = found[:count], found[count : 2 * count], found[2 * count : 3 * count]
    middle = np.exp(-1j * (q[0] + q[1]) / 2)
    slide = np.imag(middle * (x[1] - x[0] + 1j * (y[1] - y[0]))) / l
    columns = {f"strip.{name}[{i + 1}]": row[i] for name, row in (("x", x), ("y", y), ("q", q)) for i in range(count)}
    return {**columns, "root": bending / l * q[0], "side": side * slide}
