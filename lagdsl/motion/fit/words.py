"""A fit as text for a terminal."""

from __future__ import annotations

from math import isnan

from lagdsl.motion.fit.result import Fit, largest_correlations, shown

_CORRELATED = 0.9
_CHANCE = 0.01


def fit_text(fit: Fit) -> str:
    """Values with intervals, what changed, residuals, and what the data do not show."""
    runs = len(fit.motions)
    head = f"{fit.model}: {len(fit.estimates)} unknown{'s' * (len(fit.estimates) > 1)}, "
    head += f"{sum(len(each.times) for each in fit.series)} values of {runs} run{'s' * (runs > 1)}"
    rows = [["", "value", "+-", "", "from"]]
    for each in fit.estimates:
        value, half, unit = shown(each)
        rows.append([each.name, value, half, unit, f"{each.display(each.before):.6g}"])
    lines = [head, *_aligned(rows, left=(0, 3)), f"  +- ends the {100 * fit.confidence:g} % interval"]
    rows = [["", "", "residual", "sigma", "", "white"]]
    for series in fit.series:
        scale = abs(series.display.scale)
        white = "" if isnan(series.white) else ("yes" if series.white > _CHANCE else f"no ({series.white:.1g})")
        sizes = [f"{scale * series.deviation:.4g}", f"{scale * series.sigma:.4g}"]
        rows.append([series.run, series.name, *sizes, series.display.unit, white])
    lines += ["", *_aligned(rows, left=(0, 1, 4))]
    for one, other, part in largest_correlations(fit, _CORRELATED):
        lines.append(f"{one} and {other} correlate by {part:.4f}")
    lines += [str(each) for each in fit.hidden]
    return "\n".join(lines)


def _aligned(rows: list[list[str]], left: tuple[int, ...]) -> list[str]:
    widths = [max(len(row[i]) for row in rows) for i in range(len(rows[0]))]
    return ["  " + "  ".join(_cell(row, i, widths[i], left) for i in range(len(row))).rstrip() for row in rows]


def _cell(row: list[str], i: int, width: int, left: tuple[int, ...]) -> str:
    return row[i].ljust(width) if i in left else row[i].rjust(width)
