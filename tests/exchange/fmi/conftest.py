"""Tests of what FMUs do run untraced: they execute C, and the Python of importers."""

from __future__ import annotations

from pathlib import Path

import pytest

HERE = Path(__file__).parent
RUNNING = (
    "test_coupled_fmus",
    "test_fmpy_",
    "test_fmus_together",
    "test_foreign_importers",
    "test_many_instances",
    "test_page_on_fmus",
)


def pytest_collection_modifyitems(items: list[pytest.Item]) -> None:
    for item in items:
        if item.path.parent == HERE and item.path.name.startswith(RUNNING):
            item.add_marker(pytest.mark.no_cover)
