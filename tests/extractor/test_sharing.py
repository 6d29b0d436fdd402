"""Components that have most of their facts in common are taken together, and read what is common once."""

from __future__ import annotations

from pathlib import Path

import pytest

from rosarch.extractor import sharing
from rosarch.extractor.pipeline import extract
from rosarch.extractor.sharing import in_groups, read_common


@pytest.fixture
def files(tmp_path: Path) -> dict[str, Path]:
    found = {}
    for name, size in {"library": 600, "other": 500, "a": 100, "b": 90, "c": 80, "d": 70, "small": 1}.items():
        found[name] = tmp_path / name
        found[name].write_bytes(b"x" * size)
    return found


def test_groups(files: dict[str, Path], monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(sharing, "MANY", 100)

    def order(*components: str) -> list[tuple[str, str]]:
        given = [[files.get(name, Path("gone")) for name in component.split()] for component in components]
        names = {path: name for name, path in files.items()}
        return [(components[number], " ".join(sorted(names[path] for path in common))) for number, common in in_groups(given)]

    assert order("d small", "a library", "c other", "b library", "library c gone") == [
        ("a library", "library"), ("b library", "library"), ("library c gone", "library"), ("c other", ""), ("d small", ""),
    ]  # fmt: skip
    assert order("a library other", "b library", "other c") == [("a library other", "library"), ("b library", "library"), ("other c", "")]
    assert order("small", "small") == [("small", ""), ("small", "")]
    assert order() == []


def test_what_is_common_and_the_rest_are_all_facts(examples: Path) -> None:
    with extract(examples / "mobile_base", jobs=1) as extraction:
        first, second = extraction.components
        files = frozenset(first.units) & frozenset(second.units)
        assert files
        common = read_common(files)
        for component in (first, second):
            whole, own, shared = component.rows(), component.rows(common), common.facts()
            for relation, rows in whole.items():
                assert set(rows) == {*own[relation], *shared.get(relation, ())}
                assert set(own[relation]).isdisjoint(shared.get(relation, ()))


def test_models_are_the_same(examples: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    from rosarch.models import analysis

    alone = analysis.analyze(examples / "mobile_base", jobs=1)
    monkeypatch.setattr(sharing, "MANY", 1)
    monkeypatch.setattr(sharing, "_SHARE", 0.1)
    order: list[tuple[int, frozenset[Path]]] = []

    def recorded(components: list[tuple[Path, ...]]) -> list[tuple[int, frozenset[Path]]]:
        order.extend(in_groups(components))
        return order

    monkeypatch.setattr(analysis, "in_groups", recorded)
    assert analysis.analyze(examples / "mobile_base", jobs=1) == alone
    assert len(order) == 2
    assert all(files for _, files in order)
