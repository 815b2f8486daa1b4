"""Derivatives until initialization ends, and with respect to time, against differences of what importers get."""

from __future__ import annotations

import numpy as np
import pytest

from fmi.exported import VERSIONS, exported
from fmi.importing import Floats, Model, exchanged
from fmi.test_fmpy_derivatives import difference

BOTH = pytest.mark.parametrize("version", VERSIONS)


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
    """The start does not follow it, the accelerations do. What moves the start is refused."""
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
        with pytest.raises(Exception, match="Derivative"):
            one.directional(rates_of(one), [one.fmu.description.derivatives[0].variable.derivative.name], np.ones(1))


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
