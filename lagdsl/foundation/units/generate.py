"""Writes vocabulary.py from pint's registry: `python -m lagdsl.foundation.units.generate`. A tool of development."""

from __future__ import annotations

import re
from fractions import Fraction
from pathlib import Path
from typing import Any

from lagdsl.foundation.units.definition import UnitDefinition
from lagdsl.foundation.units.dimension import BASE_UNITS, dimension

GRAMMAR = Path(__file__).parents[3] / "grammar" / "lagdsl.lark"
PI = Fraction("3.14159265358979323846264338327950288419716939937510582097494459")
_NAMES_OF_PINT = {"rev": "revolution", "kn": "knot", "%": "percent"}
_LARGEST_DENOMINATOR = 10**30
TARGET = Path(__file__).parent / "vocabulary.py"

HEADER = '''"""The closed list of unit names. `python -m lagdsl.foundation.units.generate` writes it from pint."""

from fractions import Fraction

from lagdsl.foundation.units.definition import UnitDefinition
from lagdsl.foundation.units.dimension import dimension


def _unit(scale: str, pi_power: int = 0, shift: str = "0", **exponents: int) -> UnitDefinition:
    return UnitDefinition(dimension(**exponents), Fraction(scale), pi_power, Fraction(shift))


UNITS: dict[str, UnitDefinition] = {
'''


def unit_names() -> list[str]:
    """The names of the grammar's UNIT terminal, in its order."""
    text = GRAMMAR.read_text(encoding="utf-8")
    match = re.search(r"^UNIT:(.*(?:\n +\|.*)*)", text, re.MULTILINE)
    assert match is not None, "the grammar has no UNIT terminal"
    return re.findall(r'"([A-Za-z%]+)"', match[1])


def pint_registry() -> Any:
    """A registry that computes with rational numbers."""
    import pint

    return pint.UnitRegistry(non_int_type=Fraction)


def definition_from_pint(registry: Any, name: str) -> UnitDefinition:
    """The definition of one name. pint writes ohm for Modelica's Ohm and has no short names of revolution and knot."""
    unit = registry.Unit(_NAMES_OF_PINT.get(name, name.replace("Ohm", "ohm")))
    zero, one = (registry.Quantity(Fraction(value), unit).to_base_units() for value in (0, 1))
    in_si = one.to("".join(_si_text(one)))
    factor = Fraction(in_si.magnitude) - Fraction(zero.to(in_si.units).magnitude)
    shift = Fraction(zero.to(in_si.units).magnitude) / factor
    scale, pi_power = _split_pi(factor)
    exponents = {base: int(power) for base, power in zip(BASE_UNITS, _exponents(one), strict=True) if power}
    return UnitDefinition(dimension(**exponents), scale, pi_power, shift)


_PINT_BASE = ("[mass]", "[length]", "[time]", "[current]", "[temperature]", "[substance]", "[luminosity]")


def _exponents(quantity: Any) -> list[Fraction]:
    return [Fraction(quantity.dimensionality.get(name, 0)) for name in _PINT_BASE]


def _si_text(quantity: Any) -> str:
    pairs = zip(("kg", "m", "s", "A", "kelvin", "mol", "cd"), _exponents(quantity), strict=True)
    return " * ".join(f"{base}**{power}" for base, power in pairs if power) or "dimensionless"


def _split_pi(factor: Fraction) -> tuple[Fraction, int]:
    """pint has pi as a long decimal: divide it out where that leaves a simple ratio. A decimal without it is exact."""
    if factor.denominator <= _LARGEST_DENOMINATOR:
        return factor, 0
    for pi_power in (1, -1):
        exact = factor / PI**pi_power
        simple = exact.limit_denominator(10**13)
        if abs(simple - exact) <= abs(exact) / 10**40:
            return simple, pi_power
    raise AssertionError(f"no exact form of {factor}")


def render(definitions: dict[str, UnitDefinition]) -> str:
    """The text of vocabulary.py."""
    rows = []
    for name, unit in definitions.items():
        arguments = [f'"{unit.scale}"']
        arguments += [f"pi_power={unit.pi_power}"] if unit.pi_power else []
        arguments += [f'shift="{unit.shift}"'] if unit.shift else []
        powers = zip(BASE_UNITS, unit.dimension.exponents, strict=True)
        arguments += [f"{base}={power}" for base, power in powers if power]
        rows.append(f'    "{name}": _unit({", ".join(arguments)}),\n')
    return HEADER + "".join(rows) + "}\n"


def main() -> None:
    """Rewrite the checked-in file."""
    registry = pint_registry()
    TARGET.write_text(render({name: definition_from_pint(registry, name) for name in unit_names()}), encoding="utf-8")


if __name__ == "__main__":
    main()
