"""What README and docs show is so: commands run and print what stands there; sub-commands, options, checks and variants that are named exist.

Every document is a session in an empty folder with the examples. In order: a block of another language than a shell's is written to the file that the text
before it names last; a `console` block is run, and its output compared; a line of an `sh` block is run when the folder or file it is about is there.
"""

from __future__ import annotations

import json
import pkgutil
import re
import shlex
import shutil
import subprocess
from collections.abc import Callable, Iterator
from functools import cache
from pathlib import Path
from typing import Any

import pytest
import typer

from rosarch.cli.main import app
from rosarch.models.machine.build import build_machine
from rosarch.reports.behavior_text import behaviors_text
from rosarch.reports.machines import machines_text

ROOT = Path(__file__).resolve().parents[2]
DOCUMENTS = {
    path.relative_to(ROOT).as_posix(): path.read_text(encoding="utf-8")
    for path in (
        ROOT / "README.md",
        ROOT / "CONTRIBUTING.md",
        ROOT / "examples/README.md",
        ROOT / "rules/README.md",
        *sorted((ROOT / "docs").glob("*.md")),
    )
}
BLOCK = re.compile(r"^```(\w*)\n(.*?)^```$", re.MULTILINE | re.DOTALL)
FILE = re.compile(r"`([\w./-]+\.(?:dl|cpp|yml))`")
LEFT_OUT = "..."
NOT_ENDING = ("serve", "watch", "browse", "language-server")
FAULTS = re.compile(r"^\d+ findings?: \d+ (error|warning)|^FAILED|\((?!100)[\d.]+%\)$", re.MULTILINE)


def steps(text: str) -> Iterator[tuple[str, str, str]]:
    """What a reader does, in order: `write` a file with a content, `run` a command that prints something, `try` one whose output is not shown."""
    before = 0
    for block in BLOCK.finditer(text):
        if block[1] == "console":
            for part in re.split(r"^\$ ", block[2], flags=re.MULTILINE)[1:]:
                command, _, printed = part.partition("\n")
                yield "run", command, printed
        elif block[1] == "sh":
            yield from (("try", line, "") for line in block[2].splitlines() if line.startswith("rosarch "))
        elif block[1] and (files := FILE.findall(text[before : block.start()])):
            yield "write", files[-1], block[2]
        before = block.end()


def pattern(shown: str) -> str:
    """What `...` leaves out may be anything: whole lines where it is one."""
    lines = [
        r"(?:.*\n)*" if line.strip() == LEFT_OUT else ".*".join(map(re.escape, line.split(LEFT_OUT))) + "\n" for line in shown.splitlines()
    ]
    return "".join(lines)


def settled(text: str) -> str:
    """A text without what differs from run to run: times, and the keys of configurations, which depend on where the workspace lies."""
    return re.sub(r"@[0-9a-f]{12}#", "@key#", re.sub(r"\d+\.\d s$", "N s", text, flags=re.MULTILINE))


@cache
def group() -> Any:
    return typer.main.get_command(app)


def parsed(words: list[str]) -> tuple[Any, list[str]]:
    """The sub-command that words name, and the words behind its name; an error when there is none."""
    command = group()
    while hasattr(command, "get_command") and words and not words[0].startswith("-"):
        found = command.get_command(None, words[0])
        assert found is not None, f"no sub-command {words[0]}"
        command, words = found, words[1:]
    return command, words


def options_of(command: Any) -> set[str]:
    return {"--help", "-h", "-"} | {name for each in command.params for name in (*each.opts, *each.secondary_opts) if name.startswith("-")}


@cache
def all_options() -> frozenset[str]:
    found: set[str] = set()
    waiting = [group()]
    while waiting:
        command = waiting.pop()
        found |= options_of(command)
        if hasattr(command, "list_commands"):
            waiting += [command.get_command(None, name) for name in command.list_commands(None)]
    return frozenset(found)


def is_there(line: str) -> bool:
    """Whether what a command is about exists, so that it can be run; and whether it ends, and what it needs is installed."""
    words = shlex.split(line, comments=True)[1:]
    command, rest = parsed(words)
    if words[0] in NOT_ENDING or (words[0] == "verify" and not (shutil.which("spin") and shutil.which("gcc"))):
        return False
    context = command.make_context("rosarch", list(rest), resilient_parsing=True)
    arguments = [each for each in command.params if each.param_type_name == "argument"]
    first = context.params.get(arguments[0].name) if arguments else None
    paths = [each for each in (first if isinstance(first, list | tuple) else [first]) if isinstance(each, Path)]
    return all(path.exists() and path != Path() for path in paths)


