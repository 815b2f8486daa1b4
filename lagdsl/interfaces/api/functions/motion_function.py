"""A whole motion as a function of some of its quantities, with its derivative: the common part of those of JAX and
PyTorch."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from typing import Any

import numpy as np
from numpy.typing import ArrayLike

from lagdsl.foundation.numerics.rank import Floats
from lagdsl.foundation.record import record
from lagdsl.interfaces.api.motions import Motions

_START = ".start"


@record(kw_only=True)
class Runs:
    """`simulate_many` and `simulate` of a model, the names of its inputs, and its values of what is free."""

    many: Callable[..., Motions]
    one: Callable[..., object]
    inputs: Sequence[str]
    here: Callable[[], Floats]


class MotionFunction:
    """y(x): the columns `of` at `time` (rows,) [s] as a function of the quantities `free`, in SI units.

    x has the shape (..., free), y (..., rows, of) and its Jacobian (..., rows, of, free); all leading axes are runs of
    one call of `simulate_many`. `here` (free,) are the values of the model. Of two rows at an event the one behind
    it counts. A run that fails raises what `simulate` raises of it.
    """

    def __init__(
        self,
        runs: Runs,
        free: Sequence[str],
        of: Sequence[str],
        time: Floats,
        given: Mapping[str, Mapping[str, Any]],
        options: Mapping[str, Any],
    ) -> None:
        """`given` are settings by name that do not change: parameters, start, inputs; `options` those of
        `simulate_many`, with which the rows are at `time`."""
        self._runs, self._given, self._options = runs, given, options
        self.free, self.of, self.time = tuple(free), tuple(of), time

    @property
    def here(self) -> Floats:
        """The values of the model, (free,). Raises as `initial_state`."""
        return self._runs.here()

    def __call__(self, x: ArrayLike) -> Floats:
        """y(x)."""
        points, lead = self._points(x)
        return self._values(self._motions(points, ())).reshape(*lead, len(self.time), len(self.of))

    def differentiate(self, x: ArrayLike) -> tuple[Floats, Floats]:
        """y(x) and its Jacobian."""
        points, lead = self._points(x)
        motions = self._motions(points, self.free)
        table = [[motions.derivative(name, by) for by in self.free] for name in self.of]
        shape = (*lead, len(self.time), len(self.of))
        jacobian = np.array(table).transpose(2, 3, 0, 1).reshape(*shape, len(self.free))
        return self._values(motions).reshape(shape), np.ascontiguousarray(jacobian)

    def jvp(self, x: ArrayLike, dx: ArrayLike) -> tuple[Floats, Floats]:
        """y(x), and its change along dx (..., free)."""
        y, jacobian = self.differentiate(x)
        return y, np.einsum("...rof,...f->...ro", jacobian, np.asarray(dx, dtype=np.float64))

    def vjp(self, x: ArrayLike, dy: ArrayLike) -> tuple[Floats, Floats]:
        """y(x), and the gradient (..., free) of the sum of dy times y, dy (..., rows, of)."""
        y, jacobian = self.differentiate(x)
        return y, np.einsum("...rof,...ro->...f", jacobian, np.asarray(dy, dtype=np.float64))

    def _points(self, x: ArrayLike) -> tuple[Floats, tuple[int, ...]]:
        """Values (runs, free) and the leading axes. Raises ValueError for another shape."""
        values = np.asarray(x, dtype=np.float64)
        if values.ndim == 0 or values.shape[-1] != len(self.free):
            names = ", ".join(f"`{name}`" for name in self.free)
            raise ValueError(f"values of {names} have the shape (..., {len(self.free)}), not {values.shape}")
        return values.reshape(-1, len(self.free)), values.shape[:-1]

    def _motions(self, points: Floats, tangents: Sequence[str]) -> Motions:
        """Motions at the points (runs, free)."""
        settings = self._settings(points.T)
        motions = self._runs.many(**settings, **self._options, columns=self.of, tangents=tangents)
        for failed, why in motions.failures.items():
            options = {key: value for key, value in self._options.items() if key != "threads"}
            self._runs.one(**self._settings(points[failed]), **options, tangents=tangents)
            raise RuntimeError(why)
        return motions

    def _settings(self, values: Floats) -> dict[str, dict[str, Any]]:
        """Settings of runs with these values of each free quantity."""
        settings = {kind: dict(each) for kind, each in self._given.items()}
        for name, value in zip(self.free, values, strict=True):
            kind = "start" if name.endswith(_START) else "inputs" if name in self._runs.inputs else "parameters"
            settings[kind][name.removesuffix(_START) if kind == "start" else name] = value
        return settings

    def _values(self, motions: Motions) -> Floats:
        """(runs, rows, of)."""
        return np.stack([motions[name] for name in self.of], axis=-1)
