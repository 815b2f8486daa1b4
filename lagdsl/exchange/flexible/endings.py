"""The endings of files of flexible bodies; without the packages that read them."""

from __future__ import annotations

from pathlib import Path

DATA = ".sid_fem"
_DECK = ".inp"


def is_body_file(path: Path) -> bool:
    """True for an input deck and for Standard Input Data."""
    return path.suffix.lower() in (DATA, _DECK)


def is_data(path: Path) -> bool:
    """True for Standard Input Data."""
    return path.suffix.lower() == DATA
