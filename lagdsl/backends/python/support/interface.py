"""The functions that users call."""

from collections.abc import Callable, Sequence

import numpy as np
from numpy.typing import ArrayLike, NDArray

from lagdsl.backends.python.support.derivatives import differentiate_motion
from lagdsl.backends.python.support.motion import Sizes, solve_motion

Floats = NDArray[np.float64]
Evaluate = Callable[..., tuple[Floats, ...]]


class Interface:
    """The mechanics of a model as functions of t [s], q (..., nq), qd (..., nq) and more, by name.

    These are the states z (..., nz), inputs u (..., nu), discretes w (..., nw) and parameters p (..., np); left out,
    they have the initial values and defaults of the model, or zeros. All arguments broadcast over their leading axes.
    Entries stand in the order of the tables of names, in the SI units told there. Raises ValueError for an array of a
    wrong length and SingularSystem (an ArithmeticError) where the accelerations are not determined.
    """

    def __init__(
        self,
        evaluate: Evaluate,
        solve: Evaluate,
        differentiate: Evaluate,
        sizes: Sizes,
        defaults: Sequence[float],
    ) -> None:
        self._evaluate = evaluate
        self._solve = solve
        self._differentiate = differentiate
        self._sizes = sizes
        self._defaults = np.array(defaults, dtype=np.float64)

    @classmethod
    def over(cls, evaluate: Evaluate, sizes: Sizes, defaults: Sequence[float]) -> "Interface":
        """The interface over functions that NumPy evaluates and solves."""
        return cls(
            evaluate,
            lambda *state: solve_motion(evaluate, sizes, *state),
            lambda by, *state: differentiate_motion(evaluate, sizes, by, *state),
            sizes,
            defaults,
        )

    def forward_dynamics(
        self,
        t: ArrayLike,
        q: ArrayLike,
        qd: ArrayLike,
        z: ArrayLike | None = None,
        u: ArrayLike | None = None,
        w: ArrayLike | None = None,
        p: ArrayLike | None = None,
    ) -> Floats:
        """Accelerations qdd, shape (..., nq), without any stabilization of constraints."""
        return self._solve(*self._state(t, q, qd, z, u, w, p))[0]

    def multipliers(
        self,
        t: ArrayLike,
        q: ArrayLike,
        qd: ArrayLike,
        z: ArrayLike | None = None,
        u: ArrayLike | None = None,
        w: ArrayLike | None = None,
        p: ArrayLike | None = None,
    ) -> Floats:
        """Multipliers lam of all declared rows in M qdd - J'lam = f, shape (..., nc), of least norm."""
        return self._solve(*self._state(t, q, qd, z, u, w, p))[1]

    def inverse_dynamics(
        self,
        t: ArrayLike,
        q: ArrayLike,
        qd: ArrayLike,
        qdd: ArrayLike,
        z: ArrayLike | None = None,
        u: ArrayLike | None = None,
        w: ArrayLike | None = None,
        p: ArrayLike | None = None,
    ) -> Floats:
        """M qdd - f, shape (..., nq): the generalized forces that are missing to produce qdd."""
        state = self._state(t, q, qd, z, u, w, p)
        return self._evaluate("inverse_dynamics", *state, _vector("qdd", qdd, self._sizes.q))[0]

    def mass_matrix(
        self, t: ArrayLike, q: ArrayLike, qd: ArrayLike | None = None, p: ArrayLike | None = None
    ) -> Floats:
        """M, shape (..., nq, nq); it depends on qd (default 0) only for Lagrangians not quadratic in the rates."""
        return self._evaluate("mass_matrix", *self._state(t, q, qd, None, None, None, p))[0]

    def constraint_jacobian(self, t: ArrayLike, q: ArrayLike, p: ArrayLike | None = None) -> Floats:
        """J, shape (..., nc, nq), all declared rows in source order."""
        return self._evaluate("velocity_constraint", *self._state(t, q, None, None, None, None, p))[1]

    def output(
        self,
        t: ArrayLike,
        q: ArrayLike,
        qd: ArrayLike,
        z: ArrayLike | None = None,
        u: ArrayLike | None = None,
        w: ArrayLike | None = None,
        p: ArrayLike | None = None,
    ) -> Floats:
        """Outputs y, shape (..., ny)."""
        state = self._state(t, q, qd, z, u, w, p)
        return self._evaluate("output", *state, *self._solve(*state))[0]

    def energy(self, t: ArrayLike, q: ArrayLike, qd: ArrayLike, p: ArrayLike | None = None) -> Floats:
        """T + V and, for each `lagrangian` term Lx, qd . dLx/dqd - Lx, in J, shape (...)."""
        return self._evaluate("energies", *self._state(t, q, qd, None, None, None, p))[0]

    def state_jacobian(
        self,
        t: ArrayLike,
        q: ArrayLike,
        qd: ArrayLike,
        z: ArrayLike | None = None,
        u: ArrayLike | None = None,
        w: ArrayLike | None = None,
        p: ArrayLike | None = None,
    ) -> Floats:
        """d(qd, qdd, zd)/d(q, qd, z), shape (..., 2 nq + nz, 2 nq + nz), exact."""
        return self._differentiate("state", *self._state(t, q, qd, z, u, w, p))[0]

    def input_jacobian(
        self,
        t: ArrayLike,
        q: ArrayLike,
        qd: ArrayLike,
        z: ArrayLike | None = None,
        u: ArrayLike | None = None,
        w: ArrayLike | None = None,
        p: ArrayLike | None = None,
    ) -> Floats:
        """d(qd, qdd, zd)/du, shape (..., 2 nq + nz, nu), exact."""
        return self._differentiate("input", *self._state(t, q, qd, z, u, w, p))[0]

    def parameter_jacobian(
        self,
        t: ArrayLike,
        q: ArrayLike,
        qd: ArrayLike,
        z: ArrayLike | None = None,
        u: ArrayLike | None = None,
        w: ArrayLike | None = None,
        p: ArrayLike | None = None,
    ) -> Floats:
        """d(qd, qdd, zd)/dp, shape (..., 2 nq + nz, np), exact; q, qd and z are held where they are."""
        return self._differentiate("parameter", *self._state(t, q, qd, z, u, w, p))[0]

    def output_jacobian(
        self,
        t: ArrayLike,
        q: ArrayLike,
        qd: ArrayLike,
        z: ArrayLike | None = None,
        u: ArrayLike | None = None,
        w: ArrayLike | None = None,
        p: ArrayLike | None = None,
        *,
        by: str = "state",
    ) -> Floats:
        """dy/dx, shape (..., ny, nx), exact, by the "state" q, qd, z, by the "input" u or by the "parameter" p.

        Raises ValueError for another word.
        """
        return self._differentiate(by, *self._state(t, q, qd, z, u, w, p))[1]

    def _state(
        self,
        t: ArrayLike,
        q: ArrayLike,
        qd: ArrayLike | None,
        z: ArrayLike | None,
        u: ArrayLike | None,
        w: ArrayLike | None,
        p: ArrayLike | None,
    ) -> tuple[Floats, ...]:
        sizes = self._sizes
        time = np.asarray(t, dtype=np.float64)
        parameters = self._defaults if p is None else _vector("p", p, sizes.p)
        if (z is None and sizes.z) or (u is None and sizes.u):
            _, _, initial_states, default_inputs = self._evaluate("start", time, parameters)
        else:
            initial_states, default_inputs = np.zeros(sizes.z), np.zeros(sizes.u)
        state = (
            time,
            _vector("q", q, sizes.q),
            np.zeros(sizes.q) if qd is None else _vector("qd", qd, sizes.q),
            initial_states if z is None else _vector("z", z, sizes.z),
            default_inputs if u is None else _vector("u", u, sizes.u),
        )
        if w is not None or not sizes.w:
            return (*state, np.zeros(0) if w is None else _vector("w", w, sizes.w), parameters)
        started = self._evaluate("discrete_start", time, parameters)[0]
        solved = self._solve(*state, started, parameters)
        return (*state, self._evaluate("standing", *state, started, parameters, *solved)[0], parameters)


def _vector(name: str, value: ArrayLike, length: int) -> Floats:
    array = np.asarray(value, dtype=np.float64)
    if array.ndim == 0 and length == 1:
        array = array.reshape(1)
    if array.ndim == 0 or array.shape[-1] != length:
        raise ValueError(f"{name} must have {length} entries along its last axis, its shape is {array.shape}")
    return array
