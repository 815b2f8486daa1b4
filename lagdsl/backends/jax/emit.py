"""One Python file with the functions of a model for JAX."""

from __future__ import annotations

from pathlib import Path

from lagdsl.backends.backend import Artifact
from lagdsl.backends.identifier import identifier
from lagdsl.backends.python.standalone import lengths, module_over
from lagdsl.backends.reserved import PYTHON_NAMES
from lagdsl.program.program import Program

_INTRODUCTION = '''"""Equations of motion of one model, generated. Needs JAX only; switches JAX to double precision.

The functions at the end of this file take t [s], q, qd and, by name, z (states), u (inputs), w (discretes) and p
(parameters) of one state; `jax.vmap` takes many, `jax.jit` compiles, `jax.grad` and `jax.jacobian` differentiate.
`evaluate(name, ...)` calls any row of FUNCTIONS. Entries stand in the order of the tables of names, in the SI units
told there. Signs: M qdd - J'lam = f.
"""
'''
_IMPORTS = """from collections.abc import Callable, Mapping, Sequence
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


class JaxBackend:
    """Target `jax`."""

    name = "jax"

    def emit(self, program: Program) -> Artifact:
        return Artifact({f"{identifier(program.name, PYTHON_NAMES)}.py": module(program)})


def module(program: Program) -> str:
    """The text of the module."""
    arguments = f"FUNCTIONS, {lengths(program)!r}, DEFAULTS, {program.kept_rows!r}, REDUNDANT"
    last = [f"_functions = Functions({arguments})", *(f"{name} = _functions.{name}" for name in _PUBLIC)]
    return module_over(program, Path(__file__).parent, _INTRODUCTION, _IMPORTS, last)
