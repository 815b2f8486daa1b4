"""Random mechanisms against Newton's and Euler's equations of their bodies: accelerations, and the reaction at every
joint, at the start and after a while."""

from __future__ import annotations

import numpy as np
import pytest
from choice import chosen
from maximal_coordinates import BASE, SIZES, WORLD, equations, hubs
from random_mechanisms import mechanism, text

import lagdsl

CASES = {
    "planar tree": {"bodies": 4, "kinds": ["Revolute", "Prismatic", "FreeMotion"], "loops": [], "planar": True},
    "planar tree on a moving base": {
        "bodies": 3,
        "kinds": ["Revolute", "Prismatic"],
        "loops": [],
        "planar": True,
        "base": True,
    },
    "planar loop": {"bodies": 3, "kinds": ["Revolute"], "loops": [("Revolute", WORLD, 2)], "planar": True},
    "planar loops that share links": {
        "bodies": 5,
        "kinds": ["Revolute", "Revolute", "Prismatic", "FreeMotion"],
        "loops": [("Revolute", 0, 3), ("Prismatic", 4, 2)],
        "planar": True,
    },
    "loop of parallel axes in space": {
        "bodies": 4,
        "kinds": ["Revolute"],
        "loops": [("Revolute", BASE, 3)],
        "flat": True,
        "base": True,
    },
    "spatial tree": {
        "bodies": 5,
        "kinds": ["Revolute", "Universal", "Spherical", "Screw", "Cylindrical"],
        "loops": [],
        "base": True,
    },
    "loop not through the world": {
        "bodies": 3,
        "kinds": ["FreeQuaternion", "Spherical", "Universal"],
        "loops": [("Cylindrical", 2, 0)],
    },
    "loop on a moving base": {
        "bodies": 3,
        "kinds": ["Universal", "Spherical", "Planar"],
        "loops": [("Revolute", 2, BASE)],
        "base": True,
    },
    "loops closed by screw and universal": {
        "bodies": 3,
        "kinds": ["FreeQuaternion", "FreeMotion", "Spherical"],
        "loops": [("Screw", 1, WORLD), ("Universal", 0, WORLD)],
    },
    "rigid loop": {
        "bodies": 3,
        "kinds": ["FreeMotion", "FreeQuaternion"],
        "loops": [("Weld", 0, 1), ("Prismatic", WORLD, 2)],
    },
    "drives in a loop": {
        "bodies": 4,
        "kinds": ["RevoluteDrive", "Spherical", "FreeMotion", "PrismaticDrive"],
        "loops": [("Spherical", 1, 3)],
    },
}
SOME = (
    "planar tree on a moving base",
    "loops closed by screw and universal",
)


def column(values, stem, c):
    if c in SIZES:
        return np.array([values[f"{stem}[{k + 1}]"] for k in range(SIZES[c])])
    return float(values[stem])


def check(found, model, t, q, qd, bound):
    values = dict(zip(model.outputs, model.output(t, q, qd), strict=True))
    qs = {j.name: {c: column(values, f"o_{j.name}_{c}", c) for c in j.start} for j in found.joints}
    rates = {j.name: {c: column(values, f"d_{j.name}_{c}", c) for c in j.start} for j in found.joints}
    there, misfit = hubs(found, qs, rates, t)
    assert misfit < bound
    A, b, begin, wrenches = equations(found, there, qs, rates, t)
    _, sizes, basis = np.linalg.svd(A)
    free = basis[np.sum(sizes > 1e-9 * sizes[0]) :]
    expected = np.linalg.lstsq(A, b, rcond=1e-9)[0]
    size = max(1.0, np.abs(expected).max())
    np.testing.assert_allclose(A @ expected, b, rtol=0, atol=1e-9 * size)
    second = dict(zip(model.coordinates, model.forward_dynamics(t, q, qd), strict=True))
    mine = expected.copy()
    for i, j in enumerate(found.joints):
        reaction = [values[f"{part}_{j.name}[{k}]"] for part in "FT" for k in (1, 2, 3)]
        mine[wrenches + 6 * i : wrenches + 6 * i + 6] = reaction
        names = {c: f"{j.name}.{c}" for c in j.start}
        if j.start and all(f"{name}[1]" in second or name in second for name in names.values()):
            qdd = {c: column(second, name, c) for c, name in names.items()}
            mine[begin[i] : begin[i + 1]] = j.second_rates(qs[j.name], qdd)
    # All of it: the motion, equilibrium of every body under the reactions, and those reactions that are determined.
    np.testing.assert_allclose(A @ mine, b, rtol=0, atol=bound * size)
    determined = np.linalg.norm(free, axis=0) < 1e-8
    np.testing.assert_allclose(mine[determined], expected[determined], rtol=0, atol=bound * size)
    assert determined[: begin[-1]].all()


@pytest.mark.parametrize("seed", chosen([1, 2], [1]))
@pytest.mark.parametrize("name", chosen(CASES, SOME))
def test_motion_and_reactions(name, seed):
    case = CASES[name]
    found = mechanism(seed, **case)
    model = lagdsl.compile(text(found, seed, case.get("planar", False)))
    start = model.initial_state()
    check(found, model, 0.0, np.array(start.q), np.array(start.qd), 1e-9)
    if seed == 1 and case["loops"]:
        path = model.simulate(stop=0.2, interval=0.1, tolerance=1e-10)
        q = np.array([path[name][-1] for name in model.coordinates])
        qd = np.array([path[f"der({name})"][-1] for name in model.coordinates])
        check(found, model, 0.2, q, qd, 1e-7)
