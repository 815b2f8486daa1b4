"""Mechanisms in space from the component library."""

from collections.abc import Mapping

import numpy as np

from models.references.integrate import G_N, Floats, solve

Parameters = Mapping[str, float]


def _unit(*v: float) -> Floats:
    return np.array(v) / np.linalg.norm(v)


def spatial_universal(p: Parameters, t: Floats) -> dict[str, Floats]:
    """Spherical pendulum in Cartesian coordinates: r'' = g - (v*v + r*g)/l^2*r."""
    l, weight = -p["ball.com[3]"], np.array([0, 0, -G_N])

    def rates(_: float, x: Floats) -> Floats:
        r, v = x[:3], x[3:]
        return np.array([*v, *(weight - (v @ v + r @ weight) / l**2 * r)])

    a = np.radians(50)
    x = solve(rates, [0, l * np.sin(a), -l * np.cos(a), -2 * l, 0, 0], t)
    return {"P[1]": x[0], "P[2]": x[1], "P[3]": x[2]}


def spatial_top(p: Parameters, t: Floats) -> dict[str, Floats]:
    """Euler's equations about the tip, with the axes of the top as unknowns."""
    m, tilt = p["top.m"], np.radians(40)
    center = np.array([0, 0, p["top.r[3]"] / 2])
    inertia = np.diag([p[f"top.I[{k}]"] for k in (1, 2, 3)]) + m * (
        center @ center * np.eye(3) - np.outer(center, center)
    )
    weight = np.array([0, 0, -G_N])

    def turning(axes: Floats, w: Floats) -> Floats:
        moment = np.cross(center, m * axes.T @ weight) - np.cross(w, inertia @ w)
        return np.linalg.solve(inertia, moment)

    def rates(_: float, x: Floats) -> Floats:
        axes, w = x[:9].reshape(3, 3), x[9:]
        spin = np.array([[0, -w[2], w[1]], [w[2], 0, -w[0]], [-w[1], w[0], 0]])
        return np.array([*(axes @ spin).ravel(), *turning(axes, w)])

    c, s = np.cos(tilt), np.sin(tilt)
    x = solve(rates, [1, 0, 0, 0, c, -s, 0, s, c, 1, 2, 60], t)
    support = []
    for row in x.T:
        axes, w = row[:9].reshape(3, 3), row[9:]
        along = axes @ (np.cross(turning(axes, w), center) + np.cross(w, np.cross(w, center)))
        support.append(m * (along - weight))
    columns = {f"axis[{k + 1}]": x[3 * k + 2] for k in range(3)}
    return columns | {f"support[{k + 1}]": np.array(support)[:, k] for k in range(3)}


def spatial_slides(p: Parameters, t: Floats) -> dict[str, Floats]:
    """Constant accelerations along the guides."""
    lead = p["screw.lead"] / (2 * np.pi)
    m = p["nut.m"]
    return {
        "slide.s": 0.4 * G_N * t**2,
        "sleeve.s": G_N / 2 * t**2,
        "sleeve.q": 0.2 / p["collar.I[2]"] / 2 * t**2,
        "screw.q": -m * G_N * lead / (p["nut.I[2]"] + m * lead**2) / 2 * t**2,
        "plate.x": t,
        "plate.y": -G_N * np.sin(np.radians(20)) / 2 * t**2,
        "plate.q": 3 * t,
    }


def spatial_bodies(p: Parameters, t: Floats) -> dict[str, Floats]:
    """Moments of inertia from tables, turned and shifted to the axis of the joint."""

    def about(axis: Floats, mass: float, center: Floats, moments: Floats, axes: Floats) -> Floats:
        own = sum(moment * (axis @ direction) ** 2 for moment, direction in zip(moments, axes, strict=True))
        return 1 / (own + mass * (center @ center - (axis @ center) ** 2)) / 2 * t**2

    r = np.array([0.2, 0.1, -0.2])
    outer, inner = p["tube.diameter"] / 2, p["tube.inner_diameter"] / 2
    mass = p["tube.density"] * np.pi * (outer**2 - inner**2) * 0.3
    across = mass / 12 * (3 * (outer**2 + inner**2) + 0.3**2)
    tube_axes = np.array([_unit(*r), _unit(1, 0, 1), _unit(1, -4, -1)])
    tube_moments = np.array([mass / 2 * (outer**2 + inner**2), across, across])
    first = about(_unit(1, 2, 2), mass, r / 2, tube_moments, tube_axes)

    length, width, height = 0.3, p["box.width"], p["box.height"]
    mass = p["box.density"] * length * width * height
    box_axes = np.array([_unit(1, 2, 2), _unit(0, 1, -1), _unit(-4, 1, 1)])
    box_moments = mass / 12 * np.array([width**2 + height**2, length**2 + height**2, length**2 + width**2])
    second = about(_unit(-2, 1, 2), mass, np.array([0.05, 0.1, 0.1]), box_moments, box_axes)

    outer, inner = p["ball.R"], p["ball.inner_radius"]
    mass = p["ball.density"] * 4 / 3 * np.pi * (outer**3 - inner**3)
    own = 2 / 5 * p["ball.density"] * 4 / 3 * np.pi * (outer**5 - inner**5)
    return {"first.q": first, "second.q": second, "third.q": 1 / (own + mass * 0.09) / 2 * t**2}


def spatial_drives(p: Parameters, t: Floats) -> dict[str, Floats]:
    """Bead on a turning hoop in a gravity that varies with the shaking."""
    l = -p["ball.com[2]"]

    def rates(time: float, x: Floats) -> list[float]:
        weight = G_N - p["amplitude"] * p["omega"] ** 2 * np.sin(p["omega"] * time)
        return [x[1], p["Omega"] ** 2 * np.sin(x[0]) * np.cos(x[0]) - weight / l * np.sin(x[0])]

    return {"pin.q": solve(rates, [np.radians(30), 0], t)[0]}


