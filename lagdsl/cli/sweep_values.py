"""`lag sweep --set name=values`: one value, a range, a list, or a distribution to draw from."""

from __future__ import annotations

import re
from collections.abc import Callable
from dataclasses import replace
from fractions import Fraction
from typing import TypeAlias

import click
import numpy as np

from lagdsl.cli.assignments import Settings, settings
from lagdsl.flat.model import FlatModel
from lagdsl.numerics.rank import Floats
from lagdsl.sweep.plan import Axis, Plan, Target, require_few
from lagdsl.units.definition import si_value
from lagdsl.units.naming import rate_text
from lagdsl.units.parse import parse_unit

Draw: TypeAlias = Callable[[np.random.Generator, int, list[float]], Floats]

_NUMBER = r"[+-]?(?:\d+\.?\d*|\.\d+)(?:[eE][+-]?\d+)?"
_QUANTITY = re.compile(rf"\s*({_NUMBER})\s*(.*?)\s*")
_CALL = re.compile(r"([a-z]+)\s*\(([^()]*)\)\s*(.*?)\s*")
# Name: what the arguments mean (`1` for a number without unit), and how to draw.
_DISTRIBUTIONS: dict[str, tuple[tuple[str, ...], Draw]] = {
    "uniform": (("lowest", "highest"), lambda r, n, a: r.uniform(a[0], a[1], n)),
    "normal": (("mean", "deviation"), lambda r, n, a: r.normal(a[0], a[1], n)),
    "lognormal": (("median", "deviation of the logarithm"), lambda r, n, a: a[0] * np.exp(r.normal(0.0, a[1], n))),
    "triangular": (("lowest", "likeliest", "highest"), lambda r, n, a: r.triangular(a[0], a[1], a[2], n)),
}


def plan(flat: FlatModel, pairs: dict[str, str], random: int | None, seed: int) -> Plan:
    """The runs that the texts ask for. Raises UsageError for what is no value, range, list or distribution, ValueError
    for too many runs."""
    axes: list[Axis] = []
    fixed: list[Axis] = []
    samples: list[Axis] = []
    runs = 1 if random is None else random
    require_few(runs)
    for number, (name, text) in enumerate(pairs.items()):
        call = _CALL.fullmatch(text)
        if call is not None:
            _require_distribution(name, text, call)
            if random is None:
                raise click.UsageError(f"{name}={text}: give the number of draws with --random N")
            # A stream of its own for every name: one more name changes no other draws.
            samples.append(_drawn(flat, name, text, call, random, np.random.default_rng([seed, number])))
        else:
            texts = _texts(name, text, runs)
            runs *= len(texts)
            require_few(runs)
            axis = _axis(flat, name, texts)
            (axes if len(texts) > 1 else fixed).append(axis)
    if random is not None and not samples:
        raise click.UsageError("--random needs a distribution, as in --set 'm=normal(1, 0.1) kg'")
    return Plan(axes=tuple(axes), samples=tuple(samples), fixed=tuple(fixed))


def _texts(name: str, text: str, runs: int) -> list[str]:
    """The single values, each of which makes `runs` runs; a unit at the end counts for all that have none."""
    if ":" in text:
        return _range(name, text, runs)
    pieces = text.split(",")
    last = _QUANTITY.fullmatch(pieces[-1])
    unit = last[2] if last else ""
    found = [_QUANTITY.fullmatch(piece) for piece in pieces]
    return [
        f"{each[1]} {each[2] or unit}".strip() if each else piece.strip()
        for piece, each in zip(pieces, found, strict=True)
    ]


def _range(name: str, text: str, runs: int) -> list[str]:
    """`first:step:last unit`, the last included where the steps meet it. Counted in the decimals that were typed."""
    parts = [_QUANTITY.fullmatch(piece) for piece in text.split(":")]
    if len(parts) != 3 or None in parts:
        raise click.UsageError(f"{name}={text}: a range is first:step:last, as in 0.1:0.1:1 m")
    units = dict.fromkeys(part[2] for part in parts if part and part[2])
    if len(units) > 1:
        raise click.UsageError(f"{name}={text}: give one unit for the whole range")
    unit = next(iter(units), "")
    first, step, last = (Fraction(part[1]) for part in parts if part)
    if step == 0 or (last - first) / step < 0:
        raise click.UsageError(f"{name}={text}: steps of {float(step):g} do not lead from the first to the last value")
    count = (last - first) // step + 1
    require_few(count * runs)
    return [f"{float(first + i * step)!r} {unit}".strip() for i in range(count)]


