"""What a model says of its simulation."""

from __future__ import annotations

from lagdsl.record import record


@record(kw_only=True)
class Experiment:
    """Times in s; `interval` is that between rows of results. `stop_time_explicit`: the model states the stop time."""

    start_time: float = 0.0
    stop_time: float = 10.0
    tolerance: float = 1e-8
    interval: float | None = None
    stop_time_explicit: bool = False
