"""An editor: pytest-lsp's client of a process of `lag lsp`, with the versions of what it hears.

pytest-lsp checks that each answer is one that the editor has said it can take, fails the test where a message cannot be
read, and shows the log of the server with a test that fails. The process starts once for a file of tests."""

from __future__ import annotations

import asyncio
import sys
from collections.abc import Callable, Coroutine
from pathlib import Path
from time import monotonic
from typing import Any, TypeVar

import pytest_lsp
from lsprotocol import types as lsp
from pygls.protocol import default_converter
from pytest_lsp.client import DEFAULT_CLIENT_FEATURES, register_lsp_features

WAIT = 60.0  # seconds, for a loaded machine
COMMAND = [sys.executable, "-m", "lagdsl", "lsp"]
Answer = TypeVar("Answer")


class Editor(pytest_lsp.LanguageClient):
    """Speaks with one process as the editor does whose name it gets. Texts have addresses, versions count from 1.

    The loop of events runs while something is asked or waited for, so that tests are plain functions."""

    def __init__(self, folder: Path | None = None, *, like: str = "neovim") -> None:
        super().__init__(converter_factory=default_converter)
        heard = {**DEFAULT_CLIENT_FEATURES, lsp.TEXT_DOCUMENT_PUBLISH_DIAGNOSTICS: _published}
        heard[lsp.WORKSPACE_INLAY_HINT_REFRESH] = lambda params: None
        register_lsp_features(self, heard)
        self.found: dict[str, lsp.PublishDiagnosticsParams] = {}
        self.times: dict[tuple[str, int | None], float] = {}
        self._versions: dict[str, int] = {}
        self._loop = asyncio.Runner()
        config = pytest_lsp.ClientServerConfig(COMMAND, client_factory=lambda: self)
        self._run(config.start())
        folders = [lsp.WorkspaceFolder(folder.as_uri(), folder.name)] if folder is not None else None
        session = lsp.InitializeParams(pytest_lsp.client_capabilities(like), workspace_folders=folders)
        self.offers = self._run(self.initialize_session(session)).capabilities

    @property
    def process(self) -> int:
        """The number of the process."""
        assert self._server is not None
        return self._server.pid

    def close(self) -> None:
        self._run(self.shutdown_session())
        self._run(self.stop())
        self._loop.close()

    def _run(self, what: Coroutine[Any, Any, Answer]) -> Answer:
        return self._loop.run(asyncio.wait_for(what, WAIT))

    # ---- what the server says ----------------------------------------------------------------------------------------

    def ask_until(self, is_there: Callable[[], bool]) -> None:
        """Asks again and again."""
        end = monotonic() + WAIT
        while not is_there():
            assert monotonic() < end, "the answer stays another one"
            self._run(asyncio.sleep(0.05))

    def diagnostics_of(self, uri: str, *, having: str | None = None) -> list[lsp.Diagnostic]:
        """Diagnostics of the last version; with `having` as soon as that code is among it."""

        def are_there() -> bool:
            known = self.found.get(uri)
            if known is None or known.version != self._versions[uri]:
                return False
            return having is None or any(each.code == having for each in known.diagnostics)

        async def wait() -> None:
            while not are_there():
                await self.wait_for_notification(lsp.TEXT_DOCUMENT_PUBLISH_DIAGNOSTICS)

        self._run(wait())
        return list(self.found[uri].diagnostics)

    # ---- what the editor says ----------------------------------------------------------------------------------------

    def ask(self, method: str, params: Any) -> Any:
        """The answer to a request; raises JsonRpcException."""
        return self._run(self.protocol.send_request_async(method, params))

    def tell(self, method: str, params: Any) -> None:
        async def tell() -> None:
            self.protocol.notify(method, params)

        self._run(tell())

    def open(self, uri: str, text: str) -> str:
        self._versions[uri] = 1
        self.tell("textDocument/didOpen", lsp.DidOpenTextDocumentParams(lsp.TextDocumentItem(uri, "lag", 1, text)))
        return uri

    def change(self, uri: str, text: str) -> int:
        self._versions[uri] += 1
        identifier = lsp.VersionedTextDocumentIdentifier(self._versions[uri], uri)
        changes = [lsp.TextDocumentContentChangeWholeDocument(text)]
        self.tell("textDocument/didChange", lsp.DidChangeTextDocumentParams(identifier, changes))
        return self._versions[uri]

    def about(self, method: str, uri: str, text: str, mark: str, **more: Any) -> Any:
        """The answer about the place in `text` where `mark` has its `|`: `theta|` is behind the first `theta`."""
        before, _, after = mark.partition("|")
        at = text.index(before + after) + len(before)
        line = text.count("\n", 0, at)
        place = lsp.Position(line, at - text.rfind("\n", 0, at) - 1)
        kinds: dict[str, Any] = {
            "hover": lsp.HoverParams,
            "completion": lsp.CompletionParams,
            "definition": lsp.DefinitionParams,
            "typeDefinition": lsp.TypeDefinitionParams,
            "references": lsp.ReferenceParams,
            "documentHighlight": lsp.DocumentHighlightParams,
            "prepareRename": lsp.PrepareRenameParams,
            "rename": lsp.RenameParams,
            "signatureHelp": lsp.SignatureHelpParams,
        }
        params = kinds[method](text_document=lsp.TextDocumentIdentifier(uri), position=place, **more)
        return self.ask(f"textDocument/{method}", params)


def _published(ls: Editor, params: lsp.PublishDiagnosticsParams) -> None:
    ls.found[params.uri] = params
    ls.times.setdefault((params.uri, params.version), monotonic())
