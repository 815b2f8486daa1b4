"""Waiting times of a user: `lag check`, text to callable functions; and that the program does not swell."""

import os
import sys
from collections.abc import Callable
from pathlib import Path
from tempfile import TemporaryDirectory
from unittest.mock import patch

from growth import exponent
from measure import cpu_seconds, first_call_cpu_seconds, process_cpu_seconds

from lagdsl.derivation.mechanics.arrange import arrange
from lagdsl.derivation.mechanics.equations import form_equations
from lagdsl.derivation.program.program import Program
from lagdsl.foundation.diagnostics import Sink
from lagdsl.language.semantics.classes.library import read_source
from lagdsl.language.syntax.parser import parse
from lagdsl.motion.pipeline import flatten_unit

MODELS = Path(__file__).parents[1] / "models"
SIZES = (10, 20, 40, 80)


def measure(say: Callable[[str], None]) -> dict[str, object]:
    """CPU seconds."""
    say("start: lag check")
    numpy = process_cpu_seconds([sys.executable, "-c", "import numpy"])
    check = process_cpu_seconds([sys.executable, "-m", "lagdsl", "check", str(MODELS / "pendulum.lag")])
    say("start: lag run")
    base = process_cpu_seconds([sys.executable, "-c", "import numpy, click, rich"])
    run = _first_run(MODELS / "double_pendulum.lag")
    say("start: SymPy")
    ours = first_call_cpu_seconds("in_numpy", "cart_double_pendulum()")
    theirs = first_call_cpu_seconds("against_sympy", "cart_double_pendulum()")
    say("start: the hanging chain")
    points = [_chain(links) for links in SIZES]
    return {
        "numpy": numpy,
        "check": check,
        "base": base,
        "run": run,
        "ours": ours,
        "sympy": theirs,
        "chain": points,
        "nodes": exponent(points, "nodes"),
        "seconds": exponent(points, "seconds"),
    }


def _first_run(model: Path) -> float:
    """CPU seconds of `lag run` where nothing lies in the cache but bytecode."""
    command = [sys.executable, "-m", "lagdsl", "run", str(model)]
    with TemporaryDirectory() as cache, patch.dict(os.environ, {"XDG_CACHE_HOME": cache}):
        return process_cpu_seconds(command)  # so short a run compiles nothing into the folder


def _chain(links: int) -> dict[str, object]:
    """Nodes that the results of all functions need, and CPU time from text to program."""
    program = _program(links)
    roots = [element for function in program.functions for block in function.results for element in block.elements]
    return {
        "n": links,
        "nodes": len(program.graph.live(roots)),
        "seconds": cpu_seconds(lambda: _program(links), runs=3),
    }


def _program(links: int) -> Program:
    sink = Sink()
    source = read_source(MODELS / "chain.lag", sink)
    assert source is not None
    unit = parse(source, sink)
    assert unit is not None
    flat = flatten_unit(unit, sink, structural={"N": float(links)})
    sink.raise_if_errors()
    assert flat is not None
    return arrange(form_equations(flat))
