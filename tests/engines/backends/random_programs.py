"""Random expression graphs.

In the exact layer every operation is rounded correctly everywhere, so all must agree to the bit; in the smooth layer
they must agree to a few roundings of the size of the terms. Steps read exact values only.
"""

from __future__ import annotations

from dataclasses import replace

import numpy as np
from hypothesis import strategies as st
from sample_programs import pendulum

from lagdsl.algebra.graph import Graph, Group, Op
from lagdsl.derivation.program.program import Block, Program, Slot, vector_block, whole_block

EXACT = (
    Op.NEGATE, Op.ABS, Op.SIGN, Op.FLOOR, Op.CEIL, Op.NOT, Op.SQRT, Op.ADD, Op.SUBTRACT, Op.MULTIPLY, Op.DIVIDE, Op.MOD,
    Op.MIN, Op.MAX, Op.LESS, Op.LESS_EQUAL, Op.EQUAL, Op.AND, Op.OR, Op.SELECT,
)  # fmt: skip
SMOOTH = (
    Op.SIN, Op.COS, Op.TAN, Op.ASIN, Op.ACOS, Op.ATAN, Op.SINH, Op.COSH, Op.TANH, Op.EXP, Op.LOG, Op.SQRT, Op.ADD,
    Op.SUBTRACT, Op.MULTIPLY, Op.POWER, Op.ATAN2,
)  # fmt: skip
CONSTANTS = (0.0, 1.0, -1.0, 0.5, -2.0, 3.0, 1e-3, 1e300, 5e-324, float("inf"))
SYMBOLS = 6

Step = tuple[int, int, int, int]
steps = st.lists(st.tuples(*[st.integers(0, 10_000)] * 4), min_size=1, max_size=40)
values = st.lists(
    st.one_of(
        st.sampled_from([0.0, -0.0, 1.0, -1.0, 2.0, 0.5, -0.5, 3.0, 1e-9, 1e8]),
        st.floats(-4.0, 4.0, allow_subnormal=False),
    ),
    min_size=SYMBOLS,
    max_size=SYMBOLS,
)


def grow(graph: Graph, exact_steps: list[Step], smooth_steps: list[Step]) -> tuple[list[int], list[int]]:
    """Nodes of the exact and of the smooth layer."""
    exact = [*graph.symbols(Group.Q, SYMBOLS), graph.symbol(Group.TIME), *(graph.constant(x) for x in CONSTANTS)]
    for step in exact_steps:
        exact.append(_node(graph, EXACT, step, exact))
    smooth = [x for x in exact[:SYMBOLS] + exact[-10:] if not graph.is_constant(x)]
    start = len(smooth)
    for step in smooth_steps:
        smooth.append(_node(graph, SMOOTH, step, smooth))
    return exact, smooth[start:]


def _node(graph: Graph, operations: tuple[Op, ...], step: Step, pool: list[int]) -> int:
    op = operations[step[0] % len(operations)]
    a, b, c = (pool[-1 - x % len(pool)] for x in step[1:])
    if op is Op.SELECT:
        return graph.select(a, b, c)
    return graph.unary(op, a) if op < Op.ADD else graph.binary(op, a, b)


def as_outputs(graph: Graph, roots: list[int], name: str = "Random") -> Program:
    """A program whose `output` are `roots`; its other functions are those of a sample without any content."""
    base = pendulum()
    slots = tuple(Slot(name=f"q{i}") for i in range(SYMBOLS))
    none: tuple[Slot, ...] = ()
    layout = replace(
        base.layout,
        coordinates=slots, states=none, inputs=none, parameters=none, defaults=(),
        outputs=tuple(Slot(name=f"y{i}") for i in range(len(roots))),
        invariants=none, assertions=(),
    )  # fmt: skip
    n, zero = SYMBOLS, graph.zero

    def block(*shape: int) -> Block:
        return whole_block("r", shape, (zero,) * int(np.prod(shape, dtype=int)))

    shapes = {
        "start": [(n,), (n,), (0,), (0,)], "position_constraint": [(0,), (0, n)], "velocity_constraint": [(0,), (0, n)],
        "mass_matrix": [(n, n)], "dynamics": [(n, n), (n,), (0, n), (0,)], "inverse_dynamics": [(n,)],
        "residual": [(n,), (0,)], "residual_tangent": [(n,), (0,)], "state_derivative": [(0,)],
        "state_derivative_tangent": [(0,)], "output_tangent": [(len(roots),)], "energies": [(), (), (), ()],
        "momenta": [(n,)], "power": [(n,), (n,)], "monitor": [(0,), (0,), (0,)], "initial_equation": [(0,)],
        "constraint_tangent": [(0,), (0,)],
    }  # fmt: skip
    output = (vector_block("y", roots),)
    functions = tuple(
        replace(f, results=output if f.name == "output" else tuple(block(*s) for s in shapes[f.name]))
        for f in base.functions
    )
    return replace(base, name=name, layout=layout, graph=graph, functions=functions)
