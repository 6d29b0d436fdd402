"""Turn what the evaluator collected into frozen `Package` and `Target` values; check that sources exist."""

from __future__ import annotations

import os
from collections.abc import Iterable, Iterator
from pathlib import Path

from rosarch.base.diagnostics import Diagnostic, why
from rosarch.base.files import text_or_nothing
from rosarch.extractor.workspace.cmake_expand import generator_expression, split_list
from rosarch.extractor.workspace.cmake_state import TargetDraft
from rosarch.extractor.workspace.evaluator import Evaluator
from rosarch.extractor.workspace.installs import Install, Obstacle, Unsure, library_path, line_with, may_be_no_text
from rosarch.extractor.workspace.manifests import Manifest
from rosarch.extractor.workspace.model import (
    EXECUTABLE,
    IMPORTED,
    LIBRARY_KINDS,
    TEST,
    Configured,
    Exports,
    Package,
    PluginClass,
    Program,
    Target,
)
from rosarch.extractor.workspace.plugins import read_plugins
from rosarch.extractor.workspace.python_setup import read_setup

SOURCE_EXTENSIONS = frozenset({".c", ".C", ".c++", ".cc", ".cpp", ".cxx", ".cu", ".CPP", ".CC"})
HEADER_EXTENSIONS = frozenset({".h", ".hh", ".h++", ".hpp", ".hxx", ".H", ".cuh", ".inl", ".ipp", ".tcc", ".txx", ".tpp", ".in"})
_TRIED_EXTENSIONS = (".c", ".C", ".c++", ".cc", ".cpp", ".cxx", ".cu", ".h", ".hh", ".h++", ".hpp", ".hxx")


def finished_package(run: Evaluator, manifest: Manifest) -> tuple[Package, list[Diagnostic]]:
    """The package, and diagnostics for sources and plug-in files that are missing."""
    problems: list[Diagnostic] = []
    targets = tuple(_target(run, draft, problems) for draft in run.targets.values())
    draft = run.draft
    exports = (*manifest.plugin_exports, *((base, Path(file)) for base, file in draft.plugin_exports))
    plugins, plugin_problems = read_plugins(exports, manifest)
    problems.extend(plugin_problems)
    components = [
        PluginClass(name, name, "rclcpp_components", library, Path(run.file), line, executable)
        for library, cxx, executable, line in draft.component_nodes
        for name in [cxx.strip().removeprefix("::")]
    ]
    setup, setup_problems = read_setup(manifest.path.parent, manifest.name)
    problems.extend(setup_problems)
    package = Package(
        name=manifest.name,
        path=manifest.path.parent,
        manifest=manifest.path,
        version=manifest.version,
        build_type=manifest.build_type,
        depends=manifest.depends,
        build_depends=manifest.build_depends,
        is_metapackage=manifest.is_metapackage,
        targets=targets,
        aliases=tuple(run.aliases.items()),
        exports=Exports(_paths(run, draft.include_dirs), tuple(dict.fromkeys(draft.libraries)), tuple(dict.fromkeys(draft.depends))),
        message_files=_files(draft.message_files),
        service_files=_files(draft.service_files),
        action_files=_files(draft.action_files),
        cfg_files=_files(draft.cfg_files),
        parameter_files=tuple((name, Path(path)) for name, path in draft.parameter_files),
        plugin_exports=exports,
        plugins=(*plugins, *components),
        configured=tuple(Configured(Path(template), Path(output)) for template, output in draft.configured),
        programs=(*_programs(draft.programs), *setup.programs),
        entry_points=setup.entry_points,
        python_roots=tuple(dict.fromkeys((*_files(draft.python_folders), *setup.roots))),
        installs=setup.installs if manifest.build_type == "ament_python" else tuple(_installs(run, manifest, targets)),
        python_packages=setup.packages,
        finds=frozenset(draft.finds),
        calls=tuple(draft.calls),
        unsure=setup.unsure if manifest.build_type == "ament_python" else tuple(_unsure(run)),
        obstacles=tuple(dict.fromkeys((*setup.obstacles, *_obstacles(run, problems), *_undescribed(exports, manifest, problems)))),
    )
    return package, problems


