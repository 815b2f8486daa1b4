"""The NumPy engine: the bodies of the generated module, compiled when first called, and its support code."""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from dataclasses import replace
from types import SimpleNamespace
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from lagdsl.algebra.graph.fold import SCALAR
from lagdsl.algebra.graph.operation import ARGUMENT_NAMES, Group, Op
from lagdsl.derivation.program.functions import STATE
from lagdsl.derivation.program.program import Program, vector_block
from lagdsl.engines.backends.python.body import ELEMENTARY, body, body_name
from lagdsl.engines.backends.python.emit import shapes
from lagdsl.engines.backends.python.sizes import motion_sizes
from lagdsl.engines.backends.python.standalone import signature
from lagdsl.engines.backends.python.support import linear
from lagdsl.engines.backends.python.support.columns import BY_COLUMNS, formed
from lagdsl.engines.backends.python.support.derivatives import differentiate_motion
from lagdsl.engines.backends.python.support.motion import solve_motion
from lagdsl.engines.backends.python.support.values import Call, into
from lagdsl.engines.backends.python.support.vectorize import apply, split
from lagdsl.engines.runtime.engines.broadcast import Crowd, Spread, spread
from lagdsl.engines.runtime.engines.cores import share_out
from lagdsl.engines.runtime.engines.engine import EngineName, Floats, SingularSystem
from lagdsl.engines.runtime.engines.native_model import NativeModel
from lagdsl.engines.runtime.engines.numpy_model import numpy_model
from lagdsl.engines.runtime.engines.one_value import Scale

# Functions on plain Python numbers; several times faster than NumPy is on single numbers. The last four treat values
# that are not numbers as NumPy and C do.
_ON_NUMBERS = SimpleNamespace(
    **{
        **{name: SCALAR[op] for op, name in ELEMENTARY.items() if op is not Op.SELECT},
        "select": lambda condition, value, otherwise: value if condition != 0.0 else otherwise,
        "sign": lambda x: float(x > 0.0) if x >= 0.0 else -1.0 if x < 0.0 else x,
        "minimum": lambda x, y: x if x <= y else y,
        "maximum": lambda x, y: x if x >= y else y,
    }
)


