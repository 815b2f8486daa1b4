"""Contacts beside each other: what strikes, rests or opens in one mechanism changes nothing in the others."""

import math

import numpy as np
import pytest

import lagdsl

G = 9.80665  # m/s2, standard gravity
RESTITUTION = 0.5

# Balls, each with a floor of its own; blocks of two masses and a rod between them, dropped onto two floors.
BESIDE = """\
model Beside
  structural parameter Integer N = 6;
  parameter Length l = 0.4 m;
  coordinate Length h[N](start = {0.1 m*i for i in 1:N});
  coordinate Length a[2](start = {0.5 m, 0.7 m}), b[2](start = {0.5 m, 0.7 m});
  gravity = -g_n*world.y;
  for i in 1:N loop
    mass i*(0.1 kg) at {i*(1 m), h[i]};
    contact floor: h[i] >= 0 with restitution = 0.5;
  end for;
  for i in 1:2 loop
    mass 1 kg at {-i*(1 m), a[i]};
    mass 2 kg at {-i*(1 m), b[i] + l};
    constraint rod: a[i] = b[i];
    contact ground: a[i] >= 0 with restitution = 0.5;
  end for;
end Beside;
"""


def height(start: float, t: float) -> float:
    """A ball that falls from `start` [m] onto a floor, with half of its speed after each impact; at rest afterwards."""
    speed, until = math.sqrt(2 * G * start), math.sqrt(2 * start / G)
    if t <= until:
        return start - G * t**2 / 2
    for _ in range(200):
        speed *= RESTITUTION
        flight = 2 * speed / G
        if t < until + flight:
            return speed * (t - until) - G * (t - until) ** 2 / 2
        until += flight
    return 0.0


@pytest.mark.parametrize("stop", [0.45, 2.0], ids=["some bounce", "all rest"])
def test_each_mechanism_moves_as_if_it_were_alone(stop: float) -> None:
    motion = lagdsl.compile(BESIDE).simulate(stop=stop, interval=stop / 40, tolerance=1e-10)
    balls = {f"h[{i}]": 0.1 * i for i in range(1, 7)}
    blocks = {f"{name}[{i}]": (0.5, 0.7)[i - 1] for name in "ab" for i in (1, 2)}
    for name, start in (balls | blocks).items():
        expected = [height(start, t) for t in motion.time]
        np.testing.assert_allclose(motion[name], expected, atol=2e-6, err_msg=name)


def test_forces_of_contacts_that_rest_are_weights() -> None:
    outputs = """\
  output Force N_h[N] = {multiplier(floor[i]) for i in 1:N};
  output Force N_a[2] = {multiplier(ground[i]) for i in 1:2};
"""
    motion = lagdsl.compile(BESIDE.replace("end Beside", f"{outputs}end Beside")).simulate(stop=2.0)
    forces = [motion[f"N_h[{i}]"][-1] for i in range(1, 7)] + [motion[f"N_a[{i}]"][-1] for i in (1, 2)]
    np.testing.assert_allclose(forces, [0.1 * i * G for i in range(1, 7)] + [3 * G, 3 * G], rtol=1e-9)
