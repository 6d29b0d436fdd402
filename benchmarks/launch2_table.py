"""Compare what ROS 2 launch files start, as read by hand, with what rosarch makes of them.

    benchmarks/launch2_table.py SYSTEMS [--misses]

SYSTEMS has the systems of `launch2_table.tsv` side by side, under the names there. A node counts as found when its package, executable,
name, namespace, container, remappings and all parameters are those of the table; a node that is not in the table counts as an extra.
"""

from __future__ import annotations

import argparse
import json
import sys
from collections import defaultdict
from collections.abc import Iterator
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import yaml

from rosarch.extractor.launch import Composition, Files, PackagePath, compose

TABLE = Path(__file__).with_suffix(".tsv")
ASPECTS = ("package", "executable", "name", "namespace", "container", "remappings", "parameters")
ANY = object()  # a value that the table does not give


@dataclass(frozen=True)
class Row:
    """A node of the table; its file and how this is launched."""

    system: str
    file: str
    arguments: str
    package: str
    executable: str
    name: str
    namespace: str
    container: str
    remappings: str
    parameters: str


def rows() -> dict[tuple[str, str, str], list[Row]]:
    """The nodes of the table by launch."""
    found: dict[tuple[str, str, str], list[Row]] = defaultdict(list)
    for line in TABLE.read_text(encoding="utf-8").splitlines():
        if not line.startswith("#"):
            row = Row(*line.split("\t"))
            found[row.system, row.file, row.arguments].append(row)
    return found


def composed(root: Path, file: str, words: str, files: Files) -> Composition:
    """What rosarch makes of a launch file."""
    given = [word for word in words.split() if word != "-"]
    arguments = dict(word.split(":=", 1) for word in given if not word.startswith("$"))
    environment = dict(word[1:].split("=", 1) for word in given if word.startswith("$"))
    return compose([root / file], arguments, files=files, environment=environment)


def expected_parameters(root: Path, row: Row) -> dict[str, Any]:
    """The parameters that the table gives, those of files read again."""
    found: dict[str, Any] = {}
    for word in row.parameters.split(" "):
        if word.startswith("@"):
            file, _, section = word[1:].partition("#")
            node, _, path = section.partition(":")
            for data in sections(root / file, node):
                for part in filter(None, path.split(".")):
                    data = data[part]
                found.update(leaves("", data))
        elif word != "-":
            name, told, value = word.partition("=")
            found[name] = json.loads(value) if told else ANY
    return found


def sections(file: Path, node: str) -> Iterator[Any]:
    """What a file has for a node; a key may stand several times."""
    document = yaml.compose(file.read_text(encoding="utf-8"), yaml.SafeLoader)
    first, _, inner = node.partition(">")
    for key, value in document.value if document else ():
        data = yaml.safe_load(yaml.serialize(value)) if key.value == first else {}
        data = data.get(inner, {}) if inner else data
        if "ros__parameters" in data:
            yield data["ros__parameters"]


def leaves(prefix: str, data: dict[str, Any]) -> Iterator[tuple[str, Any]]:
    """Values by their names with dots."""
    for key, value in data.items():
        if isinstance(value, dict):
            yield from leaves(f"{prefix}{key}.", value)
        else:
            yield f"{prefix}{key}", ANY if isinstance(value, str) and "$(" in value else value


def actual(composition: Composition) -> list[dict[str, Any]]:
    """The nodes of a composition as the table has them."""
    found = []
    for node in composition.nodes:
        prefix = f"{node.full_name}/"
        found.append(
            {
                "package": node.package,
                "executable": node.type,
                "name": node.name or "-",
                "namespace": node.namespace.rstrip("/") or "/",
                "container": node.container or "-",
                "remappings": {remap.source: remap.target for remap in node.remaps},
                "parameters": {one.name.removeprefix(prefix): one.value for one in composition.params if one.name.startswith(prefix)},
            }
        )
    return found


def differences(root: Path, row: Row, node: dict[str, Any]) -> list[str]:
    """The aspects in which a node is not as the table says."""
    wrong = [aspect for aspect in ASPECTS[:5] if getattr(row, aspect) != node[aspect]]
    remappings = dict(word.split(":=", 1) for word in row.remappings.split(" ") if word != "-")
    wrong += ["remappings"] if {name.replace("~/", "~"): to for name, to in remappings.items()} != node["remappings"] else []
    parameters = expected_parameters(root, row)
    same = parameters.keys() == node["parameters"].keys()
    same = same and all(value is ANY or value == node["parameters"][name] for name, value in parameters.items())
    return wrong + ([] if same else ["parameters"])


def main() -> int:
    """Compare, print the table of results, and every miss when asked."""
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("systems", type=Path)
    parser.add_argument("--misses", action="store_true")
    options = parser.parse_args()
    counts: dict[str, list[int]] = defaultdict(lambda: [0, 0, 0, 0])
    missed: list[str] = []
    packages: dict[str, Files] = {}
    for (system, file, words), nodes in rows().items():
        root = options.systems / system
        files = packages.setdefault(system, Files(PackagePath([root])))
        found = actual(composed(root, file, words, files))
        count = counts[system]
        count[0] += 1
        count[1] += len(nodes)
        for row in nodes:
            best = min(found, key=lambda node: len(differences(root, row, node)), default=None)
            wrong = ["not started"] if best is None else differences(root, row, best)
            count[2] += not wrong
            missed += [f"{system}/{file} {words}: {row.package}/{row.executable} {row.name}: {', '.join(wrong)}"] if wrong else []
            if best is not None and len(wrong) < len(ASPECTS) - 2:
                found.remove(best)
        count[3] += len(found)
        missed += [f"{system}/{file} {words}: extra {node['package']}/{node['executable']} {node['name']}" for node in found]
    print(f"{'system':20}{'launches':>10}{'nodes':>8}{'right':>8}{'extra':>8}")
    for system, count in (*counts.items(), ("all", [sum(column) for column in zip(*counts.values(), strict=True)])):
        print(f"{system:20}{count[0]:10}{count[1]:8}{count[2]:8}{count[3]:8}")
    if options.misses:
        print("\n".join(missed))
    return 0 if not missed else 1


if __name__ == "__main__":
    sys.exit(main())
