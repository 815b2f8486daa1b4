"""Flat expressions as text, in the syntax of the language, with no more parentheses than it needs."""

from __future__ import annotations

from typing import TypeAlias, assert_never

from lagdsl.language.flat import expression as fx
from lagdsl.language.flat.traversal import operands, postorder

# Precedence of the grammar, weakest first.
_CONDITIONAL, _OR, _AND, _NOT, _RELATION, _SUM, _PRODUCT, _SIGN, _POWER, _ATOM = range(10)

_BINARY_LEVEL = {"or": _OR, "and": _AND, "+": _SUM, "-": _SUM, "*": _PRODUCT, "/": _PRODUCT, "^": _POWER}
_BINARY_LEVEL.update(dict.fromkeys(("<", "<=", ">", ">=", "==", "<>"), _RELATION))

_AXES = "xyz"
_LONGEST = 20_000  # characters: expressions may share subexpressions, and then their text grows out of all proportion

_Text = tuple[str, int]

_Called: TypeAlias = (
    fx.Previous
    | fx.Derivative
    | fx.Function
    | fx.Norm
    | fx.Cross
    | fx.AngularVelocity
    | fx.MaterialVelocity
    | fx.Multiplier
    | fx.FrameReaction
    | fx.ReactionAlong
    | fx.SystemEnergy
    | fx.GeneralizedMomentum
    | fx.ForceBalance
    | fx.LinearMomentum
    | fx.AngularMomentum
    | fx.AdmissibleMotion
)


def flat_expression_text(expression: fx.FlatExpression) -> str:
    """The expression as the user would write it; parts beyond a length nobody reads are shown as `...`."""
    texts: dict[int, _Text] = {}
    for node in postorder(expression, texts):
        text, level = _text(node, [texts[id(operand)] for operand in operands(node)])
        texts[id(node)] = (text, level) if len(text) <= _LONGEST else ("...", _ATOM)
    return texts[id(expression)][0]


def number_text(value: float) -> str:
    """The shortest text that reads back as the same number: `9.81`, `2`, `1e-09`."""
    text = repr(float(value))
    return text.removesuffix(".0")


def _text(node: fx.FlatExpression, parts: list[_Text]) -> _Text:  # noqa: C901, PLR0912 one case per node
    match node:
        case fx.Number(value):
            text = number_text(value)
            return text, _SIGN if text.startswith("-") else _ATOM
        case fx.Variable(name) | fx.PointReference(name):
            return name, _RELATION if "<" in name or ">" in name else _ATOM
        case fx.Unary(operator, _):
            return _unary(operator, parts[0])
        case fx.Binary(operator, _, _):
            return _binary(operator, *parts)
        case fx.Dot():
            return _binary("*", *parts)
        case fx.Conditional():
            return _conditional(*parts)
        case fx.Component(_, axis):
            return f"{_within(parts[0], _ATOM)}.{_AXES[axis]}", _ATOM
        case fx.Vector():
            return f"{{{_list(parts)}}}", _ATOM
        case fx.FrameOrigin(frame):
            return f"{frame}.origin", _ATOM
        case fx.FrameAxis(frame, axis):
            return f"{frame}.{_AXES[axis]}", _ATOM
        case fx.Motion():
            return _motion(node, [text for text, _ in parts]), _ATOM
        case fx.RequiredForce(motion, place):
            return parts[0][0] if len(motion.coordinates) == 1 else f"{parts[0][0]}[{place + 1}]", _ATOM
        case (
            fx.Previous()
            | fx.Derivative()
            | fx.Function()
            | fx.Norm()
            | fx.Cross()
            | fx.AngularVelocity()
            | fx.MaterialVelocity()
            | fx.Mechanical()
        ):
            return _call(node, _list(parts)), _ATOM
        case _:
            assert_never(node)


def _call(node: _Called, arguments: str) -> str:  # noqa: C901, PLR0912 one case per node
    match node:
        case fx.Derivative():
            return f"der({arguments})"
        case fx.Previous(name, text):
            return f"pre({text or name})"
        case fx.Function(name, _):
            return f"{name}({arguments})"
        case fx.Norm():
            return f"norm({arguments})"
        case fx.Cross():
            return f"cross({arguments})"
        case fx.AngularVelocity(frame):
            return f"omega({frame})"
        case fx.MaterialVelocity(_, frame):
            return f"vel({arguments}, {frame})"
        case fx.Multiplier(row):
            return f"multiplier({row})"
        case fx.FrameReaction(frame, kind):
            return f"reaction({frame}).{kind}"
        case fx.ReactionAlong(point, _):
            return f"reaction({point}, along = {arguments})"
        case fx.SystemEnergy(kind):
            return {"total": "energy()", "jacobi": "jacobi_integral()"}.get(kind, f"{kind}_energy()")
        case fx.GeneralizedMomentum(coordinate):
            return f"momentum({coordinate})"
        case fx.ForceBalance(weights, ties, _):
            moved = [*(f"{weight:g}*{name}" for name, weight in weights), *(name for name, _ in ties)]
            return f"force({', '.join(moved)})"
        case fx.LinearMomentum():
            return "linear_momentum()"
        case fx.AngularMomentum(body, _):
            return f"angular_momentum({f'{body}, ' if body is not None else ''}about = {arguments})"
        case fx.AdmissibleMotion(_, coordinate):
            return f"d({arguments})/d({coordinate})"
        case _:
            assert_never(node)


def _motion(motion: fx.Motion, parts: list[str]) -> str:
    """The call; positions and rates that the state has are not written."""
    count = len(motion.coordinates)
    lists = [list(motion.coordinates), parts[2 * count : 2 * count + len(motion.accelerations)]]
    given = [each[0] if len(each) == 1 else f"{{{', '.join(each)}}}" for each in lists if each]
    own = tuple(map(fx.Variable, motion.coordinates))
    if motion.positions != own:
        given.append(f"positions = {{{', '.join(parts[:count])}}}")
    if motion.rates != tuple(map(fx.Derivative, own)):
        given.append(f"rates = {{{', '.join(parts[count : 2 * count])}}}")
    names = [name for name, _ in motion.parameters]
    given += [f"{name} = {text}" for name, text in zip(names, parts[len(parts) - len(names) :], strict=True)]
    return f"{motion.function}({', '.join(given)})"


def _unary(operator: str, operand: _Text) -> _Text:
    if operator == "not":
        return f"not {_within(operand, _RELATION)}", _NOT
    return f"-{_within(operand, _POWER)}", _SIGN


def _binary(operator: str, left: _Text, right: _Text) -> _Text:
    level = _BINARY_LEVEL[operator]
    if operator == "^":
        # A sign may stand in an exponent, and `^` associates to the right.
        exponent = right[0] if right[1] == _SIGN else _within(right, _POWER)
        return f"{_within(left, _ATOM)}^{exponent}", level
    spaced = f" {operator} " if level < _PRODUCT else operator
    # Relations do not chain; the others associate to the left.
    first = _within(left, level + 1 if level == _RELATION else level)
    return f"{first}{spaced}{_within(right, level + 1)}", level


def _conditional(condition: _Text, value: _Text, otherwise: _Text) -> _Text:
    return f"if {condition[0]} then {_within(value, _OR)} else {otherwise[0]}", _CONDITIONAL


def _within(part: _Text, level: int) -> str:
    return part[0] if part[1] >= level else f"({part[0]})"


def _list(parts: list[_Text]) -> str:
    return ", ".join(text for text, _ in parts)
