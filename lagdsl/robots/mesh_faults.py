"""Meshes that cannot be taken or drawn: a reason that many of them share is told once, with their names."""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from pathlib import PurePosixPath

from lagdsl.record import record
from lagdsl.source import Span

_NAMED = 12  # names of one note
_LONGEST = 60  # characters of a name


@record()
class MeshFault:
    """A mesh by the name that the robot's file gives it, the place of that name, and the reason."""

    file: str
    span: Span
    reason: str


def once_for_each_reason(faults: Iterable[MeshFault]) -> Iterator[tuple[MeshFault, tuple[str, ...]]]:
    """The first mesh of each reason, and notes that name the others."""
    shared: dict[str, dict[str, MeshFault]] = {}
    for fault in faults:
        shared.setdefault(fault.reason, {}).setdefault(fault.file, fault)
    for meshes in shared.values():
        first, *others = meshes.values()
        yield first, _note(others) if others else ()


def _note(others: list[MeshFault]) -> tuple[str, ...]:
    names = [f"`{PurePosixPath(each.file).name[:_LONGEST]}`" for each in others]
    rest = [f"{len(names) - _NAMED} more"] if len(names) > _NAMED else []
    return (f"the same holds for {', '.join([*names[:_NAMED], *rest])}",)
