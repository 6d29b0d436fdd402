"""What a sub-command works on: a checked folder, and the analysis of it."""

from __future__ import annotations

import os
from collections.abc import Collection, Iterable
from dataclasses import replace
from pathlib import Path
from typing import TYPE_CHECKING

from rosarch.cli.errors import InputError
from rosarch.cli.options import Engine
from rosarch.cli.terminal import progress

if TYPE_CHECKING:
    from rosarch.analysis.components import Analysis
    from rosarch.analysis.method import Method
    from rosarch.base.cache import Cache
    from rosarch.base.diagnostics import Diagnostic

_NOT_DERIVED = ("component", "launch")
"""Kinds of diagnostics about a component or a system that the engine has derived nothing of."""


def check_folder(folder: Path) -> Path:
    """`folder`, when it is one that can be read."""
    if not os.path.exists(folder):
        raise InputError(f"{folder}: no such folder")
    if not os.path.isdir(folder):
        raise InputError(f"{folder}: not a folder")
    if not os.access(folder, os.R_OK | os.X_OK):
        raise InputError(f"{folder}: no permission to read this folder")
    return folder


def check_sources(folder: Path) -> Path:
    """`folder`, when it is one that can be read, and not facts."""
    from rosarch.extractor.stored_facts import has_facts

    if has_facts(folder):
        raise InputError(f"{folder}: facts, where a folder of sources is needed")
    return check_folder(folder)


def check_input(path: Path) -> Path:
    """`path`, when it is a folder that can be read, or a text of facts."""
    from rosarch.extractor.stored_facts import is_facts_text

    if os.path.isfile(path) and not is_facts_text(path):
        raise InputError(f"{path}: neither a folder nor a text of facts")
    return path if os.path.isfile(path) else check_folder(path)


def read_input(path: Path) -> str:
    """The text of a file that was given."""
    from rosarch.base.diagnostics import why
    from rosarch.base.files import read_file

    try:
        return read_file(path).decode("utf-8")
    except UnicodeDecodeError as error:
        line = error.object.count(b"\n", 0, error.start) + 1
        column = error.start - error.object.rfind(b"\n", 0, error.start)
        raise InputError(f"{path}:{line}:{column}: not UTF-8 text: byte 0x{error.object[error.start]:02x}") from None
    except OSError as error:
        raise InputError(f"{path}: cannot be read ({why(error)})") from None


def extraction_cache(wanted: bool) -> Cache | None:
    """Where what was read from sources is kept: below `ROSARCH_CACHE_DIR` or the user's cache folder."""
    if not wanted:
        return None
    from rosarch.base.cache import Cache
    from rosarch.datalog.cache import cache_folder

    return Cache(cache_folder() / "units")


def check_diagnostics(folder: Path, found: int, diagnostics: Iterable[Diagnostic]) -> None:
    """Reject input that gave nothing to work on: no package, an unknown package, only broken packages, rules that fail on all of it."""
    from rosarch.base.diagnostics import shortened

    diagnostics = list(diagnostics)
    failed = [diagnostic for diagnostic in diagnostics if diagnostic.kind in _NOT_DERIVED]
    if failed and not found:
        raise InputError(f"{folder}: {shortened(failed[0].message, 300)}{f' (and {len(failed) - 1} more)' if failed[1:] else ''}")
    for diagnostic in diagnostics:
        if diagnostic.kind == "workspace":
            raise InputError(f"{folder}: {diagnostic.message}")
    broken = {d.path: d for d in diagnostics if d.path.name == "package.xml" and d.kind in ("manifest", "unreadable")}
    if broken and not found:
        from rosarch.extractor.workspace.manifests import find_manifests, read_manifest
        from rosarch.reports.diagnostics import diagnostic_line

        if not any(read_manifest(Path(path))[0] for path in find_manifests(folder.absolute(), [])):
            raise InputError(diagnostic_line(next(iter(broken.values())), Path.cwd()))


def load_analysis(
    folder: Path,
    packages: Collection[str] | None,
    method: Method,
    component: str | None = None,
) -> Analysis:
    """Analyse a folder of packages, or stored facts; of a folder of packages only `component`, when it is given."""
    check_input(folder)
    check_engine(method.engine)
    with progress() as report:
        from rosarch.extractor.stored_facts import has_facts

        method = method.reporting_to(report)
        if has_facts(folder):
            return _load_facts(folder, packages, method)
        analysis = _analysis(folder, packages or None, component, method)
        from rosarch.models.component import UNUSED
    check_diagnostics(folder, sum(model.kind != UNUSED for model in analysis.models), analysis.diagnostics)
    return analysis


def _analysis(folder: Path, packages: Collection[str] | None, component: str | None, method: Method) -> Analysis:
    """The analysis of a folder of packages; as it was when nothing has changed since."""
    from rosarch.base.memo import Memo

    def find() -> Analysis:
        from rosarch.analysis.components import analyze

        return analyze(folder, packages, method, only=(lambda found: found.name == component) if component else None)

    cache = method.sources.cache
    if cache is None or method.engine != Engine.embedded.value:
        return find()
    top = os.path.abspath(folder)
    asked = [repr(packages and sorted(packages)), repr(component)]
    return Memo(cache).recall(["analysis", top, *asked, *method.key()], (top,), find)


def _load_facts(folder: Path, packages: Collection[str] | None, method: Method) -> Analysis:
    from rosarch.analysis.components import analyze_facts
    from rosarch.base.hints import hint
    from rosarch.extractor.manifest import ManifestError

    try:
        analysis = analyze_facts(folder, method)
    except ManifestError as error:
        raise InputError(str(error)) from None
    known = {model.package for model in analysis.models}
    for name in sorted(set(packages or ()) - known):
        raise InputError(f"{folder}: no package {name} among these facts{hint(name, known)}")
    return replace(analysis, models=tuple(model for model in analysis.models if not packages or model.package in packages))


def check_engine(engine: str) -> None:
    """Reject an engine that is not installed, or too old: better before a long extraction than after it."""
    if engine == Engine.souffle.value:
        import shutil

        from rosarch.datalog import DatalogError
        from rosarch.datalog.engine.souffle import find_souffle

        if shutil.which("souffle") is None:
            raise InputError("--engine souffle: there is no `souffle` on PATH; the embedded engine needs no installation")
        try:
            find_souffle()
        except DatalogError as error:
            raise InputError(f"--engine souffle: {error.diagnostics[0].message}") from None
