"""Motions as functions of JAX: `jit` calls the runtime, `vmap` makes many runs one call, `jvp` and `grad` take its
tangents."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import jax
import jax.numpy as jnp

from lagdsl.interfaces.api.functions.motion_function import MotionFunction


def in_jax(function: MotionFunction) -> Callable[[Any], Any]:
    """y(x) of JAX, (free,) to (rows, of), in double precision, to which JAX is switched."""
    jax.config.update("jax_enable_x64", True)
    shape, count = (len(function.time), len(function.of)), len(function.free)
    value = jax.ShapeDtypeStruct(shape, jnp.float64)
    derivative = jax.ShapeDtypeStruct((*shape, count), jnp.float64)

    def motion(x: Any) -> Any:
        return jax.pure_callback(function, value, x, vmap_method="broadcast_all")

    def along(primals: tuple[Any], tangents: tuple[Any]) -> tuple[Any, Any]:
        y, jacobian = jax.pure_callback(
            function.differentiate, (value, derivative), primals[0], vmap_method="broadcast_all"
        )
        return y, jnp.einsum("rof,f->ro", jacobian, tangents[0])

    differentiable = jax.custom_jvp(motion)
    differentiable.defjvp(along)

    def called(x: Any) -> Any:
        """The columns at the times of the rows, (rows, of), for the values x (free,) of what is free."""
        values = jnp.asarray(x, dtype=jnp.float64)
        if values.shape != (count,):
            raise ValueError(
                f"the function takes {count} values, {', '.join(function.free)}; their shape is {values.shape}"
            )
        return differentiable(values)

    return called
