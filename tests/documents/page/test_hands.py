"""Pages in the hands of somebody: keys, focus, a machine that is dragged, starts that cannot be, compared motions."""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path
from typing import Any

import pytest
from page.browser import MOST_MILLISECONDS, NEEDED, Opened
from page.pages import page_of

from lagdsl import compile as compile_model

playwright = pytest.importorskip("playwright.sync_api", reason="playwright is not installed: make page-check")
pytestmark = NEEDED
PENDULUM = """model Pendulum
  parameter Length l = 1 m;
  parameter Mass m = 1 kg;
  coordinate Angle theta(start = 90 deg);
  gravity = {0, -9.81 m/s2};
  point P = {l*sin(theta), -l*cos(theta)};
  mass m at P;
  output Length x = P.x;
  annotation(page(sliders = {theta, l}, curves = {x}), experiment(StopTime = 2));
end Pendulum;
"""
SAID, LEGEND, CLOCK = "#said", "#legend", ".clock"


@pytest.fixture(scope="module")
def opened(browser: Any, tmp_path_factory: pytest.TempPathFactory) -> Iterator[Opened]:
    """One page for all that leaves it as it was."""
    path = tmp_path_factory.mktemp("page") / "page.html"
    path.write_text(page_of(PENDULUM), encoding="utf-8")
    found = Opened(browser, path)
    found.page.keyboard.press("Space")
    yield found
    assert found.faults == []
    found.page.close()


def field(page: Any, name: str) -> float:
    return float(page.get_by_label(name, exact=True).input_value())


def integrated(page: Any) -> None:
    playwright.expect(page.locator(SAID)).to_contain_text("Integrated anew", timeout=MOST_MILLISECONDS)


def place_of_mass(page: Any) -> tuple[float, float]:
    """In the window: the mean of what is blue, the colour of masses."""
    found = page.evaluate("""() => {
        const from = document.querySelector('#stage canvas');
        const [width, height] = [from.clientWidth, from.clientHeight];
        const pen = Object.assign(document.createElement('canvas'), { width, height }).getContext('2d');
        pen.drawImage(from, 0, 0, width, height);
        const { data } = pen.getImageData(0, 0, width, height);
        let [x, y, n] = [0, 0, 0];
        for (let i = 0; i < data.length / 4; ++i) {
            if (data[4 * i + 2] > 2 * data[4 * i] + 40) { x += i % width; y += Math.floor(i / width); ++n; }
        }
        const bounds = from.getBoundingClientRect();
        return [bounds.x + x / n, bounds.y + y / n];
    }""")
    return found[0], found[1]


def test_the_page_begins_with_the_sliders_and_curves_of_its_annotation(opened: Opened) -> None:
    page = opened.page
    assert page.locator("#sliders > label").all_inner_texts() == ["theta\ndeg", "l\nm"]
    assert page.locator("#sliders > details:not(.influences):visible").count() == 2  # starts, parameters
    page.locator("#curves-tab").click()
    assert page.locator("#curves input:checked").count() == 1
    assert page.locator(".u-legend").first.inner_text().split()[-2:] != []
    page.locator("#sliders-tab").click()


def test_space_plays_whatever_has_the_focus(opened: Opened) -> None:
    page = opened.page
    play = page.locator("button.play")
    for focus in (
        "#curves-tab",
        "#sliders input[type=range]",
        "#sliders input[type=number]",
        "button:has(+ .menu)",
        "body",
    ):
        if focus == "body":
            page.evaluate("document.activeElement.blur()")
        else:
            page.locator(focus).first.focus()
        page.keyboard.press("Space")
        assert play.get_attribute("aria-label") == "Pause", focus
        page.keyboard.press("Space")
        assert play.get_attribute("aria-label") == "Play", focus
    assert page.locator("#sliders-panel").is_visible()  # no tab was pressed
    page.get_by_label("Time").focus()
    page.keyboard.press("Home")
    page.keyboard.press("ArrowRight")
    assert page.locator(CLOCK).inner_text() == "0.02 s"
    page.locator("#sliders input[type=range]").first.focus()
    before = field(page, "theta.start in deg")
    page.keyboard.press("ArrowRight")  # a slider keeps its arrows
    assert field(page, "theta.start in deg") > before
    assert page.locator(CLOCK).inner_text() == "0.02 s"
    page.get_by_role("button", name="Reset all").click()
    integrated(page)


