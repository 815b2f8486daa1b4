"""Beams, by their own equations: places as complex numbers, forces of elements as in the literature."""

from collections.abc import Mapping

import numpy as np
from numpy.typing import NDArray

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
    """Elements of Simo and Vu-Quoc with consistent masses."""
    x, y, q, inner, moment = _bending(p, t, "strip", p["strip.I"], lumped=False)
    columns = {f"strip.{name}[{i + 1}]": row[i] for name, row in (("x", x), ("y", y), ("q", q)) for i in range(_COUNT)}
    return {**columns, "root": moment[0], "side": inner[1].imag}


def flexible_rod(p: Parameters, t: Floats) -> dict[str, Floats]:
    """The same elements, in the plane of x and the weight, which a round rod does not leave."""
    down = np.array([-0.8, 0.6])
    x, y, q, inner, moment = _bending(p, t, "rod", p["rod.Iy"], lumped=True)
    columns = {f"rod.x[{i + 1}]": x[i] for i in range(_COUNT)}
    for name, part, axis in (("y", down[0], down[1]), ("z", down[1], -down[0])):
        columns |= {f"rod.{name}[{i + 1}]": -y[i] * part for i in range(_COUNT)}
        number = 3 if name == "y" else 4
        columns |= {f"rod.e[{i + 1},{number}]": np.sin(q[i] / 2) * axis for i in range(_COUNT)}
    columns |= {f"rod.e[{i + 1},1]": np.cos(q[i] / 2) for i in range(_COUNT)}
    columns |= {"root[2]": moment[0] * down[1], "root[3]": -moment[0] * down[0]}
    return {
        **columns,
        "side[1]": inner[1].real,
        "side[2]": -inner[1].imag * down[0],
        "side[3]": -inner[1].imag * down[1],
    }


_COUNT = 4


def _bending(
    p: Parameters, t: Floats, name: str, inertia: float, *, lumped: bool
) -> tuple[Floats, Floats, Floats, NDArray[np.complex128], Floats]:
    """Places and angles of the nodes, forces in axes of the sections and moments in the elements; weight along -y."""
    length, area, density = p[f"{name}.L"], p[f"{name}.A"], p[f"{name}.density"]
    l, twice = length / _COUNT, 2 * p[f"{name}.zeta"]
    normal, side = p[f"{name}.E"] * area, p[f"{name}.k_s"] * p[f"{name}.G"] * area
    bending = p[f"{name}.E"] * inertia
    bends = twice * (length / 1.8751040687119611) ** 2 * np.sqrt(density * area / bending)
    stretches = twice * 2 * length / np.pi * np.sqrt(density / p[f"{name}.E"])
    shears = twice * np.sqrt(density * inertia / side)
    shape = np.zeros((_COUNT + 1, _COUNT + 1))
    for i in range(_COUNT):
        shape[i : i + 2, i : i + 2] += density * l / 6 * np.array([[2.0, 1.0], [1.0, 2.0]])
    masses, turning = (shape * area)[1:, 1:], (shape * inertia)[1:, 1:]
    if lumped:
        turning = np.diag((shape * inertia).sum(axis=1)[1:])
    weight = (shape * area).sum(axis=1)[1:] * G_N
    weight[1] += p["weight.m"] * G_N
    masses[1, 1] += p["weight.m"]

    def strains(x: Floats, y: Floats, q: Floats) -> tuple[NDArray[np.complex128], ...]:
        step = np.diff(x + 1j * y, prepend=0, axis=0)
        middle = np.exp(1j * (q + np.concatenate([np.zeros_like(q[:1]), q[:-1]])) / 2)
        return step, middle, np.conj(middle) * step / l - 1

    def rates(_: float, state: Floats) -> Floats:
        x, y, q, vx, vy, vq = state.reshape(6, _COUNT)
        step, middle, strain = strains(x, y, q)
        speed, spin = np.diff(np.append(0, vx + 1j * vy)), np.append(0, vq)
        changes = np.conj(middle) * (speed - 1j * step * (spin[1:] + spin[:-1]) / 2) / l
        tension = normal * (strain.real + stretches * changes.real)
        across = side * (strain.imag + shears * changes.imag)
        force = middle * (tension + 1j * across)
        moment = bending / l * (np.diff(np.append(0, q)) + bends * np.diff(spin))
        lever = np.imag(np.conj(step) * force) / 2
        on_nodes = np.append(force[1:], 0) - force - 1j * weight
        on_sections = np.append(moment[1:] + lever[1:], 0) - moment + lever
        a = np.linalg.solve(masses, on_nodes)
        return np.concatenate([vx, vy, vq, a.real, a.imag, np.linalg.solve(turning, on_sections)])

    found = solve(rates, [*(np.arange(1, _COUNT + 1) * l), *np.zeros(5 * _COUNT)], t)
    x, y, q = found[: 3 * _COUNT].reshape(3, _COUNT, -1)
    strain = strains(x, y, q)[2]
    return x, y, q, normal * strain.real + 1j * side * strain.imag, bending / l * np.diff(q, prepend=0, axis=0)


