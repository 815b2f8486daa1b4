"""Files that cannot be taken or drawn: a reason that many of them share is told once, with their names."""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from pathlib import PurePosixPath

from lagdsl.exchange.robots.findings import Findings
from lagdsl.exchange.robots.reach import OutsideError
from lagdsl.foundation.meshes.triangles import MeshError
from lagdsl.foundation.record import record
from lagdsl.foundation.source import Span

_NAMED = 12  # names of one note
_LONGEST = 60  # characters of a name


@record()
class MeshFault:
    """A mesh, or another file, by the name that the robot's file gives it, the place of that name, and the reason.
    `help` is a way out of its own."""

    file: str
    span: Span
    reason: str
    kind: str = "mesh"
    help: str | None = None


def fault_of(file: str, span: Span, fault: MeshError, kind: str = "mesh") -> MeshFault:
    return MeshFault(file, span, str(fault), kind, fault.help if isinstance(fault, OutsideError) else None)


def once_for_each_reason(faults: Iterable[MeshFault]) -> Iterator[tuple[MeshFault, tuple[str, ...]]]:
    """The first mesh of each reason, and notes that name the others."""
    shared: dict[tuple[str, str | None, str], dict[str, MeshFault]] = {}
    for fault in faults:
        shared.setdefault((fault.kind, fault.help, fault.reason), {}).setdefault(fault.file, fault)
    for meshes in shared.values():
        first, *others = meshes.values()
        yield first, _note(others) if others else ()


def tell_faults(faults: Iterable[MeshFault], findings: Findings, instead: str | None) -> None:
    """E1013 for each reason."""
    for fault, notes in once_for_each_reason(faults):
        words = {"kind": fault.kind, "file": fault.file, "reason": fault.reason}
        findings.error("E1013", fault.span, notes=notes, help=fault.help, instead=instead, **words)


def _note(others: list[MeshFault]) -> tuple[str, ...]:
    names = [f"`{PurePosixPath(each.file).name[:_LONGEST]}`" for each in others]
    rest = [f"{len(names) - _NAMED} more"] if len(names) > _NAMED else []
    return (f"the same holds for {', '.join([*names[:_NAMED], *rest])}",)
