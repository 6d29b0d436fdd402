"""The answers of this package over the Language Server Protocol 3.17, by pygls."""

from __future__ import annotations

import asyncio
from collections.abc import Callable, Iterable, Sequence
from pathlib import Path
from typing import Protocol

from lsprotocol import types as lsp
from pygls import uris
from pygls.exceptions import JsonRpcInvalidParams
from pygls.lsp.server import LanguageServer

from rosarch.datalog.editor.answers import Answers, Place, Proposal, RenameError
from rosarch.datalog.editor.occurrences import Occurrence
from rosarch.datalog.editor.programs import Entry, Programs, includers
from rosarch.datalog.language.errors import Diagnostic

PAUSE = 0.15  # seconds without a keystroke before a program is checked
_KINDS = {
    "relation": lsp.CompletionItemKind.Function, "variable": lsp.CompletionItemKind.Variable, "type": lsp.CompletionItemKind.Class,
    "functor": lsp.CompletionItemKind.Operator, "keyword": lsp.CompletionItemKind.Keyword, "file": lsp.CompletionItemKind.File,
    "folder": lsp.CompletionItemKind.Folder,
}  # fmt: skip
_SYMBOLS = {
    "relation": lsp.SymbolKind.Function, "type": lsp.SymbolKind.Class, "functor": lsp.SymbolKind.Operator,
    "component": lsp.SymbolKind.Module, "instance": lsp.SymbolKind.Object,
}  # fmt: skip


class Position(Protocol):
    """What all requests about a place have."""

    @property
    def text_document(self) -> lsp.TextDocumentIdentifier: ...
    @property
    def position(self) -> lsp.Position: ...


class RuleServer(LanguageServer):
    """A language server for rule files; `entries` gives the programs that a file may extend in addition to those of the open folders."""

    def __init__(self, version: str, entries: Callable[[Path], Sequence[Entry]]) -> None:
        super().__init__("rosarch", version)
        self.entries = entries
        self.programs = Programs(self._candidates)
        self.answers = Answers(self.programs)
        self._timer: asyncio.TimerHandle | None = None
        self._published: set[Path] = set()
        self._uris: dict[Path, str] = {}

    def _candidates(self, path: Path) -> list[Entry]:
        """The programs that a file may be part of: of files that include it, by itself, with what it extends."""
        including: list[Entry] = [Entry((file,)) for file in includers(self.programs, path, self.answers.rule_files())]
        return [*including, *self.entries(path)]

    def opened(self, uri: str) -> Path:
        """The file of a document that the client has opened."""
        path = path_of(uri)
        self._uris[path] = uri
        return path

    def uri(self, path: Path) -> str:
        """What the client calls a file: it may have opened it through a link, or it may not be on disk."""
        return self._uris.get(path) or path.as_uri()

    def lines(self, path: Path) -> list[str]:
        """The lines of a file with their ends."""
        return self.programs.text(path).splitlines(keepends=True)

    def inside(self, params: Position) -> tuple[Path, int, int]:
        """The file, line and column, from 1, of a position of the client."""
        path = path_of(params.text_document.uri)
        at = self.workspace.position_codec.position_from_client_units(self.lines(path), params.position)
        return path, at.line + 1, at.character + 1

    def range(self, place: Place) -> lsp.Range:
        """The place in the client's units."""
        start = lsp.Position(place.line - 1, place.column - 1)
        end = lsp.Position(place.line - 1, place.end - 1)
        return self.workspace.position_codec.range_to_client_units(self.lines(place.path), lsp.Range(start, end))

    def location(self, place: Place) -> lsp.Location:
        """The place as a location of the protocol."""
        return lsp.Location(self.uri(place.path), self.range(place))

    def changed(self) -> None:
        """Check again when nobody has typed for a while."""
        if self._timer is not None:
            self._timer.cancel()
        self._timer = asyncio.get_running_loop().call_later(PAUSE, self.publish)

    def publish(self) -> None:
        """Say what is wrong with the files being edited."""
        self._timer = None
        now = {Path(p) for p in self.programs.edited}
        for path in now:
            shown = [self._diagnostic(path, d) for d in self.programs.program(path).of(path)]
            self.text_document_publish_diagnostics(lsp.PublishDiagnosticsParams(self.uri(path), shown))
        for path in self._published - now:
            self.text_document_publish_diagnostics(lsp.PublishDiagnosticsParams(self.uri(path), []))
        self._published = now

    def _diagnostic(self, path: Path, found: Diagnostic) -> lsp.Diagnostic:
        line, column = (found.location.line, found.location.column) if found.location else (1, 1)
        name = self.answers.at(path, line, column)
        end = name.end if name and name.column == column else column + 1
        severity = lsp.DiagnosticSeverity.Error if found.severity == "error" else lsp.DiagnosticSeverity.Warning
        message = f"{found.message}, {found.hint}" if found.hint else found.message
        return lsp.Diagnostic(self.range(Place(path, line, column, end)), message, severity, source="rosarch")