class NumpyEngine:
    """Engine that needs no compiler. The functions named `..._many` broadcast over leading axes."""

    name: EngineName = "numpy"

    def __init__(self, program: Program) -> None:
        self.layout = program.layout
        self.program = program
        self._sizes = motion_sizes(program)
        self._bodies: dict[str, Callable[..., Sequence[float]]] = {}
        self._varied: dict[str, tuple[NDArray[np.intp], Floats]] = {}
        self._functions = {f.name: f for f in program.functions}
        self._native: NativeModel | None = None
        self._signature = {f.name: signature(program, f) for f in program.functions}
        self._shapes = {f.name: shapes(f) for f in program.functions}

    @property
    def native(self) -> NativeModel:
        """The model with functions that are called back."""
        if self._native is None:
            self._native = numpy_model(self, self.program)
        return self._native

    def along(self) -> None:
        """There are none."""

    def along_parameters(self) -> None:
        """There are none."""

    def differentiated(self) -> None:
        """Nor are they."""

    def solve(
        self, t: float, q: Floats, qd: Floats, z: Floats, u: Floats, w: Floats, p: Floats
    ) -> tuple[Floats, Floats]:
        """Accelerations qdd (nq,) and multipliers lam (nc,). Raises SingularSystem."""
        try:
            return solve_motion(self.evaluate, self._sizes, np.asarray(t), q, qd, z, u, w, p)
        except linear.SingularSystem as singular:
            raise SingularSystem(singular.coordinate, self.layout) from None

    def evaluate(self, function: str, *arguments: Floats | float) -> tuple[Floats, ...]:
        """Result blocks of any function of the program."""
        if self._is_formed(function):
            return formed(self.evaluate_many, function, *map(np.asarray, arguments))
        try:
            values = self._body(function)(_ON_NUMBERS, *(_plain(argument) for argument in arguments))
        except (ArithmeticError, ValueError):  # not a finite number somewhere: NumPy goes on where Python stops
            return self.evaluate_many(function, *arguments)
        return self._whole(function, np.array(values, dtype=np.float64))

    def jacobian(self, t: float, q: Floats, qd: Floats, z: Floats, u: Floats, w: Floats, p: Floats) -> Floats:
        """d(qd, qdd, zd)/d(q, qd, z), exact, shape (2 nq + nz, 2 nq + nz). Raises SingularSystem."""
        return self.jacobian_many("state", t, q, qd, z, u, w, p)[0]

    def evaluate_many(self, function: str, *arguments: ArrayLike) -> tuple[Floats, ...]:
        """Result blocks, each of shape (leading axes of the arguments, own shape)."""
        if self._is_formed(function):
            return formed(self.evaluate_many, function, *map(np.asarray, arguments))
        body = self._body(function)
        count = len(self._varied[function][0])
        (values,) = apply(function, body, self._signature[function], ((count,),), arguments)
        return self._whole(function, values)

    def solve_many(self, *state: ArrayLike) -> tuple[Floats, ...]:
        """qdd (..., nq) and lam (..., nc) at t, q, qd, z, u, w, p. Raises SingularSystem."""
        try:
            return solve_motion(self.evaluate_many, self._sizes, *map(np.asarray, state))
        except linear.SingularSystem as singular:
            raise SingularSystem(singular.coordinate, self.layout) from None

    def crowd(self) -> Crowd:
        """There is no faster way than `solve_batch`."""
        return lambda *_: None

    def solve_batch(self, threads: int | None, *state: ArrayLike, out: Floats | None = None) -> tuple[Floats, ...]:
        """`solve_many` in parts, whose intermediate arrays stay in the caches, shared out to threads."""
        sizes = [(ARGUMENT_NAMES[g], None if g is Group.TIME else self.layout.size(g)) for g in STATE]
        many = spread(sizes, state)
        qdd, lam = (np.empty((many.count, self.layout.size(group))) for group in (Group.QDD, Group.LAMBDA))
        varied = [stride > 0 for _, _, stride in many.arrays]
        rows = [
            _rows(many, array, stride, length)
            for (_, length), (_, array, stride) in zip(sizes, many.arrays, strict=True)
        ]

        def part(first: int, end: int) -> None:
            of_part = (array[first:end] if each else array for array, each in zip(rows, varied, strict=True))
            qdd[first:end], lam[first:end] = self.solve_many(*of_part)

        share_out(many.count, threads, lambda: part)
        accelerations, multipliers = (block.reshape(*many.leading, block.shape[-1]) for block in (qdd, lam))
        return accelerations if out is None else into(out, accelerations), multipliers

    def jacobian_many(self, by: str, *state: ArrayLike) -> tuple[Floats, Floats]:
        """d(qd, qdd, zd)/dx (..., 2 nq + nz, nx) and dy/dx (..., ny, nx), exact. Raises SingularSystem."""
        try:
            return differentiate_motion(self.evaluate_many, self._sizes, by, *map(np.asarray, state))
        except linear.SingularSystem as singular:
            raise SingularSystem(singular.coordinate, self.layout) from None

    def at_one_state(self, name: str, otherwise: Call, scale: Scale | None = None) -> Call:
        """`otherwise`: there is no faster way."""
        return otherwise

    def _is_formed(self, function: str) -> bool:
        return function in BY_COLUMNS and function not in self._functions

    def _body(self, function: str) -> Callable[..., Sequence[float]]:
        """The compiled body: it returns the elements that are no constants. Its text is our own: names of the user
        stand in no body."""
        known = self._bodies.get(function)
        if known is None:
            graph, definition = self.program.graph, self._functions[function]
            elements = [node for block in definition.results for node in block.elements]
            varied = [index for index, node in enumerate(elements) if not graph.is_constant(node)]
            template = np.array([graph.value[node] if graph.is_constant(node) else 0.0 for node in elements])
            self._varied[function] = np.array(varied, dtype=np.intp), template
            kept = vector_block("varied", [elements[index] for index in varied])
            namespace: dict[str, Any] = {"inf": math.inf, "Any": Any}
            text = body(self.program, replace(definition, results=(kept,)))
            exec(compile(text, f"<generated {function}>", "exec"), namespace)
            known = self._bodies[function] = namespace[body_name(function)]
        return known

    def _whole(self, function: str, values: Floats) -> tuple[Floats, ...]:
        """The result blocks: `values` (..., varied elements) among the constant ones."""
        varied, template = self._varied[function]
        flat = np.empty((*values.shape[:-1], len(template)))
        flat[...] = template
        flat[..., varied] = values
        return split(flat, self._shapes[function])


def _rows(many: Spread, array: Floats, stride: int, length: int | None) -> Floats:
    """The argument with one axis for the states, or none where all share it."""
    own = () if length is None else (length,)
    return array.reshape(many.count, *own) if stride else array.reshape(-1)[: length or 1].reshape(own)


def _plain(argument: Floats | float) -> list[float] | float:
    return argument.tolist() if isinstance(argument, np.ndarray) else float(argument)
