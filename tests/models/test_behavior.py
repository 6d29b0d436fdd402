"""Behaviour of small nodes: each `behavior/*.cpp` says in `// expect:` comments all that is to be derived, and nothing else may be."""

from __future__ import annotations

import re
from pathlib import Path
from typing import Any

import pytest
from node_package import node_model

from rosarch.models.component import to_json

HERE = Path(__file__).parent / "behavior"
NODES = sorted(HERE.glob("*.cpp"))


def lines(document: dict[str, Any]) -> list[str]:
    """The behaviour of a document, one line each."""
    ports = {port["id"]: port["name"] for port in document["ports"]}

    def port_names(ids: list[str]) -> str:
        return ",".join(ports.get(one, one) for one in ids)

    return sorted(
        [
            f"periodic {p['mechanism']} {p['hz']} {p['hz_from_param']} {port_names(p['publishes'])} [{p['conditional'] or ''}]"
            for p in document["periodic"]
        ]
        + [
            f"reactive {ports[r['input']]} -> {ports[r['output']]} {'must' if r['must'] else 'may'} [{r['when'] or ''}]"
            for r in document["reactive"]
        ]
        + [
            f"once after {o['after']} {o['after_from_param']} -> {ports[o['output']]} {'must' if o['must'] else 'may'} [{o['when'] or ''}]"
            for o in document["one_shot"]
        ]
        + [f"deferred {ports[d['input']]} -> {ports[d['output']]} by {d['variable']}" for d in document["reactive_deferred"]]
        + [f"state {v['name']} = {v['initial']}" for v in document["state_variables"]]
        + [f"config {v['name']} = {v['initial']} {v.get('from_param')}" for v in document["configuration"]]
        + [
            f"transition {t['variable']} . {t.get('field')} on {port_names(t['trigger'])} [{t['guard'] or ''}] := {t['value']}"
            for t in document["transitions"]
        ]
    )


def normal_lines(document: dict[str, Any]) -> list[str]:
    """Reactions and transitions with their conditions in normal form."""
    ports = {port["id"]: port["name"] for port in document["ports"]}
    return sorted(
        [f"reactive {ports[r['input']]} -> {ports[r['output']]} [{r['when_normal'] or ''}]" for r in document["reactive"]]
        + [
            f"transition {t['variable']} on {','.join(ports.get(one, one) for one in t['trigger'])} [{t['guard_normal'] or ''}]"
            for t in document["transitions"]
        ]
    )


@pytest.mark.parametrize("node", NODES, ids=lambda node: node.stem)
def test_behavior_is_as_expected(node: Path, tmp_path: Path) -> None:
    source = node.read_text(encoding="utf-8")
    model = node_model(tmp_path, source)
    expected = sorted(re.findall(r"^// expect: (.*)$", source, re.MULTILINE))
    assert expected
    assert lines(to_json(model)) == expected
    normal = sorted(re.findall(r"^// normal: (.*)$", source, re.MULTILINE))
    assert not normal or normal_lines(to_json(model)) == normal
