"""`if` around equations with a condition that is not known when compiling: one equation with an `if` for each quantity.

Every branch says what the same quantities are, so that there is one value for each whatever holds.
"""

from __future__ import annotations

from dataclasses import replace

from lagdsl.language.semantics.classes.equations import derivative_of
from lagdsl.language.semantics.scope.context import Context
from lagdsl.language.semantics.scope.scope import Entry, Instance, InstanceArray, Scope, Symbol, lookup
from lagdsl.language.syntax import nodes
from lagdsl.language.syntax.walk import descendants

SECTIONS = ("equation", "initial equation")
_VARYING = (
    "parameter",
    "coordinate",
    "state",
    "input",
    "discrete",
    "algebraic",
    "output",
    "contact",
    "friction",
    "constraint",
)
_NAMES = (nodes.Reference, nodes.Member, nodes.Index)


def is_open(scope: Scope, item: nodes.If) -> bool:
    """True if a condition names something that is not known when compiling."""
    return any(_varies(scope, node) for branch in item.branches for node in descendants(branch.condition))


def _varies(scope: Scope, node: nodes.Node) -> bool:
    if isinstance(node, nodes.Reference) and node.name == "time":
        return True
    found = _entry(scope, node)
    return isinstance(found, Symbol) and found.kind in _VARYING


def _entry(scope: Scope, node: nodes.Node) -> Entry | None:
    """The item that a name stands for. Reports nothing."""
    if isinstance(node, nodes.Reference):
        return lookup(scope, node.name)
    if isinstance(node, nodes.Member):
        around = _entry(scope, node.target)
        return around.scope.entries.get(node.name) if isinstance(around, Instance) else None
    array = _entry(scope, node.target) if isinstance(node, nodes.Index) else None
    return next(iter(array.elements.values()), None) if isinstance(array, InstanceArray) else None


def merged(ctx: Context, scope: Scope, item: nodes.If) -> list[nodes.Equation]:
    """The equations that say the same as the branches together; none after E0330 or E0386."""
    bodies = [branch.body for branch in item.branches]
    read = [_equations(ctx, scope, body) for body in (*bodies, item.otherwise or ())]
    if any(equations is None for equations in read):
        return []
    given = [{key: (side, value) for key, side, value, _ in equations or ()} for equations in read]
    words = [*(f"in the branch `{branch.condition.span.text}`" for branch in item.branches), "in an `else`"]
    made = []
    for equations in read:
        for key, side, _, equation in equations or ():
            lacking = [word for word, known in zip(words, given, strict=True) if key not in known]
            if lacking:
                ctx.sink.report("E0386", equation.span, name=side.span.text, where=" and ".join(lacking))
                _silence(scope, read)
                return []
    for key, side, _, equation in read[0] or ():
        values = [known[key][1] for known in given]
        branches = tuple(
            nodes.Branch(span=branch.span, condition=branch.condition, value=value)
            for branch, value in zip(item.branches, values, strict=False)
        )
        choice = nodes.Conditional(span=item.span, branches=branches, otherwise=values[-1])
        made.append(replace(equation, left=side, right=choice))
    return made


_Said = tuple[str, nodes.Expression, nodes.Expression, nodes.Equation]


def _equations(ctx: Context, scope: Scope, body: tuple[nodes.Item, ...]) -> list[_Said] | None:
    """Of each equation what it is about, that side, the other side; None after a diagnostic."""
    found: list[_Said] = []
    for item in body:
        if isinstance(item, nodes.Equation):
            about_right = not _is_name(item.left) and _is_name(item.right)
            side, value = (item.right, item.left) if about_right else (item.left, item.right)
            found.append(("".join(side.span.text.split()), side, value, item))
        elif isinstance(item, nodes.If) and is_open(scope, item):
            inner = merged(ctx, scope, item)
            found += [("".join(each.left.span.text.split()), each.left, each.right, each) for each in inner]
            if not inner:
                return None
        else:
            hint = "give the value of the item the condition: `force if c then F else 0 on x`"
            ctx.sink.report("E0330", item.span, what="an `if` around what is no equation", help=hint)
            return None
    return found


def _silence(scope: Scope, read: list[list[_Said] | None]) -> None:
    """Nothing more is said about what was meant to get its value here."""
    for equations in read:
        for _, side, _, _ in equations or ():
            target = derivative_of(side) or side
            found = _entry(scope, target.target if isinstance(target, nodes.Index) else target)
            if isinstance(found, Symbol) and not found.given.bindings and not found.given.derivatives:
                found.kind = "unknown"


def _is_name(node: nodes.Expression) -> bool:
    return isinstance(derivative_of(node) or node, _NAMES)
