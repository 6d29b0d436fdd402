"""The language server, through a client that speaks the protocol with it over stdin and stdout."""

from __future__ import annotations

import asyncio
import sys
from collections.abc import Awaitable, Callable
from pathlib import Path

import pytest
from lsprotocol import types as lsp
from pygls.exceptions import JsonRpcException
from pygls.lsp.client import LanguageClient

pytestmark = pytest.mark.slow

RULES = """\
/// The component reads `topic`.
.decl reads(topic: symbol)
.output reads
reads(Topic) :- port([_, "subscriber", Topic]).
"""


class Session:
    """A client with a server, and what the server last said about each file."""

    def __init__(self, client: LanguageClient, root: Path) -> None:
        self.client = client
        self.root = root
        self.versions: dict[str, int] = {}
        self.said: asyncio.Queue[lsp.PublishDiagnosticsParams] = asyncio.Queue()

        @client.feature(lsp.TEXT_DOCUMENT_PUBLISH_DIAGNOSTICS)
        def published(params: lsp.PublishDiagnosticsParams) -> None:
            self.said.put_nowait(params)

    def uri(self, name: str) -> str:
        return (self.root / name).resolve().as_uri()

    async def open(self, name: str, text: str) -> list[str]:
        item = lsp.TextDocumentItem(self.uri(name), "souffle", 1, text)
        self.client.text_document_did_open(lsp.DidOpenTextDocumentParams(item))
        self.versions[name] = 1
        return await self.diagnostics(name)

    async def change(self, name: str, text: str) -> list[str]:
        self.versions[name] += 1
        document = lsp.VersionedTextDocumentIdentifier(uri=self.uri(name), version=self.versions[name])
        change = lsp.TextDocumentContentChangeWholeDocument(text)
        self.client.text_document_did_change(lsp.DidChangeTextDocumentParams(document, [change]))
        return await self.diagnostics(name)

    async def diagnostics(self, name: str) -> list[str]:
        while True:
            said = await asyncio.wait_for(self.said.get(), 60)
            if said.uri == self.uri(name):
                return [f"{d.range.start.line + 1}:{d.range.start.character + 1}: {d.message}" for d in said.diagnostics]

    def at(self, name: str, line: int, column: int) -> dict[str, object]:
        return {"text_document": lsp.TextDocumentIdentifier(self.uri(name)), "position": lsp.Position(line - 1, column - 1)}


def session(root: Path, script: Callable[[Session], Awaitable[None]]) -> None:
    async def run() -> None:
        client = LanguageClient("test", "1")
        await client.start_io(sys.executable, "-m", "rosarch.cli", "language-server")
        try:
            folder = lsp.WorkspaceFolder(root.resolve().as_uri(), "rules")
            await client.initialize_async(lsp.InitializeParams(lsp.ClientCapabilities(), workspace_folders=[folder]))
            client.initialized(lsp.InitializedParams())
            await script(Session(client, root))
            await client.shutdown_async(None)
            client.exit(None)
        except BaseException:
            client._server.kill()  # type: ignore[union-attr]  # it waits for an orderly end, which there will not be
            raise
        finally:
            await client.stop()

    asyncio.run(asyncio.wait_for(run(), 120))


def places(found: list[lsp.Location] | None) -> list[str]:
    return [f"{Path(f.uri).name}:{f.range.start.line + 1}:{f.range.start.character + 1}" for f in found or ()]


