"""Messages of an editor: each request is answered, with an error where it cannot be read.

Source: JSON-RPC 2.0 specification, sections 4.2 and 5.1; LSP 3.17. pygls 2.1 answers no request whose parameters do not
fit their types; it shows a message to the user, and writes so many lines about it that an editor which reads none
blocks it.
"""

from __future__ import annotations

import logging
from collections.abc import Generator
from dataclasses import dataclass
from typing import Any

from lsprotocol import types as lsp
from pygls.exceptions import (
    JsonRpcException,
    JsonRpcInvalidParams,
    JsonRpcInvalidRequest,
    JsonRpcMethodNotFound,
    JsonRpcParseError,
)
from pygls.protocol import LanguageServerProtocol, lsp_method

_LOGGERS = ("pygls.protocol.json_rpc", "pygls.server")
_NOT_JSON = (ValueError, RecursionError)  # UnicodeDecodeError is a ValueError
_NO_MESSAGE = "this is no message of JSON-RPC 2.0"


@dataclass(frozen=True)
class Malformed:
    """A message that cannot be read: members of its object, and what is wrong with them."""

    members: dict[str, Any]
    error: JsonRpcException


class LagProtocol(LanguageServerProtocol):
    """The protocol that answers malformed requests."""

    @lsp_method(lsp.INITIALIZE)
    def lsp_initialize(self, params: lsp.InitializeParams) -> Generator[Any, Any, lsp.InitializeResult]:
        """Columns count units of UTF-16, which every editor knows (LSP 3.17, positions), also where pygls would promise
        the first encoding of the editor's list."""
        if params.capabilities.general is not None:
            params.capabilities.general.position_encodings = None
        return (yield from super().lsp_initialize(params))

    def structure_message(self, data: dict[str, Any]) -> Any:
        """An object of JSON as a message, `Malformed` where it is none of the protocol."""
        try:
            return super().structure_message(data)
        except JsonRpcException:
            return Malformed(data, self._fault(data.get("method")))

    def _fault(self, method: object) -> JsonRpcException:
        if not isinstance(method, str):
            return JsonRpcInvalidRequest(_NO_MESSAGE)
        if self.get_message_type(method) is None:
            return JsonRpcMethodNotFound(f"there is no method `{method}`")
        return JsonRpcInvalidParams(f"the parameters of `{method}` do not fit their types")

    def handle_message(self, message: Any) -> None:
        """Answer what is malformed; notifications have no answer."""
        if isinstance(message, Malformed):
            if "id" in message.members:
                self.refuse(message.members["id"], message.error)
        elif getattr(message, "jsonrpc", None) != self.VERSION:
            members = message if isinstance(message, dict) else {"id": getattr(message, "id", None)}
            self.refuse(members.get("id"), JsonRpcInvalidRequest(_NO_MESSAGE))
        else:
            super().handle_message(message)

    def refuse(self, number: object, error: JsonRpcException) -> None:
        """Answer a request with an error; a number that is none is null."""
        known = number if isinstance(number, int | str) and not isinstance(number, bool) else None
        told = {"code": error.code, "message": error.message}
        self._send_data({"jsonrpc": self.VERSION, "id": known, "error": told})  # classes of messages leave null out

    def refuse_text(self, error: Exception) -> bool:
        """Answer a message that is not JSON; False if the error is another one."""
        if isinstance(error, _NOT_JSON):
            self.refuse(None, JsonRpcParseError("the message is not JSON"))
        return isinstance(error, _NOT_JSON)


def quiet() -> None:
    """No lines on standard error about what the editor is told in an answer."""
    for name in _LOGGERS:
        logging.getLogger(name).addFilter(_is_news)


def _is_news(record: logging.LogRecord) -> bool:
    error = record.exc_info[1] if record.exc_info else None
    return not (
        isinstance(error, (JsonRpcException, *_NOT_JSON)) or str(record.msg).startswith("Unable to deserialize")
    )
