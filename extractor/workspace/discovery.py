"""From a folder to a `Workspace`: manifests, the CMake files of the packages that are needed, plug-in descriptions."""

from __future__ import annotations

import os
from collections.abc import Collection, Iterable, Mapping
from dataclasses import replace
from pathlib import Path

from rosarch.base.boundary import confined, ros_package_path
from rosarch.base.diagnostics import Diagnostic
from rosarch.base.files import file_name
from rosarch.base.hints import hint
from rosarch.base.limits import SOURCE_SECONDS
from rosarch.extractor.package_names import quick_name
from rosarch.extractor.underlay import NOTHING_INSTALLED, Underlay
from rosarch.extractor.workspace import (
    commands_auto,
    commands_files,
    commands_find,
    commands_ignored,
    commands_python,
    commands_ros,
    commands_string,
    commands_targets,
    commands_unknown,
    commands_values,
)
from rosarch.extractor.workspace.cmake_limits import OutOfTime, time_limit
from rosarch.extractor.workspace.cmake_state import PackageDraft
from rosarch.extractor.workspace.commands_ros import finish_ament
from rosarch.extractor.workspace.drafts import finished_package
from rosarch.extractor.workspace.evaluator import Evaluator
from rosarch.extractor.workspace.installed import installed_package
from rosarch.extractor.workspace.manifests import Manifest, find_manifests, read_manifest, ros_version
from rosarch.extractor.workspace.model import Package, Workspace
from rosarch.extractor.workspace.options import DEFAULT_AMENT_DISTRO, DEFAULT_DISTRO, Options

COMMAND_MODULES = (
    commands_auto,
    commands_files,
    commands_find,
    commands_ignored,
    commands_python,
    commands_ros,
    commands_string,
    commands_targets,
    commands_unknown,
    commands_values,
)


def discover(
    root: Path,
    packages: Collection[str] | None = None,
    *,
    defines: Mapping[str, str] | None = None,
    ros_distro: str | None = None,
    environment: Mapping[str, str] | None = None,
    timeout: float = SOURCE_SECONDS,
    underlay: Underlay = NOTHING_INSTALLED,
) -> Workspace:
    """The packages below `root`; with `packages`, only those and what they need, so that one package costs little.

    What they need of an `underlay` is there, too, unless the package is below `root`. Of `packages`, some may be installed.

    `defines` are CMake cache variables and override what is assumed of `find_package`, e.g. `{"CUDA_FOUND": "0"}`.
    `ros_distro` answers `$ENV{ROS_DISTRO}` and `rosversion -d`; the default is `kinetic`, for ament packages `humble`.
    `timeout` is the limit in seconds for the CMake code of one package.
    """
    root = Path(os.path.abspath(root))
    if not os.path.isdir(root):
        what = "not a folder" if os.path.exists(root) else "no such folder"
        return Workspace(root, (), (Diagnostic("workspace", root, 1, 1, what),))
    options = Options(ros_distro, dict(defines or {}), dict(environment or {}), timeout)
    return _Discovery(root, options, underlay).run(packages)


