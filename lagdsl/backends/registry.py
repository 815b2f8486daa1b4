"""Every backend by the name of its target."""

from __future__ import annotations

from lagdsl.backends.backend import Backend
from lagdsl.backends.c.emit import CBackend
from lagdsl.backends.python.emit import PythonBackend

BACKENDS: dict[str, Backend] = {"numpy": PythonBackend(), "c": CBackend()}
