"""Terms of the equations and the statements that they come from, in both directions.

Lagrange's operator d/dt d/dqd - d/dq is linear in L, loads add, constraints add J' lam: so every declared item has a
share of its own in each equation, and the shares add up to the residual M qdd - f - J' lam. A printed term, which may
be merged from several items, belongs to all whose shares hold one of its monomials.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from typing import Literal, TypeAlias

from sympy import Add, Expr, Integer, Symbol, cos, sin

from lagdsl.derivation.textbook import geometry
from lagdsl.derivation.textbook.contributions import Contributions, admissible_variation, held_rates, work
from lagdsl.derivation.textbook.differentiate import partial
from lagdsl.derivation.textbook.symbols import Symbols, occurring, postorder
from lagdsl.derivation.textbook.tidy import Tidy, TooLargeError, size
from lagdsl.language.flat.model import FlatModel
from lagdsl.language.flat.quantity import Item, Spans

Kind: TypeAlias = Literal["mass", "body", "gravity", "energy", "load", "constraint"]
_LONGEST_ANGLE = 5
_LARGEST = 1000
_BUDGET = 60_000


@dataclass(frozen=True, slots=True, kw_only=True)
class Source:
    """A declared item: `spans` are the statements behind it, innermost first."""

    kind: Kind
    name: str
    spans: Spans


@dataclass(frozen=True, slots=True, kw_only=True)
class Share:
    """The part of the residual that items cause together: one value per coordinate, in the unit of its equation.

    `sources` are indices: a weight is of a mass and of gravity.
    """

    sources: tuple[int, ...]
    values: tuple[Expr, ...]


@dataclass(frozen=True, slots=True, kw_only=True)
class Term:
    """A printed term of the equation of coordinate number `equation`: left-hand side, or right-hand side."""

    equation: int
    side: Literal["left", "right"]
    value: Expr
    sources: tuple[int, ...]


def sources(flat: FlatModel) -> tuple[Source, ...]:
    """All items that the equations are made of: masses, bodies, gravity, energies, loads, constraints."""
    found = [Source(kind="mass", name=f"mass {n}", spans=item.spans) for n, item in enumerate(flat.masses, start=1)]
    found += [Source(kind="body", name=item.label or item.frame, spans=item.spans) for item in flat.bodies]
    if flat.gravity is not None:
        spans = () if flat.gravity_span is None else (flat.gravity_span,)
        found.append(Source(kind="gravity", name="gravity", spans=spans))
    found += [Source(kind="energy", name=term.label or term.kind, spans=term.spans) for term in flat.energies]
    found += [Source(kind="load", name=load.label or _keyword(load), spans=load.spans) for load in flat.loads]
    found += [Source(kind="constraint", name=item.name, spans=item.spans) for item in flat.constraints]
    return tuple(found)


def _keyword(load: Item) -> str:
    words = load.spans[0].text.split() if load.spans else []
    return words[0] if words else "load"


def shares(flat: FlatModel, table: Symbols, parts: Contributions, *, whole: bool = True) -> Iterator[Share]:
    """The share of each item in M qdd - f - J' lam, gathered from the same parts as the whole.

    Where not `whole`, an energy stands for what becomes of it: it tells which symbols a share has.
    """
    converter = parts.converter
    held = held_rates(flat, table, parts)

    def operated(lagrangian: Expr, still: Expr) -> tuple[Expr, ...]:
        """Lagrange's operator, one value per coordinate; `still` is the same at fixed rates of states."""
        if not whole:
            present = occurring(lagrangian)
            moved = (q in present or qd in present for q, qd in zip(table.q, table.qd, strict=True))
            return tuple(lagrangian if acts else Integer(0) for acts in moved)
        return tuple(
            converter.rate(partial(lagrangian, qd)) - held.partial(still, q)
            for q, qd in zip(table.q, table.qd, strict=True)
        )

    for index, (item, same) in enumerate(zip(parts.inertials, held.parts.inertials, strict=True)):
        yield Share(sources=(index,), values=operated(item.kinetic_energy, same.kinetic_energy))
    first = len(parts.inertials)
    if flat.gravity is not None:
        gravity = converter.vector(flat.gravity)
        for carrier, item in enumerate(parts.inertials):
            weight = item.mass * geometry.dot(gravity, item.position)
            yield Share(sources=(carrier, first), values=operated(weight, weight))
        first += 1
    for index, term in enumerate(flat.energies, start=first):
        value, still = converter.scalar(term.value), held.parts.converter.scalar(term.value)
        if term.kind == "dissipation":
            yield Share(sources=(index,), values=tuple(held.partial(still, qd) for qd in table.qd))
        elif term.kind == "potential":
            yield Share(sources=(index,), values=operated(-value, -still))
        else:
            yield Share(sources=(index,), values=operated(value, still))
    yield from _others(flat, table, parts, len(sources(flat)) - len(flat.loads) - len(flat.constraints))


