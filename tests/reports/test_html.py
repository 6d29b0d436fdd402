"""The report as one page: its document, what it may do in a browser, and that the program in it is built from its sources."""

from __future__ import annotations

import base64
import hashlib
import json
import re
import zlib
from collections.abc import Callable
from pathlib import Path
from typing import Any

import pytest

from rosarch.base.places import Place
from rosarch.reports.html.page import page_text
from rosarch.reports.html.sources import Marks, cut, excerpts, places_in

pytestmark = pytest.mark.slow

ROOT = Path(__file__).resolve().parents[2]
STATIC = ROOT / "reports" / "html" / "static"
VIEWER = STATIC.parent / "viewer"


def block(page: str, name: str) -> str:
    return re.search(rf'<script type="application/octet-stream" id="{name}">([^<]*)</script>', page)[1]  # type: ignore[index]


def unpacked(page: str, name: str) -> str:
    return zlib.decompress(base64.b64decode(block(page, name))).decode()


@pytest.fixture(scope="module")
def delivery(examples: Path, tmp_path_factory: pytest.TempPathFactory) -> str:
    from rosarch.cli.main import main

    out = tmp_path_factory.mktemp("report") / "report.html"
    assert main(["report", str(examples / "delivery_robot"), "-o", str(out), "--source-url", "https://example.org/{path}#L{line}"]) == 0
    return out.read_text(encoding="utf-8")


@pytest.fixture(scope="module")
def document(delivery: str) -> Any:
    return json.loads(unpacked(delivery, "document"))


