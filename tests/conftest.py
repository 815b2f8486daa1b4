"""Fixtures for every test."""

from pathlib import Path

import pytest
from choice import EXPLORE, examples
from hypothesis import settings

# The same examples in every run, so that a failure belongs to the change at hand; LAGDSL_EXPLORE=1 looks for new ones.
settings.register_profile("same", deadline=None, derandomize=True, max_examples=examples(100))
settings.register_profile("explore", deadline=None)
settings.load_profile("explore" if EXPLORE else "same")

ROOT = Path(__file__).parents[1]
# Whole motions and random models execute what the tests of the floors execute, too: untraced, in a third of the time.
UNTRACED = ("attack", "benchmarks", "fuzz", "models", "oracle", "packaging", "physics", "properties")


def pytest_collection_modifyitems(items: list[pytest.Item]) -> None:
    for item in items:
        if item.path.relative_to(ROOT / "tests").parts[0] in UNTRACED:
            item.add_marker(pytest.mark.no_cover)


@pytest.fixture(scope="session")
def root() -> Path:
    """The checkout."""
    return ROOT
