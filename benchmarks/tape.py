"""Tapes: one call against compiled C, an instruction against the least that a machine can do, lanes, and building."""

import ctypes
import json
import statistics
import sys
from collections.abc import Callable
from functools import partial
from pathlib import Path

import contest
import numpy as np
import ours
from measure import cpu_seconds, in_fresh_process

from lagdsl.algebra.graph.operation import ARGUMENT_NAMES, Group
from lagdsl.derivation.program.functions import STATE
from lagdsl.derivation.program.program import Program
from lagdsl.engines.backends.tape.emit import tape
from lagdsl.engines.backends.tape.listing import instructions
from lagdsl.engines.runtime.engines.buffers import Buffers, aligned
from lagdsl.engines.runtime.engines.c_engine import CEngine
from lagdsl.engines.runtime.engines.native_model import NativeModel
from lagdsl.engines.runtime.engines.tape_engine import TapeEngine
from lagdsl.engines.runtime.engines.tape_model import load_tape
from lagdsl.engines.runtime.library import runtime_library
from lagdsl.engines.runtime.structures import Arguments
from lagdsl.foundation.diagnostics import Sink
from lagdsl.motion.pipeline import compile_flat, flatten_file, read

MODELS = ("double_pendulum", "four_bar", "panda")
BUILT = (("panda", None), ("planar_chain", 100), ("spatial_chain", 100))
# Blocks of 0.1 ms, so that whoever interrupts spoils a few of them only.
BLOCK, ROUNDS, RUNS = 1e5, 400, 5
_LANES = 8
_LONGEST = 4096  # entries of a result, at most


def measure(say: Callable[[str], None]) -> dict[str, object]:
    """Calls of elimination() of MODELS, each in RUNS processes; and the CPU time of building tapes."""
    rows = []
    for name in MODELS:
        say(f"tape: {name}")
        runs = [_told(name) for _ in range(RUNS)]
        for run in runs:
            run["ratio"], run["lanes ratio"] = run["tape"] / run["c"], run["lanes"] / run["c"]
            run["of chain"] = run["tape"] / run["instructions"] / run["chain"]
        rows.append({"model": name, **{key: statistics.median(run[key] for run in runs) for key in runs[0]}})
    built = []
    for name, n in BUILT:
        say(f"tape: building {name} {n or ''}")
        program = ours.program(name, n)
        built.append(
            {"model": name, "n": n, "python": cpu_seconds(partial(tape, program)), "bytes": len(tape(program))}
        )
    return {"calls": rows, "built": built, "runs": RUNS}


def _told(name: str) -> dict[str, float]:
    found = in_fresh_process(f"import tape; tape.tell({name!r})")
    assert isinstance(found, dict)
    return found


def tell(name: str) -> None:
    """Least nanoseconds of a call on the tape, compiled, and on the tape in lanes for a state; of a multiplication and
    addition through memory; and the number of instructions."""
    program = _program(name)
    of_tape, compiled = TapeEngine(program).native, CEngine(program).native
    library = ctypes.CDLL(str(contest.built("tape")))
    arrays = [aligned(_LONGEST * _LANES) for _ in range(7)]
    results = (ctypes.c_void_p * 7)(*(array.ctypes.data for array in arrays))
    kept: list[object] = [arrays, of_tape, compiled]
    calls = {
        "tape": ("time_elimination", of_tape.model, _arguments(program, of_tape, 1, kept)),
        "c": ("time_elimination", compiled.model, _arguments(program, compiled, 1, kept)),
        "chain": ("time_chain", None, None),
    }
    lanes = load_tape(tape(program), "states")
    calls["lanes"] = ("time_lanes", lanes.part, _arguments(program, lanes, _LANES, kept))
    least = dict.fromkeys(calls, float("inf"))
    for _ in range(ROUNDS):
        for key, (function, model, arguments) in calls.items():
            timed = library[function]
            timed.restype = ctypes.c_double
            timed.argtypes = [ctypes.c_void_p] * 3 + [ctypes.c_int]
            count = 20 if least[key] == float("inf") else max(1, int(BLOCK / least[key]))
            at = None if arguments is None else ctypes.byref(arguments)
            least[key] = min(least[key], timed(model, at, results, count))
    print(json.dumps({**least, "instructions": sum(each.times for each in instructions(tape(program), "elimination"))}))


def _program(name: str) -> Program:
    own = ours.MODELS / f"{name}.lag"
    sink = Sink()
    source = read(own if own.exists() else Path(__file__).parents[1] / "models" / own.name, sink)
    flat = None if source is None else flatten_file(source, sink)
    compilation = None if flat is None else compile_flat(flat, sink)
    assert compilation is not None, sink.diagnostics
    return compilation.program


def _arguments(program: Program, model: NativeModel, lanes: int, kept: list[object]) -> Arguments:
    """A random state, the same in all lanes, after prepare(); all of it lives as long as `kept`."""
    draw, buffers = np.random.default_rng(1), Buffers(model)
    workspace = aligned(model.lanes + model.workspace)
    at = Arguments(t=0.3, workspace=workspace.ctypes.data, context=model.context)
    for group in STATE[1:]:
        size = program.layout.size(group)
        values = np.array(program.layout.defaults) if group is Group.P else draw.normal(size=size)
        array = aligned(size * lanes + 1)
        array[: size * lanes] = np.repeat(values, lanes)
        setattr(at, ARGUMENT_NAMES[group], array.ctypes.data)
        kept.append(array)
    times = np.full(lanes, 0.3)
    at.times = times.ctypes.data
    kept += [buffers, workspace, times]
    _prepare(model, at, lanes)
    return at


def _prepare(model: NativeModel, at: Arguments, lanes: int) -> None:
    """prepare() is the fourth member of lag_states, of one word each, and one of lag_model."""
    if lanes == 1:
        runtime_library().prepare(model.model, ctypes.byref(at))
        return
    address = ctypes.cast(model.part, ctypes.POINTER(ctypes.c_void_p))[3]
    ctypes.CFUNCTYPE(ctypes.c_int, ctypes.c_void_p)(address)(ctypes.addressof(at))


if __name__ == "__main__":
    print(json.dumps(measure(lambda what: print(what, file=sys.stderr)), indent=1))
