"""Methods of the protocol, each with the feature that answers it."""

from __future__ import annotations

from typing import TypeAlias

from lsprotocol import types as lsp
from pygls.exceptions import JsonRpcInvalidParams

from lagdsl.interfaces.lsp.documents import Document
from lagdsl.interfaces.lsp.features.actions import actions
from lagdsl.interfaces.lsp.features.capabilities import showable
from lagdsl.interfaces.lsp.features.completion import completion, resolve
from lagdsl.interfaces.lsp.features.definition import definition, type_definition
from lagdsl.interfaces.lsp.features.folding import folding
from lagdsl.interfaces.lsp.features.formatting import formatting
from lagdsl.interfaces.lsp.features.hints import hints
from lagdsl.interfaces.lsp.features.hover import hover
from lagdsl.interfaces.lsp.features.lenses import COMMANDS, lenses
from lagdsl.interfaces.lsp.features.references import declaration_at, references
from lagdsl.interfaces.lsp.features.rename import Refused, check_renamable, rename
from lagdsl.interfaces.lsp.features.signature import signature
from lagdsl.interfaces.lsp.features.symbols import document_symbols, workspace_symbols
from lagdsl.interfaces.lsp.features.tokens import LEGEND, tokens
from lagdsl.interfaces.lsp.positions import location_of, offset_at, range_of, uri_of
from lagdsl.interfaces.lsp.server import LagServer, folders_of

Placed: TypeAlias = (
    lsp.DefinitionParams
    | lsp.TypeDefinitionParams
    | lsp.ReferenceParams
    | lsp.DocumentHighlightParams
    | lsp.PrepareRenameParams
    | lsp.RenameParams
    | lsp.CompletionParams
    | lsp.SignatureHelpParams
    | lsp.HoverParams
)


def wired(server: LagServer) -> LagServer:
    """The server with all its features."""
    _texts(server)
    _names(server)
    _renaming(server)
    _writing(server)
    _reading(server)
    _commands(server)
    return server


def _texts(server: LagServer) -> None:
    @server.feature(lsp.INITIALIZE)
    def initialize(ls: LagServer, params: lsp.InitializeParams) -> None:
        ls.documents.folders = folders_of(params)

    @server.feature(lsp.TEXT_DOCUMENT_DID_OPEN)
    def did_open(ls: LagServer, params: lsp.DidOpenTextDocumentParams) -> None:
        ls.opened(params.text_document.uri, params.text_document.text, params.text_document.version)

    @server.feature(lsp.TEXT_DOCUMENT_DID_CHANGE)
    def did_change(ls: LagServer, params: lsp.DidChangeTextDocumentParams) -> None:
        identifier = params.text_document
        ls.changed(identifier.uri, ls.workspace.get_text_document(identifier.uri).source, identifier.version)

    @server.feature(lsp.TEXT_DOCUMENT_DID_SAVE)
    def did_save(ls: LagServer, params: lsp.DidSaveTextDocumentParams) -> None:
        ls.saved()

    @server.feature(lsp.WORKSPACE_DID_CHANGE_WATCHED_FILES)
    def did_change_files(ls: LagServer, params: lsp.DidChangeWatchedFilesParams) -> None:
        ls.saved()

    @server.feature(lsp.TEXT_DOCUMENT_DID_CLOSE)
    def did_close(ls: LagServer, params: lsp.DidCloseTextDocumentParams) -> None:
        ls.closed(params.text_document.uri)


def _place(ls: LagServer, params: Placed) -> tuple[Document, int] | None:
    """The text and the place in it that a question is about; None for a text that is not open."""
    document = ls.documents.of(params.text_document)
    return None if document is None else (document, offset_at(document.snapshot.file, params.position))


def _names(server: LagServer) -> None:
    @server.feature(lsp.TEXT_DOCUMENT_DEFINITION)
    def goto(ls: LagServer, params: lsp.DefinitionParams) -> lsp.Location | None:
        place = _place(ls, params)
        return None if place is None else definition(place[0].snapshot, place[1])

    @server.feature(lsp.TEXT_DOCUMENT_TYPE_DEFINITION)
    def goto_type(ls: LagServer, params: lsp.TypeDefinitionParams) -> lsp.Location | None:
        place = _place(ls, params)
        return None if place is None else type_definition(place[0].snapshot, place[1])

    @server.feature(lsp.TEXT_DOCUMENT_REFERENCES)
    def refer(ls: LagServer, params: lsp.ReferenceParams) -> list[lsp.Location]:
        place = _place(ls, params)
        wanted = None if place is None else declaration_at(place[0].snapshot, place[1])
        if wanted is None:
            return []
        texts, with_it = ls.documents.texts(wanted.name), params.context.include_declaration
        return [location_of(each) for each in references(texts, wanted, with_declaration=with_it)]

    @server.feature(lsp.TEXT_DOCUMENT_DOCUMENT_HIGHLIGHT)
    def highlight(ls: LagServer, params: lsp.DocumentHighlightParams) -> list[lsp.DocumentHighlight]:
        place = _place(ls, params)
        wanted = None if place is None else declaration_at(place[0].snapshot, place[1])
        found = [] if place is None or wanted is None else references([place[0].snapshot], wanted)
        return [lsp.DocumentHighlight(range_of(each)) for each in found]


