"""The functions of a model for JAX: of one state each, for jax.jit, jax.vmap and jax.grad, in double precision."""

from collections.abc import Callable, Mapping, Sequence
from typing import Any

import jax.numpy as jnp

from lagdsl.engines.backends.jax.elementary import Elementary
from lagdsl.engines.backends.jax.loop import Instructions

Body = Callable[..., Sequence[Any]] | Instructions
Row = tuple[Body, tuple[tuple[str, int | None], ...], tuple[tuple[str, tuple[int, ...]], ...]]


class Functions:
    """The functions of a model by name, and what users call. Arguments are those of one state."""

    def __init__(
        self,
        rows: Mapping[str, Row],
        lengths: Sequence[int],
        defaults: Sequence[float],
        kept: Sequence[int],
        redundant: Sequence[bool],
    ) -> None:
        self._rows, self._lengths, self._defaults = rows, tuple(lengths), defaults
        self._kept, self._redundant = list(kept), list(redundant)

    def evaluate(self, name: str, *arguments: Any) -> tuple[Any, ...]:
        """Results of a function of the table. Raises ValueError for an argument of a wrong length."""
        body, signature, results = self._rows[name]
        given = [_array(name, label, length, x) for (label, length), x in zip(signature, arguments, strict=True)]
        if isinstance(body, Instructions):
            values = body(given)
        else:
            found = body(Elementary, *(x if x.ndim == 0 else jnp.unstack(x) for x in given))
            values = jnp.stack([jnp.asarray(x, dtype=float) for x in found]) if found else jnp.zeros(0)
        blocks, first = [], 0
        for _, shape in results:
            size = 1
            for length in shape:
                size *= length
            blocks.append(values[first : first + size].reshape(shape))
            first += size
        return tuple(blocks)

    def forward_dynamics(
        self, t: Any, q: Any, qd: Any, z: Any = None, u: Any = None, w: Any = None, p: Any = None
    ) -> Any:
        """Accelerations qdd, shape (nq,)."""
        return self._motion(self._state(t, q, qd, z, u, w, p))[0]

    def multipliers(self, t: Any, q: Any, qd: Any, z: Any = None, u: Any = None, w: Any = None, p: Any = None) -> Any:
        """Multipliers of all rows, shape (nc,), of least norm."""
        return self._motion(self._state(t, q, qd, z, u, w, p))[1]

    def rates(
        self, t: Any, q: Any, qd: Any, z: Any = None, u: Any = None, w: Any = None, p: Any = None
    ) -> tuple[Any, Any, Any]:
        """qd, qdd and zd."""
        state = self._state(t, q, qd, z, u, w, p)
        acceleration, multiplier = self._motion(state)
        return state[2], acceleration, self.evaluate("state_derivative", *state, acceleration, multiplier)[0]

    def output(self, t: Any, q: Any, qd: Any, z: Any = None, u: Any = None, w: Any = None, p: Any = None) -> Any:
        """Outputs y, shape (ny,)."""
        state = self._state(t, q, qd, z, u, w, p)
        return self.evaluate("output", *state, *self._motion(state))[0]

    def inverse_dynamics(
        self, t: Any, q: Any, qd: Any, qdd: Any, z: Any = None, u: Any = None, w: Any = None, p: Any = None
    ) -> Any:
        """M qdd - f, shape (nq,)."""
        return self.evaluate("inverse_dynamics", *self._state(t, q, qd, z, u, w, p), qdd)[0]

    def mass_matrix(self, t: Any, q: Any, p: Any = None) -> Any:
        """M, shape (nq, nq)."""
        return self.evaluate("mass_matrix", *self._state(t, q, None, None, None, None, p))[0]

    def energy(self, t: Any, q: Any, qd: Any, p: Any = None) -> Any:
        """T + V and the energy of `lagrangian` terms [J]."""
        return self.evaluate("energies", *self._state(t, q, qd, None, None, None, p))[0]

    def _state(self, t: Any, q: Any, qd: Any, z: Any, u: Any, w: Any, p: Any) -> tuple[Any, ...]:
        """Left out: initial values and defaults of the model; for w with relations as they stand."""
        time = jnp.asarray(t, dtype=float)
        parameters = jnp.array(self._defaults, dtype=float) if p is None else p
        _, _, first_z, first_u = self.evaluate("start", time, parameters)
        rates = jnp.zeros(self._lengths[0]) if qd is None else qd
        state = (time, q, rates, first_z if z is None else z, first_u if u is None else u)
        if w is not None or not self._lengths[4]:
            return (*state, jnp.zeros(0) if w is None else w, parameters)
        (started,) = self.evaluate("discrete_start", time, parameters)
        solved = self._motion((*state, started, parameters))
        return (*state, self.evaluate("standing", *state, started, parameters, *solved)[0], parameters)

    def _motion(self, state: tuple[Any, ...]) -> tuple[Any, Any]:
        """Accelerations, and multipliers of least Euclidean norm."""
        _, jacobian = self.evaluate("velocity_constraint", *state)
        if "elimination" not in self._rows:
            acceleration, multiplier = self._dense(state, jacobian)
        else:
            acceleration, multiplier, response, adds, kept_jacobian, bias, _ = self.evaluate("elimination", *state)
            chosen = [k for k, row in enumerate(self._kept) if not self._redundant[row]]
            if chosen:
                places = jnp.array(chosen)
                y, j = response[places], kept_jacobian[places]
                both = adds[places] + jnp.eye(len(multiplier))[jnp.array(self._kept)[places]]
                small = _with_unit_rows(j @ y.T, j)
                for _ in range(2):  # the second time takes back the rounding of the first
                    found = jnp.linalg.solve(small, bias[places] - j @ acceleration)
                    acceleration, multiplier = acceleration + y.T @ found, multiplier + both.T @ found
        return acceleration, self._least(multiplier, jacobian)

    def _dense(self, state: tuple[Any, ...], jacobian: Any) -> tuple[Any, Any]:
        """M a - J'lam = f, J a = gamma with the rows that are independent."""
        mass, force, _, gamma = self.evaluate("dynamics", *state)
        free, multiplier = jnp.linalg.solve(mass, force), jnp.zeros(len(self._redundant))
        chosen = [k for k, excess in enumerate(self._redundant) if not excess]
        if not chosen:
            return free, multiplier
        places = jnp.array(chosen)
        j = jacobian[places]
        response = jnp.linalg.solve(mass, j.T)
        found = jnp.linalg.solve(_with_unit_rows(j @ response, j), gamma[places] - j @ free)
        return free + response @ found, multiplier.at[places].set(found)

    def _least(self, multiplier: Any, jacobian: Any) -> Any:
        """The multipliers of least norm with the same J'lam. With J = E J_i of the independent rows these are
        E (E'E)^-1 E'lam."""
        chosen = [k for k, excess in enumerate(self._redundant) if not excess]
        if len(chosen) == len(self._redundant):
            return multiplier
        j = jacobian[jnp.array(chosen, dtype=int)]
        spread = jnp.linalg.solve(_with_unit_rows(j @ j.T, j), j @ jacobian.T).T
        gram = _with_unit_rows(spread.T @ spread, j)
        return spread @ jnp.linalg.solve(gram, spread.T @ multiplier)


def _with_unit_rows(matrix: Any, rows: Any) -> Any:
    """`matrix` with 1 on the diagonal where a row of J is zero, as that of an open contact: its multiplier is zero
    then."""
    return matrix + jnp.diag(jnp.where((rows * rows).sum(axis=1) == 0.0, 1.0, 0.0))


def _array(name: str, label: str, length: int | None, value: Any) -> Any:
    array = jnp.asarray(value, dtype=float)
    if array.shape != (() if length is None else (length,)):
        raise ValueError(
            f"{label} of {name} must have the shape ({'' if length is None else f'{length},'}), not {array.shape}"
        )
    return array
