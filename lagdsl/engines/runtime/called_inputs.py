"""Inputs that the C runtime asks functions of Python for."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import Any

import numpy as np

from lagdsl.engines.runtime.engines.engine import Floats
from lagdsl.engines.runtime.structures import RunCallbacks

INPUTS: Any = dict(field[:2] for field in RunCallbacks._fields_)["inputs"]


class CalledInputs:
    """`told` tells, of a time and of whether the value before a jump is wanted, the inputs at `places`. In C nothing
    may be raised: `problem` is what was, to be raised later."""

    def __init__(self, told: Callable[[float, bool], Floats], places: Sequence[int]) -> None:
        self._told, self._places, self._nothing = told, places, np.full(len(places), np.nan)
        self.problem: BaseException | None = None
        self.called = INPUTS(self._tell)

    def _tell(self, _context: object, t: float, before: int, u: object) -> None:
        """Values that are not numbers end the run."""
        values = self._nothing
        if self.problem is None:
            try:
                values = self._told(t, bool(before))
            except BaseException as problem:
                self.problem = problem
        for place, value in zip(self._places, values.tolist(), strict=True):
            u[place] = value  # type: ignore[index]
