"""Checks of dimensions and what they report; the words are in the catalog."""

from __future__ import annotations

import re
from collections.abc import Iterator
from itertools import combinations_with_replacement

from lagdsl.foundation.diagnostics import Label
from lagdsl.foundation.diagnostics.catalog import ROWS
from lagdsl.foundation.diagnostics.catalog.dimensions import BESIDE, MISSING_FACTOR
from lagdsl.foundation.units import Dimension
from lagdsl.foundation.units.dimension import DIMENSIONLESS
from lagdsl.foundation.units.dimension import dimension as dimension_of
from lagdsl.foundation.units.naming import base_text, describe, unit_text
from lagdsl.foundation.units.parse import parse_unit
from lagdsl.foundation.units.written import literal_of
from lagdsl.language.semantics.scope import prelude
from lagdsl.language.semantics.scope.context import Context
from lagdsl.language.semantics.scope.naming import quantity
from lagdsl.language.semantics.scope.scope import Scope, Symbol, lookup
from lagdsl.language.semantics.scope.values import AnyDimension
from lagdsl.language.semantics.types.missing_units import unit_help
from lagdsl.language.syntax import nodes
from lagdsl.language.syntax.walk import descendants

_MOST_TYPES = 3
_LONGEST = 40  # characters of a literal before an exponent
_POWER = re.compile(r"(?<![A-Za-z0-9_.])([0-9]+(?:\.[0-9]+)?)d([-+])$")
_EXPONENT = re.compile(r"(?<![A-Za-z0-9_.])[0-9]+(?:\.[0-9]+)?[ \t]*[A-Za-z][A-Za-z./0-9^]*-$")


def fits(left: AnyDimension, right: AnyDimension) -> bool:
    return left is None or right is None or left == right


def joined(left: AnyDimension, right: AnyDimension) -> AnyDimension:
    return left if left is not None else right


def product(left: AnyDimension, right: AnyDimension) -> Dimension:
    return (left or DIMENSIONLESS) * (right or DIMENSIONLESS)


def quotient(left: AnyDimension, right: AnyDimension) -> Dimension:
    return (left or DIMENSIONLESS) / (right or DIMENSIONLESS)


def bare_number(node: nodes.Node) -> str | None:
    """The spelling of a number without a unit, sign included; None for any other expression."""
    sign = ""
    while isinstance(node, nodes.Unary | nodes.Parenthesized):
        if isinstance(node, nodes.Unary):
            sign += node.operator if node.operator == "-" else ""
            node = node.operand
        else:
            node = node.inner
    return f"{sign}{node.text}" if isinstance(node, nodes.Number) else None


def _report_bare(ctx: Context, node: nodes.Node, bare: str, what: str, words: str, unit: str) -> None:
    """E0405; right behind a unit and a sign the number is an exponent: `1d-3`, `9.81 ms-2`."""
    before = node.span.file.text[max(node.span.start - _LONGEST, 0) : node.span.start]
    way = None
    if power := _POWER.search(before):
        way = f"powers of ten are written with `e`: `{power[1]}e{power[2]}{node.span.text}`"
    elif exponent := _EXPONENT.search(before):
        way = f"a negative exponent stands behind `^`: `{exponent[0][:-1]}^-{node.span.text}`"
    if way is None:
        ctx.sink.report("E0405", node.span, number=bare, preposition=what, words=words, unit=unit)
    else:
        texts = {"number": bare, "preposition": what, "words": words, "unit": unit}
        ctx.sink.report("E0405", node.span, help=way, edit=None, notes=(), **texts)


def report_unequal(
    ctx: Context,
    verb: str,
    scope: Scope,
    left: tuple[nodes.Node, AnyDimension],
    right: tuple[nodes.Node, AnyDimension],
) -> None:
    """E0401 or, where one side is a bare number, E0405."""
    for (node, _), (_, other) in ((left, right), (right, left)):
        bare = bare_number(node)
        if bare is not None and other is not None:
            what = BESIDE.get(verb, BESIDE[""])
            unit = unit_text(other)
            words = describe(other)
            _report_bare(ctx, node, bare, what, words, unit)
            return
    first, second = left[1] or DIMENSIONLESS, right[1] or DIMENSIONLESS
    ctx.sink.report(
        "E0401",
        Label(right[0].span, f"this is {quantity(second)}"),
        Label(left[0].span, f"this is {quantity(first)}"),
        notes=(*hidden_variables(scope, left[0]), *hidden_variables(scope, right[0])),
        help=unit_help(right[0], second, first) or unit_help(left[0], first, second) or _missing(scope, first, second),
        verb=verb,
        left=describe(first),
        right=describe(second),
    )


