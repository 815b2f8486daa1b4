"""Clocks that tick at communication points and at the stop: counts by hand."""

from __future__ import annotations

import numpy as np
import pytest
from choice import chosen

import lagdsl
from fmi.exact_importer import ends_exactly
from fmi.exported import VERSIONS
from fmi.importing import slave
from fmi.texts import exported_text

TICKS = """model Ticks
  parameter Time T = 0.1 s;
  discrete Integer n(start = 0);
  state Real z;
equation
  der(z) = 1/(1 s);
  when sample(0, T) then
    n = pre(n) + 1;
  end when;
end Ticks;
"""
CASES = [(0.1, 3), (0.1, 14), (0.7, 7), (1.0, 7), (0.0625, 7), (1 / 3, 9), (1e-3, 50)]


@pytest.mark.parametrize("version", chosen(VERSIONS, [2]))
def test_the_last_tick_at_the_stop_belongs_to_the_run(version: int) -> None:
    """At other communication points a tick belongs to the next step, which has the inputs of that instant."""
    fmu = exported_text(TICKS, version)
    for period, count in CASES:
        stop = count * period
        for each in (1, 2, 3):
            times = stop * np.linspace(0.0, 1.0, each * count + 1)
            before = [1.0, *np.ceil(np.arange(1, len(times)) / each)]
            for known in (stop, None):
                with slave(fmu) as one:
                    one.initialize({"T": period}, stop=known)
                    found = one.rows(["n"], times)[:, 0]
                last = count + 1 if known is not None else count
                np.testing.assert_array_equal(found, [*before[:-1], last], str((period, count, each, known)))


@pytest.mark.parametrize("version", chosen(VERSIONS, [2]))
def test_a_run_and_model_exchange_tick_as_often(version: int) -> None:
    fmu = exported_text(TICKS, version)
    model = lagdsl.compile(TICKS, engine="tape")
    for period, count in CASES:
        stop = count * period
        assert ends_exactly(fmu, stop, ["n"], {"T": period})["n"] == count + 1
        assert model.simulate(stop=stop, parameters={"T": period})["n"][-1] == count + 1