def test_a_mass_is_dragged_to_its_start(opened: Opened) -> None:
    page = opened.page
    page.keyboard.press("Home")
    x, y = place_of_mass(page)
    pixels = page.evaluate("() => document.querySelector('#stage canvas').clientHeight")
    page.mouse.move(x, y)
    page.mouse.down()
    page.mouse.move(x - 0.1 * pixels, y + 0.2 * pixels, steps=4)
    page.mouse.up()
    page.mouse.move(20, 740)  # what is pointed at has another colour
    integrated(page)
    page.wait_for_timeout(300)
    angle = field(page, "theta.start in deg")
    assert 5.0 < angle < 85.0  # it went down and to the left
    # The mass is on its circle, where the line from the pin to the pointer meets it.
    there = place_of_mass(page)
    assert abs(there[0] - (x - 0.1 * pixels)) < 0.2 * pixels and there[1] > y
    page.get_by_role("button", name="Reset all").click()
    page.wait_for_timeout(300)
    assert field(page, "theta.start in deg") == 90.0


def test_two_motions_stand_side_by_side_and_behind_each_other(opened: Opened) -> None:
    page = opened.page
    page.keyboard.press("Home")
    shades = """() => {
        const from = document.querySelector('#stage canvas');
        const pen = Object.assign(document.createElement('canvas'), { width: 200, height: 100 }).getContext('2d');
        pen.drawImage(from, 0, 0, 200, 100);
        const { data } = pen.getImageData(0, 0, 200, 100);
        const blue = (i) => data[4 * i + 2] > 2 * data[4 * i] + 40;
        const all = [...Array(20000).keys()].filter(blue).map((i) => i % 200);
        return [all.filter((x) => x < 100).length, all.filter((x) => x >= 100).length];
    }"""
    ways = page.get_by_label("Keep this motion")
    ways.select_option("kept one beside")
    page.get_by_label("theta.start in deg", exact=True).fill("-90")
    page.get_by_label("theta.start in deg", exact=True).press("Enter")
    integrated(page)
    page.wait_for_timeout(600)
    left, right = page.evaluate(shades)
    assert left > 0 and right > 0
    ways.select_option("kept one behind")
    page.wait_for_timeout(600)
    left, right = page.evaluate(shades)
    assert left > 0 and right == 0  # the kept one, on the right, is pale
    ways.select_option("one motion")
    page.get_by_role("button", name="Reset all").click()
    integrated(page)


def test_ghosts_are_pale_and_go_again(opened: Opened) -> None:
    page = opened.page
    pale = """() => {
        const from = document.querySelector('#stage canvas');
        const pen = Object.assign(document.createElement('canvas'), { width: 200, height: 100 }).getContext('2d');
        pen.drawImage(from, 0, 0, 200, 100);
        const { data } = pen.getImageData(0, 0, 200, 100);
        return [...Array(20000).keys()].filter((i) => data[4 * i] > 150 && data[4 * i + 2] > data[4 * i] + 30).length;
    }"""
    page.keyboard.press("Home")
    found = []
    for _ in range(3):
        page.wait_for_timeout(600)
        found.append(page.evaluate(pale))
        page.keyboard.press("g")
    assert found[1] > 10 * max(found[0], found[2], 1)
    page.keyboard.press("g")


def test_it_is_presented_by_keys_alone(opened: Opened) -> None:
    page = opened.page
    page.keyboard.press("p")
    for name in ("#tools", "#panels", "header"):
        assert not page.locator(name).is_visible()
    size = page.locator(CLOCK).evaluate("clock => parseFloat(getComputedStyle(clock).fontSize)")
    assert size > 20.0
    page.keyboard.press("End")
    assert page.locator(CLOCK).inner_text() == "2.00 s"
    page.keyboard.press("p")
    assert page.locator("#panels").is_visible()


def test_the_text_has_the_colours_of_the_editor(opened: Opened) -> None:
    page = opened.page
    page.locator("#source-tab").click()
    words = {letter: page.locator(f".ink-{letter}").all_inner_texts() for letter in "knut"}
    assert (
        "parameter" in words["k"] and "Pendulum" in words["t"] and "90" in words["n"] and "deg" in "".join(words["u"])
    )
    text = "\n".join(page.locator(".line").all_text_contents()).replace("\u200b", "")
    assert text == PENDULUM
    page.locator("#sliders-tab").click()


