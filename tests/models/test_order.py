"""The order of what one reaction does in several functions, and in one that it calls several times: that of the calls."""

from __future__ import annotations

from pathlib import Path

from node_package import node_model

from rosarch.models.component import document_json
from rosarch.models.machine.cells import Domains
from rosarch.models.machine.reactions import component_steps, courses, is_ambiguous

SOURCE = Path(__file__).parent / "order.cpp"


def test_a_reaction_does_things_in_the_order_of_its_calls(tmp_path: Path) -> None:
    document = document_json(node_model(tmp_path, SOURCE.read_text(encoding="utf-8")))
    names = {port["id"]: port["name"] for port in document["ports"]}
    domains = Domains(document)
    (cell,) = domains.cells
    found = {}
    for trigger, steps in component_steps(document, domains).items():
        assert not is_ambiguous(steps, document)
        for before in domains.cells[cell].subject.values:
            for course in courses(steps, [cell], [before], 100):
                given = "".join(f" {value}" for value in course.choices.values())
                sent = ", ".join(names[output.port] for output in course.outputs)
                found[f"{names[trigger]}{given} {before}"] = f"{course.values[0]}: {sent}"
    assert found == {
        "twice OFF": "FAST: told, done",
        "twice SLOW": "FAST: told, done",
        "twice FAST": "FAST: told, done",
        "above OFF": "FAST: done",
        "above SLOW": "FAST: done",
        "above FAST": "FAST: done",
        "either true OFF": "SLOW: told, done",
        "either true SLOW": "SLOW: told, done",
        "either true FAST": "SLOW: told",
        "either false OFF": "SLOW: told",
        "either false SLOW": "SLOW: ",
        "either false FAST": "SLOW: told",
        "again OFF": "FAST: told, done",
        "again SLOW": "FAST: told, done",
        "again FAST": "FAST: told, done",
    }
