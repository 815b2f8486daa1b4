"""The C engine: a program compiled, loaded and called through buffers that are made once."""

from __future__ import annotations

from ctypes import byref, c_size_t
from math import prod

import numpy as np
from numpy.typing import ArrayLike

from lagdsl.backends.c.emit import model_symbol, sources
from lagdsl.backends.python.support.vectorize import split
from lagdsl.graph.operation import ARGUMENT_NAMES, Group
from lagdsl.program.functions import OPTIONAL, SIGNATURES, STATE, WRITTEN_OUT
from lagdsl.program.program import Program
from lagdsl.program.verify import RESULT_SHAPES, sizes
from lagdsl.runtime.broadcast import Spread, spread
from lagdsl.runtime.build import build
from lagdsl.runtime.cores import Part, share_out
from lagdsl.runtime.engine import Floats, SingularSystem
from lagdsl.runtime.load import VECTORS, Arguments, Batch, Library, load

_SINGULAR = 1
_STATE_VECTORS = STATE[1:]


class CEngine:
    """Engine over compiled C. One object must not be used by several threads at once.

    Beside the functions of the protocol, those named `..._many` broadcast over leading axes, in one call of C.
    With `lanes` it also holds the functions of several states, or directions, at once: it takes longer to compile and
    is faster then in `solve_many`, `solve_batch` and the Jacobians, with the same bits.
    Raises CompilationFailed (E0911, E0912, E0913) where the model cannot be compiled.
    """

    def __init__(self, program: Program, *, lanes: bool = False) -> None:
        self.layout = program.layout
        self._library = _loaded(program, lanes)
        self._shapes = {name: _formed_shapes(program, name) for name in WRITTEN_OUT}
        self._shapes |= {f.name: tuple(block.shape for block in f.results) for f in program.functions}
        self._width = {name: sum(map(prod, shapes)) for name, shapes in self._shapes.items()}
        self._number = {name: index for index, name in enumerate((*SIGNATURES, *OPTIONAL))}
        self._signature = {**SIGNATURES, **OPTIONAL}
        self._allocate()

    def _allocate(self) -> None:
        layout = self.layout
        sizes = [layout.size(group) for group in VECTORS]
        ends = np.cumsum([0, *sizes])
        # one number more than needed everywhere, so that every pointer points at something
        self._vectors = np.zeros(int(ends[-1]) + 1)
        self._view = {group: self._vectors[ends[i] : ends[i + 1]] for i, group in enumerate(VECTORS)}
        self._state = self._vectors[: ends[len(_STATE_VECTORS)]]
        self._workspace = np.zeros(self._library.workspace + 1)
        self._memory = np.zeros(self._library.memory + 1)
        self._lanes = np.zeros(self._library.batch_memory)
        self._results = np.zeros(max(*self._width.values(), 1))
        total = 2 * layout.size(Group.Q) + layout.size(Group.Z)
        self._qdd, self._lam = np.zeros(layout.size(Group.Q)), np.zeros(layout.size(Group.LAMBDA))
        self._jacobian = np.zeros((total, total))
        self._coordinate = c_size_t(0)
        self._arguments = Arguments(workspace=self._workspace.ctypes.data)
        for i, group in enumerate(VECTORS):
            setattr(self._arguments, ARGUMENT_NAMES[group], self._vectors.ctypes.data + 8 * int(ends[i]))
        self._prepared: bytes | None = None
        at, model, index = byref(self._arguments), self._library.model, byref(self._coordinate)
        self._prepare_call = (model, at)
        self._solve_call = (model, at, self._memory.ctypes.data, self._qdd.ctypes.data, self._lam.ctypes.data, index)
        self._jacobian_call = (model, at, self._memory.ctypes.data, self._jacobian.ctypes.data, index)
        self._evaluate_call = (at, self._results.ctypes.data)

    # ---- one state ---------------------------------------------------------------------------------------------------

    def solve(
        self, t: float, q: Floats, qd: Floats, z: Floats, u: Floats, w: Floats, p: Floats
    ) -> tuple[Floats, Floats]:
        """Accelerations qdd (nq,) and multipliers lam (nc,). Raises SingularSystem."""
        self._set_state(t, q, qd, z, u, w, p)
        self._check(self._library.forward_dynamics(*self._solve_call))
        return self._qdd.copy(), self._lam.copy()

    def evaluate(self, function: str, *arguments: Floats | float) -> tuple[Floats, ...]:
        """Result blocks of any function of the program."""
        parameters = None
        for group, argument in zip(self._signature[function], arguments, strict=True):
            if group is Group.TIME:
                self._arguments.t = argument
            else:
                self._view[group][...] = argument
                parameters = argument if group is Group.P else parameters
        self._prepare(np.asarray(parameters))
        self._library.evaluate(self._library.model, self._number[function], *self._evaluate_call)
        return split(self._results[: self._width[function]].copy(), self._shapes[function])

    def jacobian(self, t: float, q: Floats, qd: Floats, z: Floats, u: Floats, w: Floats, p: Floats) -> Floats:
        """d(qd, qdd, zd)/d(q, qd, z), exact, shape (2 nq + nz, 2 nq + nz). Raises SingularSystem."""
        self._set_state(t, q, qd, z, u, w, p)
        self._check(self._library.state_jacobian(*self._jacobian_call))
        return self._jacobian.copy()

    def _set_state(self, t: float, *vectors: Floats) -> None:
        self._arguments.t = t
        np.concatenate(vectors, out=self._state)
        self._prepare(vectors[-1])

    def _prepare(self, parameters: Floats) -> None:
        now = parameters.tobytes()
        if now != self._prepared:
            self._library.prepare(*self._prepare_call)
            self._prepared = now

    def _check(self, status: int) -> None:
        if status == _SINGULAR:
            raise SingularSystem(self._coordinate.value)

    # ---- many states -------------------------------------------------------------------------------------------------

    def evaluate_many(self, function: str, *arguments: ArrayLike) -> tuple[Floats, ...]:
        """Result blocks, each of shape (leading axes of the arguments, own shape)."""
        many = self._spread(self._signature[function], arguments)
        width = self._width[function]
        results = np.empty((many.count, width))
        batch = self._batch(many)
        self._library.batch_evaluate(
            self._library.model, self._number[function], byref(batch), results.ctypes.data, width
        )
        return split(results.reshape((*many.leading, width)), self._shapes[function])

    def solve_many(self, *state: ArrayLike) -> tuple[Floats, ...]:
        """qdd (..., nq) and lam (..., nc) at t, q, qd, z, u, w, p. Raises SingularSystem."""
        many = self._spread(STATE, state)
        qdd, lam = (np.empty((*many.leading, self.layout.size(group))) for group in (Group.QDD, Group.LAMBDA))
        batch = self._batch(many)
        status = self._library.batch_forward_dynamics(
            self._library.model, byref(batch), qdd.ctypes.data, lam.ctypes.data, byref(self._coordinate)
        )
        self._check(status)
        return qdd, lam

    def solve_batch(self, threads: int, *state: ArrayLike) -> tuple[Floats, ...]:
        """`solve_many` with the states shared out to threads; they run while C works."""
        many = self._spread(STATE, state)
        qdd, lam = (np.empty((*many.leading, self.layout.size(group))) for group in (Group.QDD, Group.LAMBDA))
        share_out(many.count, threads, lambda: self._worker(many, qdd, lam))
        return qdd, lam

    def _worker(self, many: Spread, qdd: Floats, lam: Floats) -> Part:
        """Solves parts of `many` in memory of its own."""
        own = [np.zeros_like(array) for array in (self._workspace, self._memory, self._lanes)]
        batch, coordinate = self._batch(many), c_size_t(0)
        batch.workspace, batch.memory, batch.lanes = (_address(array) for array in own)
        widths = (8 * self.layout.size(Group.QDD), 8 * self.layout.size(Group.LAMBDA))

        def part(first: int, end: int, _kept: object = own) -> None:
            batch.count = end - first
            for name, array, stride in many.arrays:
                setattr(batch, name, array.ctypes.data + 8 * first * stride)
            results = [block.ctypes.data + first * width for block, width in zip((qdd, lam), widths, strict=True)]
            status = self._library.batch_forward_dynamics(
                self._library.model, byref(batch), *results, byref(coordinate)
            )
            if status == _SINGULAR:
                raise SingularSystem(coordinate.value)

        return part

    def jacobian_many(self, *state: ArrayLike) -> Floats:
        """d(qd, qdd, zd)/d(q, qd, z), shape (..., 2 nq + nz, 2 nq + nz). Raises SingularSystem."""
        many = self._spread(STATE, state)
        result = np.empty(many.leading + self._jacobian.shape)
        batch = self._batch(many)
        status = self._library.batch_state_jacobian(
            self._library.model, byref(batch), result.ctypes.data, byref(self._coordinate)
        )
        self._check(status)
        return result

    def _spread(self, groups: tuple[Group, ...], arguments: tuple[ArrayLike, ...]) -> Spread:
        return spread(
            [(ARGUMENT_NAMES[g], None if g is Group.TIME else self.layout.size(g)) for g in groups], arguments
        )

    def _batch(self, many: Spread) -> Batch:
        """The C view of `many`, which must outlive it; arrays that are not given are those of the single state."""
        self._prepared = None  # the workspace is shared with the functions of one state
        batch = Batch(count=many.count, workspace=self._workspace.ctypes.data, memory=self._memory.ctypes.data)
        batch.lanes = _address(self._lanes)
        for group in VECTORS:
            name = ARGUMENT_NAMES[group]
            setattr(batch, name, getattr(self._arguments, name))
        for name, array, stride in many.arrays:
            setattr(batch, name, array.ctypes.data)
            setattr(batch, f"{name}_stride", stride)
        return batch


def _address(array: Floats) -> int | None:
    """For C, where an array that holds nothing is null."""
    return array.ctypes.data if array.size else None


def _formed_shapes(program: Program, function: str) -> tuple[tuple[int, ...], ...]:
    """Shapes of the results of a function that the program may lack."""
    lengths = sizes(program.layout)
    return tuple(tuple(lengths[length] for length in shape or ()) for shape in RESULT_SHAPES[function])


def _loaded(program: Program, lanes: bool) -> Library:
    texts = sources(program, lanes)
    try:
        return load(build(texts), model_symbol(program))
    except OSError:  # a library that was cut short or made for another machine
        return load(build(texts, fresh=True), model_symbol(program))
