"""The slider-crank with an elastic rod by hand, and its gradient: an independent formulation and integrator.

Matrices and forces are those of the IVP Test Set, problem crank, without damping. The four coordinates of the rod are
independent here: its angle and the slider follow from them in closed form, so that there are no multipliers. Gauss's
collocation integrates them, with complex steps along the parameters.

Sources: B. Simeon, Math. Modelling of Systems 2 (1996) 1, and F. Mazzia, C. Magherini, Test Set for Initial Value
Problem Solvers (2008) (the equations); Hairer, Lubich and Wanner, Geometric Numerical Integration, 2nd ed., section
II.1 (Gauss's collocation); Squire and Trapp, SIAM Review 40 (1998) 110 (complex steps).
"""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

Array = NDArray[np.complex128]

PARAMETERS = {
    **{"Omega": 150.0, "l1": 0.15, "l2": 0.3, "b": 8e-3, "h": 8e-3, "m2": 0.151104, "m3": 0.075552},
    **{"J2": 0.0045339259, "E": 2e11, "rho": 7870.0},
}
PI = 3.1415927  # as the source has it
START = (0.0, 0.0, 1.03339863e-5, 1.69327969e-5, 0.444896105, 4.63434311e-3, -1.78591076e-6, -2.68938672e-6)
COLUMNS = ("psi", "x", "w1", "w2", "u1", "u2", "der(w1)", "der(w2)", "der(u1)", "der(u2)")
_SMALL = 1e-30
_STAGES = 10

# By the mass of the rod; B is that of Coriolis forces, C1, C2, C12 and C21 the vectors c of the source.
M = np.array([[0.5, 0, 0, 0], [0, 0.5, 0, 0], [0, 0, 8, 1], [0, 0, 1, 2]])
B = np.zeros((4, 4))
B[0, 2:], B[1, 3] = (-16 / PI**3, 8 / PI**3 - 1 / PI), 0.5 / PI
B -= B.T
C1, C2, C12, C21 = np.array([[0, 0, 2 / 3, 1 / 6], [2 / PI, 0, 0, 0], [0, 0, 1 / 3, 1 / 6], [1 / PI, -0.5 / PI, 0, 0]])
# By E b h / l2: stretching; bending, which has (h / l2)^2 beside it.
STRETCHING = np.array([[0, 0, 0, 0], [0, 0, 0, 0], [0, 0, 16, -8], [0, 0, -8, 7]]) / 3
BENDING = np.diag([1 / 24, 2 / 3, 0, 0]) * PI**4


def _along(a: NDArray[np.float64], x: Array) -> Array:
    """a times the first axis of x."""
    return np.tensordot(a, x, 1)


def rod(p: dict[str, Array], t: Array, u2: Array, rate: Array) -> tuple[Array, ...]:
    """Sine and cosine of psi, its rate, d psi/du2, dx/du2, and the accelerations of psi and x for u2'' = 0."""
    omega, l1, length = p["Omega"], p["l1"], p["l2"] + u2
    up, along = l1 * np.sin(omega * t), l1 * np.cos(omega * t)
    sine = -up / length
    cosine = np.sqrt(1 - sine**2)
    by_psi, by_x = -sine / (length * cosine), cosine + sine**2 / cosine
    turning = -along * omega / (length * cosine) + by_psi * rate
    psi = (up * omega**2 + length * sine * turning**2 - 2 * rate * cosine * turning) / (length * cosine)
    x = -along * omega**2 - length * (cosine * turning**2 + sine * psi) - 2 * rate * sine * turning
    return sine, cosine, turning, by_psi, by_x, psi, x


