"""The models that are written: Storm reads the same system from PRISM's language and from JANI."""

from __future__ import annotations

from pathlib import Path

import pytest
from hand_made import load, system_of

from rosarch.behavior.composition.inputs import Inputs
from rosarch.behavior.verification import storm
from rosarch.behavior.verification.check import model_for
from rosarch.behavior.verification.languages import files
from rosarch.behavior.verification.properties import read_properties


@pytest.mark.skipif(not storm.is_installed(), reason=storm.HINT)
@pytest.mark.parametrize("name", ["handshake", "first_value", "overflow"])
def test_storm_reads_the_same_from_prism_and_jani(name: str, tmp_path: Path) -> None:
    import stormpy

    data = load(Path(__file__).parent / "systems" / f"{name}.yml")
    system = system_of(data["nodes"])
    item = read_properties(data["properties"], "f", system)[0]
    transitions = model_for(system, item.formula, Inputs())
    for language in ("prism", "jani"):
        for file, text in files(language, transitions, item):
            (tmp_path / file).write_text(text, "utf-8")
    program = stormpy.parse_prism_program(str(tmp_path / f"{item.name}.prism"))
    from_prism = stormpy.build_model(program)
    model, properties = stormpy.parse_jani_model(str(tmp_path / f"{item.name}.jani"))
    from_jani = stormpy.build_model(model)
    assert (from_prism.nr_states, from_prism.nr_transitions) == (from_jani.nr_states, from_jani.nr_transitions)
    assert len(properties) == 1


@pytest.mark.parametrize("language", ["prism", "jani", "promela"])
def test_what_variables_stand_for_is_told(language: str) -> None:
    data = load(Path(__file__).parent / "systems" / "handshake.yml")
    system = system_of(data["nodes"])
    item = read_properties(data["properties"], "f", system)[0]
    transitions = model_for(system, item.formula, Inputs())
    text = "".join(text for _, text in files(language, transitions, item))
    assert [number.description for number in transitions.numbers if number.description not in text] == []
    assert any(number.names for number in transitions.numbers)
    assert any(not number.names for number in transitions.numbers)
    assert " ()" not in text
