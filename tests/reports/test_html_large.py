"""The graph of a system of 200 nodes and 1,500 connections in a real browser: it is laid out, and its names can be read."""

from __future__ import annotations

import random
import shutil
from pathlib import Path
from typing import Any

import pytest

from rosarch.reports.html.page import page_text

playwright = pytest.importorskip("playwright.sync_api")

BROWSER = next(filter(None, map(shutil.which, ("chromium", "chromium-browser", "google-chrome"))), None)
pytestmark = [pytest.mark.slow, pytest.mark.skipif(BROWSER is None, reason="needs Chromium")]

NODES, CONNECTIONS, GROUPS = 200, 1500, 12
MANY = 25
"""Names of nodes that there is room for when all of them are in one window."""
TOLD = """() => [...document.querySelectorAll('.names [data-told]')].map((name) => {
  const { x, y, width, height } = name.getBoundingClientRect();
  return [name.textContent, x, y, x + width, y + height, parseFloat(getComputedStyle(name).fontSize) * name.getScreenCTM().a];
})"""


def large_document() -> dict[str, Any]:
    """Nodes that mostly meet nodes near them."""
    some = random.Random(5)
    nodes: list[dict[str, Any]] = [
        {"id": str(at), "name": f"/robot_{at * GROUPS // NODES}/node_{at}", "package": f"package_{at // 7}", "type": f"node_{at}",
         "origin": "library", "component": None, "lines": [f"a.launch:{at + 1}"], "conditions": [], "open": False, "ports": [], "rates": []}
        for at in range(NODES)
    ]  # fmt: skip

    def end(node: int, kind: str, topic: str) -> list[int]:
        ports = nodes[node]["ports"]
        ports.append({"id": f"p{len(ports)}", "kind": kind, "name": topic, "written": topic, "type": "std_msgs/String", "at": "a.cpp:1"})
        return [node, len(ports) - 1]

    connectors: list[dict[str, Any]] = []
    left = CONNECTIONS
    while left:
        topic, source = f"/topic_{len(connectors)}", some.randrange(NODES)
        readers = min(left, some.choice((1, 1, 2, 3, 5)))
        left -= readers
        near = [min(NODES - 1, max(0, source + some.randint(-12, 12))) for _ in range(readers)]
        sinks = [end(node, "subscriber", topic) for node in near]
        sources = [end(source, "publisher", topic)]
        types = ["std_msgs/String"]
        connectors.append({"kind": "topic", "name": topic, "types": types, "sources": sources, "sinks": sinks, "implicit": False})
    system = {"name": "large.launch", "nodes": nodes, "connectors": connectors, "files": [], "rates": [], "steps": None}
    empty: dict[str, Any] = {"components": [], "diagnostics": [], "sources": {}}
    return {
        "rosarch": "0",
        "title": "large",
        "link": None,
        "systems": [system],
        "findings": {"shown": [], "suppressed": [], "checks": {}},
    } | empty


def test_names_of_a_large_graph_can_be_read(tmp_path: Path) -> None:
    report = tmp_path / "large.html"
    report.write_text(page_text(large_document()), encoding="utf-8")
    with playwright.sync_playwright() as started:
        browser = started.chromium.launch(executable_path=BROWSER, args=["--no-sandbox"])
        page = browser.new_page(viewport={"width": 1280, "height": 800})
        page.goto(f"{report.as_uri()}#/graph?by=namespace")
        page.wait_for_selector(".stage[aria-busy=false] svg.graph .box", timeout=120_000)
        groups = page.locator(".box.group > text:first-of-type")
        assert groups.count() == GROUPS
        assert groups.first.evaluate("(name) => parseFloat(getComputedStyle(name).fontSize) * name.getScreenCTM().a") >= 9
        page.get_by_text("View", exact=True).click()
        page.get_by_label("Group nodes by").select_option("none")
        page.wait_for_selector(".stage[aria-busy=false] svg.graph[data-far] .names [data-told]", timeout=120_000)
        names = page.evaluate(TOLD)
        told = {text for text, *_ in names}
        assert len([text for text in told if "robot_" in text]) >= MANY
        assert all(9 <= size <= 16 for *_, size in names)
        assert [(one[0], two[0]) for at, one in enumerate(names) for two in names[:at] if overlap(one[1:5], two[1:5])] == []
        labels = page.locator(".box > text:first-of-type")
        silent = next(number for number, text in enumerate(labels.all_text_contents()) if text not in told)
        labels.nth(silent).dispatch_event("pointerover")
        assert labels.nth(silent).text_content() in {text for text, *_ in page.evaluate(TOLD)}
        browser.close()


def overlap(one: list[float], two: list[float]) -> bool:
    """Whether two rectangles share more than a pixel of their edges."""
    return min(one[2], two[2]) - max(one[0], two[0]) > 1 and min(one[3], two[3]) - max(one[1], two[1]) > 1
