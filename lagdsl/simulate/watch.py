"""What must stay true along the motion: invariants and assertions."""

from __future__ import annotations

import numpy as np

from lagdsl.diagnostics import Label, Sink
from lagdsl.flat.model import FlatModel
from lagdsl.mechanics.rank import Floats
from lagdsl.runtime.engine import Engine
from lagdsl.simulate.right_hand_side import RightHandSide, Solved
from lagdsl.simulate.trajectory import InvariantRecord
from lagdsl.simulate.trouble import time_text

# Ruling 32: the default tolerance of an invariant in integration tolerances.
_DEFAULT_FACTOR = 1e3


class Watch:
    """Looks at every accepted state. `check` returns the name at fault, after reporting to the sink, or None. The
    records `start`, `sizes` and `drift` (ni,) are changed in place."""

    def __init__(self, flat: FlatModel, engine: Engine, system: RightHandSide, tolerance: float) -> None:
        self._flat = flat
        self._engine = engine
        self._system = system
        count = len(flat.invariants)
        self.tolerances = np.array(
            [_DEFAULT_FACTOR * tolerance if i.tolerance is None else i.tolerance for i in flat.invariants]
        )
        self.start = np.zeros(count)
        self.sizes = np.zeros(count)
        self.drift = np.zeros(count)
        self._begun = False
        self.active = bool(flat.invariants or flat.assertions)

    def check(self, t: float, y: Floats, sink: Sink) -> str | None:
        """E0810 for a failed assertion, E0807 for an invariant beyond its tolerance."""
        if not self.active:
            return None
        solved = self._system.solved(t, y)
        if solved is None:
            return None
        values, sizes, assertions = self._engine.evaluate(
            "monitor",
            t,
            solved.q,
            solved.qd,
            solved.z,
            solved.u,
            self._system.w,
            self._system.p,
            solved.qdd,
            solved.lam,
        )
        for assertion, value in zip(self._flat.assertions, assertions.tolist(), strict=True):
            if value == 0.0:
                span = assertion.spans[0] if assertion.spans else None
                sink.report("E0810", span, time=time_text(t), text=assertion.message)
                return assertion.message
        if not self._begun:
            self.start[:], self._begun = values, True
        np.maximum(self.sizes, np.maximum(np.abs(self.start), sizes), out=self.sizes)
        drift = np.abs(values - self.start)
        np.fmax(self.drift, drift, out=self.drift)
        beyond = np.flatnonzero(~(drift <= self.tolerances * self.sizes))
        return self._report(int(beyond[0]), float(drift[beyond[0]]), solved, sink) if len(beyond) else None

    def records(self) -> tuple[InvariantRecord, ...]:
        """How every invariant held so far."""
        limits = self.tolerances * self.sizes
        return tuple(
            InvariantRecord(name=i.name, start=start, drift=drift, limit=limit)
            for i, start, drift, limit in zip(
                self._flat.invariants, self.start.tolist(), self.drift.tolist(), limits.tolist(), strict=True
            )
        )

    def _report(self, index: int, drift: float, solved: Solved, sink: Sink) -> str:
        invariant = self._flat.invariants[index]
        unit = self._engine.layout.invariants[index].unit
        suffix = "" if unit == "1" else f" {unit}"
        sink.report(
            "E0807",
            Label(invariant.spans[0]) if invariant.spans else None,
            notes=(self._power_note(solved),),
            name=invariant.name,
            time=time_text(solved.t),
            drift=f"{drift:.2g}{suffix}",
            limit=f"{float(self.tolerances[index] * self.sizes[index]):.2g}{suffix}",
        )
        return invariant.name

    def _power_note(self, solved: Solved) -> str:
        """The largest power at this instant and where it goes in."""
        load, dissipated = self._engine.evaluate(
            "power", solved.t, solved.q, solved.qd, solved.z, solved.u, self._system.w, self._system.p
        )
        powers = [
            (float(value) * sign, kind, slot.name)
            for values, sign, kind in ((load, 1.0, "loads"), (dissipated, -1.0, "dissipation"))
            for value, slot in zip(values, self._engine.layout.coordinates, strict=True)
        ]
        value, kind, name = max(powers, key=lambda entry: abs(entry[0]), default=(0.0, "", ""))
        if value == 0.0:
            return "no declared load or dissipation has power now"
        return f"largest power: {value:.3g} W by the {kind} along `{name}`"
