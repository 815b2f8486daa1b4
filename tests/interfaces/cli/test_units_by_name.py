"""Units of values by name: as behind a number of a text, and as in a declaration."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path

import pytest
from click.testing import Result

import lagdsl
from lagdsl.language.settings.failure import SettingError
from lagdsl.language.settings.literal import literal

TEXT = """model Loop
  parameter Real K(unit = "V/(rad.s)") = -4;
  parameter Real c(unit = "1/s") = 1 /s;
  parameter Real part(displayUnit = "%") = 5 %;
  parameter Mass m = 2 lb;
  coordinate Length x;
  kinetic 1/2*m*der(x)^2;
  force part*(K*(1 N.rad.s/V) + c*(1 N.s)) on x;
end Loop;
"""


@pytest.mark.parametrize(
    ("text", "value"),
    [
        ("-3 V/(rad.s)", -3.0),
        ("-3 V/rad.s", -3.0),
        ("2 mV/(deg.min)", 2e-3 * 180 / 3.141592653589793 / 60),
        ("5 1/s", 5.0),
        ("6 1/min", 0.1),
        ("30 %", 0.3),
        ("-2.5%", -0.025),
        ("3 ft", 0.9144),
        ("2 kg.m-1", 2.0),
    ],
)
def test_units_of_declarations_stand_behind_values(text: str, value: float) -> None:
    assert literal("k", text).value == pytest.approx(value, rel=1e-15)


@pytest.mark.parametrize(
    ("text", "way"),
    [
        ("3 V/rad/s", "did you mean the unit `V/rad.s`"),
        ("3 V/(rad/s)", "expected a number"),
        ("3 lbs", "write `3 lb`"),
        ("7 % 2", "expected a number"),
        ("3 1", "expected a number"),
        ("1e999 V/(rad.s)", "too large"),
    ],
)
def test_what_is_no_value_is_told(text: str, way: str) -> None:
    with pytest.raises(SettingError, match="k=") as caught:
        literal("k", text)
    assert way in str(caught.value)


def test_the_help_of_a_bare_number_can_be_followed(invoke: Callable[..., Result], tmp_path: Path) -> None:
    """N0871 names the unit of the declaration, which is taken as it stands."""
    path = tmp_path / "loop.lag"
    path.write_text(TEXT, encoding="utf-8")
    for bare, whole in (("K=3", "3 V/rad.s"), ("c=5", "5 /s")):
        assert f"write `{whole}`" in invoke("run", path, "--set", bare, "--stop", "1").stderr
        followed = invoke("run", path, "--set", f"{bare[:2]}{whole}", "--stop", "1")
        assert followed.exit_code == 0
        assert "N0871" not in followed.stderr


def test_percentages_and_pounds_move_a_mass() -> None:
    """x = -0.05*3 N t^2/(2 m), m = 0.90718474 kg."""
    motion = lagdsl.compile(TEXT).simulate(stop=2.0)
    assert motion["x"][-1] == pytest.approx(-0.15 * 4.0 / (2 * 0.90718474), rel=1e-9)


@pytest.mark.parametrize(
    ("written", "way"),
    [
        ("7 % (2)", "the remainder is `mod(7, 2)`"),
        ("7 %2", "the remainder is `mod(7, b)`"),
        ("7 % x", "`7 %` is a percentage"),
        ("4 V/(rad.s)", "`4 V/rad.s`"),
        ("max(1, 2, 3, 4)", "`max({1, 2, 3, 4})`"),
        ("5. kg", "`5.0 kg`"),
    ],
)
def test_what_may_be_meant_otherwise_is_told(written: str, way: str) -> None:
    found = lagdsl.check(TEXT.replace("5 %;", f"{written};"))
    assert any(way in (each.help or "") for each in found)
