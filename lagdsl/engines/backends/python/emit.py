"""One NumPy file that stands alone: names, support code, bodies of the functions, and the functions that users call."""

from __future__ import annotations

from pathlib import Path

from lagdsl.derivation.program.program import Function, Program
from lagdsl.engines.backends.backend import Artifact
from lagdsl.engines.backends.identifier import identifier
from lagdsl.engines.backends.python.body import body_name
from lagdsl.engines.backends.python.sizes import motion_sizes
from lagdsl.engines.backends.python.standalone import bodies, signature, single, support
from lagdsl.engines.backends.python.tables import tables
from lagdsl.engines.backends.reserved import PYTHON_NAMES

_SUPPORT = (
    "elementary",
    "columns",
    "vectorize",
    "linear",
    "delassus",
    "motion",
    "feedback",
    "derivatives",
    "kinematics",
    "names",
    "values",
    "interface",
)
_PUBLIC = (
    "forward_dynamics",
    "inverse_dynamics",
    "mass_matrix",
    "constraint_jacobian",
    "multipliers",
    "output",
    "named_outputs",
    "energy",
    "state_jacobian",
    "input_jacobian",
    "parameter_jacobian",
    "output_jacobian",
)
# Functions that a program may lack, with the functions of the module that call them.
_BY_NAME = {
    "equation_terms": ("coriolis_matrix", "gravity_forces", "bias_forces"),
    "regressor": ("regressor", "inertial_parameters"),
    "kinematics": ("frame", "point"),
}
_FOLDER = Path(__file__).parent / "support"
_DROPPED = ("Floats = ", "Flags = ", "Evaluate = ", "Kinematics = ", "Call = ", "Entries = ")
_NAMES = """# Names of the entries of arguments and of y
NAMES = {
    label: [name for name, _ in table]
    for labels, table in (
        (("q", "qd", "qdd"), COORDINATES),
        (("z",), STATES),
        (("u",), INPUTS),
        (("w",), DISCRETES),
        (("p",), PARAMETERS),
        (("y",), OUTPUTS),
    )
    for label in labels
}
"""

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
        "from __future__ import annotations\n",
        "import re\nfrom collections.abc import Callable, Mapping, Sequence\nfrom typing import Any\n",
        "import numpy as np\nfrom numpy import inf\nfrom numpy.typing import ArrayLike, NDArray\n",
        tables(program),
        _NAMES,
        "Floats = NDArray[np.float64]\nFlags = NDArray[np.bool_]\nEvaluate = Callable[..., tuple[Floats, ...]]\n"
        "Kinematics = Evaluate\nCall = Callable[..., Floats]\nEntries = ArrayLike | Mapping[str, Any]\n",
        *(support(_FOLDER / f"{name}.py", _DROPPED) for name in _SUPPORT),
        *bodies(program),
        _functions(program),
        f"evaluate = Functions(FUNCTIONS)\n_interface = interface_over(evaluate, {sizes_text(program)}, "
        "DEFAULTS, NAMES, FRAMES, POINTS, ALIASES)",
        *(f"{name} = _interface.{name}" for name in (*_PUBLIC, *_told(program))),
        "",
    ]
    return "\n".join(parts)


def _told(program: Program) -> list[str]:
    return [name for function, names in _BY_NAME.items() if program.has(function) for name in names]


def _functions(program: Program) -> str:
    rows = "".join(f"    {function.name!a}: {_row(program, function)},\n" for function in single(program))
    return (
        f"# body, (name, length) of every argument, shapes of the results\nFUNCTIONS: dict[str, Row] = {{\n{rows}}}\n"
    )


def _row(program: Program, function: Function) -> str:
    return f"({body_name(function.name)}, {signature(program, function)!r}, {shapes(function)!r})"


def shapes(function: Function) -> tuple[tuple[int, ...], ...]:
    return tuple(block.shape for block in function.results)


def sizes_text(program: Program) -> str:
    sizes = motion_sizes(program)
    return f"Sizes({', '.join(f'{name}={value}' for name, value in vars(sizes).items())})"
