"""The instructions of a tape by number, as lag/tape_code.h lists them, and how the value before is taken as `v`."""

from __future__ import annotations

from enum import IntEnum
from itertools import count
from typing import Final

import numpy as np
from numpy.typing import NDArray

from lagdsl.graph.operation import Group, Op

MOST_OPERANDS: Final = 4
# Arguments of one SINCOS.
ANGLES: Final = 32

_SPECIAL = ("END", "CONSTANTS", "LOAD", "STORE", "SCATTER", "SINCOS")
# Instructions of arithmetic and how many operands they have; behind each of them is the one that stores nothing.
ARITHMETIC: Final = {
    "NEGATE": 1, "ADD": 2, "SUBTRACT": 2, "MULTIPLY": 2, "DIVIDE": 2, "MUL_ADD": 3, "MUL_SUB": 3, "SUB_MUL": 3,
    "MUL_ADD_MUL": 4, "MUL_SUB_MUL": 4, "V_NEGATE": 0, "V_ADD": 1, "V_SUBTRACT": 1, "SUBTRACT_V": 1, "V_MULTIPLY": 1,
    "V_DIVIDE": 1, "DIVIDE_V": 1, "MUL_ADD_V": 2, "MUL_SUB_V": 2, "V_SUB_MUL": 2, "V_MUL_ADD": 2, "V_MUL_SUB": 2,
    "SUB_V_MUL": 2, "V_MUL_ADD_MUL": 3, "V_MUL_SUB_MUL": 3, "MUL_SUB_V_MUL": 3,
}  # fmt: skip
UNARY: Final = (
    *(Op.TAN, Op.ASIN, Op.ACOS, Op.ATAN, Op.SINH, Op.COSH, Op.TANH, Op.EXP, Op.LOG, Op.SQRT),
    *(Op.ABS, Op.SIGN, Op.FLOOR, Op.CEIL, Op.NOT),
)
BINARY: Final = (*(Op.POWER, Op.ATAN2, Op.MOD, Op.MIN, Op.MAX, Op.LESS, Op.LESS_EQUAL, Op.EQUAL, Op.AND, Op.OR),)

_number = count()
CODE: Final[dict[str, int]] = {
    **{name: next(_number) for name in _SPECIAL},
    **{name + ending: next(_number) for name in ARITHMETIC for ending in ("", "_ON")},
    **{op.name: next(_number) for op in (*UNARY, *BINARY, Op.SELECT)},
}


class Form(IntEnum):
    """Arithmetic with all operands in the row."""

    NEGATE = CODE["NEGATE"]
    ADD = CODE["ADD"]
    SUBTRACT = CODE["SUBTRACT"]
    MULTIPLY = CODE["MULTIPLY"]
    DIVIDE = CODE["DIVIDE"]
    MUL_ADD = CODE["MUL_ADD"]
    MUL_SUB = CODE["MUL_SUB"]
    SUB_MUL = CODE["SUB_MUL"]
    MUL_ADD_MUL = CODE["MUL_ADD_MUL"]
    MUL_SUB_MUL = CODE["MUL_SUB_MUL"]


# What an instruction becomes where the operand of this number is the value before; the operands that remain, in order.
_ON_V: dict[tuple[Form, int], tuple[str, tuple[int, ...]]] = {
    (Form.NEGATE, 0): ("V_NEGATE", ()),
    (Form.ADD, 0): ("V_ADD", (1,)),
    (Form.ADD, 1): ("V_ADD", (0,)),
    (Form.SUBTRACT, 0): ("V_SUBTRACT", (1,)),
    (Form.SUBTRACT, 1): ("SUBTRACT_V", (0,)),
    (Form.MULTIPLY, 0): ("V_MULTIPLY", (1,)),
    (Form.MULTIPLY, 1): ("V_MULTIPLY", (0,)),
    (Form.DIVIDE, 0): ("V_DIVIDE", (1,)),
    (Form.DIVIDE, 1): ("DIVIDE_V", (0,)),
    (Form.MUL_ADD, 0): ("V_MUL_ADD", (1, 2)),
    (Form.MUL_ADD, 1): ("V_MUL_ADD", (0, 2)),
    (Form.MUL_ADD, 2): ("MUL_ADD_V", (0, 1)),
    (Form.MUL_SUB, 0): ("V_MUL_SUB", (1, 2)),
    (Form.MUL_SUB, 1): ("V_MUL_SUB", (0, 2)),
    (Form.MUL_SUB, 2): ("MUL_SUB_V", (0, 1)),
    (Form.SUB_MUL, 0): ("SUB_V_MUL", (1, 2)),
    (Form.SUB_MUL, 1): ("SUB_V_MUL", (0, 2)),
    (Form.SUB_MUL, 2): ("V_SUB_MUL", (0, 1)),
    (Form.MUL_ADD_MUL, 0): ("V_MUL_ADD_MUL", (1, 2, 3)),
    (Form.MUL_ADD_MUL, 1): ("V_MUL_ADD_MUL", (0, 2, 3)),
    (Form.MUL_ADD_MUL, 2): ("V_MUL_ADD_MUL", (3, 0, 1)),
    (Form.MUL_ADD_MUL, 3): ("V_MUL_ADD_MUL", (2, 0, 1)),
    (Form.MUL_SUB_MUL, 0): ("V_MUL_SUB_MUL", (1, 2, 3)),
    (Form.MUL_SUB_MUL, 1): ("V_MUL_SUB_MUL", (0, 2, 3)),
    (Form.MUL_SUB_MUL, 2): ("MUL_SUB_V_MUL", (3, 0, 1)),
    (Form.MUL_SUB_MUL, 3): ("MUL_SUB_V_MUL", (2, 0, 1)),
}

Table = NDArray[np.int64]


def _tables() -> tuple[Table, Table]:
    code = np.full((len(CODE), MOST_OPERANDS), -1, dtype=np.int64)
    left = np.full((len(CODE), MOST_OPERANDS, MOST_OPERANDS), -1, dtype=np.int64)
    for (form, which), (name, remaining) in _ON_V.items():
        code[form, which] = CODE[name]
        left[form, which, : len(remaining)] = remaining
    return code, left


# By instruction and operand: the instruction that takes it as `v` (-1: none), and the operands that remain (-1: none).
ON_V, REMAINING = _tables()

# By operation of the graph: the instruction that does it alone.
ALONE = np.full(max(Op) + 1, -1, dtype=np.int64)
ALONE[[Op.NEGATE, Op.ADD, Op.SUBTRACT, Op.MULTIPLY, Op.DIVIDE]] = [
    Form.NEGATE, Form.ADD, Form.SUBTRACT, Form.MULTIPLY, Form.DIVIDE
]  # fmt: skip
for _op in (*UNARY, *BINARY, Op.SELECT):
    ALONE[_op] = CODE[_op.name]

# Between these, instructions stand in pairs: the second one stores nothing.
FIRST_ARITHMETIC: Final = CODE["NEGATE"]
FIRST_FUNCTION: Final = CODE[UNARY[0].name]

# The groups of arguments by number in a tape: members of lag_arguments in their order.
GROUPS: Final[dict[Group, int]] = {
    group: number
    for number, group in enumerate(
        (
            *(Group.TIME, Group.Q, Group.QD, Group.Z, Group.U, Group.W, Group.P, Group.QDD, Group.LAMBDA),
            *(Group.DIRECTION_Q, Group.DIRECTION_QD, Group.DIRECTION_Z, Group.DIRECTION_U, Group.DIRECTION_P),
            *(Group.DIRECTION_QDD, Group.DIRECTION_LAMBDA),
        )
    )
}
