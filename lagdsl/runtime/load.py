"""The Python view of lag/model.h: a compiled model, loaded."""

from __future__ import annotations

import ctypes
from ctypes import CFUNCTYPE, POINTER, Structure, byref, c_char, c_char_p, c_double, c_int, c_size_t, c_uint, c_void_p
from dataclasses import dataclass
from pathlib import Path

from lagdsl.graph.operation import ARGUMENT_NAMES, Group

VERSION = 2

# Methods of the runtime that choose their steps.
METHODS = ("dop853", "radau")

# The vectors of lag_arguments, in its order.
VECTORS: tuple[Group, ...] = (
    Group.Q,
    Group.QD,
    Group.Z,
    Group.U,
    Group.W,
    Group.P,
    Group.QDD,
    Group.LAMBDA,
    Group.DIRECTION_Q,
    Group.DIRECTION_QD,
    Group.DIRECTION_Z,
    Group.DIRECTION_U,
    Group.DIRECTION_P,
    Group.DIRECTION_QDD,
    Group.DIRECTION_LAMBDA,
)
_NAMES = [ARGUMENT_NAMES[group] for group in VECTORS]


class Arguments(Structure):
    """lag_arguments."""

    _fields_ = [
        ("t", c_double),
        *((name, c_void_p) for name in _NAMES),
        ("workspace", c_void_p),
        ("times", c_void_p),
        ("context", c_void_p),
    ]


class Batch(Structure):
    """lag_batch."""

    _fields_ = [
        ("count", c_size_t),
        ("t", c_void_p),
        *((name, c_void_p) for name in _NAMES),
        ("t_stride", c_size_t),
        *((f"{name}_stride", c_size_t) for name in _NAMES),
        ("workspace", c_void_p),
        ("memory", c_void_p),
        ("lanes", c_void_p),
    ]


# lag_what, as results of a simulation call it; "before" and "after" are the states around an event.
WHAT = ("before", "tick", "true", "false", "opened", "closed", "impact", "reinit", "terminate", "after")

# What tells the inputs at a time: (context, t, u).
INPUTS = CFUNCTYPE(None, c_void_p, c_double, POINTER(c_double))


class Happening(Structure):
    """lag_happening."""

    _fields_ = [
        ("t", c_double),
        ("what", c_int),
        ("which", c_size_t),
        ("row", c_size_t),
        ("x", POINTER(c_double)),
        ("w", POINTER(c_double)),
    ]


# To whom it is told what happens: (context, run, happening), a lag_status.
TELL = CFUNCTYPE(c_int, c_void_p, c_void_p, POINTER(Happening))


class RunOptions(Structure):
    """lag_run_options."""

    _fields_ = [
        ("tolerance", c_double),
        ("method", c_void_p),
        ("h_first", c_double),
        ("h_most", c_double),
        ("part", c_double),
        ("p", c_void_p),
        ("context", c_void_p),
        ("inputs", INPUTS),
        *((name, c_void_p) for name in ("u", "group", "natural", "cap", "row_sizes")),
        ("careful", c_int),
        ("lasting", c_void_p),
        ("general", c_size_t),
        ("tell", TELL),
        ("length", c_double),
        ("count", c_size_t),
        *((name, c_void_p) for name in ("times", "rows", "output")),
        ("indicators", c_size_t),
        ("indicate", c_void_p),
        ("clocks", c_size_t),
        *((name, c_void_p) for name in ("first", "period", "event")),
        ("looks", c_uint),
        ("time_tolerance", c_double),
        *((f"invariant_{name}", c_void_p) for name in ("tolerance", "start", "size", "drift")),
        ("continued", c_int),
        ("start", c_void_p),
    ]


class RunChange(Structure):
    """lag_change."""

    _fields_ = [("t", c_double), ("implicit", c_int)]


class RunReport(Structure):
    """lag_run_report."""

    _fields_ = [
        *((name, c_double) for name in ("t", "h", "trouble_time")),
        ("x", POINTER(c_double)),
        *((name, c_size_t) for name in ("row", "steps", "all_steps", "rejections", "evaluations", "jacobians")),
        *((name, c_size_t) for name in ("decompositions", "projections", "events", "changes")),
        *((name, POINTER(c_double)) for name in ("w", "changed", "guilty", "slack")),
        ("fault", c_size_t),
        ("next", c_double),
        ("change", POINTER(RunChange)),
        ("implicit", c_int),
    ]


class ModelHead(Structure):
    """The first members of lag_model."""

    _fields_ = [
        ("version", c_uint),
        ("size", c_size_t),
        ("name", c_char_p),
        *((name, c_size_t) for name in ("nq", "nz", "nu", "nw", "np", "nc", "ny", "ni", "na", "ne", "rank")),
        ("workspace", c_size_t),
        ("prepared", c_size_t),
        ("context", c_void_p),
    ]


class Range(Structure):
    """lag_range."""

    _fields_ = [("first", c_size_t), ("count", c_size_t)]


