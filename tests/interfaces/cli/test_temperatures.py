"""Temperatures from the command line: a sign belongs to the number before degC, differences have no offset."""

from __future__ import annotations

import numpy as np
import pytest

from lagdsl.foundation.diagnostics import Sink
from lagdsl.foundation.source import SourceFile
from lagdsl.language.flat.model import FlatModel
from lagdsl.language.settings.failure import SettingError
from lagdsl.language.settings.settings import constants, settings, split
from lagdsl.motion.pipeline import flatten_file
from lagdsl.motion.sweep.values import plan

TEXT = """
model Oven
  parameter Temperature T = 20 degC;
  parameter Real K(unit = "K") = 300 K;
  parameter TemperatureDifference d = 5 K;
  input Temperature outside;
  state Temperature s(start = 10 degC);
  coordinate Angle x;
  kinetic (1 J.s2)*der(x)^2;
  output TemperatureDifference y = d + (T - outside) + (K - s);
equation
  der(s) = (T - s)/(1 s);
end Oven;
"""


@pytest.fixture(scope="module")
def oven() -> FlatModel:
    sink = Sink()
    flat = flatten_file(SourceFile("oven.lag", TEXT), sink)
    assert flat is not None, sink.diagnostics
    return flat


@pytest.mark.parametrize(
    ("text", "kelvin"),
    [
        ("T=-5 degC", 268.15), ("T=+5 degC", 278.15), ("T=- -5 degC", 278.15), ("T=-0 degC", 273.15), ("T=250", 250.0),
        ("K=-5 degC", 268.15), ("K=-5 K", -5.0), ("d=-5 K", -5.0), ("s.start=-10 degC", 263.15),
    ],
)  # fmt: skip
def test_set(oven: FlatModel, text: str, kelvin: float) -> None:
    found = settings(oven, split([text]), Sink())
    assert [*found.parameters.values(), *found.start.values()] == [kelvin]


def test_inputs(oven: FlatModel) -> None:
    assert constants(oven, {"outside": "-12.5 degC"}, Sink()) == {"outside": 260.65}


@pytest.mark.parametrize("text", ["d=5 degC", "d=-5 degC"])
def test_differences_are_given_in_kelvin(oven: FlatModel, text: str) -> None:
    with pytest.raises(SettingError, match="difference"):
        settings(oven, split([text]), Sink())


@pytest.mark.parametrize(
    ("text", "kelvin"),
    [
        ("T=-10:5:5 degC", [263.15, 268.15, 273.15, 278.15]),
        ("T=-5,5 degC", [268.15, 278.15]),
        ("T=-5 degC, 300 K", [268.15, 300.0]),
    ],
)
def test_ranges_and_lists(oven: FlatModel, text: str, kelvin: list[float]) -> None:
    (axis,) = plan([oven], split([text]), None, 0, Sink()).axes
    assert list(axis.values) == kelvin


@pytest.mark.parametrize(
    "text",
    ["T=normal(20, 2) degC", "T=normal(20 degC, 2 degC)", "T=normal(20 degC, 2 K)", "s.start=normal(20, 2) degC"],
)
def test_deviations_have_no_offset(oven: FlatModel, text: str) -> None:
    (axis,) = plan([oven], split([text]), 4000, 7, Sink()).samples
    assert np.mean(axis.values) == pytest.approx(293.15, abs=4 * 2 / np.sqrt(4000))
    assert np.std(axis.values) == pytest.approx(2.0, rel=0.05)
