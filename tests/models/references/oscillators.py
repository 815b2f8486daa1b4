"""Oscillators, cars, machines of pulleys."""

from collections.abc import Mapping

import numpy as np
from scipy.linalg import expm

from models.references.integrate import G_N, Floats, solve

Parameters = Mapping[str, float]


def disc_on_cart(p: Parameters, t: Floats) -> dict[str, Floats]:
    """The disc follows with a third of its mass: omega^2 = k/(M + m/3)."""
    x = 0.1 * np.cos(np.sqrt(p["k"] / (p["M"] + p["m"] / 3)) * t)
    return {"x": x, "phi": -2 / 3 * (x - 0.1) / p["r"]}


def atwood(p: Parameters, t: Floats) -> dict[str, Floats]:
    a = (p["m1"] - p["m2"]) * G_N / (p["m1"] + p["m2"] + p["J"] / p["R"] ** 2)
    return {"y1": 1 + a * t**2 / 2, "y2": 1 - a * t**2 / 2, "tension2": p["m2"] * (G_N + a) + 0 * t}


def double_atwood(p: Parameters, t: Floats) -> dict[str, Floats]:
    """Newton's law for each mass, tension T of the lower rope, 2 T of the upper: unknowns x'', y'', T."""
    m1, m2, m3 = p["m1"], p["m2"], p["m3"]
    matrix = [[m1, 0, 2], [-m2, m2, 1], [-m3, -m3, 1]]
    x, y, _ = np.linalg.solve(matrix, [m1 * G_N, m2 * G_N, m3 * G_N])
    return {"x": 1 + x * t**2 / 2, "y": 0.5 + y * t**2 / 2}


def coupled_oscillators(p: Parameters, t: Floats) -> dict[str, Floats]:
    """Normal modes: in phase k/m, in opposition (k + 2 kc)/m."""
    together = np.cos(np.sqrt(p["k"] / p["m"]) * t)
    against = np.cos(np.sqrt((p["k"] + 2 * p["kc"]) / p["m"]) * t)
    return {"x[1]": 0.05 * (together + against), "x[2]": 0.05 * (together - against)}


def quarter_car(p: Parameters, t: Floats) -> dict[str, Floats]:
    """Linear: matrix exponential; the road steps by 5 cm."""
    ms, mu, ks, kt, cs = p["ms"], p["mu"], p["ks"], p["kt"], p["cs"]
    sky = p["csky"]
    a = np.array(
        [
            [0, 0, 1, 0],
            [0, 0, 0, 1],
            [-ks / ms, ks / ms, -(cs + sky) / ms, cs / ms],
            [ks / mu, -(ks + kt) / mu, (cs + sky) / mu, -cs / mu],
        ]
    )
    rest = np.array([0.05, 0.05, 0, 0])
    x = np.array([rest - expm(a * time) @ rest for time in t]).T
    return {"zs": x[0], "zu": x[1], "tyre": kt * (0.05 - x[1]), "comfort": (a @ (x - rest[:, None]))[2]}


def viscoelastic_mount(p: Parameters, t: Floats) -> dict[str, Floats]:
    """The knot is at y = (k1 x + k2 s)/(k0 + k1 + k2); c (x' - s') = k2 (s - y); matrix exponential of x, s, x'."""
    k0, k1, k2 = p["k0"], p["k1"], p["k2"]
    y = np.array([k1, k2, 0.0]) / (k0 + k1 + k2)
    s = np.array([0.0, 1.0, 0.0])
    pull = k2 * (s - y)
    a = np.array([[0.0, 0.0, 1.0], np.array([0.0, 0.0, 1.0]) - pull / p["c"], -k0 * y / p["m"]])
    states = np.array([expm(a * time) @ [0.02, 0.0, 0.0] for time in t]).T
    return {"x": states[0], "s": states[1], "y": y @ states, "base": k0 * y @ states}


