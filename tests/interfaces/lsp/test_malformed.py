"""Malformed messages: every request has an answer, standard error has no traceback, and the server goes on."""

from __future__ import annotations

import json
import re
import subprocess
import sys
from typing import Any

import pytest

URI = "file:///nowhere/m.lag"
TEXT = {"uri": URI}
START = {"line": 0, "character": 6}
INVALID_PARAMS, INVALID_REQUEST, NOT_JSON, NO_METHOD = -32602, -32600, -32700, -32601
MALFORMED: list[tuple[str, Any]] = [
    ("hover", {"textDocument": TEXT, "position": {"line": -1, "character": 0}}),
    ("hover", {"textDocument": TEXT, "position": {"line": 2**40, "character": 0}}),
    ("hover", {"textDocument": None, "position": None}),
    ("hover", {"jsonrpc": "2.0", "textDocument": TEXT, "position": START}),
    ("definition", {}),
    ("definition", []),
    ("definition", 5),
    ("definition", None),
    ("formatting", {"textDocument": TEXT, "options": {"tabSize": "x", "insertSpaces": 7}}),
    ("formatting", {"textDocument": TEXT, "options": []}),
    ("completion", {"textDocument": TEXT, "position": {"line": 0, "character": "a"}}),
    ("references", {"textDocument": TEXT, "position": START}),
    ("codeAction", {"textDocument": TEXT, "range": {"start": START}}),
    ("rename", {"textDocument": TEXT, "position": START, "newName": 3}),
]
BODIES: list[tuple[bytes, object, int]] = [
    (b"{not json", None, NOT_JSON),
    (b"\xff\xfe", None, NOT_JSON),
    (b"[" * 100_000, None, NOT_JSON),
    (b'{"a":' * 100_000, None, NOT_JSON),
    (b'{"a":' + b"[" * 600 + b"]" * 600 + b"}", None, NOT_JSON),
    (b'{"jsonrpc": "2.0", "id": "v", "method": "no/such", "params": ["' + b"[" * 600 + b'"]}', "v", NO_METHOD),
    (b"[]", None, INVALID_REQUEST),
    (b"5", None, INVALID_REQUEST),
    (b'{"id": 77, "method": "textDocument/hover"}', 77, INVALID_REQUEST),
    (b'{"jsonrpc": "1.0", "id": 78, "method": "shutdown"}', 78, INVALID_REQUEST),
    (b'{"jsonrpc": "2.0", "id": 79}', 79, INVALID_REQUEST),
    (b'{"jsonrpc": "2.0", "id": "s", "method": 5}', "s", INVALID_REQUEST),
    (b'{"jsonrpc": "2.0", "id": [1], "method": "textDocument/hover", "params": {}}', None, INVALID_PARAMS),
    (b'{"jsonrpc": "2.0", "id": "t", "method": "no/such"}', "t", NO_METHOD),
]


def framed(body: bytes) -> bytes:
    return b"Content-Length: %d\r\n\r\n" % len(body) + body


def message(method: str, params: Any, **number: int) -> bytes:
    return framed(json.dumps({"jsonrpc": "2.0", "method": method, "params": params, **number}).encode())


@pytest.fixture(scope="module")
def said() -> tuple[list[dict[str, Any]], str]:
    """All messages of a server, which heard all of this, and its standard error."""
    text = {"uri": URI, "languageId": "lag", "version": 1, "text": "model M\nend M;\n"}
    heard = [
        message("initialize", {"processId": None, "rootUri": None, "capabilities": {}}, id=0),
        message("textDocument/didOpen", {"textDocument": text}),
        message("textDocument/didChange", {}),
        *(message(f"textDocument/{method}", params, id=k) for k, (method, params) in enumerate(MALFORMED, 1)),
        *(framed(body) for body, _, _ in BODIES),
        message("textDocument/hover", {"textDocument": TEXT, "position": START}, id=100),
        message("shutdown", None, id=101),
        message("exit", None),
    ]
    done = subprocess.run(
        [sys.executable, "-m", "lagdsl", "lsp"], input=b"".join(heard), capture_output=True, timeout=60, check=True
    )
    bodies = re.split(rb"Content-Length: \d+\r\n(?:Content-Type: [^\r]*\r\n)?\r\n", done.stdout)
    return [json.loads(body) for body in bodies if body], done.stderr.decode()


def test_each_malformed_request_is_answered(said: tuple[list[dict[str, Any]], str]) -> None:
    """Nothing but a message for the user came, and an editor that reads no standard error blocked the server."""
    answers = {each["id"]: each for each in said[0] if each.get("id") is not None}
    for k, (method, _) in enumerate(MALFORMED, 1):
        assert answers[k]["error"]["code"] == INVALID_PARAMS, method
        assert "result" not in answers[k]
    for _, number, code in BODIES:
        if number is not None:
            assert answers[number]["error"]["code"] == code
    unnumbered = [each["error"]["code"] for each in said[0] if each.get("id", 0) is None]
    assert unnumbered == [code for _, number, code in BODIES if number is None]


def test_the_server_goes_on(said: tuple[list[dict[str, Any]], str]) -> None:
    answers = {each["id"]: each for each in said[0] if each.get("id") is not None}
    assert "M" in str(answers[100]["result"]) and answers[101]["result"] is None
    assert not any(each.get("method") == "window/showMessage" for each in said[0])
    assert "Traceback" not in said[1] and len(said[1]) < 200