@dataclass(frozen=True, slots=True)
class Library:
    """A loaded model: `model` points at its lag_model, `part` at its lag_states or lag_tangents, or is null; `context`
    is that of its functions.

    The others are functions compiled with it, and how many doubles they need.
    """

    model: object
    context: int | None
    part: object
    workspace: int
    memory: int
    lanes: int
    prepare: ctypes._NamedFuncPointer
    evaluate: ctypes._NamedFuncPointer
    forward_dynamics: ctypes._NamedFuncPointer
    jacobian: ctypes._NamedFuncPointer
    batch_evaluate: ctypes._NamedFuncPointer
    batch_forward_dynamics: ctypes._NamedFuncPointer
    batch_jacobian: ctypes._NamedFuncPointer
    run_size: ctypes._NamedFuncPointer
    run_place: ctypes._NamedFuncPointer
    run_move: ctypes._NamedFuncPointer
    run_to: ctypes._NamedFuncPointer
    run_tell: ctypes._NamedFuncPointer
    run_skip: ctypes._NamedFuncPointer
    run_enter: ctypes._NamedFuncPointer
    run_event: ctypes._NamedFuncPointer
    run_ticks: ctypes._NamedFuncPointer
    run_due: ctypes._NamedFuncPointer
    run_end: ctypes._NamedFuncPointer
    methods: dict[str, int]
    run_layout: tuple[int, int]


def load(path: Path, symbol: str, part: str | None = None) -> Library:
    """Load the shared library at `path`, which defines the model `symbol` and, with a part, its constant of that name.
    Raises OSError where it cannot be loaded."""
    library = ctypes.CDLL(str(path))
    head = ModelHead.in_dll(library, symbol)
    if head.version != VERSION:
        raise OSError(f"{path} was compiled for version {head.version} of lag/model.h, not {VERSION}")
    model, of_part = byref(head), None if part is None else byref(c_size_t.in_dll(library, part))
    of_states = part is not None and part.endswith("_states")
    tangents = None if of_states else of_part
    run_size = _function(library, "lag_run_size", [c_void_p, POINTER(RunOptions)])
    run_size.restype = c_size_t
    run_place = _function(library, "lag_run_place", [c_void_p, c_void_p, POINTER(RunOptions)])
    run_place.restype = c_void_p
    arguments, batch, results, index = POINTER(Arguments), POINTER(Batch), c_void_p, POINTER(c_size_t)
    return Library(
        model=model,
        context=head.context,
        part=of_part,
        workspace=_measured(library, "lag_jacobian_workspace", model, tangents),
        memory=_measured(library, "lag_jacobian_memory", model, tangents),
        lanes=_measured(library, "lag_batch_memory", model, of_part) if of_states else 0,
        prepare=_function(library, "lag_prepare", [c_void_p, arguments]),
        evaluate=_function(library, "lag_evaluate", [c_void_p, c_int, arguments, results]),
        forward_dynamics=_function(
            library, "lag_forward_dynamics", [c_void_p, arguments, c_void_p, results, results, index]
        ),
        jacobian=_function(
            library, "lag_jacobian", [c_void_p, c_void_p, arguments, Range, c_void_p, results, results, index]
        ),
        batch_evaluate=_function(library, "lag_batch_evaluate", [c_void_p, c_int, batch, results, c_size_t]),
        batch_forward_dynamics=_function(
            library, "lag_batch_forward_dynamics", [c_void_p, c_void_p, batch, results, results, index]
        ),
        batch_jacobian=_function(
            library, "lag_batch_jacobian", [c_void_p, c_void_p, batch, Range, results, results, index]
        ),
        run_size=run_size,
        run_place=run_place,
        run_move=_function(library, "lag_run_move", [c_void_p, c_double, results, c_double]),
        run_to=_function(library, "lag_run_to", [c_void_p, c_double, c_size_t]),
        run_tell=_function(library, "lag_run_tell", [c_void_p, POINTER(RunReport)]),
        run_skip=_function(library, "lag_run_skip", [c_void_p, c_size_t]),
        run_enter=_function(library, "lag_run_enter", [c_void_p]),
        run_event=_function(library, "lag_run_event", [c_void_p, c_double, c_void_p]),
        run_ticks=_function(library, "lag_run_ticks", [c_void_p]),
        run_due=_function(library, "lag_run_due", [c_void_p, c_double]),
        run_end=_function(library, "lag_run_end", [c_void_p]),
        methods={name: ctypes.addressof(c_char.in_dll(library, f"lag_{name}")) for name in METHODS},
        run_layout=tuple((c_size_t * 2).in_dll(library, "lag_run_layout")),
    )


def _measured(library: ctypes.CDLL, name: str, model: object, part: object) -> int:
    """Doubles that a function needs."""
    measure = _function(library, name, [c_void_p, c_void_p])
    measure.restype = c_size_t
    return int(measure(model, part))


def _function(library: ctypes.CDLL, name: str, arguments: list[type]) -> ctypes._NamedFuncPointer:
    function = library[name]
    function.argtypes = arguments
    function.restype = c_int
    return function
