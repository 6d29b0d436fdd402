"""Drawings by Graphviz."""

from __future__ import annotations

import shutil
import subprocess

SECONDS = 60.0


class DrawingError(Exception):
    """Graphviz is not there, or could not draw; the text is one line."""


def svg_text(dot: str, *, seconds: float = SECONDS) -> str:
    """The drawing of a graph in Graphviz' language."""
    program = shutil.which("dot")
    if program is None:
        raise DrawingError("SVG needs Graphviz: there is no `dot` on PATH; the formats dot and mermaid need no installation")
    try:
        done = subprocess.run([program, "-Tsvg"], input=dot.encode("utf-8", "replace"), capture_output=True, timeout=seconds, check=False)
    except subprocess.TimeoutExpired:
        raise DrawingError(
            f"Graphviz did not finish within {seconds:g} s; show less of the system, or merge the nodes of each namespace"
        ) from None
    except OSError as error:
        raise DrawingError(f"{program}: cannot run ({(error.strerror or str(error)).lower()})") from None
    if done.returncode:
        lines = done.stderr.decode("utf-8", "replace").strip().splitlines()
        raise DrawingError(f"Graphviz could not draw this: {lines[0] if lines else f'exit code {done.returncode}'}")
    return done.stdout.decode("utf-8", "replace")
