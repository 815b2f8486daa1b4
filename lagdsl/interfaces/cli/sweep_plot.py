"""`lag sweep --plot`: the runs as a family of curves."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING

import numpy as np

from lagdsl.documents.plot.figure import Bundle, Variation, shown
from lagdsl.interfaces.cli.output import draft_of
from lagdsl.interfaces.cli.plots import Plot, chosen
from lagdsl.language.flat.display import Display
from lagdsl.language.flat.model import FlatModel
from lagdsl.motion.simulate.table import called_heads

if TYPE_CHECKING:
    import xarray

    from lagdsl.motion.sweep.plan import Plan


def require_kept(plot: Plot, models: Sequence[FlatModel], columns: tuple[str, ...] | None) -> None:
    """Leave with status 2, before the work is done, where no run has such a column."""
    every = dict.fromkeys(name for flat in models for name in called_heads(flat))
    chosen(plot, every if columns is None else ["time", *columns])


def draw_sweep(plot: Plot, data: xarray.Dataset, plan: Plan, models: Sequence[FlatModel]) -> None:
    """Write the figure, if one is asked for; without names it shows the coordinates."""
    if plot.path is None:
        return
    from lagdsl.documents.plot.figure import draw_chosen

    heads = {name: head for flat in models for name, head in called_heads(flat).items()}
    over_time = {str(name): v.values for name, v in data.data_vars.items() if len(v.dims) > len(plan.shape)}
    time = next(data[v.dims[-1]].values for v in data.data_vars.values() if len(v.dims) > len(plan.shape))
    runs = {name: values.reshape(plan.runs, len(time)) for name, values in over_time.items()}
    runs["time"] = np.broadcast_to(time, (plan.runs, len(time)))
    bundle = Bundle(
        title=str(data.attrs["model"]),
        time=time,
        curves={name: shown(name, heads[name][2], heads[name][3], values) for name, values in runs.items()},
        variation=_variation(plan),
    )
    panels, paths = chosen(plot, list(runs))
    if not panels and not paths:
        moving = [name for name in over_time if heads[name][2] == "coordinate"]
        panels = [[name] for name in (moving or list(over_time))[:4]]
    with draft_of(plot.path) as draft:
        draw_chosen(bundle, panels, paths, draft)


def _variation(plan: Plan) -> Variation:
    """The first quantity that differs from run to run colors them."""
    from lagdsl.motion.sweep.plan import place, settings

    axis = (*plan.axes, *plan.samples, *plan.fixed)[0]
    display = axis.display or Display(axis.unit)
    values = [display(settings(plan, k)[axis.target][axis.key]) for k in range(plan.runs)]
    words = tuple(place(plan, k) or axis.name for k in range(plan.runs))
    return Variation(name=axis.name, unit=display.unit, values=np.array(values), words=words)
