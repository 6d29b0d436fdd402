"""Packages as they are installed: what build tools leave of them, as plain data.

Sources: https://github.com/ament/ament_cmake/blob/rolling/ament_cmake_core/doc/resource_index.md, rclcpp_components and pluginlib for what
they register there, https://packaging.python.org/en/latest/specifications/entry-points.
"""

from __future__ import annotations

import configparser
import os
import re
from collections.abc import Iterator
from pathlib import Path

from rosarch.base.diagnostics import Diagnostic
from rosarch.base.files import read_file
from rosarch.extractor.underlay import COMPONENTS, Installed, names_in, python_folders
from rosarch.extractor.workspace.manifests import Manifest, read_manifest
from rosarch.extractor.workspace.model import EntryPoint, Package, PluginClass, Program
from rosarch.extractor.workspace.plugins import read_plugins

_SHEBANG = re.compile(rb"#![^\n]*\bpython")
_LARGEST_SCRIPT = 1 << 20
_PLUGINS = "__pluginlib__plugin"
_NOT_IN_NAMES = re.compile(r"[-_.]+")


def installed_package(found: Installed) -> tuple[Package | None, list[Diagnostic]]:
    """What the files of a package say, and what was not understood of it; none when it has no manifest that can be read."""
    manifest, problems = read_manifest(Path(found.share, "package.xml"))
    if manifest is None:
        return None, problems
    exports = (*manifest.plugin_exports, *_exports(found))
    plugins, more = read_plugins(exports, manifest)
    scripts = {name: path for name, path in found.programs().items() if _is_script(path)}
    commands = {point.name: point for point in _entry_points(found)}
    files = {kind: tuple(_interfaces(found, kind)) for kind in ("msg", "srv", "action")}
    package = Package(
        name=found.name,
        path=Path(found.share),
        manifest=manifest.path,
        version=manifest.version,
        build_type=manifest.build_type,
        depends=manifest.depends,
        build_depends=manifest.build_depends,
        is_metapackage=manifest.is_metapackage,
        message_files=files["msg"],
        service_files=files["srv"],
        action_files=files["action"],
        plugin_exports=exports,
        plugins=(*plugins, *_components(found, manifest)),
        programs=tuple(Program(name, Path(path)) for name, path in scripts.items() if name not in commands),
        entry_points=tuple(point for name, point in commands.items() if name in scripts),
        installed=True,
    )
    return package, [*problems, *more]


def _exports(found: Installed) -> Iterator[tuple[str, Path]]:
    """The plug-in descriptions that the index names, each with the package of the base."""
    for kind, text in found.resources():
        base, ending, _ = kind.partition(_PLUGINS)
        if ending:
            yield from ((base, Path(os.path.normpath(f"{found.prefix}/{line.strip()}"))) for line in text.splitlines() if line.strip())


def _components(found: Installed, manifest: Manifest) -> Iterator[PluginClass]:
    """The classes that can be loaded into containers."""
    for line in found.resource(COMPONENTS).splitlines():
        name, _, library = line.strip().partition(";")
        if name:
            yield PluginClass(name, name, COMPONENTS, library, manifest.path, 1)


def _interfaces(found: Installed, kind: str) -> Iterator[Path]:
    """The interfaces of a kind: those in the folder of its name, and where the index says that they are."""
    listed = (line.strip() for line in found.resource("rosidl_interfaces").splitlines())
    paths = dict.fromkeys([*(f"{kind}/{name}" for name in names_in(f"{found.share}/{kind}")), *listed])
    yield from (Path(found.share, path) for path in paths if path.endswith(f".{kind}") and ".." not in path.split("/"))


def _is_script(path: str) -> bool:
    """Whether a program is one of Python; those that are compiled are not read."""
    try:
        return _SHEBANG.match(read_file(path, _LARGEST_SCRIPT)) is not None
    except OSError:
        return False


def _entry_points(found: Installed) -> Iterator[EntryPoint]:
    """The commands that the metadata of its Python package declares."""
    for folder in python_folders(found.prefix):
        for name in names_in(folder):
            stem, dot, kind = name.rpartition(".")
            if dot and kind in ("egg-info", "dist-info") and _plain(stem.partition("-")[0]) == _plain(found.name):
                yield from _declared(Path(folder, name, "entry_points.txt"))


def _plain(name: str) -> str:
    """The name of a distribution as it is compared."""
    return _NOT_IN_NAMES.sub("-", name).lower()


def _declared(path: Path) -> Iterator[EntryPoint]:
    parser = configparser.ConfigParser(delimiters=("=",), interpolation=None, strict=False)
    try:
        text = read_file(path, _LARGEST_SCRIPT).decode(errors="replace")
        parser.read_string(text)
    except (OSError, configparser.Error):
        return  # without it, its programs are read as they are
    for name, value in parser.items("console_scripts") if parser.has_section("console_scripts") else ():
        module, _, function = value.partition("[")[0].strip().partition(":")
        if module and function:
            yield EntryPoint(name, module, function, path, 1)
