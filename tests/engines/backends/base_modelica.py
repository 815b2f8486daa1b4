"""Base Modelica read by the grammar of its proposal, and evaluated: nothing of the backend takes part."""

from __future__ import annotations

import math
from collections.abc import Callable, Mapping
from functools import cache
from pathlib import Path
from typing import Any

from lark import Lark, Token, Tree

_CALLS: dict[str, Callable[..., float]] = {
    **{name: getattr(math, name) for name in ("sin", "cos", "tan", "asin", "acos", "atan", "atan2", "sinh", "cosh")},
    **{name: getattr(math, name) for name in ("tanh", "exp", "log", "sqrt", "floor", "ceil")},
    "mod": lambda x, y: x - math.floor(x / y) * y,
}
_RELATIONS: dict[str, Callable[[float, float], bool]] = {
    "<": lambda x, y: x < y,
    "<=": lambda x, y: x <= y,
    ">": lambda x, y: x > y,
    ">=": lambda x, y: x >= y,
}


@cache
def parser() -> Lark:
    grammar = (Path(__file__).parent / "base_modelica.lark").read_text(encoding="utf-8")
    return Lark(grammar, parser="lalr", start="base_modelica", keep_all_tokens=True)


class Model:
    """A parsed file: declarations with their attributes and values, equations `x = expression` by x."""

    def __init__(self, text: str) -> None:
        self.tree = parser().parse(text)
        self.prefixes: dict[str, str] = {}
        self.attributes: dict[str, dict[str, Any]] = {}
        self.values: dict[str, Any] = {}
        self.equations: dict[str, Any] = {}
        for element in self.tree.find_data("generic_element"):
            self._declare(element)
        for equation in self.tree.find_data("equation"):
            left, *rest = equation.children
            if len(rest) > 1 and isinstance(left, Tree) and left.data == "component_reference":
                self.equations[_words(left)] = rest[1]

    def _declare(self, element: Tree[Token]) -> None:
        prefix, kind, components = element.children
        for component in components.find_data("component_declaration"):  # type: ignore[union-attr]
            name = str(component.children[0])
            self.prefixes[name] = f"{_words(prefix)} {_words(kind)}".strip()
            arguments = component.find_data("argument")
            self.attributes[name] = {_words(each.children[0]): each.children[1].children[-1] for each in arguments}
            modification = component.children[1]
            if modification.data == "modification" and "=" in modification.children[:-1]:
                self.values[name] = modification.children[-1]

    def evaluate(self, names: list[str], given: Mapping[str, float]) -> list[float]:
        """Values of variables where those of `given` have these values, by their equations or declarations."""
        known: dict[str, float] = dict(given)

        def variable(name: str) -> float:
            if name not in known:
                known[name] = value(self.equations.get(name, self.values.get(name)))
            return known[name]

        def value(node: Any) -> float:
            return _evaluated(node, value, variable)

        return [variable(name) for name in names]


def _words(node: Any) -> str:
    return str(node) if isinstance(node, Token) else " ".join(filter(None, map(_words, node.children)))


def _evaluated(node: Any, value: Callable[[Any], float], variable: Callable[[str], float]) -> float:
    if isinstance(node, Token):
        return float(node)
    parts = node.children
    match node.data:
        case "component_reference":
            return variable(_words(node))
        case "factor":
            return value(parts[0]) ** value(parts[2])
        case "term" | "arithmetic_expression":
            return _chain(parts, value)
        case "relation":
            return float(_RELATIONS[str(parts[1])](value(parts[0]), value(parts[2])))
        case "logical_term" | "logical_expression" as kind:
            decide = all if kind == "logical_term" else any
            return float(decide(value(each) for each in parts[::2]))
        case "logical_factor":
            return float(not value(parts[-1]))
        case "if_expression":
            cases = zip(parts[1::4], parts[3::4], strict=False)
            return value(next((then for condition, then in cases if value(condition)), parts[-1]))
        case "primary":
            return _primary(parts, value)
    raise AssertionError(node.data)


def _chain(parts: list[Any], value: Callable[[Any], float]) -> float:
    signs = ("+", "-", "*", "/")
    operators = [str(each) for each in parts if isinstance(each, Token) and str(each) in signs]
    terms = [value(each) for each in parts if not (isinstance(each, Token) and str(each) in signs)]
    if len(operators) == len(terms):
        terms[0] = -terms[0] if operators.pop(0) == "-" else terms[0]
    total = terms[0]
    for operator, term in zip(operators, terms[1:], strict=True):
        match operator:
            case "+":
                total += term
            case "-":
                total -= term
            case "*":
                total *= term
            case _:
                total /= term
    return total


def _primary(parts: list[Any], value: Callable[[Any], float]) -> float:
    if str(parts[0]) == "(":
        return value(parts[1])
    if isinstance(parts[0], Token):
        return 1.0 if parts[0] == "true" else 0.0
    arguments = [value(each) for each in parts[1].children[1:-1:2]]
    return _CALLS[_words(parts[0])](*arguments)
