"""The server of a live report: three addresses, read from a folder in which the analysing process puts what is new."""

from __future__ import annotations

import json
import os
import socket
from collections.abc import Mapping
from http.server import BaseHTTPRequestHandler, HTTPServer
from pathlib import Path
from typing import Any

from rosarch.base.cache import hash_of
from rosarch.base.whole import write_whole

_DOCUMENT, _STATE = "document.json", "state.json"
_HEADERS = {
    "Cache-Control": "no-store",
    "X-Content-Type-Options": "nosniff",
    "X-Frame-Options": "DENY",
    "Referrer-Policy": "no-referrer",
    "Cross-Origin-Resource-Policy": "same-origin",
}


def put_document(current: Path, document: Mapping[str, Any]) -> None:
    """What is served from now on."""
    text = json.dumps(document, ensure_ascii=False, separators=(",", ":")).encode("utf-8", "backslashreplace")
    write_whole(current / _DOCUMENT, text)
    _put_state(current, {"revision": hash_of([text]), "error": None})


def put_error(current: Path, error: str) -> None:
    """Why there is nothing new."""
    _put_state(current, {**_state(current), "error": error})


def _put_state(current: Path, state: Mapping[str, Any]) -> None:
    write_whole(current / _STATE, json.dumps(state).encode())


def _state(current: Path) -> dict[str, Any]:
    """What there is now: `revision` is empty before the first document."""
    try:
        found: dict[str, Any] = json.loads((current / _STATE).read_text(encoding="utf-8"))
        return found
    except FileNotFoundError:
        return {"revision": "", "error": None}


def serve_live(listener: socket.socket, title: str, current: Path) -> None:
    """Answer until the process ends."""
    from rosarch.reports.html.page import live_page

    host, port = listener.getsockname()[:2]
    page, policy = live_page(title)

    class Handler(BaseHTTPRequestHandler):
        """Answers requests for the page, the document, and what there is now."""

        def do_GET(self) -> None:
            if self.headers.get("Host") not in (f"{host}:{port}", f"localhost:{port}"):
                self._answer(403, "text/plain", b"not for other hosts\n")  # a page from elsewhere that calls itself this one
            elif self.path == "/":
                self._answer(200, "text/html; charset=utf-8", page.encode())
            elif self.path == "/state":
                self._answer(200, "application/json", json.dumps(_state(current)).encode())
            elif self.path == "/document" and (current / _DOCUMENT).is_file():
                self._answer(200, "application/json", (current / _DOCUMENT).read_bytes())
            else:
                self._answer(404, "text/plain", b"there is nothing here\n")

        def _answer(self, code: int, type_: str, body: bytes) -> None:
            self.send_response(code)
            headers = {**_HEADERS, "Content-Security-Policy": policy, "Content-Type": type_, "Content-Length": str(len(body))}
            for name, value in headers.items():
                self.send_header(name, value)
            self.end_headers()
            self.wfile.write(body)

        def log_message(self, format: str, *args: Any) -> None:
            """Say nothing."""

    parent = os.getppid()

    class Server(HTTPServer):
        """Ends when the analysing process has."""

        def service_actions(self) -> None:
            if os.getppid() != parent:
                raise SystemExit

    server = Server((host, port), Handler, bind_and_activate=False)
    server.socket.close()
    server.socket = listener
    server.serve_forever()
