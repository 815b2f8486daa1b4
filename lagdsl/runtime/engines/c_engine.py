"""The C engine: a program compiled, loaded and called through buffers that are made once."""

from __future__ import annotations

from collections.abc import Callable
from ctypes import byref, c_size_t
from math import prod
from pathlib import Path

import numpy as np
from numpy.typing import ArrayLike

from lagdsl.backends.python.sizes import motion_sizes
from lagdsl.backends.python.support.derivatives import variables
from lagdsl.backends.python.support.values import Call
from lagdsl.backends.python.support.vectorize import split
from lagdsl.graph.operation import ARGUMENT_NAMES, Group
from lagdsl.program.functions import BY_NAME, STATE
from lagdsl.program.program import Program
from lagdsl.runtime.engines.broadcast import Spread, spread
from lagdsl.runtime.engines.buffers import Buffers
from lagdsl.runtime.engines.cores import Part, cores, share_out
from lagdsl.runtime.engines.engine import EngineName, Floats, SingularSystem
from lagdsl.runtime.engines.named_values import NUMBER, part_of, result_shapes, value_of
from lagdsl.runtime.engines.native_model import NativeModel, load_compiled
from lagdsl.runtime.engines.one_state import VECTORS, OneState
from lagdsl.runtime.engines.one_value import Place, Scale, caller, laid_out
from lagdsl.runtime.engines.state_jacobian import StateJacobian
from lagdsl.runtime.library import runtime_library
from lagdsl.runtime.structures import Batch, Range, Strided

_SINGULAR = 1
_SOLVED = (Group.QDD, Group.LAMBDA)
# For so many states it is worth compiling the functions of several at once; results are the same to the bit.
_CROWD = 2048
# States of one call of C.
_LARGEST_PART = 4096


