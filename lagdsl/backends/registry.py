"""Every backend by the name of its target."""

from __future__ import annotations

from lagdsl.backends.backend import Backend
from lagdsl.backends.c.emit import CBackend
from lagdsl.backends.casadi.emit import CasadiBackend
from lagdsl.backends.jax.emit import JaxBackend
from lagdsl.backends.python.emit import PythonBackend

BACKENDS: dict[str, Backend] = {
    backend.name: backend for backend in (PythonBackend(), CBackend(), CasadiBackend(), JaxBackend())
}
