"""Pages in a real browser: they ask for nothing, show something, and every control does its work."""

from __future__ import annotations

from pathlib import Path
from typing import Any
from xml.etree import ElementTree

import pytest
from choice import chosen
from meshes.solids import binary_stl
from page.browser import MOST_MILLISECONDS, NEEDED, Opened
from page.pages import MODELS, page_of
from PIL import Image

from lagdsl import compile as compile_model
from lagdsl.documents.page.modes import modes_page
from lagdsl.interfaces.api.shown import framed

playwright = pytest.importorskip("playwright.sync_api", reason="playwright is not installed: make page-check")
pytestmark = NEEDED
EVERY = sorted(path.relative_to(MODELS).with_suffix("").as_posix() for path in MODELS.rglob("*.lag"))


@pytest.mark.parametrize("name", chosen(EVERY, ("double_pendulum",)))
def test_every_page_is_shown_and_asks_for_nothing(name: str, browser: Any, tmp_path: Path) -> None:
    path = tmp_path / "page.html"
    path.write_text(page_of(name), encoding="utf-8")
    opened = Opened(browser, path)
    assert opened.ready() == "live"
    assert opened.colors() > 3
    forces = opened.page.get_by_role("button", name="forces", exact=True)
    if forces.count():
        forces.click()
        assert forces.get_attribute("aria-pressed") == "false"
    bar = opened.page.locator("#sliders input[type=range]").first
    if bar.count():
        bar.evaluate("bar => { bar.value = 520; bar.dispatchEvent(new Event('input')); }")
        playwright.expect(opened.page.locator("#said")).not_to_be_empty(timeout=MOST_MILLISECONDS)
    assert opened.faults == []
    opened.page.close()


def test_every_control_does_its_work(browser: Any, tmp_path: Path) -> None:
    path = tmp_path / "page.html"
    path.write_text(page_of("four_bar"), encoding="utf-8")
    opened = Opened(browser, path)
    page = opened.page
    clock = page.locator(".clock")
    page.keyboard.press("Space")  # it plays from the beginning: now it rests
    page.keyboard.press("Home")
    assert clock.inner_text() == "0.00 s"
    page.keyboard.press("ArrowRight")
    assert clock.inner_text() == "0.05 s"
    page.keyboard.press("End")
    assert clock.inner_text() == "5.00 s"
    for tab in page.locator("[name=panel]").all():
        tab.click()
        panel = page.locator(f".tab:has(#{tab.get_attribute('id')}) + .panel")
        assert panel.is_visible()
        assert page.locator(".panel:visible").count() == 1
    for name in ("frames", "fit", "ghosts", "keys"):
        page.get_by_role("button", name=name, exact=True).click()
    for name in ("v", "a", "∂r/∂q", "reactions"):
        page.get_by_role("button", name=name, exact=True).click()
    page.wait_for_selector("html[data-arrows]", timeout=MOST_MILLISECONDS, state="attached")
    assert "reaction: longest" in page.locator("#legend").inner_text()
    assert "torque" not in page.locator("#legend").inner_text()  # pins: a rounding of forces is no torque
    assert "longest ∂r/∂A.q: " in page.locator("#legend").inner_text()
    page.get_by_label("The coordinate that moves").select_option("A.q")
    speeds = page.get_by_role("button", name="v", exact=True)
    for key in ("+", "-", "g", "v", "f"):
        page.keyboard.press(key)
    assert speeds.get_attribute("aria-pressed") == "false"  # the button switched them on, the key off
    saved = {}
    for name, suffix in (("PNG", ".png"), ("SVG", ".svg"), ("GIF", ".gif"), ("CSV", ".csv")):
        page.get_by_role("button", name="save", exact=True).click()
        with page.expect_download(timeout=MOST_MILLISECONDS) as download:
            page.get_by_role("button", name=name, exact=True).click()
        assert download.value.suggested_filename == f"FourBar{suffix}"
        saved[suffix] = tmp_path / f"saved{suffix}"
        download.value.save_as(saved[suffix])
    with Image.open(saved[".gif"]) as film:
        assert film.n_frames == 72 and len(film.convert("RGB").getcolors(1 << 20)) > 3
    assert ElementTree.parse(saved[".svg"]).getroot().tag == "{http://www.w3.org/2000/svg}svg"
    page.locator("#sliders-tab").click()
    page.get_by_role("button", name="Reset all").click()
    assert opened.faults == []
    page.close()