def _installs(run: Evaluator, manifest: Manifest, targets: Iterable[Target]) -> Iterator[Install]:
    """What CMake installs: what its files say, programs, interfaces, and the manifest."""
    draft, share = run.draft, f"share/{manifest.name}"
    yield from dict.fromkeys(draft.installs)
    outputs = {target.name: target for target in targets}
    for name, destination, at in draft.installed_targets:
        target = outputs.get(run.aliases.get(name, name))
        if target is not None and target.kind in (EXECUTABLE, TEST):
            yield Install(os.path.normpath(f"{destination}/{target.output_name}"), target.cmake_file, at=at)
        elif target is not None and target.kind in LIBRARY_KINDS:
            yield Install(library_path(target.output_name), target.cmake_file)
    for files in (draft.message_files, draft.service_files, draft.action_files):
        for path in map(Path, files):
            yield Install(f"{share}/{path.parent.name}/{path.name}", path)
    yield Install(f"{share}/package.xml", manifest.path)


_MAKING = ("execute_process", "add_custom_", "externalproject", "fetchcontent", "download")


def _obstacles(run: Evaluator, sources: Iterable[Diagnostic]) -> Iterator[Obstacle]:
    """What CMake needs and does not find, but for what whole folders lack: a checkout may be without them."""
    if any(word in text_or_nothing(run.file).lower() for word in _MAKING):
        return
    for diagnostic in sources:
        if diagnostic.kind == "missing-source" and " does not exist: " in diagnostic.message:
            name = diagnostic.message.rpartition(": ")[2]
            if _has_files(diagnostic.path.parent / name):
                yield Obstacle("target source", name, diagnostic.path, diagnostic.line)
    for path, file, line in run.draft.installed_files:
        real = Path(os.path.normpath(path))
        if not os.path.exists(real) and not _is_generated(run, str(real), ()) and _has_files(real) and not may_be_no_text(real):
            yield Obstacle("install source", os.path.relpath(path, file.parent), file, line)


def _undescribed(exports: Iterable[tuple[str, Path]], manifest: Manifest, problems: Iterable[Diagnostic]) -> Iterator[Obstacle]:
    """The descriptions of plug-ins that nobody can read."""
    at = manifest.path if manifest.build_type == "catkin" else manifest.path.parent / "CMakeLists.txt"
    if manifest.build_type != "catkin":
        exports = [(host, path) for host, path in exports if (host, path) not in manifest.plugin_exports]  # ROS 2 reads none of those
    broken = {problem.path: problem.line for problem in problems if problem.kind == "plugin-xml"}
    for path in dict.fromkeys(path for _, path in exports):
        name = os.path.relpath(path, manifest.path.parent)
        if path in broken:
            yield Obstacle("description broken", name, path, broken[path])
        elif not os.path.exists(path) and _has_files(path):
            yield Obstacle("description absent", name, at, line_with(at, path.name))


def _has_files(path: Path) -> bool:
    """Whether there are files in the folder of a path."""
    try:
        return any(entry.is_file() for entry in os.scandir(path.parent))
    except OSError:
        return False


_LEAVING_OUT = """
unknown-command missing-include missing-subdirectory cyclic-subdirectory cmake-limit cmake-arguments cmake-condition cmake-syntax
cmake-message unreadable
"""


def _unsure(run: Evaluator) -> Iterator[Unsure]:
    """Why CMake may install more than is known."""
    yield from dict.fromkeys(run.draft.unsure)
    for diagnostic in run.diagnostics:
        if diagnostic.kind in _LEAVING_OUT.split():
            yield Unsure(diagnostic.message, diagnostic.path, diagnostic.line)
    if run.get("CMAKE_INSTALL_PREFIX") != run.prefix:
        yield Unsure("CMAKE_INSTALL_PREFIX is set", Path(run.file), line_with(Path(run.file), "CMAKE_INSTALL_PREFIX"))
    if not os.path.isfile(run.file):
        yield Unsure("no CMakeLists.txt", Path(run.file), 1)


def _programs(installed: Iterable[tuple[str, str]]) -> Iterator[Program]:
    """The files that CMake installs as programs, of those that exist."""
    for name, path in dict.fromkeys(installed):
        if os.path.isfile(path):
            yield Program(name, Path(os.path.normpath(path)))


def _files(names: Iterable[str]) -> tuple[Path, ...]:
    return tuple(Path(name) for name in dict.fromkeys(names))


def _elements(values: Iterable[str]) -> list[str]:
    """List elements once generator expressions are evaluated; these may span elements."""
    joined = ";".join(values)
    if "$<" in joined:
        joined = generator_expression(joined)
    return split_list(joined)


