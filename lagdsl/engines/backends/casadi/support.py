"""The functions of a model as functions of CasADi."""

from collections.abc import Callable, Mapping, Sequence
from typing import Any

import casadi
from casadi import SX

Row = tuple[Callable[..., Sequence[Any]], tuple[tuple[str, int | None], ...], tuple[tuple[str, tuple[int, ...]], ...]]


class Elementary:
    """Functions that the bodies of the model's functions call, by name. Conditions are the numbers 0 and 1."""

    sin, cos, tan = casadi.sin, casadi.cos, casadi.tan
    asin, acos, atan, atan2 = casadi.asin, casadi.acos, casadi.atan, casadi.atan2
    sinh, cosh, tanh = casadi.sinh, casadi.cosh, casadi.tanh
    exp, log, sqrt, power = casadi.exp, casadi.log, casadi.sqrt, casadi.power
    absolute, sign, floor, ceil = casadi.fabs, casadi.sign, casadi.floor, casadi.ceil
    negation, both, either = casadi.logic_not, casadi.logic_and, casadi.logic_or

    @staticmethod
    def divide(x: Any, y: Any) -> Any:
        return SX(x) / y

    @staticmethod
    def modulo(x: Any, y: Any) -> Any:
        """x - floor(x/y)*y, with the sign of y."""
        return x - casadi.floor(SX(x) / y) * y

    @staticmethod
    def minimum(x: Any, y: Any) -> Any:
        return casadi.if_else(SX(x) <= y, x, y)

    @staticmethod
    def maximum(x: Any, y: Any) -> Any:
        return casadi.if_else(SX(x) >= y, x, y)

    @staticmethod
    def less(x: Any, y: Any) -> Any:
        return SX(x) < y

    @staticmethod
    def less_equal(x: Any, y: Any) -> Any:
        return SX(x) <= y

    @staticmethod
    def equal(x: Any, y: Any) -> Any:
        return SX(x) == y

    @staticmethod
    def select(condition: Any, value: Any, otherwise: Any) -> Any:
        return casadi.if_else(SX(condition) != 0, value, otherwise)


class Functions:
    """The functions of a model by name. Each is a casadi.Function with named arguments and results."""

    def __init__(
        self, rows: Mapping[str, Row], lengths: Sequence[int], kept: Sequence[int], redundant: Sequence[bool]
    ) -> None:
        self._rows, self._kept, self._redundant = rows, list(kept), list(redundant)
        self._state = [SX.sym(name, length) for name, length in zip(_STATE, (1, *lengths), strict=True)]
        self._known: dict[str, casadi.Function] = {}

    def __getitem__(self, name: str) -> casadi.Function:
        if name not in self._known:
            self._known[name] = self._solved(name) if name in _SOLVED else self._direct(name)
        return self._known[name]

    def names(self) -> list[str]:
        return [*_SOLVED, *self._rows]

    def _direct(self, name: str) -> casadi.Function:
        if name not in self._rows:
            raise KeyError(f"there is no function {name!r}; there are {', '.join(self.names())}")
        _, signature, results = self._rows[name]
        arguments = [SX.sym(label, 1 if length is None else length) for label, length in signature]
        named = [label for label, _ in signature]
        return casadi.Function(name, arguments, self._blocks(name, arguments), named, [label for label, _ in results])

    def _blocks(self, name: str, arguments: Sequence[SX]) -> list[SX]:
        """The results of a function of the table."""
        body, _, results = self._rows[name]
        values = [SX(value) for value in body(Elementary, *arguments)]
        blocks, first = [], 0
        for _, shape in results:
            rows, columns = (*shape, 1, 1)[:2]
            part = values[first : first + rows * columns]
            blocks.append(casadi.reshape(casadi.vertcat(*part), columns, rows).T if part else SX(rows, columns))
            first += rows * columns
        return blocks

    def _solved(self, name: str) -> casadi.Function:
        acceleration, multiplier = self._motion()
        given = [*self._state, acceleration, multiplier]
        (rates,) = self._blocks("state_derivative", given)
        (outputs,) = self._blocks("output", given)
        results = {
            "forward_dynamics": {"qdd": acceleration, "lam": multiplier},
            "rates": {"dq": self._state[2], "dqd": acceleration, "dz": rates},
            "outputs": {"y": outputs},
        }[name]
        return casadi.Function(name, self._state, list(results.values()), list(_STATE), list(results))

    def _motion(self) -> tuple[SX, SX]:
        """Accelerations, and multipliers of least Euclidean norm."""
        state = self._state
        _, jacobian = self._blocks("velocity_constraint", state)
        if "elimination" not in self._rows:
            acceleration, multiplier = self._dense(jacobian)
        else:
            acceleration, multiplier, response, adds, kept_jacobian, bias, _ = self._blocks("elimination", state)
            chosen = [k for k, row in enumerate(self._kept) if not self._redundant[row]]
            if chosen:
                y, j = response[chosen, :], kept_jacobian[chosen, :]
                own = casadi.vertcat(*(SX.eye(multiplier.numel())[self._kept[k], :] for k in chosen))
                both = adds[chosen, :] + own
                small = _with_unit_rows(j @ y.T, j)
                for _ in range(2):  # the second time takes back the rounding of the first
                    found = casadi.solve(small, bias[chosen] - j @ acceleration)
                    acceleration, multiplier = acceleration + y.T @ found, multiplier + both.T @ found
        return acceleration, self._least(multiplier, jacobian)

    def _dense(self, jacobian: SX) -> tuple[SX, SX]:
        """M a - J'lam = f, J a = gamma with the rows that are independent."""
        mass, force, _, gamma = self._blocks("dynamics", self._state)
        chosen = [k for k, excess in enumerate(self._redundant) if not excess]
        if not chosen:
            return casadi.solve(mass, force), SX(len(self._redundant), 1)
        j = jacobian[chosen, :]
        response = casadi.solve(mass, j.T)
        free = casadi.solve(mass, force)
        found = casadi.solve(_with_unit_rows(j @ response, j), gamma[chosen] - j @ free)
        multiplier = SX.zeros(len(self._redundant), 1)
        multiplier[chosen] = found
        return free + response @ found, multiplier

    def _least(self, multiplier: SX, jacobian: SX) -> SX:
        """The multipliers of least norm with the same J'lam. With J = E J_i of the independent rows these are
        E (E'E)^-1 E'lam."""
        chosen = [k for k, excess in enumerate(self._redundant) if not excess]
        if len(chosen) == len(self._redundant):
            return multiplier
        j = jacobian[chosen, :]
        spread = casadi.solve(_with_unit_rows(j @ j.T, j), j @ jacobian.T).T
        gram = _with_unit_rows(spread.T @ spread, j)
        return spread @ casadi.solve(gram, spread.T @ multiplier)


_STATE = ("t", "q", "qd", "z", "u", "w", "p")
_SOLVED = ("forward_dynamics", "rates", "outputs")


def _with_unit_rows(matrix: SX, rows: SX) -> SX:
    """`matrix` with 1 on the diagonal where a row of J is zero, as that of an open contact: its multiplier is zero
    then."""
    return matrix + casadi.diag(casadi.sum2(rows * rows) == 0)
