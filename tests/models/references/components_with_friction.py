"""Components of the library with dry friction and of one way: closed forms, mode by mode."""

from __future__ import annotations

from collections.abc import Mapping

import numpy as np
from numpy.typing import ArrayLike

from models.references.hybrid import Mode, Motion
from models.references.integrate import Floats, solve

Parameters = Mapping[str, float]


def _way(rate: float, pieces: list[tuple[float, float]], t: Floats) -> tuple[Floats, Floats]:
    """Place from 0 and rate with an acceleration from each time on."""
    x, v = np.zeros_like(t), np.zeros_like(t)
    place, ends = 0.0, [begin for begin, _ in pieces[1:]] + [np.inf]
    for (begin, a), end in zip(pieces, ends, strict=True):
        since = t - begin
        x = np.where(since >= 0, place + rate * since + a * since**2 / 2, x)
        v = np.where(since >= 0, rate + a * since, v)
        if end < np.inf:
            place, rate = place + rate * (end - begin) + a * (end - begin) ** 2 / 2, rate + a * (end - begin)
    return x, v


def clutch_engagement(p: Parameters, t: Floats) -> dict[str, Floats]:
    """The slip fades on a line, the angular momentum stays."""
    a, b = p["engine.J"], p["wheels.J"]
    slip = np.maximum(100 - 30 * (1 / a + 1 / b) * t, 0.0)
    mean = a * 100 / (a + b)
    return {"der(engine.phi)": mean + b / (a + b) * slip, "der(wheels.phi)": mean - a / (a + b) * slip}


def stopping_by_friction(p: Parameters, t: Floats) -> dict[str, Floats]:
    """The block on a line; w' = -rate tanh(w/w_0) of the shaft makes sinh(w/w_0) fade like an exponential."""
    brake, rate, w_0 = p["floor.f_c"] / p["block.m"], p["pads.tau_c"] / p["shaft.J"], 1.0
    stop = p["v_i"] / brake
    place, speed = _way(p["v_i"], [(0.0, -brake), (stop, 0.0)], t)
    return {
        "block.s": place,
        "der(block.s)": speed,
        "der(shaft.phi)": np.asarray(w_0 * np.arcsinh(np.sinh(p["w_i"] / w_0) * np.exp(-rate / w_0 * t))),
    }


def _stribeck(v: float, slow: float, fast: float, curve: float, viscous: float) -> float:
    """The curve for a speed that is not negative."""
    return float(fast + (slow - fast) * np.exp(-((v / curve) ** 2)) + viscous * v)


def stribeck_bearing(p: Parameters, t: Floats) -> dict[str, Floats]:
    law = [p[f"bearing.{name}"] for name in ("tau_b", "tau_c", "w_s", "c")]
    x = solve(lambda _, x: [x[1], (3 - _stribeck(x[1], *law)) / p["shaft.J"]], [0, 0], t)
    return {"shaft.phi": x[0], "der(shaft.phi)": x[1], "friction": np.array([_stribeck(w, *law) for w in x[1]])}


def stick_slip(p: Parameters, t: Floats) -> dict[str, Floats]:
    """The block slides back on the belt, is carried along, and breaks loose at the breakaway force."""
    law = [p[f"belt.{name}"] for name in ("f_b", "f_c", "v_s", "c")]
    k, m, speed, breakaway = p["spring.k"], p["block.m"], 0.15, p["belt.f_b"]

    def sliding(_: float, x: Floats) -> ArrayLike:
        return [x[1], (-k * x[0] + _stribeck(speed - x[1], *law)) / m]

    def caught(_: float, x: Floats) -> tuple[str, ArrayLike]:
        assert abs(k * x[0]) < breakaway
        return "carried", [x[0], speed]

    modes = {
        "back": Mode(sliding, [(lambda _, x: speed - x[1], caught)]),
        "carried": Mode(lambda *_: [speed, 0.0], [(lambda _, x: breakaway - k * x[0], lambda _, x: ("back", x))]),
    }
    motion = Motion(lambda name, _: modes[name], "back", [0.04, 0], t)
    return {"block.s": motion.x[0], "carried": np.where(motion.modes == "carried", 1.0, 0.0)}


