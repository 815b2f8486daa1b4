"""Whole motions as functions for programs that differentiate: JAX, PyTorch, NumPy."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from pathlib import Path
from typing import TYPE_CHECKING, Any, TypedDict, Unpack, cast

import numpy as np

from lagdsl.foundation.diagnostics.unknown import unknown_among
from lagdsl.foundation.numerics.rank import Floats
from lagdsl.interfaces.api.estimation import Estimation
from lagdsl.interfaces.api.inputs.values import signals_of
from lagdsl.interfaces.api.names import Value, known, listed

if TYPE_CHECKING:
    from lagdsl.interfaces.api.functions.motion_function import MotionFunction
    from lagdsl.motion.signals.inputs import Signal


class MotionOptions(TypedDict, total=False):
    """Arguments of `simulate` for a motion as a function."""

    stop: float
    interval: float
    tolerance: float
    solver: str
    threads: int
    parameters: Mapping[str, Value]
    start: Mapping[str, Value]
    inputs: Mapping[str, Signal | str] | Path | str


_RUN = ("tolerance", "solver", "threads")


class MotionsAsFunctions(Estimation):
    """A model whose motions are functions with derivatives."""

    def as_function(
        self, *, free: Sequence[str] | str, of: Sequence[str] | str, **options: Unpack[MotionOptions]
    ) -> MotionFunction:
        """The columns `of` as a function y(x) of the quantities `free`, parameters, starts (`theta.start`) and constant
        inputs, in SI units: x (..., free), y (..., rows, of).

        `y(x)` are values, `y.differentiate(x)` values and Jacobian (..., rows, of, free), `y.jvp(x, dx)` and
        `y.vjp(x, dy)` products with it; `y.time` (rows,) are the times and `y.here` (free,) the values of the model.
        Leading axes of x are runs on all cores. The rest is as for `simulate`: `parameters`, `start` and `inputs` are
        settings that stay, rows are every `interval`. Raises as `simulate_many`, and for a run that fails as
        `simulate`.
        """
        from lagdsl.interfaces.api.functions.motion_function import MotionFunction, Runs
        from lagdsl.motion.simulate.derivatives import check_differentiable
        from lagdsl.motion.simulate.simulate import grid
        from lagdsl.motion.simulate.table import called_heads
        from lagdsl.motion.sweep.sweep import options_of

        flat, model = self._compilation.flat, cast("Any", self)
        names, columns = listed(free), listed(of)
        check_differentiable(flat, self._layout, names)
        for name in columns:
            if name not in called_heads(flat):
                raise unknown_among("column", name, list(called_heads(flat)))
        stay = self._staying(names, options)
        end, interval = options_of(flat, stop=options.get("stop"), interval=options.get("interval"))
        rest: dict[str, Any] = {key: value for key, value in options.items() if key in _RUN}
        runs = Runs(
            many=model.simulate_many,
            one=model.simulate,
            inputs=self.inputs,
            here=lambda: self._here(names, stay["parameters"], stay["start"]),
        )
        time = grid(flat.experiment.start_time, end, interval)
        return MotionFunction(runs, names, columns, time, stay, {**rest, "stop": end, "interval": interval})

    def _staying(self, free: Sequence[str], options: MotionOptions) -> dict[str, dict[str, Any]]:
        """Parameters, start and inputs that are given, by name. Raises ValueError for one that is free, TypeError for
        an option that there is not."""
        unknown = options.keys() - MotionOptions.__annotations__.keys()
        if unknown:
            raise TypeError(
                f"there is no option `{min(unknown)}`; there are {', '.join(MotionOptions.__annotations__)}"
            )
        parameters = known("parameter", options.get("parameters"), self._named("parameter"))
        start = self._start_values(options.get("start"))
        inputs = signals_of(self._compilation.flat, options.get("inputs"))
        for name in free:
            if name in parameters or name in inputs or (name.endswith(".start") and name[:-6] in start):
                raise ValueError(f"`{name}` is free, and a value is given for it")
        return {"parameters": {**parameters}, "start": {**start}, "inputs": {**inputs}}

    def _here(self, names: Sequence[str], parameters: Mapping[str, float], start: Mapping[str, float]) -> Floats:
        """The values (names,) of the model, with these settings."""
        from lagdsl.motion.simulate.initialize import initial_state, places_of
        from lagdsl.motion.simulate.placed import start_values

        flat, p = self._compilation.flat, self._parameter_vector(parameters)
        t = flat.experiment.start_time
        initial = initial_state(flat, self._engine, p, t0=t, start=start)
        values = dict(zip(self.parameters, initial.p.tolist(), strict=True))
        values |= dict(zip(self.inputs, start_values(self._engine, t, p)[1].tolist(), strict=True))
        values |= {f"{name}.start": value for name, value in zip(places_of(flat), initial.x.tolist(), strict=True)}
        return np.array([values[name] for name in names])

    def as_jax(
        self, *, free: Sequence[str] | str, of: Sequence[str] | str, **options: Unpack[MotionOptions]
    ) -> Callable[[Any], Any]:
        """The same as a function of JAX, (free,) to (rows, of), for `jit`, `grad`, `jvp`, `vmap`: a mapped axis is one
        call of `simulate_many`. JAX is switched to double precision. First derivatives only. Raises as `as_function`,
        ModuleNotFoundError without JAX."""
        from lagdsl.interfaces.api.motions import require_package

        require_package("jax", "motions in JAX")
        from lagdsl.interfaces.api.functions.in_jax import in_jax

        return in_jax(self.as_function(free=free, of=of, **options))

    def as_torch(
        self, *, free: Sequence[str] | str, of: Sequence[str] | str, **options: Unpack[MotionOptions]
    ) -> Callable[[Any], Any]:
        """The same as a function of PyTorch, (..., free) to (..., rows, of), for `backward` and for `torch.func`, in
        double precision. First derivatives only. Raises as `as_function`, ModuleNotFoundError without PyTorch."""
        from lagdsl.interfaces.api.motions import require_package

        require_package("torch", "motions in PyTorch")
        from lagdsl.interfaces.api.functions.in_torch import in_torch

        return in_torch(self.as_function(free=free, of=of, **options))
