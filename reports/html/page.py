"""The page: one file with the document, the program that shows it and its styles, which may load and run nothing else."""

from __future__ import annotations

import base64
import hashlib
import json
import zlib
from collections.abc import Mapping
from html import escape
from importlib.resources import files
from typing import Any

_PARTS = ("report.js", "layout.js", "report.css")


def page_text(document: Mapping[str, Any]) -> str:
    """The whole page."""
    first = {field: value for field, value in document.items() if field != "proofs"}
    return _page(str(document["title"]), _json(first), _json(document.get("proofs", {})), _policy(live=False))


def live_page(title: str) -> tuple[str, str]:
    """A page that asks the server that it comes from for the document, and the policy that it goes by."""
    policy = _policy(live=True)
    return _page(title, "", "", policy), policy


def _json(data: Any) -> str:
    return json.dumps(data, ensure_ascii=False, separators=(",", ":"))


def _page(title: str, document: str, proofs: str, policy: str) -> str:
    program, layout, styles = map(static_text, _PARTS)
    blocks = {"data": packed(document), "proofs": packed(proofs), "layout": packed(layout)}
    return _PAGE.format(policy=escape(policy), title=escape(title), styles=styles, program=program, **blocks)


_PAGE = """\
<!doctype html>
<html lang="en">
<head>
<meta charset="utf-8">
<meta http-equiv="Content-Security-Policy" content="{policy}">
<meta name="viewport" content="width=device-width, initial-scale=1">
<meta name="color-scheme" content="light dark">
<meta name="referrer" content="no-referrer">
<title>{title} - rosarch</title>
<style>{styles}</style>
</head>
<body>
<div id="app"><p class="loading">Reading the report …</p></div>
<noscript><p class="loading">This report is shown by a program that it brings with it; scripts must be allowed for this page.</p></noscript>
<script type="application/octet-stream" id="document">{data}</script>
<script type="application/octet-stream" id="proofs">{proofs}</script>
<script type="application/octet-stream" id="layout">{layout}</script>
<script>{program}</script>
</body>
</html>
"""


def _policy(*, live: bool) -> str:
    """Only what the page brings with it may run: recognised by hashes. Nothing may be loaded."""
    program, layout, styles = map(static_text, _PARTS)
    scripts = " ".join(_hash(text) for text in (program, layout))
    rules = {
        "default-src": "'none'",
        "script-src": scripts,
        "style-src": _hash(styles),
        "worker-src": "blob:",
        "img-src": "data:",
        "connect-src": "'self'" if live else "'none'",
        "base-uri": "'none'",
        "form-action": "'none'",
    }
    return "; ".join(f"{name} {value}" for name, value in rules.items())


def packed(text: str) -> str:
    """A text, compressed, in characters that mean nothing to HTML."""
    return base64.b64encode(zlib.compress(text.encode("utf-8", "backslashreplace"), 9)).decode("ascii")


def static_text(name: str) -> str:
    """One of the files that the sources in `viewer/` are built to."""
    return files("rosarch.reports.html").joinpath(f"static/{name}").read_text(encoding="utf-8")


def _hash(text: str) -> str:
    return f"'sha256-{base64.b64encode(hashlib.sha256(text.encode()).digest()).decode('ascii')}'"
