"""A process that makes runs: reads pickled tasks from standard input, writes outcomes to standard output.

It is started by `processes`, which alone writes to it; pickles come from nowhere else.
"""

from __future__ import annotations

import os
import pickle
import sys
import threading
from queue import SimpleQueue
from typing import BinaryIO

from lagdsl.sweep.plan import Task
from lagdsl.sweep.run import Runner


def main() -> None:
    """Serve until the other side closes, or is no more: then a run that is under way ends, too."""
    answers = os.fdopen(os.dup(1), "wb")
    os.dup2(2, 1)  # whatever libraries print must not get between the answers
    requests = sys.stdin.buffer
    runner = Runner(*pickle.load(requests))
    tasks: SimpleQueue[Task] = SimpleQueue()
    threading.Thread(target=_listen, args=(requests, tasks), daemon=True).start()
    while True:
        outcome = runner(tasks.get())
        try:
            pickle.dump(outcome, answers)
            answers.flush()
        except BrokenPipeError:
            os._exit(0)  # `answers` would try again when it is closed


def _listen(requests: BinaryIO, tasks: SimpleQueue[Task]) -> None:
    """Beside the runs, so that the end of the other side is noticed during one."""
    while True:
        try:
            tasks.put(pickle.load(requests))
        except (EOFError, pickle.UnpicklingError):
            os._exit(0)


if __name__ == "__main__":
    main()
