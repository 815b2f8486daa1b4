"""The drawing of the system: directions by hand, loops that close, names that do no harm."""

from __future__ import annotations

import math
from html.parser import HTMLParser
from itertools import combinations
from pathlib import Path

import numpy as np
import pytest
from choice import chosen
from textbook.build import coordinate, mass, model, parameter, v, vec

from lagdsl.derivation.scene.forms import FINE
from lagdsl.derivation.scene.posed import matrix_of
from lagdsl.derivation.textbook.recipe import recipe
from lagdsl.documents.report.derivation import document, render
from lagdsl.documents.report.document import Drawing
from lagdsl.documents.report.figure.draw import outlines
from lagdsl.documents.report.figure.labels import width
from lagdsl.documents.report.marks import Arrow, Caption, Figure, Stroke
from lagdsl.documents.report.unicode_math import line
from lagdsl.foundation.diagnostics import Sink
from lagdsl.foundation.source import SourceFile
from lagdsl.language.flat.model import FlatModel
from lagdsl.motion.pipeline import flatten_file, read

_MODELS = Path(__file__).parents[3] / "models"


def flat_of(source: Path | str) -> FlatModel:
    sink = Sink()
    file = read(source, sink) if isinstance(source, Path) else SourceFile("<text>", source)
    assert file is not None
    flat = flatten_file(file, sink)
    assert flat is not None
    return flat


def drawn(flat: FlatModel) -> Figure:
    [found] = [block.figure for block in document(recipe(flat), drawn=True).blocks if isinstance(block, Drawing)]
    return found


def ways(figure: Figure, role: str) -> list[tuple[float, float]]:
    arrows = [mark for mark in figure.marks if isinstance(mark, Arrow) and mark.role == role]
    return [(a.points[-1][0] - a.points[0][0], a.points[-1][1] - a.points[0][1]) for a in arrows]


def test_a_pendulum_moves_across_its_rod() -> None:
    """At 60 degrees from the downward vertical: ∂r/∂θ along (cos 60°, sin 60°), the rod along (sin 60°, -cos 60°)."""
    figure = drawn(flat_of(_MODELS / "pendulum.lag"))
    [(x, y)] = ways(figure, "motion")
    assert math.degrees(math.atan2(y, x)) == pytest.approx(60, abs=0.2)
    [(down_x, down_y)] = ways(figure, "weight")
    assert down_x == 0
    assert down_y < 0
    [rod] = [mark for mark in figure.marks if isinstance(mark, Stroke) and mark.style == "rod"]
    (x0, y0), (x1, y1) = rod.points
    assert math.degrees(math.atan2(y1 - y0, x1 - x0)) == pytest.approx(-30, abs=0.2)


def test_motions_of_one_coordinate_have_one_scale() -> None:
    """The second bob of a double pendulum moves with a like the first one, with b across the second rod."""
    first, second, other = ways(drawn(flat_of(_MODELS / "double_pendulum.lag")), "motion")
    np.testing.assert_allclose(first, second, atol=0.11)
    turned = math.degrees(math.atan2(other[1], other[0]))
    assert turned == pytest.approx(-20, abs=0.2)


def test_a_force_has_its_direction_and_a_coordinate_its_sense() -> None:
    body = "coordinate Length x(start = -2 m); mass 1 kg at {x, 0}; gravity = 0; force {0, -3 N} at {x, 0};"
    figure = drawn(flat_of(f"model X {body} end X;"))
    [(x, y)] = ways(figure, "load")
    assert x == 0
    assert y < 0
    [(way, _)] = ways(figure, "coordinate")
    assert way < 0  # from its zero to the start on the left
    assert ways(figure, "motion")[0][0] > 0


def test_a_loop_is_drawn_closed() -> None:
    """Starts of four_bar do not close; the drawing shows the consistent ones: rods chain from pin to pin."""
    figure = drawn(flat_of(_MODELS / "four_bar.lag"))
    ends = [mark.points for mark in figure.marks if isinstance(mark, Stroke) and mark.style in ("rod", "thin")]
    near = [
        sum(math.dist(end, other) < 0.3 for points in ends for other in (points[0], points[-1]))
        for points in ends
        for end in (points[0], points[-1])
    ]
    assert min(near) >= 2


DRAWN = ("double_pendulum", "two_masses_and_spring", "elastic_pendulum")


@pytest.mark.parametrize("name", chosen(DRAWN, DRAWN[1:2]))
def test_labels_keep_apart_and_inside(name: str) -> None:
    figure = drawn(flat_of(_MODELS / f"{name}.lag"))
    named = [
        (mark.at, width(mark.label)) for mark in figure.marks if isinstance(mark, Arrow) and mark.label is not None
    ]
    assert len(named) >= 5
    for (x, y), wide in named:
        assert wide / 2 <= x <= figure.width - wide / 2
        assert 8 <= y <= figure.height - 8
    for ((x0, y0), one), ((x1, y1), other) in combinations(named, 2):
        assert abs(x1 - x0) >= (one + other) / 2 or abs(y1 - y0) >= 12


def test_a_machine_told_by_chapters_is_drawn() -> None:
    """A trolley below its rail and a load on its rope: two coordinates, two bodies by name, no admissible motions."""
    figure = drawn(flat_of(_MODELS / "crane_with_motor.lag"))
    assert {line(mark.label) for mark in figure.marks if isinstance(mark, Caption)} == {"trolley", "load"}
    assert len(ways(figure, "coordinate")) == 2
    assert ways(figure, "motion") == ways(figure, "weight") == []


def test_a_disc_is_a_ring_across_its_axis() -> None:
    """Of radius 2 m about x, its middle at (1, 2, 3) m: seen along its axis, within the flatness of its faces."""
    matrix = matrix_of(
        np.array([0.0, 2.0, 0.0]), np.array([0.0, 0.0, 2.0]), np.array([0.1, 0.0, 0.0]), np.arange(1.0, 4.0)
    )
    [ring] = outlines("drum", matrix, lambda point: point[1:])
    np.testing.assert_allclose([math.dist(point[1:], (2.0, 3.0)) for point in ring], 2.0, rtol=1e-6)
    assert len(ring) == FINE + 1 and np.all(ring[0] == ring[-1])


def test_no_mass_no_drawing() -> None:
    flat = flat_of("model X coordinate Charge q; kinetic 1/2*(1 H)*der(q)^2; end X;")
    assert not any(isinstance(block, Drawing) for block in document(recipe(flat), drawn=True).blocks)


class _Tags(HTMLParser):
    def __init__(self) -> None:
        super().__init__()
        self.seen: set[str] = set()

    def handle_starttag(self, tag: str, attrs: list[tuple[str, str | None]]) -> None:
        self.seen.add(tag)
        assert not any(name.startswith("on") for name, _ in attrs)


def test_names_are_text() -> None:
    name = '<script>x</script>"&'
    flat = model(
        "</svg><i>",
        parameters=[parameter(name, 1.5)],
        coordinates=[coordinate("</text><b>")],
        masses=[mass(v(name), vec(v("</text><b>"), 0))],
    )
    for form in ("html", "markdown", "latex"):
        assert "<script>" not in render(recipe(flat), form)  # type: ignore[arg-type]
    tags = _Tags()
    tags.feed(render(recipe(flat), "html"))
    assert "svg" in tags.seen
    assert not tags.seen & {"script", "i", "b"}