@pytest.mark.slow
@pytest.mark.parametrize("name", DOCUMENTS)
def test_what_is_shown_happens(name: str, rosarch: Callable[..., Any], tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.chdir(tmp_path)
    (tmp_path / "examples").symlink_to(ROOT / "examples")
    for kind, what, text in steps(DOCUMENTS[name]):
        if kind == "write":
            if not what.startswith("examples/"):
                (tmp_path / what).parent.mkdir(parents=True, exist_ok=True)
                (tmp_path / what).write_text(text, encoding="utf-8")
        elif kind == "run":
            done = rosarch(*shlex.split(what)[1:])
            assert re.fullmatch(pattern(settled(text)), settled(done.err + done.out)), (what, done.err + done.out)
            assert done.code == (2 if "rosarch: error: " in text else int(FAULTS.search(text) is not None)), what
        elif is_there(what):
            done = rosarch(*shlex.split(what, comments=True)[1:])
            doubt = what.startswith("rosarch verify ") and "violated" in done.out
            assert (done.code, done.err) == (int(doubt), ""), what


def spoken(text: str) -> Iterator[str]:
    """Every command line of a document: in blocks, and in the code of sentences."""
    for kind, what, _ in steps(text):
        if kind != "write":
            yield what
    yield from re.findall(r"`(rosarch [^`\n]+)`", BLOCK.sub("", text))


@pytest.mark.slow
@pytest.mark.parametrize("name", DOCUMENTS)
def test_sub_commands_and_options_exist(name: str) -> None:
    for line in spoken(DOCUMENTS[name]):
        words = shlex.split(line, comments=True)[1:]
        if words[:1] == ["--memory"]:
            words = words[2:]
        if words[:1] == ["COMMAND"]:
            words = []
        command, rest = parsed(words)
        for word in rest:
            if re.match(r"--?[A-Za-z]", word):
                assert word.partition("=")[0] in options_of(command), line
    for option in re.findall(r"`(--[a-z][\w-]*)", BLOCK.sub("", DOCUMENTS[name])):
        assert option in all_options() | OTHERS, option


OTHERS = {"--params-file", "--ros-args", "--atheris", "--inputs", "--bits", "--no-preprocessor", "--werror", "--limit-rows"}
"""Options of other programs that documents speak of: those of ROS, of `tests/fuzz/run.py` and of `python -m rosarch.datalog`."""


@pytest.mark.slow
def test_checks_that_are_named_exist(rosarch: Callable[..., Any]) -> None:
    ids = set(re.findall(r"^## (.*)$", rosarch("rules", "checks", "--format", "markdown").out, re.MULTILINE))
    for name, text in DOCUMENTS.items():
        if name == "docs/check-reference.md":
            continue  # made of the heads of checks, one of which shows such a mistake
        made = set(re.findall(r"rosarch new check ([\w-]+)", text)) | set(re.findall(r"^// id: ([\w-]+)", text, re.MULTILINE))
        named = {each for group in re.findall(r"ignore\[([^]]*)\]", text) for each in re.split(r",\s*", group)}
        named |= set(re.findall(r"--(?:error|warning|note|ignore) '?([a-z*][\w*-]*)", text))
        named |= set(re.findall(r"\[([a-z]+(?:-[a-z]+)+)\]$", text, re.MULTILINE))
        named |= set(re.findall(r"rosarch rules checks ([a-z][\w-]*)", text))
        named |= set(re.findall(r'^  "?([a-z*][\w*-]*)"?: (?:error|warning|note|ignore)$', text, re.MULTILINE))
        for each in named:
            assert any(re.fullmatch(each.replace("*", ".*"), known) for known in ids | made), (name, each)


def test_decisions_and_variants_that_are_named_exist(rosarch: Callable[..., Any]) -> None:
    listed = json.loads(rosarch("options", "--json").out)
    decisions = {each["name"]: {variant["name"] for variant in each["variants"]} for each in listed["decisions"]}
    options = {each["name"] for each in listed["options"]}
    for name, text in DOCUMENTS.items():
        made = set(re.findall(r'option_default\("([\w-]+)"', text))
        for decision, variant in re.findall(r"--variant ([a-z][\w-]*)=([\w-]+)", text):
            assert variant in decisions[decision] or "did you mean" in text, (name, variant)
        for decision, variant in re.findall(r"decisions: \{([\w-]+): ([\w-]+)\}", text):
            assert variant in decisions[decision], (name, variant)
        for option in re.findall(r"--option ([a-z][\w-]*)=", text):
            assert option in options | made, (name, option)
    table = re.findall(r"^\| (`[\w-]+`)? *\| ((?:`[\w-]+`(?:, )?)+) \|", DOCUMENTS["docs/variants.md"], re.MULTILINE)
    described: dict[str, set[str]] = {}
    last = ""
    for decision, variants in table:
        last = decision.strip("`") or last
        described.setdefault(last, set()).update(re.findall(r"`([\w-]+)`", variants))
    assert described == decisions


def slug(heading: str) -> str:
    """The anchor that GitHub makes of a heading; that of the site is the same."""
    plain = re.sub(r"\[([^]]*)\]\([^)]*\)", r"\1", heading)
    return re.sub(r"[^\w\- ]", "", plain.lower()).strip().replace(" ", "-")


def anchors(path: Path) -> set[str]:
    text = BLOCK.sub("", path.read_text(encoding="utf-8"))
    return {slug(heading) for heading in re.findall(r"^#+ (.*)$", text, re.MULTILINE)}


@pytest.mark.parametrize("name", [*DOCUMENTS, "benchmarks/README.md"])
def test_links_lead_somewhere(name: str) -> None:
    here = ROOT / name
    text = BLOCK.sub("", here.read_text(encoding="utf-8"))
    for target in re.findall(r"\]\((?!https?:)([^)]+)\)", text) + re.findall(r'(?:src|srcset)="([^"]+)"', text):
        path, _, anchor = target.partition("#")
        file = here.parent / path if path else here
        assert file.exists(), target
        assert not anchor or anchor in anchors(file), target


def test_every_page_is_in_the_index() -> None:
    index = DOCUMENTS["docs/index.md"]
    for name in DOCUMENTS:
        if name.startswith("docs/") and name != "docs/index.md":
            assert f"({name.removeprefix('docs/')}" in index, name


def test_the_readme_fits_on_three_screens() -> None:
    assert len(DOCUMENTS["README.md"].splitlines()) <= 150


def test_every_sub_command_is_in_the_table() -> None:
    table = "\n".join(re.findall(r"^\| `.*$", DOCUMENTS["docs/commands.md"], re.MULTILINE))
    for name in group().list_commands(None):
        assert f"`{name}`" in table, name


def test_machines_and_behavior_are_those_of_the_examples() -> None:
    expected = ROOT / "examples/docking_states/expected/auto_docking"
    docking, lamp = (json.loads((expected / f"{name}.json").read_text()) for name in ("docking", "dock_lamp"))
    shown = {command: text for name in ("README.md", "examples/README.md") for _, command, text in steps(DOCUMENTS[name])}
    assert shown["rosarch show machine examples/docking_states docking"] == machines_text([build_machine(docking)], "text")
    assert machines_text([build_machine(docking)], "mermaid") in DOCUMENTS["docs/machines.md"]
    assert shown["rosarch show behavior examples/docking_states dock_lamp"] == behaviors_text([lamp])


@pytest.mark.slow
def test_the_graph_is_that_of_the_example(rosarch: Callable[..., Any], examples: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.chdir(ROOT)
    text = DOCUMENTS["docs/graphs.md"]
    (command,) = re.findall(r"^(rosarch show graph .* --format mermaid)$", text, re.MULTILINE)
    assert [rosarch(*shlex.split(command)[1:]).out] == [block[2] for block in BLOCK.finditer(text) if block[1] == "mermaid"]


def test_make_targets_exist() -> None:
    makefile = (ROOT / "Makefile").read_text()
    named = {
        target
        for text in DOCUMENTS.values()
        for block in BLOCK.finditer(text)
        for target in re.findall(r"^make (\w+)", block[2], re.MULTILINE)
    }
    assert {"demo", "test", "docs"} <= named
    for target in named:
        assert re.search(rf"^{target}:", makefile, re.MULTILINE), target


def test_the_demo_is_what_the_readme_shows() -> None:
    demo = re.search(r"^demo:.*?/(rosarch .*?)$", (ROOT / "Makefile").read_text(), re.MULTILINE | re.DOTALL)
    assert demo is not None
    assert f"$ {demo[1]}\n" in DOCUMENTS["README.md"]


def test_examples_are_described() -> None:
    for path in (ROOT / "examples").glob("*/expected"):
        assert f"## {path.parent.name}" in DOCUMENTS["examples/README.md"]


def test_folders_are_named() -> None:
    tracked = subprocess.run(["git", "ls-files"], cwd=ROOT, check=True, capture_output=True, text=True).stdout.splitlines()
    for folder in {path.partition("/")[0] for path in tracked if "/" in path and not path.startswith(".")}:
        assert f"`{folder}/" in DOCUMENTS["CONTRIBUTING.md"], folder


@pytest.mark.parametrize("name", DOCUMENTS)
def test_paths_of_this_repository_exist(name: str) -> None:
    """What is written like a path below one of the folders is there, or below the document's own; `*` and `<id>` stand for any part."""
    folders = {path.name for path in ROOT.iterdir() if path.is_dir() and not path.name.startswith(".")} - {"build", "src"}
    for path in re.findall(r"`([a-z_]+/[\w./*<>-]*)`", BLOCK.sub("", DOCUMENTS[name])):
        if path.partition("/")[0] in folders:
            place = re.sub(r"<[^>]*>", "*", path).rstrip("/")
            assert any(ROOT.glob(place)) or any((ROOT / name).parent.glob(f"**/{place}")), path


@pytest.mark.parametrize("name", DOCUMENTS)
def test_python_that_is_named_exists(name: str) -> None:
    for dotted in re.findall(r"`(rosarch(?:\.\w+)+)", DOCUMENTS[name]):
        assert pkgutil.resolve_name(dotted), dotted
