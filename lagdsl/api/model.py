"""The compiled model: what `lagdsl.compile` returns."""

from __future__ import annotations

from collections.abc import Sequence
from functools import cached_property
from typing import TYPE_CHECKING, TypedDict, Unpack

import numpy as np
from numpy.typing import ArrayLike, NDArray

from lagdsl.api.broadcast import Shape, over_leading_axes, vector
from lagdsl.diagnostics import Diagnostic

if TYPE_CHECKING:
    from lagdsl.pipeline import Compilation
    from lagdsl.program.program import Slot
    from lagdsl.runtime.engine import Engine
    from lagdsl.textbook.equations import EquationsOfMotion

Floats = NDArray[np.float64]


class Given(TypedDict, total=False):
    """Arguments that every function takes and that may be left out."""

    z: ArrayLike | None
    u: ArrayLike | None
    w: ArrayLike | None
    p: ArrayLike | None


class Model:
    """Equations of motion of one model, as functions of state and parameters, in SI units.

    Every function takes the time `t`, coordinates `q` and rates `qd` and, by keyword, first-order states `z`, inputs
    `u`, discretes `w` and parameters `p`; what is left out are the initial values, defaults and zeros of the model.
    Leading axes broadcast: `t` of shape (...), `q` of shape (..., nq). Names and order of the entries stand in
    `coordinates`, `states`, `inputs`, `parameters`, `outputs` and `constraints`.
    """

    def __init__(self, compilation: Compilation, engine: Engine) -> None:
        self._compilation = compilation
        self._engine = engine
        self._layout = compilation.program.layout

    def __repr__(self) -> str:
        return f"<Model {self.name}: {', '.join(self.coordinates + self.states)}>"

    # ---- names and defaults ------------------------------------------------------------------------------------------

    @property
    def name(self) -> str:
        return self._compilation.flat.name

    @property
    def diagnostics(self) -> tuple[Diagnostic, ...]:
        """Warnings and notes of the compilation."""
        return self._compilation.diagnostics

    @property
    def coordinates(self) -> list[str]:
        return _names(self._layout.coordinates)

    @property
    def states(self) -> list[str]:
        return _names(self._layout.states)

    @property
    def parameters(self) -> list[str]:
        """Independent parameters; those defined by others follow them."""
        return _names(self._layout.parameters)

    @property
    def inputs(self) -> list[str]:
        return _names(self._layout.inputs)

    @property
    def outputs(self) -> list[str]:
        return _names(self._layout.outputs)

    @property
    def constraints(self) -> list[str]:
        """Names of all declared constraint rows, in source order: `wire`, `pin[1]`."""
        return _names(self._layout.constraints)

    @property
    def redundant(self) -> list[bool]:
        """Which rows depend on others (their multipliers are those of minimum norm)."""
        return list(self._layout.redundant)

    @property
    def defaults(self) -> Floats:
        """Values of the independent parameters, shape (np,)."""
        return np.array(self._layout.defaults, dtype=np.float64)

    @cached_property
    def equations(self) -> EquationsOfMotion:
        """The equations of motion in symbols (SymPy), by the textbook's route."""
        from lagdsl.textbook.derive import derive

        return derive(self._compilation.flat)

    # ---- equations of motion -----------------------------------------------------------------------------------------

    def forward_dynamics(self, t: ArrayLike, q: ArrayLike, qd: ArrayLike, **given: Unpack[Given]) -> Floats:
        """Accelerations qdd, shape (..., nq), from M qdd - J' lam = f, J qdd = gamma; no stabilization terms."""

        def accelerations(*state: Floats) -> Floats:
            return self._solve(*state)[0]

        return over_leading_axes(accelerations, (self._nq,), t, *self._state(q, qd, **given))

    def multipliers(self, t: ArrayLike, q: ArrayLike, qd: ArrayLike, **given: Unpack[Given]) -> Floats:
        """Multipliers lam of all constraint rows, shape (..., nc); the constraint force is J' lam."""

        def multipliers(*state: Floats) -> Floats:
            return self._solve(*state)[1]

        return over_leading_axes(multipliers, (len(self.constraints),), t, *self._state(q, qd, **given))

    def inverse_dynamics(
        self, t: ArrayLike, q: ArrayLike, qd: ArrayLike, qdd: ArrayLike, **given: Unpack[Given]
    ) -> Floats:
        """Generalized forces M qdd - f missing to produce qdd, shape (..., nq)."""
        accelerations = vector("qdd", qdd, self.coordinates)
        return self._evaluate("inverse_dynamics", 0, (self._nq,), t, *self._state(q, qd, **given), accelerations)

    def mass_matrix(
        self, t: ArrayLike, q: ArrayLike, qd: ArrayLike | None = None, *, p: ArrayLike | None = None
    ) -> Floats:
        """M = d2L/dqd2, shape (..., nq, nq); `qd` matters only where L is not quadratic in the rates."""
        return self._evaluate("mass_matrix", 0, (self._nq, self._nq), t, *self._state(q, qd, p=p))

    def constraint_jacobian(self, t: ArrayLike, q: ArrayLike, *, p: ArrayLike | None = None) -> Floats:
        """J of all declared rows, redundant ones too, shape (..., nc, nq)."""
        shape = (len(self.constraints), self._nq)
        return self._evaluate("velocity_constraint", 1, shape, t, *self._state(q, None, p=p))

    def output(self, t: ArrayLike, q: ArrayLike, qd: ArrayLike, **given: Unpack[Given]) -> Floats:
        """Outputs y, shape (..., ny)."""

        def outputs(*state: Floats) -> Floats:
            return self._engine.evaluate("output", *state, *self._solve(*state))[0]

        return over_leading_axes(outputs, (len(self.outputs),), t, *self._state(q, qd, **given))

    def energy(self, t: ArrayLike, q: ArrayLike, qd: ArrayLike, *, p: ArrayLike | None = None) -> Floats:
        """`energy()` of the language [J]: T + V, and qd.dLx/dqd - Lx for each `lagrangian` term Lx; shape (...)."""
        return self._evaluate("energies", 0, (), t, *self._state(q, qd, p=p))

    def state_jacobian(self, t: ArrayLike, q: ArrayLike, qd: ArrayLike, **given: Unpack[Given]) -> Floats:
        """d(qd, qdd, zd)/d(q, qd, z), exact, shape (..., 2 nq + nz, 2 nq + nz)."""
        size = 2 * self._nq + len(self.states)
        return over_leading_axes(self._engine.jacobian, (size, size), t, *self._state(q, qd, **given))

    # ---- arguments ---------------------------------------------------------------------------------------------------

    @property
    def _nq(self) -> int:
        return len(self._layout.coordinates)

    def _solve(self, *state: Floats) -> tuple[Floats, Floats]:
        return self._engine.solve(*state)

    def _evaluate(self, function: str, block: int, shape: Shape, t: ArrayLike, *vectors: Floats) -> Floats:
        def result(*arguments: Floats) -> Floats:
            return self._engine.evaluate(function, *arguments)[block]

        return over_leading_axes(result, shape, t, *vectors)

    def _state(
        self,
        q: ArrayLike,
        qd: ArrayLike | None,
        *,
        z: ArrayLike | None = None,
        u: ArrayLike | None = None,
        w: ArrayLike | None = None,
        p: ArrayLike | None = None,
    ) -> tuple[Floats, ...]:
        """The arguments q qd z u w p of every function, with the model's own values for what is None."""
        parameters = self.defaults if p is None else vector("p", p, self.parameters)
        rates = np.zeros(self._nq) if qd is None else vector("qd", qd, self.coordinates)
        return (
            vector("q", q, self.coordinates),
            rates,
            self._starts[2] if z is None else vector("z", z, self.states),
            self._starts[3] if u is None else vector("u", u, self.inputs),
            np.zeros(len(self._layout.discretes)) if w is None else vector("w", w, _names(self._layout.discretes)),
            parameters,
        )

    @cached_property
    def _starts(self) -> tuple[Floats, ...]:
        """Start values q, qd, z and default inputs u of the model's own parameters."""
        return self._engine.evaluate("start", self._compilation.flat.experiment.start_time, self.defaults)


def _names(slots: Sequence[Slot]) -> list[str]:
    return [slot.name for slot in slots]
