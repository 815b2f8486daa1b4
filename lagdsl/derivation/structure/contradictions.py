"""Conditions of the start that contradict each other: initial equations, fixed starts and constraints.

From those that cannot hold together one after the other is left out; one that is not missed stays out. The rest
contradict each other, and none of them can be spared (the deletion filter of Chinneck, Feasibility and Infeasibility in
Optimization, section 2.4).
"""

from __future__ import annotations

from collections.abc import Sequence
from contextlib import suppress
from typing import Protocol

import numpy as np

from lagdsl.derivation.program.program import Layout
from lagdsl.derivation.structure.names import grammatical_subject, located, place
from lagdsl.derivation.structure.points import natural_sizes
from lagdsl.foundation.diagnostics import Label, Sink
from lagdsl.foundation.numerics.levenberg_marquardt import descend
from lagdsl.foundation.numerics.rank import Floats
from lagdsl.foundation.record import record
from lagdsl.foundation.source import Span
from lagdsl.language.flat.model import FlatModel
from lagdsl.language.flat.spans import place as place_of

# Residuals, as a part of the row's size, below which a condition counts as met.
_HOLDS = 1e-7
_STEP = 1e-6
_TRIES = 8
_WIDTH = 0.6
_ITERATIONS = 40
# Larger models are told of the residual alone: each condition is tried once, each try costs a Jacobian by differences.
_MOST_UNKNOWNS = 60
_MOST_CONDITIONS = 40
_LONGEST = 60


@record()
class _Condition:
    """Its rows, how it is called and where it stands; `label` is told at a secondary place."""

    rows: tuple[int, ...]
    words: str
    span: Span | None
    label: str


class Functions(Protocol):
    """Functions of the model, as the search that failed had them: a run of the runtime."""

    def evaluate(self, function: str, t: float, x: Floats, count: int) -> Floats:
        """The first `count` results of a function at the state x (2 nq + nz,)."""

    def take_parameters(self, p: Floats) -> None:
        """Evaluations take the parameters p (np,) from now on."""


class Failed(Protocol):
    """A search for a start that failed: from `starts` it reached the state `x`, (2 nq + nz,) both, with the parameters
    `p` (np,)."""

    @property
    def starts(self) -> Floats: ...

    @property
    def x(self) -> Floats: ...

    @property
    def p(self) -> Floats: ...


def report_contradiction(
    flat: FlatModel, layout: Layout, functions: Functions, t: float, failed: Failed, sink: Sink
) -> bool:
    """E0839 that names initial equations, fixed starts and constraints that contradict each other; False if there are
    no such, or the model is too large to look for them."""
    conditions = _conditions(flat, layout)
    if len(failed.x) + sum(parameter.free for parameter in flat.parameters) > _MOST_UNKNOWNS:
        return False
    if len(conditions) > _MOST_CONDITIONS:
        return False
    system = _System(flat, layout, functions, t, failed)
    if system.holds(conditions):
        return False
    left = list(conditions)
    for condition in conditions:
        others = [each for each in left if each is not condition]
        if not system.holds(others):
            left = others
    if len(left) < 2:
        return False
    *others, last = left
    labels = [Label(each.span, each.label) for each in others if each.span is not None and each.span != last.span]
    sink.report(
        "E0839",
        last.span,
        *dict.fromkeys(labels),
        last=last.words,
        others=_listed([each.words for each in others]),
    )
    return True


def _listed(names: Sequence[str]) -> str:
    unique = list(dict.fromkeys(names))
    return " and ".join([", ".join(unique[:-1]), unique[-1]] if len(unique) > 1 else unique)


