"""A state and what it is, as people read it: display units, only what is not zero."""

from __future__ import annotations

from lagdsl.language.flat.display import Display, display, display_rate
from lagdsl.motion.analysis.point import Point, System
from lagdsl.motion.analysis.steady import Steadiness, imbalance

_MOST = 12


def point_text(system: System, point: Point) -> str:
    """`theta = 30 deg, der(phi) = 5 rad/s`; what is zero is left out."""
    flat = system.flat
    groups: list[tuple[str, float, Display]] = [
        *((c.name, value, display(c)) for c, value in zip(flat.coordinates, point.q.tolist(), strict=True)),
        *((f"der({c.name})", v, display_rate(c)) for c, v in zip(flat.coordinates, point.qd.tolist(), strict=True)),
        *((s.name, value, display(s)) for s, value in zip(flat.states, point.z.tolist(), strict=True)),
        *((i.name, value, display(i)) for i, value in zip(flat.inputs, point.u.tolist(), strict=True)),
    ]
    shown = [f"{name} = {unit(value):.6g} {unit.unit}".rstrip() for name, value, unit in groups if abs(value) > 1e-12]
    more = [f"and {len(shown) - _MOST} more"] if len(shown) > _MOST else []
    return "  " + (", ".join([*shown[:_MOST], *more]) or "all zero")


def steadiness_text(found: Steadiness) -> str:
    """Kind of the point, and the entries that run there."""
    match found.kind:
        case "equilibrium":
            return "This is an equilibrium."
        case "steady motion":
            return _steady_text(found)
        case "no freedom":
            return "Nothing is free to move here: the state has no entry that could change by itself."
        case "neither":
            return f"This is neither an equilibrium nor a steady motion: {imbalance(found)}."


def _steady_text(found: Steadiness) -> str:
    names = () if found.turning is None else found.turning.names
    running = [name for name in found.running if name.rpartition("[")[0] not in names]
    parts = []
    if found.turning is not None:
        many = len(names) > 1
        it = "them" if many else "it"
        axes = f"that turn with {it}" if found.turning.with_body else f"that do not spin with {it}"
        told = f"{'turn' if many else 'turns'} steadily, and modes are expressed in axes {axes}"
        parts.append(f"{', '.join(f'`{name}`' for name in names)} {told}")
    if running:
        parts.append(f"these quantities change steadily and influence nothing else: {', '.join(running)}")
    return f"This is a steady motion; {'; '.join(parts)}."
