"""The files of the C runtime that are the hybrid core: events, contacts with friction, impulses, and the scan."""

from __future__ import annotations

from pathlib import Path

FOLDERS = ("events", "contacts", "impulses")
SCAN = ("run_scan", "run_instants", "run_zero_crossings", "run_corners", "scan")


def hybrid_core(runtime: Path) -> list[Path]:
    """Sources and headers below `runtime`, the folder `lag/`."""
    folders = [path for folder in FOLDERS for path in sorted((runtime / folder).rglob("*.[ch]"))]
    scan = [path for path in sorted((runtime / "run").glob("*.[ch]")) if path.stem in SCAN]
    assert len(scan) == len(SCAN)
    return [*folders, *scan]
