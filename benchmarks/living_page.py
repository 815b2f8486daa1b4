"""Living pages in headless Chromium, which draws by software: bytes, first picture, motions, pictures a second."""

import shutil
import statistics
from collections.abc import Callable, Sequence
from pathlib import Path
from tempfile import TemporaryDirectory
from typing import Any

import lagdsl

Results = dict[str, Any]
ROOT = Path(__file__).parents[1]
CHAIN = Path(__file__).with_name("models") / "planar_chain.lag"
OPTIONS = ("--use-angle=swiftshader", "--enable-unsafe-swiftshader", "--no-sandbox")
READY = "html[data-ready]"
PATIENCE = 120_000  # [ms]
OPENINGS = 7
MOVES = 41
PLAYED = 5.0  # [s]

# The stage draws when its canvas enters the document; the picture is on the screen one frame later.
_FIRST = """
window.firstPicture = new Promise((resolve) => {
  new MutationObserver((_, seen) => {
    if (document.querySelector('#stage canvas') === null) return;
    seen.disconnect();
    requestAnimationFrame(() => requestAnimationFrame(resolve));
  }).observe(document, { childList: true, subtree: true });
});
"""
# Wall time from the move of a slider to the new motion on the page, and the part of it that the runtime takes.
_MOVED = """async (count) => {
  const bar = document.querySelector('#sliders input[type=range]');
  const root = document.documentElement;
  const found = [];
  for (let k = 0; k < count; ++k) {
    root.removeAttribute('data-took');
    const arrived = new Promise((resolve) => {
      const seen = new MutationObserver(() => {
        if (!root.dataset.took) return;
        seen.disconnect();
        resolve(performance.now());
      });
      seen.observe(root, { attributes: true });
    });
    const start = performance.now();
    bar.value = 480 + k;
    bar.dispatchEvent(new Event('input'));
    const end = await arrived;
    found.push([end - start, Number(root.dataset.took)]);
    await new Promise((resolve) => setTimeout(resolve, 30));
  }
  return found;
}"""
_FRAMES = """(seconds) => new Promise((resolve) => {
  let count = 0, first = null;
  const next = (now) => {
    first ??= now;
    if (now - first >= 1000 * seconds) return resolve(count / seconds);
    ++count;
    requestAnimationFrame(next);
  };
  requestAnimationFrame(next);
})"""


def measure(say: Callable[[str], None]) -> Results:
    """Rows by model. Needs Playwright and Chromium: `make page-check` installs the first."""
    from playwright.sync_api import sync_playwright

    models = (
        ("double pendulum, 10 s", lagdsl.compile(ROOT / "models" / "double_pendulum.lag")),
        ("chain of 10 links, 10 s", lagdsl.compile(CHAIN, structural={"N": 10})),
        ("chain of 100 links, 10 s", lagdsl.compile(CHAIN, structural={"N": 100})),
    )
    with TemporaryDirectory() as folder, sync_playwright() as started:
        path = shutil.which("chromium") or shutil.which("google-chrome")
        browser = started.chromium.launch(executable_path=path, args=list(OPTIONS))
        rows = []
        for title, model in models:
            say(f"living page: {title}")
            page = model.show(Path(folder) / "page.html", browser=False, stop=10.0)
            rows.append({"title": title, "bytes": page.stat().st_size, **_looked_at(browser, page)})
        version = browser.version
        browser.close()
    return {"rows": rows, "chromium": version}


def _looked_at(browser: Any, page: Path) -> dict[str, float]:
    """Medians, times in milliseconds."""
    firsts = []
    window = browser.new_context(viewport={"width": 1280, "height": 800})
    window.new_page()  # the browser makes its own controls with the first tab of a window
    for _ in range(OPENINGS):
        tab = window.new_page()
        tab.add_init_script(_FIRST)
        tab.goto(page.as_uri())
        firsts.append(float(tab.evaluate("window.firstPicture")))
        tab.close()
    tab = window.new_page()
    tab.goto(page.as_uri())
    tab.wait_for_selector(READY, timeout=PATIENCE, state="attached")
    frames = float(tab.evaluate(_FRAMES, PLAYED))  # a page plays when it opens
    tab.keyboard.press("Space")
    moves = tab.evaluate(_MOVED, MOVES)
    window.close()
    waited, took = ([row[k] for row in moves] for k in (0, 1))
    return {
        "first": statistics.median(firsts),
        "waited": statistics.median(waited),
        "took": statistics.median(took),
        "frames": frames,
    }


def section(found: Results) -> list[str]:
    """Of README.md."""
    lines = [
        "## Living pages",
        "",
        f"`lag show`, in headless Chromium {found['chromium']}, WebGL by software, 1280 x 800. First picture: from the",
        "call of the page in an open window, median of seven. Integrated anew: from the move of a slider to the new",
        "curves, 601 rows, and the part of it that the runtime takes as WebAssembly. Pictures: playing, at most 60",
        "a second.",
        "",
        "| page | size [kB] | first picture [ms] | integrated anew [ms] | of it the runtime [ms] | pictures [1/s] |",
        "|---|---|---|---|---|---|",
    ]
    return [*lines, *(_line(row) for row in found["rows"])]


def _line(row: Results) -> str:
    cells: Sequence[str] = (
        row["title"],
        f"{row['bytes'] / 1e3:.0f}",
        f"{row['first']:.0f}",
        f"{row['waited']:.1f}",
        f"{row['took']:.1f}",
        f"{row['frames']:.0f}",
    )
    return f"| {' | '.join(cells)} |"
