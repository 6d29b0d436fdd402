"""`rosarch serve`: the report, live: on loopback, and new whenever sources or rules are saved."""

from __future__ import annotations

import socket
import tempfile
from pathlib import Path
from typing import Annotated

import typer

from rosarch.cli.commands.report import Chains, Proofs, SourceUrl, check_link
from rosarch.cli.commands.watch import saves
from rosarch.cli.errors import InputError
from rosarch.cli.inputs import check_sources
from rosarch.cli.questions import SystemQuestion, asks
from rosarch.cli.terminal import emit

Port = Annotated[int, typer.Option("--port", metavar="N", min=0, max=65535, help="The port to listen on; 0 for any free port.")]
LOOPBACK = "127.0.0.1"


@asks()
def serve(question: SystemQuestion, port: Port = 8750, source_url: SourceUrl = None, chains: Chains = False, proofs: Proofs = True) -> None:
    """Serve the report on this machine only, and update it whenever sources or rules are saved. Ends with Ctrl-C."""
    from rosarch.base.pool import alongside
    from rosarch.reports.html.live_server import serve_live

    link = check_link(source_url)
    folder = check_sources(question.folder)
    saved = saves([folder, *(question.own or ())])
    with _listening(port) as listener, tempfile.TemporaryDirectory(prefix="rosarch-") as name:
        current = Path(name)
        server = alongside(lambda: serve_live(listener, folder.resolve().name, current))
        emit(f"http://{LOOPBACK}:{listener.getsockname()[1]}/\n")
        try:
            _remake(question, link, chains, proofs, current)
            for _ in saved:
                _remake(question, link, chains, proofs, current)
        finally:
            server.terminate()


def _listening(port: int) -> socket.socket:
    try:
        return socket.create_server((LOOPBACK, port))
    except OSError as error:
        raise InputError(f"--port {port}: cannot listen there ({(error.strerror or str(error)).lower()})") from None


def _remake(question: SystemQuestion, link: str | None, chains: bool, proofs: bool, current: Path) -> None:
    """Analyse in a process of its own, which loads the rules as they are now."""
    from rosarch.base.pool import alongside

    process = alongside(lambda: _make(question, link, chains, proofs, current), daemon=False)
    try:
        process.join()
    finally:
        process.kill()
        process.join()


def _make(question: SystemQuestion, link: str | None, chains: bool, proofs: bool, current: Path) -> None:
    from rosarch.cli.report_content import load_subject
    from rosarch.reports.html.document import report_document
    from rosarch.reports.html.live_server import put_document, put_error

    try:
        subject = load_subject(question, link, chains=chains, proofs=proofs)
        put_document(current, report_document(subject))
    except InputError as error:  # the next save may fix it
        put_error(current, str(error))
        raise SystemExit(f"rosarch: error: {error}") from None
