"""Multipliers of a sampled loop, and the verdict on its stability."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from lagdsl.algebra.graph.operation import Group
from lagdsl.foundation.numerics.rank import Floats
from lagdsl.language.flat.events import SampledCorner
from lagdsl.motion.analysis.eigen import Complexes, eigen
from lagdsl.motion.analysis.linearize import Named
from lagdsl.motion.analysis.point import System
from lagdsl.motion.analysis.sampled.loop import Loop
from lagdsl.motion.analysis.sampled.schedule import time_text
from lagdsl.motion.analysis.steady import first_order_sizes, without_influence

# Multipliers this near to the unit circle lie on it; those below this size are zero.
_CIRCLE = 1e-9
_ZERO = 1e-12
_RESTS = 1e-9
_SAME = 1e-7
_MOST_TOLD = 3


@dataclass(frozen=True, slots=True, kw_only=True)
class SampledModes:
    """`multipliers` (n,) by which modes change in `period` [s], over the deviations `names`; those that are one by
    structure come last. `unbalanced` are names of what changes in a period at the point and acts on others, `running`
    of what changes and acts on nothing; `clocks` counts them, `ignored` are functions that the verdict does without.
    """

    period: float
    clocks: int
    names: tuple[Named, ...]
    multipliers: Complexes
    vectors: Complexes
    running: tuple[str, ...]
    unbalanced: tuple[str, ...]
    ignored: tuple[SampledCorner, ...]

    @property
    def eigenvalues(self) -> Complexes:
        """log(multiplier)/period [1/s] (n,), of the motion that the samples show; -inf for zero."""
        with np.errstate(divide="ignore"):
            return np.asarray(np.log(self.multipliers) / self.period)

    @property
    def frequencies(self) -> Floats:
        """[Hz] (n,), below half the rate of the periods; 0 for modes that do not oscillate."""
        found = np.abs(np.angle(self.multipliers)) / (2.0 * np.pi * self.period)
        return np.where(self.multipliers != 0.0, found, 0.0)

    @property
    def time_constants(self) -> Floats:
        """-period/log(abs(multiplier)) [s] (n,), negative where a mode grows; inf on the unit circle."""
        size = np.abs(self.multipliers)
        with np.errstate(divide="ignore"):
            decay = np.where(np.abs(size - 1.0) > _CIRCLE, np.log(size), 0.0)
            return np.asarray(np.where(decay != 0.0, -self.period / np.where(decay != 0.0, decay, 1.0), np.inf))

    @property
    def largest(self) -> float:
        """The largest magnitude of a multiplier that is not one by structure; 0 without any."""
        return float(np.max(np.abs(self.multipliers[self.multipliers != 1.0]), initial=0.0))

    @property
    def unstable(self) -> int:
        """Number of multipliers outside of the unit circle."""
        return int(np.count_nonzero(np.abs(self.multipliers) > 1.0 + _CIRCLE))

    @property
    def stability(self) -> str:
        """One sentence about the sampled loop."""
        return _statement(self)


def sampled_modes(system: System, loop: Loop) -> SampledModes:
    """Of the loop, without signals that each period sets anew: they are no states."""
    kept = lasting(loop.matrix, None)
    matrix = loop.matrix[np.ix_(kept, kept)]
    drift = loop.matrix[kept, -1]
    own = matrix - np.eye(len(kept))
    values, vectors = eigen(own)
    multipliers = 1.0 + values
    multipliers[np.abs(multipliers) <= _ZERO] = 0.0
    sizes = deviation_sizes(system, loop)[kept]
    names = tuple(loop.names[k] for k in kept)
    # Rates that nothing depends on but positions may not run: they would accelerate.
    first, beyond = len(loop.at.partition.position), len(loop.at.partition.position) + len(loop.at.partition.rate)
    idle = without_influence(own, sizes, 1.0, [k for k, place in enumerate(kept) if not first <= place < beyond])
    moves = np.abs(drift) > _RESTS * sizes
    acting = {place for place in range(len(kept)) if place not in idle}
    return SampledModes(
        period=loop.period,
        clocks=len(system.flat.events.clocks),
        names=names,
        multipliers=multipliers,
        vectors=vectors,
        running=tuple(names[k].name for k in sorted(idle) if moves[k]),
        unbalanced=(*(names[k].name for k in sorted(acting) if moves[k]), *loop.switching),
        ignored=ignored(system, loop),
    )


def reads_time(system: System) -> bool:
    """True if the motion or a clause depends on time by itself."""
    program = system.program
    names = [name for name in ("residual", "velocity_constraint", "state_derivative", "event") if program.has(name)]
    nodes = (node for name in names for block in program.function(name).results for node in block.nodes)
    return any(program.graph.depends(node, Group.TIME) for node in nodes)


def is_same(system: System, loop: Loop, other: Loop) -> bool:
    """True if both have the same matrix, and the same changes in a period by themselves."""
    sizes = deviation_sizes(system, loop)
    apart = np.abs(loop.matrix - other.matrix)
    count = len(sizes)
    scaled = apart[:, :count] * sizes / sizes[:, None]
    drift = apart[:, -1] / sizes
    return bool(np.max(scaled, initial=0.0) <= _SAME and np.max(drift, initial=0.0) <= _RESTS)


def lasting(matrix: Floats, outputs: Floats | None) -> list[int]:
    """Places of deviations on which the next ones, or outputs, depend."""
    count = len(matrix)
    found = np.any(matrix[:, :count] != 0.0, axis=0)
    if outputs is not None:
        found |= np.any(outputs[:, :count] != 0.0, axis=0)
    kept = np.flatnonzero(found)
    while True:  # what only what is left out depends on is left out, too
        rest = np.any(matrix[np.ix_(kept, kept)] != 0.0, axis=0)
        if outputs is not None:
            rest |= np.any(outputs[:, kept] != 0.0, axis=0)
        if np.all(rest):
            return [int(k) for k in kept]
        kept = kept[rest]


def deviation_sizes(system: System, loop: Loop) -> Floats:
    """Natural sizes of states and signals. Rates are those of natural displacements in a second, or of the fastest mode
    of the plant."""
    chosen = loop.at.partition
    pace = max(float(np.max(np.abs(np.linalg.eigvals(loop.at.a)), initial=0.0)), 1.0)
    signals = np.maximum(np.abs(loop.point.w[list(loop.signals.places)]), 1.0)
    return np.concatenate(
        [
            chosen.sizes[list(chosen.position)],
            chosen.sizes[list(chosen.rate)] * pace,
            first_order_sizes(system, loop.point),
            signals,
        ]
    )


def ignored(system: System, loop: Loop) -> tuple[SampledCorner, ...]:
    """Functions with corners in what acts."""
    acting = {slot.name for place, slot in enumerate(system.program.layout.discretes)
              if place in (*loop.signals.places, *loop.signals.modes)}  # fmt: skip
    acting |= {name.removeprefix("der(").removesuffix(")") for name in system.program.layout.instants.resets}
    return tuple(each for each in system.flat.events.sampled if acting & set(each.variables))


def names_text(names: Sequence[str]) -> str:
    """`limit(...)`, `floor(x/q)` and 2 more."""
    more = f" and {len(names) - _MOST_TOLD} more" if len(names) > _MOST_TOLD else ""
    return ", ".join(f"`{name}`" for name in names[:_MOST_TOLD]) + more


def _statement(found: SampledModes) -> str:
    """By the largest multiplier."""
    period = time_text(found.period)
    at = f"at {period}" if found.clocks == 1 else f"over the common period {period}"
    if found.unbalanced:
        names = ", ".join(f"`{name}`" for name in found.unbalanced[:_MOST_TOLD])
        change = f"{names} {'changes' if len(found.unbalanced) == 1 else 'change'} in a period at this point"
        return f"no statement on the sampled loop: {change}; `--trim` takes a fixed point"
    at += f", without {names_text([each.name for each in found.ignored])}" if found.ignored else ""
    drifting = int(np.count_nonzero(found.multipliers == 1.0))
    size = f"{found.largest:.6g}"
    if found.unstable:
        return f"unstable: largest multiplier {size} {at}"
    on_circle = int(np.count_nonzero(np.abs(found.multipliers) >= 1.0 - _CIRCLE)) - drifting
    if on_circle:
        told = f"{on_circle} of {len(found.multipliers)} multipliers lie on the unit circle {at}"
        return f"no growing mode: {told}; the linear equations decide no more"
    if drifting:
        told = f"{drifting} of {len(found.multipliers)} multipliers {'is' if drifting == 1 else 'are'} one"
        return f"stable but for drift: {told}, the largest other one is {size} {at}"
    return f"stable: largest multiplier {size} {at}"
