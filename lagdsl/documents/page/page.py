"""The living page: one HTML file that draws the machine, moves it, integrates it anew, and shows its equations.

It asks for nothing from anywhere. Its program lies in web/dist, built from web/src; model and motion stand in it as
data.
A small loader, the only script in the text, inflates the program of the page and starts it; the page's own policy
(Content-Security-Policy, level 3) allows that script by its hash, scripts of its own making, and WebAssembly.
"""

from __future__ import annotations

import json
import zlib
from base64 import b64encode
from collections.abc import Mapping, Sequence
from functools import cache
from hashlib import sha256
from html import escape
from pathlib import Path

import numpy as np

from lagdsl.derivation.scene.vectors import with_vectors
from lagdsl.documents.page.head import Json, head_of, shapes_of
from lagdsl.documents.page.packed import deflated, digits
from lagdsl.documents.plot.picture.recording import Recording, prepare, recorded
from lagdsl.documents.plot.picture.wishes import Wishes
from lagdsl.documents.report.notation import GREEK
from lagdsl.engines.backends.start import start_of
from lagdsl.engines.backends.tape.emit import tape
from lagdsl.foundation.diagnostics import CompilationFailed, Sink
from lagdsl.foundation.resources import page_folder
from lagdsl.foundation.source import SourceFile
from lagdsl.language.flat.model import FlatModel
from lagdsl.motion.pipeline import Compilation, compile_observed
from lagdsl.motion.signals.trajectory import Trajectory

_ROWS = 601
_LETTERS_OF_A_LINE = 56
_LARGEST = 250_000  # bytes of the tape of arrows, deflated: it costs no more than a page may
_TABS = {"sliders": "Sliders", "curves": "Curves", "derivation": "Equations", "source": "Model", "table": "Values"}


def page(
    flat: FlatModel,
    wishes: Wishes,
    *,
    source: SourceFile | None = None,
    sink: Sink | None = None,
    compilation: Compilation | None = None,
) -> str:
    """The page of a model, as the text of an HTML file; `source` is the text that it shows, `compilation` that of the
    model if there is one.

    Notes of the run go to `sink`, and so do the errors of a run that ends early: the page shows the motion so far.
    Raises CompilationFailed where there is no motion at all.
    """
    made = recorded(prepare(flat, wishes.start, compilation), wishes, _ROWS, sink)
    x = starts_of(made)
    t, compiled = made.span[0], made.prepared.compilation
    head = head_of(made, wishes, source)
    made_tape = tape(compiled.program, start_of(compiled.flat, t, x))
    first = len(made.motion.columns) - len(made.scene.columns) - len(made.prepared.own.outputs)
    pointed: Json = None
    arrow_tape = b""
    arrows = with_vectors(flat, wishes.start)
    if arrows.scene.shapes:
        observed = compile_observed(compiled, arrows.flat)
        arrow_tape = tape(observed.program, start_of(observed.flat, t, x))
        if len(zlib.compress(arrow_tape)) <= _LARGEST:
            pointed = {"first": first, "shapes": shapes_of(arrows.scene, source), "letters": GREEK}
    return html_of(
        flat, {**head, "vectors": pointed}, [made.motion], made_tape, arrow_tape if pointed else b"", compiled
    )


def starts_of(made: Recording) -> list[float]:
    """Coordinates, rates and states where the motion begins."""
    moving = {"coordinate", "rate", "state"}
    return [float(column.values[0]) for column in made.motion.columns if column.kind in moving]


def _columns(motion: Trajectory) -> bytes:
    """All numbers in single precision, column by column: more digits and sizes than a picture has."""
    columns = [column.values for column in motion.columns]
    table = np.array([*columns, motion.energy, motion.position_residual, motion.velocity_residual])
    largest = float(np.finfo(np.float32).max)
    return np.ascontiguousarray(np.clip(table, -largest, largest), dtype="<f4").tobytes()


def _derivation(flat: FlatModel, compilation: Compilation | None) -> str:
    from lagdsl.derivation.textbook.recipe import recipe
    from lagdsl.documents.report.derivation import document
    from lagdsl.documents.report.html import sections

    try:
        whole = document(recipe(flat), units=True, drawn=True, compilation=compilation)
        return sections(whole.blocks, _LETTERS_OF_A_LINE)
    except CompilationFailed as failure:
        return "".join(f"<p>{escape(d.message)}</p>" for d in failure.diagnostics)


