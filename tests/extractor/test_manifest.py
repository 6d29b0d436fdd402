"""The manifest: a folder of facts that is stale, damaged or of another version is refused."""

from __future__ import annotations

import json
from pathlib import Path

import pytest

from rosarch.extractor import manifest as module
from rosarch.extractor.facts import write_component
from rosarch.extractor.manifest import ManifestError, content_hash, read_manifest, schema_hash, write_manifest
from rosarch.extractor.workspace import Diagnostic

NOTE = Diagnostic("source", Path("a.cpp"), 1, 1, "something")


@pytest.fixture
def facts(tmp_path: Path) -> Path:
    """A folder of facts of one component with one source."""
    root, out = tmp_path / "src", tmp_path / "facts"
    root.mkdir()
    (root / "a.cpp").write_text("int a;\n", encoding="utf-8")
    entry = write_component(out, "pkg", "node", "node", ("a.cpp",), {"call": {("c1", "go")}, "component": {("node", "pkg", "node")}})
    write_manifest(out, root, [entry], ["a.cpp", "a.cpp"], [NOTE])
    return out


def refusal(folder: Path) -> str:
    with pytest.raises(ManifestError) as caught:
        read_manifest(folder)
    return str(caught.value).replace(f"{folder.parent}/", "")


def edit(folder: Path, **changes: object) -> None:
    path = folder / "manifest.json"
    path.write_text(json.dumps({**json.loads(path.read_text(encoding="utf-8")), **changes}), encoding="utf-8")


def test_a_good_folder_is_read(facts: Path) -> None:
    found = read_manifest(facts)
    assert found.root == str(facts.parent / "src")
    assert [(entry.package, entry.component, entry.kind, entry.folder, entry.sources) for entry in found.entries] == [
        ("pkg", "node", "node", "pkg/node", ("a.cpp",))
    ]
    assert found.entries[0].rows["call"] == 1
    assert dict(found.hashes) == {"a.cpp": content_hash(facts.parent / "src/a.cpp")}
    assert found.diagnostics == (NOTE,)


def test_a_missing_manifest(tmp_path: Path) -> None:
    (tmp_path / "facts").mkdir()
    assert refusal(tmp_path / "facts") == "facts/manifest.json: no such file; is this a folder of facts?"
    assert refusal(tmp_path / "nowhere") == "nowhere/manifest.json: no such file; is this a folder of facts?"


@pytest.mark.parametrize(
    ("text", "why"),
    [
        ("", "Expecting value: line 1 column 1 (char 0)"),
        ('{"format": 1', "Expecting ',' delimiter: line 1 column 13 (char 12)"),
        ("{}", "'components'"),
        ('{"components": []}', "'diagnostics'"),
        ("[]", "list indices must be integers or slices, not str"),
    ],
)
def test_a_damaged_manifest(facts: Path, text: str, why: str) -> None:
    (facts / "manifest.json").write_text(text, encoding="utf-8")
    assert refusal(facts) == f"facts/manifest.json: damaged ({why}); extract the facts again"


def test_another_schema(facts: Path) -> None:
    edit(facts, schema="0123456789abcdef")
    assert refusal(facts) == "facts/manifest.json: the facts were written under another schema; extract them again"


def test_another_format(facts: Path) -> None:
    edit(facts, format=0)
    assert refusal(facts) == "facts/manifest.json: the facts were written under another schema; extract them again"


CHANGED = "facts/pkg/node: the facts are incomplete or were changed; extract them again"


def test_a_truncated_file(facts: Path) -> None:
    (facts / "pkg/node/call.facts").write_text("c1\tg", encoding="utf-8")
    assert refusal(facts) == CHANGED


def test_a_missing_file(facts: Path) -> None:
    (facts / "pkg/node/variable.facts").unlink()
    assert refusal(facts) == CHANGED


def test_an_added_file(facts: Path) -> None:
    (facts / "pkg/node/more.facts").write_text("x\n", encoding="utf-8")
    assert refusal(facts) == CHANGED


def test_a_missing_folder(facts: Path) -> None:
    for path in (facts / "pkg/node").iterdir():
        path.unlink()
    (facts / "pkg/node").rmdir()
    assert refusal(facts) == CHANGED


def test_a_changed_source(facts: Path) -> None:
    (facts.parent / "src/a.cpp").write_text("int b;\n", encoding="utf-8")
    assert refusal(facts) == "src/a.cpp: changed since the facts were extracted; extract them again"


def test_facts_without_their_sources_are_good(facts: Path) -> None:
    (facts.parent / "src/a.cpp").unlink()
    assert len(read_manifest(facts).entries) == 1


def test_a_file_that_does_not_belong_is_no_change(facts: Path) -> None:
    (facts / "pkg/node/notes.txt").write_text("mine", encoding="utf-8")
    assert len(read_manifest(facts).entries) == 1


def test_the_manifest_is_deterministic(facts: Path) -> None:
    text = (facts / "manifest.json").read_text(encoding="utf-8")
    data = json.loads(text)
    assert text == json.dumps(data, indent=1, sort_keys=True) + "\n"
    assert sorted(data) == ["components", "diagnostics", "format", "root", "schema", "sources"]
    assert data["schema"] == schema_hash()


def test_the_schema_hash_follows_the_schema(monkeypatch: pytest.MonkeyPatch, tmp_path: Path) -> None:
    (tmp_path / "schema").mkdir()
    (tmp_path / "schema/a.dl").write_text(".decl a(x: symbol)\n", encoding="utf-8")
    monkeypatch.setattr(module, "rules_folder", lambda: tmp_path)
    first = module.schema_hash.__wrapped__()
    (tmp_path / "schema/a.dl").write_text(".decl a(x: number)\n", encoding="utf-8")
    assert len(first) == 16
    assert module.schema_hash.__wrapped__() != first


@pytest.mark.parametrize(
    ("change", "why"),
    [
        ({"package": "../../evil"}, "'../../evil' is no name of a package or component"),
        ({"component": ".."}, "'..' is no name of a package or component"),
        ({"folder": "/etc"}, "'/etc' is not the folder of pkg/node"),
        ({"folder": 5}, "5 is not the folder of pkg/node"),
        ({"package": 5}, "'int' object has no attribute 'rpartition'"),
    ],
)
def test_an_entry_that_leads_elsewhere(facts: Path, change: dict[str, object], why: str) -> None:
    (entry,) = json.loads((facts / "manifest.json").read_text(encoding="utf-8"))["components"]
    edit(facts, components=[{**entry, **change}])
    assert refusal(facts) == f"facts/manifest.json: damaged ({why}); extract the facts again"


def test_a_root_that_is_no_path(facts: Path) -> None:
    edit(facts, root=5)
    assert refusal(facts) == "facts/manifest.json: damaged (the root is no path); extract the facts again"
