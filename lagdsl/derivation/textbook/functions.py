"""Functions of the language that SymPy would rewrite, kept whole: a value, a derivative and nothing else.

SymPy's own `Abs`, `Max`, `Piecewise` and relations look for simplifications at every step; an oracle has no use for it.
Derivatives are those that hold between the jumps. Comparisons and logic have the values 0 and 1 and the derivative 0.
"""

from __future__ import annotations

from sympy import Expr, Function, Integer


class _Step(Function):  # type: ignore[misc]  # SymPy has no type information
    """Constant between its jumps."""

    def fdiff(self, argindex: int = 1) -> Expr:
        return Integer(0)


class Sign(_Step):
    nargs = 1


class Floor(_Step):
    nargs = 1


class Ceil(_Step):
    nargs = 1


class Not(_Step):
    nargs = 1


class Less(_Step):
    nargs = 2


class LessEqual(_Step):
    nargs = 2


class Equal(_Step):
    nargs = 2


class And(_Step):
    nargs = 2


class Or(_Step):
    nargs = 2


class Absolute(Function):  # type: ignore[misc]
    nargs = 1

    def fdiff(self, argindex: int = 1) -> Expr:
        return Sign(self.args[0])


class Modulo(Function):  # type: ignore[misc]
    """x - floor(x/y) y."""

    nargs = 2

    def fdiff(self, argindex: int = 1) -> Expr:
        x, y = self.args
        return Integer(1) if argindex == 1 else -Floor(x / y)


class ArcTangent2(Function):  # type: ignore[misc]
    """Angle of the point (x, y), arguments y and x."""

    nargs = 2

    def fdiff(self, argindex: int = 1) -> Expr:
        y, x = self.args
        return (x if argindex == 1 else -y) / (x**2 + y**2)


class Select(Function):  # type: ignore[misc]
    """The second argument where the first is not 0, else the third."""

    nargs = 3

    def fdiff(self, argindex: int = 1) -> Expr:
        one, zero = Integer(1), Integer(0)
        match argindex:
            case 2:
                return Select(self.args[0], one, zero)
            case 3:
                return Select(self.args[0], zero, one)
            case _:
                return zero


class Minimum(Function):  # type: ignore[misc]
    nargs = 2

    def fdiff(self, argindex: int = 1) -> Expr:
        x, y = self.args
        return Select(Less(y, x), Integer(argindex == 2), Integer(argindex == 1))


class Maximum(Function):  # type: ignore[misc]
    nargs = 2

    def fdiff(self, argindex: int = 1) -> Expr:
        x, y = self.args
        return Select(Less(x, y), Integer(argindex == 2), Integer(argindex == 1))
