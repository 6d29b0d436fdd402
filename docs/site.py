"""Additions to mkdocs: files elsewhere in the repository that the pages link to are part of the site, and links to them lead there."""

from __future__ import annotations

import posixpath
import re
from pathlib import Path
from typing import Any

from mkdocs.structure.files import File

ROOT = Path(__file__).resolve().parent.parent
PAGES = ("CONTRIBUTING.md", "examples/README.md", "benchmarks/README.md", "rules/README.md")
LINK = re.compile(r"(\]\()(?!https?:|#)([^)#\s]+)")


def on_files(files: Any, config: Any) -> Any:
    """Add the pages outside of docs/, and the schemas and other files that any page links to."""
    for path in sorted({*PAGES, *_linked()}):
        files.append(File.generated(config, _site_path(path), abs_src_path=str(ROOT / path)))
    return files


def on_page_markdown(markdown: str, page: Any, **_others: Any) -> str:
    """The text of a page with links as they are in the site, where docs/ is the root."""
    here = page.file.src_uri
    folder = posixpath.dirname(here if here in PAGES else f"docs/{here}")

    def moved(link: re.Match[str]) -> str:
        target = _site_path(posixpath.normpath(posixpath.join(folder, link[2])))
        return link[1] + posixpath.relpath(target, posixpath.dirname(here) or ".")

    return LINK.sub(moved, markdown)


def _site_path(path: str) -> str:
    """Where a file of the repository is in the site; the README's place is taken by the index."""
    return "index.md" if path == "README.md" else path.removeprefix("docs/")


def _linked() -> set[str]:
    """The files outside of docs/ that pages link to, and that are no pages."""
    found = set()
    for path in [*(ROOT / "docs").glob("*.md"), *(ROOT / page for page in PAGES)]:
        folder = path.parent.relative_to(ROOT).as_posix()
        for _, target in LINK.findall(path.read_text(encoding="utf-8")):
            name = posixpath.normpath(posixpath.join(folder, target))
            if not name.startswith("docs/") and not name.endswith(".md") and (ROOT / name).is_file():
                found.add(name)
    return found
