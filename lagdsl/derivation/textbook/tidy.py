"""Expressions made short for people, with a bound on the work.

An expression is multiplied out into a polynomial whose variables are its symbols, functions and roots; the theorem of
Pythagoras and the addition theorems are applied; then terms are collected by parameters and each bracket is factored.
Whichever is shorter, the result or what was there before, is kept. Numbers of a simulation never pass through here.
"""

from __future__ import annotations

from dataclasses import dataclass, field

import sympy
from sympy import Add, Expr, Integer, Mul, Pow, Rational, Symbol

from lagdsl.derivation.textbook.polynomial import Monomial, Polynomial, add_into, folded, multiply
from lagdsl.derivation.textbook.rational import divided, factors, lowest, quotient
from lagdsl.derivation.textbook.settle import step
from lagdsl.derivation.textbook.shortening.by_motion import by_motion
from lagdsl.derivation.textbook.shortening.choices import without_twin_choices
from lagdsl.derivation.textbook.shortening.constant_sums import known_sums, oriented
from lagdsl.derivation.textbook.shortening.products import (
    mostly_negative,
    numbered,
    revealed,
    squares,
    turned_positive,
)
from lagdsl.derivation.textbook.shortening.whole_sums import KnownSums, with_whole
from lagdsl.derivation.textbook.symbols import occurring
from lagdsl.derivation.textbook.trigonometry import Angles, reduce_trigonometry, without_squares

_LARGEST_POLYNOMIAL = 800
_LARGEST_TO_FACTOR = 12
_MOST_UNKNOWNS_TO_FACTOR = 8
_DEEPEST = 60
_DEEPEST_NESTING = 12
_WORTH_OF_BRACKETS = 4
_WORTH_OF_SUMS = 4
_WORTH_OF_SQUARES = 12
_MARGIN = 4
_LONGEST_SIGN = 6


class TooLargeError(Exception):
    """The bound on work or size is reached; the expression is left as it is."""


