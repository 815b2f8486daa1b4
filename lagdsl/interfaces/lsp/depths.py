"""The process of `deep`, as the server uses it: one question at a time; a new question ends the old one."""

from __future__ import annotations

import json
import subprocess
import sys
from threading import Lock
from typing import Any

from lagdsl.interfaces.lsp.deep import Depth, Request

_MOST_ANSWERS = 200  # of one process, so that what libraries keep does not grow for ever


class Depths:
    """Asks the process, and starts it anew where it was ended."""

    def __init__(self) -> None:
        self._process: subprocess.Popen[bytes] | None = None
        self._answers = 0
        self._waiting = False
        self._lock = Lock()

    def ask(self, request: Request) -> Depth | None:
        """The answer; None where `cancel` came before it. Called by one thread."""
        process = self._running()
        assert process.stdin is not None
        assert process.stdout is not None
        line = {name: getattr(request, name) for name in Request.__annotations__}
        self._waiting = True
        try:
            process.stdin.write(json.dumps(line).encode() + b"\n")
            process.stdin.flush()
            answer = process.stdout.readline()
        except (OSError, ValueError):
            return None
        finally:
            self._waiting = False
        if not answer:
            return None
        self._answers += 1
        found: dict[str, Any] = json.loads(answer)
        found["redundant"] = [(start, count) for start, count in found["redundant"]]
        return Depth(**found)

    def cancel(self) -> None:
        """Drop the question that waits for its answer, if there is one. May be called by another thread."""
        if self._waiting:
            self.stop()

    def stop(self) -> None:
        """End the process."""
        with self._lock:
            process, self._process = self._process, None
        if process is not None:
            process.kill()
            process.wait()

    def _running(self) -> subprocess.Popen[bytes]:
        if self._answers >= _MOST_ANSWERS:
            self.stop()
        with self._lock:
            if self._process is None or self._process.poll() is not None:
                command = [sys.executable, "-m", "lagdsl.interfaces.lsp.deep"]
                self._process = subprocess.Popen(command, stdin=subprocess.PIPE, stdout=subprocess.PIPE)
                self._answers = 0
            return self._process
