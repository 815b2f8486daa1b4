"""Derivatives until initialization ends, and with respect to time, against differences of what importers get."""

from __future__ import annotations

import numpy as np
import pytest
from choice import chosen

from fmi.exported import VERSIONS, exported
from fmi.importing import Floats, Model, exchanged
from fmi.test_fmpy_derivatives import difference

BOTH = pytest.mark.parametrize("version", chosen(VERSIONS, [3]))  # the same functions stand behind both


def enter(one: Model) -> None:
    """Into initialization mode."""
    if one.fmu.version == 2:
        one.raw.setupExperiment(startTime=0.0)
    one.raw.enterInitializationMode(*(() if one.fmu.version == 2 else (None, 0.0, None)))


def rates_of(one: Model) -> list[str]:
    return [item.variable.name for item in one.fmu.description.derivatives]


@BOTH
def test_parameters_and_starts_until_initialization_ends(version: int) -> None:
    """Of a model without constraints, along parameters, start values and an input at once."""
    knowns = ["M", "l1", "c", "a", "u"]
    with exchanged(exported("cart_double_pendulum", version)) as one:
        enter(one)
        at, direction = one.get(*knowns), np.array([0.4, 0.1, 0.2, 0.3, 2.0])

        def values(s: float) -> Floats:
            one.set(dict(zip(knowns, at + s * direction, strict=True)))
            return np.concatenate([one.array(name) for name in rates_of(one)])

        expected, _ = difference(values)
        values(0.0)
        found = one.directional(rates_of(one), knowns, direction)
        np.testing.assert_allclose(found, expected, rtol=1e-9, atol=1e-10 * np.max(np.abs(expected)))
        assert np.count_nonzero(expected) >= 3


@BOTH
def test_an_input_of_a_closed_loop_until_initialization_ends(version: int) -> None:
    """The start does not follow it, the accelerations do."""
    with exchanged(exported("four_bar", version)) as one:
        enter(one)
        (name,) = (v.name for v in one.fmu.variables.values() if v.causality == "input")

        def values(s: float) -> Floats:
            one.set({name: 0.5 + s})
            return np.concatenate([one.array(rate) for rate in rates_of(one)])

        expected, _ = difference(values)
        values(0.0)
        found = one.directional(rates_of(one), [name], np.ones(1))
        np.testing.assert_allclose(found, expected, rtol=1e-9, atol=1e-10 * np.max(np.abs(expected)))
        assert np.any(expected != 0.0)


@BOTH
def test_a_start_that_a_constraint_decides_about(version: int) -> None:
    """A bead on y = A cos(k x), k = 2 pi/wavelength, with x fixed: y and its rate follow x, A and the wavelength."""
    with exchanged(exported("bead_on_cosine_wire", version)) as one:
        enter(one)
        one.set({"x": 0.03, "der(x)": 0.4})
        knowns, direction = ["x", "der(x)", "A", "wavelength"], np.array([0.3, -0.2, 0.5, 0.7])
        x, v, A, length = one.get(*knowns)
        dx, dv, dA, dlength = direction
        k, dk = 2 * np.pi / length, -2 * np.pi / length**2 * dlength
        phase, dphase = k * x, dk * x + k * dx
        dy = dA * np.cos(phase) - A * np.sin(phase) * dphase
        slope, dslope = -A * k * np.sin(phase), -(dA * k + A * dk) * np.sin(phase) - A * k * np.cos(phase) * dphase
        drate = slope * dv + dslope * v
        np.testing.assert_allclose(one.get("y", "der(y)"), [A * np.cos(phase), slope * v], rtol=1e-12)
        found = one.directional(["x", "y", "der(x)", "der(y)"], knowns, direction)
        np.testing.assert_allclose(found, [dx, dy, dv, drate], rtol=1e-9)
        np.testing.assert_allclose(one.get("y", "der(y)"), [A * np.cos(phase), slope * v], rtol=1e-12)


@BOTH
def test_a_loop_whose_start_follows_its_lengths(version: int) -> None:
    """Accelerations and multipliers along all parameters, against differences of the starts that importers get."""
    with exchanged(exported("four_bar", version)) as one:
        enter(one)
        knowns = ["crank.l", "coupler.m", "rocker.l"]
        at, direction = one.get(*knowns), np.array([0.1, 0.5, -0.1])

        def values(s: float) -> Floats:
            one.set(dict(zip(knowns, at + s * direction, strict=True)))
            return np.concatenate([one.array(rate) for rate in rates_of(one)])

        expected, _ = difference(values)
        values(0.0)
        found = one.directional(rates_of(one), knowns, direction)
        np.testing.assert_allclose(found, expected, rtol=1e-9, atol=1e-10 * np.max(np.abs(expected)))


@pytest.mark.parametrize("name", ["kapitza_pendulum", "ball_on_moving_table"])
@BOTH
def test_time_is_a_known(name: str, version: int) -> None:
    with exchanged(exported(name, version)) as one:
        one.initialize()
        one.update()
        x = one.states + 0.01
        (time,) = (v.name for v in one.fmu.variables.values() if v.causality == "independent")

        def values(s: float) -> Floats:
            one.move(0.01 + 0.01 * s, x)
            return np.concatenate([one.array(rate) for rate in rates_of(one)])

        expected, _ = difference(values)
        values(0.0)
        found = one.directional(rates_of(one), [time], np.array([0.01]))
        np.testing.assert_allclose(found, expected, rtol=1e-9, atol=1e-9 * np.max(np.abs(expected)))
        assert np.any(expected != 0.0)