@pytest.mark.parametrize(
    ("name", "speed", "slower"), [("library/rlc_circuit", "0.002", "0.001"), ("kepler_orbit", "5000", "2500")]
)
def test_motions_of_any_length_take_seconds_to_watch(
    name: str, speed: str, slower: str, browser: Any, tmp_path: Path
) -> None:
    """Ten milliseconds flew by, and a day took a day."""
    path = tmp_path / "page.html"
    path.write_text(page_of(name), encoding="utf-8")
    page = Opened(browser, path).page
    chooser = page.get_by_label("Speed")
    assert chooser.locator("option:checked").inner_text() == f"{speed}×"
    page.keyboard.press("-")
    assert chooser.locator("option:checked").inner_text() == f"{slower}×"
    assert chooser.locator("option", has_text="×").all_inner_texts().count("1×") == 1
    page.close()


@pytest.mark.parametrize(
    ("name", "first", "last"),
    [
        (
            "block_on_slope",
            ["friction: longest 4.61 N", "ground.friction: slides, 4.61 N"],
            "ground.friction: sticks, 3.35 N",
        ),
        ("clutch", ["clutch: slides, 40 N.m"], "clutch: sticks, 18 N.m"),
    ],
)
def test_the_legend_tells_what_friction_does_now(
    name: str, first: list[str], last: str, browser: Any, tmp_path: Path
) -> None:
    path = tmp_path / "page.html"
    path.write_text(page_of(name), encoding="utf-8")
    page = Opened(browser, path).page
    page.keyboard.press("Space")
    page.keyboard.press("Home")
    page.get_by_role("button", name="friction", exact=True).click()
    page.wait_for_selector("html[data-arrows]", timeout=MOST_MILLISECONDS, state="attached")
    assert page.locator("#legend").inner_text().splitlines() == first
    page.keyboard.press("End")
    assert page.locator("#legend").inner_text().splitlines()[-1] == last
    page.close()


def test_a_motion_that_leaves_the_picture_is_taken_into_it(browser: Any, tmp_path: Path) -> None:
    """Unless somebody chose a view; `fit` shows the motion that there is, not the recorded one."""
    path = tmp_path / "page.html"
    path.write_text(page_of("rolling_coin"), encoding="utf-8")
    page = Opened(browser, path).page
    page.keyboard.press("Space")
    blue = """() => {
        const from = document.querySelector('#stage canvas');
        const pen = Object.assign(document.createElement('canvas'), { width: 320, height: 240 }).getContext('2d');
        pen.drawImage(from, 0, 0, 320, 240);
        const { data } = pen.getImageData(0, 0, 320, 240);
        return data.filter((_, i) => i % 4 === 0 && data[i + 2] > 2 * data[i] + 40).length;
    }"""
    recorded = page.evaluate(blue)
    page.evaluate("document.querySelectorAll('#sliders details').forEach((each) => (each.open = true))")

    def put(x: str) -> None:
        page.get_by_label("x.start in m").fill(x)
        page.get_by_label("x.start in m").press("Enter")
        playwright.expect(page.locator("#said")).to_contain_text("Integrated anew", timeout=MOST_MILLISECONDS)
        page.wait_for_timeout(500)

    put("0.6")
    grown = page.evaluate(blue)
    assert 0 < grown < recorded
    page.get_by_role("button", name="fit", exact=True).click()
    assert page.evaluate(blue) > 2 * grown
    page.locator("#stage canvas").click(position={"x": 40, "y": 40})  # from here on the view is somebody's own
    put("5")
    assert page.evaluate(blue) == 0
    page.close()


