"""What tests of backends share."""

from __future__ import annotations

from pathlib import Path

import pytest
from made_modules import Done, Made, make


@pytest.fixture(scope="session")
def made(tmp_path_factory: pytest.TempPathFactory) -> Made:
    """Builds a module in its folder; the runtime is compiled once for each compiler and its flags."""
    kept: dict[tuple[str, ...], Path] = {}

    def built(folder: Path, *arguments: str) -> Done:
        variables = tuple(argument for argument in arguments if "=" in argument)
        if variables not in kept:
            kept[variables] = tmp_path_factory.mktemp("objects")
        return make(folder, kept[variables], *arguments)

    return built
