"""The runs that texts ask for: one value, a range, a list, or a distribution to draw from."""

from __future__ import annotations

import os
import re
from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import replace
from fractions import Fraction
from pathlib import Path
from typing import TypeAlias

import numpy as np

from lagdsl.foundation.diagnostics import Sink
from lagdsl.foundation.numerics.rank import Floats
from lagdsl.foundation.units.definition import si_value
from lagdsl.foundation.units.parse import parse_unit
from lagdsl.language.flat.model import FlatModel, Parameter
from lagdsl.language.settings.aliases import by_own_names
from lagdsl.language.settings.arrays import family, spread
from lagdsl.language.settings.axis import note_bare, values_of
from lagdsl.language.settings.failure import SettingError, short
from lagdsl.language.settings.literal import Literal
from lagdsl.language.settings.pieces import QUANTITY
from lagdsl.language.settings.ranges import CALL, grid_of
from lagdsl.language.settings.settings import texts_of_inputs
from lagdsl.language.settings.target import Target, find, targets, value_of
from lagdsl.motion.signals.inputs import Signal
from lagdsl.motion.sweep.plan import Axis, Plan, require_few, variants

Draw: TypeAlias = Callable[[np.random.Generator, int, list[float]], Floats]

# Name: what the arguments mean (`1` for a number without unit), and how to draw.
_DISTRIBUTIONS: dict[str, tuple[tuple[str, ...], Draw]] = {
    "uniform": (("lowest", "highest"), lambda r, n, a: r.uniform(a[0], a[1], n)),
    "normal": (("mean", "deviation"), lambda r, n, a: r.normal(a[0], a[1], n)),
    "lognormal": (("median", "deviation of the logarithm"), lambda r, n, a: a[0] * np.exp(r.normal(0.0, a[1], n))),
    "triangular": (("lowest", "likeliest", "highest"), lambda r, n, a: r.triangular(a[0], a[1], a[2], n)),
}


def plan(
    models: Sequence[FlatModel],
    pairs: Mapping[str, str],
    random: int | None,
    seed: int,
    sink: Sink,
    inputs: Mapping[str, str] | None = None,
) -> Plan:
    """The runs that the texts of `pairs` and of `inputs` ask for, with names that any of the models has; notes about
    numbers without unit go to `sink`. Raises SettingError for what is no value, range, list or distribution, ValueError
    for too many runs."""
    axes: list[Axis] = []
    fixed: list[Axis] = []
    samples: list[Axis] = []
    runs = 1 if random is None else random
    require_few(runs)
    for target, text, stream in (*_set(models, pairs), *_put_in(models[0], inputs or {})):
        name, call = target.name, CALL.fullmatch(text)
        if call is not None and _is_drawn(text):
            _require_distribution(name, text, call)
            if random is None:
                raise SettingError(f"{name}={short(text)}: give the number of draws with --random N")
            samples.append(_drawn(target, text, call, random, np.random.default_rng([seed, *stream]), sink))
        else:
            axis = axis_of(target, text, sink, runs)
            runs *= len(axis.values)
            (axes if len(axis.values) > 1 else fixed).append(axis)
    if random is not None and not samples:
        raise SettingError("--random needs a distribution, as in --set 'm=normal(1, 0.1) kg'")
    return Plan(axes=tuple(axes), samples=tuple(samples), fixed=tuple(fixed))


# A target, its text, and the number of its stream of draws: one more name changes no other draws.
_Asked: TypeAlias = tuple[Target, str, tuple[int, ...]]


def _set(models: Sequence[FlatModel], pairs: Mapping[str, str]) -> Iterator[_Asked]:
    known: dict[str, Target] = {}
    for flat in models:
        known |= {name: target for name, target in targets(flat).items() if name not in known}
    for number, (name, text) in enumerate(spread(by_own_names(models[0], pairs), known).items()):
        yield find(models[0], name, known), text, (number,)


def _put_in(flat: FlatModel, inputs: Mapping[str, str]) -> Iterator[_Asked]:
    for number, (target, text) in enumerate(texts_of_inputs(flat, inputs).values()):
        yield target, text, (number, 1)


def structures(flat: FlatModel, pairs: Mapping[str, str]) -> list[dict[str, float]]:
    """The different settings of the structural parameters of `flat` that the texts ask for, at least one. Raises as
    `plan`."""
    known = targets(flat, ("structural",))
    named = {name: text for name, text in pairs.items() if name in known or family(name, known)}
    chosen = {name: text for name, text in named.items() if not _is_drawn(text)}  # `plan` refuses these
    return variants(plan([flat], chosen, None, 0, Sink()))


