"""Every backend by the name of its target."""

from __future__ import annotations

from lagdsl.engines.backends.backend import Backend
from lagdsl.engines.backends.c.emit import CBackend
from lagdsl.engines.backends.casadi.emit import CasadiBackend
from lagdsl.engines.backends.jax.emit import JaxBackend
from lagdsl.engines.backends.python.emit import PythonBackend

BACKENDS: dict[str, Backend] = {
    backend.name: backend for backend in (PythonBackend(), CBackend(), CasadiBackend(), JaxBackend())
}
