"""`rosarch diff`: folders and revisions."""

from __future__ import annotations

import json
import os
import subprocess
from collections.abc import Callable
from pathlib import Path

import pytest
from systems import small

from rosarch.analysis.comparison import Snapshot
from rosarch.base.git_revisions import LARGEST_FILE, export, resolve
from rosarch.cli.commands.diff import DiffFormat, State, compare_states

CHANGED = """\
talker/talker
  > port  publisher chatter  name chatter -> chat, queue 10 -> 1  {path}talker/talker.cpp:8

1 difference: 1 renamed
"""


@pytest.fixture(autouse=True)
def here(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.chdir(tmp_path)


def git(folder: Path, *arguments: str) -> str:
    command = ["git", "-C", str(folder), "-c", "user.name=n", "-c", "user.email=e@example.com", "-c", "commit.gpgsign=false", *arguments]
    return subprocess.run(command, check=True, capture_output=True, text=True).stdout.strip()


def commit(folder: Path) -> str:
    git(folder, "add", "-A")
    git(folder, "commit", "-q", "--allow-empty", "-m", "m")
    return git(folder, "rev-parse", "HEAD")


def change(workspace: Path) -> None:
    source = workspace / "talker/talker.cpp"
    source.write_text(source.read_text().replace('("chatter", 10)', '("chat", 1)'))


@pytest.fixture
def repository(workspace: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    """A repository of two commits, the second of which is changed."""
    git(workspace, "init", "-q")
    commit(workspace)
    change(workspace)
    commit(workspace)
    monkeypatch.chdir(workspace)
    return workspace


@pytest.mark.slow
def test_folders(rosarch: Callable, workspace: Path, tmp_path: Path) -> None:
    subprocess.run(["cp", "-r", "ws", "old"], check=True)
    assert rosarch("diff", "old", "ws").out == "no differences\n"
    change(workspace)
    outcome = rosarch("diff", "old", "ws")
    assert (outcome.code, outcome.out, outcome.err) == (1, CHANGED.format(path=""), "")


@pytest.mark.slow
def test_revisions(rosarch: Callable, repository: Path) -> None:
    outcome = rosarch("diff", "HEAD~1", "HEAD")
    assert (outcome.code, outcome.out, outcome.err) == (1, CHANGED.format(path=""), "")
    outcome = rosarch("diff", "HEAD", "HEAD")
    assert (outcome.code, outcome.out) == (0, "no differences\n")


def test_a_revision_and_what_is_in_the_folder(rosarch: Callable, repository: Path) -> None:
    assert rosarch("diff", "HEAD", ".").out == "no differences\n"
    assert rosarch("diff", "HEAD~1", ".").code == 1


def test_formats(rosarch: Callable, repository: Path) -> None:
    data = json.loads(rosarch("diff", "HEAD~1", "HEAD", "--format", "json").out)
    assert data["summary"]["renamed"] == 1
    assert "| renamed | port | publisher chatter |" in rosarch("diff", "HEAD~1", "HEAD", "--format", "markdown").out


def test_a_bare_repository(rosarch: Callable, repository: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    git(tmp_path, "clone", "-q", "--bare", str(repository), "bare")
    monkeypatch.chdir(tmp_path / "bare")
    assert rosarch("diff", "HEAD~1", "HEAD").out == CHANGED.format(path="")


@pytest.mark.parametrize(
    ("sides", "message"),
    [
        (("HEAD", "nowhere"), "nowhere: no such folder, and no such revision of the git repository here"),
        (("--", "HEAD", "-x"), "-x: no such folder, and no such revision of the git repository here"),
        (("talker/talker.cpp", "HEAD"), "talker/talker.cpp: not a folder, and no such revision of the git repository here"),
        (("HEAD", "HEAD:talker"), "HEAD:talker: no such folder, and no such revision of the git repository here"),
    ],
)
def test_what_is_neither(rosarch: Callable, repository: Path, sides: tuple[str, ...], message: str) -> None:
    outcome = rosarch("diff", *sides)
    assert (outcome.code, outcome.out, outcome.err) == (2, "", f"rosarch: error: {message}\n")


def test_no_repository(rosarch: Callable, workspace: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("GIT_CEILING_DIRECTORIES", str(workspace.parent.parent))
    assert rosarch("diff", "ws", "HEAD").err == (
        "rosarch: error: HEAD: no such folder, and no git repository here that could have a revision of this name\n"
    )


def test_no_git(rosarch: Callable, workspace: Path, monkeypatch: pytest.MonkeyPatch, tmp_path: Path) -> None:
    monkeypatch.setenv("PATH", str(tmp_path))
    assert (
        rosarch("diff", "ws", "HEAD").err
        == "rosarch: error: revisions need git, which is not on PATH; two folders can be compared without it\n"
    )


def files(folder: Path) -> dict[str, bytes | str]:
    found: dict[str, bytes | str] = {}
    for path in sorted(folder.rglob("*")):
        if path.is_symlink():
            found[str(path.relative_to(folder))] = f"-> {os.readlink(path)}"
        elif path.is_file():
            found[str(path.relative_to(folder))] = path.read_bytes()
    return found


def test_what_is_written(tmp_path: Path) -> None:
    source = tmp_path / "source"
    source.mkdir()
    git(source, "init", "-q")
    (source / "in").mkdir()
    (source / "in/a b\n\u00e9.txt").write_bytes(b"\r\n\0x")
    (source / "large").write_bytes(b"x" * (LARGEST_FILE + 1))
    (source / "empty").write_bytes(b"")
    for link, target in (("good", "in"), ("out", "/etc"), ("up", "in/../../x"), ("loop", "loop"), ("far", "out/passwd")):
        (source / link).symlink_to(target)
    made = export(commit(source), source, tmp_path / "made")
    assert files(tmp_path / "made") == {"in/a b\n\u00e9.txt": b"\r\n\0x", "large": b"", "empty": b"", "good": "-> in", "loop": "-> loop"}
    assert (made.refused, made.missing, made.submodules) == (("far", "out", "up"), (), ())


def test_submodules_and_missing_files_are_told(rosarch: Callable, repository: Path) -> None:
    blob = git(repository, "rev-parse", "HEAD:talker/package.xml")
    (repository / "extra.txt").write_text("extra")
    git(repository, "add", "extra.txt")
    git(repository, "update-index", "--add", "--cacheinfo", f"160000,{git(repository, 'rev-parse', 'HEAD')},external/sub")
    git(repository, "commit", "-q", "-m", "m")
    extra = git(repository, "rev-parse", "HEAD:extra.txt")
    (repository / ".git/objects" / extra[:2] / extra[2:]).unlink()
    outcome = rosarch("diff", "HEAD~1", "HEAD")
    assert (outcome.code, outcome.out) == (0, "no differences\n")
    assert outcome.err == (
        "rosarch: HEAD: not read: submodule: external/sub\nrosarch: HEAD: not read: file that this repository does not have: extra.txt\n"
    )
    assert blob


def tree(folder: Path, entries: dict[str, tuple[str, str]]) -> str:
    """A tree object with names that git itself would not make."""
    data = b"".join(f"{mode} {name}".encode() + b"\0" + bytes.fromhex(id_) for name, (mode, id_) in entries.items())
    command = ["git", "-C", str(folder), "hash-object", "-t", "tree", "-w", "--literally", "--stdin"]
    return subprocess.run(command, input=data, check=True, capture_output=True).stdout.decode().strip()


def test_paths_that_lead_out(tmp_path: Path) -> None:
    git(tmp_path, "init", "-q", "repo")
    repo = tmp_path / "repo"
    (repo / "target").write_text("..")
    link = git(repo, "hash-object", "-w", "target")
    inner = tree(repo, {"evil.txt": ("100644", link)})
    top = tree(repo, {"..": ("40000", inner), "door": ("120000", link)})
    behind = tree(repo, {"door": ("40000", inner), "x": ("40000", top)})
    made = export(git(repo, "commit-tree", "-m", "m", behind), repo, tmp_path / "out/made")
    assert made.refused == ("x/../evil.txt",)
    assert files(tmp_path / "out") == {"made/door/evil.txt": b"..", "made/x/door": "-> .."}


def test_nothing_of_the_repository_runs(repository: Path, tmp_path: Path) -> None:
    """Hooks, filters, conversions, monitors, pagers, aliases, and the helper that would fetch what is missing."""
    trap = tmp_path / "trap"
    trap.write_text(f"#!/bin/sh\necho ran >> {tmp_path}/ran\n")
    trap.chmod(0o755)
    (repository / ".gitattributes").write_text("* filter=trap diff=trap text eol=crlf export-subst ident\n")
    (repository / "gone.txt").write_text("gone")
    last = commit(repository)
    for hook in ("post-checkout", "pre-auto-gc", "post-index-change", "reference-transaction"):
        (repository / ".git/hooks" / hook).symlink_to(trap)
    settings = {
        "filter.trap.smudge": trap, "filter.trap.process": trap, "diff.trap.textconv": trap, "diff.trap.command": trap, "diff.external": trap,
        "core.fsmonitor": trap, "core.pager": trap, "core.sshCommand": trap, "core.editor": trap, "core.alternateRefsCommand": trap,
        "alias.cat-file": f"!{trap}", "alias.ls-tree": f"!{trap}", "core.autocrlf": "true",
        "core.repositoryformatversion": "1", "extensions.partialClone": "origin", "remote.origin.url": f"ext::{trap}",
        "remote.origin.promisor": "true", "remote.origin.uploadpack": trap, "protocol.ext.allow": "always", "protocol.allow": "always",
    }  # fmt: skip
    gone = git(repository, "rev-parse", f"{last}:gone.txt")
    for key, value in settings.items():
        git(repository, "config", key, str(value))
    (repository / ".git/objects" / gone[:2] / gone[2:]).unlink()
    (tmp_path / "ran").unlink(missing_ok=True)
    made = export(resolve("HEAD", repository), repository, tmp_path / "made")
    assert made.missing == ("gone.txt",)
    assert (tmp_path / "made/talker/talker.cpp").read_bytes() == (repository / "talker/talker.cpp").read_bytes()
    assert not (tmp_path / "ran").exists()


def test_systems_are_compared_too(workspace: Path, capsys: pytest.CaptureFixture[str]) -> None:
    loaded: list[Path] = []

    def load(state: State) -> Snapshot:
        loaded.append(state.folder)
        return Snapshot((), (small(),))

    compare_states("ws", "ws", DiffFormat.text, load)
    assert (capsys.readouterr().out, loaded) == ("no differences\n", [Path("ws"), Path("ws")])
