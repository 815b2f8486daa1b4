"""The functions of a model at one state, through buffers that are made once: steppers call them often."""

from __future__ import annotations

from ctypes import byref, c_size_t
from itertools import accumulate, pairwise

import numpy as np

from lagdsl.algebra.graph.operation import ARGUMENT_NAMES, Group
from lagdsl.derivation.program.functions import STATE
from lagdsl.derivation.program.program import Layout
from lagdsl.engines.runtime.engines.buffers import Buffers
from lagdsl.engines.runtime.engines.engine import Floats
from lagdsl.engines.runtime.engines.native_model import NativeModel
from lagdsl.engines.runtime.library import runtime_library
from lagdsl.engines.runtime.structures import Arguments

# The vectors of lag_arguments, in its order.
_NAMED = {name: group for group, name in ARGUMENT_NAMES.items() if group is not Group.TIME}
VECTORS = tuple(_NAMED[name] for name, *_ in Arguments._fields_ if name in _NAMED)
_STATE_VECTORS = STATE[1:]


class OneState:
    """`arguments` point at one array, of which `view` has the part of each group; `coordinate` is the one that cannot
    be accelerated where `solve` finds one."""

    def __init__(self, model: NativeModel, layout: Layout) -> None:
        self._native, self.buffers = model, Buffers(model)  # calls read it, whoever else has let go of the model
        ends = [0, *accumulate(map(layout.size, VECTORS))]
        # one number more than needed everywhere, so that every pointer points at something
        vectors = np.zeros(ends[-1] + 1)
        parts = zip(VECTORS, pairwise(ends), strict=True)
        self.view = {group: vectors[first:end] for group, (first, end) in parts}
        self._state = vectors[: ends[len(_STATE_VECTORS)]]
        self._solved = np.zeros(layout.size(Group.Q) + layout.size(Group.LAMBDA) + 1)
        self.coordinate = c_size_t(0)
        self.arguments = Arguments(workspace=self.buffers.workspace.ctypes.data, context=model.context)
        for group, first in zip(VECTORS, ends, strict=False):
            setattr(self.arguments, ARGUMENT_NAMES[group], vectors.ctypes.data + 8 * first)
        self._prepared: bytes | None = None
        self._at = byref(self.arguments)
        memory, qdd = self.buffers.memory.ctypes.data, self._solved.ctypes.data
        lam = qdd + 8 * layout.size(Group.Q)
        self._solve_call = (model.model, self._at, memory, qdd, lam, byref(self.coordinate))

    def set(self, t: float, *vectors: Floats) -> None:
        """q, qd, z, u, w, p."""
        self.arguments.t = t
        np.concatenate(vectors, out=self._state)

    def prepare(self, parameters: Floats) -> None:
        """Compute what only parameters change, where they did."""
        now = parameters.tobytes()
        if now != self._prepared:
            runtime_library().prepare(self._native.model, self._at)
            self._prepared = now

    def forget(self) -> None:
        """The parameters may be others now."""
        self._prepared = None

    def solve(self) -> tuple[int, Floats, Floats]:
        """Status, qdd (nq,) and lam (nc,)."""
        status = runtime_library().forward_dynamics(*self._solve_call)
        solved, n = self._solved[:-1].copy(), self.view[Group.Q].size
        return int(status), solved[:n], solved[n:]

    def evaluate(self, number: int, width: int) -> Floats:
        """The results of a function by its number, so many."""
        results = np.zeros(width + 1)
        runtime_library().evaluate(self._native.model, number, self._at, results.ctypes.data)
        return results[:width]
