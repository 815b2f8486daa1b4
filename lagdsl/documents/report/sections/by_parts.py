"""Step 5 of the recipe. Derivatives that would fill pages are written with the vectors of masses and bodies.

Of a mass, m v . v / 2 has the derivatives m v . dr/dq by the rate, since dv/dqd = dr/dq, and m v . dv/dq by the
coordinate; of a body the same with its angular momentum (Goldstein, Poole, Safko, *Classical Mechanics*, section 1.4).
"""

from __future__ import annotations

from collections.abc import Callable
from typing import Literal

from sympy import Expr

from lagdsl.derivation.textbook.contributions import Inertial
from lagdsl.derivation.textbook.recipe import CoordinateStep
from lagdsl.documents.report.boxes import Box, Bracket, Operator, Row, Sum
from lagdsl.documents.report.dimensions import Units
from lagdsl.documents.report.document import Block, Equation, Equations, Heading, Math, Paragraph, Text
from lagdsl.documents.report.names import indexed
from lagdsl.documents.report.notation import dotted
from lagdsl.documents.report.page import Page, partial

_DOT = Operator("·")
Terms = list[tuple[Literal["+", "-"], Box]]
Parts = Callable[[Page, CoordinateStep, Box, Inertial], Terms]


def derivatives(page: Page) -> list[Block]:
    blocks: list[Block] = [Heading("Lagrange's equations, term by term", "5")]
    for j, step in enumerate(page.derivation.coordinates):
        force = page.unit(Units.force, j)
        q, qd = page.notation.of(step.q), page.rate(step.q)
        momentum = partial(page.lagrangian, qd)
        rate, gradient = Row((page.by_time(), momentum)), partial(page.lagrangian, q)
        blocks.append(Paragraph((Text("Coordinate "), Math(q), Text(":"))))
        lines = (
            Equation(momentum, _written(page, step, step.momentum, _momentum), unit=page.unit(Units.momentum, j)),
            Equation(rate, _written(page, step, step.momentum_rate, _momentum_rate), unit=force),
            Equation(gradient, _written(page, step, step.gradient, _gradient), unit=force),
        )
        blocks.append(Equations(lines))
    return blocks


def is_by_parts(page: Page, expression: Expr) -> bool:
    """True if an expression fills pages and masses and bodies have all of the kinetic energy."""
    d = page.derivation
    carried = bool(d.inertials) and d.extra == 0 and all(each.kind != "kinetic" for each in page.flat.energies)
    return carried and not page.typeset.intermediates.reach(expression)


def _written(page: Page, step: CoordinateStep, expression: Expr, parts: Parts) -> Box:
    if not is_by_parts(page, expression):
        return page.typeset(expression)
    found = [term for label, item in page.inertial_elements() for term in parts(page, step, label, item)]
    if parts is _gradient:
        found.append(("-", partial(page.notation.letter("V"), page.notation.of(step.q))))
    return Sum(tuple(found))


def _momentum(page: Page, step: CoordinateStep, label: Box, item: Inertial) -> Terms:
    """m v . dr/dq + w . I . dw/dqd."""
    r, v, spin, inertia = _vectors(page, label)
    terms: Terms = []
    if any(item.velocity):
        terms.append(("+", Row((_mass(page, item), v, _DOT, partial(r, page.notation.of(step.q))))))
    if _turns(item):
        terms.append(("+", Row((spin, _DOT, inertia, _DOT, partial(spin, page.rate(step.q))))))
    return terms


def _momentum_rate(page: Page, step: CoordinateStep, label: Box, item: Inertial) -> Terms:
    """Its derivative by the time, where d/dt dr/dq = dv/dq."""
    r, v, spin, inertia = _vectors(page, label)
    q, turned = page.notation.of(step.q), partial(spin, page.rate(step.q))
    terms: Terms = []
    if any(item.velocity):
        both = Sum((("+", Row((dotted(v, 1), _DOT, partial(r, q)))), ("+", Row((v, _DOT, partial(v, q))))))
        terms.append(("+", Row((_mass(page, item), Bracket(both)))))
    if _turns(item):
        terms.append(("+", Row((dotted(spin, 1), _DOT, inertia, _DOT, turned))))
        terms.append(("+", Row((spin, _DOT, inertia, _DOT, page.by_time(), turned))))
    return terms


def _gradient(page: Page, step: CoordinateStep, label: Box, item: Inertial) -> Terms:
    """m v . dv/dq + w . I . dw/dq."""
    _, v, spin, inertia = _vectors(page, label)
    q = page.notation.of(step.q)
    terms: Terms = []
    if any(item.velocity):
        terms.append(("+", Row((_mass(page, item), v, _DOT, partial(v, q)))))
    if _turns(item):
        terms.append(("+", Row((spin, _DOT, inertia, _DOT, partial(spin, q)))))
    return terms


def _vectors(page: Page, label: Box) -> tuple[Box, Box, Box, Box]:
    """Position, velocity, angular velocity and inertia of a carrier."""
    r, v, spin = (indexed(page.vector_letter(letter), label) for letter in ("r", "v", "ω"))
    return r, v, spin, indexed(page.notation.letter("I", indexed=True), label)


def _mass(page: Page, item: Inertial) -> Box:
    shown = page.typeset(item.mass)
    return Bracket(shown) if isinstance(shown, Sum) else shown


def _turns(item: Inertial) -> bool:
    return item.frame is not None and any(item.spin)
