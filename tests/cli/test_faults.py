"""What is wrong around a run: a clear message, and a correct result or none."""

from __future__ import annotations

import os
import shutil
import signal
import subprocess
import sys
import time
from collections.abc import Callable
from pathlib import Path

import pytest

from rosarch.base import scratch
from rosarch.base.scratch import PREFIX, remove_abandoned, scratch_folder

ROOT = Path(__file__).resolve().parents[2]


@pytest.fixture
def temporary(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    """A folder for temporary files."""
    folder = tmp_path / "temporary"
    folder.mkdir()
    monkeypatch.setattr(scratch.tempfile, "tempdir", str(folder))
    return folder


def test_folders_of_killed_runs_are_removed_and_no_others(temporary: Path) -> None:
    holding = (
        "from rosarch.base.scratch import scratch_folder\nimport time\n"
        "with scratch_folder() as folder:\n    (folder / 'file').touch()\n    print(folder, flush=True)\n    time.sleep(60)\n"
    )
    process = subprocess.Popen(
        [sys.executable, "-c", holding], stdout=subprocess.PIPE, text=True, env={**os.environ, "TMPDIR": str(temporary)}
    )
    assert process.stdout
    theirs = Path(process.stdout.readline().strip())
    (temporary / "rosarch-other").mkdir()
    (temporary / f"{PREFIX}link").symlink_to(temporary / "rosarch-other")
    with scratch_folder() as ours:
        assert ours.parent == theirs.parent == temporary
        remove_abandoned()
        assert ours.is_dir()
        assert (theirs / "file").is_file()
        process.kill()
        process.wait()
        remove_abandoned()
        assert ours.is_dir()
        assert not theirs.exists()
    assert sorted(path.name for path in temporary.iterdir()) == ["rosarch-other", f"{PREFIX}link"]


def test_a_signal_during_the_removal_of_a_folder_leaves_nothing(temporary: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    rmdir, ended = os.rmdir, []

    def end_once(*arguments: object, **options: object) -> None:
        if not ended:
            ended.append(True)
            signal.raise_signal(signal.SIGTERM)
        rmdir(*arguments, **options)  # type: ignore[arg-type]

    before = signal.signal(signal.SIGTERM, lambda number, _frame: sys.exit(128 + number))
    try:
        with pytest.raises(SystemExit), scratch_folder() as folder:
            (folder / "below").mkdir()
            monkeypatch.setattr(os, "rmdir", end_once)
    finally:
        signal.signal(signal.SIGTERM, before)
    assert (ended, list(temporary.iterdir())) == ([True], [])


@pytest.mark.parametrize(
    ("version", "message"),
    [
        ("Version: 2.3", "is souffle 2.3; 2.4 or newer is needed"),
        ("Souffle: 1.7.1\nVersion: 1.7.1\nCopyright", "is souffle 1.7; 2.4 or newer is needed"),
        ("", "does not tell its version, as souffle does"),
        ("\\0\\377", "does not tell its version, as souffle does"),
    ],
)
def test_an_older_souffle_or_another_program(
    rosarch: Callable, workspace: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch, version: str, message: str
) -> None:
    binary = tmp_path / "bin" / "souffle"
    binary.parent.mkdir()
    binary.write_text(f"#!/bin/sh\necho '{version}'\n")
    binary.chmod(0o755)
    monkeypatch.setenv("PATH", f"{binary.parent}:/bin:/usr/bin")
    done = rosarch("analyze", workspace, "--engine", "souffle")
    assert (done.code, done.out, done.err) == (2, "", f"rosarch: error: --engine souffle: {binary}{':' * ('does' in message)} {message}\n")


@pytest.mark.slow
def test_a_souffle_that_fails_on_everything(rosarch: Callable, workspace: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    binary = tmp_path / "bin" / "souffle"
    binary.parent.mkdir()
    binary.write_text('#!/bin/sh\n[ "$1" = --version ] && echo "Version: 2.5" && exit\necho no more >&2\nexit 3\n')
    binary.chmod(0o755)
    (workspace / "talker" / "t.launch").write_text('<launch><node name="t" pkg="talker" type="talker"/></launch>\n')
    monkeypatch.setenv("PATH", f"{binary.parent}:/bin:/usr/bin")
    for words in (("analyze",), ("check",), ("check", "--no-cache")):
        done = rosarch(words[0], workspace, "--engine", "souffle", *words[1:])
        assert (done.code, done.out) == (2, ""), words
        assert "talker/talker not analysed: error (DatalogError: souffle failed with exit code 3: no more, in souffle.py:" in done.err


@pytest.mark.slow
def test_a_library_that_lacks_a_function_or_is_gone(workspace: Path, tmp_path: Path) -> None:
    native = tmp_path / "path" / "clang" / "native"
    native.mkdir(parents=True)
    for folder in (native, native.parent):
        (folder / "__init__.py").touch()
    command = [sys.executable, "-m", "rosarch.cli", "analyze", str(workspace)]
    environment = {**os.environ, "PYTHONPATH": str(native.parents[1])}
    done = subprocess.run(command, env=environment, capture_output=True, text=True, check=False)
    hint = "(a part of the installation is missing or too old)"
    assert (done.returncode, done.stdout, done.stderr) == (2, "", f"rosarch: error: {native}: there is no libclang here {hint}\n")
    library = native / "libclang.so"
    library.write_bytes(b"no library")
    done = subprocess.run(command, env=environment, capture_output=True, text=True, check=False)
    assert done.returncode == 2
    assert done.stderr.startswith(f"rosarch: error: {library}: cannot be loaded (")
    shutil.copy(next(Path("/lib").glob("*-linux-gnu/libm.so.6"), Path("/lib/libm.so.6")), library)
    done = subprocess.run(command, env=environment, capture_output=True, text=True, check=False)
    assert (done.returncode, done.stderr) == (2, f"rosarch: error: {library}: this libclang has no clang_getCString {hint}\n")


@pytest.mark.slow
def test_a_cache_without_room(rosarch: Callable, workspace: Path, tmp_path: Path) -> None:
    """A limit of the size of files stands for a full disk below the cache: what cannot be kept is not."""
    expected = rosarch("analyze", workspace, "--no-cache", "--format", "json").out
    limited = "import resource, sys; resource.setrlimit(resource.RLIMIT_FSIZE, (100_000, 100_000)); import signal; signal.signal(signal.SIGXFSZ, signal.SIG_IGN)\n"
    code = f"{limited}from rosarch.cli.main import main; sys.exit(main(['analyze', {str(workspace)!r}, '--format', 'json']))"
    done = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=False)
    assert (done.returncode, done.stdout) in ((0, expected), (2, ""))
    if done.returncode:
        assert done.stderr.splitlines()[-1].startswith("rosarch: error: ")  # clang may have said something before


@pytest.mark.slow
@pytest.mark.parametrize("words", [("analyze",), ("extract",), ("extract", "--text")])
def test_outputs_without_room(rosarch: Callable, workspace: Path, tmp_path: Path, words: tuple[str, ...]) -> None:
    """A limit of the size of files, from when they are written, stands for a full disk below them."""
    code = (
        "import resource, signal, sys; from rosarch.cli.main import main; from rosarch.base import whole; from rosarch.extractor import facts_text\n"
        "signal.signal(signal.SIGXFSZ, signal.SIG_IGN); write = whole._missing\n"
        "def limited(folder):\n    resource.setrlimit(resource.RLIMIT_FSIZE, (150, 150))\n    return write(folder)\n"
        f"whole._missing = lambda folder: (limited if 'out' in folder.parts else write)(folder)\n"
        f"sys.exit(main({[words[0], str(workspace), *words[1:], '-o', 'out/deep']!r}))"
    )
    done = subprocess.run([sys.executable, "-c", code], cwd=tmp_path, capture_output=True, text=True, check=False)
    assert (done.returncode, done.stdout) == (2, "")
    assert done.stderr.startswith("rosarch: error: out/deep")
    assert done.stderr.endswith(": cannot write (file too large)\n")
    assert not (tmp_path / "out").exists()


def test_an_analysis_that_fails_leaves_no_output_folder(rosarch: Callable, tmp_path: Path) -> None:
    (tmp_path / "empty").mkdir()
    for words in (("analyze",), ("extract",), ("extract", "--text")):
        assert rosarch(words[0], "empty", *words[1:], "-o", tmp_path / "out" / "deep").code == 2
        assert not (tmp_path / "out").exists()


@pytest.mark.slow
def test_a_cache_that_is_damaged_no_folder_or_out_of_reach(
    rosarch: Callable, workspace: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    (workspace / "talker" / "t.launch").write_text('<launch><node name="t" pkg="talker" type="talker"/></launch>\n')
    cache = tmp_path / "cache"
    monkeypatch.setenv("ROSARCH_CACHE_DIR", str(cache))
    expected = rosarch("check", workspace, "--format", "json")
    assert expected.code in (0, 1)
    entries = [path for path in cache.rglob("*") if path.is_file()]
    assert {path.relative_to(cache).parts[0] for path in entries} >= {"units"}
    damages: list[Callable[[bytes], bytes]] = [
        lambda data: b"", lambda data: data[: len(data) // 2], lambda data: data[:-1] + bytes([data[-1] ^ 1]), lambda data: b"\x80\x04N.",
    ]  # fmt: skip
    for damage in damages:
        for path in entries:
            if path.is_file() and path.stat().st_size:
                path.write_bytes(damage(path.read_bytes()))
        assert rosarch("check", workspace, "--format", "json") == expected
    shutil.rmtree(cache)
    cache.write_text("a file where the folder should be")
    assert rosarch("check", workspace, "--format", "json") == expected
    monkeypatch.setenv("ROSARCH_CACHE_DIR", str(tmp_path / ("x" * 300)))  # to ask for it fails, as if it were another user's
    assert rosarch("check", workspace, "--format", "json") == expected


@pytest.mark.slow
@pytest.mark.parametrize("after", [0.0, 0.2])
def test_serve_ends_with_one_line(workspace: Path, after: float) -> None:
    command = [sys.executable, "-m", "rosarch.cli", "serve", str(workspace), "--port", "0"]
    process = subprocess.Popen(
        command, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True, start_new_session=True,
        preexec_fn=lambda: signal.signal(signal.SIGINT, signal.SIG_DFL),  # what is started in the background may ignore it
    )  # fmt: skip
    assert process.stdout
    assert process.stdout.readline().startswith("http://127.0.0.1:")
    time.sleep(after)  # into the first analysis
    os.killpg(process.pid, signal.SIGINT)
    _, errors = process.communicate(timeout=30)
    assert process.returncode in (130, -signal.SIGINT)  # see test_check_input.py on the latter
    assert errors == "rosarch: interrupted\n"
    until = time.monotonic() + 10
    with pytest.raises(ProcessLookupError):
        while time.monotonic() < until:
            os.killpg(process.pid, 0)
            time.sleep(0.05)


@pytest.mark.slow
def test_runs_that_are_ended_at_random_are_no_harm(tmp_path: Path) -> None:
    """The benchmark, in small."""
    program = [
        sys.executable,
        str(ROOT / "benchmarks" / "kills.py"),
        str(ROOT / "examples" / "nodelet_filter"),
        "--seed",
        str(time.time_ns()),
    ]
    done = subprocess.run([*program, "--kills", "2", "--command", "analyze"], capture_output=True, text=True, check=False)
    assert (done.returncode, done.stderr) == (0, ""), done.stdout
    assert done.stdout.endswith("0 wrong\n")
