"""A process that makes runs: reads pickled tasks from standard input, writes outcomes to standard output.

It is started by `processes`, which alone writes to it; pickles come from nowhere else.
"""

from __future__ import annotations

import os
import pickle
import sys

from lagdsl.sweep.run import Runner


def main() -> None:
    """Serve until the other side closes."""
    answers = os.fdopen(os.dup(1), "wb")
    os.dup2(2, 1)  # whatever libraries print must not get between the answers
    requests = sys.stdin.buffer
    runner = Runner(*pickle.load(requests))
    while True:
        try:
            task = pickle.load(requests)
            pickle.dump(runner(task), answers)
            answers.flush()
        except (EOFError, BrokenPipeError):
            # Nobody is there any more; `answers` would try again when it is closed.
            os._exit(0)


if __name__ == "__main__":
    main()