def maglev(p: Parameters, t: Floats) -> dict[str, Floats]:
    """m gap'' = m g - K i^2/(2 gap^2), d((L0 + K/gap) i)/dt = v - R i."""
    m, R, L0, K, ref = p["m"], p["R"], p["L0"], p["K"], p["ref"]

    def rates(_: float, x: Floats) -> list[float]:
        gap, speed, i, xi = x
        v = p["bias"] + p["kp"] * (gap - ref) + p["ki"] * xi + p["kd"] * speed
        return [
            speed,
            G_N - K * i**2 / (2 * m * gap**2),
            (v - R * i + K / gap**2 * speed * i) / (L0 + K / gap),
            gap - ref,
        ]

    x = solve(rates, [0.012, 0, 0.7, 0], t)
    return {"gap": x[0], "der(q)": x[2], "xi": x[3]}


def van_der_pol(p: Parameters, t: Floats) -> dict[str, Floats]:
    mu, tau = p["mu"], p["tau"]
    x = solve(lambda _, x: [x[1] / tau, (mu * (1 - x[0] ** 2) * x[1] - x[0]) / tau], [2, 0], t)
    return {"x": x[0], "y": x[1]}


def disc_on_rotating_plate(p: Parameters, t: Floats) -> dict[str, Floats]:
    """omega^2 = (k - m Omega^2)/(m + m/2)."""
    return {"s": 0.1 * np.cos(np.sqrt((p["k"] - p["m"] * p["Omega"] ** 2) / (1.5 * p["m"])) * t)}


def two_masses_and_spring(p: Parameters, t: Floats) -> dict[str, Floats]:
    """Center of mass and relative motion apart."""
    m1, m2, k, c, rest = p["m1"], p["m2"], p["k"], p["c"], p["rest"]
    reduced = m1 * m2 / (m1 + m2)

    def rates(_: float, x: Floats) -> Floats:
        d, v = x[:2], x[2:]
        s = np.hypot(*d)
        return np.concatenate([v, -(k * (s - rest) + c * (d @ v) / s) / reduced * d / s])

    x = solve(rates, [0.7, 0, 0, 0.6], t)
    center = np.array([0 * t + m2 * 0.7, m2 * 0.6 * t]) / (m1 + m2)
    first, second = center - m2 / (m1 + m2) * x[:2], center + m1 / (m1 + m2) * x[:2]
    return {"x1": first[0], "y1": first[1], "x2": second[0], "y2": second[1], "stretch": np.hypot(x[0], x[1]) - rest}


def centrifugal_governor(p: Parameters, t: Floats) -> dict[str, Floats]:
    """Equilibrium: cos(theta) = (m + ms) g/(m l Omega^2)."""
    return {"theta": np.arccos((p["m"] + p["ms"]) * G_N / (p["m"] * p["l"] * p["Omega"] ** 2)) + 0 * t}


def three_masses(p: Parameters, t: Floats) -> dict[str, Floats]:
    """Standing waves: frequency 2 sqrt(k/m) sin(n pi/8), shape sin(i n pi/4) (Landau, Lifshitz, Mechanics, 23)."""
    n, i = np.arange(1, 4), np.arange(1, 4)[:, None]
    shapes = np.sin(i * n * np.pi / 4) / np.sqrt(2)
    waves = np.cos(np.outer(2 * np.sqrt(p["k"] / p["m"]) * np.sin(n * np.pi / 8), t))
    x = 0.05 * shapes @ (shapes[0][:, None] * waves)
    return {f"x[{k + 1}]": x[k] for k in range(3)}


def ziegler_column(p: Parameters, t: Floats) -> dict[str, Floats]:
    """Newton's equations of both masses without small angles; the follower force works on the lower link only."""
    inertia, c, moment = p["m"] * p["l"] ** 2, p["c"], p["P"] * p["l"]

    def rates(_: float, x: Floats) -> list[float]:
        a, b, da, db = x
        s, k = np.sin(a - b), np.cos(a - b)
        right = [moment * s - inertia * s * db**2 - c * (2 * a - b), inertia * s * da**2 - c * (b - a)]
        dda, ddb = np.linalg.solve(inertia * np.array([[3, k], [k, 1]]), right)
        return [da, db, dda, ddb]

    x = solve(rates, [np.radians(1), 0, 0, 0], t)
    return {"a": x[0], "b": x[1]}
