"""Runs in processes of this machine.

Processes of our own rather than a pool of `multiprocessing`: the user's script is not imported again in them, an
interrupt from the keyboard does not reach them, and one that dies takes a single run with it.
"""

from __future__ import annotations

import os
import pickle
import subprocess
import sys
import threading
from collections.abc import Generator, Iterable, Sequence
from pathlib import Path
from queue import SimpleQueue
from typing import TypeAlias

import lagdsl
from lagdsl.sweep.plan import Task
from lagdsl.sweep.run import Options, Outcome, Runner, Subject, failed

_Message: TypeAlias = "Outcome | BaseException | None"


def in_this_process(
    subjects: Sequence[Subject], options: Options, tasks: Iterable[Task]
) -> Generator[Outcome, None, None]:
    """One run after the other."""
    runner = Runner(subjects, options)
    for task in tasks:
        yield runner(task)


def in_processes(
    subjects: Sequence[Subject], options: Options, tasks: Iterable[Task], count: int
) -> Generator[Outcome, None, None]:
    """Outcomes as they come, by `count` processes. Raises ValueError for what cannot be sent to them."""
    try:
        model = pickle.dumps((tuple(subjects), options))
    except (pickle.PicklingError, AttributeError, TypeError) as error:
        raise ValueError(f"a sweep in several processes takes no functions as inputs; give tables ({error})") from error
    waiting = _Waiting(tasks)
    done: SimpleQueue[_Message] = SimpleQueue()
    workers = [_Worker(model) for _ in range(count)]
    threads = [threading.Thread(target=_serve, args=(w, waiting, done), daemon=True) for w in workers]
    for thread in threads:
        thread.start()
    try:
        left = count
        while left:
            message = done.get()
            if isinstance(message, BaseException):
                raise message
            if message is None:
                left -= 1
            else:
                yield message
    finally:
        waiting.close()
        for worker in workers:
            worker.stop()
        for thread in threads:
            thread.join()


class _Waiting:
    """Tasks for several threads."""

    def __init__(self, tasks: Iterable[Task]) -> None:
        self._tasks = iter(tasks)
        self._lock = threading.Lock()
        self._open = True

    def take(self) -> Task | None:
        with self._lock:
            return next(self._tasks, None) if self._open else None

    def close(self) -> None:
        with self._lock:
            self._open = False


class _Worker:
    """One process, started again when it has died."""

    def __init__(self, model: bytes) -> None:
        self._model = model
        self._process: subprocess.Popen[bytes] | None = None
        self._stopped = False
        self._lock = threading.Lock()

    def run(self, task: Task) -> Outcome:
        try:
            process = self._running()
            assert process.stdin is not None
            assert process.stdout is not None
            pickle.dump(task, process.stdin)
            process.stdin.flush()
            outcome = pickle.load(process.stdout)
        except (OSError, EOFError, pickle.UnpicklingError):
            return failed(task.index, f"the process of this run died ({self._discard()})")
        assert isinstance(outcome, Outcome)
        return outcome

    def stop(self) -> None:
        with self._lock:
            self._stopped = True
        self._discard()

    def _running(self) -> subprocess.Popen[bytes]:
        with self._lock:
            if self._stopped:
                raise OSError("stopped")
            if self._process is None:
                self._process = _start()
                assert self._process.stdin is not None
                self._process.stdin.write(self._model)
            return self._process

    def _discard(self) -> str:
        """End the process; how it ended."""
        with self._lock:
            process, self._process = self._process, None
        if process is None:
            return "it was stopped"
        try:
            status = process.wait(timeout=0.2)
        except subprocess.TimeoutExpired:
            process.kill()
            status = process.wait()
        for stream in (process.stdin, process.stdout):
            assert stream is not None
            try:
                stream.close()
            except OSError:  # what it had not read yet
                continue
        return f"signal {-status}" if status < 0 else f"status {status}"


def _start() -> subprocess.Popen[bytes]:
    home = str(Path(lagdsl.__file__).parents[1])
    paths = [home, *filter(None, os.environ.get("PYTHONPATH", "").split(os.pathsep))]
    return subprocess.Popen(
        [sys.executable, "-m", "lagdsl.sweep.worker"],
        stdin=subprocess.PIPE,
        stdout=subprocess.PIPE,
        env={"OPENBLAS_NUM_THREADS": "1", **os.environ, "PYTHONPATH": os.pathsep.join(paths)},
        start_new_session=True,
    )


def _serve(worker: _Worker, waiting: _Waiting, done: SimpleQueue[_Message]) -> None:
    """The thread of one process: hand it tasks, pass on outcomes, then None."""
    try:
        while (task := waiting.take()) is not None:
            done.put(worker.run(task))
    except BaseException as error:  # told where the outcomes are read
        done.put(error)
    done.put(None)