def test_proofs_of_components_that_are_as_they_were_are_kept(
    delivery: str, examples: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    from rosarch.cli.main import main
    from rosarch.models import derivations

    def refuse(*_: Any) -> None:
        raise AssertionError("proven again")

    monkeypatch.setattr(derivations, "component_derivations", refuse)
    out = tmp_path / "report.html"
    assert main(["report", str(examples / "delivery_robot"), "-o", str(out), "--source-url", "https://example.org/{path}#L{line}"]) == 0
    assert json.loads(unpacked(out.read_text(encoding="utf-8"), "proofs")) == json.loads(unpacked(delivery, "proofs"))


def test_components_have_ports_and_machines(document: Any) -> None:
    courier = next(c for c in document["components"] if c["name"] == "delivery_robot/courier")
    assert {port["name"] for port in courier["ports"]} >= {"obstacles_ahead", "battery"}
    assert not {key for port in courier["ports"] for key in port if key.endswith("_tree")}
    assert courier["machine"].keys() >= {"regions", "always", "dead"}


def test_systems_have_connectors_with_ends(document: Any) -> None:
    system = next(s for s in document["systems"] if s["name"].endswith("delivery.launch"))
    battery = next(c for c in system["connectors"] if c["name"] == "/battery")
    ends = {
        (system["nodes"][node]["name"], system["nodes"][node]["ports"][port]["kind"])
        for node, port in battery["sources"] + battery["sinks"]
    }
    assert ends == {("/drive", "publisher"), ("/courier", "subscriber")}
    assert {rate["topic"] for rate in system["rates"]} >= {"/battery"}
    assert system["files"][0]["file"] == "src/delivery_bringup/launch/delivery.launch"


def test_findings_mark_what_is_meant(document: Any) -> None:
    finding = next(f for f in document["findings"]["shown"] if f["check"] == "topic-type-mismatch")
    first = finding["evidence"][0]
    path, _, line = first["at"].rpartition(":")
    texts = {first + at: text for first, texts in document["sources"][path] for at, text in enumerate(texts)}
    assert texts[int(line)][slice(*first["mark"])] == "nh_.subscribe"
    assert document["findings"]["checks"]["topic-type-mismatch"]["recommendation"]


def test_every_place_that_can_be_read_is_excerpted(document: Any, examples: Path) -> None:
    places = set(places_in({key: value for key, value in document.items() if key != "sources"}))
    there = {(path, line) for path, line in places if (examples / "delivery_robot" / path).is_file()}
    told = {(path, first + at) for path, runs in document["sources"].items() for first, texts in runs for at in range(len(texts))}
    assert len(there) > 20 and there <= told


def test_components_connectors_and_findings_are_proven(delivery: str, document: Any) -> None:
    proofs = json.loads(unpacked(delivery, "proofs"))
    courier = next(c for c in document["components"] if c["name"] == "delivery_robot/courier")
    steps, roots = proofs["steps"], proofs["roots"][courier["name"]]
    assert {f"port {port['kind']} {port['name']} {port['at']}" for port in courier["ports"]} <= set(roots)
    for number in roots.values():
        text, rule, premises, _cut = steps[number]
        assert premises and rule.startswith("rules/core/"), text
    at = [proofs["places"][place] for _text, rule, _premises, _cut, *places in steps for place in places if rule == "input"]
    assert any("courier.cpp:" in place for place in at)
    assert len({json.dumps(step) for step in steps}) == len(steps)
    proven = [root for system in document["systems"] for root in proofs["roots"][system["name"]] if root.startswith("finding ")]
    assert sorted(proven) == sorted(f"finding {finding['id']}" for finding in document["findings"]["shown"] if finding["systems"])
    for system in document["systems"]:
        ends = {(node, port) for connector in system["connectors"] for node, port in connector["sources"] + connector["sinks"]}
        asked = [(system["nodes"][node], system["nodes"][node]["ports"][port]) for node, port in ends]
        keys = {f"end {port['name']} {node['id']} {node['component']}#{port['id']}" for node, port in asked if "implicit" not in port}
        assert keys | {f"node {node['id']}" for node in system["nodes"]} <= set(proofs["roots"][system["name"]])
        for rate in system["rates"]:
            told = (
                {"topic_high"} if rate["high"] is not None else {f"topic_unbounded {rate['topic']} {reason}" for reason in rate["reasons"]}
            )
            assert any(root.startswith(tuple(told)) for root in proofs["roots"][system["name"]] if f" {rate['topic']}" in root)


def test_only_what_the_page_brings_may_run(delivery: str) -> None:
    policy = re.search(r'http-equiv="Content-Security-Policy" content="([^"]*)"', delivery)[1].replace("&#x27;", "'")  # type: ignore[index]
    rules = dict(rule.split(" ", 1) for rule in policy.split("; "))
    program, styles = re.findall(r"<script>(.*?)</script>|<style>(.*?)</style>", delivery, re.DOTALL)[::-1]
    allowed = [base64.b64encode(hashlib.sha256(text.encode()).digest()).decode() for text in (program[0], unpacked(delivery, "layout"))]
    assert rules["script-src"].split() == [f"'sha256-{text}'" for text in allowed]
    assert rules["style-src"] == f"'sha256-{base64.b64encode(hashlib.sha256(styles[1].encode()).digest()).decode()}'"
    assert (rules["default-src"], rules["connect-src"], rules["base-uri"]) == ("'none'", "'none'", "'none'")
    assert "unsafe" not in policy and "http" not in policy


def test_titles_are_escaped() -> None:
    page = page_text({"title": "</title><script>alert(1)</script>"})
    assert "alert(1)" not in page.replace("&lt;/title&gt;&lt;script&gt;alert(1)&lt;/script&gt;", "")


def test_excerpts_are_runs_of_lines() -> None:
    text = "\n".join(f"line {number}" for number in range(1, 31))
    found = excerpts([("a.cpp", 2), ("a.cpp", 6), ("a.cpp", 20), ("gone.cpp", 1)], {"a.cpp": text}.get)
    assert [(first, len(lines)) for first, lines in found["a.cpp"]] == [(1, 9), (17, 7)]
    assert list(found) == ["a.cpp"]


def test_lines_are_cut_and_printable() -> None:
    assert cut("\tx = \u202e1;  ") == "    x = \\u202e1;"
    assert len(cut("y" * 1000)) == 240
    marks = Marks({"a.cpp": "\tpub = advertise(1);\n"}.get)
    assert (marks.at(Place("a.cpp", 1, 8)), marks.at(Place("a.cpp", 2, 1)), marks.at(Place("b.cpp", 1, 1))) == ([10, 19], None, None)


@pytest.mark.parametrize("pattern", ["javascript:alert(1)//{path}", "https://example.org/", "{path}"])
def test_source_urls_are_addresses_of_pages(pattern: str, examples: Path, rosarch: Callable) -> None:
    outcome = rosarch("report", examples / "delivery_robot", "--source-url", pattern)
    assert (outcome.code, outcome.err.splitlines()) == (
        2, [f"rosarch: error: --source-url {pattern}: not an address with {{path}} in it, such as https://example.org/{{path}}#L{{line}}"],
    )  # fmt: skip


def test_the_program_is_built_from_its_sources() -> None:
    names = [path.relative_to(VIEWER).as_posix() for path in (VIEWER / "src").rglob("*") if path.is_file()]
    found = hashlib.sha256()
    for name in sorted([*names, "build.mjs", "package-lock.json"]):
        found.update(f"{name}\0".encode() + (VIEWER / name).read_bytes() + b"\0")
    assert (STATIC / "sources.sha256").read_text().strip() == found.hexdigest(), "run `npm run build` in reports/html/viewer/"


def test_licences_of_what_is_bundled_are_shipped() -> None:
    wanted = json.loads((VIEWER / "package.json").read_text())["dependencies"]
    shipped = (STATIC / "THIRD_PARTY_LICENSES").read_text()
    assert wanted and all(f"{name} {version}\n" in shipped for name, version in wanted.items())
