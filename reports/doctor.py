"""How well a workspace was read, as text: one section per subject, each with what to do about it."""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path

from rosarch.findings.health import Health
from rosarch.reports.diagnostics import diagnostic_line
from rosarch.reports.labels import counted

SHOWN = 10

_ADVICE = {
    "component": "the rules did not end in time or memory: report it; other components are not affected",
    "source": "raise --timeout for time limits; a source that crashes the parser costs that source only",
    "plugin": "correct the library path of the description, or the target that is named otherwise",
    "missing-plugin-file": "correct the path in package.xml, or add the file",
    "plugin-xml": "repair the XML; its classes are not known until then",
    "manifest": "repair package.xml; what could be read of it was used",
    "missing-cmakelists": "add CMakeLists.txt, or hide the package with CATKIN_IGNORE",
    "duplicate-package": "hide the copy that is not meant with CATKIN_IGNORE",
    "unknown-type": "add the package that defines the message to the workspace",
    "compile-commands": "build again with -DCMAKE_EXPORT_COMPILE_COMMANDS=ON, or remove the file",
    "config-syntax": "none is needed; a .cfg file in Python 3 is read more exactly",
}
_UNBOUND = {
    "overloaded": "candidates are known",
    "dependent": "in templates; any method of that name may be meant",
    "recovered": "read from the text, as the compiler dropped them",
}


def doctor_text(health: Health, base: Path) -> str:
    """The whole report; diagnostics show paths relative to `base`."""
    sections = [
        *_head(health),
        *_missing(health),
        *_lost(health),
        *_diagnostics(health, base),
        *_unused(health),
        *_unbound(health),
        *_unknown(health),
        *_slow(health),
    ]
    if not any(line.startswith("  ") for line in sections):
        sections.append("nothing is missing")
    return "\n".join(sections) + "\n"


def _head(health: Health) -> Iterator[str]:
    sources = counted(health.sources, "source")
    yield f"{counted(health.components, 'component')}, {sources}, {health.built} of them with a compile command"
    if health.installed:
        yield f"known to rosarch, sources in the workspace not read: {', '.join(health.installed)}"


def _some(lines: list[str]) -> Iterator[str]:
    yield from (f"  {line}" for line in lines[:SHOWN])
    if len(lines) > SHOWN:
        yield f"  and {len(lines) - SHOWN} more"


def _missing(health: Health) -> Iterator[str]:
    if not health.missing:
        return
    yield f"missing headers: {len(health.missing)}, replaced by stand-ins that accept every use"
    ranked = sorted(health.missing.items(), key=lambda item: (-len(item[1]), item[0]))
    yield from _some([f"{header}  in {counted(len(files), 'file')}" for header, files in ranked])
    yield "  -> add the package to the workspace, or build with -DCMAKE_EXPORT_COMPILE_COMMANDS=ON, which tells where headers are installed"


def _lost(health: Health) -> Iterator[str]:
    if health.macros:
        yield f"macros that no header defines: {len(health.macros)}, left out where they are used"
        yield from _some([f"{name}  {min(map(str, places))}" for name, places in sorted(health.macros.items())])
        yield "  -> add the package that defines them to the workspace: what they declare or do is not known"
    if health.lost:
        yield f"functions that the parser lost: {len(health.lost)}"
        yield from _some([f"{at}-{last}  {reason}" for at, last, reason in health.lost])
        yield "  -> nothing of them is in the model; a header that is missing, or a bracket that does not match, is the usual cause"


def _diagnostics(health: Health, base: Path) -> Iterator[str]:
    groups: dict[str, list[str]] = {}
    for diagnostic in health.diagnostics:
        groups.setdefault(diagnostic.kind, []).append(diagnostic_line(diagnostic, base))
    for kind, lines in sorted(groups.items()):
        yield f"{kind}: {len(lines)}"
        yield from _some(lines)
        if kind in _ADVICE:
            yield f"  -> {_ADVICE[kind]}"
    if health.empty:
        yield f"components without a source: {len(health.empty)}"
        yield from _some(health.empty)
        yield "  -> their target lists no source that exists; a generated one is not there before the build"
    for name, rows in sorted(health.violations.items()):
        yield f"{name}: {rows} rows that should not be\n  -> the rules contradict themselves: report it"


def _unused(health: Health) -> Iterator[str]:
    if not health.unused:
        return
    yield f"sources that use ROS and belong to no component: {len(health.unused)}"
    yield from _some(health.unused)
    yield "  -> no target builds them, nothing installs or imports them, or their library is in no program: what they make is in no model"


def _unbound(health: Health) -> Iterator[str]:
    if not health.unbound:
        return
    total = sum(health.unbound.values())
    yield f"calls that the compiler could not bind: {total} of {health.calls} ({100 * total / health.calls:.1f} %)"
    yield from (f"  {reason}: {count}  {_UNBOUND.get(reason, '')}".rstrip() for reason, count in sorted(health.unbound.items()))


def _unknown(health: Health) -> Iterator[str]:
    if not health.unknown:
        return
    yield f"ports with unknown name: {len(health.unknown)}"
    yield from _some([f"{port.at}  {port.component}: {port.kind} {port.name}  {port.reason}" for port in health.unknown])
    yield "  -> nothing, when the name is only known at run time; else `rosarch why-not DIR 'value(...)'` tells which rule is missing"


def _slow(health: Health) -> Iterator[str]:
    if not health.slow:
        return
    yield f"slow sources: {len(health.slow)}"
    yield from _some([f"{path}  {seconds:.1f} s" for path, seconds in health.slow])
    yield "  -> other commands keep what they read, and read again only what has changed"
