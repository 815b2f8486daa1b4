"""An editor in a few lines: a process of `lag lsp` and what it says."""

from __future__ import annotations

import asyncio
import sys
from collections.abc import Callable
from functools import partial
from pathlib import Path
from threading import Condition, Thread
from time import monotonic, sleep
from typing import Any

from lsprotocol import types as lsp
from pygls.lsp.client import LanguageClient

WAIT = 60.0  # seconds, for a loaded machine


class Editor:
    """Speaks with one process. Texts have addresses, versions count from 1."""

    def __init__(self, folder: Path | None = None) -> None:
        self.found: dict[str, lsp.PublishDiagnosticsParams] = {}
        self.times: dict[tuple[str, int | None], float] = {}
        self.shown: list[str] = []
        self.messages: list[str] = []
        self._versions: dict[str, int] = {}
        self._heard = Condition()
        self._loop = asyncio.new_event_loop()
        self._thread = Thread(target=self._loop.run_forever, daemon=True)
        self._thread.start()
        self._client = self._call(self._start())
        capabilities = lsp.ClientCapabilities(
            window=lsp.WindowClientCapabilities(show_document=lsp.ShowDocumentClientCapabilities(support=True)),
            workspace=lsp.WorkspaceClientCapabilities(
                inlay_hint=lsp.InlayHintWorkspaceClientCapabilities(refresh_support=True)
            ),
        )
        folders = [lsp.WorkspaceFolder(folder.as_uri(), folder.name)] if folder is not None else None
        self.offers = self.ask(
            "initialize", lsp.InitializeParams(capabilities=capabilities, workspace_folders=folders)
        ).capabilities
        self.tell("initialized", lsp.InitializedParams())

    async def _start(self) -> LanguageClient:
        client = LanguageClient("tests", "1")
        client.feature(lsp.TEXT_DOCUMENT_PUBLISH_DIAGNOSTICS)(partial(self._published))
        client.feature(lsp.WINDOW_SHOW_DOCUMENT)(partial(self._show))
        client.feature(lsp.WINDOW_SHOW_MESSAGE)(lambda params: self.messages.append(params.message))
        client.feature(lsp.WORKSPACE_INLAY_HINT_REFRESH)(lambda params: None)
        await client.start_io(sys.executable, "-m", "lagdsl", "lsp")
        return client

    @property
    def process(self) -> int:
        """The number of the process."""
        server: Any = self._client._server
        return int(server.pid)

    def close(self) -> None:
        self.ask("shutdown", None)
        self.tell("exit", None)
        self._call(self._client.stop())
        self._loop.call_soon_threadsafe(self._loop.stop)
        self._thread.join(WAIT)
        self._loop.close()

    # ---- what the server says ----------------------------------------------------------------------------------------

    def _published(self, params: lsp.PublishDiagnosticsParams) -> None:
        with self._heard:
            self.found[params.uri] = params
            self.times.setdefault((params.uri, params.version), monotonic())
            self._heard.notify_all()

    def _show(self, params: lsp.ShowDocumentParams) -> lsp.ShowDocumentResult:
        self.shown.append(params.uri)
        return lsp.ShowDocumentResult(success=True)

    def wait(self, is_there: Callable[[], bool]) -> None:
        with self._heard:
            assert self._heard.wait_for(is_there, WAIT), "the server says nothing"

    @staticmethod
    def ask_until(is_there: Callable[[], bool]) -> None:
        """Asks again and again, without the lock that the messages of the server need."""
        end = monotonic() + WAIT
        while not is_there():
            assert monotonic() < end, "the answer stays another one"
            sleep(0.05)

    def diagnostics(self, uri: str, *, having: str | None = None) -> list[lsp.Diagnostic]:
        """Diagnostics of the last version; with `having` as soon as that code is among it."""

        def is_there() -> bool:
            known = self.found.get(uri)
            if known is None or known.version != self._versions[uri]:
                return False
            return having is None or any(each.code == having for each in known.diagnostics)

        self.wait(is_there)
        return list(self.found[uri].diagnostics)

    # ---- what the editor says ----------------------------------------------------------------------------------------

    def _call(self, coroutine: Any) -> Any:
        return asyncio.run_coroutine_threadsafe(coroutine, self._loop).result(WAIT)

    def ask(self, method: str, params: Any) -> Any:
        """The answer to a request; raises JsonRpcException."""

        async def answer() -> Any:
            return await self._client.protocol.send_request_async(method, params)

        return self._call(answer())

    def tell(self, method: str, params: Any) -> None:
        self._loop.call_soon_threadsafe(self._client.protocol.notify, method, params)

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
