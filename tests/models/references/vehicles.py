"""Cars on wavy roads, a skateboard, a crane."""

from collections.abc import Mapping

import numpy as np

from models.references.integrate import G_N, Floats, linear, solve

Parameters = Mapping[str, float]


def quarter_car_of_parts(p: Parameters, t: Floats) -> dict[str, Floats]:
    """Newton's law of two masses; the road by its own oscillator; matrix exponential."""
    ms, mu, ks, cs, kt = p["body.m"], p["wheel.m"], p["strut.k"], p["strut.c"], p["tyre.k"]
    omega = p["omega"]
    a = np.array(
        [
            [0, 0, 1, 0, 0, 0],
            [0, 0, 0, 1, 0, 0],
            [-ks / ms, ks / ms, -cs / ms, cs / ms, 0, 0],
            [ks / mu, -(ks + kt) / mu, cs / mu, -cs / mu, kt / mu, 0],
            [0, 0, 0, 0, 0, omega],
            [0, 0, 0, 0, -omega, 0],
        ]
    )
    x = linear(a, [0, 0, 0, 0, 0, p["wave"]], t)
    return {"body.s": x[0], "wheel.s": x[1]}


def half_car(p: Parameters, t: Floats) -> dict[str, Floats]:
    """Newton and Euler in heave and pitch (nose up) and for both wheels; matrix exponential."""
    m, J, a, b = p["body.m"], p["body.J"], p["body.a"], p["body.b"]
    omega = 2 * np.pi * p["v"] / p["wavelength"]
    lag = 2 * np.pi * (a + b) / p["wavelength"]
    # states: heave, pitch, front wheel, rear wheel, their rates, wave*sin(omega t), wave*cos(omega t)
    stretch_f, stretch_r = np.array([1, a, -1, 0.0]), np.array([1, -b, 0, -1.0])
    strut_f = np.concatenate([p["strut_f.k"] * stretch_f, p["strut_f.c"] * stretch_f, [0, 0]])
    strut_r = np.concatenate([p["strut_r.k"] * stretch_r, p["strut_r.c"] * stretch_r, [0, 0]])
    tyre_f = p["tyre_f.k"] * np.array([0, 0, -1, 0, 0, 0, 0, 0, 1, 0])
    tyre_r = p["tyre_r.k"] * np.array([0, 0, 0, -1, 0, 0, 0, 0, np.cos(lag), -np.sin(lag)])
    matrix = np.zeros((10, 10))
    matrix[:4, 4:8] = np.eye(4)
    matrix[4] = (-strut_f - strut_r) / m
    matrix[5] = (-a * strut_f + b * strut_r) / J
    matrix[6] = (strut_f + tyre_f) / p["wheel_f.m"]
    matrix[7] = (strut_r + tyre_r) / p["wheel_r.m"]
    matrix[8, 9], matrix[9, 8] = omega, -omega
    x = linear(matrix, [0, 0, 0, 0, 0, 0, 0, 0, 0, p["wave"]], t)
    return {"heave": x[0], "pitch": x[1], "wheel_f.s": x[2], "wheel_r.s": x[3], "tread": tyre_f @ x}


def skateboard(p: Parameters, t: Floats) -> dict[str, Floats]:
    """Kane's equations in forward speed u and lean rate, in axes that turn with the heading.

    Yaw rate and side speed follow from the trucks (Hubbard, J. Applied Mechanics 46 (1979) 931; Kremnev, Kuleshov,
    ENOC 2008): yaw = -u (tan f + tan r) sin(lean)/(2 a), side = -u (tan f - tan r) sin(lean)/2.
    """
    m, h, k, a = p["m"], p["h"], p["k"], p["a"]
    front, rear = np.tan(p["front"]), np.tan(p["rear"])
    yaw, side = -(front + rear) / (2 * a), -(front - rear) / 2
    Ix, Iy, Iz = p["I[1]"], p["I[2]"], p["I[3]"]

    def rates(_: float, x: Floats) -> list[float]:
        heading, lean, u, w = x[2:]
        s, c = np.sin(lean), np.cos(lean)
        turn = yaw * s * u
        # velocity of the mass center (1 + yaw h s^2) u, side s u - h c w, -h s w and how it depends on u and w
        velocity = np.array([(1 + yaw * h * s**2) * u, side * s * u - h * c * w, -h * s * w])
        by_u, by_w = np.array([1 + yaw * h * s**2, side * s, 0]), np.array([0, -h * c, -h * s])
        bias = w * np.array([2 * yaw * h * s * c * u, side * c * u + h * s * w, -h * c * w])
        bias = bias + np.cross([0, 0, turn], velocity)
        # the same for the angular velocity, in axes of the deck
        omega = np.array([w, turn * s, turn * c])
        spin_u, spin_w = np.array([0, yaw * s**2, yaw * s * c]), np.array([1.0, 0, 0])
        spin_bias = w * u * yaw * np.array([0, 2 * s * c, c**2 - s**2])
        inertia = np.array([Ix, Iy, Iz])
        moment = inertia * spin_bias + np.cross(omega, inertia * omega)
        mass = [
            [m * by_u @ by_u + spin_u @ (inertia * spin_u), m * by_u @ by_w],
            [m * by_u @ by_w, m * by_w @ by_w + spin_w @ (inertia * spin_w)],
        ]
        forces = [
            -m * bias @ by_u - moment @ spin_u,
            m * G_N * h * s - k * lean - m * bias @ by_w - moment @ spin_w,
        ]
        v = side * s * u
        return [
            u * np.cos(heading) - v * np.sin(heading),
            u * np.sin(heading) + v * np.cos(heading),
            turn,
            w,
            *np.linalg.solve(mass, forces),
        ]

    x = solve(rates, [0, 0, 0, np.radians(6), 3, 0], t)
    return {"x": x[0], "y": x[1], "heading": x[2], "lean": x[3], "speed": x[4]}


def crane_with_motor(p: Parameters, t: Floats) -> dict[str, Floats]:
    """Newton's law along the rail, moments about the pivot, armature circuit; the motor turns by N s."""
    l, M, m, J = p["l"], p["trolley.m"], p["load.m"], p["load.Izz"]
    R, L, k = p["motor.R"], p["motor.L"], p["motor.k"]
    N = p["gear.ratio"] / p["pinion.r"]

    def accelerations(x: Floats) -> tuple[float, float]:
        _, angle, _, w, i = x
        s, c = np.sin(angle), np.cos(angle)
        matrix = [[M + m + p["motor.J"] * N**2, m * l * c], [m * l * c, m * l**2 + J]]
        along, about = np.linalg.solve(matrix, [N * k * i + m * l * s * w**2, -m * G_N * l * s])
        return float(along), float(about)

    def rates(_: float, x: Floats) -> list[float]:
        s, angle, v, w, i = x
        voltage = p["kp"] * (p["target"] - s) - p["kd"] * v + p["kq"] * angle
        return [v, w, *accelerations(x), (voltage - R * i - k * N * v) / L]

    x = solve(rates, [0, np.radians(5), 0, 0, 0], t)
    along = np.array([accelerations(column)[0] for column in x.T])
    return {"rail.s": x[0], "pivot.q": x[1], "i": x[4], "push": N * (k * x[4] - p["motor.J"] * N * along)}
