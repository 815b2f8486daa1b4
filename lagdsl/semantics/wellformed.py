"""Physics that needs only the flat model: what is never used, counted twice, or impossible."""

from __future__ import annotations

from lagdsl.diagnostics import Sink
from lagdsl.semantics import flat_model as fm
from lagdsl.semantics.flat_dependence import Dependence
from lagdsl.semantics.wellformed_bounds import check_bounds
from lagdsl.semantics.wellformed_effect import check_effects, check_unused_coordinates
from lagdsl.semantics.wellformed_energy import check_energies
from lagdsl.semantics.wellformed_frames import check_frames
from lagdsl.semantics.wellformed_gravity import check_gravity
from lagdsl.semantics.wellformed_inertia import check_inertias


def check(flat: fm.FlatModel, sink: Sink) -> None:
    """Report every fault of family 05 that shows before anything is derived; degrees of freedom come later."""
    dependence = Dependence(flat)
    check_unused_coordinates(flat, dependence, sink)
    check_energies(flat, dependence, sink)
    check_inertias(flat, dependence, sink)
    check_gravity(flat, dependence, sink)
    check_effects(flat, dependence, sink)
    check_frames(flat, sink)
    check_bounds(flat, sink)
