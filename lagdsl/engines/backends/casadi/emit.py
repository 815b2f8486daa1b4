"""One Python file that builds the functions of a model as functions of CasADi, operation by operation."""

from __future__ import annotations

from pathlib import Path

from lagdsl.derivation.program.program import Program
from lagdsl.engines.backends.backend import Artifact
from lagdsl.engines.backends.identifier import identifier
from lagdsl.engines.backends.python.standalone import lengths, module_over
from lagdsl.engines.backends.reserved import PYTHON_NAMES

_INTRODUCTION = '''"""Equations of motion of one model, generated. Needs CasADi only.

`functions[name]` is a casadi.Function of SX, for each row of FUNCTIONS and for `forward_dynamics` (qdd, lam), `rates`
(dq, dqd, dz) and `outputs` (y) of t, q, qd, z, u, w, p. Entries stand in the order of the tables of names, in the SI
units told there. Signs: M qdd - J'lam = f, J qdd = gamma.
"""
'''
_IMPORTS = """from collections.abc import Callable, Mapping, Sequence
from math import inf
from typing import Any

import casadi
from casadi import SX
"""


class CasadiBackend:
    """Target `casadi`."""

    name = "casadi"

    def emit(self, program: Program) -> Artifact:
        return Artifact({f"{identifier(program.name, PYTHON_NAMES)}.py": module(program)})


def module(program: Program) -> str:
    """The text of the module."""
    arguments = f"FUNCTIONS, {lengths(program)!r}, {program.kept_rows!r}, REDUNDANT"
    last = [f"functions = Functions({arguments})"]
    return module_over(program, [Path(__file__).with_name("support.py")], _INTRODUCTION, _IMPORTS, last)
