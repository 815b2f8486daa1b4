"""The instructions of a tape by number, as lag/tape/tape_code.h lists them."""

from __future__ import annotations

from itertools import count
from typing import Final

import numpy as np

from lagdsl.algebra.graph.operation import Group, Op

MOST_OPERANDS: Final = 6
# Arguments of one SINCOS.
ANGLES: Final = 32

_SPECIAL = ("END", "CONSTANTS", "LOAD", "STORE", "SCATTER", "SINCOS", "TWO_PRODUCTS", "THREE_PRODUCTS")
_UNARY = (
    *(Op.TAN, Op.ASIN, Op.ACOS, Op.ATAN, Op.SINH, Op.COSH, Op.TANH, Op.EXP, Op.LOG, Op.SQRT),
    *(Op.FLOOR, Op.CEIL, Op.ABS, Op.SIGN, Op.NOT),
)
_BINARY = (
    *(Op.MULTIPLY, Op.DIVIDE, Op.POWER, Op.ATAN2, Op.MOD, Op.MIN, Op.MAX),
    *(Op.LESS, Op.LESS_EQUAL, Op.EQUAL, Op.AND, Op.OR),
)

_STRIDED = ("TWO_PRODUCTS", "THREE_PRODUCTS", "MULTIPLY", "DIVIDE")

_number = count()
CODE: Final[dict[str, int]] = {
    name: next(_number)
    for name in (
        *_SPECIAL,
        *(op.name for op in (*_UNARY, *_BINARY, Op.SELECT)),
        *(f"STRIDED_{name}" for name in _STRIDED),
    )
}

# The same instructions over strides.
STRIDED: Final[dict[int, int]] = {CODE[name]: CODE[f"STRIDED_{name}"] for name in _STRIDED}
FIRST_STRIDED: Final = min(STRIDED.values())

# Sums are of products, a term that is none is multiplied by one; signs tell which are subtracted.
TWO_PRODUCTS: Final = CODE["TWO_PRODUCTS"]
THREE_PRODUCTS: Final = CODE["THREE_PRODUCTS"]

# By operation of the graph: its instruction.
INSTRUCTION = np.full(max(Op) + 1, -1, dtype=np.int64)
for _op in (*_UNARY, *_BINARY, Op.SELECT):
    INSTRUCTION[_op] = CODE[_op.name]
INSTRUCTION[Op.NEGATE] = CODE["MULTIPLY"]
INSTRUCTION[[Op.ADD, Op.SUBTRACT]] = TWO_PRODUCTS

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