def test_one_sees_a_ball_turn(browser: Any, tmp_path: Path) -> None:
    path = tmp_path / "page.html"
    body = "body b(m = 1 kg, I = {1, 1, 1}*1 kg.m2) on f; gravity = 0;"
    start = "coordinate Angle q(der(start = 1 rad/s)); frame f = world.rotz(q);"
    path.write_text(page_of(f"model Ball\n{start} {body}\nend Ball;\n", 1.0), encoding="utf-8")
    page = Opened(browser, path).page
    page.keyboard.press("Space")
    pixels = """() => {
        const from = document.querySelector('#stage canvas');
        const pen = Object.assign(document.createElement('canvas'), { width: 80, height: 60 }).getContext('2d');
        pen.drawImage(from, 0, 0, 80, 60);
        return Array.from(pen.getImageData(0, 0, 80, 60).data);
    }"""
    pictures = []
    for key in ("Home", "End"):
        page.keyboard.press(key)
        page.wait_for_timeout(500)
        pictures.append(page.evaluate(pixels))
    assert sum(abs(a - b) > 8 for a, b in zip(*pictures, strict=True)) > 100
    page.close()


def test_clocks_are_a_density_to_the_end_and_no_red_band(browser: Any, tmp_path: Path) -> None:
    """Of two thousand samples only the first four hundred were marked: the control seemed to end after two seconds."""
    path = tmp_path / "page.html"
    path.write_text(page_of("furuta_swing_up"), encoding="utf-8")
    page = Opened(browser, path).page
    shades = page.evaluate(
        "[...document.querySelectorAll('.track .ticks b')].map((part) => parseFloat(part.style.opacity))"
    )
    assert len(shades) == 100 and min(shades) > 0.0
    assert page.locator(".ticks i.tick").count() == 0
    page.close()


def test_start_values_have_sliders_as_large_as_the_motion(browser: Any, tmp_path: Path) -> None:
    path = tmp_path / "page.html"
    path.write_text(page_of("library/rlc_circuit"), encoding="utf-8")
    page = Opened(browser, path).page
    for name, most in (("C1.q", 0.002), ("L1.q", 0.002), ("ground.q", 0.002)):  # at most 1.8 mC flow, none to ground
        page.get_by_label(f"{name}.start", exact=True).evaluate("bar => { bar.value = 1000; bar.oninput(); }")
        assert float(page.get_by_label(f"{name}.start in C").input_value()) == most
    page.close()


def test_numbers_of_axes_are_short_and_differ(browser: Any, tmp_path: Path) -> None:
    """0.025, 0.025, 0.025 stood at an energy that keeps its value, and nine digits did not fit beside an axis."""
    record = """
        window.told = new Set();
        const write = CanvasRenderingContext2D.prototype.fillText;
        CanvasRenderingContext2D.prototype.fillText = function (text, ...at) {
            window.told.add(text);
            write.call(this, text, ...at);
        };"""
    for name, value in (("free_rigid_body", 0.025005), ("kepler_orbit", -1.0409e10)):
        path = tmp_path / f"{name}.html"
        path.write_text(page_of(name), encoding="utf-8")
        page = Opened(browser, path, before=record).page
        page.locator("#curves-tab").click()
        page.wait_for_timeout(500)
        told = [text for text in page.evaluate("[...window.told]") if text[-1:].isdigit()]
        near = {float(text) for text in told if "," not in text and abs(float(text) - value) < 2e-3 * abs(value)}
        assert len(near) >= 2 and max(len(text) for text in told) <= 10
        page.close()


