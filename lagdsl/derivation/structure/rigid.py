"""Can anything move at all?"""

from __future__ import annotations

from lagdsl.derivation.structure.dependence import Dependence
from lagdsl.derivation.structure.moments import comes_from_outside
from lagdsl.derivation.structure.names import comes_and_goes, place
from lagdsl.foundation.diagnostics import Sink
from lagdsl.language.flat.balanced import balanced
from lagdsl.language.flat.model import FlatModel


def report_rigid(flat: FlatModel, found: Dependence, sink: Sink) -> None:
    """N0611 where constraints that are always there leave no degree of freedom, and neither time nor an input nor a
    state moves them."""
    independent = sum(not redundant for redundant in found.redundant)
    if not flat.coordinates or independent < len(flat.coordinates) or flat.states:
        return
    if any(comes_and_goes(constraint) or balanced(constraint) for constraint in flat.constraints):
        return
    if comes_from_outside(flat):
        return
    text = f"{independent} independent constraint{'' if independent == 1 else 's'} on as many coordinates"
    written = [constraint for constraint in flat.constraints if place(constraint) is not None]
    sink.report("N0611", place(written[-1]) if written else None, independent=text)
