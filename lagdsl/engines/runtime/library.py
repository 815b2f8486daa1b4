"""The C runtime, loaded: part of the installed package, and the same for all models."""

from __future__ import annotations

import ctypes
from ctypes import c_char, c_double, c_int, c_size_t, c_void_p
from functools import cache

from lagdsl.engines.runtime.building.platforms import library_name, this_machine
from lagdsl.engines.runtime.structures import Range
from lagdsl.foundation.resources import is_checkout, runtime_library_folder

# Methods of the runtime by the names of solvers: those that choose their steps, those that are given a length.
METHODS = {"dop853": "lag_dop853", "radau": "lag_radau"}
FIXED_METHODS = {"rk4": "lag_steps_rk4", "leapfrog": "lag_steps_leapfrog", "ros2": "lag_steps_ros2"}

_STATUS = c_int
_SIZE = c_size_t
_AT = c_void_p  # anything that is handed over by its address

# Result and arguments of the functions of the runtime, by their names in C without `lag_`; a test reads the headers and
# compares. The caller of a function that is missing here adds it.
PROTOTYPES: dict[str, tuple[type | None, tuple[type, ...]]] = {
    "prepare": (_STATUS, (_AT, _AT)),
    "evaluate": (_STATUS, (_AT, c_int, _AT, _AT)),
    "forward_dynamics": (_STATUS, (_AT, _AT, _AT, _AT, _AT, _AT)),
    "jacobian_workspace": (_SIZE, (_AT, _AT)),
    "jacobian_memory": (_SIZE, (_AT, _AT)),
    "jacobian": (_STATUS, (_AT, _AT, _AT, Range, _AT, _AT, _AT, _AT)),
    "batch_memory": (_SIZE, (_AT, _AT)),
    "batch_evaluate": (_STATUS, (_AT, c_int, _AT, _AT, _SIZE)),
    "batch_forward_dynamics": (_STATUS, (_AT, _AT, _AT, _AT, _AT, _AT)),
    "batch_jacobian": (_STATUS, (_AT, _AT, _AT, Range, _AT, _AT, _AT)),
    "call_once": (_STATUS, (_AT, c_int)),
    "motion_parameters": (_STATUS, (_AT, _AT)),
    "run_size": (_SIZE, (_AT, _AT)),
    "run_place": (_AT, (_AT, _AT, _AT)),
    "run_begin": (_STATUS, (_AT, c_double, _AT)),
    "run_move": (_STATUS, (_AT, c_double, _AT, c_double)),
    "run_to": (_STATUS, (_AT, c_double, _SIZE)),
    "run_over": (_STATUS, (_AT, _AT, _SIZE, _SIZE, _AT)),
    "run_tell": (None, (_AT, _AT)),
    "run_start": (_STATUS, (_AT, c_double, _AT)),
    "run_find": (_STATUS, (_AT, c_double, _AT, _AT, _AT)),
    "run_depend": (None, (_AT, _AT)),
    "run_enter": (_STATUS, (_AT,)),
    "run_jump": (_STATUS, (_AT,)),
    "run_change": (_STATUS, (_AT, _AT, _AT)),
    "run_end": (_STATUS, (_AT,)),
    "run_explain": (None, (_AT, c_int, _AT)),
    "run_evaluate": (_STATUS, (_AT, c_int, c_double, _AT, _AT)),
    "run_rank": (_SIZE, (_AT, _AT, _AT)),
    "sensitivities_width": (_SIZE, (_AT,)),
    "sensitivities_size": (_SIZE, (_AT, _SIZE)),
    "sensitivities_place": (_AT, (_AT, _AT, _AT, _AT, _AT)),
    "sensitivities_start": (_STATUS, (_AT, _AT, c_double, _AT, _AT)),
    "sensitivities_fault": (None, (_AT, _AT)),
    "sensitivities_row": (_STATUS, (_AT, _AT)),
    "sensitivities_inputs": (None, (_AT, _AT, _AT)),
    "sensitivities_saved_size": (_SIZE, (_AT, _AT)),
    "sensitivities_save": (None, (_AT, _AT, _AT)),
    "sensitivities_load": (None, (_AT, _AT, _AT)),
    "results_width": (_SIZE, (_AT,)),
    "extremes_memory": (_SIZE, (_AT,)),
    "extremes_place": (None, (_AT, _AT, _AT)),
    "run_saved_size": (_SIZE, (_AT, _AT)),
    "run_save": (None, (_AT, _AT)),
    "run_load": (_STATUS, (_AT, _AT)),
    "session_size": (_SIZE, (_AT, _AT)),
    "session_place": (_AT, (_AT, _AT, _AT, c_double, c_double)),
    "session_parameters": (_AT, (_AT,)),
    "session_inputs": (_AT, (_AT,)),
    "session_lasting": (_AT, (_AT,)),
    "session_begin": (_STATUS, (_AT, c_double)),
    "session_to": (_STATUS, (_AT, c_double, _SIZE)),
    "session_row": (_AT, (_AT,)),
    "session_events": (_AT, (_AT,)),
    "session_fault": (c_int, (_AT, c_int)),
    "session_guilty": (_AT, (_AT,)),
    "session_width": (_SIZE, (_AT,)),
    "session_sensitivities_size": (_SIZE, (_AT, _SIZE)),
    "session_differentiate": (None, (_AT, _AT, _SIZE, _AT)),
    "session_derivatives": (_AT, (_AT,)),
    "hold_tell": (None, (_AT, c_double, c_int, _AT)),
    "hold_jump": (_STATUS, (_AT,)),
    "hold_step": (_STATUS, (_AT, c_double, _SIZE)),
    "hold_to": (_STATUS, (_AT, c_double, _SIZE)),
    "hold_go": (_STATUS, (_AT, _SIZE)),
    "holds_step": (None, (_AT, _SIZE, c_double, _SIZE, _AT)),
    "holds_to": (None, (_AT, _SIZE, c_double, _SIZE, _AT)),
    "holds_go": (None, (_AT, _SIZE, _SIZE, _AT)),
    "holds_state": (None, (_AT, _SIZE, _AT)),
    "holds_row": (None, (_AT, _SIZE, _AT)),
    "signal_at": (c_double, (_AT, c_double, c_int)),
    "signals_tell": (None, (_AT, c_double, c_int, _AT)),
    "ensemble_size": (_SIZE, (_AT,)),
    "ensemble_width": (_SIZE, (_AT,)),
    "ensemble_run": (_SIZE, (_AT, _SIZE, _SIZE, _AT)),
    "tape_check": (_STATUS, (_AT, _SIZE, _AT)),
    "tape_model": (_AT, (_AT, _SIZE, _AT)),
    "tape_start": (_AT, (_AT,)),
    "tape_states": (_AT, (_AT,)),
    "tape_tangents": (_AT, (_AT, c_int)),
    "tape_jacobian": (_AT, (_AT,)),
}