def test_meshes_are_seen_and_those_without_a_file_told(browser: Any, tmp_path: Path) -> None:
    (tmp_path / "box.stl").write_bytes(binary_stl())
    file = tmp_path / "arm.lag"
    file.write_text(
        """model Arm
  coordinate Angle q;
  frame link = world.roty(q);
  gravity = 0;
  body (m = 1 kg, I = {1 kg.m2, 1 kg.m2, 1 kg.m2}) on link;
  draw mesh(file = "box.stl", color = "red") on link.move({-0.5 m, -1 m, -1.5 m});
  draw mesh(file = "none.stl") on link;
end Arm;
"""
    )
    opened = Opened(browser, compile_model(file).show(tmp_path / "page.html", browser=False))
    page = opened.page
    assert page.locator("#said").inner_text() == "Not drawn, for want of a file with a mesh: none.stl."
    bounds = page.locator("#stage canvas").bounding_box()
    assert bounds is not None
    page.mouse.move(bounds["x"] + bounds["width"] / 2, bounds["y"] + bounds["height"] / 2)
    playwright.expect(page.locator("#pointed")).to_contain_text("box.stl")
    red = page.evaluate("""() => {
        const from = document.querySelector('#stage canvas');
        const pen = Object.assign(document.createElement('canvas'), { width: 80, height: 60 }).getContext('2d');
        pen.drawImage(from, 0, 0, 80, 60);
        const { data } = pen.getImageData(0, 0, 80, 60);
        return data.filter((_, i) => i % 4 === 0 && data[i] > 2 * data[i + 1] + 20).length;
    }""")
    assert red > 100 and opened.faults == []
    page.close()


def test_a_sweep_has_a_slider_over_its_runs(browser: Any, tmp_path: Path) -> None:
    model = compile_model(MODELS / "pendulum.lag")
    data = model.sweep({"l": [0.2, 0.5, 1.0]}, interval=0.1)
    opened = Opened(browser, model.show(tmp_path / "page.html", browser=False, sweep=data))
    page = opened.page
    said = page.locator("#said")
    page.get_by_label("Run", exact=True).evaluate("bar => { bar.value = 2; bar.dispatchEvent(new Event('input')); }")
    playwright.expect(page.locator("#runs output")).to_have_text("Run 3 of 3: l = 1 m")
    playwright.expect(said).to_contain_text("Integrated anew", timeout=MOST_MILLISECONDS)
    assert page.get_by_label("l in m").input_value() == "1"
    assert opened.faults == []
    page.close()


def test_modes_move_and_have_their_root_locus_beside(browser: Any, tmp_path: Path) -> None:
    model = compile_model(MODELS / "ziegler_column.lag")
    flat, names = model._compilation.flat, [slot.name for slot in model._engine.layout.parameters]
    path = tmp_path / "page.html"
    variation = model.vary("P", "linspace(0, 3, 13) N")
    path.write_text(modes_page(flat, model.modes(), names=names, variation=variation), encoding="utf-8")
    opened = Opened(browser, path)
    page = opened.page
    assert opened.ready() == "recorded" and opened.colors() > 3
    assert page.locator(".locus .uplot").count() == 3
    assert "flutter" in page.locator(".locus li").first.inner_text()
    page.locator(".locus .u-over").first.hover()
    playwright.expect(page.locator(".locus .u-value").first).to_contain_text("P = ")
    clock = page.locator(".clock").inner_text()
    page.locator(".modes button").nth(1).click()
    page.get_by_label("Amplitude").select_option(label="amplitude: large")
    playwright.expect(page.locator(".clock")).not_to_have_text(clock)
    assert page.locator("#sliders > :not(#runs):visible").count() == 0
    assert opened.faults == []
    page.close()


def test_a_page_prints_all_panels(browser: Any, tmp_path: Path) -> None:
    path = tmp_path / "page.html"
    path.write_text(page_of("double_pendulum"), encoding="utf-8")
    opened = Opened(browser, path)
    opened.page.emulate_media(media="print")
    for name in ("derivation", "source", "table", "curves"):
        assert opened.page.locator(f"#{name}-panel").is_visible()
    for name in ("tools", "player"):
        assert not opened.page.locator(f"#{name}").is_visible()
    assert opened.page.locator("#values tr", has_text="deg").first.inner_text().split() == ["a", "30", "deg"]
    canvas, stage = (opened.page.locator(place).bounding_box() for place in ("#stage canvas", "#stage"))
    assert canvas is not None and stage is not None
    assert canvas["width"] <= stage["width"] and canvas["height"] <= stage["height"]
    assert len(opened.page.pdf()) > 20_000
    opened.page.close()


