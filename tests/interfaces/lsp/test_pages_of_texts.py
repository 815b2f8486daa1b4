"""The page that follows the text, as a browser asks for it. The editor is Emacs: it opens no pages, has no snippets."""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path
from urllib.error import HTTPError
from urllib.request import urlopen

import pytest
from lsp_editor import Editor
from lsp_texts import PENDULUM
from lsprotocol import types as lsp


@pytest.fixture(scope="module")
def editor() -> Iterator[Editor]:
    made = Editor(like="emacs")
    yield made
    made.close()


def _read(address: str) -> str:
    with urlopen(address, timeout=60) as answer:
        return str(answer.read().decode())


def test_the_page_follows_the_text(editor: Editor, tmp_path: Path) -> None:
    uri = editor.open((tmp_path / "pendulum.lag").as_uri(), PENDULUM)
    editor.diagnostics_of(uri)
    command = lsp.ExecuteCommandParams("lagdsl.show", arguments=[uri, "Pendulum"])
    address = editor.ask("workspace/executeCommand", command)
    assert address.startswith("http://127.0.0.1:")
    assert address in [each.message for each in editor.messages]
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
        with pytest.raises(HTTPError, match="404") as refused:
            _read("/".join(address.split("/")[:3]) + f"/{stranger}")
        refused.value.close()


def test_an_editor_without_snippets_and_markdown_gets_plain_words(editor: Editor, tmp_path: Path) -> None:
    text = 'model A\n  parameter Mass m = 1 kg "**heavy**";\n  \nend A;\n'
    uri = editor.open((tmp_path / "plain.lag").as_uri(), text)
    offered = {item.label: item for item in editor.about("completion", uri, text, ";\n  |\n").items}
    assert offered["coordinate"].insert_text is None
    assert not any("${" in (item.insert_text or "") for item in offered.values())
    assert offered["m"].documentation == "**heavy**"