class CEngine:
    """Engine over compiled C. One object must not be used by several threads at once.

    Beside the functions of the protocol, those named `..._many` broadcast over leading axes, in one call of C.
    The functions of several states, or of several directions of derivatives, at once are compiled when first needed.
    `library` was compiled from the C files of the program; without one, that is done here.
    Raises CompilationFailed (E0911, E0912, E0913) where the model cannot be compiled.
    """

    name: EngineName = "c"

    def __init__(self, program: Program, library: Path | None = None) -> None:
        self.layout = program.layout
        self._program = program
        self._parts: dict[str, NativeModel] = {}
        self._runtime = runtime_library()
        self._shapes = result_shapes(program)
        self._free: list[list[Place]] = []
        self._width = {name: sum(map(prod, shapes)) for name, shapes in self._shapes.items()}
        self._use(self._provide() if library is None else opened(library, program))

    def _use(self, model: NativeModel) -> None:
        """Everything is computed by this model from now on."""
        self._model, self._one = model, OneState(model, self.layout)
        self._state_jacobian: StateJacobian | None = None
        for places in self._free:
            places.clear()

    @property
    def native(self) -> NativeModel:
        """The compiled model."""
        return self._model

    # ---- one state ---------------------------------------------------------------------------------------------------

    def solve(
        self, t: float, q: Floats, qd: Floats, z: Floats, u: Floats, w: Floats, p: Floats
    ) -> tuple[Floats, Floats]:
        """Accelerations qdd (nq,) and multipliers lam (nc,). Raises SingularSystem."""
        self._one.set(t, q, qd, z, u, w, p)
        self._one.prepare(p)
        status, qdd, lam = self._one.solve()
        if status == _SINGULAR:
            raise SingularSystem(self._one.coordinate.value, self.layout)
        return qdd, lam

    def evaluate(self, function: str, *arguments: Floats | float) -> tuple[Floats, ...]:
        """Result blocks of any function of the program."""
        parameters = None
        for group, argument in zip(BY_NAME[function].arguments, arguments, strict=True):
            if group is Group.TIME:
                self._one.arguments.t = argument
            else:
                self._one.view[group][...] = argument
                parameters = argument if group is Group.P else parameters
        self._one.prepare(np.asarray(parameters))
        return split(self._one.evaluate(NUMBER[function], self._width[function]), self._shapes[function])

    def jacobian(self, t: float, q: Floats, qd: Floats, z: Floats, u: Floats, w: Floats, p: Floats) -> Floats:
        """d(qd, qdd, zd)/d(q, qd, z), exact, shape (2 nq + nz, 2 nq + nz). Raises SingularSystem."""
        if self._state_jacobian is None:
            size = 2 * self.layout.size(Group.Q) + self.layout.size(Group.Z)
            self._state_jacobian = StateJacobian(self._part("tangents"), self._one.arguments, size)
        self._one.set(t, q, qd, z, u, w, p)
        self._one.forget()
        status, jacobian = self._state_jacobian(t, p)
        if status == _SINGULAR:
            raise SingularSystem(self._state_jacobian.coordinate.value, self.layout)
        return jacobian

    def at_one_state(self, name: str, otherwise: Call, scale: Scale | None = None) -> Call:
        """The value of this name (`named_values.py`) at one state, fast; `otherwise` takes other arguments. Several
        threads may call it. `scale` is applied to the result."""
        if "load" in self.layout.kinds:  # loads are found where all arguments are arrays
            return otherwise
        free = list[Place]()
        self._free.append(free)

        def make() -> Place:
            value = value_of(self._program, name)
            model = self._model if value.part is None else self._part(value.part)
            return laid_out(model, self.layout, value, self._patience)

        return caller(free, make, otherwise, self._heed, scale)

    # After so many calls of a value the engine wants to know of it; 0: never.
    _calls_until_attention = 0

    @property
    def _patience(self) -> int:
        """After so many calls of a value `_heed` is told of it; 0: never."""
        return 0

    def _heed(self, status: int, given: int, place: Place) -> bool:
        """A call of one value ended with a status that is not OK. Returns False where the memory belongs to a model
        that is no longer used. Raises SingularSystem."""
        if status == _SINGULAR:
            raise SingularSystem(place[-1].call.coordinate, self.layout)
        return True

    # ---- many states -------------------------------------------------------------------------------------------------

    def evaluate_many(self, function: str, *arguments: ArrayLike) -> tuple[Floats, ...]:
        """Result blocks, each of shape (leading axes of the arguments, own shape)."""
        many = self._spread(BY_NAME[function].arguments, arguments)
        width = self._width[function]
        results = np.empty((many.count, width))
        own = Buffers(self._model)
        batch = self._batch(many, own)
        self._runtime.batch_evaluate(self._model.model, NUMBER[function], byref(batch), results.ctypes.data, width)
        return split(results.reshape((*many.leading, width)), self._shapes[function])

    def solve_many(self, *state: ArrayLike) -> tuple[Floats, ...]:
        """qdd (..., nq) and lam (..., nc) at t, q, qd, z, u, w, p. Raises SingularSystem."""
        return self.solve_batch(1, *state)

    def solve_batch(self, threads: int, *state: ArrayLike) -> tuple[Floats, ...]:
        """`solve_many` with the states shared out to threads; they run while C works."""
        many = self._spread(STATE, state)
        model = self._part("states") if many.count >= _CROWD else self._model
        found = [(np.empty((*many.leading, size)), 8 * size) for size in map(self.layout.size, _SOLVED)]

        def solve(batch: Batch, first: int, coordinate: c_size_t) -> int:
            results = (block.ctypes.data + first * width for block, width in found)
            solve_batch = self._runtime.batch_forward_dynamics
            return int(solve_batch(model.model, model.part, byref(batch), *results, byref(coordinate)))

        share_out(many.count, threads, lambda: self._worker(model, many, solve), _LARGEST_PART)
        return tuple(block for block, _ in found)

    def jacobian_many(self, by: str, *state: ArrayLike) -> tuple[Floats, Floats]:
        """d(qd, qdd, zd)/dx (..., 2 nq + nz, nx) and dy/dx (..., ny, nx), exact. Raises SingularSystem.

        x are the "state" q, qd, z, the "input" u or the "parameter" p. Works on all cores.
        """
        many = self._spread(STATE, state)
        model = self._part(part_of(by))
        lengths = motion_sizes(self._program)
        first_variable, count = variables(lengths, by)
        x = Range(first_variable, count)
        heights = (2 * lengths.q + lengths.z, len(self.layout.outputs))
        found = [(np.empty((*many.leading, height, count)), 8 * height * count) for height in heights]

        def differentiate(batch: Batch, first: int, coordinate: c_size_t) -> int:
            results = (block.ctypes.data + first * width for block, width in found)
            jacobian = self._runtime.batch_jacobian
            return int(jacobian(model.model, model.part, byref(batch), x, *results, byref(coordinate)))

        share_out(many.count, cores(), lambda: self._worker(model, many, differentiate))
        return found[0][0], found[1][0]

    def _worker(self, model: NativeModel, many: Spread, call: Callable[[Batch, int, c_size_t], int]) -> Part:
        """Works on parts of `many` in memory of its own."""
        own, coordinate = Buffers(model), c_size_t(0)
        batch = self._batch(many, own)

        def part(first: int, end: int, _kept: object = own) -> None:
            batch.count = end - first
            for name, array, stride in many.arrays:
                getattr(batch, name).first = array.ctypes.data + 8 * first * stride
            if call(batch, first, coordinate) == _SINGULAR:
                raise SingularSystem(coordinate.value, self.layout)

        return part

    def _part(self, name: str) -> NativeModel:
        """The model with functions of several states or directions at once."""
        known = self._parts.get(name)
        if known is None:
            known = self._parts[name] = self._provide(name)
        return known

    def _provide(self, part: str | None = None) -> NativeModel:
        """The model, with the functions of several states or directions at once that are called `part`."""
        return _loaded(self._program, part)

    def _spread(self, groups: tuple[Group, ...], arguments: tuple[ArrayLike, ...]) -> Spread:
        return spread(
            [(ARGUMENT_NAMES[g], None if g is Group.TIME else self.layout.size(g)) for g in groups], arguments
        )

    def _batch(self, many: Spread, own: Buffers) -> Batch:
        """The C view of `many`, which must outlive it; arrays that are not given are those of the single state."""
        batch = Batch(count=many.count)
        for name in ("workspace", "memory", "lanes"):
            setattr(batch, name, getattr(own, name).ctypes.data)
        for group in VECTORS:
            name = ARGUMENT_NAMES[group]
            getattr(batch, name).first = getattr(self._one.arguments, name)
        for name, array, stride in many.arrays:
            setattr(batch, name, Strided(array.ctypes.data, stride))
        return batch


def opened(library: Path, program: Program) -> NativeModel:
    """The model in a library that was compiled from the C files of `program`. Raises OSError where it is damaged."""
    from lagdsl.backends.c.emit import model_symbol

    return load_compiled(library, model_symbol(program))


def _loaded(program: Program, part: str | None = None) -> NativeModel:
    from lagdsl.backends.c.emit import engine_sources, model_symbol, part_symbol
    from lagdsl.runtime.building.build import build

    texts = engine_sources(program, () if part is None else (part,))
    constant = None if part is None else part_symbol(program, part)
    try:
        return load_compiled(build(texts), model_symbol(program), constant)
    except OSError:  # a library that was cut short or made for another machine
        return load_compiled(build(texts, fresh=True), model_symbol(program), constant)
