"""Rolled code: stretches of statements of the same shape share one text, and what repeats is a loop.

Found in the schedule itself: no array in the model's text is needed for it. Operations and their order are those of the
straight line, so that results are the same to the bit.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from types import MappingProxyType

from lagdsl.derivation.program.passes.repeat import Run, runs
from lagdsl.engines.backends.c.dialect import Place
from lagdsl.engines.backends.c.shape import Leaf, Shaped, Shapes
from lagdsl.engines.backends.c.statement import Listing
from lagdsl.foundation.record import record

# Loose stretches are cut into pieces of this length.
_LONGEST_PIECE = 150
_EXTERNAL = -1


@dataclass(slots=True)
class Kernel:
    """One text for all of its `runs`. `body` and `local` tell, per statement of a lap, its shape and, per leaf, which
    statement of the same lap it is, or -1; `exports` are the statements whose values go to the scratch array."""

    body: tuple[int, ...]
    local: tuple[tuple[int, ...], ...]
    runs: list[Run]
    exports: list[int]


@record()
class Rolled:
    """`order` names the kernels in the order of the calls, each with the run that it does then."""

    shapes: Shapes
    shaped: tuple[Shaped, ...]
    kernels: tuple[Kernel, ...]
    order: tuple[tuple[int, int], ...]
    slot: dict[int, int]
    scratch: int

    @property
    def length(self) -> int:
        """Statements in the text."""
        return sum(len(kernel.body) for kernel in self.kernels)


def reroll(listing: Listing, fused: Mapping[int, int] = MappingProxyType({})) -> Rolled:
    """Kernels and the order of their runs."""
    shapes = Shapes(listing, fused)
    shaped = tuple(shapes.of(statement) for statement in listing.statements)
    kernels: dict[object, Kernel] = {}
    number: dict[int, int] = {}
    order: list[tuple[int, int]] = []
    exported: set[int] = set()
    for run in _pieces(runs([statement.shape for statement in shaped])):
        local = _locals(shaped, run)
        exported |= _outside(shaped, run, local)
        body = tuple(shaped[run.start + index].shape for index in range(run.period))
        key = (body, local, run.count > 1)
        kernel = kernels.get(key)
        if kernel is None:
            kernel = kernels[key] = Kernel(body, local, [], [])
            number[id(kernel)] = len(kernels) - 1
        order.append((number[id(kernel)], len(kernel.runs)))
        kernel.runs.append(run)
    for kernel in kernels.values():
        kernel.exports = [index for index in range(len(kernel.body)) if _is_exported(kernel, index, exported)]
    slot, scratch = _slots(tuple(kernels.values()), order, listing.gathered)
    return Rolled(shapes, shaped, tuple(kernels.values()), tuple(order), slot, scratch)


def columns(rolled: Rolled, kernel: Kernel, index: int, leaf: int) -> list[list[Leaf]]:
    """The leaves at one place of statement `index`: per run, per lap; variables by their place in scratch."""
    return [[_resolved(rolled, rolled.shaped[at].leaves[leaf]) for at in laps(run, index)] for run in kernel.runs]


def laps(run: Run, index: int) -> range:
    """The statements that are number `index` of their lap."""
    return range(run.start + index, run.stop, run.period)


def _resolved(rolled: Rolled, leaf: Leaf) -> Leaf:
    return rolled.slot[leaf] if isinstance(leaf, int) else leaf.index if isinstance(leaf, Place) else leaf


def _pieces(found: tuple[Run, ...]) -> list[Run]:
    pieces: list[Run] = []
    for run in found:
        if run.count > 1:
            pieces.append(run)
            continue
        starts = range(run.start, run.stop, _LONGEST_PIECE)
        pieces.extend(Run(start, min(_LONGEST_PIECE, run.stop - start), 1) for start in starts)
    return pieces


def _locals(shaped: tuple[Shaped, ...], run: Run) -> tuple[tuple[int, ...], ...]:
    """Per statement of a lap, per leaf: the statement of the same lap that it is in every lap, or -1."""
    return tuple(
        tuple(_local(shaped, run, index, leaf) for leaf in range(len(shaped[run.start + index].leaves)))
        for index in range(run.period)
    )


def _local(shaped: tuple[Shaped, ...], run: Run, index: int, leaf: int) -> int:
    first = shaped[run.start + index].leaves[leaf]
    if not isinstance(first, int) or not run.start <= first < run.start + index:
        return _EXTERNAL
    distance = run.start + index - first
    same = all(shaped[at].leaves[leaf] == at - distance for at in laps(run, index))
    return first - run.start if same else _EXTERNAL


def _outside(shaped: tuple[Shaped, ...], run: Run, local: tuple[tuple[int, ...], ...]) -> set[int]:
    """The variables that a run reads from elsewhere, or from another lap."""
    found: set[int] = set()
    for index, of_leaves in enumerate(local):
        for leaf, where in enumerate(of_leaves):
            if where == _EXTERNAL and isinstance(shaped[run.start + index].leaves[leaf], int):
                found.update(x for at in laps(run, index) if isinstance(x := shaped[at].leaves[leaf], int))
    return found


def _is_exported(kernel: Kernel, index: int, exported: set[int]) -> bool:
    return any(at in exported for run in kernel.runs for at in laps(run, index))


def _slots(kernels: tuple[Kernel, ...], order: list[tuple[int, int]], first: int) -> tuple[dict[int, int], int]:
    """Places in the scratch array, lap by lap, so that they lie at equal distances."""
    slot: dict[int, int] = {}
    for which, number in order:
        kernel = kernels[which]
        run = kernel.runs[number]
        for start in range(run.start, run.stop, run.period):
            for index in kernel.exports:
                slot[start + index] = first
                first += 1
    return slot, first
