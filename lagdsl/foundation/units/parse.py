"""Reads unit texts: those of literals (`m/s^2`, `/s`) and of unit strings (`N.m.s/rad`, `1/(kg.m2)`, `s-1`)."""

from __future__ import annotations

import re
from fractions import Fraction
from functools import lru_cache
from typing import Literal

from lagdsl.foundation.diagnostics.suggest import nearest
from lagdsl.foundation.units.definition import ONE, UnitDefinition, product
from lagdsl.foundation.units.dimension import dimension
from lagdsl.foundation.units.vocabulary import UNITS

Factors = list[tuple[UnitDefinition, Fraction]]

_TOKEN = re.compile(r"(?P<name>[A-Za-z_µμ°%Ω]+)|(?P<one>1)|(?P<mark>[./()*])|(?P<other>.)", re.DOTALL)
_EXPONENT = re.compile(r"\^?(?P<whole>[+-]?[1-9][0-9]?)(?![0-9])|\^\((?P<ratio>-?[1-9][0-9]?/[1-9][0-9]?)\)")
_LONGEST = 100
_CYCLES = ("Hz", "kHz", "MHz")
_ANGLES = frozenset({"rad", "mrad", "deg", "arcmin", "arcsec", "rev", "rpm"})


class UnknownUnit(ValueError):  # noqa: N818 the contract's name
    """A text that is no unit.

    `fault` says why: a `name` outside the vocabulary, a second `slash`, or another `form`. `start` and `end` are the
    characters at fault within the text; `name` is what stands there; `suggestion` is a repaired unit text or None.
    """

    def __init__(
        self, text: str, fault: Literal["name", "slash", "form"], start: int, end: int, suggestion: str | None
    ) -> None:
        super().__init__(text, fault, start, end, suggestion)
        self.text = text
        self.fault = fault
        self.start = start
        self.end = end
        self.suggestion = suggestion

    @property
    def name(self) -> str:
        return self.text[self.start : self.end]

    def __str__(self) -> str:
        return f"`{self.text}` is not a unit" + (f"; did you mean `{self.suggestion}`?" if self.suggestion else "")


def counts_turns(text: str) -> bool:
    """True for a unit of frequencies. An angular velocity counts angles in the same dimension."""
    return text.strip() in _CYCLES


def counts_angles(text: str) -> bool:
    """True for a unit with an angle in it, as those of angular velocities, `rad/s` and `rpm`."""
    return any(match["name"] in _ANGLES for match in _TOKEN.finditer(text))


def counts_otherwise(text: str, unit: str) -> str:
    """Why a value in the unit `text` cannot be one of a quantity declared in `unit`, though dimensions agree; or ""."""
    if unit == "rad/s" and counts_turns(text):
        return "Hz counts turns; write `rev/s` or `rad/s`"
    if unit == "Hz" and counts_angles(text):
        return f"`{text}` counts angles; write Hz, as 60 rpm are 1 Hz"
    return ""


@lru_cache(maxsize=1024)
def parse_unit(text: str) -> UnitDefinition:
    """The definition of a unit text: dimension and exact conversion to the coherent SI unit.

    Factors are joined by `.`; there is at most one `/` and everything after it divides (Modelica's rule), with or
    without parentheses. `1` and the empty text are dimensionless. Negative exponents may stand without `^`, as in unit
    strings (`s-1`); the lexer of literals is stricter. Raises UnknownUnit.
    """
    stripped = text.strip()
    if stripped in ("", "1"):
        return ONE
    if len(stripped) > _LONGEST:
        raise UnknownUnit(text, "form", 0, len(text), None)
    return product(_Reader(text).unit())


class _Reader:
    def __init__(self, text: str) -> None:
        self.text = text
        self.at = len(text) - len(text.lstrip())
        self.stop = len(text.rstrip())

    def unit(self) -> Factors:
        factors = [] if self._peek() == "/" else self._group()
        if self._peek() == "/":
            self.at += 1
            factors = factors + [(unit, -exponent) for unit, exponent in self._group()]
        if self._peek() == "/":
            raise UnknownUnit(self.text, "slash", self.at, self.at + 1, _one_slash(self.text))
        if self.at < self.stop:
            raise self._form()
        return factors

    def _group(self) -> Factors:
        if self._peek() != "(":
            return self._factors()
        self.at += 1
        factors = self._factors()
        if self._peek() != ")":
            raise self._form()
        self.at += 1
        return factors

    def _factors(self) -> Factors:
        factors = [self._factor()]
        while self._peek() == ".":
            self.at += 1
            factors.append(self._factor())
        return factors

    def _factor(self) -> tuple[UnitDefinition, Fraction]:
        match = _TOKEN.match(self.text, self.at, self.stop)
        if match is None or match.lastgroup not in ("name", "one"):
            raise self._form()
        self.at = match.end()
        if match.lastgroup == "one":
            return ONE, Fraction(1)
        if match[0] not in UNITS:
            raise UnknownUnit(self.text, "name", match.start(), match.end(), _repaired(self.text, *match.span()))
        return UNITS[match[0]], self._exponent(UNITS[match[0]])

    def _exponent(self, unit: UnitDefinition) -> Fraction:
        match = _EXPONENT.match(self.text, self.at, self.stop)
        if match is None:
            return Fraction(1)
        if match["ratio"] is not None and (unit.scale != 1 or unit.pi_power):
            raise self._form()
        self.at = match.end()
        return Fraction(match["whole"] or match["ratio"])

    def _peek(self) -> str:
        return self.text[self.at] if self.at < self.stop else ""

    def _form(self) -> UnknownUnit:
        repaired = re.sub(r"\s*([./*()])\s*", r"\1", self.text.strip()).replace("**", "^")
        repaired = re.sub(r"[\s*·]+", ".", repaired).replace("//", "/")
        return UnknownUnit(self.text, "form", self.at, max(self.at + 1, self.stop), _if_unit(repaired, self.text))


