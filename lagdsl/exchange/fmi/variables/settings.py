"""Settings of an exported model beside its equations: its start, and the sizes by which accuracy is measured.

The same numbers that `simulate/` gives to the C runtime, for the default parameters.
"""

from __future__ import annotations

from collections.abc import Sequence
from decimal import Decimal

import numpy as np

from lagdsl.derivation.structure.functions import ProgramFunctions
from lagdsl.derivation.structure.names import contact_rows
from lagdsl.derivation.structure.points import geometry
from lagdsl.derivation.structure.scales import scales_of
from lagdsl.engines.backends.start import Start
from lagdsl.engines.runtime.engines.engine import Engine
from lagdsl.foundation.numerics.rank import Floats
from lagdsl.foundation.record import record
from lagdsl.language.flat.model import FlatModel
from lagdsl.motion.pipeline import Compilation

# A tick nearer to the start than this part of the period is there (lag/events/instant.c).
_SAME_TICK = 1e-9


@record(kw_only=True)
class Settings:
    """Of `lag_fmu` in lag/fmu.h. `nominal`, `groups`, `natural`, `caps`: (2 nq + nz,) in the order of
    (q, qd, z); `row_sizes`, `lasting`: (nc,); `inputs` (nu,) are the default inputs at the start, `parameters`
    (np) the defaults with free ones as they were found, `clocks` (nclock) periods and times from the start to the first
    tick; SI units."""

    start: Start
    parameters: tuple[float, ...]
    inputs: tuple[float, ...]
    nominal: tuple[float, ...]
    groups: tuple[float, ...]
    natural: tuple[float, ...]
    caps: tuple[float, ...]
    row_sizes: tuple[float, ...]
    lasting: tuple[bool, ...]
    general: int
    clocks: tuple[tuple[float, float], ...]


def settings(
    compilation: Compilation,
    start: Start,
    engine: Engine | None = None,
    redundant: Sequence[bool] | None = None,
    parameters: Sequence[float] | None = None,
) -> Settings:
    """`start` is the consistent state for the default parameters, near which rows that are `redundant` depend on others
    (None: those that do in general), and `parameters` those with the free ones found (None: the defaults); `engine`, if
    there is one, saves an interpreter."""
    flat, layout = compilation.flat, compilation.program.layout
    functions = ProgramFunctions(compilation.program) if engine is None else engine
    space = geometry(flat, functions)
    scales = scales_of(flat, layout.components, space.q)
    loose = contact_rows(flat)
    natural = scales.sizes
    return Settings(
        start=start,
        parameters=tuple(layout.defaults if parameters is None else parameters),
        inputs=_floats(space.u),
        nominal=_floats(np.where(natural > 0.0, natural, 1.0)),
        groups=_floats(scales.groups),
        natural=_floats(natural),
        caps=_floats(scales.caps),
        row_sizes=_floats(space.row_sizes),
        lasting=tuple(row not in loose for row in range(len(layout.constraints))),
        clocks=_clocks(flat, functions, tuple(layout.defaults if parameters is None else parameters)),
        general=sum(not (flag or row in loose) for row, flag in enumerate(redundant or layout.redundant)),
    )


def _clocks(
    flat: FlatModel, functions: Engine | ProgramFunctions, parameters: Sequence[float]
) -> tuple[tuple[float, float], ...]:
    if not flat.events.clocks:
        return ()
    begin = flat.experiment.start_time
    firsts, periods = functions.evaluate("clock", begin, np.array(parameters, dtype=np.float64))
    waited = np.maximum(0.0, np.ceil((begin - firsts) / periods - _SAME_TICK))

    def shift(first: float, period: float, ticks: float) -> float:
        """In decimal places, as the numbers were written."""
        exact = [Decimal(repr(float(value))) for value in (first, period, begin)]
        return float(exact[0] + int(ticks) * exact[1] - exact[2])

    found = zip(firsts.tolist(), periods.tolist(), waited.tolist(), strict=True)
    return tuple((period, shift(first, period, ticks)) for first, period, ticks in found)


def _floats(values: Floats) -> tuple[float, ...]:
    return tuple(float(value) for value in values)
