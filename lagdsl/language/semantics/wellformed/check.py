"""Physics that needs only the flat model: what is never used, counted twice, or impossible."""

from __future__ import annotations

from lagdsl.foundation.diagnostics import Sink
from lagdsl.language.flat import model as fm
from lagdsl.language.flat.dependence import Dependence
from lagdsl.language.semantics.wellformed.bounds import check_bounds
from lagdsl.language.semantics.wellformed.constraints import check_constraints
from lagdsl.language.semantics.wellformed.doubled import check_doubled
from lagdsl.language.semantics.wellformed.effect import check_effects, check_unused_coordinates
from lagdsl.language.semantics.wellformed.energy import check_energies
from lagdsl.language.semantics.wellformed.frames import check_frames
from lagdsl.language.semantics.wellformed.free_parameters import check_free_parameters
from lagdsl.language.semantics.wellformed.gravity import check_gravity
from lagdsl.language.semantics.wellformed.immobile import check_freedom
from lagdsl.language.semantics.wellformed.inertia import check_inertias
from lagdsl.language.semantics.wellformed.measurements import check_measurements
from lagdsl.language.semantics.wellformed.reactions import check_reactions


def check(flat: fm.FlatModel, sink: Sink, *, sampled: bool = True) -> None:
    """Report every fault of family 05 that shows before anything is derived; degrees of freedom come later.

    Without `sampled` functions are not compared at random moments (W0511, W0526, W0527): that takes as long as all the
    rest.
    """
    dependence = Dependence(flat)
    check_unused_coordinates(flat, dependence, sink)
    check_energies(flat, dependence, sink)
    check_inertias(flat, dependence, sink)
    check_gravity(flat, dependence, sink, sampled=sampled)
    check_freedom(flat, dependence, sink)
    if sampled:
        check_doubled(flat, dependence, sink)
    check_effects(flat, dependence, sink)
    check_reactions(flat, sink)
    check_constraints(flat, sink)
    check_frames(flat, sink)
    check_bounds(flat, sink)
    check_free_parameters(flat, sink)
    check_measurements(flat, sink)