class Runtime:
    """The functions of PROTOTYPES as attributes; `methods` are the addresses of METHODS and FIXED_METHODS by name."""

    methods: dict[str, int]

    def __init__(self, library: ctypes.CDLL) -> None:
        self._library = library
        known = {**METHODS, **FIXED_METHODS}
        self.methods = {name: ctypes.addressof(c_char.in_dll(library, symbol)) for name, symbol in known.items()}

    def __getattr__(self, name: str) -> ctypes._NamedFuncPointer:
        """Found once, kept as an attribute."""
        try:
            result, arguments = PROTOTYPES[name]
        except KeyError:
            raise AttributeError(f"the runtime has no function `lag_{name}` among PROTOTYPES") from None
        function = self._library[f"lag_{name}"]
        function.argtypes = arguments
        function.restype = result
        setattr(self, name, function)
        return function

    def bare(self, name: str) -> ctypes._NamedFuncPointer:
        """A function of PROTOTYPES that does not convert its arguments, which takes longer than the call itself: they
        have to be objects of ctypes, or ints."""
        function = self._library[f"lag_{name}"]
        function.restype = PROTOTYPES[name][0]
        return function


@cache
def runtime_library() -> Runtime:
    """The runtime of this package. A checkout builds it first where its sources changed; an installed package never.

    Raises CompilationFailed: E0914 where it cannot be loaded, E0911 or E0912 where a checkout cannot build it.
    """
    path = runtime_library_folder() / library_name(this_machine().partition("-")[0])
    if is_checkout():
        from lagdsl.engines.runtime.building.build_library import up_to_date

        up_to_date(path)
    try:
        return Runtime(ctypes.CDLL(str(path)))
    except OSError as problem:
        from lagdsl.engines.runtime.building.compiler import failure

        raise failure("E0914", reason=str(problem)) from None
