"""Rules with files of one's own and variants: which of the shipped ones are taken as they were compiled."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path

import pytest

from rosarch.datalog import program as programs
from rosarch.rule_programs import compile, sets

CHECK = """// id: my-check
// title: Nodes
// help: A node is started
// impact: high
// confidence: high
// description: None.
// scenario: None.
// recommendation: None.
// message: {node} is started
// at: node

/// `node` is started. Must.
.decl my_check(node: Start)
my_check(N) :- started(N, _, _).
"""


@pytest.mark.slow
@pytest.mark.parametrize("other", ["rules of one's own", "a variant"])
def test_what_differs_in_systems_alone_has_the_shipped_rules_of_components(
    other: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    compile.compile_rules()
    own = tmp_path / "my-check.dl"
    own.write_text(CHECK)
    rules = sets.rule_set([own]) if other != "a variant" else sets.rule_set(variants={"name-matching": "exact"})

    def refuse(paths: Sequence[Path], *_: object) -> None:
        raise AssertionError(f"compiled again: {paths}")

    monkeypatch.setenv("ROSARCH_CACHE_DIR", str(tmp_path / "cache"))
    with monkeypatch.context() as patch:
        patch.setattr(programs, "_compiled", refuse)
        assert sets.model_program(rules).hash == sets.model_program().hash
        assert sets.is_loaded_soon(rules)
        with pytest.raises(AssertionError, match="compiled again"):
            sets.system_rules(rules)
