"""The server: what an editor says reaches documents, and what is known of them goes back."""

from __future__ import annotations

import gc
from asyncio import AbstractEventLoop, get_running_loop, to_thread
from collections.abc import Callable
from pathlib import Path
from typing import Any

from lsprotocol import types as lsp
from pygls import uris
from pygls.exceptions import JsonRpcInvalidParams
from pygls.lsp.server import LanguageServer

from lagdsl.foundation.version import __version__
from lagdsl.interfaces.lsp.commands import result_of
from lagdsl.interfaces.lsp.deep import Request
from lagdsl.interfaces.lsp.depths import Depths
from lagdsl.interfaces.lsp.documents import Document, Documents
from lagdsl.interfaces.lsp.features.diagnostics import deeper, shown
from lagdsl.interfaces.lsp.findings import findings
from lagdsl.interfaces.lsp.pages import Pages
from lagdsl.interfaces.lsp.protocol import LagProtocol
from lagdsl.interfaces.lsp.snapshot import Snapshot
from lagdsl.interfaces.lsp.worker import Worker
from lagdsl.language.semantics.classes.library import hold

REST = 0.15
"""Seconds without a key before a text is looked at."""
DEEP_REST = 0.5
"""Seconds before its equations are formed."""
_VERSIONS_PER_COLLECTION = 20


