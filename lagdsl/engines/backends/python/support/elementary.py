"""Elementary functions on arrays; each broadcasts. Conditions are the numbers 0 and 1."""

import numpy as np
from numpy.typing import NDArray

Floats = NDArray[np.float64]


class Elementary:
    """Functions that the bodies of the model's functions call, by name."""

    sin, cos, tan = np.sin, np.cos, np.tan
    asin, acos, atan, atan2 = np.arcsin, np.arccos, np.arctan, np.arctan2
    sinh, cosh, tanh = np.sinh, np.cosh, np.tanh
    exp, log, sqrt, power = np.exp, np.log, np.sqrt, np.power
    absolute, sign, floor, ceil, divide = np.abs, np.sign, np.floor, np.ceil, np.divide

    @staticmethod
    def modulo(x: Floats, y: Floats) -> Floats:
        """x - floor(x/y)*y, with the sign of y."""
        return np.subtract(x, np.floor(np.divide(x, y)) * y)

    @staticmethod
    def minimum(x: Floats, y: Floats) -> Floats:
        return np.where(x <= y, x, y)

    @staticmethod
    def maximum(x: Floats, y: Floats) -> Floats:
        return np.where(x >= y, x, y)

    @staticmethod
    def less(x: Floats, y: Floats) -> Floats:
        return np.where(x < y, 1.0, 0.0)

    @staticmethod
    def less_equal(x: Floats, y: Floats) -> Floats:
        return np.where(x <= y, 1.0, 0.0)

    @staticmethod
    def equal(x: Floats, y: Floats) -> Floats:
        return np.where(np.equal(x, y), 1.0, 0.0)

    @staticmethod
    def negation(x: Floats) -> Floats:
        return np.where(np.equal(x, 0.0), 1.0, 0.0)

    @staticmethod
    def both(x: Floats, y: Floats) -> Floats:
        return np.where(np.logical_and(x, y), 1.0, 0.0)

    @staticmethod
    def either(x: Floats, y: Floats) -> Floats:
        return np.where(np.logical_or(x, y), 1.0, 0.0)

    @staticmethod
    def select(condition: Floats, value: Floats, otherwise: Floats) -> Floats:
        return np.where(np.not_equal(condition, 0.0), value, otherwise)
