"""Results that follow from the equations of motion: accelerations, equilibria, linear equations, frequencies."""

from __future__ import annotations

import math
from collections.abc import Sequence
from typing import Literal, TypeAlias

from sympy import Expr, Integer, Symbol, fraction

from lagdsl.derivation.textbook.small_motions.accelerations import LONGEST_SOLUTION
from lagdsl.derivation.textbook.small_motions.linear import Frequency, Linear
from lagdsl.derivation.textbook.small_motions.roots import Condition
from lagdsl.derivation.textbook.small_motions.steady import Steady
from lagdsl.derivation.textbook.small_motions.study import Equilibrium
from lagdsl.derivation.textbook.tidy import size
from lagdsl.documents.report.boxes import (
    EQUALS,
    Box,
    Bracket,
    Fraction,
    Joined,
    Name,
    Number,
    Operator,
    Power,
    Root,
    Row,
    Subscript,
    Sum,
    Upright,
)
from lagdsl.documents.report.dimensions import Units
from lagdsl.documents.report.document import (
    Block,
    Code,
    Equation,
    Equations,
    Heading,
    Math,
    Paragraph,
    Strong,
    Text,
    text,
    with_code,
)
from lagdsl.documents.report.names import listed
from lagdsl.documents.report.notation import dotted
from lagdsl.documents.report.page import Page
from lagdsl.documents.report.sections.instants import absent_rows
from lagdsl.documents.report.unicode_math import line
from lagdsl.documents.report.unit_text import value_and_unit
from lagdsl.language.flat.expression import Number as Constant
from lagdsl.language.flat.model import Input

Sign: TypeAlias = Literal["+", "-"]
_ZERO = Number("0")
_LONGEST_ROOT = 40
_LONGEST_FRACTION = 76
_REST = "At rest, with all rates and accelerations zero, the equations of motion are:"
_REST_CONSTRAINED = "At rest, with all rates and accelerations zero, the equations of motion and the constraints are:"
_OF_CONSTRAINED = ". Small motions about it keep the constraints; `lag modes` finds them."
_OF_CONTACTS = (
    "Of each contact the gap or the multiplier is zero, and neither is negative: it is open, or closed and pushes."
)
_HOLD = "They hold at "
_NOWHERE = "They have no solution: the system stays nowhere at rest."
_SINGULAR = "They hold only where the matrix of the accelerations is singular, which determines no motion: at "
_LONGEST_IN_LINE = 80  # letters of a value; longer ones stand in a line of their own
_COUPLED = ": the squares of their frequencies are roots of a longer polynomial; `lag modes` finds them."
_DAMPED = " are coupled by damping or gyroscopic terms; `lag modes` finds their eigenvalues."
_STEADY = " constant and all other coordinates are at rest; then the equations of motion are:"
_EVERYWHERE = "At rest all terms vanish: every configuration is an equilibrium."
_NONLINEAR = "The equations are not linear in the accelerations and multipliers, so they are solved in numbers."


def accelerations(page: Page) -> list[Block]:
    """Each acceleration by itself, then the multipliers of constraints; nothing for a model without coordinates."""
    if page.study is None:
        return []
    found = page.study.accelerations
    blocks: list[Block] = [Heading("Solved for the accelerations")]
    if found.nonlinear:
        return [*blocks, Paragraph(text(_NONLINEAR))]
    absent = absent_rows(page)
    if absent is not None:
        blocks.append(Paragraph(text(absent)))
    if found.values:
        units = {} if page.units is None else page.units.of_symbols(page.derivation)
        lines = (
            _solution(page.notation.of(symbol), page.typeset(value), unit=units.get(symbol))
            for symbol, value in found.values
        )
        blocks.append(Equations(tuple(lines)))
    if left_out := [symbol for symbol in found.left_out if symbol not in page.derivation.balanced.values()]:
        names = listed([page.notation.of(symbol) for symbol in left_out])
        words = f": more than {LONGEST_SOLUTION} terms and factors, or not determined; they are solved in numbers."
        blocks.append(Paragraph((Text("Not written out are "), *names, Text(words))))
    return blocks


