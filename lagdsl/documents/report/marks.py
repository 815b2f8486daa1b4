"""A figure before it has a format: lines, balls and arrows in points of a page, y upward."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Literal, TypeAlias

from lagdsl.documents.report.boxes import Box

Place: TypeAlias = tuple[float, float]
Style: TypeAlias = Literal["rod", "thin", "outline", "ground", "reference"]
Role: TypeAlias = Literal["coordinate", "motion", "load", "weight"]


@dataclass(frozen=True, slots=True)
class Stroke:
    points: tuple[Place, ...]
    style: Style


@dataclass(frozen=True, slots=True)
class Ball:
    """A mass; a `hollow` one is a body at its mass centre."""

    center: Place
    radius: float
    hollow: bool


@dataclass(frozen=True, slots=True)
class Arrow:
    """An arrow along `points`, its label at `at`. `number` is that of its coordinate, which has a color."""

    points: tuple[Place, ...]
    role: Role
    label: Box | None
    at: Place
    number: int = 0


@dataclass(frozen=True, slots=True)
class Caption:
    """The name of what stands at `point`, at `at`."""

    point: Place
    label: Box
    at: Place


Mark: TypeAlias = Stroke | Ball | Arrow | Caption


@dataclass(frozen=True, slots=True)
class Figure:
    """`words` say what is drawn, for those who do not see it."""

    width: float
    height: float
    marks: tuple[Mark, ...]
    words: str


# Colors of coordinates, dark enough on white and light enough on black; those of loads and weights.
COLORS = ("2f6fb5", "b8602a", "2e8b57", "8a5cb8", "a8862a", "2a95a0")
LOAD, WEIGHT = "c0392b", "7f8c8d"


def color(arrow: Arrow) -> str:
    if arrow.role in ("load", "weight"):
        return LOAD if arrow.role == "load" else WEIGHT
    return COLORS[arrow.number % len(COLORS)]
