"""Fixtures that tests of backends share."""

from __future__ import annotations

import hashlib
import os
from contextlib import nullcontext
from pathlib import Path

import pytest
from made_modules import SANITIZED, Done, Made, make, sanitized_objects

from lagdsl.engines.runtime.lock import locked


@pytest.fixture(scope="session")
def made(tmp_path_factory: pytest.TempPathFactory) -> Made:
    """Builds a module in its folder; the runtime is compiled once for each compiler and its flags, by all processes of
    this run."""
    own = tmp_path_factory.getbasetemp()
    kept = (own.parent if "PYTEST_XDIST_WORKER" in os.environ else own) / "objects"

    def built(folder: Path, *arguments: str) -> Done:
        if f"CFLAGS={SANITIZED}" in arguments:
            return make(folder, sanitized_objects(), *arguments)
        variables = "\n".join(argument for argument in arguments if "=" in argument)
        objects = kept / hashlib.sha256(variables.encode()).hexdigest()
        objects.mkdir(parents=True, exist_ok=True)
        with locked(objects.with_suffix(".lock")) if not any(objects.iterdir()) else nullcontext():
            return make(folder, objects, *arguments)

    return built
