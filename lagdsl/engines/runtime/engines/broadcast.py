"""Functions of one state applied over leading axes, and the functions users call over any engine."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from math import prod
from typing import Protocol, TypeAlias

import numpy as np
from numpy.typing import ArrayLike

from lagdsl.derivation.program.program import Program
from lagdsl.engines.backends.python.sizes import argument_names, motion_sizes
from lagdsl.engines.backends.python.support import linear
from lagdsl.engines.backends.python.support.derivatives import differentiate_motion
from lagdsl.engines.backends.python.support.interface import Interface
from lagdsl.engines.backends.python.support.motion import solve_motion
from lagdsl.engines.backends.python.support.names import real_numbers
from lagdsl.engines.backends.python.support.values import Call
from lagdsl.engines.runtime.engines.engine import Engine, Floats, SingularSystem
from lagdsl.engines.runtime.engines.one_value import Scale
from lagdsl.foundation.record import record

# A function of the number of threads, t, q, qd, (z, u, w, p) and out.
Crowd: TypeAlias = Callable[..., Floats | None]


class BatchEngine(Engine, Protocol):
    """An engine whose functions also broadcast over leading axes."""

    def evaluate_many(self, function: str, *arguments: ArrayLike) -> tuple[Floats, ...]:
        """Result blocks, each of shape (leading axes of the arguments, own shape)."""
        ...

    def solve_many(self, *state: ArrayLike) -> tuple[Floats, ...]:
        """qdd (..., nq) and lam (..., nc) at t, q, qd, z, u, w, p."""
        ...

    def solve_batch(self, threads: int | None, *state: ArrayLike, out: Floats | None = None) -> tuple[Floats, ...]:
        """The same as `solve_many`, by `threads` threads; None: by as many as pay. `out` is an array for qdd."""
        ...

    def crowd(self) -> Crowd:
        """`solve_batch` of arrays, fast: qdd, None where it is not for these arguments."""
        ...

    def jacobian_many(self, by: str, *state: ArrayLike) -> tuple[Floats, Floats]:
        """d(qd, qdd, zd)/dx, shape (..., 2 nq + nz, nx), and dy/dx, shape (..., ny, nx), by "state" (q, qd, z), "input"
        or "parameter"."""
        ...

    def at_one_state(self, name: str, otherwise: Call, scale: Scale | None = None) -> Call:
        """The value of this name at one state; `otherwise` takes arguments that are not those of one state."""
        ...


def interface(program: Program, engine: BatchEngine) -> Interface:
    """The functions users call, computed by `engine`."""
    return Interface(
        engine.evaluate_many,
        solving(program, engine),
        differentiating(program, engine),
        motion_sizes(program),
        program.layout.defaults,
        argument_names(program),
        aliases=dict(program.layout.aliases),
    )


def solving(program: Program, engine: BatchEngine) -> Callable[..., tuple[Floats, ...]]:
    """`solve_many` of the engine; with loads that depend on accelerations and multipliers a function of the same
    arguments that takes those in w, whatever the engine does with them."""
    sizes = motion_sizes(program)
    if not sizes.loads:
        return engine.solve_many

    def solve(*state: ArrayLike) -> tuple[Floats, ...]:
        try:
            return solve_motion(engine.evaluate_many, sizes, *map(np.asarray, state))
        except linear.SingularSystem as singular:
            raise SingularSystem(singular.coordinate, program.layout) from None

    return solve


def differentiating(program: Program, engine: BatchEngine) -> Callable[..., tuple[Floats, ...]]:
    """`jacobian_many` of the engine; with loads that depend on accelerations and multipliers a function of the same
    arguments in which these follow."""
    sizes = motion_sizes(program)
    if not sizes.loads:
        return engine.jacobian_many

    def differentiate(by: str, *state: ArrayLike) -> tuple[Floats, ...]:
        return differentiate_motion(engine.evaluate_many, sizes, by, *map(np.asarray, state))

    return differentiate


@record()
class Spread:
    """Arguments with common leading axes, `count` states in all.

    Each has its name, a contiguous array, and the numbers from one state to the next (0 where all states share it).
    """

    leading: tuple[int, ...]
    count: int
    arrays: tuple[tuple[str, Floats, int], ...]


def spread(signature: Sequence[tuple[str, int | None]], arguments: Sequence[ArrayLike]) -> Spread:
    """Raises ValueError for an argument of a wrong length or with leading axes that do not fit. Length None: no axis
    of its own (the time)."""
    given = []
    leading: tuple[int, ...] = ()
    for (name, length), argument in zip(signature, arguments, strict=True):
        array = real_numbers(name, argument)
        shape = array.shape
        if length is not None and (not shape or shape[-1] != length):
            raise ValueError(f"{name} must have {length} entries along its last axis, its shape is {shape}")
        axes = shape if length is None else shape[:-1]
        given.append((name, length, array, axes))
        if not axes or axes == leading:  # NumPy takes its time to find that out
            continue
        try:
            leading = np.broadcast_shapes(leading, axes) if leading else axes
        except ValueError:
            raise ValueError(f"leading axes {axes} of {name} do not fit {leading} of the arguments before") from None
    arrays = []
    for name, length, array, axes in given:
        shape = axes if not axes or axes == leading else leading if length is None else (*leading, length)
        fits = array if shape is axes else np.broadcast_to(array, shape)
        whole = fits if fits.flags.c_contiguous else np.ascontiguousarray(fits)
        arrays.append((name, whole, (1 if length is None else length) if axes else 0))
    return Spread(leading, prod(leading), tuple(arrays))


def apart(many: Spread, out: Floats) -> Spread:
    """`many` with copies of the arrays that lie where `out` does: it is written while they are read."""
    arrays = (
        (name, array.copy() if np.may_share_memory(array, out) else array, stride)
        for name, array, stride in many.arrays
    )
    return Spread(many.leading, many.count, tuple(arrays))
