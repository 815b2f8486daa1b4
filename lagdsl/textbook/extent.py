"""How large a derivation on paper would become, judged before anything is differentiated."""

from __future__ import annotations

from dataclasses import dataclass

from lagdsl.semantics.flat_model import FlatModel, Frame, Rotate, RotateAbout, RotateQuaternion, SetAxes

_MOST_COORDINATES = 6
_MOST_CARRIERS = 12
_MOST_LOADS = 24
_MOST_ROWS = 12
_DEEPEST_TURNS = 6
_MOST_DEFINITIONS = 200


@dataclass(frozen=True, slots=True, kw_only=True)
class Extent:
    """`reasons` say, in plain words, what is beyond the bounds of a written-out derivation; none if nothing is."""

    reasons: tuple[str, ...]


def extent(flat: FlatModel) -> Extent:
    rows = sum(len(constraint.rows) for constraint in flat.constraints)
    measures = (
        (len(flat.coordinates), _MOST_COORDINATES, "coordinates"),
        (len(flat.masses) + len(flat.bodies), _MOST_CARRIERS, "masses and bodies"),
        (len(flat.loads), _MOST_LOADS, "loads"),
        (rows, _MOST_ROWS, "constraint rows"),
        (_turns(flat), _DEEPEST_TURNS, "rotations in a row"),
        (len(flat.named), _MOST_DEFINITIONS, "definitions, points and frames"),
    )
    return Extent(reasons=tuple(f"{value} {noun} (at most {most})" for value, most, noun in measures if value > most))


def _turns(flat: FlatModel) -> int:
    """The longest run of rotations from the world to a frame."""
    depth = {"world": 0}
    for item in flat.named:
        if isinstance(item, Frame):
            own = sum(isinstance(step, Rotate | RotateAbout | RotateQuaternion | SetAxes) for step in item.steps)
            depth[item.name] = depth.get(item.parent, 0) + own
    return max(depth.values())
