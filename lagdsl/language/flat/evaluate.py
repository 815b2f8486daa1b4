"""Numbers for flat expressions: a plain interpreter, for checks that must try values before anything is derived.

It works in complex numbers, so that time derivatives come exactly from one complex step (W. Squire and G. Trapp, SIAM
Review 40 (1998) 110): der(e) = Im e(q + i h qd, t + i h) / h with h = 1e-30.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import field
from functools import cached_property, partial
from typing import TypeAlias, assert_never

import numpy as np
from numpy.typing import NDArray

from lagdsl.foundation.numerics.complex_step import Complexes, Number, applied, chosen, compared, divided, power, truth
from lagdsl.foundation.record import record, remembered
from lagdsl.language.flat import expression as fx
from lagdsl.language.flat import model as fm
from lagdsl.language.flat.events import Discrete, Relation, Timed, entries
from lagdsl.language.flat.rotation import composed, quaternion_rotation, rotation, rotation_about, turned
from lagdsl.language.flat.traversal import postorder

Floats: TypeAlias = NDArray[np.float64]

_STEP = 1e-30


class NotEvaluable(Exception):  # noqa: N818 named after what it says
    """The expression needs what the mechanics provides, or a derivative that is not known here."""


@record(kw_only=True)
class Values:
    """Numbers of a moment: of coordinates, states, inputs and `time`, their rates, second derivatives of coordinates.

    Parameters may be given too; left out they have their defaults. Every other missing value is 0; the rate of `time`
    is 1.
    """

    variables: Mapping[str, float] = field(default_factory=dict)
    rates: Mapping[str, float] = field(default_factory=dict)
    accelerations: Mapping[str, float] = field(default_factory=dict)


def evaluate(flat: fm.FlatModel, expression: fx.FlatExpression, values: Values) -> float:
    """A scalar's value in SI units; nan outside the domain of a function. Raises NotEvaluable."""
    return Evaluator(flat, values).scalar(expression)


class Evaluator:
    """Evaluates many expressions at one moment; points, frames and definitions are computed once."""

    def __init__(self, flat: fm.FlatModel, values: Values) -> None:
        self._flat, self._values = flat, values

    @cached_property
    def _instant(self) -> _Instant:
        """Made for the first expression: often there is none."""
        values = self._values
        return _instant(self._flat, values.variables, values.rates, values.accelerations)

    def scalar(self, expression: fx.FlatExpression) -> float:
        with np.errstate(all="ignore"):
            return float(self._instant.scalar(expression).real)

    def vector(self, expression: fx.FlatExpression) -> Floats:
        """World components, shape (3,)."""
        with np.errstate(all="ignore"):
            return np.asarray(self._instant.vector(expression).real)

    def frame(self, name: str) -> tuple[Floats, Floats]:
        """Origin (3,) and axes as columns (3, 3) of a frame, in the world."""
        with np.errstate(all="ignore"):
            origin, axes = self._instant.frame(name)
        return np.asarray(origin.real), np.asarray(axes.real)


class ManyEvaluator:
    """Evaluates many expressions at k moments at once, which takes little more time than one. All have values of the
    same names."""

    def __init__(self, flat: fm.FlatModel, moments: Sequence[Values]) -> None:
        self._count = len(moments)
        variables = _together([each.variables for each in moments])
        rates = _together([each.rates for each in moments])
        self._instant = _instant(flat, variables, rates, _together([each.accelerations for each in moments]))

    def scalar(self, expression: fx.FlatExpression) -> Floats:
        """Shape (k,)."""
        with np.errstate(all="ignore"):
            return self._spread(self._instant.scalar(expression))

    def vector(self, expression: fx.FlatExpression) -> Floats:
        """World components, shape (3, k)."""
        with np.errstate(all="ignore"):
            return self._spread(self._instant.vector(expression))

    def frame(self, name: str) -> tuple[Floats, Floats]:
        """Origin (3, k) and axes as columns (3, 3, k) of a frame, in the world."""
        with np.errstate(all="ignore"):
            origin, axes = self._instant.frame(name)
        return self._spread(origin), self._spread(axes)

    def _spread(self, value: Number) -> Floats:
        found = np.asarray(value).real
        return np.broadcast_to(found, (*found.shape[:-1], self._count))


def _together(moments: Sequence[Mapping[str, float]]) -> dict[str, Complexes]:
    return {name: np.array([each[name] for each in moments], np.complex128) for name in moments[0]}


def _instant(
    flat: fm.FlatModel,
    given: Mapping[str, Number],
    given_rates: Mapping[str, Number],
    given_accelerations: Mapping[str, Number],
) -> _Instant:
    named, known = _of(flat)
    rates: dict[str, Number] = {c.name: 0j for c in flat.coordinates}
    rates.update({"time": 1 + 0j, **given_rates})
    accelerations = {c.name: given_accelerations.get(c.name, 0j) for c in flat.coordinates}
    return _Instant(flat, named, {**known, **given}, rates, accelerations)


