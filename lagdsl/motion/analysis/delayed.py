"""The frequency response of a model with delays: exact, as a delay is the factor exp(-sT) between two signals.

Delayed expressions e and their delayed values d = exp(-sT) e cut the model into one without delays: inputs u and d,
outputs y and e. With its response G the loops are closed again: y = (Gyu + Gyd (exp(sT) - Ged)^-1 Geu) u.
"""

from __future__ import annotations

import numpy as np

from lagdsl.algebra.graph.operation import Group
from lagdsl.foundation.diagnostics import Sink
from lagdsl.foundation.numerics.rank import Floats
from lagdsl.motion.analysis.border import on_both_sides
from lagdsl.motion.analysis.control.frequency_response import FrequencyResponse
from lagdsl.motion.analysis.eigen import Complexes
from lagdsl.motion.analysis.linearization import chosen, linear_of
from lagdsl.motion.analysis.linearize import Reduced, holonomic_rows, reduce, state_names
from lagdsl.motion.analysis.point import Point, System
from lagdsl.motion.analysis.sampled.held_flow import held_flow, values_at
from lagdsl.motion.analysis.sampled.moved import Place, moved
from lagdsl.motion.analysis.sampled.signals import Signals
from lagdsl.motion.analysis.steady import imbalance

_PER_DECADE = 60
_BESIDE = 10.0


def delayed_bode(
    system: System, point: Point, channel: tuple[str | None, str | None], omega: Floats | None, sink: Sink
) -> FrequencyResponse | None:
    """As `bode_at`, without a quotient of polynomials and without margins: there are infinitely many poles."""
    at = reduce(system, point, holonomic_rows(system), sink)
    at = None if at is None else on_both_sides(system, at, sink)
    cut = None if at is None else _cut(system, at, sink)
    if at is None or cut is None:
        return None
    linear = linear_of(system, at)
    if linear.steadiness.kind == "neither":
        sink.report("W0854", None, reason=imbalance(linear.steadiness))
    states = state_names(system, at.partition)
    told = {each.name: (len(states) + row, each) for row, each in enumerate(linear.outputs)}
    told |= {each.name: (row, each) for row, each in enumerate(states) if each.name not in told}
    source = chosen([each.name for each in linear.inputs], channel[0], "input")
    target = linear.outputs[0].name if channel[1] is None and len(linear.outputs) == 1 else channel[1]
    row, output = told[[*told][chosen([*told], target, "output")]]
    asked = cut.frequencies() if omega is None else omega
    return FrequencyResponse(
        model=linear.model,
        point=linear.point,
        steadiness=linear.steadiness,
        input=linear.inputs[source],
        output=output,
        frequencies=asked / (2.0 * np.pi),
        response=np.array([cut.response(1j * each, source, row) for each in asked.tolist()]),
        transfer=None,
        margins=None,
    )


class _Cut:
    """dx/dt = A x + B d + b u of the model without delays; `rows` are those of states, outputs, delayed expressions."""

    def __init__(self, times: Floats, rates: Floats, rows: Floats) -> None:
        self._times, self._count = times, len(rates)
        self._rates, self._rows = rates, rows

    def response(self, s: complex, source: int, row: int) -> complex:
        """Of a state or an output to an input."""
        n, states = len(self._times), self._count
        # Columns of the rates of delayed values belong to s times these values.
        rates, rows = (self._with(s, each) for each in (self._rates, self._rows))
        column = [*range(n), n + source]
        inside = np.linalg.solve(s * np.eye(states) - rates[:, :states], rates[:, states:][:, column])
        whole = rows[:, :states] @ inside + rows[:, states:][:, column]
        loops = np.diag(np.exp(s * self._times)) - whole[-n:, :n]
        return complex(whole[row, n] + whole[row, :n] @ np.linalg.solve(loops, whole[-n:, n]))

    def frequencies(self) -> Floats:
        """Angular frequencies from a decade below the slowest to one above the fastest of the poles without the
        delays, with the delays of no length, and of the delays."""
        n, states = len(self._times), self._count
        a, b = self._rates[:, :states], self._rates[:, states : states + n]
        c, d = self._rows[-n:, :states], self._rows[-n:, states : states + n]
        closed = a + b @ np.linalg.lstsq(np.eye(n) - d, c, rcond=None)[0]
        sizes = np.concatenate([np.abs(np.linalg.eigvals(a)), np.abs(np.linalg.eigvals(closed)), 1.0 / self._times])
        sizes = sizes[sizes > 1e-12 * np.max(sizes)]
        low, high = np.min(sizes) / _BESIDE, np.max(sizes) * _BESIDE
        return np.geomspace(low, high, int(np.ceil(np.log10(high / low) * _PER_DECADE)) + 1)

    def _with(self, s: complex, matrix: Floats) -> Complexes:
        n, states = len(self._times), self._count
        values, slopes = matrix[:, states : states + n], matrix[:, states + n : states + 2 * n]
        return np.hstack([matrix[:, :states], values + s * slopes, matrix[:, states + 2 * n :]])


def _cut(system: System, at: Reduced, sink: Sink) -> _Cut | None:
    """The model at a point without its delays; None after E0855."""
    program, flow = system.program, at.flow
    kinds, states = program.layout.kinds, len(at.value)
    places = tuple(place for kind in ("delay", "delay_rate") for place, own in enumerate(kinds) if own == kind)
    held = held_flow(system, at, Signals(places, (), ()))
    unit = np.zeros((len(held.along.q), len(flow.point.w)))
    unit[np.arange(states, states + len(places)), list(places)] = 1.0
    along = held.along
    tangents = {Group.Q: along.q, Group.QD: along.qd, Group.Z: along.z, Group.U: along.u, Group.W: unit}
    values, times, _ = (block.elements for block in program.function("delayed").results)
    place = Place(values=values_at(flow.point, flow.qdd, flow.lam), tangents=tangents)
    found, lengths = moved(program.graph, values, place), moved(program.graph, times, place)
    whole = np.vstack([np.eye(states, held.rates.shape[1]), held.outputs, found.tangents.T])
    if held.borders or any(found.borders) or not (np.all(np.isfinite(whole)) and np.all(np.isfinite(held.rates))):
        sink.report("E0855", None, name=f"what `{system.flat.events.delays[0].name}` reads or moves")
        return None
    return _Cut(np.asarray(lengths.values, dtype=np.float64), held.rates, whole)
