"""SymPy expressions as boxes, in the order people write: numbers, parameters, coordinates, rates, functions."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field

import sympy
from sympy import Expr, Symbol

from lagdsl.derivation.textbook import functions
from lagdsl.derivation.textbook.symbols import Symbols
from lagdsl.documents.report.boxes import (
    Box,
    Bracket,
    Call,
    Cases,
    Column,
    Fraction,
    Marked,
    Matrix,
    Name,
    Number,
    Operator,
    Power,
    Root,
    Row,
    Sum,
    Upright,
)
from lagdsl.documents.report.intermediate import Intermediates, Rules
from lagdsl.documents.report.notation import Notation

_FUNCTION_NAMES = {
    sympy.sin: "sin", sympy.cos: "cos", sympy.tan: "tan", sympy.asin: "arcsin", sympy.acos: "arccos",
    sympy.atan: "arctan", sympy.sinh: "sinh", sympy.cosh: "cosh", sympy.tanh: "tanh", sympy.exp: "exp",
    sympy.log: "ln", functions.Sign: "sign", functions.Floor: "floor", functions.Ceil: "ceil",
    functions.Absolute: "abs", functions.Modulo: "mod", functions.ArcTangent2: "atan2",
    functions.Minimum: "min", functions.Maximum: "max", functions.Not: "not",
}  # fmt: skip
_RELATIONS = {
    functions.Less: "<",
    functions.LessEqual: "≤",
    functions.Equal: "=",
    functions.And: "and",
    functions.Or: "or",
}


@dataclass
class Typesetter:
    """Sets expressions in the notation of one derivation; the symbols `first` lead in products (masses and gravity)."""

    notation: Notation
    symbols: Symbols
    constants: frozenset[Symbol]
    intermediates: Intermediates
    first: tuple[Symbol, ...] = ()
    _rank: dict[Symbol, int] = field(init=False)

    def __post_init__(self) -> None:
        s = self.symbols
        others = sorted(self.constants - set(s.p), key=str)
        constants = dict.fromkeys((*self.first, *s.p, *others))
        order = (*s.lam, *constants, s.time, *s.u, *s.z, *s.q, *s.qd, *s.qdd)
        self._rank = {symbol: index for index, symbol in enumerate(order)}

    def __call__(self, expression: Expr, sources: Mapping[Expr, tuple[int, ...]] | None = None) -> Box:
        """The expression, a long one with intermediate quantities; its terms with their `sources`."""
        expression, rules = self.intermediates.short(expression)
        if not sources:
            return self._box(expression)
        sources = {_by(rules, term): own for term, own in sources.items()} if rules else sources
        if expression.is_Add:
            return self._sum(expression, sources)
        box = self._box(expression)
        if isinstance(box, Sum) and len(box.terms) == 1:
            [(sign, inside)] = box.terms
            return Sum(((sign, Marked(inside, sources.get(expression, ()))),))
        return Marked(box, sources[expression]) if expression in sources else box

    def vector(self, components: tuple[Expr, Expr, Expr], planar: bool = False) -> Box:
        return Column(tuple(self(x) for x in (components[:2] if planar else components)))

    def matrix(self, rows: tuple[tuple[Expr, ...], ...]) -> Box:
        return Matrix(tuple(tuple(self(x) for x in row) for row in rows))

    # ---- by kind -----------------------------------------------------------------------------------------------------

    def _box(self, e: Expr) -> Box:
        if e.is_Symbol:
            return self.notation.of(e)
        if e.is_Number or e.is_NumberSymbol:
            return _number(e)
        if e.is_Add:
            return self._sum(e)
        if e.is_Mul or e.is_Pow:
            return self._product(e)
        return self._function(e)

    def _sum(self, e: Expr, sources: Mapping[Expr, tuple[int, ...]] | None = None) -> Box:
        unmoving = len(self._rank) if any(self._is_polynomial(term) for term in e.args) else -1
        ordered = sorted(e.args, key=lambda term: self._term_key(term, unmoving))
        terms = [(_is_negative(term), term) for term in ordered]
        if terms[0][0]:
            first = next((i for i, (negative, _) in enumerate(terms) if not negative), 0)
            terms.insert(0, terms.pop(first))
        return Sum(tuple(("-" if negative else "+", self._marked(negative, t, sources or {})) for negative, t in terms))

    def _marked(self, negative: bool, term: Expr, sources: Mapping[Expr, tuple[int, ...]]) -> Box:
        box = self._box(-term if negative else term)
        return Marked(box, sources[term]) if term in sources else box

    def _product(self, e: Expr) -> Box:
        sign, e = ("-", -e) if _is_negative(e) else ("+", e)
        coefficient, rest = e.as_coeff_Mul()
        above: list[Expr] = []
        below: list[Expr] = []
        for factor in sympy.Mul.make_args(rest):
            base, exponent = factor.as_base_exp()
            if factor.is_Pow and exponent.is_Number and exponent.is_negative:
                below.append(base**-exponent)
            elif factor != 1:
                above.append(factor)
        box = self._quotient(coefficient, above, below)
        return Sum((("-", box),)) if sign == "-" else box

    def _quotient(self, coefficient: Expr, above: list[Expr], below: list[Expr]) -> Box:
        if below:
            numerator = self._factors(_whole(coefficient.p), above) or Number("1")
            denominator = self._factors(_whole(coefficient.q), below)
            assert denominator is not None
            return Fraction(_unbracketed(numerator), _unbracketed(denominator))
        leading = None if coefficient == 1 and above else _number(coefficient)
        return self._factors(leading, above) or Number("1")

    def _factors(self, leading: Box | None, factors: list[Expr]) -> Box | None:
        boxes = [] if leading is None else [leading]
        ordered = sorted(factors, key=self._factor_key)
        alone = len(ordered) == 1 and leading is None
        boxes += [self._factor(factor, alone) for factor in ordered]
        if not boxes:
            return None
        return boxes[0] if len(boxes) == 1 else Row(tuple(boxes))

    def _factor(self, factor: Expr, alone: bool) -> Box:
        if factor.is_Pow:
            return self._power(factor.base, factor.exp)
        box = self._box(factor)
        return Bracket(box) if isinstance(box, Sum) and not alone else box

    def _power(self, base: Expr, exponent: Expr) -> Box:
        if exponent == sympy.Rational(1, 2):
            return Root(self._box(base))
        if exponent.is_Rational and exponent.q == 2 and exponent.p > 0:
            return Power(Root(self._box(base)), Number(str(exponent.p)))
        inside = self._box(base)
        if type(base) in (sympy.sin, sympy.cos, sympy.tan) and exponent.is_Integer:
            assert isinstance(inside, Call)
            return Call(Power(inside.function, Number(str(exponent))), inside.arguments)
        simple = base.is_Symbol or (base.is_Integer and base >= 0)
        return Power(inside if simple else Bracket(inside), self._box(exponent))

    def _function(self, e: Expr) -> Box:
        kind = type(e)
        if kind is functions.Select:
            condition, value, otherwise = e.args
            return Cases(self._box(value), self._box(condition), self._box(otherwise))
        arguments = tuple(self._box(argument) for argument in e.args)
        if kind in _RELATIONS:
            left, right = (Bracket(x) if isinstance(x, Row) and _has_relation(x) else x for x in arguments)
            return Row((left, Operator(_RELATIONS[kind]), right))
        return Call(Upright(_FUNCTION_NAMES.get(kind, str(kind.__name__))), arguments)

    # Order; ties stay in SymPy's own, which is the same in every run.

    def _is_polynomial(self, term: Expr) -> bool:
        """True if something that moves is a factor by itself, not only inside functions."""
        return any(s in self._rank and s not in self.constants for s in term.as_powers_dict())

    def _factor_key(self, factor: Expr) -> tuple[int, int]:
        base = factor.as_base_exp()[0]
        if base.is_NumberSymbol:
            return (0, 0)
        if base.is_Symbol:
            return (1 if base in self.constants else 3, self._rank.get(base, len(self._rank)))
        if base.is_Add:
            constant = base.free_symbols <= self.constants
            return (1 if constant else 2, -1 if constant else 0)
        rank = min((self._rank.get(s, 0) for s in base.free_symbols), default=0)
        return (4, 2 * rank + (not isinstance(base, sympy.sin)))

    def _term_key(self, term: Expr, unmoving: int) -> tuple[int, int, int]:
        """Accelerations first, then higher degrees in the rates, then the others; `unmoving` ranks constants."""
        powers = term.as_powers_dict()
        qdd = [self._rank[s] for s in self.symbols.qdd if s in term.free_symbols]
        rates = sum(int(p) for s, p in powers.items() if s in self.symbols.qd and p.is_Integer)
        moving = [self._rank[s] for s in term.free_symbols if s in self._rank and s not in self.constants]
        return (qdd[0] if qdd else len(self._rank), -rates, max(moving, default=unmoving))


def _by(rules: Rules, term: Expr) -> Expr:
    for rule in rules:
        term = term.xreplace(rule)
    return term


def _is_negative(e: Expr) -> bool:
    return bool(e.as_coeff_Mul()[0].is_negative)


def _has_relation(box: Row) -> bool:
    return any(isinstance(item, Operator) for item in box.items)


def _unbracketed(box: Box) -> Box:
    return box.inside if isinstance(box, Bracket) else box


def _whole(value: int) -> Box | None:
    return None if value == 1 else Number(str(value))


def _number(e: Expr) -> Box:
    if e is sympy.pi:
        return Name("π")
    if e.is_NumberSymbol or not e.is_finite:
        return Upright({sympy.E: "e", sympy.oo: "∞", -sympy.oo: "-∞"}.get(e, "undefined"))
    if e.is_negative:
        return Sum((("-", _number(-e)),))
    if e.is_Integer or e.is_Float:
        return Number(_decimal(e) if e.is_Float or abs(e) >= 10**12 else str(e))
    if (e.q <= 9 or not _is_decimal(e.q)) and max(e.q, e.p) < 10**4:
        return Fraction(Number(str(e.p)), Number(str(e.q)))
    return Number(_decimal(e))


def _is_decimal(q: int) -> bool:
    """True if 1/q ends after a few digits."""
    return 10**9 % q == 0


def _decimal(e: Expr) -> str:
    return f"{float(e):.10g}"