@dataclass
class Tidy:
    """Shortens expressions. `constants` do not change during a motion, `positive` symbols have positive values.

    `budget` counts products of monomials over the life of the object; when it is used up all is returned as given.
    `known` are sums of the model: r - l0 of a spring stays a bracket where all terms have that factor, R - r a factor.
    """

    constants: frozenset[Symbol]
    positive: frozenset[Symbol]
    budget: int = 100_000
    known: KnownSums = field(default_factory=KnownSums)
    _constant_kernels: dict[int, bool] = field(default_factory=dict)
    _nesting: int = 0
    _kernels: list[Expr] = field(default_factory=list)
    _index: dict[Expr, int] = field(default_factory=dict)
    _memo: dict[Expr, Expr] = field(default_factory=dict)
    _factors: dict[frozenset[tuple[Monomial, Expr]], tuple[Expr, list[tuple[Polynomial, int]]]] = field(
        default_factory=dict
    )

    def __call__(self, expression: Expr) -> Expr:
        if expression.is_Atom:
            return expression
        known = self._memo.get(expression)
        if known is None:
            known = self._shortest(expression)
            self._memo[expression] = known
            self._memo[known] = known
        return known

    def keep_whole(self, sums: tuple[Expr, ...]) -> None:
        """Sums that stay brackets from now on."""
        pairs = [(each, self(each)) for each in sums]
        self.known = with_whole(self.known, pairs)
        self._memo.clear()

    def _closed(self, expression: Expr) -> Expr:
        """The expression with the sums that have roots as symbols: multiplied out, they would lose their squares."""
        closed = expression.xreplace(self.known.closed)
        if closed == expression:
            return expression
        polynomial = self.reduced(closed)
        found = (self._bracketed(polynomial, self._best(polynomial)), self._by_roots(polynomial))
        return min((each.xreplace(self.known.opened) for each in found), key=self._length)

    def _by_roots(self, polynomial: Polynomial) -> Expr:
        """Sum over square roots and the sums that have them: each before a bracket."""
        groups: dict[Monomial, Polynomial] = {}
        for monomial, coefficient in polynomial.items():
            rooted = tuple(pair for pair in monomial if self._is_rooted(self._kernels[pair[0]]))
            rest = tuple(pair for pair in monomial if pair not in rooted)
            groups.setdefault(rooted, {})[rest] = coefficient
        return Add(*(self.monomial(rooted) * self._product_or_sum(rest) for rooted, rest in groups.items()))

    def _product_or_sum(self, polynomial: Polynomial) -> Expr:
        content, rest = self._factor(polynomial)
        return min(numbered(content, Integer(1), rest), self._best(polynomial), key=self._length)

    def _is_rooted(self, kernel: Expr) -> bool:
        return kernel in self.known.opened or (kernel.is_Pow and kernel.base.is_Add)

    def _shortest(self, expression: Expr) -> Expr:
        if self._nesting >= _DEEPEST_NESTING:
            return expression
        self._nesting += 1
        try:
            polynomial = self.reduced(expression)
            found = self._bracketed(polynomial, min(self._best(polynomial), expression, key=self._length))
            return found if not self.known.closed else min(found, self._closed(expression), key=self._length)
        except TooLargeError:
            return expression
        finally:
            self._nesting -= 1

    def collected(self, polynomial: Polynomial) -> Expr:
        """A reduced polynomial as a short expression."""
        return self._bracketed(polynomial, self._best(polynomial))

    def _best(self, polynomial: Polynomial) -> Expr:
        """Collected by constants, or by what moves where that is clearly shorter: products of one constant, and squares
        of sums, are as the model builds its energies."""
        found = oriented(self._collect(polynomial), self.known.constant)
        other = by_motion(polynomial, self._is_constant, self._factor)
        if other is None:
            return found
        other = oriented(other, self.known.constant)
        lost = _WORTH_OF_SQUARES * max(squares(found) - squares(other), 0)
        return other if self._length(other) + _MARGIN + lost <= self._length(found) else found

    def _length(self, expression: Expr) -> int:
        """Sums that the model has itself count less."""
        return size(expression) - _WORTH_OF_SUMS * known_sums(expression, self.known.constant)

    def _bracketed(self, polynomial: Polynomial, collected: Expr) -> Expr:
        """The sums that stay whole as brackets, where that is about as short as `collected`."""
        if self.known.whole and (bracketed := self._folded(polynomial)) is not polynomial:
            whole = self._best(bracketed)
            return whole if size(whole) <= size(collected) + _WORTH_OF_BRACKETS else collected
        return collected

    def factored(self, polynomial: Polynomial) -> Expr:
        """A reduced polynomial as a product, or collected, whichever is shorter."""
        content, rest = self._factor(polynomial)
        return min(content * rest, self.collected(polynomial), key=size)

    def factors(self, expression: Expr) -> tuple[Expr, ...]:
        """Factors that are no numbers, without multiplicity and without denominators; raises TooLargeError."""
        polynomial = self.reduced(expression)
        if not polynomial:
            return (Integer(0),)
        divisor = lowest(polynomial)
        shifted = divided(polynomial, divisor)
        outside = tuple(self._kernels[kernel] for kernel, power in divisor if power > 0)
        if len(shifted) == 1:
            return outside
        unknowns = {kernel for monomial in shifted for kernel, _ in monomial}
        if len(shifted) > _LARGEST_TO_FACTOR or len(unknowns) > _MOST_UNKNOWNS_TO_FACTOR:
            return (*outside, self._sum(shifted))
        return (*outside, *(self.collected(part) for part, _ in factors(shifted)[1]))

    def reduced(self, expression: Expr) -> Polynomial:
        """The expression as a polynomial in kernels, trigonometry reduced; raises TooLargeError."""
        polynomial = without_twin_choices(self._polynomial(expression, 0), self._kernels, self.kernel)
        angles = Angles(kernel=self.kernel, expression=lambda index: self._kernels[index])
        return self._cancelled(reduce_trigonometry(polynomial, angles), angles)

    def multiplied_out(self, expression: Expr) -> Polynomial:
        """The expression as a polynomial in kernels, sin^2 = 1 - cos^2 and nothing else; raises TooLargeError."""
        angles = Angles(kernel=self.kernel, expression=lambda index: self._kernels[index])
        return without_squares(self._polynomial(expression, 0), angles)

    def _folded(self, polynomial: Polynomial) -> Polynomial:
        """c a + c b as c (a + b) for each sum that stays whole, a symbol from then on."""
        for bracket in self.known.whole:
            if len(polynomial) > 1:
                polynomial = folded(polynomial, self.reduced(bracket), self.kernel(bracket))
        return polynomial

    def _cancelled(self, polynomial: Polynomial, angles: Angles) -> Polynomial:
        """Sums in denominators are divided out of the numerator where that leaves no remainder."""
        below = sorted({k for m in polynomial for k, power in m if power < 0 and self._kernels[k].is_Add})
        for kernel in below:
            divisor = reduce_trigonometry(self._polynomial(self._kernels[kernel], 0), angles)
            power, numerator = self._over(polynomial, kernel, divisor)
            reduced = power
            while reduced < 0 and numerator:
                result = quotient(numerator, divisor) or quotient(without_squares(numerator, angles), divisor)
                if result is None:
                    break
                numerator, reduced = result, reduced + 1
            if reduced > power or not numerator:
                polynomial = multiply(numerator, {((kernel, reduced),) if reduced else (): Integer(1)})
        return polynomial

    def _over(self, polynomial: Polynomial, kernel: int, divisor: Polynomial) -> tuple[int, Polynomial]:
        """The lowest power of a kernel, and all that stands over it."""
        power = min(dict(monomial).get(kernel, 0) for monomial in polynomial)
        numerator: Polynomial = {}
        for monomial, coefficient in polynomial.items():
            own = dict(monomial).get(kernel, 0)
            term: Polynomial = {tuple(pair for pair in monomial if pair[0] != kernel): coefficient}
            for _ in range(own - power):
                term = self._times(term, divisor)
            add_into(numerator, term)
        return power, self._bounded(numerator)

    def is_zero(self, expression: Expr) -> bool:
        """True if it vanishes identically, as far as the bound lets one see."""
        try:
            return not self.reduced(expression)
        except TooLargeError:
            return False

    # ---- multiplying out ---------------------------------------------------------------------------------------------

    def kernel(self, expression: Expr) -> int:
        if expression not in self._index:
            self._index[expression] = len(self._kernels)
            self._kernels.append(expression)
        return self._index[expression]

    def _polynomial(self, expression: Expr, depth: int) -> Polynomial:
        if depth > _DEEPEST:
            raise TooLargeError
        if expression.is_Rational:
            return {(): expression} if expression else {}
        if expression.is_Add:
            total: Polynomial = {}
            for argument in expression.args:
                add_into(total, self._polynomial(argument, depth + 1))
            return self._bounded(total)
        if expression.is_Mul:
            product: Polynomial = {(): Integer(1)}
            for argument in expression.args:
                product = self._times(product, self._polynomial(argument, depth + 1))
            return product
        if expression.is_Pow and expression.exp.is_Rational:
            return self._power(expression.base, expression.exp, depth)
        if expression.is_Atom:
            return self._single(expression, 1)
        rebuilt = step(expression.func(*(self(argument) for argument in expression.args)))
        if (rebuilt.is_Atom and not rebuilt.is_Rational) or rebuilt.is_Function or rebuilt.is_Pow:
            return self._single(rebuilt, 1)
        return self._polynomial(rebuilt, depth + 1)

    def _power(self, base: Expr, exponent: Rational, depth: int) -> Polynomial:
        if exponent.is_Integer and 0 < exponent <= 8:
            factor = self._polynomial(base, depth + 1)
            product: Polynomial = {(): Integer(1)}
            for _ in range(int(exponent)):
                product = self._times(product, factor)
            return product
        inner = self._root(self(base)) if exponent.q == 2 else Pow(self(base), Rational(1, exponent.q))
        whole = Integer(exponent.p)
        if inner.is_Mul or (inner.is_Pow and inner.exp.is_Integer):
            product = {(): Integer(1)}
            for factor, power in inner.as_powers_dict().items():
                product = self._times(product, self._one_power(factor, power * whole, depth))
            return product
        return self._one_power(inner, whole, depth)

    def _one_power(self, base: Expr, power: Expr, depth: int) -> Polynomial:
        if base.is_Rational:
            return {(): Pow(base, power)} if power.is_Integer else self._single(Pow(base, power), 1)
        if not power.is_Integer or abs(power) > 64:
            return self._single(Pow(base, power), 1)
        if power > 1 and base.is_Pow and base.exp == Rational(1, 2) and power % 2 == 0:
            return self._power(base.base, power / 2, depth + 1)
        return self._single(base, int(power))

    def _root(self, base: Expr) -> Expr:
        """The square root; squares of positive symbols leave it."""
        outside, inside = [], []
        for factor, power in base.as_powers_dict().items():
            if power.is_Integer and self._is_positive(factor):
                outside.append(factor ** (power // 2))
                inside.append(factor ** (power % 2))
            else:
                inside.append(factor**power)
        return Mul(*outside, sympy.sqrt(Mul(*inside)))

    def _is_positive(self, factor: Expr) -> bool:
        if factor.is_Symbol:
            return factor in self.positive
        symbols = factor.free_symbols if factor.is_Add and len(factor.args) <= _LONGEST_SIGN else set()
        positive = bool(symbols) and symbols <= self.positive
        return positive and bool(factor.xreplace({s: Symbol(s.name, positive=True) for s in symbols}).is_positive)

    def _single(self, expression: Expr, power: int) -> Polynomial:
        return {((self.kernel(expression), power),): Integer(1)}

    def _times(self, left: Polynomial, right: Polynomial) -> Polynomial:
        self.budget -= len(left) * len(right)
        if self.budget < 0:
            raise TooLargeError
        return self._bounded(multiply(left, right))

    def _bounded(self, polynomial: Polynomial) -> Polynomial:
        if len(polynomial) > _LARGEST_POLYNOMIAL:
            raise TooLargeError
        return polynomial

    # ---- collecting --------------------------------------------------------------------------------------------------

    def _collect(self, polynomial: Polynomial) -> Expr:
        """Sum over brackets: (sum of parameter factors) * bracket, brackets factored, equal ones merged."""
        groups: dict[Monomial, Polynomial] = {}
        for monomial, coefficient in polynomial.items():
            fixed = tuple(pair for pair in monomial if self._is_constant(pair[0]))
            moving = tuple(pair for pair in monomial if not self._is_constant(pair[0]))
            groups.setdefault(fixed, {})[moving] = coefficient
        brackets: dict[Expr, list[tuple[Expr, Monomial]]] = {}
        for fixed, moving_part in groups.items():
            content, bracket = self._factor(moving_part)
            brackets.setdefault(bracket, []).append((content, fixed))
        return Add(*(self._common(terms) * bracket for bracket, terms in brackets.items()))

    def _common(self, terms: list[tuple[Expr, Monomial]]) -> Expr:
        """A sum of products of constants, common factors before it. SymPy would look for factors inside of kernels,
        which are short already, so that those of several nodes are hidden in symbols."""
        hidden: dict[Expr, Expr] = {}
        for index in {kernel for _, monomial in terms for kernel, _ in monomial}:
            kernel = self._kernels[index]
            if not kernel.is_Atom:
                hidden[Symbol(f"kernel {index:09d}")] = kernel
        back = {kernel: symbol for symbol, kernel in hidden.items()}
        shown = [
            content * Mul(*(back.get(self._kernels[k], self._kernels[k]) ** power for k, power in monomial))
            for content, monomial in terms
        ]
        total = Add(*shown)
        return revealed(sympy.factor_terms(total) if total.is_Add else total, hidden)

    def _is_constant(self, index: int) -> bool:
        known = self._constant_kernels.get(index)
        if known is None:
            known = self._constant_kernels[index] = occurring(self._kernels[index]) <= self.constants
        return known

    def monomial(self, monomial: Monomial) -> Expr:
        """The product of kernels."""
        return Mul(*(self._kernels[index] ** power for index, power in monomial))

    def _factor(self, polynomial: Polynomial) -> tuple[Expr, Expr]:
        """Rational content and the rest, factored where it is small."""
        divisor = lowest(polynomial)
        shifted = divided(polynomial, divisor)
        common = self.monomial(divisor)
        if len(shifted) == 1:
            [(monomial, coefficient)] = shifted.items()
            return coefficient, common * self.monomial(monomial)
        unknowns = {kernel for monomial in shifted for kernel, _ in monomial}
        if len(shifted) > _LARGEST_TO_FACTOR or len(unknowns) > _MOST_UNKNOWNS_TO_FACTOR:
            return Integer(1), common * self._sum(shifted)
        key = frozenset(shifted.items())
        if key not in self._factors:
            self._factors[key] = factors(shifted)
        content, parts = self._factors[key]
        if sum(1 for part, power in parts if power % 2 and mostly_negative(part)) % 2:
            content = -content
        return content, Mul(common, *(self._sum(turned_positive(part)) ** power for part, power in parts))

    def _sum(self, polynomial: Polynomial) -> Expr:
        return Add(*(c * self.monomial(monomial) for monomial, c in polynomial.items()))


def times(factor: Expr, symbol: Symbol) -> Expr:
    """Their product; the sign of a sum of negative terms stands before it."""
    negative = factor.is_Add and all(term.as_coeff_Mul()[0].is_negative for term in factor.args)
    return Mul(-1, symbol, -factor) if negative else factor * symbol


def size(expression: Expr, most: int = 1000) -> int:
    """Length of the text: nodes of the tree, shared ones counted as often as they occur; at most `most`."""
    total, stack = 0, [expression]
    while stack and total < most:
        node = stack.pop()
        total += 1
        stack.extend(node.args)
    return total
