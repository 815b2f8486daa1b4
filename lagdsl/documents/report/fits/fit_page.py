"""A fit as one page without a script: values, what data do not show, the motions over the data, residuals."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from html import escape
from math import isnan

import numpy as np

from lagdsl.documents.report.html_style import STYLE
from lagdsl.foundation.numerics.rank import Floats
from lagdsl.motion.fit.result import Fit, SeriesResiduals, largest_correlations, shown

_WIDTH, _HEIGHT, _LOW = 760.0, 190.0, 90.0
_LEFT, _RIGHT, _TOP, _BOTTOM = 84.0, 12.0, 10.0, 24.0
_FIGURES = """.fit svg { width: 100%; height: auto; font: 11px system-ui, sans-serif; }
.fit text { fill: var(--soft); } .fit .axis { stroke: var(--line); fill: none; }
.fit .curve { stroke: var(--accent); fill: none; stroke-width: 1.6; } .fit circle { fill: var(--ink); opacity: 0.3; }
@media (max-width: 600px) { .fit svg { font-size: 19px; } }
td:not(:first-child) { font-variant-numeric: tabular-nums; }
"""
# Beyond so many values every second, third ... is drawn.
_MOST = 600
_CHANCE, _CORRELATED = 0.01, 0.9


def fit_page(fit: Fit) -> str:
    """One HTML file that needs no network."""
    count = sum(len(each.times) for each in fit.series)
    runs = f"{len(fit.motions)} run{'s' * (len(fit.motions) > 1)}"
    figures = "\n".join(_series(fit, each) for each in fit.series)
    return f"""<!DOCTYPE html>