def path_of(uri: str) -> Path:
    """The file of a URI."""
    return Path(uris.to_fs_path(uri) or uri).resolve()


def rule_server(version: str, entries: Callable[[Path], Sequence[Entry]]) -> RuleServer:
    """A server with all its features, to be started on a stream."""
    server = RuleServer(version, entries)
    _documents(server)
    _questions(server)
    _edits(server)
    return server


def _documents(server: RuleServer) -> None:
    @server.feature(lsp.INITIALIZED)
    def initialized(_params: lsp.InitializedParams) -> None:
        server.answers.folders = tuple(path_of(f) for f in server.workspace.folders)

    @server.feature(lsp.TEXT_DOCUMENT_DID_OPEN)
    def opened(params: lsp.DidOpenTextDocumentParams) -> None:
        server.programs.edit(server.opened(params.text_document.uri), params.text_document.text)
        server.changed()

    @server.feature(lsp.TEXT_DOCUMENT_DID_CHANGE)
    def edited(params: lsp.DidChangeTextDocumentParams) -> None:
        uri = params.text_document.uri
        server.programs.edit(path_of(uri), server.workspace.get_text_document(uri).source)
        server.changed()

    @server.feature(lsp.TEXT_DOCUMENT_DID_SAVE)
    def saved(params: lsp.DidSaveTextDocumentParams) -> None:
        server.programs.saved(path_of(params.text_document.uri))
        server.changed()

    @server.feature(lsp.TEXT_DOCUMENT_DID_CLOSE)
    def closed(params: lsp.DidCloseTextDocumentParams) -> None:
        server.programs.close(path_of(params.text_document.uri))
        server.changed()

    @server.feature(lsp.WORKSPACE_DID_CHANGE_WATCHED_FILES)
    def changed_on_disk(params: lsp.DidChangeWatchedFilesParams) -> None:
        for change in params.changes:
            server.programs.saved(path_of(change.uri))
        server.changed()


def _questions(server: RuleServer) -> None:
    answers = server.answers

    @server.feature(lsp.TEXT_DOCUMENT_HOVER)
    def hover(params: lsp.HoverParams) -> lsp.Hover | None:
        found = answers.hover(*server.inside(params))
        if found is None:
            return None
        code, doc, place = found
        text = f"```prolog\n{code}\n```" + (f"\n\n{doc}" if doc else "")
        return lsp.Hover(lsp.MarkupContent(lsp.MarkupKind.Markdown, text), server.range(place))

    @server.feature(lsp.TEXT_DOCUMENT_DEFINITION)
    def definition(params: lsp.DefinitionParams) -> list[lsp.Location]:
        return [server.location(p) for p in answers.definition(*server.inside(params))]

    @server.feature(lsp.TEXT_DOCUMENT_REFERENCES)
    def references(params: lsp.ReferenceParams) -> list[lsp.Location]:
        where = server.inside(params)
        found = answers.references(*where)
        if not params.context.include_declaration:
            declared = set(answers.definition(*where))
            found = [p for p in found if p not in declared]
        return [server.location(p) for p in found]

    @server.feature(lsp.TEXT_DOCUMENT_DOCUMENT_HIGHLIGHT)
    def highlight(params: lsp.DocumentHighlightParams) -> list[lsp.DocumentHighlight]:
        path, line, column = server.inside(params)
        return [lsp.DocumentHighlight(server.range(p)) for p in answers.references(path, line, column) if p.path == path]

    @server.feature(lsp.TEXT_DOCUMENT_SIGNATURE_HELP, lsp.SignatureHelpOptions(["(", ","]))
    def signature(params: lsp.SignatureHelpParams) -> lsp.SignatureHelp | None:
        found = answers.signature(*server.inside(params))
        if found is None:
            return None
        attributes = [lsp.ParameterInformation(a) for a in found.attributes]
        return lsp.SignatureHelp([lsp.SignatureInformation(found.label, found.doc, attributes, found.active)], 0, found.active)

    @server.feature(lsp.TEXT_DOCUMENT_DOCUMENT_SYMBOL)
    def outline(params: lsp.DocumentSymbolParams) -> list[lsp.DocumentSymbol]:
        path = path_of(params.text_document.uri)
        return [_symbol(server, path, o) for o in server.programs.names(path).occurrences if o.is_declaration and o.kind in _SYMBOLS]

    @server.feature(lsp.WORKSPACE_SYMBOL)
    def symbols(params: lsp.WorkspaceSymbolParams) -> list[lsp.WorkspaceSymbol]:
        return list(_matching(server, params.query.lower()))


