"""Units of printed equations by a change of units: with lengths, masses and times counted in other units, each symbol
takes the factor of the unit in the table, and each equation that of the unit behind it."""

from __future__ import annotations

import json
import re
from pathlib import Path

import numpy as np
import pytest

import lagdsl
from report.printed import equations, value

_ROOT = Path(__file__).parents[3]
_BASE = {
    "m": (1, 0, 0),
    "kg": (0, 1, 0),
    "s": (0, 0, 1),
    "rad": (0, 0, 0),
    "N": (1, 1, -2),
    "J": (2, 1, -2),
    "": (0, 0, 0),
}
_RAISED = str.maketrans("⁰¹²³⁴⁵⁶⁷⁸⁹⁻", "0123456789-")
CASES = [
    ("models/double_pendulum.lag", ("4. Energies", "Equations of motion")),
    ("models/rolling_coin.lag", ("Equations of motion",)),
    ("models/centrifugal_governor.lag", ("Equations of motion",)),
    ("models/bead_on_hoop.lag", ("Solved for the accelerations", "Outputs")),
]


def factor(unit: str, scales: tuple[float, float, float]) -> float:
    """The factor of `kg.m2/s` or `kg·m²/s` where m, kg and s have these factors."""
    above, _, below = unit.translate(_RAISED).replace("·", ".").partition("/")
    result = 1.0
    for part, sign in ((above, 1), (below.strip("()"), -1)):
        for piece in part.split("."):
            found = re.fullmatch(r"([A-Za-z]*)(-?\d*)", piece)
            assert found is not None, unit
            for scale, power in zip(scales, _BASE[found.group(1)], strict=True):
                result *= scale ** (sign * power * int(found.group(2) or 1)) if found.group(1) else 1.0
    return result


def table(text: str) -> dict[str, str]:
    """Symbols with their units; a symbol without one is a number."""
    section = text.split("Symbols and units\n-----------------\n")[1].split("\n\n", maxsplit=1)[0]
    head, *rows = section.splitlines()
    start, end = head.index("unit"), head.index("meaning")
    marks = [len(row[:end]) - len(re.sub(r"[\u0300-\u036f]", "", row[:end])) for row in rows]
    return {row[: start + n].strip(): row[start + n : end + n].strip() for row, n in zip(rows, marks, strict=True)}


@pytest.mark.parametrize(("path", "headings"), CASES, ids=[Path(path).stem for path, _ in CASES])
def test_equations_change_as_their_units(path: str, headings: tuple[str, ...]) -> None:
    text = lagdsl.compile(_ROOT / path).derive().to("text", units=True)
    units, rng = table(text), np.random.default_rng(3)
    scales = (1.7, 2.3, 0.6)
    values = {name: float(rng.uniform(0.5, 1.5)) for name in units}
    other = {name: values[name] * factor(units[name], scales) for name in units}
    checked = 0
    for heading in headings:
        for line in equations(text, heading):
            words, _, unit = line.removesuffix("]").rpartition("  [")
            if not words or " = " not in words or "T −" in words:
                continue
            left, right = words.split(" = ")
            shown = left if right == "0" else right
            if not shown.strip("0"):
                continue
            expected = value(shown, values) * factor(unit, scales)
            np.testing.assert_allclose(value(shown, other), expected, rtol=1e-12)
            checked += 1
    assert checked >= len(headings)


def test_units_are_in_json_and_not_in_the_text_that_nobody_asked_for() -> None:
    derivation = lagdsl.compile(_ROOT / "models/rolling_coin.lag").derive()
    units = json.loads(derivation.to("json"))["units"]
    assert units["der(psi)"] == "rad/s"
    assert units["multiplier(rolling[1])"] == "N"
    assert "Symbols and units" not in str(derivation)
    assert r"\quad[\mathrm{kg{\cdot}m/s}]" in derivation.to("latex", units=True)
    assert '<mtext class="unit">[N·m]</mtext>' in derivation.to("html", units=True)
