"""Modes of the linearized motion: eigenvalues, frequencies, damping, shapes, and what they say about stability."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from lagdsl.foundation.diagnostics import Severity, Sink
from lagdsl.foundation.numerics.rank import Floats
from lagdsl.motion.analysis.border import on_both_sides
from lagdsl.motion.analysis.eigen import Complexes, eigen
from lagdsl.motion.analysis.held import sampled
from lagdsl.motion.analysis.integrable import integrable_rows
from lagdsl.motion.analysis.linearize import Named, Reduced, holonomic_rows, reduce, state_names
from lagdsl.motion.analysis.point import Point, System
from lagdsl.motion.analysis.sampled.modes import loop_modes
from lagdsl.motion.analysis.sampled.verdict import SampledModes
from lagdsl.motion.analysis.steady import Steadiness, imbalance, steadiness

# Real parts below this part of the eigenvalue's magnitude count as zero: twice the digits of a double eigenvalue.
AXIS = 1e-7
_MOST_TOLD = 4


@dataclass(frozen=True, slots=True, kw_only=True)
class Modes:
    """`eigenvalues` (n,) [1/s], the zeros last; a row of `shapes` (n, ns) is one mode over `places`.

    `places` are all coordinates and first-order states; the largest entry of a shape is 1, others are relative to it in
    SI units, complex numbers telling amplitude and phase. `vectors` (nx, n) are eigenvectors of the minimal state,
    generalized ones for the zeros.
    `dropped` counts zeros that were left out, one for each integrable row of velocity level. `held` are signals of
    sampled controllers: the modes are those of the plant with these signals held. `loop` has the multipliers of the
    loop that they close, which decide; where there is none, `unjudged` tells why.
    """

    model: str
    point: Point
    states: tuple[Named, ...]
    places: tuple[Named, ...]
    eigenvalues: Complexes
    vectors: Complexes
    shapes: Complexes
    steadiness: Steadiness
    dropped: int
    integrable: tuple[str, ...]
    held: tuple[str, ...] = ()
    loop: SampledModes | None = None
    unjudged: str = ""

    @property
    def frequencies(self) -> Floats:
        """Natural frequencies abs(s)/(2 pi) [Hz] (n,); 0 for modes that do not oscillate."""
        size = np.abs(self.eigenvalues)
        return np.where(np.abs(self.eigenvalues.imag) > AXIS * size, size / (2.0 * np.pi), 0.0)

    @property
    def damping(self) -> Floats:
        """Damping ratios -Re(s)/abs(s) (n,); nan for s = 0."""
        size = np.abs(self.eigenvalues)
        return np.where(size > 0.0, -self.eigenvalues.real / np.where(size > 0.0, size, 1.0), np.nan)

    @property
    def time_constants(self) -> Floats:
        """-1/Re(s) [s] (n,), in which a mode falls to 1/e, negative where it grows; inf on the imaginary axis."""
        real = np.where(np.abs(self.eigenvalues.real) > AXIS * np.abs(self.eigenvalues), self.eigenvalues.real, 0.0)
        return np.where(real != 0.0, -1.0 / np.where(real != 0.0, real, 1.0), np.inf)

    @property
    def unstable(self) -> int:
        """Number of eigenvalues with positive real part."""
        return int(np.count_nonzero(self.eigenvalues.real > AXIS * np.abs(self.eigenvalues)))

    @property
    def stability(self) -> str:
        """One sentence about the linearized motion, of a sampled loop about the loop."""
        return statement(self)


def modes_at(system: System, point: Point, sink: Sink) -> Modes | None:
    """Modes about `point`; None after errors. W0854 where the point is neither equilibrium nor steady motion."""
    rows = holonomic_rows(system)
    plain = _reduced(system, point, rows, sink)
    if plain is None:
        return None
    integrable = integrable_rows(system, point)
    at = plain if not integrable else _reduced(system, point, [*rows, *integrable], sink)
    if at is None:
        return None
    found = steadiness(system, plain)
    signals = sampled(system)
    own = Sink()
    loop = loop_modes(system, point, own) if signals else None
    if found.kind == "neither" and loop is None:
        sink.report("W0854", None, reason=imbalance(found))
    turned = at if found.turning is None else found.turning.relative(at)
    values, vectors = eigen(turned.a)
    layout = system.engine.layout
    return Modes(
        model=system.flat.name,
        point=point,
        states=state_names(system, at.partition),
        places=tuple(Named(slot.name, slot.unit) for slot in (*layout.coordinates, *layout.states)),
        eigenvalues=values,
        vectors=_normalized(vectors),
        shapes=_normalized(_displacements(at, vectors)).T,
        steadiness=found,
        dropped=len(plain.value) - len(at.value),
        integrable=tuple(layout.constraints[row].name for row in integrable),
        held=signals,
        loop=loop,
        unjudged="; ".join(each.message for each in own.diagnostics if each.severity is Severity.ERROR),
    )


def growth(at: Reduced) -> tuple[float, ...]:
    """Real parts [1/s] of modes that grow, largest first, beyond what rounding makes of a double zero beside the
    fastest mode."""
    values = eigen(at.a)[0]
    least = AXIS * float(np.max(np.abs(values), initial=0.0))
    return tuple(sorted((real for real in values.real.tolist() if real > least), reverse=True))


def _reduced(system: System, point: Point, held: Sequence[int], sink: Sink) -> Reduced | None:
    at = reduce(system, point, held, sink, outputs=False)
    return None if at is None else on_both_sides(system, at, sink, of_modes=True)


def _displacements(at: Reduced, vectors: Complexes) -> Complexes:
    """Of all coordinates and states (ns, n), dependent ones included."""
    states = len(at.value)
    moved = np.hstack([at.along.q[:states], at.along.z[:states]])
    return np.asarray(moved.T @ vectors)


def _normalized(vectors: Complexes) -> Complexes:
    """Columns whose largest entry is 1; of equal ones the first."""
    result = vectors.copy()
    for column in range(result.shape[1]):
        size = np.abs(result[:, column])
        largest = float(np.max(size, initial=0.0))
        if largest > 0.0:
            first = int(np.argmax(size >= (1.0 - 1e-9) * largest))
            result[:, column] /= result[first, column]
            result[first, column] = 1.0
    return result


def held_text(names: Sequence[str]) -> str:
    """The words for eigenvalues of a model in which samples close a loop."""
    told = ", ".join(f"`{name}`" for name in names[:_MOST_TOLD])
    more = f" and {len(names) - _MOST_TOLD} more" if len(names) > _MOST_TOLD else ""
    return f"the sampled controller is held ({told}{more}), and these figures are those of the plant alone"


def statement(modes: Modes) -> str:
    """Lyapunov's theorem on the first approximation, in plain words."""
    if modes.loop is not None:
        return modes.loop.stability
    values = modes.eigenvalues
    system = modes.steadiness.kind
    zeros = int(np.count_nonzero(values == 0.0))
    marginal = int(np.count_nonzero(np.abs(values.real) <= AXIS * np.abs(values))) - zeros
    why = f" ({modes.unjudged})" if modes.unjudged else ""
    if system == "neither" and not why:
        return "no statement: the point is neither an equilibrium nor part of a steady motion"
    if system == "no freedom":
        return "no statement: nothing is free to move, so that there is no mode"
    if modes.held:
        return f"no statement on stability: {held_text(modes.held)}{why}"
    if modes.unstable:
        growing = values[values.real > AXIS * np.abs(values)]
        oscillating = int(np.count_nonzero(np.abs(growing.imag) > AXIS * np.abs(growing)))
        how = "oscillating" if oscillating == len(growing) else "monotonic" if not oscillating else "both kinds of"
        return f"unstable {system}: {len(growing)} of {len(values)} real parts are positive ({how} growth)"
    if not marginal and not zeros:
        return f"asymptotically stable {system}: all real parts are negative"
    parts = [f"{marginal} on the imaginary axis"] if marginal else []
    parts += [f"{zeros} zero"] if zeros else []
    rest = len(values) - marginal - zeros
    if rest and not marginal:
        return f"stable {system} but for drift: {zeros} of {len(values)} eigenvalues are zero, all others decay"
    return f"no growing mode about this {system}: {' and '.join(parts)}; the linear equations decide no more"


def phase_of(entry: complex) -> float:
    """Degrees in (-179.5, 180.5]; those that are shown as 0 without the sign of rounding."""
    angle = math.degrees(math.atan2(entry.imag, entry.real))
    return 0.0 if abs(angle) < 0.5 else angle if angle > -179.5 else angle + 360.0
