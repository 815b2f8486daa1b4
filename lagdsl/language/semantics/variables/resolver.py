"""Symbols get their values: on demand, so that declarations may stand in any order.

The symbols that a value uses are complete before the value itself; the order of completion is the order of the flat
model.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from itertools import product as cartesian
from typing import assert_never

from lagdsl.foundation.source import Span
from lagdsl.foundation.units.dimension import DIMENSIONLESS, LENGTH
from lagdsl.language.flat import expression as flat
from lagdsl.language.flat import model as flat_model
from lagdsl.language.flat.quantity import Variability
from lagdsl.language.semantics.items import labels
from lagdsl.language.semantics.operators.discontinuous import relation
from lagdsl.language.semantics.operators.geometry import as_point
from lagdsl.language.semantics.scope.constants import structural_integer
from lagdsl.language.semantics.scope.context import Context
from lagdsl.language.semantics.scope.instance_diagnostics import report_missing
from lagdsl.language.semantics.scope.limits import shape_fits
from lagdsl.language.semantics.scope.naming import element_name, kind_of
from lagdsl.language.semantics.scope.scope import LABELS, Binding, Indices, Symbol
from lagdsl.language.semantics.scope.values import (
    POISON,
    Array,
    FrameValue,
    Order,
    Poison,
    Scalar,
    Value,
    Vector,
    components,
    element_at,
    highest,
    latest,
    rank,
)
from lagdsl.language.semantics.types.bindings import Expected, bound
from lagdsl.language.semantics.types.quantity_fields import quantity_fields
from lagdsl.language.semantics.variables import parameters
from lagdsl.language.semantics.variables.attributes import sign_of
from lagdsl.language.semantics.variables.laws import Laws
from lagdsl.language.syntax import nodes

_BODY = "a body has no members: read the parameters that give its mass and inertia"


class Definitions(Laws):
    """The resolver: shapes and values of symbols, each made once."""

    # ---- shapes ------------------------------------------------------------------------------------------------------

    def shape(self, ctx: Context, symbol: Symbol) -> tuple[int, ...] | None:
        """The extents of a declared array, () for a scalar; None after a diagnostic."""
        if symbol.kind == "unknown":
            return None
        if symbol.kind in LABELS:
            ranks = list(symbol.made.labels)
            return tuple(max(indices[k] for indices in ranks) for k in range(len(ranks[0]))) if ranks else None
        if symbol.made.shape is None:
            with self.entered(ctx, symbol, None, symbol.span) as free:
                if free:
                    symbol.made.shape = self._declared_shape(ctx, symbol)
        return symbol.made.shape

    def _declared_shape(self, ctx: Context, symbol: Symbol) -> tuple[int, ...] | None:
        own = [(subscript, symbol.scope) for subscript in symbol.declarator.subscripts] if symbol.declarator else []
        extents: list[int] = []
        for position, part in enumerate([*own, *(symbol.info.shape if symbol.info is not None else ())]):
            if isinstance(part, int):
                extents.append(part)
                continue
            subscript, scope = part
            if isinstance(subscript, nodes.All):
                extent = self._bound_extent(ctx, symbol, position, subscript)
            elif isinstance(subscript, nodes.Range):
                ctx.sink.report("E0312", subscript.span, expected="an array size", found="a range")
                extent = None
            else:
                value = ctx.elaborate(ctx, scope, subscript, False)
                name = subscript.span.text
                extent = structural_integer(ctx, value, subscript, "E0301", name=name)
                if extent is not None and extent < 1:
                    what = f"the size of `{symbol.short}`"
                    ctx.sink.report("E0334", subscript.span, what=what, expected="positive", found=str(extent))
                    extent = None
            if extent is None:
                self.poison(symbol)
                return None
            extents.append(extent)
        if not shape_fits(ctx, symbol, tuple(extents)):
            self.poison(symbol)
            return None
        return tuple(extents)

    def _bound_extent(self, ctx: Context, symbol: Symbol, position: int, subscript: nodes.All) -> int | None:
        binding = symbol.given.bindings.get(None)
        if binding is None:
            ctx.sink.report("E0336", subscript.span, name=symbol.short)
            return None
        value = ctx.elaborate(ctx, binding.scope, binding.node, True)
        found = value.shape if isinstance(value, Array) else (3,) if isinstance(value, Vector) else ()
        if position < len(found):
            return found[position]
        if not isinstance(value, Poison):
            ctx.sink.report("E0312", binding.node.span, expected="an array", found=kind_of(value))
        return None

    # ---- values ------------------------------------------------------------------------------------------------------

    def whole(self, ctx: Context, symbol: Symbol, span: Span) -> Value:
        """The value of the plain name."""
        if symbol.kind in ("constraint", "contact", "friction", "body"):
            hint = _BODY if symbol.kind == "body" else f"its force is `multiplier({span.text})`"
            ctx.sink.report("E0219", span, name=symbol.short, what=f"the name of a {symbol.kind}", help=hint)
            return POISON
        shape = self.shape(ctx, symbol)
        if shape is None:
            return POISON
        if not shape:
            return self.element(ctx, symbol, (), span)
        return self.part(ctx, symbol, (), span)

    def part(self, ctx: Context, symbol: Symbol, chosen: Sequence[int | tuple[int, ...]], span: Span) -> Value:
        """A slice, one number or several for each leading subscript; no other element is made.

        So a row may be defined by the row before.
        """
        shape = self.shape(ctx, symbol) or ()
        full = [*chosen, *(tuple(range(1, extent + 1)) for extent in shape[len(chosen) :])]
        ways = [(found,) if isinstance(found, int) else found for found in full]
        cells = [self.element(ctx, symbol, indices, span) for indices in cartesian(*ways)]
        return self._array(ctx, symbol, cells, tuple(len(found) for found in full if not isinstance(found, int)), span)

    def _array(self, ctx: Context, symbol: Symbol, cells: list[Value], shape: tuple[int, ...], span: Span) -> Value:
        scalars: list[Scalar] = []
        width: tuple[int, ...] = ()
        for cell in cells:
            if isinstance(cell, Vector):
                parts, width = components(cell), (3,)
                scalars.extend(element_at(parts, k) for k in range(3))  # type: ignore[misc]
            elif isinstance(cell, Scalar):
                scalars.append(cell)
            elif isinstance(cell, Poison):
                return POISON
            else:
                ctx.sink.report("E0312", span, expected="one element", found=f"all of `{symbol.short}`")
                return POISON
        kinds = {cell.kind for cell in scalars}
        elements = tuple(cell.expression for cell in scalars)
        kind = kinds.pop() if len(kinds) == 1 else "Real"
        return Array(elements, (*shape, *width), scalars[0].dimension, latest(*scalars), highest(*scalars), kind)

    def element(self, ctx: Context, symbol: Symbol, indices: Indices, span: Span) -> Value:
        """The value of one element (indices () for a scalar), made when first asked for."""
        found = symbol.made.cells.get(indices)
        if found is not None:
            return found
        if symbol.kind in ("coordinate", "state", "input", "discrete") and not symbol.is_name:
            value: Value = self._variable(ctx, symbol, indices)
            symbol.made.cells[indices] = value
            if symbol.kind == "coordinate" and ctx.assembly is not None:
                ctx.assembly.is_computed(symbol)  # its definition comes before what reads it
            return value
        key = self._key(symbol, indices)
        with self.entered(ctx, symbol, key, span) as free:
            if not free:
                return POISON
            with ctx.current.standing():
                self._make(ctx, symbol, indices, key)
        if indices not in symbol.made.cells:
            if key is None:
                self.poison(symbol)
            else:
                for rest in every((self.shape(ctx, symbol) or ())[len(key) :]):
                    symbol.made.cells.setdefault((*key, *rest), POISON)
        return symbol.made.cells.setdefault(indices, POISON)

    def _key(self, symbol: Symbol, indices: Indices) -> Indices | None:
        """The part that is resolved at once: the element, the row of one binding, or (None) the whole array of a single
        binding."""
        if not indices or symbol.kind in LABELS:
            return indices
        leading = (indices[:length] for length in range(len(indices), 0, -1))
        return next((key for key in leading if key in symbol.given.bindings), None)

    def _variable(self, ctx: Context, symbol: Symbol, indices: Indices) -> Value:
        if symbol.kind == "unknown" or symbol.info is None:
            return POISON
        dimension = symbol.info.dimension or DIMENSIONLESS
        variable = flat.Variable(element_name(symbol.name, indices))
        if symbol.kind == "discrete":
            return Scalar(variable, dimension, Variability.DISCRETE, Order.STILL, symbol.info.base)
        if symbol.kind == "input" and symbol.info.base == "Boolean":
            return _truth_of_input(ctx, symbol, variable)
        order = Order.GIVEN if symbol.kind == "input" else Order.CONFIGURATION
        variability = Variability.CONTINUOUS if symbol.info.base == "Real" else Variability.DISCRETE
        return Scalar(variable, dimension, variability, order, symbol.info.base)

    # ---- one symbol --------------------------------------------------------------------------------------------------

    def _make(self, ctx: Context, symbol: Symbol, indices: Indices, key: Indices | None) -> None:
        match symbol.kind:
            case "constant" | "structural" | "parameter":
                parameters.make(ctx, symbol, self.shape(ctx, symbol) or (), key)
            case "algebraic" | "output" | "input":
                self._define(ctx, symbol, indices, key)
            case "point":
                symbol.made.cells[indices] = self._point(ctx, symbol, indices)
            case "frame":
                symbol.made.cells[indices] = self._frame(ctx, symbol, indices)
            case "energy" | "load" | "invariant":
                symbol.made.cells[indices] = labels.value(ctx, symbol, indices)
            case "state" | "discrete" | "coordinate" | "constraint" | "contact" | "friction" | "body" | "unknown":
                symbol.made.cells[indices] = POISON
            case _:
                assert_never(symbol.kind)

    def _missing(self, ctx: Context, symbol: Symbol, indices: Indices) -> None:
        """E0318 for the element or, where no element has a value, once for all."""
        if symbol.given.bindings:
            report_missing(ctx, "E0318", symbol, element_name(symbol.short, indices))
        else:
            report_missing(ctx, "E0318", symbol, symbol.short)
            self.poison(symbol)

    def _binding(self, symbol: Symbol, key: Indices | None) -> Binding | None:
        return symbol.given.bindings.get(key) or (symbol.given.bindings.get(None) if not key else None)

    def _define(self, ctx: Context, symbol: Symbol, indices: Indices, key: Indices | None) -> None:
        """An algebraic variable or an output."""
        binding = self._binding(symbol, key)
        shape = self.shape(ctx, symbol)
        if binding is None:
            given = ctx.assembly.quantity(symbol, indices) if ctx.assembly is not None else None
            if given is not None:
                symbol.made.cells[indices] = given
            else:
                self._missing(ctx, symbol, indices)
        if binding is None or shape is None or symbol.info is None:
            return
        part = shape[len(key or ()) :]
        # A plain `Real` variable is of the dimension of its binding; what an input is says its class.
        dimension = DIMENSIONLESS if symbol.kind == "input" else None
        dimension = symbol.info.dimension or dimension
        expected = Expected(f"`{symbol.short}`", dimension, part, symbol.info.base, symbol.info.unit)
        value = bound(ctx, binding.scope, binding.node, expected)
        if isinstance(value, Scalar):
            symbol.made.cells[indices] = self._named(ctx, symbol, indices, value)
        elif isinstance(value, Array):
            for position, rest in enumerate(every(part)):
                cell = Scalar(value.elements[position], value.dimension, value.variability, value.order, value.kind)
                each = (*(key or ()), *rest)
                symbol.made.cells[each] = self._named(ctx, symbol, each, cell)

    def _named(self, ctx: Context, symbol: Symbol, indices: Indices, value: Scalar) -> Scalar:
        """The reference to a definition; outputs and what needs the solved motion are read as their expression."""
        dimension = value.dimension if value.dimension is not None else DIMENSIONLESS
        value = replace(value, dimension=dimension, is_nothing=False)
        unused_port = symbol.kind == "input" and value.expression == flat.ZERO
        if symbol.kind == "output" or unused_port:
            return value
        fields = quantity_fields(symbol, indices, sign_of(ctx, symbol), dimension)
        variability = max(value.variability, Variability.PARAMETER, key=rank)
        definition = flat_model.Definition(**fields, value=value.expression, variability=variability)
        if value.order >= Order.ACCELERATION:
            ctx.product.observed.append(definition)
            return value
        ctx.product.named.append(definition)
        return replace(value, expression=flat.Variable(fields["name"]), variability=variability)

    def _point(self, ctx: Context, symbol: Symbol, indices: Indices) -> Value:
        binding = symbol.given.bindings.get(indices)
        name = element_name(symbol.name, indices)
        if binding is None:
            position = self._row(ctx, symbol, indices)
        else:
            value = ctx.elaborate(ctx, binding.scope, binding.node, True)
            position = as_point(ctx, binding.scope, binding.node, value)
        if position is None:
            return POISON
        spans = (symbol.span if binding is None else binding.span, *symbol.scope.spans)
        doc = symbol.declarator.doc if symbol.declarator is not None else None
        ctx.product.named.append(flat_model.Point(spans=spans, name=name, position=position.expression, doc=doc))
        dimension = ctx.conventions.dimension(LENGTH)
        return Vector(flat.PointReference(name), dimension, position.variability, position.order)

    def _row(self, ctx: Context, symbol: Symbol, indices: Indices) -> Vector | None:
        """One point of an array of points with one binding for all: `point P[2] = {{0, 0}, {l, 0}}`."""
        binding = symbol.given.bindings.get(None)
        if binding is None:
            self._missing(ctx, symbol, indices)
            return None
        value = ctx.elaborate(ctx, binding.scope, binding.node, True)
        if not isinstance(value, Array) or len(value.shape) != 2 or value.shape[:1] != symbol.made.shape:
            if not isinstance(value, Poison):
                count = " by ".join(str(extent) for extent in symbol.made.shape or ())
                wanted, found = f"an array of {count} points", kind_of(value)
                what = f"`{symbol.short}`"
                ctx.sink.report("E0334", binding.node.span, what=what, expected=wanted, found=found)
            self.poison(symbol)
            return None
        part = element_at(value, indices[0] - 1)
        return as_point(ctx, binding.scope, binding.node, part)

    def _frame(self, ctx: Context, symbol: Symbol, indices: Indices) -> Value:
        binding = symbol.given.bindings.get(indices)
        name = element_name(symbol.name, indices)
        if binding is None:
            placed = ctx.assembly.frame(symbol, indices) if ctx.assembly is not None else None
            if placed is None:
                self._missing(ctx, symbol, indices)
            return placed if placed is not None else POISON
        value = ctx.elaborate(ctx, binding.scope, binding.node, False)
        if not isinstance(value, FrameValue):
            if not isinstance(value, Poison):
                ctx.sink.report("E0312", binding.node.span, expected="a frame", found=kind_of(value))
            return POISON
        spans = (binding.span, *symbol.scope.spans)
        doc = symbol.declarator.doc if symbol.declarator is not None else None
        frame = flat_model.Frame(spans=spans, name=name, parent=value.name, steps=value.steps, doc=doc)
        ctx.product.named.append(frame)
        return FrameValue(name, (), value.variability, value.order)


def _truth_of_input(ctx: Context, symbol: Symbol, variable: flat.Variable) -> Scalar:
    """A Boolean input is a number, 0 or 1, to those who give it; where it changes is an event."""
    above = flat.Binary(">=", flat.Binary("-", variable, flat.Number(0.5)), flat.ZERO)
    spans = (symbol.span, *symbol.scope.spans)
    truth = relation(ctx, spans, f"input {variable.name}", above, DIMENSIONLESS, Order.GIVEN)
    return Scalar(truth, DIMENSIONLESS, Variability.DISCRETE, Order.STILL, "Boolean")


def every(shape: tuple[int, ...]) -> list[Indices]:
    """All 1-based indices of an array, in row-major order."""
    return list(cartesian(*(range(1, extent + 1) for extent in shape)))
