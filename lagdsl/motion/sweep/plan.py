"""The runs of a sweep: every combination of the values of its axes, each with all samples."""

from __future__ import annotations

import hashlib
import math
from collections.abc import Collection, Iterable, Iterator, Mapping
from dataclasses import dataclass, field
from itertools import groupby, islice
from typing import Literal, TypeAlias, get_args

from lagdsl.language.flat.display import Display
from lagdsl.motion.signals.inputs import Signal

Target: TypeAlias = Literal["parameter", "start", "structural", "input", "tables"]

LARGEST = 1_000_000  # runs


@dataclass(frozen=True, slots=True, kw_only=True)
class Axis:
    """One thing that is set, with its values in SI units.

    `name` is how `--set` calls it (`l`, `theta.start`), `key` how the model does (`theta`), `display` how people see
    it. Values of the target "tables" are places in `tables`, each of which has signals of inputs by name and, in
    `labels`, its own name.
    """

    name: str
    key: str
    target: Target
    unit: str
    values: tuple[float, ...]
    display: Display | None = None
    labels: tuple[str, ...] = ()
    tables: tuple[Mapping[str, Signal], ...] = ()


@dataclass(frozen=True, slots=True, kw_only=True)
class Plan:
    """`axes` are combined with each other; `samples` belong together, entry k of each to sample k; `fixed` have one
    value in all runs."""

    axes: tuple[Axis, ...] = ()
    samples: tuple[Axis, ...] = ()
    fixed: tuple[Axis, ...] = ()

    @property
    def shape(self) -> tuple[int, ...]:
        """Numbers of values along the axes, then the number of samples if there are any."""
        return (*(len(axis.values) for axis in self.axes), *(len(axis.values) for axis in self.samples[:1]))

    @property
    def runs(self) -> int:
        return math.prod(self.shape)


@dataclass(frozen=True, slots=True, kw_only=True)
class Task:
    """One run: what is set, by name, in SI units; `swept` is the number of the compiled model. `inputs` are its own,
    beside those that all runs share."""

    index: int
    swept: int
    parameters: dict[str, float]
    start: dict[str, float]
    inputs: Mapping[str, Signal] = field(default_factory=dict)


def require_sound(plan: Plan) -> None:
    """Raise ValueError for what is no sweep."""
    every = (*plan.axes, *plan.samples, *plan.fixed)
    names = [axis.name for axis in every]
    for axis in every:
        if not axis.values:
            raise ValueError(f"`{axis.name}` has no values")
        if not all(math.isfinite(value) for value in axis.values):
            raise ValueError(f"the values of `{axis.name}` must be finite numbers")
        if names.count(axis.name) > 1:
            raise ValueError(f"`{axis.name}` is set twice")
    for axis in plan.axes:
        if len(set(axis.values)) < len(axis.values):
            raise ValueError(f"`{axis.name}` has the same value twice")
    if len({len(axis.values) for axis in plan.samples}) > 1:
        raise ValueError("all samples need the same number of values")
    require_few(plan.runs)


def require_few(runs: int) -> None:
    """Raise ValueError for more runs than a sweep may have."""
    if runs > LARGEST:
        raise ValueError(f"the sweep has {min(runs, 10**300):.6g} runs, at most {LARGEST} are possible")


def settings(plan: Plan, index: int) -> dict[Target, dict[str, float]]:
    """Settings of run `index`; runs count as the elements of an array of the plan's shape, the last axis fastest."""
    chosen: dict[Target, dict[str, float]] = {target: {} for target in get_args(Target)}
    for axis in plan.fixed:
        chosen[axis.target][axis.key] = axis.values[0]
    if plan.samples:
        index, sample = divmod(index, len(plan.samples[0].values))
        for axis in plan.samples:
            chosen[axis.target][axis.key] = axis.values[sample]
    for axis in reversed(plan.axes):
        index, position = divmod(index, len(axis.values))
        chosen[axis.target][axis.key] = axis.values[position]
    return chosen


def inputs_of(plan: Plan, index: int) -> dict[str, Signal]:
    """Inputs of run `index` that are its own."""
    chosen = settings(plan, index)
    found: dict[str, Signal] = dict(chosen["input"])
    for axis in (*plan.axes, *plan.fixed):
        if axis.target == "tables":
            found |= axis.tables[int(chosen["tables"][axis.key])]
    return found


def calls_python(plan: Plan) -> bool:
    """True if an input of single runs is a function of Python."""
    return any(
        callable(signal) for axis in (*plan.axes, *plan.fixed) for each in axis.tables for signal in each.values()
    )


def place(plan: Plan, index: int) -> str:
    """Settings of run `index`, for people: `l = 0.1 m, theta.start = 20 deg`; what all runs share is left out."""
    chosen = settings(plan, index)
    varied = (*plan.axes, *plan.samples)
    return ", ".join(_shown(axis, chosen[axis.target][axis.key]) for axis in varied)


def _shown(axis: Axis, value: float) -> str:
    if axis.labels:
        return f"{axis.name} = {axis.labels[int(value)]}"
    shown = axis.display or Display(axis.unit)
    return f"{axis.name} = {shown(value):.6g} {shown.unit}".rstrip()


def variants(plan: Plan) -> list[dict[str, float]]:
    """The different settings of structural parameters, each of which is a model of its own."""
    found = [settings(plan, index)["structural"] for index in range(plan.runs)] if _has_structural(plan) else [{}]
    return [dict(items) for items in dict.fromkeys(tuple(each.items()) for each in found)]


def _has_structural(plan: Plan) -> bool:
    return any(axis.target == "structural" for axis in (*plan.axes, *plan.samples, *plan.fixed))


def task(plan: Plan, index: int, known: list[dict[str, float]]) -> Task:
    """Run `index`, where `known` are the variants."""
    chosen = settings(plan, index)
    return Task(
        index=index,
        swept=known.index(chosen["structural"]),
        parameters=chosen["parameter"],
        start=chosen["start"],
        inputs=inputs_of(plan, index),
    )


def tasks_of(plan: Plan, known: list[dict[str, float]], finished: Collection[int]) -> Iterator[Task]:
    """All runs that are not finished, those of one variant after those of another."""
    every: Iterable[int] = range(plan.runs)
    if len(known) > 1:
        every = sorted(every, key=lambda index: known.index(settings(plan, index)["structural"]))
    return (task(plan, index, known) for index in every if index not in finished)


def parts_of(tasks: Iterable[Task], most: int) -> Iterator[list[Task]]:
    """Tasks that follow each other, at most so many together, and of one model only."""
    for _, alike in groupby(tasks, key=lambda task: task.swept):
        while part := list(islice(alike, most)):
            yield part


def fingerprint(plan: Plan, *parts: str) -> str:
    """A digest of the plan and of `parts`: what two sweeps must share to be the same one."""
    digest = hashlib.sha256()
    for text in (repr(plan), *parts):
        data = text.encode()
        digest.update(f"{len(data)}:".encode() + data)
    return digest.hexdigest()
