"""Loads that do no work on any admissible motion, the lecture's non-contributing forces (N0519).

A load is idle if its generalized forces are identically zero: what it pushes does not move that way, whatever the
coordinates do.
"""

from __future__ import annotations

from lagdsl.derivation.mechanics.equations import Equations
from lagdsl.derivation.mechanics.lagrange.loads import VirtualWork, add_load, generalized_forces
from lagdsl.derivation.mechanics.zero_test import vanish
from lagdsl.foundation.diagnostics import Sink

# Each load takes a sweep of its own; in a larger model that would cost the square of its size.
_MOST_LOADS = 32


def report_idle_loads(equations: Equations, sink: Sink) -> None:
    """A note for each load that enters no equation of motion and is not told by W0514; many loads are not looked at."""
    loads = equations.flat.loads
    if len(loads) > _MOST_LOADS:
        return
    told = [diagnostic.labels[0].span for diagnostic in sink.diagnostics if diagnostic.code == "W0514"]
    for load in loads:
        if not load.spans or load.spans[0] in told:
            continue
        work = VirtualWork(equations.graph)
        add_load(equations.lowering, load, work)
        if vanish(equations, generalized_forces(work, equations.symbols.directions)):
            sink.report("N0519", load.spans[0])
