"""The name in a package manifest."""

from __future__ import annotations

import html
import re

from rosarch.extractor.files import read_file

_COMMENT = re.compile(r"<!--.*?(?:-->|\Z)", re.DOTALL)
_NAME = re.compile(r"<name>\s*([^<\s]+)\s*</name>")


def quick_name(path: str) -> str | None:
    """The package name without parsing: enough to know which manifests are needed."""
    try:
        text = read_file(path).decode(errors="replace")
    except OSError:
        return None
    match = _NAME.search(_COMMENT.sub("", text))
    return html.unescape(match.group(1)) if match else None
