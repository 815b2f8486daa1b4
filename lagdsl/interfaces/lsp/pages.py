"""Living pages in a browser, which load themselves anew when the text has changed.

Pages are served to this computer only, under an address that nobody can guess.
"""

from __future__ import annotations

import secrets
import tempfile
from html import escape
from http.server import BaseHTTPRequestHandler, ThreadingHTTPServer
from pathlib import Path
from threading import Condition, Thread

_FRAME = """<!doctype html>
<html lang="en"><head><meta charset="utf-8"><title>{title}</title>
<style>html,body,iframe{{margin:0;border:0;width:100%;height:100%;display:block}}</style></head>
<body><iframe id="page" title="{title}" src="page"></iframe><script>
const follow = async (known) => {{
  for (;;) {{
    try {{
      const version = await (await fetch("version?" + known)).text();
      if (version !== known) {{ known = version; document.getElementById("page").src = "page?" + version; }}
    }} catch {{ await new Promise((done) => setTimeout(done, 2000)); }}
  }}
}};
follow("{version}");
</script></body></html>
"""
_LONGEST_WAIT = 25.0  # seconds, after which a browser asks again


class Shown:
    """The page of one text: the file that holds it and how often it was written."""

    def __init__(self, title: str, path: Path) -> None:
        self.title = title
        self.path = path
        self.version = 0
        self.changed = Condition()

    def written(self) -> None:
        with self.changed:
            self.version += 1
            self.changed.notify_all()

    def wait(self, known: str) -> str:
        """The version, as soon as it is another one than `known`."""
        with self.changed:
            self.changed.wait_for(lambda: str(self.version) != known, _LONGEST_WAIT)
            return str(self.version)


class Pages:
    """The pages that are open, by the addresses of their texts."""

    def __init__(self) -> None:
        self._by_uri: dict[str, tuple[str, Shown]] = {}
        self._by_token: dict[str, Shown] = {}
        self._folder: tempfile.TemporaryDirectory[str] | None = None
        self._server: ThreadingHTTPServer | None = None

    def of(self, uri: str) -> Shown | None:
        found = self._by_uri.get(uri)
        return None if found is None else found[1]

    def open(self, uri: str, title: str) -> tuple[str, Shown]:
        """The address of the page of a text, and the page."""
        if self._server is None:
            self._start()
        if uri not in self._by_uri:
            token = secrets.token_urlsafe(24)
            assert self._folder is not None
            shown = Shown(title, Path(self._folder.name) / f"{token}.html")
            self._by_uri[uri], self._by_token[token] = (token, shown), shown
        token, shown = self._by_uri[uri]
        assert self._server is not None
        return f"http://127.0.0.1:{self._server.server_address[1]}/{token}/", shown

    def close(self) -> None:
        if self._server is not None:
            self._server.shutdown()
            self._server.server_close()
        if self._folder is not None:
            self._folder.cleanup()

    def _start(self) -> None:
        self._folder = tempfile.TemporaryDirectory(prefix="lag-pages-")
        pages = self._by_token

        class Handler(BaseHTTPRequestHandler):
            def do_GET(self) -> None:
                _answer(self, pages)

            def log_message(self, format: str, *args: object) -> None:
                """Nothing: standard error is for the editor."""

        self._server = ThreadingHTTPServer(("127.0.0.1", 0), Handler)
        self._server.daemon_threads = True
        Thread(target=self._server.serve_forever, daemon=True).start()


def _answer(handler: BaseHTTPRequestHandler, pages: dict[str, Shown]) -> None:
    path, _, query = handler.path.partition("?")
    parts = path.split("/")
    shown = pages.get(parts[1]) if len(parts) == 3 else None
    if shown is None:
        handler.send_error(404)
        return
    match parts[2]:
        case "":
            text = _FRAME.format(title=escape(shown.title), version=shown.version)
            _send(handler, "text/html; charset=utf-8", text.encode())
        case "version":
            _send(handler, "text/plain", shown.wait(query).encode())
        case "page":
            waiting = "<!doctype html><title>…</title><p>The page is being computed.</p>"
            content = shown.path.read_bytes() if shown.path.is_file() else waiting.encode()
            _send(handler, "text/html; charset=utf-8", content)
        case _:
            handler.send_error(404)


def _send(handler: BaseHTTPRequestHandler, kind: str, content: bytes) -> None:
    handler.send_response(200)
    handler.send_header("Content-Type", kind)
    handler.send_header("Content-Length", str(len(content)))
    handler.send_header("Cache-Control", "no-store")
    handler.end_headers()
    handler.wfile.write(content)
