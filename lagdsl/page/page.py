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
from collections.abc import Mapping
from dataclasses import field
from hashlib import sha256
from html import escape

import numpy as np

from lagdsl.backends.start import start_of
from lagdsl.backends.tape.emit import tape
from lagdsl.diagnostics import CompilationFailed, Sink
from lagdsl.flat.model import FlatModel
from lagdsl.numerics.rank import Floats
from lagdsl.page.head import Json, head_of
from lagdsl.pipeline import compile_flat
from lagdsl.program.program import Layout
from lagdsl.record import record
from lagdsl.resources import page_folder
from lagdsl.runtime.engines.engine import Engine
from lagdsl.runtime.engines.selection import engine_of
from lagdsl.scene.living import START, living
from lagdsl.signals.inputs import Signal, signals
from lagdsl.signals.trajectory import Trajectory
from lagdsl.simulate.failure import SimulationFailed
from lagdsl.simulate.simulate import simulate
from lagdsl.source import SourceFile

_ROWS = 601
_TABS = (
    ("sliders", "Sliders"),
    ("curves", "Curves"),
    ("derivation", "Equations"),
    ("source", "Model"),
    ("table", "Values"),
)


@record(kw_only=True)
class Wishes:
    """Values that the page begins with, by name in SI units. The experiment of the model says the others."""

    stop: float | None = None
    tolerance: float | None = None
    parameters: Mapping[str, float] = field(default_factory=dict)
    start: Mapping[str, float] = field(default_factory=dict)
    inputs: Mapping[str, Signal] = field(default_factory=dict)


def page(flat: FlatModel, wishes: Wishes, *, source: SourceFile | None = None, sink: Sink | None = None) -> str:
    """The page of a model, as the text of an HTML file; `source` is the text that it shows.

    Notes of the run go to `sink`, and so do the errors of a run that ends early: the page shows the motion so far.
    Raises CompilationFailed where there is no motion at all.
    """
    shown = living(flat, wishes.start)
    made = compile_flat(shown.flat, Sink())
    assert made is not None, "a model that compiles does so with further outputs"
    engine = engine_of(made.program)
    p = _parameters(engine.layout, wishes)
    t = flat.experiment.start_time
    end = flat.experiment.stop_time if wishes.stop is None else wishes.stop
    tolerance = flat.experiment.tolerance if wishes.tolerance is None else wishes.tolerance
    motion, ended = _motion(engine, made.flat, p, end, tolerance, wishes, sink)
    moving = {"coordinate", "rate", "state"}
    x = [float(column.values[0]) for column in motion.columns if column.kind in moving]
    u = signals(made.flat, engine.evaluate("start", t, p)[3], wishes.inputs, (t, end), Sink()).at(t)
    head = head_of(
        flat,
        shown,
        motion,
        p=p.tolist(),
        u=u.tolist(),
        source=source,
        span=(t, end),
        tolerance=tolerance,
        said=ended,
    )
    made_tape = tape(made.program, start_of(made.flat, t, x))
    return _html(flat, head, _columns(motion), made_tape, _derivation(flat))


def _parameters(layout: Layout, wishes: Wishes) -> Floats:
    names = [slot.name for slot in layout.parameters]
    p = np.array(layout.defaults, dtype=np.float64)
    starts = {name + START: value for name, value in wishes.start.items()}
    for name, value in {**wishes.parameters, **starts}.items():
        p[names.index(name)] = value
    return p


def _motion(
    engine: Engine, flat: FlatModel, p: Floats, end: float, tolerance: float, wishes: Wishes, sink: Sink | None
) -> tuple[Trajectory, str]:
    """The recorded motion, and why it ended early, if it did."""
    interval = (end - flat.experiment.start_time) / (_ROWS - 1)
    try:
        motion = simulate(
            engine, flat, stop=end, interval=interval, tolerance=tolerance, p=p, inputs=wishes.inputs, sink=sink
        )
    except SimulationFailed as failure:
        told = Sink() if sink is None else sink
        for diagnostic in failure.diagnostics:
            told.add(diagnostic)
        return failure.trajectory, failure.diagnostics[0].message
    return motion, ""


def _columns(motion: Trajectory) -> bytes:
    """All numbers in single precision, column by column: seven digits are more than a picture has."""
    columns = [column.values for column in motion.columns]
    table = np.array([*columns, motion.energy, motion.position_residual, motion.velocity_residual])
    return np.ascontiguousarray(table, dtype="<f4").tobytes()


def _derivation(flat: FlatModel) -> str:
    from lagdsl.report.derivation import document
    from lagdsl.report.html import sections
    from lagdsl.textbook.recipe import recipe

    try:
        return sections(document(recipe(flat)).blocks)
    except CompilationFailed as failure:
        return "".join(f"<p>{escape(d.message)}</p>" for d in failure.diagnostics)


def _html(flat: FlatModel, head: Json, motion: bytes, model_tape: bytes, derivation: str) -> str:
    folder = page_folder() / "dist"
    loader = (folder / "loader.js").read_text(encoding="utf-8").strip()
    style = (folder / "page.css").read_text(encoding="utf-8").strip()
    allowed = b64encode(sha256(loader.encode()).digest()).decode()
    policy = (
        f"default-src 'none'; script-src 'sha256-{allowed}' blob: 'wasm-unsafe-eval'; worker-src blob:; "
        "style-src 'unsafe-inline'; img-src data: blob:; media-src blob:"
    )
    tabs = "".join(
        f'<button role="tab" id="{name}-tab" aria-controls="{name}-panel">{title}</button>' for name, title in _TABS
    )
    inside = {"derivation": f'<div id="derivation">{derivation}</div>', "table": _TABLE}
    panels = "".join(
        f'<div role="tabpanel" id="{name}-panel" aria-labelledby="{name}-tab" tabindex="0">'
        f"{inside.get(name, _empty(name))}</div>"
        for name, _ in _TABS
    )
    doc = f"<p>{escape(flat.doc)}</p>" if flat.doc else ""
    data = {
        "code": _packed((folder / "page.js").read_bytes()),
        "worker": _packed((folder / "worker.js").read_bytes()),
        "wasm": _packed((folder / "lag.wasm").read_bytes()),
        "tape": _packed(model_tape),
        "motion": _packed(motion),
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
<div id="stage"><div id="pointed"></div><div id="tools"></div></div>
<div id="player"></div>
<main id="panels"><div role="tablist" aria-label="Panels">{tabs}</div>
{panels}
<p id="said" role="status"></p></main>
<noscript>The machine moves with JavaScript only; its equations stand above.</noscript>
<script type="application/json" id="head">{_json(head)}</script>
{blocks}<script>{loader}</script>
<!--
{notices}-->
</body>
</html>
"""


_TABLE = (
    '<table><caption>Values at the time of the clock</caption><thead><tr><th scope="col">name</th>'
    '<th scope="col">value</th><th scope="col">unit</th></tr></thead><tbody id="values"></tbody></table>'
)


def _empty(name: str) -> str:
    return f'<div id="{name}"></div>'


def _packed(data: bytes) -> str:
    return b64encode(zlib.compress(data, 9)).decode()


def _json(head: Json) -> str:
    """Nothing in it ends the element that it stands in, or begins another one."""
    text = json.dumps(head, ensure_ascii=False, separators=(",", ":"), allow_nan=False)
    return text.replace("<", "\\u003c").replace("\u2028", "\\u2028").replace("\u2029", "\\u2029")
