"""The count of the lecture: d = 3N - k for particles, 6B - k for bodies, or both."""

from __future__ import annotations

from lagdsl.flat.model import FlatModel
from lagdsl.record import record


@record(kw_only=True)
class Count:
    """N particles and B bodies have 3N + 6B coordinates in space; k conditions, stated or built into the choice of
    coordinates, leave `freedom`."""

    particles: int
    bodies: int
    freedom: int

    @property
    def conditions(self) -> int:
        return 3 * self.particles + 6 * self.bodies - self.freedom


def count(flat: FlatModel, freedom: int) -> Count | None:
    """None where inertia stands in energies written by hand, or where the masses have fewer freedoms than that."""
    particles, bodies = len(flat.masses), len(flat.bodies)
    line = Count(particles=particles, bodies=bodies, freedom=freedom)
    by_hand = any(term.kind in ("kinetic", "lagrangian") for term in flat.energies)
    return line if particles + bodies and line.conditions >= 0 and not by_hand else None


def count_text(line: Count) -> str:
    """`d = 3N - k = 3*2 - 5 = 1`"""
    symbols, numbers = [], []
    if line.particles:
        symbols.append("3N")
        numbers.append(f"3*{line.particles}")
    if line.bodies:
        symbols.append("6B")
        numbers.append(f"6*{line.bodies}")
    return f"d = {' + '.join(symbols)} - k = {' + '.join(numbers)} - {line.conditions} = {line.freedom}"
