"""Texts of loops by templates: from the second turn on, a text is not elaborated where it leads to the same operations.

A template is made of what elaboration found in one turn, where that left nothing but the value behind: sums, products,
powers, calls of one argument and elements of arrays, whose checks depend on the types of their operands alone. Every
other text has none.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from functools import partial
from operator import itemgetter
from typing import Final

from lagdsl.language.flat import expression as flat
from lagdsl.language.semantics.operators.paths import designated
from lagdsl.language.semantics.scope.alike import follows, type_of
from lagdsl.language.semantics.scope.constants import BINARY, FUNCTIONS, NoValue, evaluate
from lagdsl.language.semantics.scope.context import Context
from lagdsl.language.semantics.scope.scope import Scope, Symbol
from lagdsl.language.semantics.scope.template import Element, Named, Number, Operation, Part, Step, Template
from lagdsl.language.semantics.scope.values import Scalar, Value, is_structural
from lagdsl.language.syntax import nodes

_ARITHMETIC: Final = frozenset(("+", "-", "*", "<", "<=", ">", ">=", "==", "<>", "and", "or"))
_EXTREMES: Final = frozenset(("min", "max"))


def by_template(ctx: Context, scope: Scope, node: nodes.Expression) -> Scalar | None:
    """The value of `node` in a turn of a loop; None where no template holds."""
    current = ctx.current
    for template in current.templates.known(node, scope, current.mode):
        indices = current.templates.indices(scope)
        if indices is not None and _made(ctx, scope, template, indices):
            whole, value = template.whole.step, template.whole.value
            return Scalar(whole.made, value.dimension, value.variability, value.order, value.kind)
    return None


def _made(ctx: Context, scope: Scope, template: Template, indices: Mapping[str, float]) -> bool:
    """True after all steps."""
    for condition, truth in template.whole.conditions.values():
        if (condition(indices) != 0.0) is not truth:
            return False
    for step in template.steps:
        if step.turn is scope:
            continue
        if type(step) is Operation:
            right = step.right
            step.made = step.make(step.left.made) if right is None else step.make(step.left.made, right.made)
        elif type(step) is Element or type(step) is Named:
            value = (
                _element(ctx, step, indices) if type(step) is Element else ctx.elaborate(ctx, scope, step.node, False)
            )
            if value is None or not step.type.has(value):
                return False
            assert isinstance(value, Scalar)
            step.made = value.expression
        step.turn = scope
    return True


def _element(ctx: Context, step: Element, indices: Mapping[str, float]) -> Value | None:
    chosen = []
    for number, extent in step.subscripts:
        index = number(indices)
        if not (1.0 <= index <= extent and index.is_integer()):
            return None
        chosen.append(int(index))
    return ctx.resolver.element(ctx, step.symbol, tuple(chosen), step.node.span)


# ---- making ----------------------------------------------------------------------------------------------------------


def keep_template(ctx: Context, scope: Scope, node: nodes.Expression, value: Scalar) -> None:
    """Keep the template of `node`, if it has one. Its elaboration gave `value` in this turn and left nothing else."""
    templates = ctx.current.templates
    indices = templates.indices(scope)
    if indices is None or not templates.are_wanted(node, scope, ctx.current.mode):
        return
    if templates.of is not scope:
        templates.of, templates.parts = scope, {}
    effects = ctx.effects
    found = _Making(ctx, scope, indices, templates.parts).part(node)
    if found is not None and ctx.effects == effects and found.value is value:
        steps = _steps(found.step)
        if steps:
            templates.keep(node, Template(steps, found))


def _steps(whole: Step) -> tuple[Step, ...]:
    """All that are made in a turn, each behind those that it needs."""
    found: dict[int, Step] = {}
    stack: list[tuple[Step, bool]] = [(whole, False)]
    while stack:
        step, ready = stack.pop()
        if ready:
            found.setdefault(id(step), step)
        elif step.turn is not None and id(step) not in found:
            stack.append((step, True))
            if isinstance(step, Operation):
                stack += [(each, False) for each in (step.right, step.left) if each is not None]
    return tuple(found.values())


class _Making:
    """The parts of a text in one turn."""

    def __init__(self, ctx: Context, scope: Scope, indices: Mapping[str, float], parts: dict[int, Part]) -> None:
        self._ctx, self._scope, self._indices, self._parts = ctx, scope, indices, parts
        self._common = ctx.current.common

    def part(self, node: nodes.Expression) -> Part | None:
        """None for a text that has no template."""
        node, number = self._spelled(node)
        if number is None:
            return None
        found = self._parts.get(number)
        if found is None:
            value = self._ctx.elaborate(self._ctx, self._scope, node, False)
            if not isinstance(value, Scalar) or value.is_nothing:
                return None
            if self._is_fixed(number):
                found = Part(Step(value.expression, None), value, {})
            else:
                found = self._by_index(node, value)
            if found is not None:
                self._parts[number] = found
        return found

    def _spelled(self, node: nodes.Expression) -> tuple[nodes.Expression, int | None]:
        """The text without parentheses, and the number of its spelling, if it has one."""
        while isinstance(node, nodes.Parenthesized):
            node = node.inner
        return node, self._common.number(node)

    def _is_fixed(self, number: int) -> bool:
        return self._common.names(number).isdisjoint(self._indices)

    def _by_index(self, node: nodes.Expression, value: Scalar) -> Part | None:
        if isinstance(node, nodes.Conditional):
            return self._conditional(node)
        if isinstance(value.expression, flat.Number):
            return None
        if isinstance(node, nodes.Index):
            return Part(self._index(node, value), value, {})
        if isinstance(node, nodes.Member):
            return Part(Named(value.expression, self._scope, node, type_of(value)), value, {})
        if isinstance(node, nodes.Binary):
            return self._binary(node, value)
        if isinstance(node, nodes.Unary):
            return self._unary(node, value)
        return self._call(node, value) if isinstance(node, nodes.Call) else None

    def _conditional(self, node: nodes.Conditional) -> Part | None:
        conditions: dict[int, tuple[Number, bool]] = {}
        taken = node.otherwise
        for branch in node.branches:
            number, condition = self._common.number(branch.condition), self._number(branch.condition)
            if number is None or condition is None:
                return None
            truth = condition(self._indices) != 0.0
            conditions[number] = condition, truth
            if truth:
                taken = branch.value
                break
        part = self.part(taken)
        return None if part is None else Part(part.step, part.value, {**conditions, **part.conditions})

    def _index(self, node: nodes.Index, value: Scalar) -> Step:
        ctx, scope, made, kind = self._ctx, self._scope, value.expression, type_of(value)
        target = self._common.number(node.target)
        if target is not None and self._is_fixed(target) and designated(ctx, scope, node) is None:
            symbol = designated(ctx, scope, node.target)
            shape = ctx.resolver.shape(ctx, symbol) if isinstance(symbol, Symbol) else None
            numbers = [each for node_ in node.subscripts if (each := self._subscript(node_)) is not None]
            if isinstance(symbol, Symbol) and shape is not None and len(shape) == len(numbers) == len(node.subscripts):
                return Element(made, scope, symbol, tuple(zip(numbers, shape, strict=True)), node, kind)
        return Named(made, scope, node, kind)

    def _binary(self, node: nodes.Binary, value: Scalar) -> Part | None:
        made = value.expression
        if not isinstance(made, flat.Binary) or made.operator != node.operator:
            return None
        left, right = self.part(node.left), self.part(node.right)
        if left is None or right is None or not follows(made.operator, left.value, right.value, value):
            return None
        if made.left != left.step.made or made.right != right.step.made:
            return None
        make = partial(flat.Binary, made.operator)
        step = Operation(made, self._scope, make, left.step, right.step)
        return Part(step, value, {**left.conditions, **right.conditions})

    def _unary(self, node: nodes.Unary, value: Scalar) -> Part | None:
        made, operand = value.expression, self.part(node.operand)
        if operand is None or not isinstance(made, flat.Unary) or made.operand != operand.step.made:
            return None
        return self._of_one(partial(flat.Unary, made.operator), operand, value)

    def _call(self, node: nodes.Call, value: Scalar) -> Part | None:
        made = value.expression
        if len(node.arguments) != 1 or isinstance(node.arguments[0], nodes.Named):
            return None
        operand = self.part(node.arguments[0])
        if operand is None or is_structural(operand.value):
            return None
        if isinstance(made, flat.Derivative) and made.operand == operand.step.made:
            return self._of_one(flat.Derivative, operand, value)
        if isinstance(made, flat.Function) and made.arguments == (operand.step.made,):
            return self._of_one(partial(_function, made.name), operand, value)
        return None

    def _of_one(self, make: Callable[..., flat.FlatExpression], operand: Part, value: Scalar) -> Part:
        return Part(Operation(value.expression, self._scope, make, operand.step, None), value, operand.conditions)

    # ---- numbers of the indices --------------------------------------------------------------------------------------

    def _subscript(self, node: nodes.Subscript) -> Number | None:
        return None if isinstance(node, nodes.Range | nodes.All) else self._number(node)

    def _number(self, node: nodes.Expression) -> Number | None:
        """The value of `node` as a function of the indices; None for a text that has more than arithmetic in it."""
        node, number = self._spelled(node)
        if number is None:
            return None
        if self._is_fixed(number):
            return self._constant(node)
        if isinstance(node, nodes.Reference):
            return itemgetter(node.name)
        if isinstance(node, nodes.Binary) and node.operator in _ARITHMETIC:
            return self._of_numbers(BINARY[node.operator], (node.left, node.right))
        if (
            isinstance(node, nodes.Call)
            and isinstance(node.function, nodes.Reference)
            and node.function.name in _EXTREMES
        ):
            return self._of_numbers(FUNCTIONS[node.function.name], node.arguments)
        return None

    def _constant(self, node: nodes.Expression) -> Number | None:
        value = self._ctx.elaborate(self._ctx, self._scope, node, False)
        if not isinstance(value, Scalar) or not is_structural(value):
            return None
        try:
            number = evaluate(value.expression)
        except NoValue:
            return None
        return lambda _: number

    def _of_numbers(
        self, function: Callable[..., float], nodes_: tuple[nodes.Expression | nodes.Named, ...]
    ) -> Number | None:
        parts = [None if isinstance(each, nodes.Named) else self._number(each) for each in nodes_]
        known = [each for each in parts if each is not None]
        if len(known) < len(parts):
            return None
        if len(known) == 2:
            one, two = known
            return lambda indices: function(one(indices), two(indices))
        return lambda indices: function(*(each(indices) for each in known))


def _function(name: str, argument: flat.FlatExpression) -> flat.Function:
    return flat.Function(name, (argument,))
