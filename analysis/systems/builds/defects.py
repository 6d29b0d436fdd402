"""The defects of the packages that a composition has to do with."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

from rosarch.analysis.systems.builds.defect import Defect
from rosarch.analysis.systems.builds.headers import of_own_headers
from rosarch.analysis.systems.builds.interfaces import of_interfaces
from rosarch.analysis.systems.builds.launch_files import of_launch_files
from rosarch.analysis.systems.builds.packages import of_build
from rosarch.analysis.systems.builds.programs import of_script, of_setup
from rosarch.extractor.launch.model import Composition, ProgramNamed
from rosarch.extractor.workspace.built import Built


def defects(composition: Composition, builds: Sequence[Built]) -> Iterator[tuple[str, Defect]]:
    """The defects of packages, each with the name of its package, as far as a composition has to do with them."""
    for package in builds:
        yield from ((package.name, one) for one in (*of_interfaces(package), *of_build(package), *of_own_headers(package)))
    programs = {(named.package, named.type) for named in composition.references if isinstance(named, ProgramNamed)}
    for name, program in sorted(programs):
        for package in (one for one in builds if one.name == name):
            yield from ((name, one) for one in of_script(package, program, composition.ros))
            yield from ((name, one) for one in of_setup(package, program))
    if composition.ros == 2:
        yield from of_launch_files(composition, builds)
