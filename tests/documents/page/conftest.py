"""A browser for pages."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Any

import pytest
from page.browser import CHROMIUM, OPTIONS


@pytest.fixture(scope="module")
def browser() -> Iterator[Any]:
    playwright = pytest.importorskip("playwright.sync_api", reason="playwright is not installed: make page-check")
    with playwright.sync_playwright() as started:
        found = started.chromium.launch(executable_path=CHROMIUM, args=list(OPTIONS))
        yield found
        found.close()
