"""The structures of lag/run.h and of what it reads, as ctypes sees them."""

from __future__ import annotations

from ctypes import CFUNCTYPE, POINTER, Structure, c_double, c_int, c_size_t, c_uint, c_void_p
from enum import IntEnum

# Methods of the runtime by the names of solvers: those that choose their steps, those that are given a length.
METHODS = {"dop853": "lag_dop853", "radau": "lag_radau"}
FIXED_METHODS = {"rk4": "lag_steps_rk4", "leapfrog": "lag_steps_leapfrog", "ros2": "lag_steps_ros2"}

# lag_what, as results of a simulation call it; "before" and "after" are rows.
WHAT = ("before", "tick", "true", "false", "opened", "closed", "impact", "reinit", "terminate", "after", "jump")


class Status(IntEnum):
    """lag_status."""

    OK = 0
    SINGULAR = 1
    NOT_FINITE = 2
    MISSING = 3
    STUCK = 4
    TOO_LONG = 5
    OFF = 6
    ATTENTION = 7
    VIOLATED = 8
    STOPPED = 9
    CHATTER = 10
    HAPPENS = 11
    UNSETTLED = 12
    CONFLICT = 13
    REFUSED = 14
    PIERCED = 15
    TORN = 16
    FORKED = 17
    FOREIGN = 18
    TIMELESS = 19


class InitialFault(IntEnum):
    """lag_initial_fault."""

    NONE = 0
    NUMBERS = 1
    POSITIONS = 2
    RATES = 3
    EQUATIONS = 4
    RANK = 5
    PARAMETERS = 6


# What tells the inputs at a time: (context, t, before, u).
INPUTS = CFUNCTYPE(None, c_void_p, c_double, c_int, POINTER(c_double))


class Note(Structure):
    """lag_note."""

    _fields_ = [("t", c_double), ("what", c_int), ("which", c_size_t)]


# Who empties the buffers of results: (context, results), a lag_status.
FULL = CFUNCTYPE(c_int, c_void_p, c_void_p)


class Extremes(Structure):
    """lag_extremes."""

    _fields_ = [
        ("size", c_size_t),
        ("count", c_size_t),
        *((name, c_void_p) for name in ("low", "high", "turns", "pivot", "way", "sample", "outputs")),
    ]


class Results(Structure):
    """lag_results."""

    _fields_ = [
        ("most_rows", c_size_t),
        ("most_notes", c_size_t),
        ("rows", c_void_p),
        ("notes", c_void_p),
        ("full", FULL),
        ("context", c_void_p),
        ("row", c_size_t),
        ("note", c_size_t),
        ("any", c_int),
        ("last", c_double),
        ("after", c_double),
        ("turning", c_void_p),
        ("extremes", c_void_p),
        ("angle", c_void_p),
    ]


_START = ("x", "fixed", "written", "nominal", "minimum", "maximum", "free", "parameter_nominal")


class Start(Structure):
    """lag_start."""

    _fields_ = [
        ("t", c_double),
        *((name, c_void_p) for name in _START),
    ]


class Initial(Structure):
    """lag_initial."""

    _fields_ = [
        ("fault", c_int),
        ("which", c_size_t),
        ("residual", c_double),
        ("rank", c_size_t),
        ("moved", c_int),
        *((name, c_size_t) for name in ("freedom", "excess", "general")),
        ("given", c_int),
        *((name, c_void_p) for name in ("dependent", "row_sizes", "pattern", "p")),
    ]


class RunOptions(Structure):
    """lag_run_options."""

    _fields_ = [
        ("tolerance", c_double),
        ("method", c_void_p),
        *((name, c_double) for name in ("h_first", "h_most", "h_fixed", "part")),
        ("p", c_void_p),
        ("context", c_void_p),
        ("inputs", INPUTS),
        *((name, c_void_p) for name in ("u", "group", "natural", "cap", "row_sizes")),
        ("careful", c_int),
        ("lasting", c_void_p),
        ("general", c_size_t),
        ("tell", c_void_p),
        ("length", c_double),
        ("count", c_size_t),
        *((name, c_void_p) for name in ("times", "rows", "output", "results")),
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


class Ensemble(Structure):
    """lag_ensemble."""

    _fields_ = [
        ("model", c_void_p),
        ("options", c_void_p),
        *((name, c_double) for name in ("t", "stop")),
        ("breaks", c_size_t),
        ("at", c_void_p),
        *((name, c_size_t) for name in ("first_piece", "piece", "most_steps")),
        ("equations", c_int),
        *((name, c_void_p) for name in ("set", "turning", "stopped")),
        *((name, c_void_p) for name in ("p", "u", "natural", "x")),
        *((name, c_void_p) for name in ("rows", "kept", "ended", "status")),
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


class RunFault(Structure):
    """lag_fault."""

    _fields_ = [
        ("t", c_double),
        ("x", POINTER(c_double)),
        ("which", c_size_t),
        ("value", c_double),
        ("limit", c_double),
    ]