class _Discovery:
    """The world of the evaluators: packages are evaluated when first asked for."""

    def __init__(self, root: Path, options: Options, underlay: Underlay) -> None:
        self.root = root
        self.underlay = underlay
        self.installed: list[Package] = []
        self.options = options
        self.diagnostics: list[Diagnostic] = []
        self.paths: dict[str, str] = {}
        self.manifests: dict[str, Manifest | None] = {}
        self.evaluators: dict[str, Evaluator | None] = {}
        self.drafts: dict[str, PackageDraft] = {}

    def run(self, names: Collection[str] | None) -> Workspace:
        """Evaluate what is asked for."""
        with confined([self.root, *ros_package_path(), *self.underlay.folders]):
            return self._run(names)

    def _run(self, names: Collection[str] | None) -> Workspace:
        self._locate()
        if not self.paths and not self.diagnostics:
            self._report("workspace", self.root, "no package.xml below this folder")
        if set(names or ()) - set(self.paths):
            self._locate_ignored(set(names or ()))
        self.underlay = self.underlay.without(self.paths)
        used = {ros_version(Path(path)) for path in self.paths.values()} if self.underlay.libraries else set()
        if len(used) == 1:
            self.underlay = self.underlay.of_ros(*used)
        known = {*self.paths, *self.underlay.packages}
        for name in sorted(set(names or ()) - known):
            self._report("workspace", self.root, f"no package {name} below this folder{hint(name, self.paths)}")
        wanted = sorted(self.paths if names is None else set(names) & known)
        queue, seen = list(wanted), set(wanted)
        while queue:
            for other in self._needs(queue.pop()):
                if other in known and other not in seen:
                    seen.add(other)
                    queue.append(other)
        return self._workspace(frozenset(wanted))

    def _needs(self, name: str) -> Iterable[str]:
        """Read a package; what it needs."""
        if name not in self.paths:
            package, problems = installed_package(self.underlay.packages[name])
            self.diagnostics.extend(problems)
            self.installed.extend([package] if package else [])
            return package.depends if package else ()
        self.find(name)
        manifest = self.manifest(name)
        evaluator = self.evaluators.get(name)
        return (*(manifest.depends if manifest else ()), *(evaluator.draft.found_packages if evaluator else ()))

    def _report(self, kind: str, path: Path, message: str) -> None:
        self.diagnostics.append(Diagnostic(kind, path, 1, 1, message))

    def _locate(self) -> None:
        paths = find_manifests(self.root, self.diagnostics)
        folders = {os.path.dirname(path) for path in paths}
        for path in paths:
            name = quick_name(path)
            if (name is None or name in self.paths) and any(str(above) in folders for above in Path(path).parents[1:]):
                continue  # below another package, and no package of the workspace
            if name is None or name != file_name(name):
                _manifest, problems = read_manifest(Path(path))
                self.diagnostics.extend(problems or [Diagnostic("manifest", Path(path), 1, 1, "no <name>")])
            elif name in self.paths:
                other = os.path.relpath(self.paths[name], self.root)
                self._report("duplicate-package", Path(path), f"package {name} is also in {other}, which counts")
            else:
                self.paths[name] = path

    def _locate_ignored(self, names: set[str]) -> None:
        """Packages asked for by name are read although a marker hides them from the build."""
        for path in find_manifests(self.root, [], ignored=True):
            name = quick_name(path)
            if name in names and name not in self.paths:
                self.paths[name] = path
                self._report("ignored-package", Path(path), f"package {name} is hidden from the build by an ignore marker")

    def manifest(self, name: str) -> Manifest | None:
        """The manifest of a workspace package, parsed once."""
        if name not in self.manifests and name in self.paths:
            self.manifests[name], problems = read_manifest(Path(self.paths[name]), self.options.ros_distro)
            self.diagnostics.extend(problems)
        return self.manifests.get(name)

    def path(self, name: str) -> str | None:
        """The folder of a workspace package."""
        return os.path.dirname(self.paths[name]) if name in self.paths else None

    def find(self, name: str) -> PackageDraft | None:
        """What the CMake files of a workspace package declare. A package that is asked for by itself gives what it has so far."""
        if name not in self.paths:
            return None
        if name not in self.drafts:
            self._evaluate(name)
        return self.drafts.get(name)

    def _evaluate(self, name: str) -> None:
        manifest = self.manifest(name)
        folder = os.path.dirname(self.paths[name])
        if manifest is None:
            return
        options = self.options
        if options.ros_distro is None:
            distro = DEFAULT_AMENT_DISTRO if manifest.build_type.startswith("ament") else DEFAULT_DISTRO
            options = replace(options, ros_distro=distro)
        evaluator = Evaluator(name, folder, str(self.root), options, self)
        evaluator.manifest_depends = list(manifest.build_depends)
        self.drafts[name] = evaluator.draft
        self.evaluators[name] = evaluator
        if manifest.build_type == "ament_python":
            return
        if not os.path.isfile(evaluator.file):
            if not manifest.is_metapackage:
                self._report("missing-cmakelists", manifest.path, f"package {name} has no CMakeLists.txt")
            return
        evaluator.run_top()
        finish_ament(evaluator)

    def _workspace(self, selected: frozenset[str]) -> Workspace:
        packages: list[Package] = []
        for name in sorted(self.evaluators):
            evaluator, manifest = self.evaluators[name], self.manifests.get(name)
            if evaluator is not None and manifest is not None:
                self.diagnostics.extend(evaluator.diagnostics)
                try:
                    with time_limit(self.options.timeout):
                        package, problems = finished_package(evaluator, manifest)
                except OutOfTime:
                    self._report("cmake-limit", Path(evaluator.file), f"package {name} not done after {self.options.timeout:g} s, left out")
                    continue
                packages.append(package)
                self.diagnostics.extend(problems)
        unique = sorted(set(self.diagnostics), key=lambda d: (str(d.path), d.line, d.column, d.kind, d.message))
        packages = sorted([*packages, *self.installed], key=lambda package: package.name)
        return Workspace(self.root, tuple(packages), tuple(unique), selected, underlay=self.underlay)