<html lang="en">
<head>
<meta charset="utf-8">
<meta name="viewport" content="width=device-width, initial-scale=1">
<meta http-equiv="Content-Security-Policy" content="default-src 'none'; style-src 'unsafe-inline'">
<title>{escape(fit.model)}: fit</title>
<style>
{STYLE}{_FIGURES}</style>
</head>
<body>
<main class="fit">
<header>
<p class="kicker">Fit</p>
<h1>{escape(fit.model)}</h1>
<p class="subtitle">{len(fit.estimates)} unknowns from {count} values of {runs}</p>
</header>
<section>
<h2>Values</h2>
{_values(fit)}
<p>The intervals have a probability of {100 * fit.confidence:g} % (Student's t, {fit.freedom} degrees of freedom).
Residuals are {fit.deviation:.3g} times the standard deviations. The sum of squares fell
from {fit.first_sum_of_squares:.4g} to {fit.sum_of_squares:.4g} in {fit.trials} trials.</p>
</section>
<section>
<h2>Notes</h2>
{_bullets([f"{d.code}: {d.message}" for d in fit.notes]) or "<p>Nothing was found that speaks against the values.</p>"}
</section>
{_correlations(fit)}
<section>
<h2>Motions and data</h2>
{figures}
</section>
</main>
</body>
</html>
"""


def _values(fit: Fit) -> str:
    rows = []
    for each in fit.estimates:
        value, half, unit = shown(each)
        before = each.display(each.before)
        change = f"{100 * (each.value - each.before) / abs(each.before):+.3g} %" if each.before else ""
        rows.append([each.name, value, half, unit, f"{before:.6g}", change])
    return _table(["", "value", "\N{PLUS-MINUS SIGN}", "unit", "before", "change"], rows)


def _correlations(fit: Fit) -> str:
    pairs = largest_correlations(fit, _CORRELATED)
    if not pairs:
        return ""
    told = [f"{one} and {other}: {part:.4f}" for one, other, part in pairs]
    return f"<section>\n<h2>Correlations beyond {_CORRELATED:g}</h2>\n{_bullets(told)}\n</section>"


def _series(fit: Fit, series: SeriesResiduals) -> str:
    scale, shift = series.display.scale, series.display.shift
    unit = f" [{series.display.unit}]" if series.display.unit else ""
    white = "too few values to test" if isnan(series.white) else "white" if series.white > _CHANCE else "not white"
    title = f"{series.name} of {series.run}"
    text = f"{title}: residuals {abs(scale) * series.deviation:.3g}{unit}, {white}"
    places = np.arange(1.0, len(series.times) + 1.0) if series.event else series.times
    curve = (places, series.computed)
    if not series.event:
        motion = next(
            m for m, run in zip(fit.motions, dict.fromkeys(s.run for s in fit.series), strict=True) if run == series.run
        )
        motion = motion.drawn(smooth=True)
        curve = (motion.time, motion[series.name])
    across = "" if series.event else " s"
    over = _plot(
        (curve[0], scale * curve[1] + shift), (places, scale * series.measured + shift), title, _HEIGHT, across
    )
    rest = _plot(None, (places, scale * series.residuals), f"residuals of {title}", _LOW, across)
    return f"<figure>{over}{rest}<figcaption>{escape(text)}</figcaption></figure>"


def _plot(
    curve: tuple[Floats, Floats] | None, points: tuple[Floats, Floats], words: str, height: float, across: str
) -> str:
    """`across` is the unit of the abscissa."""
    pairs = [points] if curve is None else [points, curve]
    x0, x1 = _ends(np.concatenate([pair[0] for pair in pairs]))
    y0, y1 = _ends(np.concatenate([pair[1] for pair in pairs]))

    def at(x: Floats, y: Floats) -> list[tuple[float, float]]:
        right = _LEFT + (x - x0) / (x1 - x0) * (_WIDTH - _LEFT - _RIGHT)
        down = _TOP + (y1 - y) / (y1 - y0) * (height - _TOP - _BOTTOM)
        seen = np.isfinite(down)
        return [(round(a, 1), round(b, 1)) for a, b in zip(right[seen].tolist(), down[seen].tolist(), strict=True)]

    every = max(len(points[0]) // _MOST, 1)
    dots = "".join(f'<circle cx="{a}" cy="{b}" r="2"/>' for a, b in at(points[0][::every], points[1][::every]))
    line = "" if curve is None else _line(at(*curve))
    base, right = height - _BOTTOM, _WIDTH - _RIGHT
    zero = at(np.array([x0, x1]), np.zeros(2)) if y0 < 0.0 < y1 else []
    axis = "".join(f"M{a} {b}" if k == 0 else f"L{a} {b}" for k, (a, b) in enumerate(zero))
    labels = f'<text x="{_LEFT - 6}" y="{_TOP + 8}" text-anchor="end">{y1:.4g}</text>'
    labels += f'<text x="{_LEFT - 6}" y="{base}" text-anchor="end">{y0:.4g}</text>'
    labels += f'<text x="{_LEFT}" y="{height - 8}">{x0:.4g}</text>'
    labels += f'<text x="{right}" y="{height - 8}" text-anchor="end">{x1:.4g}{across}</text>'
    frame = f'<path class="axis" d="M{_LEFT} {_TOP}V{base}H{right}{axis}"/>'
    size = f'viewBox="0 0 {_WIDTH:g} {height:g}"'
    return f'<svg {size} role="img" aria-label="{escape(words, quote=True)}">{frame}{dots}{line}{labels}</svg>'


def _line(places: Sequence[tuple[float, float]]) -> str:
    return '<polyline class="curve" points="' + " ".join(f"{a},{b}" for a, b in places) + '"/>'


def _ends(values: Floats) -> tuple[float, float]:
    """The least and the largest of the finite values, apart from each other."""
    seen = values[np.isfinite(values)]
    low, high = (float(np.min(seen)), float(np.max(seen))) if len(seen) else (0.0, 1.0)
    return (low, high) if high > low else (low - 0.5 * (abs(low) or 1.0), high + 0.5 * (abs(high) or 1.0))


def _bullets(items: Sequence[str]) -> str:
    return f"<ul>{''.join(f'<li>{escape(item)}</li>' for item in items)}</ul>" if items else ""


def _table(head: Sequence[str], rows: Iterable[Sequence[str]]) -> str:
    names = "".join(f"<th>{escape(name)}</th>" for name in head)
    cells = "".join(f"<tr>{''.join(f'<td>{escape(cell)}</td>' for cell in row)}</tr>" for row in rows)
    return f'<div class="scroll"><table><thead><tr>{names}</tr></thead><tbody>{cells}</tbody></table></div>'
