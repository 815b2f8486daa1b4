"""One NumPy file that stands alone: names, support code, bodies of the functions, and the functions that users call."""

from __future__ import annotations

from pathlib import Path

from lagdsl.backends.backend import Artifact
from lagdsl.backends.identifier import identifier
from lagdsl.backends.python.body import body, body_name
from lagdsl.backends.python.sizes import motion_sizes
from lagdsl.backends.python.tables import tables
from lagdsl.backends.reserved import PYTHON_NAMES
from lagdsl.graph.operation import ARGUMENT_NAMES, Group
from lagdsl.program.functions import ALONG_MANY
from lagdsl.program.program import Function, Program

_SUPPORT = ("elementary", "columns", "vectorize", "linear", "delassus", "motion", "derivatives", "interface")
_PUBLIC = (
    "forward_dynamics",
    "inverse_dynamics",
    "mass_matrix",
    "constraint_jacobian",
    "multipliers",
    "output",
    "energy",
    "state_jacobian",
    "input_jacobian",
    "parameter_jacobian",
    "output_jacobian",
)
_DROPPED = ("import ", "from ", "Floats = ", "Flags = ", "Evaluate = ")

_INTRODUCTION = '''"""Equations of motion of one model, generated. Needs NumPy only.

The functions at the end of this file take t [s], q, qd and, by name, z (states), u (inputs), w (discretes) and
p (parameters), each with one entry per row of the table of that name below; all broadcast over leading axes. `help` on
any of them tells shapes. `evaluate(name, ...)` calls any row of FUNCTIONS. Signs: M qdd - J'lam = f, J qdd = gamma.
"""
'''


class PythonBackend:
    """Target `numpy`."""

    name = "numpy"

    def emit(self, program: Program) -> Artifact:
        return Artifact({f"{identifier(program.name, PYTHON_NAMES)}.py": module(program)})


def module(program: Program) -> str:
    """The text of the module."""
    parts = [
        _INTRODUCTION,
        "from collections.abc import Callable, Mapping, Sequence\n",
        "import numpy as np\nfrom numpy import inf\nfrom numpy.typing import ArrayLike, NDArray\n",
        tables(program),
        "Floats = NDArray[np.float64]\nFlags = NDArray[np.bool_]\nEvaluate = Callable[..., tuple[Floats, ...]]\n",
        *(_support(name) for name in _SUPPORT),
        *(body(program, function) for function in _single(program)),
        _functions(program),
        f"evaluate = Functions(FUNCTIONS)\n_interface = Interface.over(evaluate, {sizes_text(program)}, DEFAULTS)",
        *(f"{name} = _interface.{name}" for name in _PUBLIC),
        "",
    ]
    return "\n".join(parts)


def _single(program: Program) -> list[Function]:
    return [function for function in program.functions if function.name not in ALONG_MANY]


def _functions(program: Program) -> str:
    rows = "".join(f"    {function.name!a}: {_row(program, function)},\n" for function in _single(program))
    return (
        f"# body, (name, length) of every argument, shapes of the results\nFUNCTIONS: dict[str, Row] = {{\n{rows}}}\n"
    )


def _row(program: Program, function: Function) -> str:
    return f"({body_name(function.name)}, {signature(program, function)!r}, {shapes(function)!r})"


def signature(program: Program, function: Function) -> tuple[tuple[str, int | None], ...]:
    """Name and length of every argument; the time has no axis of its own."""
    return tuple(
        (ARGUMENT_NAMES[group], None if group is Group.TIME else program.layout.size(group))
        for group in function.arguments
    )


def shapes(function: Function) -> tuple[tuple[int, ...], ...]:
    return tuple(block.shape for block in function.results)


def sizes_text(program: Program) -> str:
    sizes = motion_sizes(program)
    return f"Sizes({', '.join(f'{name}={value}' for name, value in vars(sizes).items())})"


def _support(name: str) -> str:
    """A file of the support folder as part of the module, which imports once and holds the other parts itself."""
    text = (Path(__file__).parent / "support" / f"{name}.py").read_text(encoding="utf-8")
    _, docstring, code = text.split('"""', 2)
    kept = [line for line in code.splitlines() if not line.startswith(_DROPPED)]
    comment = "\n".join(f"# {line}".rstrip() for line in docstring.strip().splitlines())
    return f"# {'-' * 117}\n{comment}\n\n{_squeezed(kept)}"


def _squeezed(lines: list[str]) -> str:
    kept: list[str] = []
    for line in lines:
        if line or kept[-2:] != ["", ""]:
            kept.append(line)
    return "\n".join(kept).strip("\n") + "\n\n"