def test_a_rule_file_while_it_is_written(tmp_path: Path) -> None:
    """Diagnostics follow the text; names of rosarch's rules are known without any include."""

    async def script(editor: Session) -> None:
        assert await editor.open("own.dl", RULES) == []
        wrong = RULES.replace("port(", "prt(")
        assert await editor.change("own.dl", wrong) == ["4:17: unknown relation `prt`, did you mean `port`?"]
        assert await editor.change("own.dl", RULES.replace(").\n", ")\n")) == ["4:47: syntax error, unexpected end of file"]
        assert await editor.change("own.dl", RULES) == []

        hover = await editor.client.text_document_hover_async(lsp.HoverParams(**editor.at("own.dl", 4, 18)))
        assert hover is not None and isinstance(hover.contents, lsp.MarkupContent)
        assert ".decl port(port: Port)" in hover.contents.value and "is a port of the component" in hover.contents.value
        hover = await editor.client.text_document_hover_async(lsp.HoverParams(**editor.at("own.dl", 4, 8)))
        assert hover is not None and "Topic: symbol" in str(hover.contents)

        definition = await editor.client.text_document_definition_async(lsp.DefinitionParams(**editor.at("own.dl", 4, 18)))
        assert isinstance(definition, list) and [Path(d.uri).name for d in definition if isinstance(d, lsp.Location)] == ["ports.dl"]

    session(tmp_path, script)


def test_uses_and_renaming_in_other_files(tmp_path: Path) -> None:
    """A relation is renamed wherever it means the same, and nowhere else."""
    (tmp_path / "other.dl").write_text('.decl twice(topic: symbol)\ntwice(T) :- reads(T), reads(T).\n.include "own.dl"\n')
    (tmp_path / "unrelated.dl").write_text(".decl reads(n: number)\nreads(1).\n")
    (tmp_path / "own.dl").write_text(RULES)

    async def script(editor: Session) -> None:
        await editor.open("own.dl", RULES)
        context = lsp.ReferenceContext(include_declaration=True)
        found = await editor.client.text_document_references_async(lsp.ReferenceParams(context=context, **editor.at("own.dl", 2, 8)))
        assert sorted(places(found)) == ["other.dl:2:13", "other.dl:2:23", "own.dl:2:7", "own.dl:3:9", "own.dl:4:1"]

        edit = await editor.client.text_document_rename_async(lsp.RenameParams(new_name="listens_to", **editor.at("own.dl", 2, 8)))
        assert edit is not None and edit.changes is not None
        assert {Path(uri).name: len(edits) for uri, edits in edit.changes.items()} == {"own.dl": 3, "other.dl": 2}

        edit = await editor.client.text_document_rename_async(lsp.RenameParams(new_name="T", **editor.at("own.dl", 4, 8)))
        assert edit is not None and edit.changes is not None
        assert [(e.range.start.line, e.range.start.character) for e in edit.changes[editor.uri("own.dl")]] == [(3, 6), (3, 39)]

        with pytest.raises(JsonRpcException, match=r"`port` is declared in .*ports\.dl, which is not in an open folder"):
            await editor.client.text_document_rename_async(lsp.RenameParams(new_name="plug", **editor.at("own.dl", 4, 18)))
        with pytest.raises(JsonRpcException, match="`port` is already declared at"):
            await editor.client.text_document_rename_async(lsp.RenameParams(new_name="port", **editor.at("own.dl", 2, 8)))
        with pytest.raises(JsonRpcException, match="`no name` is no name"):
            await editor.client.text_document_rename_async(lsp.RenameParams(new_name="no name", **editor.at("own.dl", 2, 8)))

    session(tmp_path, script)


def test_completion(tmp_path: Path) -> None:
    """What is proposed depends on what stands before: directives, types, relations, attributes."""

    async def script(editor: Session) -> None:
        async def labels(text: str) -> list[str]:
            await editor.change("own.dl", text)
            lines = text.split("\n")
            where = editor.at("own.dl", len(lines), len(lines[-1]) + 1)
            found = await editor.client.text_document_completion_async(lsp.CompletionParams(**where))
            assert isinstance(found, lsp.CompletionList)
            return [i.label for i in found.items]

        await editor.open("own.dl", RULES)
        assert "decl" in await labels(RULES + ".de")
        types = await labels(RULES + ".decl more(p: ")
        assert types[:4] == ["number", "unsigned", "float", "symbol"] and "Port" in types and "port_type" not in types
        relations = await labels(RULES + "reads(T) :- port_t")
        assert "port_type" in relations and "reads" in relations and "T" in relations
        assert (await labels(RULES + "reads(T) :- port_type("))[:2] == ["Port", "T"]
        assert await labels("/// not in a comment") == []

        where = editor.at("own.dl", 5, 1)
        await editor.change("own.dl", RULES + 'reads(T) :- port_type([_, "x", T], ')
        where = editor.at("own.dl", 5, 36)
        help_ = await editor.client.text_document_signature_help_async(lsp.SignatureHelpParams(**where))
        assert help_ is not None and help_.signatures[0].label == "port_type(port: Port, type: symbol)" and help_.active_parameter == 1

    session(tmp_path, script)


