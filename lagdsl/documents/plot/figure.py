"""Figures of a motion: what moves, how fast, what comes out, whether the energy behaves; chosen columns over time or
against each other, of one motion or of the runs of a sweep."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np

from lagdsl.documents.plot.names import ENERGY, panels_of, paths_of
from lagdsl.documents.plot.sheet import COLORS, DARK, LINES, escaped, in_brackets, mark_events, sheet, title
from lagdsl.foundation.numerics.rank import Floats
from lagdsl.foundation.record import record
from lagdsl.language.flat.display import Display, drawn_rate
from lagdsl.motion.signals.trajectory import Trajectory

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure

_MOST_CURVES = 14  # of a panel of all columns of a kind
_MOST_NAMED = 7  # curves in a legend; more runs have a scale of colors
_MOST_DOTS = 200
_WIDTH, _HEIGHT, _SQUARE = 8.0, 2.6, 4.6
_TICKS = 5  # of the short axis of a path: numbers like -0.0015 stand beside each other
_KINDS = {"coordinate": "coordinates", "rate": "rates", "state": "states", "discrete": "discretes", "output": "outputs",
          "energy": ENERGY}  # fmt: skip


@record(kw_only=True)
class Curve:
    """One quantity in its display unit: `values` (runs, rows)."""

    name: str
    unit: str
    values: Floats


@record(kw_only=True)
class Variation:
    """Value that colors the runs of a sweep: `values` (runs,) in `unit`; `words` tell each run."""

    name: str
    unit: str
    values: Floats
    words: tuple[str, ...]

    @property
    def few(self) -> bool:
        """So that a legend can name all runs."""
        return len(self.values) <= _MOST_NAMED

    def colors(self) -> list[Any]:
        if self.few:
            return [COLORS[k % len(COLORS)] for k in range(len(self.values))]
        import matplotlib as mpl

        low, high = float(np.min(self.values)), float(np.max(self.values))
        parts = (self.values - low) / (high - low) if high > low else np.full(len(self.values), 0.5)
        return list(mpl.colormaps["viridis"](parts))


@record(kw_only=True)
class Bundle:
    """Curves by name over `time` (rows,) [s]; `events` [s] are those that a figure marks."""

    title: str
    time: Floats
    curves: Mapping[str, Curve]
    events: tuple[float, ...] = ()
    variation: Variation | None = None


def bundle_of(motion: Trajectory) -> Bundle:
    """All columns of a motion and its energy; ticks of clocks are no events to mark."""
    curves = {name: shown(name, c.kind, c.display, c.values[None, :]) for c in motion.columns for name in c.called}
    curves.setdefault(ENERGY, Curve(name=ENERGY, unit="J", values=motion.energy[None, :]))
    events = tuple(sorted({event.time for event in motion.events if event.kind != "tick"}))
    return Bundle(title=motion.model, time=motion.time, curves=curves, events=events)


def shown(name: str, kind: str, display: Display, values: Floats) -> Curve:
    """`values` of a column of this kind, in SI units, as people see them."""
    display = drawn_rate(display) if kind == "rate" else display
    return Curve(name=name, unit=display.unit, values=np.asarray(values * display.scale + display.shift))


def plot(trajectory: Trajectory, path: Path | str | None = None) -> Figure:
    """One panel for each kind of quantity and unit, above one time axis; written to `path` (by its suffix) if given.

    Needs the extra `plot`. `plot_of` draws chosen columns.
    """
    motion = trajectory.drawn(smooth=True)
    bundle = bundle_of(motion)
    groups: dict[tuple[str, str], list[Curve]] = {}
    for column in motion.columns[1:]:
        curve = bundle.curves[column.name]
        groups.setdefault((column.kind, curve.unit), []).append(curve)
    if energy := _energy(motion):
        groups["energy", energy.unit] = [energy]
    heights = [1.5, *[1.0] * (len(groups) - 1)] if groups else [1.0]
    with sheet((8.0, 1.2 + 1.75 * sum(heights)), path) as figure:
        axes = list(figure.subplots(len(heights), 1, sharex=True, squeeze=False, height_ratios=heights)[:, 0])
        for panel, ((kind, _), curves) in zip(axes, groups.items(), strict=False):
            _draw_over_time(panel, bundle, [curves[:_MOST_CURVES]], _KINDS[kind], len(curves) - _MOST_CURVES)
        if energy and energy.name != ENERGY:
            axes[-1].ticklabel_format(axis="y", style="sci", scilimits=(0, 0))
            small: dict[str, Any] = {"ha": "right", "va": "bottom", "color": "#666666", "fontsize": 8}
            axes[-1].text(1.0, 1.02, f"of {motion.energy[0]:.5g} J", transform=axes[-1].transAxes, **small)
        axes[-1].set_xlabel("time [s]")
        title(axes[0], motion.model)
        figure.align_ylabels(axes)
    return figure


def _energy(motion: Trajectory) -> Curve | None:
    """The energy itself where it changes visibly, its drift where it is conserved; none where there is none."""
    if not (np.any(np.isfinite(motion.energy)) and np.any(motion.energy)):
        return None
    change = motion.energy - motion.energy[0]
    if float(np.nanmax(np.abs(change))) < 1e-4 * float(np.nanmax(np.abs(motion.energy))):
        return Curve(name="energy drift", unit="J", values=change[None, :])
    return Curve(name=ENERGY, unit="J", values=motion.energy[None, :])


def plot_of(
    motion: Trajectory,
    path: Path | str | None = None,
    *,
    show: str | Sequence[str] | None = None,
    xy: tuple[str, str] | Sequence[tuple[str, str]] | None = None,
) -> Figure:
    """Columns of a motion by their names, `energy` and `time` among them; without names all of them, see `plot`.

    `show` is `"theta, der(theta)"`, one panel with an axis for each of two units, or several such texts, one panel
    each. `xy` is `("x, u", "y, v")`, one panel with the paths (x, y) and (u, v), or several such pairs. Events are
    marked. Raises KeyError for a name that no column has, ValueError where names make no panel.
    """
    if not show and not xy:
        return plot(motion, path)
    known = list(bundle_of(motion).curves)
    panels, paths = panels_of(show, known), paths_of(xy, known)
    return draw_chosen(bundle_of(motion.drawn(smooth=True)), panels, paths, path)


def draw_chosen(
    bundle: Bundle,
    panels: Sequence[Sequence[str]],
    paths: Sequence[Sequence[tuple[str, str]]],
    path: Path | str | None = None,
) -> Figure:
    """`panels` are columns over time, those of two units on two axes; `paths` are pairs of columns against each other.

    Panels stand below each other, paths at their right. Written to `path` (by its suffix) if given. Raises
    ModuleNotFoundError without Matplotlib.
    """
    over_time = [part for names in panels for part in _by_units([bundle.curves[name] for name in names])]
    width = (_WIDTH if over_time else 0.0) + _SQUARE * bool(paths) + 0.9 * (bundle.variation is not None)
    height = 0.6 + max(_HEIGHT * len(over_time), (_SQUARE - 0.4) * len(paths))
    with sheet((width, height), path) as figure:
        right, left = _places(figure, len(over_time), len(paths))
        for panel, parts in zip(left, over_time, strict=True):
            _draw_over_time(panel, bundle, parts)
        if left:
            left[-1].set_xlabel("time [s]")
            figure.align_ylabels(left)
        for panel, pairs in zip(right, paths, strict=True):
            _draw_paths(panel, bundle, [(bundle.curves[x], bundle.curves[y]) for x, y in pairs])
        _tell_runs(figure, [*left, *right], bundle)
        title((left or right)[0], bundle.title)
    return figure


def _places(figure: Figure, panels: int, paths: int) -> tuple[list[Axes], list[Axes]]:
    """Axes of the paths, and those of the panels, which share their time."""
    widths = [width for count, width in ((panels, _WIDTH), (paths, _SQUARE)) if count]
    beside = figure.add_gridspec(1, len(widths), width_ratios=widths)

    def below(cell: int, count: int, *, shared: bool) -> list[Axes]:
        found: Any = beside[cell].subgridspec(count, 1).subplots(sharex=shared, squeeze=False) if count else None
        return list(found[:, 0]) if count else []

    return below(-1, paths, shared=False), below(0, panels, shared=True)


def _by_units(curves: Sequence[Curve]) -> list[list[list[Curve]]]:
    """Curves of one unit share an axis, two units a panel; a third one opens the next panel."""
    by_unit: dict[str, list[Curve]] = {}
    for curve in curves:
        by_unit.setdefault(curve.unit, []).append(curve)
    groups = list(by_unit.values())
    return [groups[k : k + 2] for k in range(0, len(groups), 2)]


def _draw_over_time(
    panel: Axes, bundle: Bundle, groups: Sequence[Sequence[Curve]], kind: str = "", more: int = 0
) -> None:
    """Curves over time, those of a second unit on an axis of their own. Several curves of a `kind` have that as their
    label; so many `more` of them have no color."""
    twin = panel.twinx() if len(groups) > 1 else None
    drawn = 0
    for side, group in zip((panel, twin), groups, strict=False):
        assert side is not None
        for curve in group:
            _draw_runs(side, bundle, np.broadcast_to(bundle.time, curve.values.shape), curve, drawn)
            drawn += 1
        label = kind + in_brackets(group[0].unit, "\n") if kind and len(group) > 1 else _axis_label(group)
        own = bundle.variation is None and twin is not None and len(group) == 1
        side.set_ylabel(label, color=side.lines[0].get_color() if own else DARK)
        side.margins(y=0.08)
        _calm(side, group)
        side.ticklabel_format(axis="y", useOffset=False)
    if twin is not None:
        twin.grid(visible=False)
        twin.spines["right"].set_visible(True)
    if drawn > 1:
        runs = 1 if bundle.variation is None else len(bundle.variation.values)
        lines = [line for side in (panel, twin) if side is not None for line in side.lines[::runs]]
        left_out = f"and {more} more" if more > 0 else None
        aside: dict[str, Any] = {"loc": "upper left", "bbox_to_anchor": (1.0, 1.03), "title": left_out}
        above: dict[str, Any] = {"loc": "lower right", "bbox_to_anchor": (1.0, 1.0), "ncols": 5}
        legend = panel.legend(handles=lines, fontsize=8, handlelength=1.6, **(aside if kind else above))
        if runs > 1:  # dashes tell the columns, because colors tell the runs
            for line in legend.get_lines():
                line.set_color(DARK)
    if len(bundle.time) > 1:
        panel.set_xlim(float(bundle.time[0]), float(bundle.time[-1]))
        mark_events(panel, bundle.events, float(bundle.time[-1] - bundle.time[0]))


def _calm(panel: Axes, curves: Sequence[Curve]) -> None:
    """Round-off does not fill the height: what is constant to nine digits looks constant."""
    values = np.concatenate([curve.values[np.isfinite(curve.values)] for curve in curves])
    if len(values) and 0.0 < np.ptp(values) < 1e-9 * np.max(np.abs(values)):
        middle, size = float(np.mean(values)), float(np.max(np.abs(values)))
        panel.set_ylim(middle - 1e-3 * size, middle + 1e-3 * size)


def _draw_runs(panel: Axes, bundle: Bundle, x: Floats, curve: Curve, index: int, **more: Any) -> None:
    """Of a motion the curve in a color of its own; of a sweep a curve for each run."""
    if bundle.variation is None:
        colors, style = [COLORS[index % len(COLORS)]], LINES[index // len(COLORS) % len(LINES)]
    else:
        colors, style = bundle.variation.colors(), LINES[index % len(LINES)]
    width, alpha = (1.4, 1.0) if len(colors) <= 20 else (0.8, 0.7)
    same: dict[str, Any] = {
        "linestyle": style,
        "linewidth": width,
        "alpha": alpha,
        "label": escaped(curve.name),
        **more,
    }
    for right, up, color in zip(x, curve.values, colors, strict=True):
        panel.plot(right, up, color=color, **same)


def _draw_paths(panel: Axes, bundle: Bundle, pairs: Sequence[tuple[Curve, Curve]]) -> None:
    """With a dot at each start and crosses at events, just before and just after which rows stand."""
    rows = np.isin(bundle.time, bundle.events[:_MOST_DOTS])
    for index, (right, up) in enumerate(pairs):
        _draw_runs(panel, bundle, right.values, up, index, marker="o", markevery=[0], markersize=4)
        panel.plot(right.values[0, rows], up.values[0, rows], "x", color="#666666", markersize=4, zorder=3)
    rights, ups = [list({curve.name: curve for curve in side}.values()) for side in zip(*pairs, strict=True)]
    panel.set_xlabel(_axis_label(rights, between=" "))
    panel.set_ylabel(_axis_label(ups))
    panel.margins(0.06)
    panel.locator_params(axis="x", nbins=_TICKS)
    if len(pairs) > 1 and bundle.variation is None:
        panel.legend(handles=panel.lines[::2], fontsize=8)
    units = {curve.unit for curve in (*rights, *ups)}
    if len(units) == 1 and units <= {"m", "cm", "mm", "km"}:  # a path in space keeps its shape
        panel.set_aspect("equal", adjustable="datalim")


def _axis_label(curves: Sequence[Curve], between: str = "\n") -> str:
    names = ", ".join(escaped(curve.name) for curve in curves[:4]) + (", ..." if len(curves) > 4 else "")
    units = dict.fromkeys(curve.unit for curve in curves)
    return names + in_brackets(", ".join(unit for unit in units if unit not in ("", "1")), between)


def _tell_runs(figure: Figure, panels: Sequence[Axes], bundle: Bundle) -> None:
    """A legend for few runs, a scale of colors for many."""
    variation = bundle.variation
    if variation is None:
        return
    if variation.few:  # runs of the first curve
        words = [*map(escaped, variation.words)]
        figure.legend(panels[0].lines[: len(words)], words, loc="outside right upper", fontsize=8)
        return
    from matplotlib.cm import ScalarMappable
    from matplotlib.colors import Normalize

    scale = Normalize(float(np.min(variation.values)), float(np.max(variation.values)))
    label = escaped(variation.name) + in_brackets(variation.unit)
    figure.colorbar(ScalarMappable(scale, "viridis"), ax=list(panels), label=label, pad=0.02)
