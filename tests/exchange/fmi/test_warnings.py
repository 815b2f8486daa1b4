"""Assertions that warn are messages of an FMU, once each time that they begin to."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import pytest
from choice import chosen
from fmpy import simulate_fmu

from fmi.exported import VERSIONS, place
from fmi.texts import export_text

TEXT = """model Swing
  coordinate Length x(start = 1 m);
  mass 1 kg at {x, 0};
  gravity = 0;
  potential 1/2*(40 N/m)*x^2;
  output Length y = x;
equation
  assert(x > -0.9 m, "far out", AssertionLevel.warning);
  assert(x < 2 m, "never told", AssertionLevel.warning);
  when x < 0 m then
    assert(der(x) > 0, "to the left", AssertionLevel.warning);
  end when;
  annotation(experiment(StopTime = 2.2));
end Swing;
"""


@pytest.mark.parametrize("kind", ["ModelExchange", "CoSimulation"])
@pytest.mark.parametrize("version", chosen(VERSIONS, [2]))
def test_warnings_are_logged(version: int, kind: str) -> None:
    path = place() / f"warns{version}{kind}.fmu"
    export_text(TEXT, path, version)
    told: list[tuple[str, str]] = []
    simulate_fmu(path, fmi_type=kind, stop_time=2.2, debug_logging=True, logger=_logger(version, told))
    texts = [text for category, text in told if category == "logStatusWarning"]
    for text in ("far out", "to the left"):
        assert len([each for each in texts if text in each]) == 2, texts
    assert len(texts) == 4


def _logger(version: int, told: list[tuple[str, str]]) -> Callable[..., None]:
    def of_two(_: Any, __: Any, ___: int, category: bytes, message: bytes) -> None:
        told.append((category.decode(), message.decode()))

    def of_three(_: Any, __: int, category: bytes, message: bytes) -> None:
        told.append((category.decode(), message.decode()))

    return of_two if version == 2 else of_three