def _renaming(server: LagServer) -> None:
    @server.feature(lsp.TEXT_DOCUMENT_PREPARE_RENAME)
    def prepare(ls: LagServer, params: lsp.PrepareRenameParams) -> lsp.Range | None:
        place = _place(ls, params)
        found = None if place is None else place[0].snapshot.occurrence_at(place[1])
        if found is None or found.declaration is None:
            return None
        try:
            check_renamable(found.declaration)
        except Refused as reason:
            raise JsonRpcInvalidParams(str(reason)) from None
        return range_of(found.span)

    @server.feature(lsp.TEXT_DOCUMENT_RENAME, lsp.RenameOptions(prepare_provider=True))
    def change_name(ls: LagServer, params: lsp.RenameParams) -> lsp.WorkspaceEdit | None:
        place = _place(ls, params)
        wanted = None if place is None else declaration_at(place[0].snapshot, place[1])
        if wanted is None:
            return None
        try:
            changes = rename(list(ls.documents.texts(wanted.name)), wanted, params.new_name)
        except Refused as reason:
            raise JsonRpcInvalidParams(str(reason)) from None
        edits = {
            uri_of(snapshot.file): [lsp.TextEdit(range_of(span), params.new_name) for span in spans]
            for snapshot, spans in changes.items()
        }
        return lsp.WorkspaceEdit(changes=edits)


def _writing(server: LagServer) -> None:
    triggers = lsp.CompletionOptions(trigger_characters=[".", " "], resolve_provider=True)

    @server.feature(lsp.TEXT_DOCUMENT_COMPLETION, triggers)
    def complete(ls: LagServer, params: lsp.CompletionParams) -> lsp.CompletionList | None:
        place = _place(ls, params)
        if place is None:
            return None
        found = completion(place[0].snapshot, place[1])
        typed = params.context.trigger_character if params.context is not None else None
        if typed == " " and not all(item.kind == lsp.CompletionItemKind.Unit for item in found.items):
            return None
        found.items = [showable(item, ls.client_capabilities) for item in found.items]
        return found

    @server.feature(lsp.COMPLETION_ITEM_RESOLVE)
    def resolved(ls: LagServer, item: lsp.CompletionItem) -> lsp.CompletionItem:
        return showable(resolve(item), ls.client_capabilities)

    @server.feature(lsp.TEXT_DOCUMENT_SIGNATURE_HELP, lsp.SignatureHelpOptions(trigger_characters=["(", ","]))
    def help_(ls: LagServer, params: lsp.SignatureHelpParams) -> lsp.SignatureHelp | None:
        place = _place(ls, params)
        return None if place is None else signature(place[0].snapshot, place[1])

    @server.feature(lsp.TEXT_DOCUMENT_FORMATTING)
    def layout(ls: LagServer, params: lsp.DocumentFormattingParams) -> list[lsp.TextEdit]:
        document = ls.documents.of(params.text_document)
        return [] if document is None else formatting(document.snapshot)

    kinds = lsp.CodeActionOptions(code_action_kinds=[lsp.CodeActionKind.QuickFix])

    @server.feature(lsp.TEXT_DOCUMENT_CODE_ACTION, kinds)
    def act(ls: LagServer, params: lsp.CodeActionParams) -> list[lsp.CodeAction]:
        document = ls.documents.of(params.text_document)
        if document is None or document.checked is not document.snapshot:
            return []
        file = document.snapshot.file
        start, end = offset_at(file, params.range.start), offset_at(file, params.range.end)
        return actions(document.snapshot, document.uri, document.found, start, end)


def _reading(server: LagServer) -> None:
    @server.feature(lsp.TEXT_DOCUMENT_HOVER)
    def tell(ls: LagServer, params: lsp.HoverParams) -> lsp.Hover | None:
        place = _place(ls, params)
        return None if place is None else hover(place[0].with_values(), place[1], place[0].depth)

    @server.feature(lsp.TEXT_DOCUMENT_DOCUMENT_SYMBOL)
    def outline(ls: LagServer, params: lsp.DocumentSymbolParams) -> list[lsp.DocumentSymbol]:
        document = ls.documents.of(params.text_document)
        return [] if document is None else document_symbols(document.snapshot)

    @server.feature(lsp.WORKSPACE_SYMBOL)
    def search(ls: LagServer, params: lsp.WorkspaceSymbolParams) -> list[lsp.WorkspaceSymbol]:
        return workspace_symbols(ls.documents.texts(), params.query)

    @server.feature(lsp.TEXT_DOCUMENT_SEMANTIC_TOKENS_FULL, LEGEND)
    def color(ls: LagServer, params: lsp.SemanticTokensParams) -> lsp.SemanticTokens | None:
        document = ls.documents.of(params.text_document)
        return None if document is None else tokens(document.snapshot)

    @server.feature(lsp.TEXT_DOCUMENT_FOLDING_RANGE)
    def fold(ls: LagServer, params: lsp.FoldingRangeParams) -> list[lsp.FoldingRange]:
        document = ls.documents.of(params.text_document)
        return [] if document is None else folding(document.snapshot)

    @server.feature(lsp.TEXT_DOCUMENT_INLAY_HINT)
    def hint(ls: LagServer, params: lsp.InlayHintParams) -> list[lsp.InlayHint]:
        document = ls.documents.of(params.text_document)
        if document is None:
            return []
        depth = document.depth if document.depth_of is document.snapshot else None
        return hints(document.snapshot, depth)

    @server.feature(lsp.TEXT_DOCUMENT_CODE_LENS)
    def lens(ls: LagServer, params: lsp.CodeLensParams) -> list[lsp.CodeLens]:
        document = ls.documents.of(params.text_document)
        return [] if document is None else lenses(document.snapshot, document.uri)


def _commands(server: LagServer) -> None:
    for name, word in COMMANDS.items():
        _command(server, name, word)


def _command(server: LagServer, name: str, word: str) -> None:
    @server.command(name)
    async def run(ls: LagServer, *arguments: object) -> str | None:
        return await ls.execute(word, list(arguments))
