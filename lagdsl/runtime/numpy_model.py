"""A lag_model whose functions are called back in Python: the runtime moves what an engine of Python computes.

Slow, since every evaluation crosses between two languages; it shows that what is emitted agrees.
"""

from __future__ import annotations

import ctypes
import re
from collections.abc import Callable, Mapping, Sequence
from ctypes import CFUNCTYPE, Structure, addressof, c_char_p, c_double, c_int, c_size_t, c_uint, c_void_p
from functools import cache

import numpy as np

from lagdsl.backends.c.source import kind_name, model_counts
from lagdsl.graph.operation import ARGUMENT_NAMES, Group
from lagdsl.program.functions import ALONG_MANY, OPTIONAL, SIGNATURES, WRITTEN_OUT
from lagdsl.program.program import Program, Slot
from lagdsl.program.verify import RESULT_SHAPES, sizes
from lagdsl.resources import c_folder
from lagdsl.runtime.engine import Engine
from lagdsl.runtime.native_model import NativeModel, native_model
from lagdsl.runtime.run_structures import Status
from lagdsl.runtime.structures import VERSION, Arguments, ModelHead

_COMMENT = re.compile(r"/\*.*?\*/", re.DOTALL)
_BODY = re.compile(r"typedef struct lag_model \{(.*?)\n\} lag_model;", re.DOTALL)
_FUNCTION = re.compile(r"lag_status \(\*(\w+)\)\(.*?\)$", re.DOTALL)
_SCALARS: dict[str, type] = {"unsigned": c_uint, "size_t": c_size_t}


class _Slot(Structure):
    """lag_slot."""

    _fields_ = [("name", c_char_p), ("unit", c_char_p), ("place", c_char_p)]


class Callbacks:
    """The model; `raised` is what a function raised that C called: C ends soon, and whoever called it raises it."""

    def __init__(
        self,
        engine: Engine,
        name: str,
        functions: Mapping[str, tuple[Group, ...]],
        counts: Mapping[str, int],
        kept_rows: Sequence[int] = (),
    ) -> None:
        """`functions` are the signatures of those that the engine has, `counts` the lengths of lag_model that the
        layout does not tell."""
        self._engine, self._layout = engine, engine.layout
        self._held: list[object] = []
        self.raised: list[BaseException] = []
        layout = engine.layout
        self._model = model = _model_type()(version=VERSION, size=ctypes.sizeof(_model_type()), name=name.encode())
        lengths = {**sizes(layout), "rank": len(layout.constraints) - sum(layout.redundant), **counts}
        for member, count in lengths.items():
            setattr(model, member, count)
        self._fill_tables(kept_rows)
        model.prepare = self._pointer(CFUNCTYPE(c_int, c_void_p)(lambda at: Status.OK))
        for function, signature in functions.items():
            kind = CFUNCTYPE(c_int, c_void_p, *(c_void_p for _ in RESULT_SHAPES[function]))
            setattr(model, function, self._pointer(kind(self._callback(function, signature))))

    def native(self) -> NativeModel:
        return native_model(ModelHead.from_address(addressof(self._model)), self, raised=self.raised)

    def _pointer(self, function: object) -> int | None:
        self._held.append(function)
        return ctypes.cast(function, c_void_p).value  # type: ignore[arg-type]

    def _callback(self, function: str, signature: tuple[Group, ...]) -> Callable[..., int]:
        evaluate, raised = self._engine.evaluate, self.raised
        given = [(ARGUMENT_NAMES[group], self._layout.size(group)) for group in signature if group is not Group.TIME]
        vectors = [(name, c_double * size if size else None) for name, size in given]
        nothing = np.zeros(0)

        def call(at: int, *results: int) -> int:
            if raised:
                return Status.NOT_FINITE
            try:
                state = Arguments.from_address(at)
                arguments = [
                    nothing if vector is None else np.ctypeslib.as_array(vector.from_address(getattr(state, name)))
                    for name, vector in vectors
                ]
                for to, block in zip(results, evaluate(function, state.t, *arguments), strict=True):
                    values = np.ascontiguousarray(block, dtype=np.float64)
                    ctypes.memmove(to, values.ctypes.data, values.nbytes)
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
        kinds = _kinds()
        numbers: dict[str, tuple[type, Sequence[float]]] = {
            "defaults": (np.float64, layout.defaults),
            "position_level": (np.uint8, layout.position_level),
            "redundant": (np.uint8, layout.redundant),
            "kinds": (np.uint8, [kinds.index(kind_name(layout, k)) for k in range(len(layout.kinds))]),
            "strict": (np.uint8, instants.strict),
            "contact_rows": (np.uintp, instants.contact_rows),
            "switched_rows": (np.uintp, instants.switched_rows),
            "reset_places": (np.uintp, instants.reset_places),
            "kept_rows": (np.uintp, kept_rows),
        }
        for name, (kind, values) in numbers.items():
            array: np.ndarray = np.array([*values, 0], dtype=kind)
            self._held.append(array)
            setattr(model, name, array.ctypes.data)

    def _slots(self, slots: Sequence[Slot]) -> int:
        table = (_Slot * (len(slots) + 1))(*(_Slot(slot.name.encode(), slot.unit.encode(), None) for slot in slots))
        self._held.append(table)
        return addressof(table)


def numpy_model(engine: Engine, program: Program) -> NativeModel:
    """The model of `program` with the functions of an engine that has all of them."""
    names = [f.name for f in program.functions if f.name not in ALONG_MANY]
    known = {**SIGNATURES, **OPTIONAL}
    functions = {name: known[name] for name in dict.fromkeys((*names, *WRITTEN_OUT))}
    return Callbacks(engine, program.name, functions, model_counts(program), program.kept_rows).native()


@cache
def _header() -> str:
    return _COMMENT.sub("", (c_folder() / "include" / "lag" / "model.h").read_text(encoding="utf-8"))


@cache
def _kinds() -> list[str]:
    """The names of lag_kind in their order."""
    return list(dict.fromkeys(re.findall(r"LAG_KIND_\w+", _header())))


@cache
def _model_type() -> type[Structure]:
    """lag_model as its header declares it: all pointers are addresses."""
    body = _BODY.search(_header())
    assert body is not None
    fields: list[tuple[str, type]] = []
    for member in body.group(1).split(";"):
        text = member.strip()
        function = _FUNCTION.match(text)
        if function is not None:
            fields.append((function.group(1), c_void_p))
        elif text:
            fields += _members(text)
    return type("Model", (Structure,), {"_fields_": fields})


def _members(text: str) -> list[tuple[str, type]]:
    """`size_t nq, nz`, `const double *defaults`."""
    first, *others = text.split(",")
    *words, name = first.replace("*", " * ").split()
    kind: type = _SCALARS.get(words[0], c_void_p)
    kind = c_char_p if text == "const char *name" else kind
    return [(each.strip().lstrip("*"), kind) for each in (name, *others)]