class LagServer(LanguageServer):
    """The server with its documents, its two queues and its pages."""

    def __init__(self) -> None:
        full = lsp.TextDocumentSyncKind.Full
        super().__init__("lag", __version__, protocol_cls=LagProtocol, text_document_sync_kind=full)
        self.documents = Documents()
        self.pages = Pages()
        self.depths = Depths()
        self.loop: AbstractEventLoop | None = None
        self._versions = 0  # since the last collection
        self.quick = Worker(REST, self._look)
        self.deep = Worker(DEEP_REST, self._look_deep)

    def report_server_error(self, error: Exception, source: Any) -> None:
        """Answer a message that is not JSON; the user is shown what nobody asked for."""
        if not (isinstance(self.protocol, LagProtocol) and self.protocol.refuse_text(error)):
            super().report_server_error(error, source)

    # ---- texts -------------------------------------------------------------------------------------------------------

    def opened(self, uri: str, text: str, version: int) -> None:
        self.loop = get_running_loop()
        self.documents.open[uri] = Document(uri, text, version)
        self.quick.ask(uri, rest=0.0)

    def changed(self, uri: str, text: str, version: int) -> None:
        document = self.documents.open.get(uri)
        if document is None:
            self.opened(uri, text, version)
            return
        self._versions += 1
        document.change(text, version)
        self.deep.forget(uri)
        self.depths.cancel()
        self.quick.ask(uri)

    def _hold(self, document: Document) -> None:
        """Other texts that import this one see it as the editor holds it."""
        hold(self.documents.held())
        for other in self.documents.naming(document):
            other.refresh()
            self.quick.ask(other.uri)

    def saved(self) -> None:
        """A file has changed on disk: texts that import it may say something else."""
        for document in self.documents.open.values():
            document.refresh()
            self.quick.ask(document.uri)

    def closed(self, uri: str) -> None:
        document = self.documents.open.pop(uri, None)
        self.quick.forget(uri)
        self.deep.forget(uri)
        if document is not None:
            self._hold(document)
        self.text_document_publish_diagnostics(lsp.PublishDiagnosticsParams(uri, []))

    def end(self) -> None:
        self.quick.end()
        self.deep.end()
        self.depths.stop()
        self.pages.close()

    # ---- findings: in the threads of the queues ----------------------------------------------------------------------

    def _look(self, uri: str) -> None:
        document = self.documents.open.get(uri)
        if document is None:
            return
        snapshot = document.snapshot
        found = findings(snapshot, document.memory)
        if document.snapshot is not snapshot:
            return
        document.checked, document.found = snapshot, found
        if snapshot.is_whole and document.whole != snapshot.text:
            document.whole = snapshot.text
            self._hold(document)
        self._publish(document, snapshot, shown(found, snapshot.file))
        if snapshot.is_whole:
            self.deep.ask(uri)
        if self._versions >= _VERSIONS_PER_COLLECTION:
            self._versions = 0
            self._call(self._forget_notifications)
            gc.collect()  # scopes and instances of versions that are gone hold one another

    def _look_deep(self, uri: str) -> None:
        document = self.documents.open.get(uri)
        if document is None:
            return
        snapshot = document.snapshot
        page = self.pages.of(uri)
        path = None if page is None else str(page.path)
        held = self.documents.held()
        request = Request(name=snapshot.file.name, text=snapshot.text, page=path, held=held)
        depth = self.depths.ask(request)
        if depth is None or document.snapshot is not snapshot or document.checked is not snapshot:
            return
        document.depth, document.depth_of = depth, snapshot
        known = shown(document.found, snapshot.file)
        self._publish(document, snapshot, [*known, *deeper(depth, snapshot.file, document.found)])
        self._call(self._refresh)
        if page is not None and depth.page:
            page.written()

    def _publish(self, document: Document, snapshot: Snapshot, found: list[lsp.Diagnostic]) -> None:
        def publish() -> None:
            if document.snapshot is snapshot and document.uri in self.documents.open:
                parameters = lsp.PublishDiagnosticsParams(document.uri, found, snapshot.version)
                self.text_document_publish_diagnostics(parameters)

        self._call(publish)

    def _call(self, action: Callable[[], None]) -> None:
        """In the thread that talks to the editor."""
        if self.loop is not None and not self.loop.is_closed():
            self.loop.call_soon_threadsafe(action)

    def _forget_notifications(self) -> None:
        """pygls 2.1 keeps a future for each notification that it handles itself, too: 2 KiB a key."""
        futures = self.protocol._request_futures
        for message in [message for message, future in futures.items() if future.done()]:
            del futures[message]

    def _refresh(self) -> None:
        workspace = self.client_capabilities.workspace
        if workspace is not None and workspace.inlay_hint is not None and workspace.inlay_hint.refresh_support:
            self.workspace_inlay_hint_refresh(None)

    # ---- questions ---------------------------------------------------------------------------------------------------

    async def execute(self, word: str, arguments: list[Any]) -> str | None:
        """Run a command of a lens on a text; the address of what it made."""
        uri, model = _arguments(arguments)
        document = self.documents.open.get(uri)
        if document is None:
            raise JsonRpcInvalidParams(f"no text `{uri}` is open")
        if word == "show":
            return self._show(document, model)
        snapshot = document.snapshot
        path = await to_thread(result_of, word, snapshot.file.name, snapshot.text, model)
        address = uris.from_fs_path(str(path)) or path.as_uri()
        self._open(address, external=path.suffix == ".html")
        return address

    def _show(self, document: Document, model: str) -> str:
        address, _ = self.pages.open(document.uri, model)
        self.deep.ask(document.uri, rest=0.0)
        self._open(address, external=True)
        return address

    def _open(self, address: str, *, external: bool) -> None:
        window = self.client_capabilities.window
        if window is not None and window.show_document is not None and window.show_document.support:
            self.window_show_document(lsp.ShowDocumentParams(address, external=external), lambda _: None)
        else:
            self.window_show_message(lsp.ShowMessageParams(lsp.MessageType.Info, address))


def _arguments(arguments: list[Any]) -> tuple[str, str]:
    """Address and model; a client may wrap them in one more list."""
    if len(arguments) == 1 and isinstance(arguments[0], list):
        arguments = arguments[0]
    if len(arguments) != 2 or not all(isinstance(each, str) for each in arguments):
        raise JsonRpcInvalidParams("a command takes the address of a text and the name of a model")
    return arguments[0], arguments[1]


def folders_of(parameters: lsp.InitializeParams) -> list[Path]:
    """The folders of the workspace."""
    found = [folder.uri for folder in parameters.workspace_folders or ()]
    if not found and parameters.root_uri is not None:
        found = [parameters.root_uri]
    return [Path(path) for uri in found if (path := uris.to_fs_path(uri)) is not None]