# ---- suggestions -----------------------------------------------------------------------------------------------------

_SPELLINGS = {
    "Nm": "N.m", "kNm": "kN.m", "Nmm": "N.mm", "Ns": "N.s", "Nms": "N.m.s", "kgm": "kg.m", "Ws": "W.s", "As": "A.s",
    "kWh": "kW.h", "Ah": "A.h", "Vs": "V.s", "kmh": "km/h", "kph": "km/h", "mps": "m/s", "cc": "cm3",
    "sec": "s", "secs": "s", "hr": "h", "hrs": "h", "mins": "min", "in": "inch", "L": "litre", "l": "litre",
    "Kg": "kg", "KG": "kg", "KN": "kN", "Kn": "kN", "°": "deg", "RPM": "rpm", "Ω": "Ohm", "°C": "degC",
    "µm": "um", "μm": "um", "µs": "us", "μs": "us",
}  # fmt: skip
_FULL_NAMES = {
    "meter": "m", "metre": "m", "gram": "g", "kilo": "kg", "second": "s", "minute": "min", "hour": "h",
    "tonne": "t", "ton": "t", "liter": "litre", "litre": "litre", "micron": "um", "inche": "inch",
    "foot": "ft", "feet": "ft", "yard": "yd", "pound": "lb", "knot": "kn", "horsepower": "hp", "calorie": "cal",
    "electronvolt": "eV", "arcminute": "arcmin", "arcsecond": "arcsec", "percent": "%", "atmosphere": "atm",
    "radian": "rad", "degree": "deg", "turn": "rev", "revolution": "rev", "hertz": "Hz", "kelvin": "K",
    "newton": "N", "joule": "J", "watt": "W", "pascal": "Pa", "volt": "V", "amp": "A", "ampere": "A", "ohm": "Ohm",
    "celsius": "degC", "farad": "F", "henry": "H", "tesla": "T", "weber": "Wb", "coulomb": "C",
}  # fmt: skip
# Known units with another zero: nothing that stands in their place means the same.
_OTHER_SCALES = ("degF", "Fahrenheit", "fahrenheit")
_PREFIXES = {"micro": "u", "milli": "m", "mili": "m", "centi": "c", "kilo": "k", "mega": "M"}
# Masses, lengths, times, rates and angles have a plural; with forces and powers the `s` is the second.
_COUNTED = tuple(dimension(**exponents) for exponents in ({"kg": 1}, {"m": 1}, {"s": 1}, {"s": -1}, {}))


def _repaired(text: str, start: int, end: int) -> str | None:
    """The text with the unknown name replaced by its usual spelling, by a product of known names, or by the nearest."""
    name = text[start:end]
    if name in _OTHER_SCALES:
        return None
    known = (_SPELLINGS.get(name), _of_full_name(name), _same_but_case(name), _of_plural(name), _without_double(name))
    for replacement in (*known, _as_product(name), nearest(name, UNITS)):
        if replacement is not None:
            return _if_unit(text[:start] + replacement + text[end:], text)
    return None


def _of_full_name(name: str) -> str | None:
    """`mm` for `Millimeters`."""
    stem = name.casefold()
    for word in (stem, stem.removesuffix("s")):
        if word in _FULL_NAMES:
            return _FULL_NAMES[word]
        for prefix, letter in _PREFIXES.items():
            unit = letter + _FULL_NAMES.get(word.removeprefix(prefix), "?")
            if word.startswith(prefix) and unit in UNITS:
                return unit
    return None


def _of_plural(name: str) -> str | None:
    """`kg` for `kgs`, and not for `Ns`, which is a product."""
    stem = name[:-1]
    plural = name.endswith("s") and len(stem) > 1 and stem in UNITS and UNITS[stem].dimension in _COUNTED
    return stem if plural else None


def _without_double(name: str) -> str | None:
    """`cm` for `cmm`: a letter was typed twice."""
    fewer = [name[:k] + name[k + 1 :] for k in range(1, len(name)) if name[k - 1] == name[k]]
    return next((unit for unit in fewer if len(unit) > 1 and unit in UNITS), None)


def _same_but_case(name: str) -> str | None:
    same = [unit for unit in UNITS if unit.casefold() == name.casefold()]
    return same[0] if len(same) == 1 else None


def _as_product(name: str) -> str | None:
    """`Nm` is `N.m`: the fewest known names, up to three, whose letters are `name`."""
    for first in range(1, len(name)):
        if name[:first] in UNITS and name[first:] in UNITS and not _are_alike(name[:first], name[first:]):
            return f"{name[:first]}.{name[first:]}"
    for first in range(1, len(name) - 1):
        rest = _as_product(name[first:]) if name[:first] in UNITS and len(name) <= 12 else None
        if rest is not None and rest.count(".") == 1:
            return f"{name[:first]}.{rest}"
    return None


def _are_alike(one: str, other: str) -> bool:
    """True for two units of one quantity: nobody means `cm.m`."""
    return UNITS[one].dimension == UNITS[other].dimension and not UNITS[one].dimension.is_dimensionless


def _one_slash(text: str) -> str | None:
    """`m/s/s` means `m/(s.s)`, and everything after the one slash divides."""
    head, _, tail = text.partition("/")
    return _if_unit(f"{head}/{tail.replace('/', '.')}".replace("(", "").replace(")", ""), text)


def _if_unit(candidate: str, text: str) -> str | None:
    """`candidate` where it is a unit; one further repair of its own is taken."""
    if candidate == text:
        return None
    try:
        parse_unit(candidate)
    except UnknownUnit as error:
        return error.suggestion
    return candidate