@pytest.mark.parametrize("scheme", ["light", "dark"])
def test_a_page_fits_a_telephone(scheme: str, browser: Any, tmp_path: Path) -> None:
    path = tmp_path / "page.html"
    path.write_text(page_of("double_pendulum"), encoding="utf-8")
    opened = Opened(browser, path, 390, 844)
    opened.page.emulate_media(color_scheme=scheme)
    assert opened.page.evaluate("document.documentElement.scrollWidth <= window.innerWidth")
    assert opened.faults == []
    opened.page.close()


def test_the_cursor_of_curves_stands_where_the_clock_is(browser: Any, tmp_path: Path) -> None:
    """Also where its panel was hidden before, and had another size."""
    path = tmp_path / "page.html"
    path.write_text(page_of("double_pendulum"), encoding="utf-8")
    page = Opened(browser, path, 1280, 800).page
    page.keyboard.press("Space")
    page.locator(".track input").evaluate("bar => { bar.value = bar.max / 2; bar.oninput(); }")
    page.locator("#curves-tab").click()
    page.wait_for_timeout(1000)
    at = page.evaluate("""() => {
        const cursor = getComputedStyle(document.querySelector('.u-cursor-x'));
        return new DOMMatrix(cursor.transform).m41 / document.querySelector('.u-over').clientWidth;
    }""")
    assert at == pytest.approx(0.5, abs=0.02)
    page.close()


def test_a_notebook_shows_the_page_in_its_frame(browser: Any, tmp_path: Path) -> None:
    path = tmp_path / "notebook.html"
    path.write_text(f"<!DOCTYPE html><html><body>{framed(page_of('pendulum'), 'p')}</body></html>", encoding="utf-8")
    page = browser.new_page()
    page.goto(path.as_uri())
    page.frame_locator("iframe").locator("html[data-ready]").wait_for(timeout=MOST_MILLISECONDS, state="attached")
    page.close()


def test_units_are_shown_on_request(browser: Any, tmp_path: Path) -> None:
    path = tmp_path / "page.html"
    path.write_text(page_of("double_pendulum"), encoding="utf-8")
    opened = Opened(browser, path)
    page = opened.page
    page.locator("#derivation-tab").click()
    units = page.locator("#derivation section.units, #derivation mtext.unit")
    assert units.count() > 3 and not any(each.is_visible() for each in units.all())
    page.get_by_label("units of symbols and equations").check()
    assert all(each.is_visible() for each in units.all())
    opened.page.close()


def test_a_term_and_its_statement_mark_each_other(browser: Any, tmp_path: Path) -> None:
    path = tmp_path / "page.html"
    path.write_text(page_of("double_pendulum"), encoding="utf-8")
    opened = Opened(browser, path)
    page = opened.page
    page.locator("#derivation-tab").click()
    page.locator("#derivation .term").first.hover()  # (m1 + m2) l1^2 times an acceleration
    assert page.locator("#pointed").inner_text() == "mass 1, mass 2"
    # Another panel hides the text of the model: the marks stay in the document.
    marked = [line.text_content().strip() for line in page.locator(".line.marked").all()]
    assert marked == ["mass m1 at P1;", "mass m2 at P2;"]
    page.locator("#derivation .term").first.click()
    line = page.locator(".line").filter(has_text="mass m2 at P2;")
    assert line.is_visible() and "marked" in (line.get_attribute("class") or "")
    line.hover()
    assert page.locator("#pointed").inner_text() == "mass 2"
    line.click()
    assert page.locator("#derivation .term.marked").first.is_visible()
    page.locator("#source-tab").click()
    page.locator(".line").first.click()
    playwright.expect(page.locator("#said")).to_have_text("No term of the equations comes from this line.")
    assert opened.faults == []
    page.close()
