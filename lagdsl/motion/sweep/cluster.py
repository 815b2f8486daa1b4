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

from lagdsl.engines.runtime.ensemble import Stop
from lagdsl.motion.sweep.maker import Ensembles, Maker
from lagdsl.motion.sweep.plan import Task, parts_of
from lagdsl.motion.sweep.run import Options, Outcome, SweptModel, failed

# Parts that are on their way per thread of the cluster, so that a large sweep does not fill the scheduler; runs of one.
_AHEAD, _LARGEST = 4, 256
_PATIENCE = 10.0  # seconds to find the scheduler
_OWN = threading.local()


def on_cluster(
    address: str, subjects: Sequence[SweptModel], options: Options, tasks: Iterable[Task], left: int
) -> Generator[Outcome, None, None]:
    """Outcomes of the `left` tasks as they come from the scheduler at `address`, whose workers need lagdsl in the same
    version.

    Raises ModuleNotFoundError without Dask, ConnectionError where nobody answers, nobody works, or the connection ends,
    ValueError for inputs that cannot be sent.
    """
    distributed: Any = import_module("distributed")  # without complete types
    try:
        sent = pickle.dumps((tuple(subjects), options))
    except (pickle.PicklingError, AttributeError, TypeError) as error:
        raise ValueError(f"a sweep on a cluster takes no functions as inputs; give tables ({error})") from error
    try:
        # Not the default of this process: that would outlive a client that fails, and change what xarray does.
        client = distributed.Client(address, timeout=_PATIENCE, set_as_default=False)
    except (OSError, ValueError) as error:
        raise ConnectionError(f"no Dask scheduler answers at {address}") from error
    with _quiet(), client:
        try:
            model = client.scatter(sent, broadcast=True)
        except TimeoutError as error:
            raise ConnectionError(f"the Dask scheduler at {address} has no workers") from error
        width = _AHEAD * max(1, sum(client.nthreads().values()))
        parts = parts_of(tasks, max(1, min(_LARGEST, left // (_AHEAD * width))))
        numbers: dict[str, list[int]] = {}

        def submit(part: list[Task]) -> Any:
            future = client.submit(_run, model, part, pure=False)
            numbers[future.key] = [task.index for task in part]
            return future

        running = distributed.as_completed([submit(part) for part in islice(parts, width)], loop=client.loop)
        for future in running:
            if future.cancelled():
                raise ConnectionError(f"the connection to the Dask scheduler at {address} was lost")
            lost = future.exception()
            own = numbers.pop(future.key)
            if lost is None:
                yield from future.result()
            else:
                yield from (failed(number, f"the cluster lost this run: {lost}") for number in own)
            following = next(parts, None)
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


def _run(model: bytes, tasks: list[Task]) -> list[Outcome]:
    """Some runs on a worker, each thread of which keeps the models of the last sweep."""
    if getattr(_OWN, "model", None) != model:
        subjects, options = pickle.loads(model)
        _OWN.model, _OWN.maker = model, Maker(subjects, options, Ensembles(subjects, options), Stop())
    outcomes: list[Outcome] = _OWN.maker.run(tasks, 0)
    return outcomes
