"""Trees of texts with errors: the statements that were understood."""

from pathlib import Path

import pytest
from choice import spread

from lagdsl.foundation.diagnostics import Sink
from lagdsl.foundation.source import SourceFile
from lagdsl.language.syntax import nodes
from lagdsl.language.syntax.parser import parse, parse_recovered

MODELS = sorted((Path(__file__).parents[3] / "models").glob("*.lag"))


def _recovered(text: str) -> tuple[nodes.Unit | None, Sink]:
    sink = Sink()
    return parse_recovered(SourceFile("<text>", text), sink), sink


@pytest.mark.parametrize("path", spread(MODELS, 6), ids=lambda path: path.stem)
def test_a_text_without_errors_has_the_same_tree(path: Path) -> None:
    text = path.read_text(encoding="utf-8")
    unit, sink = _recovered(text)
    assert not sink.has_errors
    assert unit == parse(SourceFile("<text>", text), Sink())


@pytest.mark.parametrize("path", spread(MODELS, 4), ids=lambda path: path.stem)
def test_a_beginning_has_a_tree_of_its_complete_statements(path: Path) -> None:
    text = path.read_text(encoding="utf-8")
    whole, _ = _recovered(text)
    assert whole is not None
    for length in range(0, len(text), 29):
        unit, _ = _recovered(text[:length])
        assert unit is not None
        for one, other in zip(unit.items, whole.items, strict=False):
            if isinstance(one, nodes.Class):
                assert isinstance(other, nodes.Class)
                complete = [item for item in other.items if item.span.end <= length]
                assert list(one.items[: len(complete)]) == complete


def test_open_blocks_are_closed_from_inside() -> None:
    unit, sink = _recovered(
        "model A\n  for i in 1:3 loop\n    Real x[i] = i;\n    if true then\n      Real y = 1;\n      Real z ="
    )
    assert sink.has_errors
    assert unit is not None
    (model,) = unit.items
    assert isinstance(model, nodes.Class)
    (loop,) = model.items
    assert isinstance(loop, nodes.For)
    assert [type(item) for item in loop.body] == [nodes.Component, nodes.If]
