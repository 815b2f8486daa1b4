"""The functions that users call."""

from __future__ import annotations

from collections.abc import Mapping, Sequence

import numpy as np
from numpy.typing import ArrayLike

from lagdsl.engines.backends.python.support.derivatives import differentiate_motion
from lagdsl.engines.backends.python.support.kinematics import FrameKinematics, PointKinematics, frame_of, point_of
from lagdsl.engines.backends.python.support.motion import Sizes, solve_motion
from lagdsl.engines.backends.python.support.names import arrays_of
from lagdsl.engines.backends.python.support.values import (
    OUTPUT_JACOBIANS,
    Entries,
    Evaluate,
    Floats,
    Starts,
    Values,
    given_once,
)


class Interface(Values):
    """The mechanics of a model as functions of t [s], q (..., nq), qd (..., nq) and more, by name.

    These are the states z (..., nz), inputs u (..., nu), discretes w (..., nw) and parameters p (..., np); left out,
    they have the initial values and defaults of the model, or zeros. All arguments broadcast over their leading axes.
    Entries stand in the order of the tables of names, in the SI units told there. Or they are given by name, an array
    by its own: `u={"tau": [1.0, 2.0]}`; q and qd then need all coordinates. `inputs` and `parameters` are other names
    of u and p. Without q the state is that of the start, with the values `start` by name. `out` is an array of float64
    for the result, of its shape and in one piece, which is returned.

    Loads in w that depend on accelerations or multipliers are found, from those given. Raises ValueError for an array
    of a wrong length and for unknown or missing names, SingularSystem (an ArithmeticError) where the accelerations are
    not determined, LoadsNotFound (another one).
    """

    def forward_dynamics(
        self,
        t: ArrayLike | None = None,
        q: Entries | None = None,
        qd: Entries | None = None,
        z: Entries | None = None,
        u: Entries | None = None,
        w: Entries | None = None,
        p: Entries | None = None,
        *,
        start: Starts | None = None,
        inputs: Entries | None = None,
        parameters: Entries | None = None,
        out: Floats | None = None,
    ) -> Floats:
        """Accelerations qdd, shape (..., nq), without any stabilization of constraints."""
        if q is None or start is not None or inputs is not None or parameters is not None:
            t, q, qd, z, u, w, p = self._by_names((t, q, qd, z, u, w, p), start, inputs, parameters)
        return self._calls["forward_dynamics"](self, t, q, qd, z, u, w, p, None, out)

    def multipliers(
        self,
        t: ArrayLike | None = None,
        q: Entries | None = None,
        qd: Entries | None = None,
        z: Entries | None = None,
        u: Entries | None = None,
        w: Entries | None = None,
        p: Entries | None = None,
        *,
        start: Starts | None = None,
        inputs: Entries | None = None,
        parameters: Entries | None = None,
        out: Floats | None = None,
    ) -> Floats:
        """Multipliers lam of all declared rows in M qdd - J'lam = f, shape (..., nc), of least norm."""
        if q is None or start is not None or inputs is not None or parameters is not None:
            t, q, qd, z, u, w, p = self._by_names((t, q, qd, z, u, w, p), start, inputs, parameters)
        return self._calls["multipliers"](self, t, q, qd, z, u, w, p, None, out)

    def inverse_dynamics(
        self,
        t: ArrayLike | None = None,
        q: Entries | None = None,
        qd: Entries | None = None,
        qdd: ArrayLike | None = None,
        z: Entries | None = None,
        u: Entries | None = None,
        w: Entries | None = None,
        p: Entries | None = None,
        *,
        start: Starts | None = None,
        inputs: Entries | None = None,
        parameters: Entries | None = None,
        out: Floats | None = None,
    ) -> Floats:
        """M qdd - f, shape (..., nq): the generalized forces that are missing to produce qdd. Loads that depend on
        accelerations or multipliers are those in w."""
        if q is None or start is not None or inputs is not None or parameters is not None:
            t, q, qd, z, u, w, p = self._by_names((t, q, qd, z, u, w, p), start, inputs, parameters)
        return self._calls["inverse_dynamics"](self, t, q, qd, z, u, w, p, qdd, out)

    def mass_matrix(
        self,
        t: ArrayLike | None = None,
        q: Entries | None = None,
        qd: Entries | None = None,
        p: Entries | None = None,
        *,
        start: Starts | None = None,
        parameters: Entries | None = None,
        out: Floats | None = None,
    ) -> Floats:
        """M, shape (..., nq, nq); it depends on qd (default 0) only for Lagrangians not quadratic in the rates."""
        if q is None or start is not None or parameters is not None:
            t, q, qd, _, _, _, p = self._by_names((t, q, qd, None, None, None, p), start, None, parameters)
        return self._calls["mass_matrix"](self, t, q, qd, None, None, None, p, None, out)

    def coriolis_matrix(
        self,
        t: ArrayLike | None = None,
        q: Entries | None = None,
        qd: Entries | None = None,
        p: Entries | None = None,
        *,
        start: Starts | None = None,
        parameters: Entries | None = None,
        out: Floats | None = None,
    ) -> Floats:
        """C by Christoffel's symbols, shape (..., nq, nq): C qd are the Coriolis and centrifugal forces.

        dM/dt - 2 C is skew where M depends on q and p alone.
        """
        if q is None or start is not None or parameters is not None:
            t, q, qd, _, _, _, p = self._by_names((t, q, qd, None, None, None, p), start, None, parameters)
        return self._calls["coriolis_matrix"](self, t, q, qd, None, None, None, p, None, out)

    def gravity_forces(
        self,
        t: ArrayLike | None = None,
        q: Entries | None = None,
        p: Entries | None = None,
        *,
        start: Starts | None = None,
        parameters: Entries | None = None,
        out: Floats | None = None,
    ) -> Floats:
        """g = dV/dq, shape (..., nq), of weights and of all other potentials, such as springs."""
        if q is None or start is not None or parameters is not None:
            t, q, _, _, _, _, p = self._by_names((t, q, None, None, None, None, p), start, None, parameters)
        return self._calls["gravity_forces"](self, t, q, None, None, None, None, p, None, out)

    def bias_forces(
        self,
        t: ArrayLike | None = None,
        q: Entries | None = None,
        qd: Entries | None = None,
        z: Entries | None = None,
        u: Entries | None = None,
        w: Entries | None = None,
        p: Entries | None = None,
        *,
        start: Starts | None = None,
        inputs: Entries | None = None,
        parameters: Entries | None = None,
        out: Floats | None = None,
    ) -> Floats:
        """d/dt(dL/dqd) - dL/dq at qdd = 0, shape (..., nq): C qd + g, and what prescribed motion adds. Loads, damping
        and reactions are no part of it; `inverse_dynamics` at qdd = 0 is this less the loads."""
        if q is None or start is not None or inputs is not None or parameters is not None:
            t, q, qd, z, u, w, p = self._by_names((t, q, qd, z, u, w, p), start, inputs, parameters)
        return self._calls["bias_forces"](self, t, q, qd, z, u, w, p, None, out)

    def regressor(
        self,
        t: ArrayLike | None = None,
        q: Entries | None = None,
        qd: Entries | None = None,
        qdd: ArrayLike | None = None,
        z: Entries | None = None,
        u: Entries | None = None,
        w: Entries | None = None,
        p: Entries | None = None,
        *,
        start: Starts | None = None,
        inputs: Entries | None = None,
        parameters: Entries | None = None,
        out: Floats | None = None,
    ) -> Floats:
        """Y, shape (..., nq, n): with the n `inertial_parameters` pi, Y pi = M qdd + bias of masses and bodies, damping
        and dry friction. Friction has the sense of the slip here, whatever w says."""
        if q is None or start is not None or inputs is not None or parameters is not None:
            t, q, qd, z, u, w, p = self._by_names((t, q, qd, z, u, w, p), start, inputs, parameters)
        return self._calls["regressor"](self, t, q, qd, z, u, w, p, qdd, out)

    def inertial_parameters(self, p: Entries | None = None, *, parameters: Entries | None = None) -> Floats:
        """pi, shape (..., n): of each body mass, first moments and inertia about the origin of its frame, of each
        mass its mass; then coefficients of damping and limits of dry friction."""
        p = p if parameters is None else given_once("p", p, "parameters", parameters)
        zeros = np.zeros(self._sizes.q)
        return self._evaluate("regressor", *self._state(0.0, zeros, None, None, None, None, p), zeros)[1]

    def constraint_jacobian(
        self,
        t: ArrayLike | None = None,
        q: Entries | None = None,
        p: Entries | None = None,
        *,
        start: Starts | None = None,
        parameters: Entries | None = None,
        out: Floats | None = None,
    ) -> Floats:
        """J, shape (..., nc, nq), all declared rows in source order."""
        if q is None or start is not None or parameters is not None:
            t, q, _, _, _, _, p = self._by_names((t, q, None, None, None, None, p), start, None, parameters)
        return self._calls["constraint_jacobian"](self, t, q, None, None, None, None, p, None, out)

    def output(
        self,
        t: ArrayLike | None = None,
        q: Entries | None = None,
        qd: Entries | None = None,
        z: Entries | None = None,
        u: Entries | None = None,
        w: Entries | None = None,
        p: Entries | None = None,
        *,
        start: Starts | None = None,
        inputs: Entries | None = None,
        parameters: Entries | None = None,
        out: Floats | None = None,
    ) -> Floats:
        """Outputs y, shape (..., ny)."""
        if q is None or start is not None or inputs is not None or parameters is not None:
            t, q, qd, z, u, w, p = self._by_names((t, q, qd, z, u, w, p), start, inputs, parameters)
        return self._calls["output"](self, t, q, qd, z, u, w, p, None, out)

    def named_outputs(
        self,
        t: ArrayLike | None = None,
        q: Entries | None = None,
        qd: Entries | None = None,
        z: Entries | None = None,
        u: Entries | None = None,
        w: Entries | None = None,
        p: Entries | None = None,
        *,
        start: Starts | None = None,
        inputs: Entries | None = None,
        parameters: Entries | None = None,
    ) -> dict[str, Floats]:
        """Outputs by name: shape (...) of a scalar, (..., n) of an array of n elements."""
        values = self.output(t, q, qd, z, u, w, p, start=start, inputs=inputs, parameters=parameters)
        return arrays_of(self._names["y"], values)

    def energy(
        self,
        t: ArrayLike | None = None,
        q: Entries | None = None,
        qd: Entries | None = None,
        p: Entries | None = None,
        *,
        start: Starts | None = None,
        parameters: Entries | None = None,
        out: Floats | None = None,
    ) -> Floats:
        """T + V and, for each `lagrangian` term Lx, qd . dLx/dqd - Lx, in J, shape (...)."""
        if q is None or start is not None or parameters is not None:
            t, q, qd, _, _, _, p = self._by_names((t, q, qd, None, None, None, p), start, None, parameters)
        return self._calls["energy"](self, t, q, qd, None, None, None, p, None, out)

    def state_jacobian(
        self,
        t: ArrayLike | None = None,
        q: Entries | None = None,
        qd: Entries | None = None,
        z: Entries | None = None,
        u: Entries | None = None,
        w: Entries | None = None,
        p: Entries | None = None,
        *,
        start: Starts | None = None,
        inputs: Entries | None = None,
        parameters: Entries | None = None,
        out: Floats | None = None,
    ) -> Floats:
        """d(qd, qdd, zd)/d(q, qd, z), shape (..., 2 nq + nz, 2 nq + nz), exact."""
        if q is None or start is not None or inputs is not None or parameters is not None:
            t, q, qd, z, u, w, p = self._by_names((t, q, qd, z, u, w, p), start, inputs, parameters)
        return self._calls["state_jacobian"](self, t, q, qd, z, u, w, p, None, out)

    def input_jacobian(
        self,
        t: ArrayLike | None = None,
        q: Entries | None = None,
        qd: Entries | None = None,
        z: Entries | None = None,
        u: Entries | None = None,
        w: Entries | None = None,
        p: Entries | None = None,
        *,
        start: Starts | None = None,
        inputs: Entries | None = None,
        parameters: Entries | None = None,
        out: Floats | None = None,
    ) -> Floats:
        """d(qd, qdd, zd)/du, shape (..., 2 nq + nz, nu), exact."""
        if q is None or start is not None or inputs is not None or parameters is not None:
            t, q, qd, z, u, w, p = self._by_names((t, q, qd, z, u, w, p), start, inputs, parameters)
        return self._calls["input_jacobian"](self, t, q, qd, z, u, w, p, None, out)

    def parameter_jacobian(
        self,
        t: ArrayLike | None = None,
        q: Entries | None = None,
        qd: Entries | None = None,
        z: Entries | None = None,
        u: Entries | None = None,
        w: Entries | None = None,
        p: Entries | None = None,
        *,
        start: Starts | None = None,
        inputs: Entries | None = None,
        parameters: Entries | None = None,
        out: Floats | None = None,
    ) -> Floats:
        """d(qd, qdd, zd)/dp, shape (..., 2 nq + nz, np), exact; q, qd and z are held where they are."""
        if q is None or start is not None or inputs is not None or parameters is not None:
            t, q, qd, z, u, w, p = self._by_names((t, q, qd, z, u, w, p), start, inputs, parameters)
        return self._calls["parameter_jacobian"](self, t, q, qd, z, u, w, p, None, out)

    def output_jacobian(
        self,
        t: ArrayLike | None = None,
        q: Entries | None = None,
        qd: Entries | None = None,
        z: Entries | None = None,
        u: Entries | None = None,
        w: Entries | None = None,
        p: Entries | None = None,
        *,
        by: str = "state",
        start: Starts | None = None,
        inputs: Entries | None = None,
        parameters: Entries | None = None,
        out: Floats | None = None,
    ) -> Floats:
        """dy/dx, shape (..., ny, nx), exact, by the "state" q, qd, z, by the "input" u or by the "parameter" p.

        Raises ValueError for another word.
        """
        if q is None or start is not None or inputs is not None or parameters is not None:
            t, q, qd, z, u, w, p = self._by_names((t, q, qd, z, u, w, p), start, inputs, parameters)
        if by not in OUTPUT_JACOBIANS:
            raise ValueError(f"derivatives are by {', '.join(OUTPUT_JACOBIANS)}, not by {by!r}")
        return self._calls[OUTPUT_JACOBIANS[by]](self, t, q, qd, z, u, w, p, None, out)

    def frame(self, name: str) -> FrameKinematics:
        """The motion of a frame: `.position .rotation .velocity .jacobian .bias_acceleration` of t, q, qd.

        Raises KeyError.
        """
        return frame_of(self._kinematics, self._places[0], name)

    def point(self, name: str) -> PointKinematics:
        """The motion of a point: `.position .velocity .jacobian .bias_acceleration` of t, q, qd. Raises
        KeyError."""
        return point_of(self._kinematics, *self._places, name)


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
