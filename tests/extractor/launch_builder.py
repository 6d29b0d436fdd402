"""Launch files of one test, in a package of their own."""

from __future__ import annotations

from collections.abc import Mapping
from pathlib import Path

from rosarch.extractor.launch import Composition, Files, PackagePath, compose

MANIFEST = "<package><name>{}</name><version>1.2.3</version></package>"


def composed(
    folder: Path,
    content: str | bytes,
    arguments: Mapping[str, str] | None = None,
    environment: Mapping[str, str] | None = None,
    **others: str | bytes,
) -> Composition:
    """Compose a launch file with the `content` of `<launch>`, in package `here`; `others` are files beside it, `_` in names for `.`."""
    package = folder / "here"
    package.mkdir(exist_ok=True)
    (package / "package.xml").write_text(MANIFEST.format("here"))
    for name, text in others.items():
        (package / name.replace("_", ".")).write_bytes(text if isinstance(text, bytes) else text.encode())
    document = content if isinstance(content, bytes) else f"<launch>\n{content}\n</launch>\n".encode()
    (package / "main.launch").write_bytes(document)
    return compose([package / "main.launch"], arguments, files=Files(PackagePath([folder]), str(folder)), environment=environment)


def problems(composition: Composition, folder: Path) -> list[str]:
    """The problems, with places relative to the package."""
    return [str(problem).replace(f"{folder}/here/", "") for problem in composition.problems]


def params(composition: Composition) -> dict[str, object]:
    """The values of all parameters."""
    return {setting.name: setting.value for setting in composition.params}