def _paths(run: Evaluator, values: Iterable[str]) -> tuple[Path, ...]:
    """Include folders, absolute, each once. The compiler's own folders and folders that do not exist in the workspace are left out."""
    result: dict[str, None] = {}
    for value in _elements(values):
        path = os.path.normpath(value)
        if not value or value.startswith("$<") or not os.path.isabs(path) or path in ("/usr/include", "/"):
            continue
        if not run.is_outside(path) and not os.path.isdir(path):
            continue
        result[path] = None
    return tuple(Path(path) for path in result)


def _target(run: Evaluator, draft: TargetDraft, problems: list[Diagnostic]) -> Target:
    properties, directory = draft.properties, draft.directory
    sources, headers, objects = _sources(run, draft, problems)
    definitions = [*directory.definitions, *properties.get("COMPILE_DEFINITIONS", [])]
    links = tuple(dict.fromkeys(_elements([*directory.links, *properties.get("LINK_LIBRARIES", [])])))
    kind = draft.kind
    if kind == EXECUTABLE and _is_test(draft, links):
        kind = TEST
    output = (
        properties.get("OUTPUT_NAME") or properties.get("LIBRARY_OUTPUT_NAME") or properties.get("RUNTIME_OUTPUT_NAME") or [draft.name]
    )[0]
    return Target(
        name=draft.name,
        output_name=output,
        kind=kind,
        package=run.package,
        cmake_file=Path(draft.cmake_file),
        line=draft.line,
        sources=sources,
        headers=headers,
        include_dirs=_paths(run, [*directory.include_dirs, *properties.get("INCLUDE_DIRECTORIES", [])]),
        interface_include_dirs=_paths(run, properties.get("INTERFACE_INCLUDE_DIRECTORIES", [])),
        definitions=_definitions(definitions),
        interface_definitions=_definitions(properties.get("INTERFACE_COMPILE_DEFINITIONS", [])),
        links=links,
        objects=objects,
        uses_packages=tuple(dict.fromkeys(draft.uses_packages)),
        given_line=draft.given_line or draft.line,
    )


def _is_test(draft: TargetDraft, links: Iterable[str]) -> bool:
    """Executables outside the default build that are linked with a test framework."""
    tested = any("gtest" in link.lower() or "gmock" in link.lower() for link in links)
    return tested or ("EXCLUDE_FROM_ALL" in draft.properties and "test" in draft.name.lower())


def _definitions(values: Iterable[str]) -> tuple[str, ...]:
    """`NAME` or `NAME=value`, without `-D`."""
    words = (value.removeprefix("-D") for value in _elements(values))
    return tuple(dict.fromkeys(word for word in words if word and not word.startswith("$<")))


def _sources(run: Evaluator, draft: TargetDraft, problems: list[Diagnostic]) -> tuple[tuple[Path, ...], tuple[Path, ...], tuple[str, ...]]:
    sources: dict[str, None] = {}
    headers: dict[str, None] = {}
    objects: list[str] = []
    folders = dict.fromkeys([draft.directory.binary, *draft.properties.get("SOURCE_BINARY_DIRS", [])])
    if draft.kind == IMPORTED:
        return (), (), ()
    for name in _elements(draft.properties.get("SOURCES", [])):
        if name.startswith("$<"):
            if name.startswith("$<TARGET_OBJECTS:"):
                objects.append(name[len("$<TARGET_OBJECTS:") : -1])
            continue
        path = os.path.normpath(name)
        found = path if os.path.isfile(path) else next((path + e for e in _TRIED_EXTENSIONS if os.path.isfile(path + e)), None)
        if found is None:
            if not _is_generated(run, path, folders):
                shown = os.path.relpath(path, draft.directory.source)
                message = f"source of {draft.name} {_why_unread(path)}: {shown}"
                problems.append(Diagnostic("missing-source", Path(draft.cmake_file), draft.line, draft.column, message))
            continue
        extension = os.path.splitext(found)[1]
        if extension in SOURCE_EXTENSIONS:
            sources[found] = None
        elif extension in HEADER_EXTENSIONS:
            headers[found] = None
    return tuple(map(Path, sources)), tuple(map(Path, headers)), tuple(objects)


def _why_unread(path: str) -> str:
    """Why there is no file to read."""
    try:
        os.stat(path)
    except (FileNotFoundError, NotADirectoryError):
        return "does not exist"
    except OSError as error:
        return f"cannot be read ({why(error)})"
    return "is not a file"


def _is_generated(run: Evaluator, path: str, folders: Iterable[str]) -> bool:
    if path in run.generated or path.startswith(run.build + "/") or run.is_outside(path):
        return True
    relative = os.path.relpath(path, run.directory.source)
    return any(os.path.normpath(os.path.join(folder, relative)) in run.generated for folder in folders)
