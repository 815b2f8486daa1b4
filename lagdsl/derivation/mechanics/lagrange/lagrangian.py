"""Energies of a model: T, V, the Lagrangian L = T - V + lagrangian terms, and Rayleigh's function D."""

from __future__ import annotations

from lagdsl.algebra.graph.graph import Graph
from lagdsl.derivation.mechanics.lagrange.inertial_elements import InertialElement, inertial_elements, kinetic_energy
from lagdsl.derivation.mechanics.lowering.acceleration import refuse_accelerations
from lagdsl.derivation.mechanics.lowering.lowering import Lowering
from lagdsl.foundation.record import record
from lagdsl.language.flat.model import FlatModel


@record(kw_only=True)
class Energies:
    """Nodes [J], `dissipation` [W]. `extra` is the sum of the `lagrangian` terms."""

    kinetic: int
    potential: int
    extra: int
    dissipation: int
    lagrangian: int
    inertial_elements: tuple[InertialElement, ...]


def energies(lowering: Lowering, flat: FlatModel) -> Energies:
    """All declared contributions summed; masses and bodies add 1/2 m v.v + 1/2 omega.I omega and -m g.r."""
    graph = lowering.graph
    found = inertial_elements(lowering, flat)
    totals = {
        "kinetic": graph.sum(kinetic_energy(graph, carrier) for carrier in found),
        "potential": _weight(lowering, flat, found),
        "lagrangian": graph.zero,
        "dissipation": graph.zero,
    }
    for term in flat.energies:
        lowering.place = term.spans
        value = lowering.scalar(term.value)
        refuse_accelerations(graph, [value], term.spans, f"`{term.kind}`")
        totals[term.kind] = graph.add(totals[term.kind], value)
    free = graph.subtract(totals["kinetic"], totals["potential"])
    return Energies(
        kinetic=totals["kinetic"],
        potential=totals["potential"],
        extra=totals["lagrangian"],
        dissipation=totals["dissipation"],
        lagrangian=graph.add(free, totals["lagrangian"]),
        inertial_elements=found,
    )


def _weight(lowering: Lowering, flat: FlatModel, found: tuple[InertialElement, ...]) -> int:
    """Sum of -m g.r from the world origin; `gravity` may depend on time and parameters."""
    graph: Graph = lowering.graph
    if flat.gravity is None:
        return graph.zero
    gravity = lowering.vector(flat.gravity)
    heights = (graph.multiply(carrier.mass, graph.dot(gravity, carrier.position)) for carrier in found)
    return graph.negate(graph.sum(heights))