def _axis(flat: FlatModel, name: str, texts: list[str]) -> Axis:
    chosen = [_only(settings(flat, {name: text})) for text in texts]
    values = tuple(value for _, _, value in chosen)
    key, target, _ = chosen[0]
    if len(set(values)) < len(values):
        raise click.UsageError(f"`{name}` has the same value twice")
    return Axis(name=name, key=key, target=target, unit=_unit(flat, key), values=values)


def _only(found: Settings) -> tuple[str, Target, float]:
    """Key, kind and value of the one thing that is set."""
    kinds: tuple[tuple[Target, dict[str, float]], ...] = (
        ("parameter", found.parameters),
        ("start", found.start),
        ("structural", found.structural),
    )
    ((key, kind, value),) = [(key, kind, value) for kind, values in kinds for key, value in values.items()]
    return key, kind, value


def _drawn(
    flat: FlatModel, name: str, text: str, call: re.Match[str], count: int, generator: np.random.Generator
) -> Axis:
    """`count` draws; those that a parameter may not have fail as runs, not here."""
    meanings, draw = _DISTRIBUTIONS[call[1]]
    given = [piece.strip() for piece in call[2].split(",")]
    arguments: list[float] = []
    key, target = name, "parameter"
    for meaning, piece in zip(meanings, given, strict=True):
        found = _QUANTITY.fullmatch(piece)
        if found is None:
            raise click.UsageError(f"{name}={text}: the {meaning} must be a number")
        if meaning == "deviation of the logarithm":
            arguments.append(float(found[1]))
            continue
        unit = found[2] or call[3]
        key, target, value = _only(settings(_unbounded(flat, name), {name: f"{found[1]} {unit}".strip()}))
        arguments.append(_amount(found[1], unit) if meaning == "deviation" else value)
    if target == "structural":
        raise click.UsageError(f"`{name}` is structural: it takes ranges and lists, not distributions")
    _require_drawable(name, text, call[1], arguments)
    values = tuple(float(value) for value in draw(generator, count, arguments))
    return Axis(
        name=name, key=key, target="start" if target == "start" else "parameter", unit=_unit(flat, key), values=values
    )


def _amount(digits: str, unit: str) -> float:
    """A difference in SI units: the zero of the scale does not matter to it."""
    return si_value(digits, replace(parse_unit(unit), shift=Fraction(0)))


def _require_distribution(name: str, text: str, call: re.Match[str]) -> None:
    """There is one of that name, and it takes so many numbers."""
    if call[1] not in _DISTRIBUTIONS:
        raise click.UsageError(f"{name}={text}: there are the distributions {', '.join(_DISTRIBUTIONS)}")
    meanings, _ = _DISTRIBUTIONS[call[1]]
    if len(call[2].split(",")) != len(meanings):
        raise click.UsageError(f"{name}={text}: {call[1]} takes {', '.join(meanings)}")


def _require_drawable(name: str, text: str, distribution: str, arguments: list[float]) -> None:
    match distribution:
        case "uniform" | "triangular":
            sound = arguments == sorted(arguments) and arguments[0] < arguments[-1]
            why = "from the lowest to the highest"
        case "lognormal":
            sound, why = arguments[0] > 0.0 and arguments[1] >= 0.0, "a positive median"
        case _:
            sound, why = arguments[1] >= 0.0, "a deviation that is not negative"
    if not sound:
        raise click.UsageError(f"{name}={text}: {distribution} needs {why}")


def _unbounded(flat: FlatModel, name: str) -> FlatModel:
    """The model with every value allowed for `name`: a deviation need not be what the parameter may be."""
    parameters = tuple(replace(p, minimum=None, maximum=None) if p.name == name else p for p in flat.parameters)
    return replace(flat, parameters=parameters)


def _unit(flat: FlatModel, key: str) -> str:
    """The SI unit of what is set."""
    for item in (*flat.parameters, *flat.coordinates, *flat.states):
        if item.name == key:
            return "" if item.unit == "1" else item.unit
    for coordinate in flat.coordinates:
        if f"der({coordinate.name})" == key:
            return rate_text(coordinate.dimension, coordinate.unit)
    raise AssertionError(f"internal error: nothing is called {key}")