def test_a_start_that_cannot_be_is_told_and_the_picture_grey(browser: Any, tmp_path: Path) -> None:
    """Events come from the motion that is integrated here, too."""
    path = tmp_path / "page.html"
    path.write_text(page_of("bouncing_ball"), encoding="utf-8")
    opened = Opened(browser, path)
    page = opened.page
    ticks = page.locator(".track .ticks i").count()
    height = page.get_by_label("h.start in m", exact=True)
    height.fill("0.5")
    height.press("Enter")
    integrated(page)
    more = page.locator(".track .ticks i")
    assert more.count() > 3 and more.count() != ticks
    assert "floor" in str(more.first.get_attribute("title"))
    height.fill("-0.5")
    height.press("Enter")
    playwright.expect(page.locator(SAID)).to_contain_text("This start cannot be.", timeout=MOST_MILLISECONDS)
    assert "`floor`" in page.locator(SAID).inner_text()
    assert page.locator("button.play").get_attribute("aria-label") == "Play"
    assert "grayscale" in page.locator("#stage canvas").evaluate("canvas => getComputedStyle(canvas).filter")
    page.get_by_role("button", name="Reset all").click()
    integrated(page)
    assert page.locator("#stage canvas").evaluate("canvas => getComputedStyle(canvas).filter") == "none"
    assert opened.faults == []
    page.close()


def test_it_works_in_a_frame_and_on_a_slide(browser: Any, tmp_path: Path) -> None:
    path = tmp_path / "page.html"
    path.write_text(page_of("double_pendulum"), encoding="utf-8")
    around = tmp_path / "slide.html"
    around.write_text('<iframe src="page.html#present" width="640" height="360"></iframe>', encoding="utf-8")
    page = browser.new_page()
    page.goto(around.as_uri())
    inside = page.frame_locator("iframe")
    inside.locator("html[data-ready]").wait_for(timeout=MOST_MILLISECONDS, state="attached")
    assert not inside.locator("#panels").is_visible()
    inside.locator("#stage canvas").click(position={"x": 5, "y": 5})
    page.keyboard.press("End")
    assert inside.locator(CLOCK).inner_text() == "5.00 s"
    assert inside.locator("html").evaluate("html => html.scrollHeight <= innerHeight && html.scrollWidth <= innerWidth")
    page.close()


def test_printed_formulas_fit_the_paper(browser: Any, tmp_path: Path) -> None:
    path = compile_model(Path("models/double_pendulum.lag").resolve()).show(tmp_path / "page.html", browser=False)
    page = Opened(browser, path, 700, 900).page
    page.emulate_media(media="print")
    wide = page.evaluate("""() => {
        const room = document.querySelector('#derivation').getBoundingClientRect().right + 1;
        const formulas = [...document.querySelectorAll('#derivation math')];
        return formulas.filter((each) => each.getBoundingClientRect().right > room).length;
    }""")
    assert wide == 0
    pages = page.pdf(format="A4").count(b"/Type /Page\n") or page.pdf(format="A4").count(b"/Type /Page ")
    assert 3 <= pages <= 8  # formulas break between their lines: no heading stands alone on a sheet
    page.close()


def test_a_dial_is_turned(browser: Any, tmp_path: Path) -> None:
    """The hand of a gauge stands upward at zero and turns with the pointer."""
    text = "model Wheel\n  coordinate Angle q;\n  kinetic 1/2*(1 kg.m2)*der(q)^2;\nend Wheel;\n"
    path = tmp_path / "page.html"
    path.write_text(page_of(text, 1.0), encoding="utf-8")
    page = Opened(browser, path).page
    page.keyboard.press("Space")
    canvas = page.locator("#stage canvas").bounding_box()
    assert canvas is not None
    x, y = place_of_mass(page)  # the hand is blue: its middle is half a radius above the center
    found = page.evaluate("() => document.querySelector('#stage canvas').clientHeight")
    page.mouse.move(x, y)
    page.mouse.down()
    page.mouse.move(x - 0.4 * found, y + 20, steps=4)
    page.mouse.up()
    integrated(page)
    page.wait_for_timeout(300)
    page.evaluate("document.querySelectorAll('#sliders details').forEach((each) => (each.open = true))")
    assert 45.0 < field(page, "q.start in deg") < 135.0
    page.close()
