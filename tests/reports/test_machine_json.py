"""The JSON of state machines and of components follows the published schemas."""

from __future__ import annotations

import json
from pathlib import Path

import pytest
from jsonschema import Draft202012Validator
from machine_documents import DOOR, Document, document
from test_machine_text import hostile

from rosarch.models.machine.build import StateMachine, build_machine
from rosarch.reports.json_models import component_schema
from rosarch.reports.machine_json import machine_data, machine_schema, machines_text

EXAMPLES = Path(__file__).resolve().parents[2] / "examples"
DOCUMENTS = {str(path.relative_to(EXAMPLES)): json.loads(path.read_text()) for path in sorted(EXAMPLES.glob("*/expected/*/*.json"))}


def test_schemas_are_schemas() -> None:
    Draft202012Validator.check_schema(machine_schema())
    Draft202012Validator.check_schema(component_schema())


@pytest.mark.parametrize(
    "machine", [*map(build_machine, (DOOR, document(), *DOCUMENTS.values())), hostile()], ids=lambda m: m.component[:8]
)
def test_machines_follow_their_schema(machine: StateMachine) -> None:
    Draft202012Validator(machine_schema()).validate(json.loads(machines_text([machine]))[0])


@pytest.mark.parametrize("name", DOCUMENTS)
def test_components_follow_their_schema(name: str) -> None:
    Draft202012Validator(component_schema()).validate(DOCUMENTS[name])


@pytest.mark.parametrize(
    ("path", "value"),
    [(("regions", 0, "initial"), []), (("regions", 0, "transitions", 0, "trigger"), 3), (("more",), 1), (("regions",), None)],
)
def test_the_schema_refuses_what_is_wrong(path: tuple[str | int, ...], value: object) -> None:
    data = machine_data(build_machine(DOOR))
    inner = data
    for key in path[:-1]:
        inner = inner[key]
    inner[path[-1]] = value
    assert not Draft202012Validator(machine_schema()).is_valid(data)


def test_every_field_of_the_document_is_required() -> None:
    full: Document = DOCUMENTS["docking_states/expected/auto_docking/docking.json"]
    for key in full:
        assert not Draft202012Validator(component_schema()).is_valid({k: v for k, v in full.items() if k != key}), key


def test_a_transition() -> None:
    (region, _) = machine_data(build_machine(DOOR))["regions"]
    assert region["transitions"][0] == {
        "source": 0,
        "target": 1,
        "trigger": "open",
        "guard": {"text": "!locked_", "formula": {"is": {"variable": "Door::locked_", "in": ["false"]}}},
        "outputs": [{"port": "motor", "name": "motor", "when": None, "sometimes": False}],
        "assigned": {"Door::state_": "OPEN"},
        "rows": [{"list": "reactive", "index": 1, "at": ["n.cpp:51"]}, {"list": "transitions", "index": 0, "at": ["n.cpp:10"]}],
    }
    assert region["states"] == [{"Door::state_": "CLOSED"}, {"Door::state_": "OPEN"}]
