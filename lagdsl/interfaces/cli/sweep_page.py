"""`lag sweep --page`: the machine with a slider over the runs."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING

import click

from lagdsl.documents.page.runs import MOST_RUNS, sweep_page
from lagdsl.documents.plot.picture.wishes import Wishes
from lagdsl.foundation.diagnostics import Sink
from lagdsl.foundation.source import SourceFile
from lagdsl.language.flat.model import FlatModel

if TYPE_CHECKING:
    from lagdsl.motion.sweep.plan import Plan


def require_one_machine(plan: Plan) -> None:
    """Leave with status 2, before the work is done, where a page cannot hold the runs."""
    varied = [axis.name for axis in (*plan.axes, *plan.samples) if axis.target == "structural"]
    if varied:
        raise click.UsageError(
            f"--page: `{varied[0]}` is structural, so the runs are of different machines; make a page of each value"
        )
    if plan.runs > MOST_RUNS:
        raise click.UsageError(f"--page: a page holds at most {MOST_RUNS} runs, the sweep has {plan.runs}")


def page_of(plan: Plan, models: Sequence[FlatModel], wishes: Wishes, source: SourceFile, sink: Sink) -> str:
    """Raises CompilationFailed where no run has a motion."""
    from lagdsl.motion.sweep.plan import inputs_of, place, settings

    found = []
    for k in range(plan.runs):
        chosen = settings(plan, k)
        own = Wishes(parameters=chosen["parameter"], start=chosen["start"], inputs=inputs_of(plan, k))
        found.append((place(plan, k) or f"run {k + 1}", own))
    return sweep_page(models[0], found, wishes, source=source, sink=sink)
