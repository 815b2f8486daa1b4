"""The values that users ask for by name, as calls of C."""

from __future__ import annotations

from math import prod

from lagdsl.algebra.graph.operation import Group
from lagdsl.derivation.program.functions import BY_NAME, FUNCTIONS, WRITTEN_OUT
from lagdsl.derivation.program.lengths import sizes
from lagdsl.derivation.program.program import Program
from lagdsl.engines.backends.python.sizes import motion_sizes
from lagdsl.engines.backends.python.support.derivatives import variables
from lagdsl.engines.backends.python.support.values import DIFFERENTIATED, EVALUATED, SOLVED
from lagdsl.engines.runtime.engines.one_value import OUTPUT, OUTPUT_JACOBIAN, RATES_JACOBIAN, SOLVE, Value

NUMBER = {function.name: index for index, function in enumerate(FUNCTIONS)}
# Results of the function `kinematics` of one frame or point.
KINEMATICS = {
    name: place for place, name in enumerate(("position", "rotation", "velocity", "jacobian", "bias_acceleration"))
}


def result_shapes(program: Program) -> dict[str, tuple[tuple[int, ...], ...]]:
    """Of the functions of a program, and of those that it may lack since they can be formed."""
    lengths = sizes(program.layout)
    formed = {
        name: tuple(tuple(lengths[n] for n in each.shape) for each in BY_NAME[name].results) for name in WRITTEN_OUT
    }
    return formed | {f.name: tuple(block.shape for block in f.results) for f in program.functions}


def value_of(program: Program, name: str) -> Value:
    """The value of this name: one of every model or, of a program of one frame or point, of KINEMATICS."""
    layout = program.layout
    if name in EVALUATED:
        return _block(program, *EVALUATED[name])
    if name in KINEMATICS:
        value = _block(program, "kinematics", KINEMATICS[name])
        rotation = Value(value.what, value.count, value.first, (3, 3))
        return rotation if name == "rotation" else value
    n, m = layout.size(Group.Q), layout.size(Group.LAMBDA)
    if name in SOLVED:
        return Value(SOLVE, n + m, n * SOLVED[name], (m if SOLVED[name] else n,))
    if name == "output":
        return Value(OUTPUT, len(layout.outputs), 0, (len(layout.outputs),))
    by, place = DIFFERENTIATED[name]
    x = variables(motion_sizes(program), by)
    height = 2 * n + layout.size(Group.Z), len(layout.outputs)
    return Value(
        what=OUTPUT_JACOBIAN if place else RATES_JACOBIAN,
        count=sum(height) * x[1],
        first=height[0] * x[1] * place,
        shape=(height[place], x[1]),
        x=x,
        part=part_of(by),
    )


def whole(program: Program, function: str) -> Value:
    """All results of a function, one after the other."""
    count = sum(map(prod, result_shapes(program)[function]))
    return Value(NUMBER[function], count, 0, (count,))


def part_of(by: str) -> str:
    """The functions of several directions for derivatives by these variables."""
    return "parameter_tangents" if by == "parameter" else "tangents"


def _block(program: Program, function: str, place: int) -> Value:
    shapes = result_shapes(program)[function]
    lengths = [prod(shape) for shape in shapes]
    return Value(NUMBER[function], sum(lengths), sum(lengths[:place]), shapes[place])
