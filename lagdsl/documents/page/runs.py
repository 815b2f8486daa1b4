"""Pages with several motions: the runs of a sweep, rows from a file, modes as moving shapes."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import replace
from typing import Any

from lagdsl.documents.page.head import Json, fields, head_of, occurrences
from lagdsl.documents.page.page import html_of, starts_of
from lagdsl.documents.plot.picture.recording import Recording, prepare, recorded
from lagdsl.documents.plot.picture.wishes import Wishes
from lagdsl.engines.backends.start import start_of
from lagdsl.engines.backends.tape.emit import tape
from lagdsl.foundation.diagnostics import CompilationFailed, Sink
from lagdsl.foundation.record import record
from lagdsl.foundation.source import SourceFile
from lagdsl.language.flat.model import FlatModel
from lagdsl.motion.pipeline import Compilation
from lagdsl.motion.signals.inputs import Signal
from lagdsl.motion.signals.trajectory import Trajectory

# Numbers of all recorded motions together: about a megabyte in the page.
_MOST_NUMBERS = 400_000
_LEAST_ROWS, _MOST_ROWS = 61, 301
MOST_RUNS = 200
_OF_RUNS = ("parameters", "start", "inputs")


@record(kw_only=True)
class Run:
    """One of several motions: `label` tells it from the others, `said` what there is to say of it.

    `p` are its parameters, where the page may integrate it anew; `pace` is how many seconds of it pass in a second.
    """

    label: str
    motion: Trajectory
    span: tuple[float, float]
    said: str = ""
    p: Sequence[float] | None = None
    pace: float = 1.0


def sweep_page(
    flat: FlatModel,
    settings: Sequence[tuple[str, Wishes]],
    wishes: Wishes,
    *,
    source: SourceFile | None = None,
    sink: Sink | None = None,
) -> str:
    """The page of a sweep, with a slider over its runs: `settings` have the label and the values of each, `wishes` is
    what all of them share. Where runs have inputs of their own, the page shows the recorded motions and integrates none
    anew.

    Runs without a motion are shown as far as there is one; errors go to `sink`. Raises CompilationFailed where no run
    has a motion, ValueError for more runs than a page holds.
    """
    if len(settings) > MOST_RUNS:
        raise ValueError(f"a page holds at most {MOST_RUNS} runs, the sweep has {len(settings)}: give fewer values")
    starts = {name for _, own in settings for name in own.start} | set(wishes.start)
    prepared = prepare(flat, starts)
    width = len(prepared.compilation.flat.outputs) + 2 * len(flat.coordinates) + len(flat.states) + 4
    rows = min(max(_MOST_NUMBERS // (width * max(len(settings), 1)), _LEAST_ROWS), _MOST_ROWS)
    found: list[tuple[Recording, Wishes]] = []
    runs: list[Run] = []
    failures: list[CompilationFailed] = []
    for label, setting in settings:
        values: dict[str, Any] = {name: {**getattr(wishes, name), **getattr(setting, name)} for name in _OF_RUNS}
        own = replace(wishes, **values)
        try:
            made = recorded(prepared, own, rows, Sink())
        except CompilationFailed as failure:
            failures.append(failure)
            continue
        found.append((made, own))
        runs.append(Run(label=label, motion=made.motion, span=made.span, said=made.ended, p=made.p.tolist()))
    if not found:
        raise failures[0]
    if failures and sink is not None:
        for diagnostic in failures[0].diagnostics:
            sink.add(diagnostic)
    first, own = found[0]
    head = head_of(first, replace(wishes, inputs=own.inputs), source, [run.motion for run in runs])
    compiled = prepared.compilation
    if len({_identity(own.inputs) for _, own in settings}) > 1:  # sliders of inputs are those of one run
        return page_of_runs(flat, head, runs, compilation=compiled)
    made_tape = tape(compiled.program, start_of(compiled.flat, first.span[0], starts_of(first)))
    return page_of_runs(flat, head, runs, made_tape, compiled)


def _identity(inputs: Mapping[str, Signal]) -> tuple[tuple[str, float], ...]:
    """Numbers are equal by their values, other signals if they are one object."""
    return tuple((name, each if isinstance(each, (int, float)) else id(each)) for name, each in inputs.items())


def page_of_runs(
    flat: FlatModel,
    head: dict[str, Json],
    runs: Sequence[Run],
    model_tape: bytes = b"",
    compilation: Compilation | None = None,
) -> str:
    """`head` is that of the first run; without a tape nothing is integrated anew. `compilation` is that of the model if
    there is one."""
    told: list[Json] = []
    for run in runs:
        start, stop = run.span
        more: dict[str, Json] = {"rows": len(run.motion), "parameters": run.p, "events": occurrences(run.motion)}
        told.append(fields(run, "label pace said", start=start, stop=stop, **more))
    whole = {**head, "live": bool(model_tape), "runs": told}
    return html_of(flat, whole, [run.motion for run in runs], model_tape, compilation=compilation)
