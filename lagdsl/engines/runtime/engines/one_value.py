"""One value of a model at one state, as fast as Python can ask for it (`lag/call.h`).

The memory of a call is laid out once and used again, by one thread at a time: whoever calls takes it out of the list
of what is free and puts it back. Arrays are copied through the buffer protocol, which refuses what is no array of
float64 of the right shape; whoever called then takes the way of all other arguments.
"""

from __future__ import annotations

from collections.abc import Callable
from ctypes import byref, c_void_p, cast
from math import nan, prod
from typing import TYPE_CHECKING, Any, TypeAlias

import numpy as np

from lagdsl.algebra.graph.operation import ARGUMENT_NAMES, Group
from lagdsl.derivation.program.functions import FUNCTIONS
from lagdsl.engines.backends.python.support.values import into
from lagdsl.engines.runtime.engines.buffers import aligned
from lagdsl.engines.runtime.engines.engine import Floats
from lagdsl.engines.runtime.library import runtime_library
from lagdsl.engines.runtime.structures import Call as Structure
from lagdsl.engines.runtime.structures import Range
from lagdsl.foundation.record import record

if TYPE_CHECKING:
    from lagdsl.derivation.program.program import Layout
    from lagdsl.engines.runtime.engines.native_model import NativeModel

# Values of lag/call.h that are no functions of the model by themselves.
_FIRST = sum(function.single for function in FUNCTIONS)
SOLVE, OUTPUT, RATES_JACOBIAN, OUTPUT_JACOBIAN = range(_FIRST, _FIRST + 4)
_QD, _Z, _U, _W, _P = 1, 2, 4, 8, 16
_OTHERS = _QD | _Z | _U | _W
_GIVEN = (Group.Q, Group.QD, Group.Z, Group.U, Group.W, Group.P, Group.QDD)
# Exceptions of buffers for arguments that are not of their kind.
UNFIT = (TypeError, ValueError, BufferError, NotImplementedError)


@record()
class Value:
    """`what` of lag/call.h, with variables `x` of derivatives; of its `count` numbers those from `first` on that fill
    `shape`. `part` has functions of several directions."""

    what: int
    count: int
    first: int
    shape: tuple[int, ...]
    x: tuple[int, int] = (0, 0)
    part: str | None = None


@record()
class Reads:
    """Arguments that a value reads: q and qdd, which cannot be left out then, and `others` but t and p, for which
    something stands where they are left out."""

    q: bool = True
    qdd: bool = False
    others: bool = True


@record()
class Rest:
    """Parts that a call seldom looks at: the structure, where z and w go; and what must live as long."""

    call: Structure
    z: memoryview
    w: memoryview
    held: object


# Memory of one call: its address, where t, q, qd, u, p and qdd go, the result, what copies it, the rest.
Place: TypeAlias = tuple[Any, ...]
# A function of NumPy and its second argument, applied to the result.
Scale: TypeAlias = tuple[np.ufunc, Floats]


def laid_out(model: NativeModel, layout: Layout, value: Value, calls: int) -> Place:
    """The memory of a call of `value`; after so many `calls`, unless 0, one tells ATTENTION."""
    given = {group: np.zeros(layout.size(group)) for group in _GIVEN}
    lengths = {name: layout.size(group) for group, name in ARGUMENT_NAMES.items() if group is not Group.TIME}
    n, m = lengths["q"], lengths["lam"]
    memory = {
        "zero": n,
        "start": 2 * n + lengths["z"] + lengths["u"],
        "standing": 2 * lengths["w"],
        "solved": n + m,
        "parameters": lengths["p"],
        "results": value.count,
        # That of the system, which is as large as M, only where the equations are solved.
        "memory": model.memory if value.what >= SOLVE or layout.size(Group.W) else 0,
    }
    # one number more than needed everywhere, so that every pointer points at something
    arrays = {name: aligned(size + 1) for name, size in memory.items()}
    spare = np.zeros(max(lengths.values()) + 1)
    call = Structure(what=value.what, x=Range(*value.x), started=nan, left=calls)
    call.model, call.tangents = model.address, _address(model.part)
    for name, array in arrays.items():
        setattr(call, name, array.ctypes.data)
    for name in lengths:
        setattr(call.at, name, spare.ctypes.data)
    for group, array in given.items():
        setattr(call.at, ARGUMENT_NAMES[group], array.ctypes.data)
    workspace = aligned(model.workspace + 1)
    call.at.workspace, call.at.context = workspace.ctypes.data, model.context
    time = memoryview(call).cast("B")[Structure.at.offset :][:8].cast("d")
    result = arrays["results"][value.first : value.first + prod(value.shape)].reshape(value.shape)
    first = (given[group].data for group in (Group.Q, Group.QD, Group.U, Group.P, Group.QDD))
    rest = Rest(call, given[Group.Z].data, given[Group.W].data, (workspace, arrays, spare, model))
    return (byref(call), time, *first, result, result.copy, rest)


def caller(
    free: list[Place],
    make: Callable[[], Place],
    otherwise: Callable[..., Any],
    heed: Callable[[int, int, Place], bool],
    scale: Scale | None,
    reads: Reads,
) -> Callable[..., Any]:
    """A function of its owner, t, q, qd, z, u, w, p, qdd and out; None stands for what is left out.

    Arguments that are not those of one state as floats and arrays go to `otherwise`; a status that is not OK goes to
    `heed`, which says whether the memory stays in use. Raises ValueError for an `out` that is not of the kind of the
    result. Everything that it uses is a local name: they are found fastest.
    """
    once, whole = runtime_library().bare("call_once"), slice(None)
    with_q, with_qdd, first = reads.q, reads.qdd, 0 if reads.others else _OTHERS

    def call(own: Any, t: Any, q: Any, qd: Any, z: Any, u: Any, w: Any, p: Any, qdd: Any, out: Any) -> Any:
        try:
            place = free.pop()
        except IndexError:
            place = make()
        at, own_t, own_q, own_qd, own_u, own_p, own_qdd, result, copy, rest = place
        try:
            own_t[0] = t if type(t) is float else _number(t)
            given = first
            if with_q:
                own_q[whole] = q
            if qd is not None:
                own_qd[whole] = qd
                given |= _QD
            if u is not None:
                own_u[whole] = u
                given |= _U
            if p is not None:
                own_p[whole] = p
                given |= _P
            if with_qdd:
                own_qdd[whole] = qdd
            if z is not None or w is not None:
                given |= _put(rest, z, w)
        except UNFIT:
            free.append(place)
            return otherwise(own, t, q, qd, z, u, w, p, qdd, out)
        status = once(at, given)
        keep = not status or heed(status, given, place)
        found = copy() if out is None else into(out, result)
        if keep:
            free.append(place)
        return found if scale is None else scale[0](found, scale[1], found)

    return call


def _number(t: Any) -> float:
    """Whole numbers, and those of NumPy, are the others that are times as they are."""
    if type(t) is not int and not isinstance(t, float):
        raise TypeError
    return t


def _put(rest: Rest, z: Any, w: Any) -> int:
    """States and discretes, which few models have; returns which of them are given."""
    if z is not None:
        rest.z[:] = z
    if w is not None:
        rest.w[:] = w
    return (0 if z is None else _Z) + (0 if w is None else _W)


def _address(part: Any) -> int | None:
    return None if part is None else cast(part, c_void_p).value
