"""One Python file with the functions of a model for JAX."""

from __future__ import annotations

from pathlib import Path

from lagdsl.derivation.program.program import Function, Program
from lagdsl.engines.backends.backend import Artifact
from lagdsl.engines.backends.identifier import identifier
from lagdsl.engines.backends.jax.instructions import count_of, instructions
from lagdsl.engines.backends.python.body import body
from lagdsl.engines.backends.python.standalone import lengths, module_over
from lagdsl.engines.backends.reserved import PYTHON_NAMES

_INTRODUCTION = '''"""Equations of motion of one model, generated. Needs JAX only; switches JAX to double precision.

The functions at the end of this file take t [s], q, qd and, by name, z (states), u (inputs), w (discretes) and p
(parameters) of one state; `jax.vmap` takes many, `jax.jit` compiles, `jax.grad` and `jax.jacobian` differentiate.
`evaluate(name, ...)` calls any row of FUNCTIONS. Long functions are lists of instructions that a loop executes: they
compile in seconds. Entries stand in the order of the tables of names, in the SI units told there.
Signs: M qdd - J'lam = f.
"""
'''
_IMPORTS = """from collections.abc import Callable, Iterator, Mapping, Sequence
from itertools import groupby
from math import inf
from typing import Any

import jax
import jax.numpy as jnp
"""
_PUBLIC = (
    "evaluate",
    "forward_dynamics",
    "multipliers",
    "rates",
    "output",
    "inverse_dynamics",
    "mass_matrix",
    "energy",
)


_SUPPORT = [Path(__file__).with_name(f"{name}.py") for name in ("elementary", "loop", "support")]
# Operations: the time of XLA for straight-line code grows with the square of their number.
_LONGEST_WRITTEN_OUT = 150


class JaxBackend:
    """Target `jax`."""

    name = "jax"

    def emit(self, program: Program) -> Artifact:
        return Artifact({f"{identifier(program.name, PYTHON_NAMES)}.py": module(program)})


def module(program: Program) -> str:
    """The text of the module."""
    arguments = f"FUNCTIONS, {lengths(program)!r}, DEFAULTS, {program.kept_rows!r}, REDUNDANT"
    last = [f"_functions = Functions({arguments})", *(f"{name} = _functions.{name}" for name in _PUBLIC)]
    return module_over(program, _SUPPORT, _INTRODUCTION, _IMPORTS, last, _definition)


def _definition(program: Program, function: Function) -> str:
    if count_of(program.graph, function) <= _LONGEST_WRITTEN_OUT:
        return body(program, function)
    return instructions(program, function)