def _others(flat: FlatModel, table: Symbols, parts: Contributions, first: int) -> Iterator[Share]:
    """Shares of loads and constraints."""
    pairs = list(zip(table.q, table.qd, strict=True))
    for index, actions in enumerate(parts.actions, start=first):
        works = (
            Add(*(work(action, admissible_variation(action, parts.converter, q, qd)) for action in actions))
            for q, qd in pairs
        )
        yield Share(sources=(index,), values=tuple(-value for value in works))
    rows = iter(zip(table.lam, parts.residuals, strict=True))
    for index, constraint in enumerate(flat.constraints, start=first + len(flat.loads)):
        own = [next(rows) for _ in constraint.rows]
        by = table.q if constraint.level == "position" else table.qd
        values = tuple(-Add(*(lam * partial(residual, symbol) for lam, residual in own)) for symbol in by)
        yield Share(sources=(index,), values=values)


class Parents:
    """Sources of terms, by the monomials that both have when all is multiplied out."""

    def __init__(self, table: Symbols, found: Sequence[Share], constants: frozenset[Symbol]) -> None:
        self._shares = found
        # A budget of its own: what is looked up must not make what is printed longer.
        self._tidy = Tidy(constants=constants, positive=frozenset(), budget=_BUDGET)
        self._monomials: dict[tuple[int, int], frozenset[object] | None] = {}
        self._moving = frozenset({table.time, *table.q, *table.qd, *table.qdd})

    def of(self, equation: int, term: Expr) -> tuple[int, ...]:
        """Indices of the sources of one term of an equation, in order; at least one where the equation has shares."""
        own = self._monomials_of(term)
        acting = [(number, share) for number, share in enumerate(self._shares) if share.values[equation] != 0]
        chosen = []
        for number, share in acting:
            key = (number, equation)
            if key not in self._monomials:
                self._monomials[key] = self._monomials_of(share.values[equation])
            theirs = self._monomials[key]
            if own is None or theirs is None:
                fits = self._own(term) <= occurring(share.values[equation])
            else:
                fits = not own.isdisjoint(theirs)
            if fits:
                chosen.append(share)
        found = chosen or [share for _, share in acting]
        return tuple(sorted({index for share in found for index in share.sources}))

    def _own(self, term: Expr) -> set[Symbol]:
        """Parameters and multipliers, by which a term beyond the bound is known."""
        return {symbol for symbol in occurring(term) if symbol not in self._moving}

    def _monomials_of(self, expression: Expr) -> frozenset[object] | None:
        """The terms of its sum: multiplied out, angles apart, sin^2 = 1 - cos^2; None beyond the bound."""
        if size(expression) >= _LARGEST:
            return None
        try:
            return frozenset(self._tidy.multiplied_out(angles_apart(expression)))
        except TooLargeError:
            return None


def angles_apart(expression: Expr) -> Expr:
    """Sines and cosines of short sums by the addition theorems."""
    known: dict[Expr, Expr] = {}
    for node in postorder(expression, known):
        arguments = tuple(known[argument] for argument in node.args)
        made = node if arguments == node.args else node.func(*arguments)
        if isinstance(made, sin | cos) and made.args[0].is_Add and len(made.args[0].args) <= _LONGEST_ANGLE:
            made = _apart(made.args[0].args, isinstance(made, sin))
        known[node] = made
    return known[expression]


def _apart(angles: tuple[Expr, ...], is_sine: bool) -> Expr:
    first, rest = angles[0], angles[1:]
    if not rest:
        return sin(first) if is_sine else cos(first)
    if is_sine:
        return sin(first) * _apart(rest, False) + cos(first) * _apart(rest, True)
    return cos(first) * _apart(rest, False) - sin(first) * _apart(rest, True)


def terms(
    lefts: Sequence[Expr], rights: Sequence[Expr], parents: Callable[[int, Expr], tuple[int, ...]]
) -> Iterator[Term]:
    """The terms of all equations, as they are printed."""
    sides: Mapping[Literal["left", "right"], Sequence[Expr]] = {"left": lefts, "right": rights}
    for side, expressions in sides.items():
        for equation, expression in enumerate(expressions):
            for value in Add.make_args(expression):
                if value != 0:
                    yield Term(equation=equation, side=side, value=value, sources=parents(equation, value))