def test_a_fix_and_columns_after_characters_outside_the_basic_plane(tmp_path: Path) -> None:
    """Columns are counted in the client's UTF-16 units; a misspelt name can be changed to the one that is meant."""
    text = '.decl a(x: symbol)\n.output a\na("🤖") :- prt([_, "🤖", "🤖"]).\n'

    async def script(editor: Session) -> None:
        assert await editor.open("own.dl", text) == ["3:12: unknown relation `prt`, did you mean `port`?"]
        place = lsp.Range(lsp.Position(2, 11), lsp.Position(2, 14))
        context = lsp.CodeActionContext([lsp.Diagnostic(place, "unknown relation `prt`, did you mean `port`?")])
        document = lsp.TextDocumentIdentifier(editor.uri("own.dl"))
        actions = await editor.client.text_document_code_action_async(lsp.CodeActionParams(document, place, context))
        assert actions is not None and isinstance(actions[0], lsp.CodeAction) and actions[0].title == "Change to port"
        assert actions[0].edit is not None and actions[0].edit.changes is not None
        assert list(actions[0].edit.changes[editor.uri("own.dl")]) == [lsp.TextEdit(place, "port")]

    session(tmp_path, script)


def test_the_outline_and_an_include(tmp_path: Path) -> None:
    """Declarations are the outline of a file; an include leads to the file."""
    (tmp_path / "types.dl").write_text(".type T <: symbol\n")

    async def script(editor: Session) -> None:
        assert await editor.open("main.dl", '.include "types.dl"\n.decl a(x: T)\n.output a\na("b").\n') == []
        document = lsp.TextDocumentIdentifier(editor.uri("main.dl"))
        outline = await editor.client.text_document_document_symbol_async(lsp.DocumentSymbolParams(document))
        assert [s.name for s in outline or ()] == ["a"]
        found = await editor.client.text_document_definition_async(lsp.DefinitionParams(**editor.at("main.dl", 1, 14)))
        assert isinstance(found, list) and places([f for f in found if isinstance(f, lsp.Location)]) == ["types.dl:1:1"]
        assert await editor.open("types.dl", ".type T <: symbl\n") == ["1:7: unknown type `symbl`, did you mean `symbol`?"]

    session(tmp_path, script)


def test_documents_keep_the_names_that_the_client_gives_them(tmp_path: Path) -> None:
    """A file that is opened through a link, and a text that is nowhere on disk, get their diagnostics and edits under their own names."""
    (tmp_path / "real").mkdir()
    (tmp_path / "link").symlink_to("real")

    async def script(editor: Session) -> None:
        for uri in ((tmp_path / "link" / "own.dl").as_uri(), "untitled:Untitled-1"):
            item = lsp.TextDocumentItem(uri, "souffle", 1, RULES.replace("port(", "prt("))
            editor.client.text_document_did_open(lsp.DidOpenTextDocumentParams(item))
            while (said := await asyncio.wait_for(editor.said.get(), 60)).uri != uri:
                pass
            assert [d.message for d in said.diagnostics] == ["unknown relation `prt`, did you mean `port`?"]
            document = lsp.TextDocumentIdentifier(uri)
            edit = await editor.client.text_document_rename_async(lsp.RenameParams(document, lsp.Position(1, 7), "hears"))
            assert edit is not None and list(edit.changes or ()) == [uri]
            editor.client.text_document_did_close(lsp.DidCloseTextDocumentParams(document))

    session(tmp_path, script)
