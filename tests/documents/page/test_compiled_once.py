"""`lag show` compiles a model once, whatever the page says of the start of its motion."""

from __future__ import annotations

from pathlib import Path

import pytest
from click.testing import CliRunner

from lagdsl.derivation.mechanics import arrange as arranging
from lagdsl.interfaces.cli.main import lag


@pytest.mark.parametrize("name", ["pendulum", "four_bar_points"])
def test_one_compilation_for_a_page(name: str, root: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """The first has no constraint; the start of the second lies on its constraints, for page and drawing."""
    arrange, made = arranging.arrange, []

    def counting(equations: object) -> object:
        made.append(equations)
        return arrange(equations)  # type: ignore[arg-type]

    monkeypatch.setattr(arranging, "arrange", counting)
    path = tmp_path / "page.html"
    arguments = ["show", str(root / "models" / f"{name}.lag"), "-o", str(path), "--no-open"]
    done = CliRunner().invoke(lag, arguments)
    assert done.exit_code == 0, done.output
    assert len(made) == 1
    assert "The system" in path.read_text(encoding="utf-8")
