"""Accelerations by elimination against Lagrange's equations differentiated numerically, with fifty digits.

Nothing but values of the Lagrangian is asked of the graph: d/dt(dL/dqd) - dL/dq along q + h qd + h^2/2 qdd by central
differences whose step is far above the rounding and far below what matters.
"""

from collections.abc import Callable, Iterator, Sequence

import mpmath
import numpy as np
import pytest
from elimination_models import PLANAR, SCALARS, SPATIAL, eliminated, flat_model
from test_mechanics_elimination import GENERAL
from test_mechanics_typed_energies import ANY, chain

from lagdsl.algebra.graph.evaluate import evaluate
from lagdsl.algebra.graph.operation import Group
from lagdsl.language.flat.model import FlatModel

Numbers = Sequence[mpmath.mpf]
STEP = mpmath.mpf("1e-14")
TIME = 0.3


def residuals(
    lagrangian: Callable[[Numbers, Numbers, mpmath.mpf], mpmath.mpf], q: Numbers, qd: Numbers, qdd: Numbers
) -> Iterator[tuple[mpmath.mpf, mpmath.mpf]]:
    """Residual that the accelerations leave in each of Lagrange's equations, and the size of its terms."""
    t, h, n = mpmath.mpf(TIME), STEP, len(q)

    def moved(values: Numbers, index: int, step: mpmath.mpf) -> list[mpmath.mpf]:
        return [value + (step if k == index else 0) for k, value in enumerate(values)]

    def momentum(index: int, s: mpmath.mpf) -> mpmath.mpf:
        place = [a + s * b + s * s / 2 * c for a, b, c in zip(q, qd, qdd, strict=True)]
        rate = [b + s * c for b, c in zip(qd, qdd, strict=True)]
        ahead, behind = (lagrangian(place, moved(rate, index, step), t + s) for step in (h, -h))
        return (ahead - behind) / (2 * h)

    for index in range(n):
        push = (lagrangian(moved(q, index, h), qd, t) - lagrangian(moved(q, index, -h), qd, t)) / (2 * h)
        inertia = (momentum(index, h) - momentum(index, -h)) / (2 * h)
        yield abs(inertia - push), abs(push) + abs(momentum(index, mpmath.mpf(0))) + 1


def worst(flat: FlatModel, error: float = 0.0) -> float:
    """The largest residual at a random state, of accelerations that are wrong by `error`."""
    derivation, solution = eliminated(flat)
    graph, n = derivation.graph, len(flat.coordinates)
    parameters = [item.value for item in flat.parameters if not item.structural]
    rng = np.random.default_rng(7)
    q, qd = rng.uniform(-1.0, 1.0, n), rng.uniform(-1.0, 1.0, n)
    symbols = {Group.Q: q, Group.QD: qd, Group.U: [0.0] * len(flat.inputs), Group.P: parameters, Group.TIME: TIME}
    qdd = [float(x) + error for x in evaluate(graph, solution.own.accelerations, symbols)]
    exact = [mpmath.mpf(x) for x in parameters]

    def lagrangian(place: Numbers, rate: Numbers, t: mpmath.mpf) -> mpmath.mpf:
        given = {Group.Q: list(place), Group.QD: list(rate), Group.P: exact, Group.TIME: t}
        (value,) = evaluate(graph, [derivation.dynamics.energies.lagrangian], given)
        return mpmath.mpf(value)

    with mpmath.workdps(50):
        numbers = [[mpmath.mpf(float(x)) for x in values] for values in (q, qd, qdd)]
        return max(float(left / size) for left, size in residuals(lagrangian, *numbers))


FREE = [
    name
    for name, flat in GENERAL.items()
    if not flat.constraints and all(e.kind != "dissipation" for e in flat.energies)
]


@pytest.mark.parametrize("name", FREE)
def test_general_lagrangians(name: str) -> None:
    assert worst(GENERAL[name]) < 1e-12


@pytest.mark.parametrize("name", ANY)
def test_energies_in_velocities_of_frames(name: str) -> None:
    assert worst(flat_model(f"model M\n  {ANY[name]}\nend M;\n")) < 1e-12


@pytest.mark.parametrize("text", [PLANAR, SPATIAL, SCALARS])
def test_chains(text: str) -> None:
    assert worst(flat_model(text.format(n=3))) < 1e-12


def test_wrong_accelerations_are_seen() -> None:
    assert worst(flat_model(SPATIAL.format(n=3)), 1e-8) > 1e-11


@pytest.mark.parametrize("typed", [False, True])
def test_bodies(typed: bool) -> None:
    assert worst(flat_model(chain("spatial", 3, typed=typed))) < 1e-12
