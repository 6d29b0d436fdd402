"""The facts of a workspace as one text: the same facts as in a folder, read without libclang, refused with the place of what is wrong."""

from __future__ import annotations

import subprocess
import sys
from collections.abc import Callable
from pathlib import Path

import pytest

from rosarch.extractor.manifest import ManifestError
from rosarch.extractor.stored_facts import has_facts, read_stored

ROOT = Path(__file__).resolve().parents[2]
TEXT = ROOT / "examples" / "facts" / "docking_states.txt"
HEAD = "rosarch facts\nroot\t.\n\ncomponent\tpkg\tnode\tnode\ta.cpp\n"


@pytest.mark.slow
def test_a_text_has_the_facts_of_a_folder(rosarch: Callable, tmp_path: Path) -> None:
    assert rosarch("extract", ROOT / "examples/docking_states", "--out", tmp_path).code == 0
    folder, text = read_stored(tmp_path), read_stored(TEXT)
    assert text.root == folder.root == ROOT / "examples/docking_states"
    assert [(c.package, c.name, c.kind, c.sources) for c in text.components] == [
        (c.package, c.name, c.kind, c.sources) for c in folder.components
    ]
    for ours, theirs in zip(text.components, folder.components, strict=True):
        assert dict(ours.rows()) == {name: rows for name, rows in theirs.rows().items() if rows}
    assert rosarch("analyze", TEXT, "--format", "json").out == rosarch("analyze", tmp_path, "--format", "json").out


@pytest.mark.slow
def test_rules_are_run_on_it_without_libclang(tmp_path: Path) -> None:
    (tmp_path / "own.dl").write_text('.decl named(name: symbol)\n.output named\nnamed(Name) :- port([_, "subscriber", Name]).\n')
    (tmp_path / "run.py").write_text(
        "import sys\n"
        "from rosarch.cli.main import main\n"
        "text, rules = sys.argv[1:]\n"
        "assert main(['query', text, 'state_variable(V)', '-c', 'docking']) == 0\n"
        "assert main(['explain', text, 'named(beacon)', '-c', 'docking', '-r', rules, '--depth', '1']) == 0\n"
        "assert main(['rules', 'run', text, rules, '-c', 'docking']) == 0\n"
        "assert main(['show', 'ports', text, 'docking']) == 0\n"
        "assert not [name for name in sys.modules if name.partition('.')[0] == 'clang']\n"
    )
    done = subprocess.run([sys.executable, tmp_path / "run.py", TEXT, tmp_path / "own.dl"], capture_output=True, text=True, check=False)
    assert (done.returncode, done.stderr) == (0, "")
    assert "auto_docking::Docking::state_\n" in done.stdout and "named\nname\n--------\nbeacon\n" in done.stdout
    assert "  src/auto_docking/src/docking.cpp:" in done.stdout


@pytest.mark.parametrize(
    ("lines", "message"),
    [
        ("call(call, name)\n\tc\tf\n\tc\n", "7:2: expected 2 cells, found 1"),
        ("location(node, file, line, column)\n\tn\tf\tten\t1\n", "6:6: `line` is a number, not `ten`"),
        ("\tn\tf\n", "5:1: a row of no relation"),
        ("cal(call, name)\n", "5:1: no relation `cal` is extracted, did you mean `call`?"),
        ("call(call, function)\n", "5:1: the schema has `call(call, name)`; extract the facts again"),
        ("source\ta.cpp\n", "5:1: `source` needs 2 cells, found 1"),
        ("source\t0\t../a.cpp\n", "5:10: a source that is not below the root"),
        ("component\t..\tnode\tnode\n", "5:1: `..` is no name of a package or component"),
        ("component\tpkg\n", "5:1: `component` needs 3 cells, found 1"),
        ("diagnostic\tsource\ta.cpp\tx\t1\tbad\n", "5:1: the line and the column of a `diagnostic` are numbers"),
    ],
)
def test_what_is_wrong_is_told_with_its_place(lines: str, message: str, tmp_path: Path) -> None:
    (tmp_path / "f.txt").write_text(HEAD + lines)
    assert has_facts(tmp_path / "f.txt")
    with pytest.raises(ManifestError) as caught:
        read_stored(tmp_path / "f.txt")
    assert str(caught.value) == f"{tmp_path}/f.txt:{message}"


@pytest.mark.slow
def test_a_text_of_other_sources_is_refused(rosarch: Callable, tmp_path: Path) -> None:
    (tmp_path / "a.cpp").write_text("int a;\n")
    (tmp_path / "f.txt").write_text(HEAD + "source\t0123456789abcdef\ta.cpp\n")
    outcome = rosarch("query", tmp_path / "f.txt", "port(P)")
    assert (outcome.code, outcome.err) == (
        2,
        f"rosarch: error: {tmp_path}/a.cpp: changed since the facts were extracted; extract them again\n",
    )


def test_a_source_of_a_name_too_long_is_no_change(tmp_path: Path) -> None:
    (tmp_path / "f.txt").write_text(HEAD + f"source\t0123456789abcdef\t{'a' * 300}.cpp\n")
    assert len(read_stored(tmp_path / "f.txt").components) == 1


def test_relations_before_any_component_are_refused(tmp_path: Path) -> None:
    (tmp_path / "f.txt").write_text("rosarch facts\ncall(call, name)\n")
    with pytest.raises(ManifestError, match=r"f\.txt:2:1: facts of no component$"):
        read_stored(tmp_path / "f.txt")


@pytest.mark.slow
def test_other_files_are_no_facts(rosarch: Callable, tmp_path: Path) -> None:
    (tmp_path / "a.txt").write_text("hello\n")
    for arguments in (("query", tmp_path / "a.txt", "port(P)"), ("analyze", tmp_path / "a.txt")):
        outcome = rosarch(*arguments)
        assert (outcome.code, outcome.err) == (2, f"rosarch: error: {tmp_path}/a.txt: neither a folder nor a text of facts\n")
    outcome = rosarch("extract", ROOT / "examples/docking_states", "--text", "--out", tmp_path)
    assert (outcome.code, outcome.err) == (2, f"rosarch: error: {tmp_path}: a folder; name a file for --text\n")
