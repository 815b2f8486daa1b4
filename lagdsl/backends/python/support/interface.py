"""The functions that users call."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from lagdsl.backends.python.support.derivatives import differentiate_motion
from lagdsl.backends.python.support.feedback import with_loads
from lagdsl.backends.python.support.kinematics import FrameKinematics, PointKinematics, frame_of, point_of
from lagdsl.backends.python.support.motion import Sizes, solve_motion
from lagdsl.backends.python.support.names import arrays_of, own_entries, real_numbers, with_entries

Floats = NDArray[np.float64]
Evaluate = Callable[..., tuple[Floats, ...]]
# A vector in the order of its names, or some of its entries by name.
Entries = ArrayLike | Mapping[str, Any]


class Interface:
    """The mechanics of a model as functions of t [s], q (..., nq), qd (..., nq) and more, by name.

    These are the states z (..., nz), inputs u (..., nu), discretes w (..., nw) and parameters p (..., np); left out,
    they have the initial values and defaults of the model, or zeros. All arguments broadcast over their leading axes.
    Entries stand in the order of the tables of names, in the SI units told there. Or they are given by name, an array
    by its own: `u={"tau": [1.0, 2.0]}`; q and qd then need all coordinates. Loads in w that depend on accelerations or
    multipliers are found, from those given. Raises ValueError for an array of a wrong length and for unknown or missing
    names, SingularSystem (an ArithmeticError) where the accelerations are not determined, LoadsNotFound (another one).
    """

    def __init__(
        self,
        evaluate: Evaluate,
        solve: Evaluate,
        differentiate: Evaluate,
        sizes: Sizes,
        defaults: Sequence[float],
        names: Mapping[str, Sequence[str]],
        frames: tuple[str, ...] = (),
        points: tuple[str, ...] = (),
        aliases: Mapping[str, str] | None = None,
    ) -> None:
        self._names, self._aliases = names, aliases or {}
        self._frames, self._points = frames, points
        self._evaluate = evaluate
        self._solve = solve
        self._differentiate = differentiate
        self._sizes = sizes
        self._defaults = np.array(defaults, dtype=np.float64)
        self._row_factors: Floats = np.ones(1)  # by which the equations multiply rows, where that is known

    def forward_dynamics(
        self,
        t: ArrayLike,
        q: Entries,
        qd: Entries,
        z: Entries | None = None,
        u: Entries | None = None,
        w: Entries | None = None,
        p: Entries | None = None,
    ) -> Floats:
        """Accelerations qdd, shape (..., nq), without any stabilization of constraints."""
        return self._solve(*self._moving(t, q, qd, z, u, w, p))[0]

    def multipliers(
        self,
        t: ArrayLike,
        q: Entries,
        qd: Entries,
        z: Entries | None = None,
        u: Entries | None = None,
        w: Entries | None = None,
        p: Entries | None = None,
    ) -> Floats:
        """Multipliers lam of all declared rows in M qdd - J'lam = f, shape (..., nc), of least norm."""
        return self._solve(*self._moving(t, q, qd, z, u, w, p))[1] * self._row_factors

    def inverse_dynamics(
        self,
        t: ArrayLike,
        q: Entries,
        qd: Entries,
        qdd: ArrayLike,
        z: Entries | None = None,
        u: Entries | None = None,
        w: Entries | None = None,
        p: Entries | None = None,
    ) -> Floats:
        """M qdd - f, shape (..., nq): the generalized forces that are missing to produce qdd. Loads that depend on
        accelerations or multipliers are those in w."""
        state = self._state(t, q, qd, z, u, w, p)
        return self._evaluate("inverse_dynamics", *state, self._vector("qdd", qdd, None))[0]

    def mass_matrix(self, t: ArrayLike, q: Entries, qd: Entries | None = None, p: Entries | None = None) -> Floats:
        """M, shape (..., nq, nq); it depends on qd (default 0) only for Lagrangians not quadratic in the rates."""
        return self._evaluate("mass_matrix", *self._state(t, q, qd, None, None, None, p))[0]

    def coriolis_matrix(self, t: ArrayLike, q: Entries, qd: Entries, p: Entries | None = None) -> Floats:
        """C by Christoffel's symbols, shape (..., nq, nq): C qd are the Coriolis and centrifugal forces.

        dM/dt - 2 C is skew where M depends on q and p alone.
        """
        return self._evaluate("equation_terms", *self._state(t, q, qd, None, None, None, p))[0]

    def gravity_forces(self, t: ArrayLike, q: Entries, p: Entries | None = None) -> Floats:
        """g = dV/dq, shape (..., nq), of weights and of all other potentials, such as springs."""
        return self._evaluate("equation_terms", *self._state(t, q, None, None, None, None, p))[1]

    def bias_forces(
        self,
        t: ArrayLike,
        q: Entries,
        qd: Entries,
        z: Entries | None = None,
        u: Entries | None = None,
        w: Entries | None = None,
        p: Entries | None = None,
    ) -> Floats:
        """d/dt(dL/dqd) - dL/dq at qdd = 0, shape (..., nq): C qd + g, and what prescribed motion adds. Loads, damping
        and reactions are no part of it; `inverse_dynamics` at qdd = 0 is this less the loads."""
        return self._evaluate("equation_terms", *self._state(t, q, qd, z, u, w, p))[2]

    def regressor(
        self,
        t: ArrayLike,
        q: Entries,
        qd: Entries,
        qdd: ArrayLike,
        z: Entries | None = None,
        u: Entries | None = None,
        w: Entries | None = None,
        p: Entries | None = None,
    ) -> Floats:
        """Y, shape (..., nq, n): with the n `inertial_parameters` pi, Y pi = M qdd + bias of masses and bodies."""
        state = self._state(t, q, qd, z, u, w, p)
        return self._evaluate("regressor", *state, self._vector("qdd", qdd, None))[0]

    def inertial_parameters(self, p: Entries | None = None) -> Floats:
        """pi, shape (..., n): of each body mass, first moments and inertia about the origin of its frame, of each
        mass its mass."""
        zeros = np.zeros(self._sizes.q)
        return self._evaluate("regressor", *self._state(0.0, zeros, None, None, None, None, p), zeros)[1]

    def constraint_jacobian(self, t: ArrayLike, q: Entries, p: Entries | None = None) -> Floats:
        """J, shape (..., nc, nq), all declared rows in source order."""
        rows = self._evaluate("velocity_constraint", *self._state(t, q, None, None, None, None, p))[1]
        return rows / np.reshape(self._row_factors, (-1, 1))

    def output(
        self,
        t: ArrayLike,
        q: Entries,
        qd: Entries,
        z: Entries | None = None,
        u: Entries | None = None,
        w: Entries | None = None,
        p: Entries | None = None,
    ) -> Floats:
        """Outputs y, shape (..., ny)."""
        state = self._moving(t, q, qd, z, u, w, p)
        return self._evaluate("output", *state, *self._solve(*state))[0]

    def named_outputs(
        self,
        t: ArrayLike,
        q: Entries,
        qd: Entries,
        z: Entries | None = None,
        u: Entries | None = None,
        w: Entries | None = None,
        p: Entries | None = None,
    ) -> dict[str, Floats]:
        """Outputs by name: shape (...) of a scalar, (..., n) of an array of n elements."""
        return arrays_of(self._names["y"], self.output(t, q, qd, z, u, w, p))

    def energy(self, t: ArrayLike, q: Entries, qd: Entries, p: Entries | None = None) -> Floats:
        """T + V and, for each `lagrangian` term Lx, qd . dLx/dqd - Lx, in J, shape (...)."""
        return self._evaluate("energies", *self._state(t, q, qd, None, None, None, p))[0]

    def state_jacobian(
        self,
        t: ArrayLike,
        q: Entries,
        qd: Entries,
        z: Entries | None = None,
        u: Entries | None = None,
        w: Entries | None = None,
        p: Entries | None = None,
    ) -> Floats:
        """d(qd, qdd, zd)/d(q, qd, z), shape (..., 2 nq + nz, 2 nq + nz), exact."""
        return self._differentiate("state", *self._moving(t, q, qd, z, u, w, p))[0]

    def input_jacobian(
        self,
        t: ArrayLike,
        q: Entries,
        qd: Entries,
        z: Entries | None = None,
        u: Entries | None = None,
        w: Entries | None = None,
        p: Entries | None = None,
    ) -> Floats:
        """d(qd, qdd, zd)/du, shape (..., 2 nq + nz, nu), exact."""
        return self._differentiate("input", *self._moving(t, q, qd, z, u, w, p))[0]

    def parameter_jacobian(
        self,
        t: ArrayLike,
        q: Entries,
        qd: Entries,
        z: Entries | None = None,
        u: Entries | None = None,
        w: Entries | None = None,
        p: Entries | None = None,
    ) -> Floats:
        """d(qd, qdd, zd)/dp, shape (..., 2 nq + nz, np), exact; q, qd and z are held where they are."""
        return self._differentiate("parameter", *self._moving(t, q, qd, z, u, w, p))[0]

    def output_jacobian(
        self,
        t: ArrayLike,
        q: Entries,
        qd: Entries,
        z: Entries | None = None,
        u: Entries | None = None,
        w: Entries | None = None,
        p: Entries | None = None,
        *,
        by: str = "state",
    ) -> Floats:
        """dy/dx, shape (..., ny, nx), exact, by the "state" q, qd, z, by the "input" u or by the "parameter" p.

        Raises ValueError for another word.
        """
        return self._differentiate(by, *self._moving(t, q, qd, z, u, w, p))[1]

    def frame(self, name: str) -> FrameKinematics:
        """The motion of a frame: `.position .rotation .velocity .jacobian .bias_acceleration` of t, q, qd.

        Raises KeyError.
        """
        return frame_of(self._kinematics, self._frames, name)

    def point(self, name: str) -> PointKinematics:
        """The motion of a point: `.position .velocity .jacobian .bias_acceleration` of t, q, qd. Raises
        KeyError."""
        return point_of(self._kinematics, self._frames, self._points, name)

    def _kinematics(
        self,
        t: ArrayLike,
        q: Entries,
        qd: Entries | None,
        z: Entries | None = None,
        u: Entries | None = None,
        w: Entries | None = None,
        p: Entries | None = None,
    ) -> tuple[Floats, ...]:
        return self._evaluate("kinematics", *self._state(t, q, qd, z, u, w, p))

    def _moving(self, *given: Any) -> tuple[Floats, ...]:
        """t, q, qd, z, u, w, p, with the loads that depend on the motion that they cause."""
        state = self._state(*given)
        count = self._sizes.loads
        return with_loads(self._evaluate, self._solve, count, *state) if count else state

    def _state(
        self,
        t: ArrayLike,
        q: Entries,
        qd: Entries | None,
        z: Entries | None,
        u: Entries | None,
        w: Entries | None,
        p: Entries | None,
    ) -> tuple[Floats, ...]:
        sizes = self._sizes
        coordinates = self._vector("q", q, None)
        time = _time(t, coordinates.shape, sizes.q)
        parameters = self._defaults if p is None else self._vector("p", p, self._defaults)
        if (_is_partial(z) and sizes.z) or (_is_partial(u) and sizes.u):
            _, _, initial_states, default_inputs = self._evaluate("start", time, parameters)
        else:
            initial_states, default_inputs = np.zeros(sizes.z), np.zeros(sizes.u)
        state = (
            time,
            coordinates,
            np.zeros(sizes.q) if qd is None else self._vector("qd", qd, None),
            initial_states if z is None else self._vector("z", z, initial_states),
            default_inputs if u is None else self._vector("u", u, default_inputs),
        )
        if not sizes.w or not _is_partial(w):
            return (*state, np.zeros(0) if w is None else self._vector("w", w, None), parameters)
        standing = self._standing(*state, parameters)
        return (*state, standing if w is None else self._vector("w", w, standing), parameters)

    def _standing(self, *state: Floats) -> Floats:
        """w as relations stand at t, q, qd, z, u, p."""
        *before, parameters = state
        started = self._evaluate("discrete_start", before[0], parameters)[0]
        solved = self._solve(*before, started, parameters)
        return self._evaluate("standing", *before, started, parameters, *solved)[0]

    def _vector(self, name: str, given: Entries, others: Floats | None) -> Floats:
        """Entries by name, or all of them; those that are left out by name are those of `others`."""
        names = self._names[name]
        if isinstance(given, Mapping):
            own = own_entries(self._aliases, given) if name in ("q", "qd") else given
            return with_entries(name, names, self._numbers(name, own), others)
        return _vector(name, given, len(names))

    def _numbers(self, name: str, given: Mapping[str, Any]) -> Mapping[str, ArrayLike]:
        """Values by name in SI units."""
        return given