def first_of(target: Target, text: str) -> float | None:
    """The value in the first run; None for a distribution, which `plan` refuses for a structural parameter."""
    return None if _is_drawn(text) else axis_of(target, text, Sink()).values[0]


def _is_drawn(text: str) -> bool:
    call = CALL.fullmatch(text)
    return call is not None and call[1] != "linspace"


def axis_of(target: Target, text: str, sink: Sink, runs: int = 1) -> Axis:
    """The values of a text, each of which makes `runs` runs. Raises SettingError, ValueError for too many."""
    grid = grid_of(target.name, text)
    require_few(grid.count * runs)
    values = values_of(target, text, grid, sink)
    if len(set(values)) < len(values):
        raise SettingError(f"`{target.name}` has the same value twice")
    return axis(target, values)


def axis(target: Target, values: tuple[float, ...]) -> Axis:
    """The axis of a quantity with these values [SI units]."""
    return Axis(
        name=target.name,
        key=target.key,
        target=target.kind,
        unit=target.unit,
        values=values,
        display=target.display,
    )


def axis_of_tables(name: str, labels: tuple[str, ...], tables: Sequence[Mapping[str, Signal]]) -> Axis:
    """An axis over signals by name of inputs; each of `tables` is called by its label."""
    places = tuple(float(k) for k in range(len(tables)))
    return Axis(name=name, key=name, target="tables", unit="", values=places, labels=labels, tables=tuple(tables))


def labels_of(paths: Sequence[Path]) -> tuple[str, ...]:
    """Short names of files that tell them apart: without the folder that all lie in."""
    whole = [path.absolute() for path in paths]
    folder = os.path.commonpath([path.parent for path in whole])
    return tuple(path.relative_to(folder).as_posix() for path in whole)


def _drawn(
    target: Target, text: str, call: re.Match[str], count: int, generator: np.random.Generator, sink: Sink
) -> Axis:
    """`count` draws; those that a parameter may not have fail as runs, not here. N0871 for numbers that lack a unit."""
    name = target.name
    if target.kind == "structural":
        raise SettingError(f"`{name}` is structural: it takes ranges and lists, not distributions")
    meanings, draw = _DISTRIBUTIONS[call[1]]
    given = [piece.strip() for piece in call[2].split(",")]
    arguments: list[float] = []
    literals: list[Literal] = []
    free = _unbounded(target)
    for meaning, piece in zip(meanings, given, strict=True):
        found = QUANTITY.fullmatch(piece)
        if found is None:
            raise SettingError(f"{name}={short(text)}: the {meaning} must be a number")
        if meaning == "deviation of the logarithm":
            arguments.append(float(found[1]))
            continue
        unit = found[2] or call[3]
        literals.append(value_of(free, f"{found[1]} {unit}".strip()))
        arguments.append(_amount(found[1], unit) if meaning == "deviation" else literals[-1].value)
    note_bare(target, text, literals, sink)
    _require_drawable(name, text, call[1], arguments)
    return axis(target, tuple(float(value) for value in draw(generator, count, arguments)))


def _amount(digits: str, unit: str) -> float:
    """A difference in SI units: the zero of the scale does not matter to it."""
    return si_value(digits, replace(parse_unit(unit), shift=Fraction(0)))


def _require_distribution(name: str, text: str, call: re.Match[str]) -> None:
    """There is one of that name, and it takes so many numbers."""
    if call[1] not in _DISTRIBUTIONS:
        raise SettingError(f"{name}={short(text)}: there are the distributions {', '.join(_DISTRIBUTIONS)}")
    meanings, _ = _DISTRIBUTIONS[call[1]]
    if len(call[2].split(",")) != len(meanings):
        raise SettingError(f"{name}={short(text)}: {call[1]} takes {', '.join(meanings)}")


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
        raise SettingError(f"{name}={short(text)}: {distribution} needs {why}")


def _unbounded(target: Target) -> Target:
    """With every value allowed: a deviation need not be what the parameter may be."""
    item = target.quantity
    return (
        replace(target, quantity=replace(item, minimum=None, maximum=None)) if isinstance(item, Parameter) else target
    )