def rates(p: dict[str, Array], t: Array, y: Array) -> Array:
    """d/dt of the coordinates of the rod and their rates (8, ...)."""
    q, v = y[:4], y[4:]
    omega, l1, l2, m2, m3, J2 = (p[name] for name in ("Omega", "l1", "l2", "m2", "m3", "J2"))
    mass, stiffness = p["rho"] * p["b"] * p["h"] * l2, p["E"] * p["b"] * p["h"] / l2
    sine, cosine, turning, by_psi, by_x, psi, x = rod(p, t, q[3], v[3])
    s = np.sin(omega * t) * cosine - np.cos(omega * t) * sine
    c = np.cos(omega * t) * cosine + np.sin(omega * t) * sine
    inertia = J2 + mass * ((q * _along(M, q)).sum(0) + 2 * l2 * _along(C12, q))
    coupling = mass * (l2 * np.multiply.outer(C21, np.ones_like(q[0])) - _along(B, q))
    torque = 0.5 * l1 * l2 * m2 * omega**2 * s + mass * l1 * omega**2 * (s * _along(C1, q) - c * _along(C2, q))
    torque -= mass * (2 * turning * (l2 * _along(C12, v) + (v * _along(M, q)).sum(0)) + (v * _along(B, v)).sum(0))
    force = mass * (
        turning**2 * (_along(M, q) + np.multiply.outer(C12, l2 * np.ones_like(q[0])))
        + l1 * omega**2 * (np.multiply.outer(C1, c) + np.multiply.outer(C2, s))
        + 2 * turning * _along(B, v)
    )
    force -= stiffness * (_along(STRETCHING, q) + (p["h"] / l2) ** 2 * _along(BENDING, q))
    # psi'' = by_psi u2'' + psi and x'' = by_x u2'' + x: their equations, along u2.
    matrix = np.multiply.outer(M, mass * np.ones_like(q[0]))
    matrix[3] += coupling * by_psi
    matrix[:, 3] += coupling * by_psi
    matrix[3, 3] += inertia * by_psi**2 + m3 * by_x**2
    force -= coupling * psi
    force[3] += by_psi * (torque - inertia * psi) - m3 * by_x * x
    solved = np.linalg.solve(np.moveaxis(matrix, (0, 1), (-2, -1)), np.moveaxis(force, 0, -1)[..., None])[..., 0]
    return np.concatenate([v, np.moveaxis(solved, -1, 0)])


def gradient(stop: float, steps: int) -> Array:
    """a d/da of COLUMNS at `stop` (10, 10), for each parameter a in turn."""
    count = len(PARAMETERS)
    p = {
        name: np.where(np.arange(count) == i, value * (1 + 1j * _SMALL), value + 0j)
        for i, (name, value) in enumerate(PARAMETERS.items())
    }
    y = _integrated(p, np.repeat(np.array(START, complex)[:, None], count, axis=1), stop / steps, steps)
    sine, cosine, *_ = rod(p, stop, y[3], y[7])
    x = p["l1"] * np.cos(p["Omega"] * stop) + (p["l2"] + y[3]) * cosine
    return np.concatenate([[np.arcsin(sine), x], y]).imag / _SMALL


def _integrated(p: dict[str, Array], y: Array, h: float, steps: int) -> Array:
    """y (8, columns) after so many steps of length h."""
    nodes, weights = (
        (each + shift) / 2 for each, shift in zip(np.polynomial.legendre.leggauss(_STAGES), (1, 0), strict=True)
    )
    matrix = np.array([weights * node @ _basis(nodes, nodes * node) for node in nodes])
    ahead = _basis(nodes, 1 + nodes)
    slopes = np.zeros((_STAGES, *y.shape), complex)
    for step in range(steps):
        newton = np.linalg.inv(np.eye(_STAGES * len(y)) - h * np.kron(matrix, _jacobian(p, (step + 0.5) * h, y)))
        size, before = 1.0, np.inf
        while size > 1e-14 and (size > 1e-10 or size < before / 2):
            stages = np.moveaxis(y + h * np.tensordot(matrix, slopes, 1), 1, 0)
            left = np.moveaxis(rates(p, (step + nodes[:, None]) * h, stages), 0, 1) - slopes
            change = (newton @ left.reshape(_STAGES * len(y), -1)).reshape(slopes.shape)
            slopes = slopes + change
            before, size = (
                size,
                max(np.abs(part(change)).max() / (np.abs(part(slopes)).max() + 1e-300) for part in (np.real, np.imag)),
            )
        y = y + h * np.tensordot(weights, slopes, 1)
        slopes = np.tensordot(ahead, slopes, 1)
    return y


def _basis(nodes: NDArray[np.float64], at: NDArray[np.float64]) -> NDArray[np.float64]:
    """Lagrange's polynomials of the nodes (second axis) at these places (first)."""
    others = [np.delete(nodes, i) for i in range(len(nodes))]
    return np.array(
        [[np.prod((t - rest) / (node - rest)) for node, rest in zip(nodes, others, strict=True)] for t in at]
    )


def _jacobian(p: dict[str, Array], t: float, y: Array) -> NDArray[np.float64]:
    """Of the rates by y, at the first column."""
    real = {name: np.full(len(y), value[0].real, complex) for name, value in p.items()}
    return rates(real, t, y[:, :1].real + 1j * _SMALL * np.eye(len(y))).imag / _SMALL
