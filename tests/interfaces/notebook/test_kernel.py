"""The notebooks of the documents in a real kernel: what people see is what is stored."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import pytest
from choice import ALL

nbclient = pytest.importorskip("nbclient")
nbformat = pytest.importorskip("nbformat")

FOLDER = Path(__file__).parents[3] / "docs" / "notebooks"


@pytest.mark.skipif(not ALL, reason="a kernel takes ten seconds; test_notebook runs the same cells without one")
@pytest.mark.parametrize("name", sorted(path.stem for path in FOLDER.glob("*.ipynb")))
def test_notebook_in_a_kernel(name: str) -> None:
    """Every output has all the forms that are stored: figures as pictures, too."""
    stored = nbformat.read(FOLDER / f"{name}.ipynb", 4)
    nbformat.validate(stored)
    forms = [_forms(cell) for cell in stored.cells]
    made = nbclient.NotebookClient(stored, timeout=300, resources={"metadata": {"path": str(FOLDER)}}).execute()
    assert [_forms(cell) for cell in made.cells] == forms


def _forms(cell: Any) -> list[tuple[str, list[str]]]:
    """Kind and forms of each output that shows something; a bar of progress leaves nothing."""
    found = [(each.output_type, each.get("data", {})) for each in cell.get("outputs", ())]
    return [(kind, sorted(data)) for kind, data in found if kind == "stream" or any(data.values())]