def _solution(name: Box, value: Box, *, final: bool = False, unit: str | None = None) -> Equation:
    """`name = value` in `unit`; a long fraction is multiplied by its denominator, so that its sums can be broken."""
    if isinstance(value, Fraction) and len(line(value)) > _LONGEST_FRACTION:
        below = Bracket(value.below) if isinstance(value.below, Sum) else value.below
        return Equation(Row((*(below.items if isinstance(below, Row) else (below,)), name)), value.above, final=final)
    return Equation(name, value, final=final, unit=unit)


def small_motions(page: Page) -> list[Block]:
    found = page.study
    if found is None:
        return []
    blocks: list[Block] = [Heading("Equilibria and small motions")]
    if found.reason is not None:
        return [*blocks, Paragraph(with_code(found.reason))]
    if found.held:
        inputs = {item.name: item for item in page.flat.inputs}
        held = [Row((page.notation.of(u), EQUALS, *_default(inputs[u.name]))) for u in found.held]
        blocks.append(Paragraph((Text("Inputs are held at their defaults: "), *listed(held), Text("."))))
    count = len(page.derivation.symbols.q)
    lines = tuple(
        Equation(page.typeset(value), _ZERO, unit=page.unit(Units.force, j) if j < count else None)
        for j, value in enumerate(found.statics)
        if value != 0
    )
    contacts = any(row.contact for row in page.derivation.constraints)
    if not lines and not contacts:
        return [*blocks, Paragraph(text(_EVERYWHERE))]
    blocks += [Paragraph(text(_REST_CONSTRAINED if found.constrained else _REST)), Equations(lines)]
    blocks += [Paragraph(text(_OF_CONTACTS))] if contacts else []
    if not found.equilibria:
        blocks.append(_nowhere(page, found.singular))
    for group in _alike(found.equilibria):
        if _is_never(group[0]):
            blocks.append(_unless(page, group[0]))
        else:
            blocks += _equilibrium(page, group, constrained=found.constrained)
    blocks += [] if found.not_all_because is None else [Paragraph(with_code(found.not_all_because))]
    return blocks if found.steady is None else [*blocks, *_steady_motions(page, found.steady)]


def _default(item: Input) -> tuple[Box, ...]:
    assert isinstance(item.default, Constant)
    value, unit = value_and_unit(item.default.value, item)
    return (Number(value), Upright(unit)) if unit else (Number(value),)


def _is_never(equilibrium: Equilibrium) -> bool:
    """True if nothing that moves can make the equations hold for the parameters of the model."""
    return not equilibrium.exists and not equilibrium.at and all(c.kind == "zero" for c in equilibrium.conditions)


def _unless(page: Page, equilibrium: Equilibrium) -> Paragraph:
    conditions = listed([_condition(page, each) for each in equilibrium.conditions])
    return Paragraph((Text("There is no equilibrium unless "), *conditions, Text(".")))


def _nowhere(page: Page, singular: Sequence[Equilibrium]) -> Paragraph:
    words: list[Text | Math] = [Text(_NOWHERE if not singular else _HOLD if page.derivation.balanced else _SINGULAR)]
    for number, place in enumerate(_places(page, singular)):
        words += [Text(" and at "), *place] if number else place
    return Paragraph((*words, Text(".")) if singular else tuple(words))