def spatial_rolling_disc(p: Parameters, t: Floats) -> dict[str, Floats]:
    """Angular momentum about the mass center in axes that do not spin, contact force eliminated."""
    m, radius = p["m"], p["R"]
    a, c, b = m * radius**2 / 4, m * radius**2 / 2, m * radius**2

    def rates(_: float, x: Floats) -> list[float]:
        lean, w1, w2, w3 = x
        n2 = w3 * np.tan(lean)
        return [
            w1,
            (-a * n2 * w3 + (c + b) * w2 * w3 + m * G_N * radius * np.sin(lean)) / (a + b),
            -b * w1 * w3 / (c + b),
            (-c * w1 * w2 + a * n2 * w1) / a,
        ]

    x = solve(rates, [p["lean"], 0, 40, 0], t)
    turn = np.array([rates(0, row)[1] for row in x.T])
    lift = -radius * (np.cos(x[0]) * x[1] ** 2 + np.sin(x[0]) * turn)
    return {"rise": -np.sin(x[0]), "normal": m * (G_N + lift)}


def spatial_ball_on_turntable(p: Parameters, t: Floats) -> dict[str, Floats]:
    """The velocity turns at 2/7 of the table's rate (K. Weltner, Am. J. Phys. 47 (1979) 984)."""
    w = 2 / 7 * p["Omega"]
    return {"motion.r[1]": 0.3 - 0.1 / w * (1 - np.cos(w * t)), "motion.r[3]": -0.1 / w * np.sin(w * t)}


def spatial_wheelset(p: Parameters, t: Floats) -> dict[str, Floats]:
    """Speed and turning rate from the speeds of the wheels; both stay."""
    v, w = 9 * p["R"], 2 * p["R"] / p["track"]
    return {
        "motion.x": v / w * np.sin(w * t),
        "motion.y": v / w * (1 - np.cos(w * t)),
        "motion.q": w * t,
        "left_bearing.q": -8 * t,
        "right_bearing.q": -10 * t,
    }


def spatial_bifilar(p: Parameters, t: Floats) -> dict[str, Floats]:
    """One coordinate, the twist: the height follows from the length of the rods."""
    l, half, width = p["l"], p["half"], p["beam.width"]
    inertia = (1 + width**2) / 12  # by the mass, about the vertical

    def height(q: Floats | float) -> Floats:
        return -np.sqrt(l**2 - 4 * half**2 * np.sin(np.asarray(q) / 2) ** 2)

    def rates(_: float, x: Floats) -> list[float]:
        q, w = x
        z = height(q)
        first = -(half**2) * np.sin(q) / z
        second = -(half**2) * np.cos(q) / z + half**2 * np.sin(q) * first / z**2
        return [w, -(first * second * w**2 + G_N * first) / (inertia + first**2)]

    q = solve(rates, [np.radians(70), 0], t)[0]
    return {"motion.angles[1]": q, "motion.r[2]": height(q)}


def spatial_differential(p: Parameters, t: Floats) -> dict[str, Floats]:
    """The same moment on both shafts; the cage has the mean of their angles."""
    left, right, cage = p["left_wheel.I[1]"], p["right_wheel.I[1]"], p["case.I[1]"]
    share = 30 / (2 + cage * (1 / left + 1 / right) / 2)
    a, b = share / left / 2 * t**2, share / right / 2 * t**2
    return {"left.q": a, "right.q": b, "cage.q": (a + b) / 2, "share": share + 0 * t}


def spatial_springs(p: Parameters, t: Floats) -> dict[str, Floats]:
    """Moments about the pin of forces on the rod's end."""
    inertia = p["rod.m"] * p["rod.l"] ** 2 / 3

    def rates(_: float, x: Floats) -> list[float]:
        q, w = x
        end = np.array([np.cos(q), np.sin(q), 0])
        v = w * np.array([-np.sin(q), np.cos(q), 0])

        def pull(name: str, a: list[float]) -> Floats:
            line = end - np.array(a)
            length = np.linalg.norm(line)
            stretch = p.get(f"{name}.k", 0.0) * (length - p.get(f"{name}.rest", 0.0))
            return -(stretch + p.get(f"{name}.c", 0.0) * (line @ v) / length) * line / length

        force = pull("first", [0.5, 1, 0.3]) + pull("second", [1, -1, 0]) + pull("third", [0, -1, -0.4])
        moment = end[0] * force[1] - end[1] * force[0]
        return [w, (moment - p["wire.k"] * (q - p["wire.rest"]) - p["oil.c"] * w) / inertia]

    return {"pin.q": solve(rates, [np.radians(30), 0], t)[0]}


def spatial_inclined_gate(p: Parameters, t: Floats) -> dict[str, Floats]:
    """Moment of the weight about the line of the hinges, by Rodrigues' formula."""
    axis = _unit(*(p[f"head[{k}]"] - p[f"foot[{k}]"] for k in (1, 2, 3)))
    m, center = p["gate.m"], np.array([p[f"gate.r[{k}]"] for k in (1, 2, 3)]) / 2
    moments = np.array([p[f"gate.I[{k}]"] for k in (1, 2, 3)])
    inertia = axis**2 @ moments + m * (center @ center - (axis @ center) ** 2)

    def rates(_: float, x: Floats) -> list[float]:
        c, s = np.cos(x[0]), np.sin(x[0])
        place = c * center + s * np.cross(axis, center) + (1 - c) * (axis @ center) * axis
        return [x[1], axis @ np.cross(place, [0, -m * G_N, 0]) / inertia]

    return {"hinge.q": solve(rates, [np.radians(40), 0], t)[0]}