def html_of(
    flat: FlatModel,
    head: Mapping[str, Json],
    motions: Sequence[Trajectory],
    model_tape: bytes,
    arrow_tape: bytes = b"",
    compilation: Compilation | None = None,
) -> str:
    """The page from its head, its motions one after the other, and the tape that it integrates, if it does.
    `compilation` is that of the model if there is one."""
    derivation, motion = _derivation(flat, compilation), b"".join(_columns(each) for each in motions)
    folder = page_folder() / "dist"
    loader = (folder / "loader.js").read_text(encoding="utf-8").strip()
    style = (folder / "page.css").read_text(encoding="utf-8").strip()
    allowed = b64encode(sha256(loader.encode()).digest()).decode()
    policy = (
        f"default-src 'none'; script-src 'sha256-{allowed}' blob: 'wasm-unsafe-eval'; worker-src blob:; "
        "style-src 'unsafe-inline'; img-src data: blob:; media-src blob:"
    )
    titles = {**_TABS, "sliders": "Modes"} if "modes" in head else _TABS
    inside = {"derivation": f'{_UNITS}<div id="derivation">{derivation}</div>', "table": _TABLE}
    panels = "".join(
        f'<label class="tab"><input type="radio" name="panel" id="{name}-tab"{" checked" * (name == "sliders")}>'
        f'{title}</label><section class="panel" id="{name}-panel" aria-label="{title}" tabindex="0">'
        + inside.get(name, f'<div id="{name}"></div>')
        + "</section>"
        for name, title in titles.items()
    )
    doc = f"<p>{escape(flat.doc)}</p>" if flat.doc else ""
    data = {
        "code": _packed_file(folder / "page.js"),
        "worker": _packed_file(folder / "worker.js"),
        "wasm": _packed_file(folder / "lag.wasm"),
        "tape": deflated(model_tape),
        **({"vectors": deflated(arrow_tape)} if arrow_tape else {}),
        "motion": deflated(motion),
        "font": digits((page_folder() / "font" / "math.woff2").read_bytes()),
    }
    blocks = "".join(f'<script type="text/plain" id="{name}">{text}</script>\n' for name, text in data.items())
    notices = (folder / "licenses.txt").read_text(encoding="utf-8").replace("--", "- -")
    return f"""<!DOCTYPE html>
<html lang="en">
<head>
<meta charset="utf-8">
<meta name="viewport" content="width=device-width, initial-scale=1">
<meta http-equiv="Content-Security-Policy" content="{policy}">
<title>{escape(flat.name)}</title>
<style>{style}</style>
</head>
<body>
<header><h1>{escape(flat.name)}</h1>{doc}</header>
<div id="tools" role="toolbar" aria-label="Picture"></div>
<div id="stage"><div id="pointed"></div><div id="legend"></div></div>
<div id="player"></div>
<main id="panels">{panels}
<p id="said" role="status"></p></main>
<noscript>The machine moves with JavaScript only; its equations stand above.</noscript>
<script type="application/json" id="head">{_json(head)}</script>
{blocks}<script>{loader}</script>
<!--
{notices}-->
</body>
</html>
"""


_UNITS = '<label class="choice"><input type="checkbox" id="units">units of symbols and equations</label>'
_TABLE = (
    '<table><caption>Values at the time of the clock</caption><thead><tr><th scope="col">name</th>'
    '<th scope="col">value</th><th scope="col">unit</th></tr></thead><tbody id="values"></tbody></table>'
)


@cache
def _packed_file(path: Path) -> str:
    """One of those that all pages carry: to pack them takes longer than the rest of a small page."""
    return deflated(path.read_bytes())


def _json(head: Json) -> str:
    """Nothing in it ends the element that it stands in, or begins another one."""
    text = json.dumps(head, ensure_ascii=False, separators=(",", ":"), allow_nan=False)
    return text.replace("<", "\\u003c").replace("\u2028", "\\u2028").replace("\u2029", "\\u2029")
