"""A lag_model whose functions are called back in Python: the runtime moves what an engine of Python computes.

Slow, since every evaluation crosses between two languages; it shows that what is emitted agrees.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from ctypes import addressof, c_char_p, c_double, c_void_p, cast, memmove, sizeof
from typing import Any

import numpy as np

from lagdsl.algebra.graph.operation import ARGUMENT_NAMES, Group
from lagdsl.derivation.program.functions import ALONG_MANY, OPTIONAL, SIGNATURES, WRITTEN_OUT
from lagdsl.derivation.program.lengths import counted, sizes
from lagdsl.derivation.program.program import Program, Slot
from lagdsl.engines.backends.tape.emit import kind_number
from lagdsl.engines.runtime.engines.engine import Engine, Floats
from lagdsl.engines.runtime.engines.native_model import NativeModel, native_model
from lagdsl.engines.runtime.structures import VERSION, Model, Status

_NOTHING = np.zeros(0)


class Callbacks:
    """`raised` is what a function raised that C called: C ends soon, and whoever called it raises it."""

    def __init__(
        self,
        engine: Engine,
        name: str,
        functions: Sequence[str],
        counts: Mapping[str, int],
        kept_rows: Sequence[int] = (),
    ) -> None:
        """`functions` are those that the engine has, `counts` the lengths of lag_model that the layout
        does not tell."""
        self._engine, self._layout = engine, engine.layout
        self._held: list[object] = []
        self.raised: list[BaseException] = []
        layout = engine.layout
        self._model = model = Model(version=VERSION, size=sizeof(Model), name=name.encode())
        lengths = {**sizes(layout), "rank": len(layout.constraints) - sum(layout.redundant), **counts}
        for member, count in lengths.items():
            setattr(model, member, count)
        self._fill_tables(kept_rows)
        kinds = {field[0]: field[1] for field in Model._fields_}
        for function, call in {"prepare": _prepared, **{name: self._callback(name) for name in functions}}.items():
            setattr(model, function, kinds[function](call))

    def native(self) -> NativeModel:
        return native_model(self._model, self, raised=self.raised)

    def _callback(self, function: str) -> Callable[..., int]:
        evaluate, raised = self._engine.evaluate, self.raised
        signature = {**SIGNATURES, **OPTIONAL}[function]
        lengths = [(ARGUMENT_NAMES[group], self._layout.size(group)) for group in signature if group is not Group.TIME]
        vectors = [(name, c_double * length if length else None) for name, length in lengths]

        def call(at: Any, *results: Any) -> int:
            if raised:
                return Status.NOT_FINITE
            try:
                state = at.contents
                arguments = [
                    _NOTHING if kind is None else np.ctypeslib.as_array(kind.from_address(getattr(state, name)))
                    for name, kind in vectors
                ]
                for to, block in zip(results, evaluate(function, state.t, *arguments), strict=True):
                    _copy(block, to)
            except BaseException as problem:
                raised.append(problem)
                return Status.NOT_FINITE
            return Status.OK

        return call

    def _fill_tables(self, kept_rows: Sequence[int]) -> None:
        layout, model = self._layout, self._model
        instants = layout.instants
        slots = ("coordinates", "states", "inputs", "discretes", "parameters", "constraints", "outputs", "invariants")
        for name in slots:
            setattr(model, name, self._slots(getattr(layout, name)))
        numbers: dict[str, tuple[type, Sequence[float]]] = {
            "defaults": (np.float64, layout.defaults),
            "position_level": (np.uint8, layout.position_level),
            "redundant": (np.uint8, layout.redundant),
            "kinds": (np.uint8, [kind_number(layout, index) for index in range(len(layout.kinds))]),
            "strict": (np.uint8, instants.strict),
            "jumping": (np.uint8, instants.jumping),
            "contact_rows": (np.uintp, instants.contact_rows),
            "friction_rows": (np.uintp, instants.friction_rows),
            "friction_slips": (np.uintp, instants.friction_slips),
            "friction_contacts": (np.uintp, instants.friction_contacts),
            "switched_rows": (np.uintp, instants.switched_rows),
            "reset_places": (np.uintp, instants.reset_places),
            "kept_rows": (np.uintp, kept_rows),
            **({"whole_inputs": (np.uint8, instants.whole_inputs)} if instants.whole_inputs else {}),
            **({"one_way": (np.uint8, instants.one_way)} if instants.one_way else {}),
            **({"components": (np.uintp, layout.components)} if layout.components else {}),
        }
        for name, (kind, values) in numbers.items():
            array: np.ndarray = np.array([*values, 0], dtype=kind)
            self._held.append(array)
            setattr(model, name, array.ctypes.data)

    def _slots(self, slots: Sequence[Slot]) -> int:
        """A table of lag_slot: name, unit, place."""
        entries = [text for slot in slots for text in (slot.name.encode(), slot.unit.encode(), None)]
        table = (c_char_p * (len(entries) + 1))(*entries)
        self._held.append(table)
        return addressof(table)


def numpy_model(engine: Engine, program: Program) -> NativeModel:
    """The model of `program` with the functions of an engine that has all of them."""
    names = [f.name for f in program.functions if f.name not in ALONG_MANY]
    lengths = {"nk": len(program.kept_rows), "nswitched": len(program.layout.instants.switched_rows)}
    counts = {**counted(program), **lengths}
    return Callbacks(
        engine, program.name, list(dict.fromkeys((*names, *WRITTEN_OUT))), counts, program.kept_rows
    ).native()


def _prepared(_at: Any) -> int:
    """There is nothing to prepare."""
    return Status.OK


def _copy(block: Floats, to: Any) -> None:
    """`to` may point nowhere where the block is empty."""
    values = np.ascontiguousarray(block, dtype=np.float64)
    if values.nbytes:
        memmove(cast(to, c_void_p), values.ctypes.data, values.nbytes)