def flexible_blade(p: Parameters, t: Floats) -> dict[str, Floats]:
    """Lagrange's equations of the angle and of one amplitude; the point mass at the end moves across the blade."""
    m, length, ball = 0.2, 0.5, p["tip.m"]  # structural
    stiffness = 4 * 0.4 / length**3
    spin = m * length**2 / 12
    weight = np.array([m, ball])

    def rates(_: float, x: Floats) -> list[float]:
        theta, eta, v, u = x
        turn = np.exp(1j * theta)
        place = turn * np.array([length / 2 + 1j * eta / 3, length + 1j * eta])
        along = turn * np.array([1j / 3, 1j])
        bias = -(v**2) * place + 2j * v * u * along
        force = -1j * G_N * weight - weight * bias
        jacobian = np.array([1j * place, along])
        matrix = np.real(jacobian.conj() * weight @ jacobian.T)
        matrix += [[spin, m * length / 12], [m * length / 12, m / 5 - m / 9]]
        right = np.real(jacobian.conj() @ force) - [0, stiffness * (eta + p["blade.beta"] * u)]
        return [v, u, *np.linalg.solve(matrix, right)]

    x = solve(rates, [np.radians(40), 0, 0, 0], t)
    return {"pin.q": x[0], "blade.eta[1]": x[1]}


def flexible_cable(p: Parameters, t: Floats) -> dict[str, Floats]:
    """Hermite's cubics with their mass matrix by hand; forces of Gerstmayr and Irschik at points of Gauss."""
    count = 2
    length, area, density = p["cord.L"], p["cord.A"], p["cord.density"]
    l, axial, bending = length / count, p["cord.E"] * area, p["cord.E"] * area**2 / (4 * np.pi)
    damping = 4 * p["cord.zeta"] * length / np.pi * np.sqrt(density / p["cord.E"])
    size = np.array([1, l, 1, l])
    own = np.array([[156, 22, 54, -13], [22, 4, 13, -3], [54, 13, 156, -22], [-13, -3, -22, 4]]) * np.outer(size, size)
    spread = np.array([1 / 2, l / 12, 1 / 2, -l / 12]) * l
    mass, force = np.zeros((2 * count + 2, 2 * count + 2)), np.zeros((2 * count + 2, 3))
    for i in range(count):
        mass[2 * i : 2 * i + 4, 2 * i : 2 * i + 4] += density * area * l / 420 * own
        force[2 * i : 2 * i + 4] += np.outer(spread, [0.0, -density * area * G_N, 0.1])
    mass[-2, -2] += 0.05
    force[-2, 1] -= 0.05 * G_N
    inverse = np.linalg.inv(mass[1:, 1:])

    def rule(points: int) -> tuple[Floats, Floats, Floats]:
        """Weights, and first and second derivatives of the cubics."""
        x, w = np.polynomial.legendre.leggauss(points)
        x, l1 = (1 + x) / 2, np.ones(points)
        first = np.array([6 * x**2 - 6 * x, l * (3 * x**2 - 4 * x + 1), 6 * x - 6 * x**2, l * (3 * x**2 - 2 * x)]) / l
        second = np.array([12 * x - 6 * l1, l * (6 * x - 4), 6 - 12 * x, l * (6 * x - 2)]) / l**2
        return w / 2 * l, first, second

    stretched, bent = rule(5), rule(3)

    def inner(q: Floats, v: Floats) -> Floats:
        weight, first, _ = stretched
        slope = first.T @ q
        norm = np.linalg.norm(slope, axis=1)
        rate = np.sum(slope * (first.T @ v), axis=1) / norm
        total: Floats = first @ ((weight * axial * (norm - 1 + damping * rate) / norm)[:, None] * slope)
        weight, first, second = bent
        slope, bend = first.T @ q, second.T @ q
        squared = np.sum(slope**2, axis=1)
        turn = np.cross(slope, bend)
        # of |slope x bend|^2 / |slope|^4 by slope and by bend
        scale = (weight * bending / squared**2)[:, None]
        by_slope = np.cross(bend, turn) - 2 * (np.sum(turn**2, axis=1) / squared)[:, None] * slope
        return total + first @ (scale * by_slope) + second @ (scale * np.cross(turn, slope))

    def rates(_: float, state: Floats) -> Floats:
        q, v = np.zeros((2, 2 * count + 2, 3))
        q[1:], v[1:] = state.reshape(2, 2 * count + 1, 3)
        acting = force.copy()
        for i in range(count):
            acting[2 * i : 2 * i + 4] -= inner(q[2 * i : 2 * i + 4], v[2 * i : 2 * i + 4])
        return np.concatenate([state[state.size // 2 :], (inverse @ acting[1:]).ravel()])

    q = np.array([[1, 0, 0], [l, 0, 0], [1, 0, 0], [length, 0, 0], [1, 0, 0]], dtype=float)
    v = np.array([[0, 0, 2], [0, 0, 1], [0, 0, 2], [0, 0, 2], [0, 0, 2]], dtype=float)
    found = solve(rates, [*q.ravel(), *v.ravel()], t)[: q.size].reshape(*q.shape, -1)
    root, a, sa, b, sb = found
    weight, first, _ = stretched
    near = np.array([np.zeros_like(root), root, a, sa])
    strain = np.linalg.norm(np.einsum("ji,jkt->ikt", first, near), axis=1) - 1
    end = 1.5 * (b - a) / l - (sa + sb) / 4
    moment = bending / l * np.cross(end, sb - sa, axis=0) / np.sum(end**2, axis=0)
    columns = {f"cord.r[{i + 1},{k + 1}]": found[2 * i + 1][k] for i in range(count) for k in range(3)}
    columns |= {f"cord.s[{i + 1},{k + 1}]": found[2 * i + 2][k] for i in range(count) for k in range(3)}
    columns |= {f"bent[{k + 1}]": moment[k] for k in range(3)}
    return {**columns, "pull": axial / l * weight @ strain}