def _steady_motions(page: Page, found: Steady) -> list[Block]:
    names = listed([page.notation.of(rate) for rate in found.rates])
    opening = (Text("In a steady motion "), *names, Text(f" {'is' if len(found.rates) == 1 else 'are'}{_STEADY}"))
    lines = tuple(Equation(page.typeset(value), _ZERO) for value in found.equations)
    blocks: list[Block] = [Paragraph(opening), Equations(lines)]
    places = [
        Equilibrium(at=tuple(each.at.items()), arbitrary=(), conditions=each.conditions, exists=True, linear=None)
        for each in found.places
    ]
    for same in _by_conditions(places):
        words: list[Strong | Text | Math] = [Strong("Steady motion"), Text(" ")]
        for number, place in enumerate(_places(page, same)):
            words += [Text(" and "), *place] if number else place
        for condition in same[0].conditions:
            words += [Text(", where "), Math(_condition(page, condition, found.rates))]
        blocks.append(Paragraph((*words, Text("."))))
    return blocks


def _by_conditions(places: Sequence[Equilibrium]) -> list[list[Equilibrium]]:
    result: dict[tuple[Condition, ...], list[Equilibrium]] = {}
    for place in places:
        result.setdefault(place.conditions, []).append(place)
    return list(result.values())


def _alike(equilibria: Sequence[Equilibrium]) -> list[list[Equilibrium]]:
    """Equilibria with the same linear equations together."""
    result: list[list[Equilibrium]] = []
    for each in equilibria:
        same = (g for g in result if each.linear and (g[0].linear, g[0].exists) == (each.linear, each.exists))
        group = next(same, None)
        if group is None:
            result.append([each])
        else:
            group.append(each)
    return result


def _equilibrium(page: Page, group: Sequence[Equilibrium], *, constrained: bool) -> list[Block]:
    first = group[0]
    if constrained and len(group) == 1 and _is_long(page, first):
        places = tuple(Equation(page.notation.of(q), page.typeset(value)) for q, value in first.at)
        after = Paragraph(with_code(_OF_CONSTRAINED.removeprefix(". ")))
        return [Paragraph((Strong("Equilibrium"), Text(" at"))), Equations(places), after]
    opening: list[Strong | Text | Math] = [Strong("Equilibrium"), Text(" ")]
    for number, place in enumerate(_places(page, group)):
        opening += [Text(" and "), *place] if number else place
    for condition in first.conditions:
        opening += [Text(", where "), Math(_condition(page, condition))]
    if first.conditions and not first.exists:
        opening.append(Text(", which is not so for the values above"))
    if first.closed:
        verb = ": the contact " if len(first.closed) == 1 else ": the contacts "
        names = [(Code(name),) for name in first.closed]
        pieces = [piece for n, name in enumerate(names) for piece in ((Text(" and "), *name) if n else name)]
        return [Paragraph((*opening, Text(verb), *pieces, Text(f" {'is' if len(names) == 1 else 'are'} closed.")))]
    if constrained:
        return [Paragraph((*opening, *with_code(_OF_CONSTRAINED)))]
    if first.linear is None:
        return [Paragraph((*opening, Text(". Its linear equations are too long to print.")))]
    blocks: list[Block] = [Paragraph((*opening, Text(". For small deviations δ:")))]
    blocks.append(Equations(_linear_lines(page, first.linear)))
    return [*blocks, *_frequencies(page, first)]


def _is_long(page: Page, equilibrium: Equilibrium) -> bool:
    """True for a place that is determined by itself and takes more than a line."""
    boxes = [page.typeset(value) for _, value in equilibrium.at]
    alone = not equilibrium.arbitrary and not equilibrium.conditions
    return alone and any(len(line(box)) > _LONGEST_IN_LINE for box in boxes)


def _places(page: Page, group: Sequence[Equilibrium]) -> list[list[Text | Math]]:
    """Each place in words; two that differ by one sign as one."""
    if len(group) == 2:
        pairs = list(zip(group[0].at, group[1].at, strict=True))
        other = [(q, a) for (q, a), (_, b) in pairs if a != b]
        if len(other) == 1 and all(a in (b, -b) for (_, a), (_, b) in pairs):
            return [_place(page, group[0], other[0][0])]
    return [_place(page, each, None) for each in group]


