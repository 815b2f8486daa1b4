"""Proposals as the editor can show them: not each editor has snippets and Markdown.

Source: LSP 3.17, CompletionClientCapabilities.
"""

from __future__ import annotations

from lsprotocol import types as lsp
from pygls.capabilities import get_capability

_ITEM = "text_document.completion.completion_item"


def showable(item: lsp.CompletionItem, capabilities: lsp.ClientCapabilities) -> lsp.CompletionItem:
    """The item; its snippet is the word alone and its Markdown a plain text where the editor has none."""
    has_snippets = get_capability(capabilities, f"{_ITEM}.snippet_support", False)
    formats = get_capability(capabilities, f"{_ITEM}.documentation_format", ()) or ()
    if item.insert_text_format is lsp.InsertTextFormat.Snippet and not has_snippets:
        item.insert_text, item.insert_text_format = None, None
        item.kind = lsp.CompletionItemKind.Keyword
    if isinstance(item.documentation, lsp.MarkupContent) and lsp.MarkupKind.Markdown not in formats:
        item.documentation = item.documentation.value
    return item