def interface_over(
    evaluate: Evaluate,
    sizes: Sizes,
    defaults: Sequence[float],
    names: Mapping[str, Sequence[str]],
    frames: tuple[str, ...] = (),
    points: tuple[str, ...] = (),
    aliases: Mapping[str, str] | None = None,
) -> Interface:
    """The interface over functions that NumPy evaluates and solves. `frames` and `points` are those that the function
    `kinematics` tells of, `aliases` other names of coordinates."""
    return Interface(
        evaluate,
        lambda *state: solve_motion(evaluate, sizes, *state),
        lambda by, *state: differentiate_motion(evaluate, sizes, by, *state),
        sizes,
        defaults,
        names,
        frames,
        points,
        aliases,
    )


def _time(t: ArrayLike, shape: tuple[int, ...], count: int) -> Floats:
    """Raises ValueError for what must be the coordinates: one state whose time is a vector as long as it."""
    time = real_numbers("t", t)
    if time.ndim and time.shape[-1] == count and len(shape) == 1 and count > 1:
        raise ValueError(
            f"t has the shape {time.shape}, that of coordinates: the time is the first argument. For one state at "
            f"{count} times give q the shape (1, {count})"
        )
    return time


def _is_partial(given: Entries | None) -> bool:
    """True if entries may be left out."""
    return given is None or isinstance(given, Mapping)


def _vector(name: str, value: ArrayLike, length: int) -> Floats:
    array = real_numbers(name, value)
    if array.ndim == 0 and length == 1:
        array = array.reshape(1)
    if array.ndim == 0 or array.shape[-1] != length:
        hint = "; the arguments are t, q, qd, ..." if name in ("q", "qd") else ""
        raise ValueError(f"{name} must have {length} entries along its last axis, its shape is {array.shape}{hint}")
    return array
