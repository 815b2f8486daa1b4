"""The operations of the graph."""

from enum import IntEnum


class Op(IntEnum):
    """Operation of a node. Comparisons and logic give 0 or 1; SELECT(c, a, b) is a where c is not 0, else b.

    The order matters: leaves, then one, two and three arguments. Hashed as the numbers that they are: the hash of names
    costs more than the rest of a look-up.
    """

    __hash__ = int.__hash__

    CONSTANT = 0
    SYMBOL = 1
    # one argument
    NEGATE = 10
    SIN = 11
    COS = 12
    TAN = 13
    ASIN = 14
    ACOS = 15
    ATAN = 16
    SINH = 17
    COSH = 18
    TANH = 19
    EXP = 20
    LOG = 21
    SQRT = 22
    ABS = 23
    SIGN = 24
    FLOOR = 25
    CEIL = 26
    NOT = 27
    # two arguments
    ADD = 40
    SUBTRACT = 41
    MULTIPLY = 42
    DIVIDE = 43
    POWER = 44
    ATAN2 = 45
    MOD = 46
    MIN = 47
    MAX = 48
    LESS = 49
    LESS_EQUAL = 50
    EQUAL = 51
    AND = 52
    OR = 53
    # three arguments
    SELECT = 60


FIRST_UNARY = Op.NEGATE
FIRST_BINARY = Op.ADD
FIRST_TERNARY = Op.SELECT

# Piecewise constant: the derivative is 0 wherever there is one.
STEPS = frozenset({Op.SIGN, Op.FLOOR, Op.CEIL, Op.NOT, Op.LESS, Op.LESS_EQUAL, Op.EQUAL, Op.AND, Op.OR})


class Group(IntEnum):
    """Group of a symbol: one of the arrays that a program's functions take, by name in the vocabulary."""

    __hash__ = int.__hash__

    TIME = 0
    Q = 1
    QD = 2
    Z = 3
    U = 4
    W = 5
    P = 6
    QDD = 7
    LAMBDA = 8
    DIRECTION_Q = 9
    DIRECTION_QD = 10
    DIRECTION_Z = 11
    DIRECTION_U = 12
    DIRECTION_QDD = 13
    DIRECTION_LAMBDA = 14
    DIRECTION_P = 15
    RELEASE = 16
    RELEASE_RATE = 17


ARGUMENT_NAMES: dict[Group, str] = {
    Group.TIME: "t",
    Group.Q: "q",
    Group.QD: "qd",
    Group.Z: "z",
    Group.U: "u",
    Group.W: "w",
    Group.P: "p",
    Group.QDD: "qdd",
    Group.LAMBDA: "lam",
    Group.DIRECTION_Q: "dq",
    Group.DIRECTION_QD: "dqd",
    Group.DIRECTION_Z: "dz",
    Group.DIRECTION_U: "du",
    Group.DIRECTION_QDD: "dqdd",
    Group.DIRECTION_LAMBDA: "dlam",
    Group.DIRECTION_P: "dp",
}

# The direction along which the symbols of a group move.
DIRECTION_OF = {
    Group.Q: Group.DIRECTION_Q,
    Group.QD: Group.DIRECTION_QD,
    Group.Z: Group.DIRECTION_Z,
    Group.U: Group.DIRECTION_U,
    Group.P: Group.DIRECTION_P,
    Group.QDD: Group.DIRECTION_QDD,
    Group.LAMBDA: Group.DIRECTION_LAMBDA,
}

# Elementary functions by the name that C, mpmath and our own tables of functions have for them.
ELEMENTARY_NAMES = {
    Op.SIN: "sin",
    Op.COS: "cos",
    Op.TAN: "tan",
    Op.ASIN: "asin",
    Op.ACOS: "acos",
    Op.ATAN: "atan",
    Op.SINH: "sinh",
    Op.COSH: "cosh",
    Op.TANH: "tanh",
    Op.EXP: "exp",
    Op.LOG: "log",
    Op.SQRT: "sqrt",
    Op.FLOOR: "floor",
    Op.CEIL: "ceil",
    Op.ATAN2: "atan2",
}