def _missing(scope: Scope, left: Dimension, right: Dimension) -> str | None:
    """A missing factor, from the parameters of the class."""
    for short, other, which in ((right, left, "second"), (left, right, "first")):
        factor = _factor(scope, other / short)
        if factor is not None:
            unit = base_text(other / short)
            return MISSING_FACTOR.format(which=which, unit=unit, factor=factor, words=describe(other))
    return None


def _factor(scope: Scope, ratio: Dimension) -> str | None:
    known = list(_parameters(scope))
    for name, dimension in known:
        if dimension == ratio:
            return name
    for (first, one), (second, two) in combinations_with_replacement(known, 2):
        if one * two == ratio:
            return f"{first}^2" if first == second else f"{first}*{second}"
    return None


def _parameters(scope: Scope) -> Iterator[tuple[str, Dimension]]:
    for name, entry in scope.owner.entries.items():
        if isinstance(entry, Symbol) and entry.kind in ("parameter", "constant"):
            info = entry.info
            if info is not None and info.dimension and not info.dimension.is_dimensionless and not info.shape:
                yield name, info.dimension
    if lookup(scope, "g_n") is None:
        yield "g_n", prelude.CONSTANTS["g_n"].dimension


def hidden_variables(scope: Scope, *roots: nodes.Node) -> tuple[str, ...]:
    """N0106: unit literals in the text whose unit could be read as a product of variables of the model."""
    notes: list[str] = []
    for node in (node for root in roots for node in descendants(root)):
        if isinstance(node, nodes.Quantity):
            names = re.findall(r"[A-Za-z]+", node.unit)
            if all(isinstance(lookup(scope, name), Symbol) for name in names):
                listed = " and ".join(f"`{name}`" for name in dict.fromkeys(names))
                powers = re.sub(r"([A-Za-z])\^?(-?[0-9])", r"\1^\2", node.unit).replace(".", "*")
                meant = f"{node.number}*{powers}" if not powers.startswith("/") else f"{node.number}{powers}"
                literal = f"{node.number} {node.unit}"
                notes.append(ROWS["N0106"].message.format(literal=literal, names=listed, meant=meant))
    return tuple(dict.fromkeys(notes))


def _declared_help(found: AnyDimension) -> str | None:
    """Help of E0407: the types of the value, one for each unit that they have."""
    units: dict[str, str] = {}
    for name, each in prelude.TYPES.items():
        if each.base == "Real" and not each.shape and each.dimension == found:
            units.setdefault(each.unit, f"`{name}`")
    names = " or ".join(list(units.values())[:_MOST_TYPES])
    return f"declare it as {names}, or check the formula of the value" if names else None


def require(
    ctx: Context,
    scope: Scope,
    node: nodes.Node,
    found: AnyDimension,
    expected: Dimension,
    code: str,
    /,
    help: str | None = None,
    **words: str,
) -> bool:
    """Report `code` (with `expected` and `found` in words) unless the dimension is the expected one."""
    wanted = ctx.conventions.dimension(expected)
    if fits(found, wanted):
        return True
    if isinstance(node, nodes.Array):
        # The element at fault is a better place than the whole vector.
        numbers = [part for part in node.elements if (bare_number(part) or "0").strip("-0.")]
        node = numbers[0] if numbers else node
    bare = bare_number(node)
    if bare is not None:
        unit = unit_text(wanted)
        ctx.sink.report("E0405", node.span, number=bare, preposition="used as", words=describe(wanted), unit=unit)
    else:
        notes = hidden_variables(scope, node)
        literal = literal_of(node.span.text) if help is None else None
        if literal is not None and parse_unit(literal.partition(" ")[2]).dimension == wanted:
            help = f"a unit stands behind its number: `{literal}`"
        if wanted == dimension_of(K=1) and isinstance(node, nodes.Quantity) and node.unit == "C":
            help = f"`C` is the coulomb: did you mean `{node.number} degC`?"
        help = help or unit_help(node, found, wanted)
        if help is None and code == "E0407":
            help = _declared_help(found)
        texts = {"expected": quantity(wanted), "found": quantity(found), **words}
        ctx.sink.report(code, node.span, notes=notes, help=help, edit=None, **texts)
    return False
