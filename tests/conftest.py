"""What every test can use."""

import os
from pathlib import Path

import pytest
from hypothesis import settings

# The same examples in every run, so that a failure belongs to the change at hand; LAGDSL_EXPLORE=1 looks for new ones.
settings.register_profile("same", deadline=None, derandomize=True)
settings.register_profile("explore", deadline=None)
settings.load_profile("explore" if os.environ.get("LAGDSL_EXPLORE") else "same")

ROOT = Path(__file__).parents[1]


@pytest.fixture(scope="session")
def root() -> Path:
    """The checkout."""
    return ROOT
