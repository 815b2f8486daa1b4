"""The structures of the C runtime as ctypes sees them."""

from __future__ import annotations

import ctypes
from ctypes import CFUNCTYPE, POINTER, Structure, c_char_p, c_double, c_int, c_size_t, c_uint, c_void_p

from lagdsl.graph.operation import ARGUMENT_NAMES, Group
from lagdsl.program.functions import FUNCTIONS

# Of lag/model.h.
VERSION = 2

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


def function_type(results: int) -> type[ctypes._CFunctionType]:
    """The type of a function of lag_model that fills so many arrays of results."""
    return CFUNCTYPE(c_int, POINTER(Arguments), *[POINTER(c_double)] * results)


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


class Model(Structure):
    """lag_model. Its functions are those of `lagdsl.program.functions`, in that order; null is what a model lacks."""

    _fields_ = [
        ("version", c_uint),
        ("size", c_size_t),
        ("name", c_char_p),
        *((name, c_size_t) for name in ("nq", "nz", "nu", "nw", "np", "nc", "ny", "ni", "na", "ne", "rank")),
        ("workspace", c_size_t),
        ("prepared", c_size_t),
        ("context", c_void_p),
        *((name, c_void_p) for name in ("coordinates", "states", "inputs", "discretes", "parameters", "constraints")),
        *((name, c_void_p) for name in ("outputs", "invariants", "assertions", "defaults", "position_level")),
        ("redundant", c_void_p),
        ("prepare", CFUNCTYPE(c_int, POINTER(Arguments))),
        *((function.name, function_type(len(function.results))) for function in FUNCTIONS if function.single),
        ("jacobian_pattern", c_void_p),
        ("nk", c_size_t),
        ("kept_rows", c_void_p),
        *((name, c_size_t) for name in ("nindicator", "ncontact", "ngap", "nclock")),
        *((name, c_size_t) for name in ("nreset", "ncollision", "nstop", "nfail", "ntimed", "ndistance", "ncorner")),
        *((name, c_void_p) for name in ("kinds", "strict", "contact_rows")),
        ("nswitched", c_size_t),
        *((name, c_void_p) for name in ("switched_rows", "reset_places", "resets", "stops", "failures")),
        ("nd", c_size_t),
        ("definitions", c_void_p),
    ]


class Range(Structure):
    """lag_range."""

    _fields_ = [("first", c_size_t), ("count", c_size_t)]
