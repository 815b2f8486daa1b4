"""The page tells what moves the end of a motion, by the derivatives of `model.sensitivity`, or why it cannot."""

from __future__ import annotations

import re
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from choice import chosen
from page.browser import MOST_MILLISECONDS, NEEDED, Opened
from page.pages import MODELS, Elements, page_of
from page.test_live import answered, needs_node

from lagdsl import compile as compile_model
from lagdsl.documents.page.head import WORDS
from lagdsl.engines.runtime.structures import Status

# A stop time for each, and what its motion is differentiated by.
CASES = {
    "bouncing_ball": (2.0, ["h.start", "der(h).start"]),  # through three impacts
    "double_pendulum": (2.0, ["l1", "m2", "a.start", "der(b).start"]),
    "four_bar": (1.0, ["coupler.m", "crank.l", "rocker.l"]),  # a closed loop: lengths move the start
    "clutch": (3.0, ["J1", "J2"]),  # friction that sticks
}
GRAZING = """
model Grazing "Thrown up to a ceiling that it only touches, within every tolerance"
  coordinate Length h(der(start = 10.0000000001 m/s));
  mass 1 kg at {0, h};
  gravity = {0, -10 m/s2};
  contact ceiling: 5 m - h >= 0 with restitution = 0.5;
end Grazing;
"""
DELAYED = """
model Delayed
  coordinate Length x(start = 1 m);
  parameter Real k = 1;
  mass 1 kg at {x, 0};
  gravity = 0;
  force -k*(1 N/m)*delay(x, 0.1 s) on x;
end Delayed;
"""


@needs_node
@pytest.mark.parametrize("name", chosen(CASES, ("bouncing_ball", "four_bar")))
def test_derivatives_of_the_end_are_those_of_python(name: str, tmp_path: Path) -> None:
    stop, by = CASES[name]
    elements = Elements(page_of(name, stop))
    head = elements.head
    sliders = [each["name"] for each in head["parameters"]]
    width, answer = answered(elements, tmp_path, {}, by=[sliders.index(each) for each in by])
    assert answer["status"] == 0
    found = np.array(answer["derivatives"]).reshape(len(by), width)
    model = compile_model(MODELS / f"{name}.lag", engine="tape")
    columns = [*model.coordinates, *(f"der({each})" for each in model.coordinates)]
    expected = model.sensitivity(columns, by, stop=stop, tolerance=1e-10)
    names = [each["name"] for each in head["columns"]]
    own = found[:, [names.index(each) for each in columns]].T
    np.testing.assert_allclose(own, expected.derivatives, rtol=1e-6, atol=1e-6 * np.abs(expected.derivatives).max())
    assert np.any(own != 0.0)


@needs_node
def test_a_guard_that_is_only_touched_has_words_and_no_derivatives(tmp_path: Path) -> None:
    elements = Elements(page_of(GRAZING, 2.0))
    _, answer = answered(elements, tmp_path, {}, by=[0])
    assert answer["status"] == Status.GRAZING and answer["derivatives"] == []
    assert elements.head["words"][str(int(Status.GRAZING))] == WORDS[Status.GRAZING]
    assert answer["time"] == pytest.approx(1.0, abs=1e-3)


def test_the_head_says_where_there_are_no_derivatives() -> None:
    assert Elements(page_of("bouncing_ball", 2.0)).head["differentiable"]
    assert not Elements(page_of(DELAYED, 1.0)).head["differentiable"]


class TestInBrowser:
    pytestmark = NEEDED

    def test_the_strongest_come_first_and_follow_the_sliders(self, browser: Any, tmp_path: Path) -> None:
        path = tmp_path / "page.html"
        path.write_text(page_of("double_pendulum"), encoding="utf-8")
        opened = Opened(browser, path)
        page = opened.page
        page.wait_for_selector("html[data-influence]", timeout=MOST_MILLISECONDS, state="attached")
        page.get_by_label("The curve whose end moves").select_option("b")
        expected = compile_model(MODELS / "double_pendulum.lag").sensitivity("b", "l1, l2, m1, m2")
        rows = {row[0]: row for row in told(page)}
        for name, derivative, value in zip(expected.by, expected.derivatives[0], expected.values, strict=True):
            change = np.degrees(derivative * 0.01 * value)
            assert rows[name][1] == "1 %"
            assert float(rows[name][2].replace("−", "-").split()[0]) == pytest.approx(change, rel=6e-3)
        assert rows["a at the start"][1] == "1 deg" and rows["der(a) at the start"][1] == "1 rad/s"
        assert [row[1] for row in told(page)[-2:]] == ["1 rad/s", "1 rad/s"]  # a hundredth of zero is nothing
        sizes = [abs(float(row[2].replace("−", "-").split()[0])) for row in told(page)[:-2]]
        assert sizes == sorted(sizes, reverse=True)
        before = told(page)
        page.get_by_label("l1 in m").fill("0.6")
        page.get_by_label("l1 in m").press("Enter")
        page.wait_for_selector(".influences[aria-busy=true]", state="attached")
        page.wait_for_selector(".influences[aria-busy=false]", timeout=MOST_MILLISECONDS, state="attached")
        assert told(page) != before
        assert opened.faults == []
        page.close()

    @pytest.mark.parametrize(("text", "words"), [(GRAZING, "touches its border"), (DELAYED, "Delayed values have no")])
    def test_it_says_why_there_is_nothing_to_tell(self, text: str, words: str, browser: Any, tmp_path: Path) -> None:
        path = tmp_path / "page.html"
        path.write_text(page_of(text, 2.0), encoding="utf-8")
        opened = Opened(browser, path)
        found = opened.page.locator(".influences p")
        found.filter(has_text=re.compile(words)).wait_for(timeout=MOST_MILLISECONDS)
        assert told(opened.page) == []
        assert opened.faults == []
        opened.page.close()


def told(page: Any) -> list[list[str]]:
    """Name, amount and change of each row."""
    rows = [row.locator("th, td:not(.bar)").all_inner_texts() for row in page.locator(".influence tr").all()]
    return [[each.strip() for each in row] for row in rows]
