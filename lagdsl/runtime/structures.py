"""The structures of the C runtime as ctypes sees them."""

from __future__ import annotations

from ctypes import CFUNCTYPE, POINTER, Structure, c_char_p, c_double, c_int, c_size_t, c_uint, c_void_p

from lagdsl.graph.operation import ARGUMENT_NAMES, Group

# Of lag/model.h.
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