def _place(page: Page, equilibrium: Equilibrium, both: Symbol | None) -> list[Text | Math]:
    of = page.notation.of
    boxes: list[Box] = []
    for q, value in equilibrium.at:
        shown = page.typeset(value)
        if q == both:
            inside = shown.terms[0][1] if isinstance(shown, Sum) and len(shown.terms) == 1 else shown
            shown = Row((Name("±"), Bracket(inside) if isinstance(inside, Sum) else inside))
        boxes.append(Row((of(q), EQUALS, shown)))
    words: list[Text | Math] = []
    for number, box in enumerate(boxes):
        words += [Text(", "), Math(box)] if number else [Math(box)]
    if equilibrium.arbitrary:
        rest = listed([of(q) for q in equilibrium.arbitrary])
        pieces = [piece for piece in rest if isinstance(piece, Text | Math)]
        words += [Text(", with any " if words else "with any "), *pieces]
    return words


def _condition(page: Page, condition: Condition, rates: Sequence[Symbol] = ()) -> Box:
    """`a ≤ b` of a quotient of positive quantities, as squares of rates are, else the whole inequality."""
    value, at_most = condition.value, Operator("≤")
    if condition.kind == "zero":
        shown = page.typeset(value)
        alone = isinstance(shown, Sum) and len(shown.terms) == 1
        return Row((shown.terms[0][1] if isinstance(shown, Sum) and alone else shown, EQUALS, _ZERO))
    if condition.kind == "nonnegative":
        return Row((_ZERO, at_most, page.typeset(value)))
    above, below = fraction(value.together())
    even = {rate for rate in rates if value.xreplace({rate: -rate}) == value}
    positive = {s: Symbol(s.name, positive=True) for s in value.free_symbols if s in even or page.is_positive(s)}
    if above.xreplace(positive).is_positive and below.xreplace(positive).is_positive:
        return Row((page.typeset(above), at_most, page.typeset(below)))
    return Row((Sum((("-", Number("1")),)), at_most, page.typeset(value), at_most, Number("1")))


def _linear_lines(page: Page, linear: Linear) -> tuple[Equation, ...]:
    symbols = page.derivation.symbols
    boxes = [page.notation.of(q) for q in symbols.q]
    alone = len(boxes) == 1 and len(linear.frequencies) == 1
    if alone:
        own = linear.frequencies[0]
        rows = [((Integer(1),), (own.damping,), (own.square,))]
    else:
        rows = list(zip(linear.mass, linear.damping, linear.stiffness, strict=True))

    def unit(j: int) -> str | None:
        return page.unit(Units.acceleration if alone else Units.force, j)

    return tuple(Equation(_row(page, boxes, row), _ZERO, final=True, unit=unit(j)) for j, row in enumerate(rows))


def _row(page: Page, boxes: Sequence[Box], row: tuple[Sequence[Expr], ...]) -> Box:
    terms: list[tuple[Sign, Box]] = []
    for factors, dots in zip(row, (2, 1, 0), strict=True):
        for factor, box in zip(factors, boxes, strict=True):
            if factor != 0:
                deviation = Joined((page.notation.letter("δ"), dotted(box, dots) if dots else box))
                terms.append(_term(page, factor, deviation))
    terms.sort(key=lambda term: term[0] == "-") if terms and terms[0][0] == "-" else None
    return Sum(tuple(terms)) if terms else _ZERO


def _term(page: Page, factor: Expr, deviation: Joined) -> tuple[Sign, Box]:
    if factor == 1:
        return "+", deviation
    shown = page.typeset(factor)
    sign: Sign = "+"
    if isinstance(shown, Sum) and len(shown.terms) == 1:
        [(sign, shown)] = shown.terms
    if isinstance(shown, Sum | Fraction):
        shown = Bracket(shown)
    before = shown.items if isinstance(shown, Row) else (shown,)
    return sign, Row((*before, deviation))