def _symbol(server: RuleServer, path: Path, found: Occurrence) -> lsp.DocumentSymbol:
    place = server.range(Place(path, found.line, found.column, found.end))
    return lsp.DocumentSymbol(found.name, _SYMBOLS[found.kind], place, place)


def _matching(server: RuleServer, query: str) -> Iterable[lsp.WorkspaceSymbol]:
    for path in server.answers.rule_files():
        for found in server.programs.names(path).occurrences:
            if found.is_declaration and found.kind in _SYMBOLS and query in found.name.lower():
                yield lsp.WorkspaceSymbol(
                    server.location(Place(path, found.line, found.column, found.end)), found.name, _SYMBOLS[found.kind]
                )


def _edits(server: RuleServer) -> None:
    answers = server.answers

    @server.feature(lsp.TEXT_DOCUMENT_COMPLETION, lsp.CompletionOptions([".", "@", "(", ",", '"', "/"]))
    def completion(params: lsp.CompletionParams) -> lsp.CompletionList:
        found = answers.completion(*server.inside(params))
        return lsp.CompletionList(is_incomplete=False, items=[_item(p, order) for order, p in enumerate(found)])

    @server.feature(lsp.TEXT_DOCUMENT_PREPARE_RENAME)
    def prepare_rename(params: lsp.PrepareRenameParams) -> lsp.Range | None:
        path, line, column = server.inside(params)
        found = answers.at(path, line, column)
        return server.range(Place(path, found.line, found.column, found.end)) if found and found.kind != "file" else None

    @server.feature(lsp.TEXT_DOCUMENT_RENAME, lsp.RenameOptions(prepare_provider=True))
    def rename(params: lsp.RenameParams) -> lsp.WorkspaceEdit:
        try:
            places = answers.rename(*server.inside(params), params.new_name)
        except RenameError as error:
            raise JsonRpcInvalidParams(str(error)) from None
        changes: dict[str, list[lsp.TextEdit]] = {}
        for place in places:
            changes.setdefault(server.uri(place.path), []).append(lsp.TextEdit(server.range(place), params.new_name))
        return lsp.WorkspaceEdit(changes)

    @server.feature(lsp.TEXT_DOCUMENT_CODE_ACTION, lsp.CodeActionOptions([lsp.CodeActionKind.QuickFix]))
    def actions(params: lsp.CodeActionParams) -> list[lsp.CodeAction]:
        return [a for d in params.context.diagnostics if (a := _fix(server, params.text_document.uri, d))]


def _item(proposal: Proposal, order: int) -> lsp.CompletionItem:
    filled = lsp.InsertTextFormat.Snippet if proposal.fill else lsp.InsertTextFormat.PlainText
    return lsp.CompletionItem(
        proposal.label, kind=_KINDS[proposal.kind], detail=proposal.detail or None, documentation=proposal.doc or None,
        sort_text=f"{order:05}", insert_text=proposal.fill or proposal.label, insert_text_format=filled,
    )  # fmt: skip


def _fix(server: RuleServer, uri: str, diagnostic: lsp.Diagnostic) -> lsp.CodeAction | None:
    """The change to the name that a diagnostic proposes."""
    if "did you mean" not in diagnostic.message:
        return None
    document = lsp.TextDocumentIdentifier(uri)
    name = server.answers.fix(*server.inside(lsp.TextDocumentPositionParams(document, diagnostic.range.start)))
    if not name:
        return None
    edit = lsp.WorkspaceEdit({uri: [lsp.TextEdit(diagnostic.range, name)]})
    return lsp.CodeAction(f"Change to {name}", kind=lsp.CodeActionKind.QuickFix, diagnostics=[diagnostic], edit=edit)


def serve(version: str, entries: Callable[[Path], Sequence[Entry]]) -> None:
    """Serve on stdin and stdout until the client ends; nothing else may write to stdout."""
    rule_server(version, entries).start_io()
