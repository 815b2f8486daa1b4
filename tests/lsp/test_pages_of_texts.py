"""The page that follows the text, as a browser asks for it."""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path
from urllib.error import HTTPError
from urllib.request import urlopen

import pytest
from lsp_editor import Editor
from lsp_texts import PENDULUM
from lsprotocol import types as lsp


@pytest.fixture
def editor() -> Iterator[Editor]:
    made = Editor()
    yield made
    made.close()


def _read(address: str) -> str:
    with urlopen(address, timeout=60) as answer:
        return str(answer.read().decode())


def test_the_page_follows_the_text(editor: Editor, tmp_path: Path) -> None:
    uri = editor.open((tmp_path / "pendulum.lag").as_uri(), PENDULUM)
    editor.diagnostics(uri)
    command = lsp.ExecuteCommandParams("lagdsl.show", arguments=[uri, "Pendulum"])
    address = editor.ask("workspace/executeCommand", command)
    assert address.startswith("http://127.0.0.1:")
    assert address in editor.shown
    assert "<iframe" in _read(address)
    assert _read(f"{address}version?0") == "1"
    first = _read(f"{address}page")
    assert "Content-Security-Policy" in first
    editor.change(uri, PENDULUM.replace("0.5 m", "0.75 m"))
    assert _read(f"{address}version?1") == "2"
    second = _read(f"{address}page")
    assert "0.75 m" in second
    assert "0.75 m" not in first
    for stranger in ("", "x/", f"{address.split('/')[3]}/other", f"{address.split('/')[3]}/../page"):
        with pytest.raises(HTTPError, match="404"):
            _read("/".join(address.split("/")[:3]) + f"/{stranger}")
