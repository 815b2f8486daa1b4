"""Lines of the certificate on conserved quantities: their values along the motion."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

import numpy as np

from lagdsl.algebra.graph.operation import Group
from lagdsl.exchange.verify.certificate import Line
from lagdsl.exchange.verify.conserved.noise import with_size
from lagdsl.exchange.verify.conserved.quantity import ConservedQuantity, Term
from lagdsl.exchange.verify.states import coordinate_sizes
from lagdsl.foundation.numerics.rank import Floats
from lagdsl.motion.pipeline import Compilation
from lagdsl.motion.signals.trajectory import Trajectory

_PERMITTED = 1e3  # times the tolerance of the integration, as for the invariants of a model
_ROUNDING = 1e-10


def along(
    compilation: Compilation, found: Sequence[ConservedQuantity], motion: Trajectory, p: Floats, tolerance: float
) -> Iterator[Line]:
    """One for each: the largest drift from the value at the start, as a part of the terms that it is the sum of."""
    states = _states(compilation, motion, p)
    sizes = coordinate_sizes(compilation.flat, compilation.program, p)
    natural = {Group.Q: sizes, Group.QD: sizes / (np.ptp(motion.time) or 1.0)}
    for quantity in found:
        values, size = _values(compilation, quantity.terms, states, natural)
        drift = np.max(np.abs(values - values[0])) if len(values) else 0.0
        scope = "" if quantity.for_all_parameters else ", with these values of the parameters"
        yield Line(
            name=f"conserved {quantity.expression}",
            says=f"constant along the motion: {quantity.because}",
            figure=float(drift / size) if size > 0.0 else float(drift),
            limit=max(_PERMITTED * tolerance, _ROUNDING),
            note=f"at random states its rate is {quantity.remainder:.0e} of its terms{scope}",
        )


def _values(
    compilation: Compilation, terms: Sequence[Term], states: dict[Group, Floats], natural: dict[Group, Floats]
) -> tuple[Floats, float]:
    names = [item.name for item in compilation.flat.parameters if not item.structural]
    nodes = [term.candidate.value for term in terms]
    values, sizes = with_size(compilation.equations.graph, nodes, states, natural)
    weights = np.stack([term.coefficient.of(states[Group.P], names) for term in terms], axis=1)
    size = float(np.max(np.sum(np.abs(weights) * sizes, axis=1), initial=0.0))
    return np.sum(weights * values, axis=1), size


def _states(compilation: Compilation, motion: Trajectory, p: Floats) -> dict[Group, Floats]:
    """Rows of the motion; quantities that are found depend on nothing else."""
    names = [item.name for item in compilation.flat.coordinates]
    q = np.stack([motion[name] for name in names], axis=1)
    qd = np.stack([motion[f"der({name})"] for name in names], axis=1)
    return {Group.TIME: motion.time, Group.Q: q, Group.QD: qd, Group.P: np.broadcast_to(p, (len(q), len(p)))}
