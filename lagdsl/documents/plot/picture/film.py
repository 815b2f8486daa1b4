"""Pictures and films of a recorded motion as files: PNG, SVG, PDF, GIF."""

from __future__ import annotations

import io
import math
from collections.abc import Sequence
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np

from lagdsl.documents.plot.picture.draw import Drawn, draw, prepared, save_picture
from lagdsl.documents.plot.picture.recording import Recording, prepare, recorded, staged
from lagdsl.documents.plot.picture.wishes import Wishes
from lagdsl.foundation.diagnostics import Sink
from lagdsl.foundation.numerics.rank import Floats
from lagdsl.language.flat.model import FlatModel

if TYPE_CHECKING:
    from PIL.Image import Image

# Frames a second, and how long a film lasts; what is shorter is shown slowly, what is longer fast.
_RATE = 16.0
_SHORTEST, _LONGEST = 3.0, 10.0
_COLORS = 96
_DOTS = 75  # an inch: 480 pixels wide
_MOST_BYTES = 4_000_000
_ROWS = 401


def write_picture(
    flat: FlatModel,
    wishes: Wishes,
    path: Path | str,
    times: Sequence[float] = (),
    sink: Sink | None = None,
    *,
    pixels: int = 1280,
    follow: bool = False,
) -> None:
    """The machine as a picture, in the form of the suffix: .png, .svg, .pdf; `pixels` wide; the view
    may `follow` it.

    With one time at that time [s], else at the start; with several the last one in full and the others pale. Raises
    CompilationFailed where there is no motion, ValueError for a time that is not part of it or a model without a place
    to draw, ModuleNotFoundError without Matplotlib.
    """
    made = recorded(prepare(flat, wishes.start), wishes, _ROWS, sink)
    rows = _rows_at(made, times or [made.span[0]])
    picture, stamps = _prepared(flat, made, follow=follow)
    last = float(stamps[rows[-1]])
    draw(picture, rows[-1], rows[:-1], caption=f"t = {last:.3g} s" if times else "")
    save_picture(picture, path, pixels)


def write_film(
    flat: FlatModel, wishes: Wishes, path: Path | str, sink: Sink | None = None, *, follow: bool = False
) -> None:
    """The machine as a GIF of at most 4 MB that plays again and again; `follow` and errors as of `write_picture`."""
    t = flat.experiment.start_time
    end = flat.experiment.stop_time if wishes.stop is None else wishes.stop
    seconds = min(max(end - t, _SHORTEST), _LONGEST)
    count = round(seconds * _RATE)
    made = recorded(prepare(flat, wishes.start), wishes, count + 1, sink)
    picture, times = _prepared(flat, made, follow=follow)
    picture.figure.set_dpi(_DOTS)
    frames, shown = [], np.linspace(t, end, count + 1)
    digits = max(2 - math.floor(math.log10(end - t)), 0)  # so many that two frames differ
    factor = (end - t) / seconds
    speed = "" if abs(factor - 1.0) < 0.05 else f"  ({factor:.2g}× speed)"
    for time in shown[shown <= times[-1] + 1e-9 * (end - t)].tolist():
        draw(picture, _row_at(times, time), caption=f"t = {time:.{digits}f} s{speed}")
        frames.append(_pixels(picture))
    delay = 10 * round(100.0 / _RATE)
    for every in (1, 2, 4):
        data = _gif(frames[::every], every * delay)
        if len(data) <= _MOST_BYTES:
            break
    Path(path).write_bytes(data)


def _prepared(flat: FlatModel, made: Recording, *, follow: bool) -> tuple[Drawn, Floats]:
    """An empty picture, and the times of its rows. Raises ValueError if the scene has nothing to draw."""
    if all(shape.kind == "frame" for shape in made.scene.shapes):
        raise ValueError(f"nothing in {flat.name} has a place to be drawn at: `--plot FILE.png` draws its curves")
    return prepared(staged(flat, made.scene, [made.motion]), flat.name, follow=follow), made.motion.time


def _rows_at(made: Recording, times: Sequence[float]) -> list[int]:
    """Raises ValueError for a time that is not part of the motion."""
    first, last = made.span[0], float(made.motion.time[-1])
    for time in times:
        if not first <= time <= last * (1.0 + 1e-12):
            raise ValueError(f"the motion is from {first:g} s to {last:g} s: there is no picture at {time:g} s")
    return [_row_at(made.motion.time, time) for time in times]


def _row_at(times: Floats, time: float) -> int:
    """The nearest row; of those at the time of an event the last one, which is after it."""
    return len(times) - 1 - int(np.argmin(np.abs(times[::-1] - time)))


def _pixels(picture: Drawn) -> Image:
    from PIL import Image

    canvas: Any = picture.figure.canvas  # Matplotlib has no types for the canvas
    canvas.draw()
    return Image.fromarray(np.asarray(canvas.buffer_rgba())[..., :3].copy(), "RGB")


def _gif(frames: Sequence[Image], delay: int) -> bytes:
    """One palette for all frames, so that what rests does not flicker; `delay` [ms]."""
    from PIL import Image

    width, height = frames[0].size
    some = frames[:: max(1, len(frames) // 8)][:8]
    sheet = Image.new("RGB", (width, height * len(some)))
    for k, frame in enumerate(some):
        sheet.paste(frame, (0, k * height))
    palette = sheet.quantize(_COLORS, Image.Quantize.MEDIANCUT, dither=Image.Dither.NONE)
    first, *rest = (frame.quantize(palette=palette, dither=Image.Dither.NONE) for frame in frames)
    data = io.BytesIO()
    first.save(data, "GIF", save_all=True, append_images=rest, duration=delay, loop=0, optimize=False)
    return data.getvalue()
