"""A folder that the processes of one run of the tests share: it is there as long as the run."""

from __future__ import annotations

import os
import tempfile
from pathlib import Path

_NAME = "LAGDSL_TESTS_FOLDER"  # processes of pytest-xdist inherit it


def make_shared_folder() -> tempfile.TemporaryDirectory[str] | None:
    """None in a process that has the folder of another one."""
    if "PYTEST_XDIST_WORKER" in os.environ:
        return None
    folder = tempfile.TemporaryDirectory(prefix="lagdsl-tests-")
    os.environ[_NAME] = folder.name
    return folder


def shared_folder() -> Path:
    return Path(os.environ[_NAME])
