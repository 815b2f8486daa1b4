"""Helpers of the syntax tests: parsing with what was found, places marked in texts."""

from __future__ import annotations

import ast
from pathlib import Path

from choice import spread

from lagdsl.foundation.diagnostics import Diagnostic, Sink
from lagdsl.foundation.source import SourceFile
from lagdsl.language.syntax import nodes
from lagdsl.language.syntax.parser import parse, parse_expression

CORPUS = Path(__file__).parents[2] / "corpus" / "syntax"
MODELS = Path(__file__).parents[3] / "models"
# The format of every model is compared in tests/models.
TEXTS = sorted(CORPUS.glob("*.lag")) + spread(sorted(MODELS.glob("*.lag")), 12)


def parsed(text: str) -> tuple[nodes.Unit | None, tuple[Diagnostic, ...]]:
    sink = Sink()
    return parse(SourceFile("test.lag", text), sink), sink.diagnostics


def tree(text: str) -> nodes.Unit:
    unit, diagnostics = parsed(text)
    assert unit is not None, [(d.code, d.message) for d in diagnostics]
    return unit


def expression(text: str) -> nodes.Expression:
    sink = Sink()
    found = parse_expression(SourceFile("test.lag", text), sink)
    assert found is not None, [(d.code, d.message) for d in sink.diagnostics]
    return found


def statement(text: str) -> nodes.Item:
    """The first item of a model that holds `text`."""
    unit = tree(f"model M {text} end M;")
    model = unit.items[0]
    assert isinstance(model, nodes.Class)
    return model.items[0]


def equation(text: str) -> nodes.Item:
    """The first equation of a model whose `equation` section holds `text`."""
    model = tree(f"model M equation {text} end M;").items[0]
    assert isinstance(model, nodes.Class)
    return model.sections[0].items[0]


def unmarked(marked: str) -> tuple[str, list[tuple[int, int]]]:
    """The text without the marks `⟦` and `⟧`, and the places between them, in order of their beginnings."""
    text, places, begun = "", [], []
    for character in marked:
        if character == "⟦":
            begun.append(len(text))
        elif character == "⟧":
            places.append((begun.pop(), len(text)))
        else:
            text += character
    return text, sorted(places)


def places(diagnostics: tuple[Diagnostic, ...]) -> list[tuple[int, int]]:
    """Primary places."""
    return sorted((d.labels[0].span.start, d.labels[0].span.end) for d in diagnostics if d.labels)


def dump(value: object, indent: str = "") -> str:
    """The tree as text, a field a line."""
    match value:
        case nodes.Node():
            names = [name for kind in reversed(type(value).__mro__) for name in getattr(kind, "__slots__", ())]
            shown = [name for name in names if name != "span" and not name.endswith("_span")]
            fields = "".join(
                f"\n{indent}  {name}: {dump(getattr(value, name), indent + '  ')}"
                for name in shown
                if getattr(value, name) not in ((), None)
            )
            return type(value).__name__ + fields
        case tuple():
            return "".join(f"\n{indent}- {dump(part, indent + '  ')}" for part in value)
        case _:
            return ast.unparse(ast.Constant(value))