def _frequencies(page: Page, equilibrium: Equilibrium) -> list[Block]:
    linear, of = equilibrium.linear, page.notation.of
    assert linear is not None
    known = sorted(linear.frequencies, key=lambda each: each.number) if equilibrium.exists else linear.frequencies
    letter = page.notation.letter("ω")
    names = [Subscript(letter, Number(str(k))) if len(known) > 1 else letter for k in range(1, len(known) + 1)]
    lines = [each for pair in zip(names, known, strict=True) for each in _frequency_lines(page, *pair)]
    blocks: list[Block] = [Equations(tuple(lines))] if lines else []
    words: list[Text | Math] = []
    for name, each in zip(names, known, strict=True):
        if len(equilibrium.conditions) == 0 or equilibrium.exists:
            words += [*_in_numbers(name, each), *_damped_in_numbers(page, name, each)]
    if words:
        blocks.append(Paragraph((Text("With the values above: "), *words[:-1], Text("."))))
    for symbols, why in ((linear.coupled, _COUPLED), (linear.damped, _DAMPED)):
        if symbols:
            blocks.append(Paragraph((*listed([of(q) for q in symbols]), *with_code(why))))
    return blocks


def _frequency_lines(page: Page, name: Box, frequency: Frequency) -> list[Equation]:
    """Natural frequency, then damping ratio and damped frequency of a coordinate with damping of its own."""
    lines, damped = [_frequency_line(page, name, frequency)], frequency.damped
    if damped is not None:
        ratio, left = _names_of_damped(page, name)
        unit = page.unit(Units.plain, "rad/s")
        lines.append(_solution(ratio, page.typeset(damped.ratio), final=True))
        lines.append(Equation(left, Root(page.typeset(damped.square)), final=True, unit=unit))
    return lines


def _names_of_damped(page: Page, name: Box) -> tuple[Box, Box]:
    """ζ and ω_d, with the number of the frequency if it has one."""
    ratio, frequency = page.notation.letter("ζ"), page.notation.letter("ω")
    if isinstance(name, Subscript):
        return Subscript(ratio, name.index), Subscript(frequency, Row((Name("d"), name.index)))
    return ratio, Subscript(frequency, Name("d"))


def _frequency_line(page: Page, name: Box, frequency: Frequency) -> Equation:
    """The frequency itself where its square is positive whatever the parameters are, else the square."""
    shown = page.typeset(frequency.square)
    if frequency.sign > 0 and size(frequency.square) <= _LONGEST_ROOT:
        return Equation(name, Root(shown), final=True, unit=page.unit(Units.plain, "rad/s"))
    return _solution(Power(name, Number("2")), shown, final=True, unit=page.unit(Units.plain, "1/s2"))


def _damped_in_numbers(page: Page, name: Box, frequency: Frequency) -> list[Text | Math]:
    damped = frequency.damped
    if damped is None or not math.isfinite(damped.ratio_number):
        return []
    ratio, left = _names_of_damped(page, name)
    found: list[Text | Math] = [Math(ratio), Text(f" = {damped.ratio_number:.4g}")]
    if damped.square_number > 0:
        found += [Text(", "), Math(left), Text(f" = {math.sqrt(damped.square_number):.4g} rad/s")]
    elif damped.ratio_number > 0:
        found.append(Text(": deviations return without swinging"))
    return [*found, Text("; ")]


def _in_numbers(name: Box, frequency: Frequency) -> list[Text | Math]:
    """Frequency, or growth, for the values of the model; each ends with a mark that the last one loses."""
    square = frequency.number
    if not math.isfinite(square):
        return []
    root = math.sqrt(abs(square))
    if square > 0:
        words = f" = {root:.4g} rad/s, {root / (2 * math.pi):.4g} Hz"
    elif square < 0:
        words = f"² = −{-square:.4g} 1/s²"
    else:
        words = " = 0: nothing holds this motion"
    if frequency.growth > 0:
        words += f", unstable: deviations grow by a factor of e in {1 / frequency.growth:.4g} s"
    return [Math(name), Text(words), Text("; ")]
