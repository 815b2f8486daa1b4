"""Directional and adjoint derivatives that importers get, against differences of what they get."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np
import pytest
from choice import chosen
from fmpy.simulation import FMICallException
from models.corpus import compiled

from fmi.exported import EVERY, exported, in_versions
from fmi.importing import Floats, Model, exchanged

MODELS = pytest.mark.parametrize("name", chosen(EVERY, EVERY[1::5]))
MODELS_IN_VERSIONS = in_versions(chosen(EVERY, EVERY[::4]))
# Central differences of tenth order: truncation (0.3 h)^10, rounding 2^-52 / h.
WEIGHTS = np.array([5 / 6, -5 / 21, 5 / 84, -5 / 504, 1 / 1260])
STEPS = (3e-2, 1e-2, 3e-3, 1e-3, 3e-4, 1e-4, 3e-5, 1e-5)
CLOSE = 1e-9


def difference(function: Callable[[float], Floats]) -> tuple[Floats, Floats]:
    """d function(s) / ds at zero, and how well it is known: two steps that agree best, entry by entry. A step may lead
    to where there are no values."""
    slopes = []
    for h in STEPS:
        pairs = [function(k * h) - function(-k * h) for k in range(1, 6)]
        slopes.append(np.tensordot(WEIGHTS, np.array(pairs), axes=1) / h)
    gaps = np.nan_to_num(np.abs(np.diff(slopes, axis=0)), nan=np.inf)
    best = np.argmin(gaps, axis=0)
    return np.take_along_axis(np.array(slopes[1:]), best[None], axis=0)[0], np.min(gaps, axis=0)


def unknowns_of(one: Model) -> list[str]:
    """Derivatives of states and real outputs."""
    names = [item.variable.name for item in one.fmu.description.derivatives]
    for item in one.fmu.description.outputs:
        if item.variable.type in ("Real", "Float64") and item.variable.name not in names:
            names.append(item.variable.name)
    return names


def knowns_of(one: Model) -> tuple[list[str], list[str]]:
    """States, in order, and real inputs."""
    states = [item.variable.derivative.name for item in one.fmu.description.derivatives]
    inputs = [v.name for v in one.fmu.variables.values() if v.causality == "input" and v.type in ("Real", "Float64")]
    return states, inputs


def sizes_of(x: Floats, rates: Floats, n: int) -> Floats:
    """Of states, or of the largest one of their kind: of n coordinates, n rates, and the rest, which may be in units
    that make them large: those go as far in a millisecond."""
    kinds = np.split(x, [n, 2 * n])
    sizes = np.concatenate([np.maximum(np.abs(each), 0.1 * np.max(np.abs(each), initial=1.0)) for each in kinds])
    sizes[2 * n :] = np.maximum(sizes[2 * n :], 1e-3 * np.abs(rates[2 * n :]))
    return sizes


@MODELS_IN_VERSIONS
def test_directional_derivatives_are_those_of_the_functions(name: str, version: int) -> None:
    """Along random directions of states and inputs, at the start and off the constraints, too."""
    random = np.random.default_rng(5)
    with exchanged(exported(name, version)) as one:
        one.initialize()
        one.update()
        states, inputs = knowns_of(one)
        unknowns = unknowns_of(one)
        x, u = one.states, np.concatenate([np.zeros(0), *(one.array(i) for i in inputs)])
        sizes = sizes_of(x, one.derivatives, len(compiled(name).graph.layout.coordinates))
        checked = np.zeros(one.length(unknowns), dtype=bool)
        for _ in range(3):
            at = x + 0.01 * sizes * random.normal(size=len(x))
            direction = np.concatenate([sizes * random.normal(size=len(x)), random.normal(size=len(u))])

            def values(s: float, at: Floats = at, direction: Floats = direction) -> Floats:
                one.move(0.0, at + s * direction[: len(x)])
                place = 0
                for i in inputs:
                    count = one.length([i])
                    one.set({i: u[place : place + count] + s * direction[len(x) + place : len(x) + place + count]})
                    place += count
                try:
                    return np.concatenate([one.array(unknown) for unknown in unknowns])
                except FMICallException:
                    return np.full(one.length(unknowns), np.nan)

            expected, known_to = difference(values)
            values(0.0)
            found = one.directional(unknowns, [*states, *inputs], direction)
            scale = np.maximum(np.abs(expected), 1e-3 * np.max(np.abs(expected)))
            certain = known_to <= CLOSE * scale  # beside a kink or a singular position differences know nothing
            checked |= certain
            off = np.flatnonzero(certain & (np.abs(found - expected) > 3 * CLOSE * scale))
            assert not len(off), [(unknowns, off, found[off], expected[off])]
        assert np.mean(checked) > 0.9


@MODELS
def test_adjoint_derivatives_are_the_transposed_ones(name: str) -> None:
    """w (J v) = (w J) v, FMI 3."""
    random = np.random.default_rng(6)
    with exchanged(exported(name, 3)) as one:
        one.initialize()
        one.update()
        states, inputs = knowns_of(one)
        knowns, unknowns = [*states, *inputs], unknowns_of(one)
        v, w = random.normal(size=one.length(knowns)), random.normal(size=one.length(unknowns))
        forward, backward = one.directional(unknowns, knowns, v), one.adjoint(unknowns, knowns, w)
        size = np.abs(w) @ np.abs(forward) + np.abs(backward) @ np.abs(v)
        assert abs(w @ forward - backward @ v) <= 1e-13 * max(size, 1e-300)
        assert np.any(forward != 0.0)


@in_versions(["double_pendulum", "cart_double_pendulum", "chain"])
def test_without_constraints_derivatives_are_the_state_jacobian(name: str, version: int) -> None:
    from fmi.motions import model

    with exchanged(exported(name, version)) as one:
        one.initialize()
        one.update()
        states, _ = knowns_of(one)
        rates = [item.variable.name for item in one.fmu.description.derivatives]
        n = len(one.states) // 2
        expected = model(name).state_jacobian(0.0, one.states[:n], one.states[n:])
        columns = [one.directional(rates, states, unit) for unit in np.eye(2 * n)]
        np.testing.assert_allclose(np.array(columns).T, expected, rtol=1e-12, atol=1e-12 * np.max(np.abs(expected)))
