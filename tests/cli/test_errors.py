"""What the command says about wrong usage and bad input: one line, exit code 2, no traceback."""

from __future__ import annotations

import errno
import json
import os
import re
import signal
import subprocess
import sys
import time
from collections.abc import Callable
from pathlib import Path

import pytest

from rosarch.base.limits import Limits


@pytest.fixture(autouse=True)
def here(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.chdir(tmp_path)


@pytest.mark.parametrize("command", [("analyze", "none"), ("extract", "none", "-o", "facts"), ("show", "ports", "none")])
def test_missing_folder(rosarch: Callable, command: tuple[str, ...]) -> None:
    outcome = rosarch(*command)
    assert (outcome.code, outcome.out, outcome.err) == (2, "", "rosarch: error: none: no such folder\n")


def test_file_instead_of_folder(rosarch: Callable, tmp_path: Path) -> None:
    (tmp_path / "file").touch()
    assert rosarch("analyze", "file").err == "rosarch: error: file: neither a folder nor a text of facts\n"
    assert rosarch("check", "file").err == "rosarch: error: file: not a folder\n"


@pytest.mark.slow
@pytest.mark.parametrize(
    ("command", "message"),
    [
        ("rules run {facts} empty", "empty: no file of rules (*.dl) in this folder"),
        ("rules run {facts} own", "own: nothing to print; add an `.output` directive or name a relation with --relation"),
        ("rules run {facts} system.dl", "system.dl: nothing to print of components; name systems with --launch, '*' for all"),
        ("rules run {facts} own -c lamp", "own: nothing to print; add an `.output` directive or name a relation with --relation"),
        ("query {facts} port(P) -c lamp", "no component lamp, did you mean `dock_lamp`?"),
        ("query {facts} port(P) -c x", "no component x, there are auto_docking/dock_lamp, auto_docking/docking, dock_lamp, docking"),
        ("show ports {facts} x", "no node or nodelet x, there are auto_docking/dock_lamp, auto_docking/docking, dock_lamp, docking"),
        ("query {facts} port(P) -r /dev/null", "/dev/null: neither a file nor a folder"),
        ("query own/own.dl port(P)", "own/own.dl: neither a folder nor a text of facts"),
        ("watch own/own.dl", "own/own.dl: neither a folder nor a text of facts"),
        ("new check a-b --into own/own.dl", "own/own.dl: not a folder"),
        ("rules list prt", "no relation prt, did you mean `port`?"),
        ("check {facts}", "{facts}: facts, where a folder of sources is needed"),
        ("doctor {facts}", "{facts}: facts, where a folder of sources is needed"),
        ("show graph {facts}", "{facts}: facts, where a folder of sources is needed"),
    ],
)
def test_what_is_asked_for_in_vain(rosarch: Callable, examples: Path, tmp_path: Path, command: str, message: str) -> None:
    (tmp_path / "empty").mkdir()
    (tmp_path / "own").mkdir()
    (tmp_path / "own" / "own.dl").write_text(".decl q(x: symbol)\nq(X) :- port([_, _, X]).\n")
    (tmp_path / "system.dl").write_text(".decl s(x: symbol)\n.output s\ns(X) :- port_name([_, _, _], X).\n")
    facts = str(examples / "facts" / "docking_states.txt")
    outcome = rosarch(*(word.format(facts=facts) for word in command.split()))
    assert (outcome.code, outcome.out, outcome.err) == (2, "", f"rosarch: error: {message.format(facts=facts)}\n")


@pytest.mark.parametrize("command", [("analyze", "empty"), ("extract", "empty", "-o", "facts"), ("show", "ports", "empty")])
def test_folder_without_packages(rosarch: Callable, tmp_path: Path, command: tuple[str, ...]) -> None:
    (tmp_path / "empty").mkdir()
    outcome = rosarch(*command)
    assert (outcome.code, outcome.out, outcome.err) == (2, "", "rosarch: error: empty: no package.xml below this folder\n")


def test_unknown_package(rosarch: Callable, workspace: Path) -> None:
    outcome = rosarch("analyze", "ws", "--package", "taker")
    assert (outcome.code, outcome.err) == (2, "rosarch: error: ws: no package taker below this folder, did you mean `talker`?\n")


def test_broken_manifest_alone(rosarch: Callable, tmp_path: Path) -> None:
    (tmp_path / "ws" / "broken").mkdir(parents=True)
    (tmp_path / "ws" / "broken" / "package.xml").write_text("<package")
    outcome = rosarch("analyze", "ws")
    assert (outcome.code, outcome.err) == (2, "rosarch: error: ws/broken/package.xml:1:1: broken XML: unclosed token\n")


def test_broken_manifest_costs_only_its_package(rosarch: Callable, workspace: Path) -> None:
    (workspace / "broken").mkdir()
    (workspace / "broken" / "package.xml").write_text("<package")
    outcome = rosarch("analyze", "ws", "--format", "json")
    assert outcome.code == 0
    assert [model["component"] for model in json.loads(outcome.out)] == ["talker"]
    assert outcome.err == "manifest: 1\n  ws/broken/package.xml:1:1: broken XML: unclosed token\n1 diagnostic\n"


@pytest.mark.parametrize("command", [("analyze", "ws"), ("extract", "ws")])
def test_output_is_a_file(rosarch: Callable, workspace: Path, tmp_path: Path, command: tuple[str, ...]) -> None:
    (tmp_path / "out").touch()
    outcome = rosarch(*command, "-o", "out")
    assert (outcome.code, outcome.out, outcome.err) == (2, "", "rosarch: error: out: not a folder\n")


def test_output_below_a_file(rosarch: Callable, workspace: Path, tmp_path: Path) -> None:
    (tmp_path / "out" / "talker").mkdir(parents=True)
    (tmp_path / "out" / "talker" / "talker.json").mkdir()
    outcome = rosarch("analyze", "ws", "-o", "out")
    assert (outcome.code, outcome.err) == (2, "rosarch: error: out/talker/talker.json: cannot write (is a directory)\n")


def test_sources_changed_since_extraction(rosarch: Callable, workspace: Path) -> None:
    assert rosarch("extract", "ws", "-o", "facts").code == 0
    source = workspace / "talker" / "talker.cpp"
    source.write_text(source.read_text() + "// changed\n")
    outcome = rosarch("analyze", "facts")
    assert (outcome.code, outcome.err) == (
        2,
        f"rosarch: error: {source}: changed since the facts were extracted; extract them again\n",
    )


def test_truncated_facts(rosarch: Callable, workspace: Path, tmp_path: Path) -> None:
    assert rosarch("extract", "ws", "-o", "facts").code == 0
    file = tmp_path / "facts" / "talker" / "talker" / "call.facts"
    file.write_bytes(file.read_bytes()[:-5])
    outcome = rosarch("analyze", "facts")
    text = "rosarch: error: facts/talker/talker: the facts are incomplete or were changed; extract them again\n"
    assert (outcome.code, outcome.err) == (2, text)


def test_facts_without_manifest(rosarch: Callable, workspace: Path, tmp_path: Path) -> None:
    assert rosarch("extract", "ws", "-o", "facts").code == 0
    (tmp_path / "facts" / "manifest.json").unlink()
    outcome = rosarch("analyze", "facts")
    assert (outcome.code, outcome.err) == (2, "rosarch: error: facts/manifest.json: no such file; is this a folder of facts?\n")


def test_unknown_package_of_facts(rosarch: Callable, workspace: Path) -> None:
    assert rosarch("extract", "ws", "-o", "facts").code == 0
    outcome = rosarch("analyze", "facts", "--package", "taker")
    assert outcome.err == "rosarch: error: facts: no package taker among these facts, did you mean `talker`?\n"


def test_unknown_node(rosarch: Callable, workspace: Path) -> None:
    outcome = rosarch("show", "ports", "ws", "tolker")
    assert (outcome.code, outcome.out, outcome.err) == (2, "", "rosarch: error: no node or nodelet tolker, did you mean `talker`?\n")


def test_souffle_is_not_installed(rosarch: Callable, workspace: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("PATH", "")
    outcome = rosarch("analyze", "ws", "--engine", "souffle")
    text = "rosarch: error: --engine souffle: there is no `souffle` on PATH; the embedded engine needs no installation\n"
    assert (outcome.code, outcome.err) == (2, text)


@pytest.mark.parametrize(
    ("arguments", "text"),
    [
        (("analyze", ".", "--define", "CUDA"), "--define CUDA: not of the form NAME=VALUE"),
        (("analyze",), "Missing argument 'DIR'. (see rosarch analyze --help)"),
        (("analyze", ""), "Invalid value for 'DIR': an empty path (see rosarch analyze --help)"),
        (("extract", ".", "--out="), "Invalid value for '--out' / '-o': an empty path (see rosarch extract --help)"),
        (("extract", "."), "Missing option '--out' / '-o'. (see rosarch extract --help)"),
    ],
)
def test_wrong_usage(rosarch: Callable, arguments: tuple[str, ...], text: str) -> None:
    outcome = rosarch(*arguments)
    assert (outcome.code, outcome.out, outcome.err) == (2, "", f"rosarch: error: {text}\n")


@pytest.mark.parametrize(
    "arguments",
    [("analyse",), ("analyze", ".", "--jobs", "0"), ("analyze", ".", "--engine", "z3"), ("analyze", ".", "--no-such"), ("show",)],
)
def test_wrong_usage_is_one_line(rosarch: Callable, arguments: tuple[str, ...]) -> None:
    outcome = rosarch(*arguments)
    assert (outcome.code, outcome.out) == (2, "")
    assert outcome.err.startswith("rosarch: error: ")
    assert outcome.err.count("\n") == 1


def test_defect_is_one_line(rosarch: Callable, workspace: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr("rosarch.analysis.components.analyze", lambda *_arguments, **_options: {}["models"])
    outcome = rosarch("analyze", "ws")
    text = "rosarch: error: unexpected KeyError: 'models' (this is a defect of rosarch; --traceback shows where)\n"
    assert (outcome.code, outcome.out, outcome.err) == (2, "", text)
    with pytest.raises(KeyError):
        rosarch("analyze", "ws", "--traceback")


def test_interrupt(rosarch: Callable, workspace: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    def interrupted(*_arguments: object, **_options: object) -> None:
        raise KeyboardInterrupt

    monkeypatch.setattr("rosarch.analysis.components.analyze", interrupted)
    outcome = rosarch("analyze", "ws")
    assert (outcome.code, outcome.out, outcome.err) == (130, "", "rosarch: interrupted\n")


@pytest.mark.slow
@pytest.mark.parametrize("number", [signal.SIGTERM, signal.SIGHUP, signal.SIGKILL])
def test_termination_leaves_nothing_behind(workspace: Path, tmp_path: Path, number: signal.Signals) -> None:
    endless = "template <int N, long M> struct T { T<N - 1, 2 * M> a; T<N - 1, 2 * M + 1> b; };\ntemplate <long M> struct T<0, M> {};\nT<24, 0> t;\n"
    cmake = workspace / "talker" / "CMakeLists.txt"
    cmake.write_text(cmake.read_text() + "add_executable(second second.cpp)\nadd_executable(third third.cpp)\n")
    for name in ("talker", "second", "third"):
        (workspace / "talker" / f"{name}.cpp").write_text(endless)
    (tmp_path / "temporary").mkdir()
    environment = {**os.environ, "TMPDIR": str(tmp_path / "temporary")}
    command = [sys.executable, "-m", "rosarch.cli.main", "analyze", "ws", "--no-cache", "--jobs", "2"]
    process = subprocess.Popen(
        command,
        env=environment,
        stdout=subprocess.PIPE,
        stderr=subprocess.PIPE,
        text=True,
        start_new_session=True,
        preexec_fn=lambda: signal.signal(signal.SIGHUP, signal.SIG_DFL),
    )
    until = time.monotonic() + 60
    while not list((tmp_path / "temporary").glob("*/*.pch")) and time.monotonic() < until:
        time.sleep(0.05)
    time.sleep(0.5)  # into the source
    process.send_signal(number)
    out, err = process.communicate(timeout=30)  # ends when no worker holds the pipes any more
    if number is signal.SIGKILL:
        assert (process.returncode, out, err) == (-number, "", "")
    else:
        assert (process.returncode, out, err) == (128 + number, "", "")
        assert list((tmp_path / "temporary").iterdir()) == []


@pytest.mark.slow
def test_closed_pipe(workspace: Path) -> None:
    command = f"{sys.executable} -m rosarch.cli.main show ports ws | true"
    done = subprocess.run(command, shell=True, capture_output=True, text=True, check=False)
    assert done.stderr == ""


def test_nothing_is_written_outside_the_output_folder(rosarch: Callable, workspace: Path, tmp_path: Path) -> None:
    cmake = workspace / "talker" / "CMakeLists.txt"
    cmake.write_text(cmake.read_text() + f"set_target_properties(talker PROPERTIES OUTPUT_NAME {tmp_path}/evil)\n")
    (workspace / "bad").mkdir()
    (workspace / "bad" / "package.xml").write_text("<package><name>../../bad</name></package>")
    before = {path for path in tmp_path.rglob("*") if path.is_file()}
    assert rosarch("analyze", "ws", "-o", "deep/models").code == 0
    assert rosarch("extract", "ws", "-o", "deep/facts").code == 0
    written = {path.relative_to(tmp_path).as_posix() for path in tmp_path.rglob("*") if path.is_file() and path not in before}
    assert {"deep/models/talker/evil.json", "deep/facts/talker/evil/call.facts", "deep/facts/manifest.json"} <= written
    assert {Path(name).parent.as_posix() for name in written} == {"deep/models/talker", "deep/facts/talker/evil", "deep/facts"}


def test_names_that_are_not_utf_8(rosarch: Callable, workspace: Path, tmp_path: Path) -> None:
    source = workspace / "talker" / "talker.cpp"
    os.rename(source, os.fsencode(source.parent) + b"/\xff.cpp")
    os.mkdir(os.fsencode(workspace) + b"/b\xff\xfe")
    cmake = workspace / "talker" / "CMakeLists.txt"
    cmake.write_text("find_package(catkin)\ncatkin_package()\nfile(GLOB S *.cpp)\nadd_executable(talker ${S} none.cpp)\n")
    missing = "missing-source: 1\n  ws/talker/CMakeLists.txt:4:1: source of talker does not exist: none.cpp\n1 diagnostic\n"
    outcome = rosarch("analyze", "ws", "--format", "json", "-o", "models")
    assert (outcome.code, outcome.err) == (0, missing)
    (model,) = json.loads(outcome.out)
    assert model["sources"] == ["talker/\\xff.cpp"]
    assert [port["at"] for port in model["ports"]] == ["talker/\\xff.cpp:8"]
    assert json.loads((tmp_path / "models" / "talker" / "talker.json").read_text()) == model
    assert rosarch("extract", "ws", "-o", "facts").code == 0
    assert json.loads(rosarch("analyze", "facts", "--format", "json").out) == [model]


@pytest.mark.slow
def test_a_locale_that_cannot_show_a_proof(workspace: Path) -> None:
    command = [sys.executable, "-m", "rosarch.cli.main", "explain", "ws", "port([_, publisher, chatter])"]
    done = subprocess.run(command, capture_output=True, text=True, check=False, env={**os.environ, "PYTHONIOENCODING": "ascii"})
    assert (done.returncode, done.stderr) == (0, "")
    assert done.stdout.splitlines()[1].startswith("\\u251c\\u2500 ")


def test_two_components_of_one_name(rosarch: Callable, workspace: Path, tmp_path: Path) -> None:
    cmake = workspace / "talker" / "CMakeLists.txt"
    cmake.write_text(cmake.read_text() + "add_executable(other talker.cpp)\nset_target_properties(other PROPERTIES OUTPUT_NAME talker)\n")
    outcome = rosarch("extract", "ws", "-o", "facts")
    assert (outcome.code, outcome.err) == (
        0,
        "duplicate-component: 1\n  ws/talker/CMakeLists.txt:5:1: talker has another component talker; that of target other is called talker_2\n"
        "1 diagnostic\n",
    )
    assert [model["component"] for model in json.loads(rosarch("analyze", "facts", "--format", "json").out)] == ["talker", "talker_2"]


def test_a_full_disk_ends_the_run(rosarch: Callable, workspace: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    def full(*_arguments: object, **_options: object) -> None:
        raise OSError(errno.ENOSPC, os.strerror(errno.ENOSPC), "/tmp/rosarch-x/y.unit")

    monkeypatch.setattr("rosarch.extractor.cxx.units.extract_unit", full)
    outcome = rosarch("analyze", "ws", "--no-cache")
    assert (outcome.code, outcome.out) == (2, "")
    assert outcome.err == "rosarch: error: /tmp/rosarch-x/y.unit: cannot write (no space left on device)\n"


def test_no_room_for_the_declarations(rosarch: Callable, workspace: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr("rosarch.extractor.cxx.units.build_prelude", lambda *_arguments: os.abort())
    monkeypatch.setattr("rosarch.extractor.cxx.units.PRELUDE_BYTES", 1 << 60)
    outcome = rosarch("analyze", "ws", "--no-cache")
    assert (outcome.code, outcome.out) == (2, "")
    assert re.search(r"^rosarch: error: .*/rosarch\.run-\w+: cannot write \(no space left on device\)$", outcome.err, re.MULTILINE)


@pytest.mark.slow
@pytest.mark.parametrize(
    ("redirection", "text"),
    [
        (">/dev/full", "rosarch: error: standard output: cannot write (no space left on device)\n"),
        (">&-", "rosarch: error: standard output: cannot write (it is closed)\n"),
    ],
)
def test_a_report_that_cannot_be_written(workspace: Path, redirection: str, text: str) -> None:
    done = subprocess.run(
        f"{sys.executable} -m rosarch.cli.main analyze ws {redirection}", shell=True, capture_output=True, text=True, check=False
    )
    assert (done.returncode, done.stderr) == (2, text)


@pytest.mark.slow
def test_closed_error_output(workspace: Path) -> None:
    (workspace / "broken").mkdir()
    (workspace / "broken" / "package.xml").write_text("<package")
    done = subprocess.run(
        f"{sys.executable} -m rosarch.cli.main analyze ws 2>&-", shell=True, stdout=subprocess.PIPE, text=True, check=False
    )
    assert (done.returncode, done.stdout.splitlines()[0]) == (0, "talker/talker  node talker  talker/")


@pytest.mark.slow
def test_a_manifest_decides_what_facts_are(rosarch: Callable, workspace: Path, tmp_path: Path) -> None:
    assert rosarch("extract", "ws", "-o", "facts").code == 0
    models = rosarch("analyze", "facts", "--format", "json").out
    for part in ("facts/talker", "facts/talker/talker"):
        assert rosarch("analyze", part, "--format", "json").out == models
    (tmp_path / "facts" / "talker" / "talker" / "call.facts").unlink()
    changed = "rosarch: error: facts/talker/talker: the facts are incomplete or were changed; extract them again\n"
    for command in (("analyze", "facts"), ("query", "facts", "port(P)")):
        assert rosarch(*command).err == changed
    part = rosarch("query", "facts/talker/talker", "port(P)")
    assert (part.code, part.err) == (2, changed.replace("facts/talker", f"{tmp_path}/facts/talker"))
    for path in (tmp_path / "facts" / "talker" / "talker").iterdir():
        path.unlink()
    assert rosarch("analyze", "facts").err == changed
    (workspace / "manifest.json").write_text("{}")
    assert rosarch("analyze", "ws").code == 0


@pytest.mark.parametrize(("out", "what"), [("ws", "with packages"), ("ws/talker", "in a package"), ("ws/talker/facts", "in a package")])
def test_facts_do_not_go_among_sources(rosarch: Callable, workspace: Path, out: str, what: str) -> None:
    outcome = rosarch("extract", "ws", "-o", out)
    assert (outcome.code, outcome.err) == (2, f"rosarch: error: {out}: a folder {what}; choose another one for the facts\n")


@pytest.mark.slow
def test_rules_that_never_end(rosarch: Callable, workspace: Path, tmp_path: Path, limits: Limits) -> None:
    (tmp_path / "own.dl").write_text(".decl n(x: number)\n.output n\nn(0).\nn(X + 1) :- n(X).\n")
    assert rosarch("extract", "ws", "-o", "facts").code == 0
    outcome = rosarch("rules", "run", "facts", "own.dl", "--timeout", "0.2")
    assert outcome.code == 2
    assert "still running after 1 s" in outcome.err
    assert limits.evaluation == 1.0


def test_the_memory_of_workers(rosarch: Callable, workspace: Path, limits: Limits) -> None:
    assert rosarch("--memory", 3000, "analyze", "ws").code == 0
    assert limits.memory == 3000 << 20


@pytest.mark.parametrize("text", ["<package", "<package><name>talker</name>"])
def test_one_broken_manifest_is_an_error_whatever_is_guessed(rosarch: Callable, workspace: Path, text: str) -> None:
    (workspace / "talker" / "package.xml").write_text(text)
    outcome = rosarch("analyze", "ws")
    assert (outcome.code, outcome.out, outcome.err.partition("broken XML")[0]) == (
        2,
        "",
        f"rosarch: error: ws/talker/package.xml:1:{outcome.err.split(':')[4]}: ",
    )


@pytest.mark.slow
@pytest.mark.parametrize("command", [("analyze", "ws"), ("query", "ws", "port(P)")])
def test_souffle_is_looked_for_first(rosarch: Callable, workspace: Path, monkeypatch: pytest.MonkeyPatch, command: tuple[str, ...]) -> None:
    monkeypatch.setenv("PATH", "")
    outcome = rosarch(*command, "--engine", "souffle")
    text = "rosarch: error: --engine souffle: there is no `souffle` on PATH; the embedded engine needs no installation\n"
    assert (outcome.code, outcome.err) == (2, text)
