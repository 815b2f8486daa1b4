"""Runs on a Dask cluster, when its address is given."""

from __future__ import annotations

import logging
import pickle
import threading
from collections.abc import Generator, Iterable, Iterator, Sequence
from contextlib import contextmanager
from importlib import import_module
from itertools import islice
from typing import Any

from lagdsl.sweep.plan import Task
from lagdsl.sweep.run import Options, Outcome, Runner, Subject, failed

# Tasks that are on their way per thread of the cluster, so that a large sweep does not fill the scheduler.
_AHEAD = 4
_PATIENCE = 10.0  # seconds to find the scheduler
_OWN = threading.local()


def on_cluster(
    address: str, subjects: Sequence[Subject], options: Options, tasks: Iterable[Task]
) -> Generator[Outcome, None, None]:
    """Outcomes as they come from the scheduler at `address`, whose workers need lagdsl in the same version.

    Raises ModuleNotFoundError without Dask, ConnectionError where nobody answers, nobody works, or the connection ends.
    """
    distributed: Any = import_module("distributed")  # without complete types
    try:
        # Not the default of this process: that would outlive a client that fails, and change what xarray does.
        client = distributed.Client(address, timeout=_PATIENCE, set_as_default=False)
    except (OSError, ValueError) as error:
        raise ConnectionError(f"no Dask scheduler answers at {address}") from error
    with _quiet(), client:
        try:
            model = client.scatter(pickle.dumps((tuple(subjects), options)), broadcast=True)
        except TimeoutError as error:
            raise ConnectionError(f"the Dask scheduler at {address} has no workers") from error
        waiting = iter(tasks)
        numbers: dict[str, int] = {}

        def submit(task: Task) -> Any:
            future = client.submit(_run, model, task, pure=False)
            numbers[future.key] = task.index
            return future

        width = _AHEAD * max(1, sum(client.nthreads().values()))
        running = distributed.as_completed([submit(task) for task in islice(waiting, width)], loop=client.loop)
        for future in running:
            if future.cancelled():
                raise ConnectionError(f"the connection to the Dask scheduler at {address} was lost")
            lost = future.exception()
            number = numbers.pop(future.key)
            yield future.result() if lost is None else failed(number, f"the cluster lost this run: {lost}")
            following = next(waiting, None)
            if following is not None:
                running.add(submit(following))


@contextmanager
def _quiet() -> Iterator[None]:
    """Without the tracebacks that Dask logs when a connection ends: that is told once, in our words."""
    loggers = [logging.getLogger(name) for name in logging.root.manager.loggerDict if name.startswith("distributed")]
    before = [logger.level for logger in loggers]
    for logger in loggers:
        logger.setLevel(logging.CRITICAL + 1)
    try:
        yield
    finally:
        for logger, level in zip(loggers, before, strict=True):
            logger.setLevel(level)


def _run(model: bytes, task: Task) -> Outcome:
    """One run on a worker, each thread of which keeps the models of the last sweep."""
    if getattr(_OWN, "model", None) != model:
        _OWN.model, _OWN.runner = model, Runner(*pickle.loads(model))
    outcome: Outcome = _OWN.runner(task)
    return outcome
