"""The C engine: a program compiled, loaded and called through buffers that are made once."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from ctypes import byref, c_size_t
from functools import cached_property
from math import prod
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import ArrayLike

from lagdsl.algebra.graph.operation import ARGUMENT_NAMES, Group
from lagdsl.derivation.program.functions import BY_NAME, STATE
from lagdsl.derivation.program.passes.motion_jacobian import motion_jacobian
from lagdsl.derivation.program.program import Program
from lagdsl.engines.backends.python.sizes import motion_sizes
from lagdsl.engines.backends.python.support.derivatives import variables
from lagdsl.engines.backends.python.support.values import WITH_ACCELERATIONS, Call, require_room
from lagdsl.engines.backends.python.support.vectorize import split
from lagdsl.engines.backends.tape.emit import Tapes
from lagdsl.engines.runtime.engines.benches import Bench, Benches
from lagdsl.engines.runtime.engines.broadcast import Crowd, Spread, apart, spread
from lagdsl.engines.runtime.engines.buffers import place_of
from lagdsl.engines.runtime.engines.cores import PART, share_out
from lagdsl.engines.runtime.engines.crowd import crowd
from lagdsl.engines.runtime.engines.engine import EngineName, Floats, SingularSystem
from lagdsl.engines.runtime.engines.memory import Memory
from lagdsl.engines.runtime.engines.named_values import NUMBER, part_of, result_shapes, value_of, whole
from lagdsl.engines.runtime.engines.native_model import NativeModel, load_compiled
from lagdsl.engines.runtime.engines.one_state import OneState
from lagdsl.engines.runtime.engines.one_value import Place, Reads, Scale, Value, caller, laid_out
from lagdsl.engines.runtime.engines.state_jacobian import StateJacobian
from lagdsl.engines.runtime.library import runtime_library
from lagdsl.engines.runtime.structures import Batch, Range

_SINGULAR = 1
_SOLVED = (Group.QDD, Group.LAMBDA)
# Arguments of a call of one value.
_ORDER = (*STATE, Group.QDD)
_SINGLE = frozenset(_ORDER)
# For so many states it is worth compiling the functions of several at once.
_CROWD = 256
# Functions of several states.
_STATES = "states"
# Seconds that writing and compiling C takes: always, and for each byte of a tape (GCC 12, a core of 2022; ten models of
# 4 to 400 kB take 0.7 to 1.3 times as much, one whose loops stay loops in C less than half).
_ALWAYS, _PER_BYTE = 0.1, 8e-6
# The part of the time that C saves.
_SAVED = 2 / 3
# States of one call of C.
_LARGEST_PART = 4096


class CEngine:
    """Engine over compiled C. `solve`, `evaluate` and `jacobian` are for one thread at a time, the others for several.

    Beside the functions of the protocol, those named `..._many` broadcast over leading axes, in one call of C; what
    `at_one_state` gives is fast at one state.
    The functions of several states, or of several directions of derivatives, at once are compiled when first needed.
    `library` was compiled from the C files of the program; without one, that is done here. `together`: for runs that go
    on together, whose model `native` has functions of several states as soon as these pay.
    Raises CompilationFailed (E0911, E0912, E0913) where the model cannot be compiled.
    """

    name: EngineName = "c"

    def __init__(self, program: Program, library: Path | None = None, *, together: bool = False) -> None:
        self.layout = program.layout
        self.program = program
        self._together = together and _goes_together(program)
        self._parts: dict[str, NativeModel] = {}
        self._runtime = runtime_library()
        self._shapes = result_shapes(program)
        self._memory = Memory()
        self._use(self._provide() if library is None else opened(library, program))

    def _use(self, model: NativeModel) -> None:
        """Everything is computed by this model from now on."""
        self._model, self._one = model, OneState(model, self.layout)
        self._state_jacobian: StateJacobian | None = None
        self._memory.clear()

    @property
    def native(self) -> NativeModel:
        """The compiled model."""
        return self._model

    def worked(self, seconds: float, left: float = 0.0) -> None:
        """So many seconds of work were done, and so many are known to come."""
        if self._together and self._model.part is None and pays(left, self._tapes.tape()):
            self._use(_loaded(self.program, _STATES))

    def along(self) -> NativeModel:
        """A tape: that takes less time than compiling."""
        return self._taped("tangents")

    def along_parameters(self) -> NativeModel:
        """A tape, too."""
        return self._taped("parameter_tangents")

    def differentiated(self) -> NativeModel | None:
        """Compiled, too: it is called at every stage of a step."""
        return self._part("jacobian") if motion_jacobian(self.program) is not None else None

    def _taped(self, part: str) -> NativeModel:
        known = self._parts.get(f"tape of {part}")
        if known is None:
            from lagdsl.engines.runtime.engines.tape_model import load_tape

            known = self._parts[f"tape of {part}"] = load_tape(self._tapes.tape(parts=(part,)), part)
        return known

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
        reads = Reads(qdd=name in WITH_ACCELERATIONS)
        return self._caller(lambda: value_of(self.program, name), otherwise, reads, scale)

    def _caller(
        self, told: Callable[[], Value], otherwise: Callable[..., Any], reads: Reads, scale: Scale | None = None
    ) -> Callable[..., Any]:
        free = self._memory.of_a_value()

        def make() -> Place:
            value = told()
            model = self._model if value.part is None else self._part(value.part)
            return laid_out(model, self.layout, value, self._patience)

        return caller(free, make, otherwise, self._heed, scale, reads)

    def _whole(self, function: str) -> Callable[[Sequence[ArrayLike]], Floats | None]:
        """All results of a function of one state, from its arguments; None for several states."""
        known = self._memory.wholes.get(function)
        if known is None:
            groups = BY_NAME[function].arguments
            places = [_ORDER.index(group) for group in groups]
            reads = Reads(q=Group.Q in groups, qdd=Group.QDD in groups, others=False)
            call = self._caller(lambda: whole(self.program, function), lambda *_: None, reads)

            def known(arguments: Sequence[ArrayLike]) -> Floats | None:
                given: list[Any] = [None] * len(_ORDER)
                for place, argument in zip(places, arguments, strict=True):
                    given[place] = argument
                if isinstance(given[0], np.ndarray) and given[0].ndim == 0:
                    given[0] = given[0].item()
                found: Floats | None = call(None, *given, None)
                return found

            self._memory.wholes[function] = known
        return known

    @property
    def _parts_of_native(self) -> tuple[str, ...]:
        """Functions that `native` has beside those of one state."""
        return (_STATES,) if self._together else ()

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
        groups, width = BY_NAME[function].arguments, self._width[function]
        found = self._whole(function)(arguments) if _SINGLE.issuperset(groups) else None
        if found is not None:
            return split(found, self._shapes[function])
        many = self._spread(groups, arguments)
        results = np.empty((many.count, width))
        start = results.ctypes.data

        def evaluate(batch: Batch, first: int, _coordinate: c_size_t) -> None:
            to = start + 8 * width * first
            self._runtime.batch_evaluate(self._model.model, NUMBER[function], byref(batch), to, width)

        self._share_out(self._model, many, 1, evaluate, many.count or 1)
        return split(results.reshape((*many.leading, width)), self._shapes[function])

    def solve_many(self, *state: ArrayLike) -> tuple[Floats, ...]:
        """qdd (..., nq) and lam (..., nc) at t, q, qd, z, u, w, p. Raises SingularSystem."""
        return self.solve_batch(1, *state)

    def solve_batch(self, threads: int | None, *state: ArrayLike, out: Floats | None = None) -> tuple[Floats, ...]:
        """`solve_many` with the states shared out to threads, None: as many as pay; they run while C works. `out` is an
        array for qdd."""
        many = self._spread(STATE, state)
        model = self._part(_STATES) if many.count >= self._crowd else self._model
        shapes = [(*many.leading, size) for size in self._solved_sizes]
        if out is not None:
            require_room(out, shapes[0])
            many = apart(many, out)
        found = (np.empty(shapes[0]) if out is None else out, np.empty(shapes[1]))
        (qdd, n), (lam, m) = ((place_of(block), 8 * block.shape[-1]) for block in found)
        forward_dynamics = self._runtime.batch_forward_dynamics

        def solve(batch: Batch, first: int, coordinate: c_size_t) -> None:
            results = (qdd + first * n, lam + first * m)
            self._checked(
                forward_dynamics(model.model, model.part, byref(batch), *results, byref(coordinate)), coordinate
            )

        self._share_out(model, many, threads, solve, _LARGEST_PART)
        return found

    def crowd(self) -> Crowd:
        """`solve_batch` of arrays, fast: qdd, None where it is not for these arguments (`crowd.py`)."""

        def place() -> tuple[NativeModel, Benches]:
            model = self._part(_STATES)
            return model, self._memory.of_many(model, self._one.arguments)

        return crowd(self.layout, self._crowd, _LARGEST_PART, place)

    def jacobian_many(self, by: str, *state: ArrayLike) -> tuple[Floats, Floats]:
        """d(qd, qdd, zd)/dx (..., 2 nq + nz, nx) and dy/dx (..., ny, nx), exact. Raises SingularSystem.

        x are the "state" q, qd, z, the "input" u or the "parameter" p. Works on as many cores as pay.
        """
        many = self._spread(STATE, state)
        model = self._part(part_of(by))
        lengths = motion_sizes(self.program)
        first_variable, count = variables(lengths, by)
        x = Range(first_variable, count)
        heights = (2 * lengths.q + lengths.z, len(self.layout.outputs))
        rates, outputs = (np.empty((*many.leading, height, count)) for height in heights)
        places = [
            (block.ctypes.data, 8 * height * count) for block, height in zip((rates, outputs), heights, strict=True)
        ]

        def differentiate(batch: Batch, first: int, coordinate: c_size_t) -> None:
            results = (place + first * width for place, width in places)
            jacobian = self._runtime.batch_jacobian
            self._checked(jacobian(model.model, model.part, byref(batch), x, *results, byref(coordinate)), coordinate)

        self._share_out(model, many, None, differentiate)
        return rates, outputs

    def _share_out(
        self,
        model: NativeModel,
        many: Spread,
        threads: int | None,
        call: Callable[[Batch, int, c_size_t], None],
        largest: int = PART,
    ) -> None:
        """`call` for all states, in parts."""
        benches = self._memory.of_many(model, self._one.arguments)
        used: list[Bench] = []
        share_out(many.count, threads, lambda: benches.worker(many, call, used), largest)
        benches.put_back(used, [name for name, array, _ in many.arrays if array.size])

    def _checked(self, status: int, coordinate: c_size_t) -> None:
        if status == _SINGULAR:
            raise SingularSystem(coordinate.value, self.layout)

    @property
    def _crowd(self) -> int:
        """For so many states functions of several at once pay; results are the same to the bit."""
        return _CROWD

    def _part(self, name: str) -> NativeModel:
        """The model with functions of several states or directions at once."""
        known = self._parts.get(name)
        if known is None:
            known = self._parts[name] = self._provide(name)
        return known

    def _provide(self, part: str | None = None) -> NativeModel:
        """The model, with the functions of several states or directions at once that are called `part`."""
        return _loaded(self.program, part)

    def _spread(self, groups: tuple[Group, ...], arguments: tuple[ArrayLike, ...]) -> Spread:
        sizes = ((ARGUMENT_NAMES[group], None if group is Group.TIME else self.layout.size(group)) for group in groups)
        return spread(tuple(sizes), arguments)

    @cached_property
    def _tapes(self) -> Tapes:
        return Tapes(self.program)

    @cached_property
    def _solved_sizes(self) -> tuple[int, ...]:
        """Numbers of accelerations and of multipliers."""
        return tuple(map(self.layout.size, _SOLVED))

    @cached_property
    def _width(self) -> dict[str, int]:
        """Numbers of all results of a function."""
        return {name: sum(map(prod, shapes)) for name, shapes in self._shapes.items()}


def opened(library: Path, program: Program, part: str | None = None) -> NativeModel:
    """The model in a library that was compiled from the C files of `program`, with its part. Raises OSError where it is
    damaged."""
    from lagdsl.engines.backends.c.emit import model_symbol, part_symbol

    return load_compiled(library, model_symbol(program), None if part is None else part_symbol(program, part))


def pays(seconds: float, tape: bytes) -> bool:
    """True if C saves more of so much work than compiling the program of this tape takes."""
    return _SAVED * seconds > _ALWAYS + _PER_BYTE * len(tape)


def _goes_together(program: Program) -> bool:
    """True if elimination is all of the equations: lag_motions_can()."""
    return program.has("elimination") and not program.kept_rows and "load" not in program.layout.kinds


def _loaded(program: Program, part: str | None = None) -> NativeModel:
    from lagdsl.engines.backends.c.emit import engine_sources, model_symbol, part_symbol
    from lagdsl.engines.runtime.building.build import build

    texts = engine_sources(program, () if part is None else (part,))
    constant = None if part is None else part_symbol(program, part)
    try:
        return load_compiled(build(texts), model_symbol(program), constant)
    except OSError:  # a library that was cut short or made for another machine
        return load_compiled(build(texts, fresh=True), model_symbol(program), constant)
