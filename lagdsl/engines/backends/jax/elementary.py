"""The operations of the functions of a model for JAX, in double precision."""

from typing import Any

import jax
import jax.numpy as jnp

_configuration: Any = jax.config  # JAX gives `update` no types
_configuration.update("jax_enable_x64", True)


class Elementary:
    """Functions that the bodies of the model's functions call, by name. Conditions are the numbers 0 and 1."""

    sin, cos, tan = jnp.sin, jnp.cos, jnp.tan
    asin, acos, atan, atan2 = jnp.arcsin, jnp.arccos, jnp.arctan, jnp.arctan2
    sinh, cosh, tanh = jnp.sinh, jnp.cosh, jnp.tanh
    exp, log, sqrt, power = jnp.exp, jnp.log, jnp.sqrt, jnp.power
    absolute, sign, floor, ceil = jnp.abs, jnp.sign, jnp.floor, jnp.ceil
    negate, add, subtract, multiply, divide = jnp.negative, jnp.add, jnp.subtract, jnp.multiply, jnp.divide

    @staticmethod
    def modulo(x: Any, y: Any) -> Any:
        """x - floor(x/y)*y, with the sign of y."""
        return x - jnp.floor(jnp.divide(x, y)) * y

    @staticmethod
    def minimum(x: Any, y: Any) -> Any:
        return jnp.where(x <= y, x, y)

    @staticmethod
    def maximum(x: Any, y: Any) -> Any:
        return jnp.where(x >= y, x, y)

    @staticmethod
    def less(x: Any, y: Any) -> Any:
        return jnp.where(x < y, 1.0, 0.0)

    @staticmethod
    def less_equal(x: Any, y: Any) -> Any:
        return jnp.where(x <= y, 1.0, 0.0)

    @staticmethod
    def equal(x: Any, y: Any) -> Any:
        return jnp.where(x == y, 1.0, 0.0)

    @staticmethod
    def negation(x: Any) -> Any:
        return jnp.where(x == 0.0, 1.0, 0.0)

    @staticmethod
    def both(x: Any, y: Any) -> Any:
        return jnp.where(jnp.logical_and(x, y), 1.0, 0.0)

    @staticmethod
    def either(x: Any, y: Any) -> Any:
        return jnp.where(jnp.logical_or(x, y), 1.0, 0.0)

    @staticmethod
    def select(condition: Any, value: Any, otherwise: Any) -> Any:
        return jnp.where(condition != 0.0, value, otherwise)