def brakes_and_clutches(p: Parameters, t: Floats) -> dict[str, Floats]:
    shaft, turning = _way(10.0, [(0.0, -2.0), (5.0, 0.0), (8.0, 1.0)], t)
    cart, rolling = _way(3.0, [(0.0, 0.5), (1.0, -1.5), (1.0 + 3.5 / 1.5, 0.0)], t)
    train, wagon = (_way(rate, [(0.0, a), (0.5, 0.0)], t)[0] for rate, a in ((2.0, -3.0), (0.0, 1.0)))
    since = np.maximum(t - 3.0, 0.0)
    return {
        "shaft.phi": shaft,
        "der(shaft.phi)": turning,
        "cart.s": cart,
        "der(cart.s)": rolling,
        "train.s": train,
        "wagon.s": wagon,
        "tight.phi": 0.25 * since**2 + since**3 / 12,
        "der(tight.phi)": 0.5 * since + 0.25 * since**2,
    }


def freewheels(p: Parameters, t: Floats) -> dict[str, Floats]:
    meet = 3.0 / (4.0 + 0.25)
    pedals, own = _way(0.0, [(0.0, 4.0), (meet, 3.5 / 3), (2.0, -2.0)], t)
    wheel, others = _way(3.0, [(0.0, -0.25), (meet, 3.5 / 3), (2.0, -0.25)], t)
    hoist, _ = _way(0.0, [(0.0, 1.0), (2.0, -1.0), (4.0, 0.0)], t)
    winch, _ = _way(0.0, [(0.0, 1.0), (2.0, -1.0)], t)
    return {
        "pedals.phi": pedals,
        "der(pedals.phi)": own,
        "wheel.phi": wheel,
        "der(wheel.phi)": others,
        "hoist.phi": hoist,
        "winch.phi": np.where(t > 4.0, np.maximum(winch, 6 * p["pawl.pitch"]), winch),
    }


def journals(p: Parameters, t: Floats) -> dict[str, Floats]:
    """J w' = -mu r m e sqrt(w^4 + w'^2), so w' = -c w^2; a line for the pulley."""
    J, loss = p["I"] + p["m"] * p["e"] ** 2, p["journal.mu"] * p["journal.r"] * p["m"] * p["e"]
    c = loss / np.sqrt(J**2 - loss**2)
    rate = 40 / (1 + 40 * c * t)
    brake = p["bush.mu"] * p["bush.r"] * 300 / p["pulley.J"]
    return {
        "pin.q": np.log1p(40 * c * t) / c,
        "der(pin.q)": rate,
        "loss": -J * c * rate**2,
        "pulley.phi": _way(20.0, [(0.0, -brake), (20.0 / brake, 0.0)], t)[0],
    }


def worm_hoist(p: Parameters, t: Floats) -> dict[str, Floats]:
    """A normal force n (times the radius of the worm) brakes the worm with sin + mu cos, and turns the wheel with
    ratio tan(lead) (cos - mu sin); mu over the cosine of the pressure angle."""
    s, c, mu = np.sin(p["gear.lead"]), np.cos(p["gear.lead"]), p["gear.mu"] / np.cos(p["gear.alpha"])
    ratio, worm = p["gear.ratio"], s + mu * c
    wheel = ratio * s / c * (c - mu * s)

    def acceleration(drive: float) -> float:
        (a, force) = np.linalg.solve([[p["motor.J"], worm], [p["drum.J"] / ratio, -wheel]], [drive, -40.0])
        assert force > 0
        return float(a)

    up, down = acceleration(4.0), acceleration(0.0)
    assert mu > s / c
    stop = 0.4 - up * 0.4 / down
    turned, rate = _way(0.0, [(0.0, up), (0.4, down), (stop, 0.0)], t)
    return {"motor.phi": turned, "drum.phi": turned / ratio, "der(motor.phi)": rate}
