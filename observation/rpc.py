"""XML-RPC as ROS 1 speaks it: calls with a time limit, and servers on loopback."""

from __future__ import annotations

import http.client
import socketserver
import threading
from collections.abc import Callable, Mapping
from typing import Any
from urllib.parse import urlsplit
from xml.parsers.expat import ExpatError
from xmlrpc.client import Fault, ProtocolError, ResponseError, ServerProxy, Transport
from xmlrpc.server import SimpleXMLRPCRequestHandler, SimpleXMLRPCServer

LOOPBACK = "127.0.0.1"
SUCCESS = 1


class CallError(Exception):
    """A server that does not answer, or rejects the call; the text is one line that says which and why."""


class _TimedTransport(Transport):
    def __init__(self, seconds: float) -> None:
        super().__init__()
        self._seconds = seconds

    def make_connection(self, host: Any) -> http.client.HTTPConnection:
        connection = super().make_connection(host)
        connection.timeout = self._seconds
        return connection


class Remote:
    """A master or node, called by the name `caller`."""

    def __init__(self, uri: str, caller: str, seconds: float = 3.0) -> None:
        if urlsplit(uri).scheme not in ("http", "https"):
            raise CallError(f"{uri}: not the address of a master, such as http://localhost:11311")
        self.uri = uri
        self._caller = caller
        self._proxy = ServerProxy(uri, transport=_TimedTransport(seconds), allow_none=True)

    def call(self, method: str, *arguments: Any) -> Any:
        """The value that the method answers with.

        Raises:
            CallError: there is no answer, or the method failed.
        """
        try:
            answer = getattr(self._proxy, method)(self._caller, *arguments)
            code, message, value = answer
        except Fault as error:
            raise CallError(f"{self.uri}: {method} failed: {error.faultString}") from None
        except (OSError, http.client.HTTPException, ProtocolError) as error:
            raise CallError(f"{self.uri}: no answer to {method}: {_reason(error)}") from None
        except (ResponseError, ExpatError, TypeError, ValueError) as error:
            raise CallError(f"{self.uri}: what answers to {method} is no ROS master or node ({type(error).__name__})") from None
        if code != SUCCESS:
            raise CallError(f"{self.uri}: {method} failed: {message}")
        return value


def _reason(error: Exception) -> str:
    if isinstance(error, TimeoutError):
        return "timed out"
    return getattr(error, "strerror", None) or str(error) or type(error).__name__


class _Handler(SimpleXMLRPCRequestHandler):
    protocol_version = "HTTP/1.1"  # roscpp keeps its connections
    rpc_paths = ()

    def log_message(self, format: str, *args: Any) -> None:
        """Nothing is logged."""


class _Threads(socketserver.ThreadingMixIn, SimpleXMLRPCServer):
    daemon_threads = True
    block_on_close = False
    request_queue_size = 128


class Server:
    """Answers calls on a free port of loopback: each method gets the arguments of the call and answers with a value."""

    def __init__(self, methods: Mapping[str, Callable[..., Any]]) -> None:
        self._methods = methods
        self._server = _Threads((LOOPBACK, 0), requestHandler=_Handler, logRequests=False, allow_none=True)
        self._server.register_instance(self)
        self.uri = f"http://{LOOPBACK}:{self._server.server_address[1]}/"
        threading.Thread(target=self._server.serve_forever, kwargs={"poll_interval": 0.05}, daemon=True).start()

    def _dispatch(self, method: str, arguments: tuple[Any, ...]) -> tuple[int, str, Any]:
        known = self._methods.get(method)
        if known is None:
            return -1, f"no method {method}", 0
        try:
            return SUCCESS, method, known(*arguments)
        except LookupError as error:
            return -1, str(error), 0

    def close(self) -> None:
        """Answer no more."""
        self._server.shutdown()
        self._server.server_close()
