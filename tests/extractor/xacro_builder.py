"""Xacro files of one test, in a package of their own."""

from __future__ import annotations

from collections.abc import Mapping
from pathlib import Path

from rosarch.extractor.launch import Files, PackagePath
from rosarch.extractor.launch.unknowns import Unknowns
from rosarch.extractor.urdf import NOETIC, Dialect, Expansion, expand, write

HEAD = '<robot xmlns:xacro="http://www.ros.org/wiki/xacro">'
MANIFEST = "<package><name>here</name></package>"


def expanded(
    folder: Path,
    content: str | bytes,
    arguments: Mapping[str, str] | None = None,
    environment: Mapping[str, str] | None = None,
    dialect: Dialect = NOETIC,
    unknowns: Unknowns | None = None,
    **others: str | bytes,
) -> Expansion:
    """Evaluate a file with the `content` of its root; `others` are files beside it, `_` in names for `.`; in texts `ROBOT` opens a root."""
    package = folder / "here"
    package.mkdir(exist_ok=True)
    (package / "package.xml").write_text(MANIFEST)
    for name, text in others.items():
        (package / name.replace("_", ".")).write_bytes(text if isinstance(text, bytes) else text.replace("ROBOT", HEAD).encode())
    document = content if isinstance(content, bytes) else f"{HEAD}{content}</robot>".encode()
    (package / "robot.xacro").write_bytes(document)
    files = Files(PackagePath([folder]), str(folder))
    return expand(f"{package}/robot.xacro", arguments, files=files, environment=environment, unknowns=unknowns, dialect=dialect)


def inner(folder: Path, content: str, **options: object) -> str:
    """What is in the evaluated root, on one line and without space between tags."""
    unknowns = Unknowns()
    expansion = expanded(folder, content, unknowns=unknowns, **options)  # type: ignore[arg-type]
    if expansion.document is None:
        return problems(expansion, folder)[-1]
    text = unknowns.render(write(expansion.document, "robot.xacro"))
    body = text[text.index("<robot") :].strip().removesuffix("</robot>")
    body = body[body.index(">") + 1 :]
    return " ".join(body.split()).replace("> <", "><")


def problems(expansion: Expansion, folder: Path) -> list[str]:
    """The problems, with places relative to the package."""
    return [str(problem).replace(f"{folder}/here/", "") for problem in expansion.problems]
