"""Interface of a compiled model to the simulator: one interface, a NumPy and a C implementation."""

from __future__ import annotations

from typing import TYPE_CHECKING, Literal, Protocol, TypeAlias, get_args

import numpy as np
from numpy.typing import NDArray

from lagdsl.derivation.program.program import Layout, Program

if TYPE_CHECKING:
    from lagdsl.engines.runtime.engines.native_model import NativeModel

Floats = NDArray[np.float64]
EngineName: TypeAlias = Literal["auto", "tape", "c", "numpy"]
ENGINES: tuple[EngineName, ...] = get_args(EngineName)


class SingularSystem(ArithmeticError):  # noqa: N818  it is a state of the mechanism, not always a mistake
    """The accelerations are not determined at this state. `coordinate` is the index of a direction without inertia."""

    def __init__(self, coordinate: int, layout: Layout | None = None) -> None:
        name = f" (`{layout.coordinates[coordinate].name}`)" if layout else ""
        super().__init__(f"the acceleration of coordinate {coordinate}{name} is not determined")
        self.coordinate = coordinate


class Engine(Protocol):
    """Functions of one program at one state: `t` a float, arrays one-dimensional, SI units, in the order of the layout.

    Rank-deficient constraints are solved in minimum norm of lam. Raises SingularSystem where M is singular on the null
    space of J; values that are not finite are returned as they are, the caller says what they mean.
    """

    program: Program
    layout: Layout
    name: EngineName

    @property
    def native(self) -> NativeModel:
        """The model as the runtime in C takes it."""
        ...

    def along(self) -> NativeModel | None:
        """The model with the functions of several directions of derivatives at once, made when first asked for; None
        where there are none."""
        ...

    def along_parameters(self) -> NativeModel | None:
        """The same along parameters."""
        ...

    def differentiated(self) -> NativeModel | None:
        """The model with the derivatives of its motion at one state; None where it does not write them out."""
        ...

    def solve(
        self, t: float, q: Floats, qd: Floats, z: Floats, u: Floats, w: Floats, p: Floats
    ) -> tuple[Floats, Floats]:
        """Accelerations qdd (nq,) and multipliers lam (nc,)."""
        ...

    def evaluate(self, function: str, *arguments: Floats | float) -> tuple[Floats, ...]:
        """Any function of `lagdsl.derivation.program.functions` by name: its result blocks."""
        ...

    def jacobian(self, t: float, q: Floats, qd: Floats, z: Floats, u: Floats, w: Floats, p: Floats) -> Floats:
        """d(qd, qdd, zd)/d(q, qd, z), exact, shape (2 nq + nz, 2 nq + nz)."""
        ...
