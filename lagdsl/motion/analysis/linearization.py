"""Result of `linearize`: matrices with names and units."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace
from typing import TYPE_CHECKING

import numpy as np

from lagdsl.foundation.diagnostics import Sink, failed
from lagdsl.foundation.diagnostics.suggest import listing
from lagdsl.foundation.numerics.connected_blocks import Flags
from lagdsl.foundation.numerics.rank import Floats
from lagdsl.motion.analysis.border import on_both_sides
from lagdsl.motion.analysis.control.margins import Margins
from lagdsl.motion.analysis.control.package import python_control, signal_name
from lagdsl.motion.analysis.control.transfer import TransferFunction, transfer_function
from lagdsl.motion.analysis.control.zeros import Matrices, invariant_zeros
from lagdsl.motion.analysis.dependence import dependence, idle_charges
from lagdsl.motion.analysis.eigen import Complexes, eigen
from lagdsl.motion.analysis.linearize import Named, Reduced, holonomic_rows, reduce, state_names
from lagdsl.motion.analysis.point import Point, System
from lagdsl.motion.analysis.steady import Steadiness, steadiness

if TYPE_CHECKING:
    import control


@dataclass(frozen=True, slots=True, kw_only=True)
class Linearization:
    """d(dx)/dt = A dx + B du, dy = C dx + D du about a point, SI units; x is the minimal state.

    A (nx, nx), B (nx, nu), C (ny, nx), D (ny, nu); rows and columns are named by `states`, `inputs`, `outputs`. `rate`
    (nx,) is dx/dt at the point itself, which is zero at an equilibrium. `left_out` are charges that no other state, no
    output and no relation depends on: the circuit depends on their rates alone.

    With `every` [s] the system is sampled: dx[k+1] = A dx[k] + B du[k], dy[k] = C dx[k] + D du[k], at instants that far
    from each other; `rate` is the change of x in that time, `left_out` are also discrete variables that the ticks set
    anew, and `without` names limits and quantizers of clauses, which small motions do not see.
    """

    model: str
    point: Point
    states: tuple[Named, ...]
    inputs: tuple[Named, ...]
    outputs: tuple[Named, ...]
    left_out: tuple[Named, ...]
    A: Floats
    B: Floats
    C: Floats
    D: Floats
    rate: Floats
    steadiness: Steadiness
    every: float | None = None
    without: tuple[str, ...] = ()

    @property
    def poles(self) -> Complexes:
        """Eigenvalues of A (nx,) [1/s], of a sampled system its multipliers; zeros last, exact."""
        return eigen(self.A)[0]

    @property
    def zeros(self) -> Complexes:
        """Invariant zeros (k,) of all inputs and outputs together: exponentials exp(s t) of inputs and states with
        outputs that stay zero."""
        return invariant_zeros(*self._matrices)

    def transfer_function(self, source: str | None = None, target: str | None = None) -> TransferFunction:
        """G of y = G u from the input `source` to the output or state `target`; what there is one of may be left out.

        Raises UnknownName, and CompilationFailed where a name is missing.
        """
        a, b, c, d = self._matrices
        place = chosen([each.name for each in self.inputs], source, "input")
        told = {each.name: row for row, each in enumerate(self.outputs)}
        told |= {each.name: len(c) + row for row, each in enumerate(self.states) if each.name not in told}
        outputs = [each.name for each in self.outputs]
        name = outputs[0] if target is None and len(outputs) == 1 else target
        name = [*told][chosen([*told], name, "output")]
        whole = (a, b, np.vstack([c, np.eye(len(a))]), np.vstack([d, np.zeros((len(a), d.shape[1]))]))
        units = {each.name: each for each in (*self.states, *self.outputs)}
        return transfer_function(whole, (place, self.inputs[place]), (told[name], units[name]), self.every)

    def margins(self, source: str | None = None, target: str | None = None) -> Margins:
        """Gain, phase and delay margins of the loop that u = -y closes, in SI units; see `transfer_function`."""
        return self.transfer_function(source, target).margins

    def without_idle_charges(self) -> Linearization:
        """The same from inputs to outputs and to all other states, without charges on which nothing else depends here,
        by exact zeros of A and C; they are added to `left_out`."""
        charges = [place for place, state in enumerate(self.states) if state.unit == "C"]
        idle = charges
        while True:
            others = [i for i in range(len(self.states)) if i not in idle]
            rest = [j for j in idle if not np.any(self.A[others, j]) and not np.any(self.C[:, j])]
            if rest == idle:
                break
            idle = rest
        kept = [i for i in range(len(self.states)) if i not in idle]
        return replace(
            self,
            states=tuple(self.states[i] for i in kept),
            left_out=(*self.left_out, *(self.states[i] for i in idle)),
            A=self.A[np.ix_(kept, kept)],
            B=self.B[kept],
            C=self.C[:, kept],
            rate=self.rate[kept],
        )

    def to_control(self, *, full_state: bool = False) -> control.StateSpace:
        """A `StateSpace` of python-control with our names, in which dots are underscores, and SI units.

        Its attribute `units` maps names of signals and states to units, `left_out` names the charges that it does
        without (`without_idle_charges`). With `full_state` the outputs are the states. Raises ModuleNotFoundError
        without the package.
        """
        package = python_control()
        found = self.without_idle_charges()
        outputs = found.states if full_state else found.outputs
        count = len(found.states)
        c, d = (np.eye(count), np.zeros((count, len(found.inputs)))) if full_state else (found.C, found.D)
        names = [[signal_name(each.name) for each in group] for group in (found.states, found.inputs, outputs)]
        system = package.ss(
            found.A, found.B, c, d, 0 if self.every is None else self.every,
            states=names[0], inputs=names[1], outputs=names[2], name=signal_name(self.model),
        )  # fmt: skip
        told = (*found.states, *found.inputs, *outputs)
        system.units = {signal_name(each.name): each.unit for each in told}
        system.left_out = tuple(each.name for each in found.left_out)
        return system

    @property
    def _matrices(self) -> Matrices:
        return self.A, self.B, self.C, self.D


def chosen(known: Sequence[str], name: str | None, what: str) -> int:
    """The place of `name`, which may be None where there is one. Raises UnknownName, and CompilationFailed (E0861)."""
    if name is None and len(known) == 1:
        return 0
    if name in known:
        return known.index(name)
    sink = Sink()
    if name is None:
        told = listing("", known, "`{}`")
        sink.report("E0861", None, what=what, count=len(known), known=told)
    else:
        sink.report("E0853", None, name=name, what=f"the {what} of a transfer function", known=listing(name, known))
    raise failed(sink.diagnostics)


def linearize_at(system: System, point: Point, sink: Sink) -> Linearization | None:
    """Exact; None after E0850, E0851, E0855 or E0860."""
    at = reduce(system, point, holonomic_rows(system), sink)
    at = None if at is None else on_both_sides(system, at, sink)
    return None if at is None else linear_of(system, at)


def linear_of(system: System, at: Reduced) -> Linearization:
    """With names, without idle charges."""
    layout = system.engine.layout
    entries, watched = dependence(system, at)
    idle = idle_charges(system, at, entries, watched)
    kept = [i for i in range(len(at.value)) if i not in idle]
    names = state_names(system, at.partition)
    a, b, c, d = _without_rounding(at, entries)
    return Linearization(
        model=system.flat.name,
        point=at.flow.point,
        states=tuple(names[i] for i in kept),
        inputs=tuple(Named(slot.name, slot.unit) for slot in layout.inputs),
        outputs=tuple(Named(slot.name, slot.unit) for slot in layout.outputs),
        left_out=tuple(names[i] for i in idle),
        A=a[np.ix_(kept, kept)],
        B=b[kept],
        C=c[:, kept],
        D=d,
        rate=at.value[kept],
        steadiness=steadiness(system, at),
    )


def _without_rounding(at: Reduced, entries: Flags) -> tuple[Floats, Floats, Floats, Floats]:
    """A, B, C and D with zeros at all entries but these."""
    states = len(at.value)
    whole = np.where(entries, np.block([[at.a, at.b], [at.c, at.d]]), 0.0)
    return whole[:states, :states], whole[:states, states:], whole[states:, :states], whole[states:, states:]