@remembered
def _of(flat: fm.FlatModel) -> tuple[dict[str, fm.Named], dict[str, complex]]:
    """Named items, and values of variables that are not given, by name."""
    variables: dict[str, complex] = {p.name: p.value for p in flat.parameters}
    variables.update({item.name: 0j for item in (*flat.coordinates, *flat.states, *flat.inputs)})
    return {item.name: item for item in flat.named}, {**variables, "time": 0j}


class _Instant:
    """One moment, or k at once where the variables are arrays (k,). Vectors are then arrays (3, k), also with k = 1
    where all moments have the same."""

    def __init__(
        self,
        flat: fm.FlatModel,
        named: dict[str, fm.Named],
        variables: dict[str, Number],
        rates: dict[str, Number],
        accelerations: dict[str, Number] | None,
    ) -> None:
        self.flat = flat
        self.named = named
        self.variables = variables
        self.rates = rates
        self.accelerations = accelerations
        self._nodes: dict[int, tuple[fx.FlatExpression, Number]] = {}
        self._many = any(isinstance(value, np.ndarray) for value in variables.values())
        last = (1,) if self._many else ()
        origin, axes = np.zeros((3, *last), np.complex128), np.eye(3, dtype=np.complex128).reshape(3, 3, *last)
        self._frames: dict[str, tuple[Complexes, Complexes]] = {"world": (origin, axes)}
        self._later: _Instant | None = None
        self._waiting: dict[str, Callable[[], Number]] = {}

    # ---- expressions -------------------------------------------------------------------------------------------------

    def scalar(self, expression: fx.FlatExpression) -> Number:
        value = self._value(expression)
        assert not isinstance(value, np.ndarray) or (self._many and value.ndim == 1), "a scalar is expected"
        return value

    def vector(self, expression: fx.FlatExpression) -> Complexes:
        value = self._value(expression)
        assert isinstance(value, np.ndarray), "a vector is expected"
        return value

    def _value(self, expression: fx.FlatExpression) -> Number:
        known = self._nodes
        if id(expression) not in known:
            for node in postorder(expression, known):
                # The node is kept with its value, so that its identity is not given to another one.
                known[id(node)] = (node, self._compute(node))
        return known[id(expression)][1]

    def _compute(self, expression: fx.FlatExpression) -> Number:  # noqa: C901, PLR0912 one case per node
        match expression:
            case fx.Number(value):
                return complex(value)
            case fx.Variable(name):
                return self._variable(name)
            case fx.Derivative(operand):
                return self._derivative(operand)
            case fx.Unary(operator, operand):
                inner = self._value(operand)
                return -inner if operator == "-" else compared("==", inner, 0j)
            case fx.Binary():
                return self._binary(expression)
            case fx.Function(name, arguments):
                return applied(name, [self.scalar(argument) for argument in arguments])
            case fx.Conditional(condition, then, otherwise):
                return chosen(self.scalar(condition), self._value(then), self._value(otherwise))
            case fx.Component(vector, axis):
                return self._single(self.vector(vector)[axis])
            case fx.Dot(left, right):
                return self._dot(self.vector(left), self.vector(right))
            case fx.Norm(vector):
                components = self.vector(vector)
                return applied("sqrt", [self._dot(components, components)])
            case fx.Vector(x, y, z):
                return self._scalars((x, y, z))
            case fx.Cross(left, right):
                return np.cross(self.vector(left), self.vector(right), axis=0)
            case fx.PointReference(name):
                point = self.named[name]
                assert isinstance(point, fm.Point)
                return self.vector(point.position)
            case fx.FrameOrigin(frame):
                return self.frame(frame)[0]
            case fx.FrameAxis(frame, axis):
                return self.frame(frame)[1][:, axis]
            case fx.AngularVelocity(frame):
                return self._angular_velocity(frame)
            case fx.MaterialVelocity(point_expression, frame):
                arm = self.vector(point_expression) - self.frame(frame)[0]
                origin_velocity = self._rate(lambda moment: moment.frame(frame)[0])
                return origin_velocity + np.cross(self._angular_velocity(frame), arm, axis=0)
            case fx.Previous() | fx.Mechanical() | fx.OfMechanism():
                raise NotEvaluable(type(expression).__name__)
            case _:
                assert_never(expression)

    def _single(self, value: Number) -> Number:
        """A number of NumPy as one of Python, which is faster; an array as it is."""
        return value if self._many else complex(value)

    def _dot(self, left: Complexes, right: Complexes) -> Number:
        return (left * right).sum(axis=0) if self._many else complex(left @ right)

    def _variable(self, name: str) -> Number:
        item = self.named.get(name)
        if isinstance(item, fm.Definition):
            return self.scalar(item.value)
        if name in self._waiting:
            self.variables[name] = self._waiting.pop(name)()
        if name in self.variables:
            value = self.variables[name]
            return value if isinstance(value, np.ndarray) else complex(value)
        return self._discrete(name)

    def _discrete(self, name: str) -> Number:
        """Relations as they stand, variables at their starts, contacts open, slips free and without a sense, no clock
        ticking."""
        for entry in entries(self.flat.events):
            if entry.name == name:
                item = entry.item
                if isinstance(item, Relation):
                    value = self.scalar(item.difference).real
                    return truth(value > 0.0 if item.strict else value >= 0.0)
                if isinstance(item, Timed):
                    return self.scalar(item.value)
                return self.scalar(item.start) if isinstance(item, Discrete) else 0j
        raise NotEvaluable(name)

    def _binary(self, expression: fx.Binary) -> Number:
        left, right = self._value(expression.left), self._value(expression.right)
        operator = expression.operator
        match operator:
            case "+":
                return left + right
            case "-":
                return left - right
            case "*":
                return left * right
            case "/":
                return divided(left, right)
            case "^":
                return power(left, right)
            case "<" | "<=" | ">" | ">=" | "==" | "<>" | "and" | "or":
                return compared(operator, left, right)
            case _:
                assert_never(operator)

    # ---- frames ------------------------------------------------------------------------------------------------------

    def frame(self, name: str) -> tuple[Complexes, Complexes]:
        """Origin (3,) and axes as columns (3, 3) of a frame, in the world."""
        if name not in self._frames:
            item = self.named[name]
            assert isinstance(item, fm.Frame)
            origin, axes = self.frame(item.parent)
            for step in item.steps:
                origin, axes = self._step(step, origin, axes)
            self._frames[name] = origin, axes
        return self._frames[name]

    def _step(self, step: fm.FrameStep, origin: Complexes, axes: Complexes) -> tuple[Complexes, Complexes]:
        match step:
            case fm.Rotate(axis, angle):
                return origin, composed(axes, rotation(axis, self._angle(angle)))
            case fm.RotateAbout(axis, angle):
                return origin, composed(axes, rotation_about(self._scalars(axis), self._angle(angle)))
            case fm.RotateQuaternion(e):
                return origin, composed(axes, quaternion_rotation(self._scalars(e)))
            case fm.SetAxes(x, y, z):
                columns = np.broadcast_arrays(self.vector(x), self.vector(y), self.vector(z))
                return origin, np.stack(columns, axis=1)
            case fm.Move(offset):
                return origin + turned(axes, self._scalars(offset)), axes
            case fm.Place(position):
                return self.vector(position), axes

    def _angle(self, expression: fx.FlatExpression) -> Number:
        value = self.scalar(expression)
        return np.atleast_1d(value) if self._many else value

    def _scalars(self, expressions: tuple[fx.FlatExpression, ...]) -> Complexes:
        found = [self.scalar(expression) for expression in expressions]
        return np.stack(np.broadcast_arrays(*map(np.atleast_1d, found))) if self._many else np.array(found)

    # ---- time derivatives --------------------------------------------------------------------------------------------

    def _derivative(self, operand: fx.FlatExpression) -> Number:
        if isinstance(operand, fx.Variable) and operand.name in self.rates:
            return self.rates[operand.name]
        if isinstance(operand, fx.Derivative) and isinstance(operand.operand, fx.Variable):
            name = operand.operand.name
            if self.accelerations is not None and name in self.accelerations:
                return self.accelerations[name]
        return self._rate(lambda moment: moment._value(operand))

    def _rate(self, quantity: Callable[[_Instant], Number]) -> Number:
        later = quantity(self._shifted())
        return np.asarray(later.imag / _STEP + 0j) if isinstance(later, np.ndarray) else complex(later.imag / _STEP)

    def _angular_velocity(self, frame: str) -> Complexes:
        """omega from the skew matrix Rdot R'."""
        axes = self.frame(frame)[1]
        turning = composed(np.asarray(self._rate(lambda moment: moment.frame(frame)[1])), axes.swapaxes(0, 1))
        x, y, z = turning[2, 1] - turning[1, 2], turning[0, 2] - turning[2, 0], turning[1, 0] - turning[0, 1]
        return np.array([x, y, z], dtype=np.complex128) / 2

    def _shifted(self) -> _Instant:
        """The moment an imaginary step later. Complex steps do not nest: a step of a step is refused."""
        if self.accelerations is None:
            raise NotEvaluable("a derivative of a derivative")
        if self._later is None:
            rates = {**self.rates}
            rates.update({i.derivative_of: self.variables[i.name] for i in self.flat.inputs if i.derivative_of})
            variables = {name: value + 1j * _STEP * rates.get(name, 0.0) for name, value in self.variables.items()}
            later = {name: rate + 1j * _STEP * self.accelerations.get(name, 0.0) for name, rate in self.rates.items()}
            self._later = _Instant(self.flat, self.named, variables, later, None)
            moving = (state for state in self.flat.states if state.name in variables and state.name not in rates)
            self._later._waiting = {state.name: partial(self._state_later, state) for state in moving}
        return self._later

    def _state_later(self, state: fm.State) -> Number:
        """Asked for where it is read only: equations of states may read rates of other quantities."""
        return self.variables[state.name] + 1j * _STEP * self.scalar(state.derivative)
