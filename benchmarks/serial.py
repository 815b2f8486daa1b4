"""Serial arms as plain numbers, the same for every peer: joints about z, each placed on the link before."""

from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path

import numpy as np

STATES = 16
QUARTERS = {0: (1, 0), 1: (0, 1), -1: (0, -1)}


@dataclass(frozen=True)
class Link:
    """Turned about x of the link before by `quarter` right angles, displaced by `place` [m] in its axes before that;
    mass [kg], mass center [m], inertia xx yy zz xy xz yz about it [kg.m2]."""

    quarter: int
    place: tuple[float, float, float]
    mass: float
    center: tuple[float, float, float]
    inertia: tuple[float, float, float, float, float, float]

    @property
    def rotation(self) -> list[float]:
        """Row by row; exact."""
        c, s = QUARTERS[self.quarter]
        return [1, 0, 0, 0, c, -s, 0, s, c]


@dataclass(frozen=True)
class Arm:
    """Links from the base on; gravity [m/s2]."""

    links: tuple[Link, ...]
    gravity: tuple[float, float, float]


def planar_chain(n: int) -> Arm:
    """models/planar_chain.lag."""
    m, length = 1.3, 0.7
    inertia = (1e-3, m * length**2 / 12, m * length**2 / 12, 0.0, 0.0, 0.0)  # only zz matters
    places = [(0.0, 0.0, 0.0)] + [(length, 0.0, 0.0)] * (n - 1)
    return Arm(tuple(Link(0, place, m, (length / 2, 0.0, 0.0), inertia) for place in places), (9.81, 0.0, 0.0))


def spatial_chain(n: int) -> Arm:
    """models/spatial_chain.lag."""
    inertia = (0.02, 0.03, 0.025, 0.001, 0.002, 0.003)
    links = [
        Link(
            0 if i == 0 else 1 if i % 2 else -1,
            (0.0, 0.0, 0.0) if i == 0 else (0.1, 0.3, 0.2),
            1.5,
            (0.05, 0.1, 0.2),
            inertia,
        )
        for i in range(n)
    ]
    return Arm(tuple(links), (0.0, 0.0, -9.81))


def panda(_: int = 7) -> Arm:
    """models/panda.lag, where the sources of the numbers stand."""
    rows = (
        (0, (0, 0, 0.333), 4.970684, (0.003875, 0.002081, -0.04762)),
        (-1, (0, 0, 0), 0.646926, (-0.003141, -0.02872, 0.003495)),
        (1, (0, -0.316, 0), 3.228604, (0.027518, 0.039252, -0.066502)),
        (1, (0.0825, 0, 0), 3.587895, (-0.05317, 0.104419, 0.027454)),
        (-1, (-0.0825, 0.384, 0), 1.225946, (-0.011953, 0.041065, -0.038437)),
        (1, (0, 0, 0), 1.666555, (0.060149, -0.014117, -0.010517)),
        (1, (0.088, 0, 0), 1.495522, (0.0017208742976286579, 0.00136035441716123, 0.1004852811486558)),
    )
    inertias = (
        (0.70337, 0.70661, 0.009117, -0.000139, 0.006772, 0.019169),
        (0.007962, 0.02811, 0.025995, -0.003925, 0.010254, 0.000704),
        (0.037242, 0.036155, 0.01083, -0.004761, -0.011396, -0.012805),
        (0.025853, 0.019552, 0.028323, 0.007796, -0.001332, 0.008641),
        (0.035549, 0.029474, 0.008627, -0.002117, -0.004037, 0.000229),
        (0.001964, 0.004354, 0.005433, 0.000109, -0.001158, 0.000341),
        (
            0.016529853712634626,
            0.014107248642161839,
            0.006676955556640956,
            0.0003948922971191777,
            -0.0007066957106145017,
            -0.001051105327046708,
        ),
    )
    return Arm(tuple(Link(*row, inertia) for row, inertia in zip(rows, inertias, strict=True)), (0.0, 0.0, -9.81))


ARMS = {
    "planar_chain": planar_chain,
    "spatial_chain": spatial_chain,
    "panda": panda,
    "panda_scalars": panda,
}


def numbers(arm: Arm) -> str:
    """For native/pinocchio.cpp: number of links and gravity, then a line for every link."""
    lines = [_line([len(arm.links), *arm.gravity])]
    lines += [_line([*k.rotation, *k.place, k.mass, *k.center, *k.inertia]) for k in arm.links]
    return "\n".join(lines) + "\n"


def mjcf(arm: Arm) -> str:
    """For MuJoCo, without contacts; its integrator is not used."""
    bodies = "".join(
        f'<body pos="{_line(k.place)}" quat="{_line(_quaternion(k.quarter))}"><joint type="hinge" axis="0 0 1"/>'
        f'<inertial pos="{_line(k.center)}" mass="{k.mass!r}" fullinertia="{_line(k.inertia)}"/>'
        for k in arm.links
    )
    return (
        '<mujoco><compiler balanceinertia="false" boundmass="0" boundinertia="0"/>'
        f'<option gravity="{_line(arm.gravity)}"><flag contact="disable" constraint="disable"/></option>'
        f"<worldbody>{bodies}{'</body>' * len(arm.links)}</worldbody></mujoco>"
    )


def states(n: int, count: int = STATES, seed: int = 1) -> np.ndarray:
    """q and qd of random states, shape (count, 2 n)."""
    return np.random.default_rng(seed).uniform(-1.0, 1.0, (count, 2 * n))


def wide_states(n: int, count: int, seed: int = 2) -> np.ndarray:
    """The same, angles all around and fast: q within pi, qd of standard deviation 5 rad/s."""
    generator = np.random.default_rng(seed)
    return np.hstack([generator.uniform(-np.pi, np.pi, (count, n)), generator.normal(0.0, 5.0, (count, n))])


def write_states(path: Path, values: np.ndarray) -> None:
    """As native/contest.c reads them: how many, how many coordinates, then q and qd of each."""
    rows, width = values.shape
    path.write_text("\n".join([f"{rows} {width // 2}", *(_line(row) for row in values)]) + "\n")


def _quaternion(quarter: int) -> tuple[float, float, float, float]:
    half = 0.5**0.5
    return (1.0, 0.0, 0.0, 0.0) if quarter == 0 else (half, quarter * half, 0.0, 0.0)


def _line(values: Sequence[float]) -> str:
    return " ".join(f"{float(value):.17g}" for value in values)