def _conditions(flat: FlatModel, layout: Layout) -> list[_Condition]:
    """Constraints, fixed starts and initial equations, those that may stay out last: rows as `_System` counts them."""
    n, count, size = len(flat.coordinates), len(layout.constraints), 2 * len(flat.coordinates) + len(flat.states)
    result = []
    for item in located(flat):
        rows = [count + row for row in item.rows]
        rows += [row for row in item.rows if item.constraint.level == "position"]
        words = grammatical_subject(flat, item.constraint)
        result.append(_Condition(tuple(rows), words, place(item.constraint), "holds, too"))
    first = 2 * count
    for k, coordinate in enumerate(flat.coordinates):
        if coordinate.fixed:
            span = coordinate.start_span or place_of(coordinate)
            result.append(_Condition((first + k,), f"the fixed start of `{coordinate.name}`", span, "fixed"))
        if coordinate.rate_fixed:
            span = coordinate.rate_start_span or place_of(coordinate)
            words = f"the fixed start of `der({coordinate.name})`"
            result.append(_Condition((first + n + k,), words, span, "fixed"))
    for k, state in enumerate(flat.states):
        if state.fixed:
            words = f"the fixed start of `{state.name}`"
            result.append(_Condition((first + 2 * n + k,), words, place_of(state), "fixed"))
    for k, equation in enumerate(flat.initial_equations):
        span = place_of(equation)
        text = "" if span is None else " ".join(span.text.rstrip("; ").split())
        words = f"`{text}`" if 0 < len(text) <= _LONGEST else "an initial equation"
        result.append(_Condition((first + size + k,), words, span, "holds at the start, too"))
    return result


class _System:
    """All rows at a state and free parameters: phi (nc,), J qd + b (nc,), differences from the starts (2 nq + nz,),
    equations (ne,)."""

    def __init__(self, flat: FlatModel, layout: Layout, functions: Functions, t: float, failed: Failed) -> None:
        self._counts = (len(flat.coordinates), len(layout.constraints), len(flat.initial_equations))
        self._functions, self._t, self._failed = functions, t, failed
        n = len(flat.coordinates)
        sizes = natural_sizes(flat.coordinates, layout.components, failed.starts[:n])
        states = [state.nominal or 1.0 for state in flat.states]
        known = {parameter.name: parameter for parameter in flat.parameters}
        slots = [known[slot.name] for slot in layout.parameters]
        self._free = [k for k, parameter in enumerate(slots) if parameter.free]
        changes = [abs(slots[k].nominal or slots[k].value) or 1.0 for k in self._free]
        self._sizes = np.concatenate([sizes, sizes, np.array([*states, *changes], dtype=np.float64)])
        parameters = failed.p[self._free] if self._free else np.zeros(0)
        starts = np.append(failed.starts, [slots[k].value for k in self._free])
        self._beginnings = [np.append(failed.x, parameters), starts]
        generator = np.random.default_rng(20011)
        for _ in range(_TRIES):
            self._beginnings.append(starts + _WIDTH * self._sizes * generator.standard_normal(len(starts)))
        slopes = [np.linalg.norm(self._jacobian(x), axis=1) for x in self._beginnings]
        finite = np.where(np.isfinite(slopes), slopes, 0.0)
        largest = np.max(finite, axis=0)
        self._rows = np.where(largest > 0.0, largest, 1.0)

    def holds(self, conditions: Sequence[_Condition]) -> bool:
        """True if some state is found that satisfies them."""
        rows = [row for condition in conditions for row in condition.rows]
        if not rows:
            return True

        def equations(y: Floats) -> tuple[Floats, Floats]:
            x = y * self._sizes
            scale = self._rows[rows]
            return self._values(x)[rows] / scale, self._jacobian(x)[rows] / scale[:, None]

        for beginning in self._beginnings:
            with suppress(np.linalg.LinAlgError):
                reached = descend(equations, beginning / self._sizes, iterations=_ITERATIONS)
                if reached.size <= _HOLDS:
                    return True
        return False

    def _values(self, unknowns: Floats) -> Floats:
        n, count, equations = self._counts
        width = count * (1 + n)
        x = unknowns[: len(self._failed.x)]
        if self._free:
            p = self._failed.p.copy()
            p[self._free] = unknowns[len(x) :]
            self._functions.take_parameters(p)
        return np.concatenate(
            [
                self._functions.evaluate("position_constraint", self._t, x, width)[:count] if count else np.zeros(0),
                self._functions.evaluate("velocity_constraint", self._t, x, width)[:count] if count else np.zeros(0),
                x - self._failed.starts,
                self._functions.evaluate("initial_equation", self._t, x, equations),
            ]
        )

    def _jacobian(self, x: Floats) -> Floats:
        """By natural sizes of the unknowns."""
        columns = []
        for k, size in enumerate(self._sizes.tolist()):
            step = np.zeros(len(x))
            step[k] = _STEP * size
            columns.append((self._values(x + step) - self._values(x - step)) / (2.0 * _STEP))
        return np.array(columns).T.reshape(-1, len(x))
