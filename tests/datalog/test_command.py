"""`python -m rosarch.datalog`, with the options and the input and output parameters of souffle."""

from __future__ import annotations

import gzip
import io
import json
import sqlite3
import subprocess
import sys
from collections.abc import Callable
from pathlib import Path
from types import SimpleNamespace

import pytest

from rosarch.datalog.__main__ import main

Run = Callable[..., tuple[int, str, str]]
COPY = ".decl e(a: symbol, b: number)\n.input e{}\n.decl r(a: symbol, b: number)\n.output r{}\nr(x, y) :- e(x, y).\n"


@pytest.fixture
def run(tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capfd: pytest.CaptureFixture[str]) -> Run:
    """Run a program from its text in an empty folder: exit code, stdout, stderr."""
    monkeypatch.chdir(tmp_path)

    def command(source: str, *options: str) -> tuple[int, str, str]:
        Path("p.dl").write_text(source, encoding="utf-8")
        code = main(["p.dl", *options])
        out, err = capfd.readouterr()
        return code, out, err

    return command


def files() -> list[str]:
    return sorted(p.name for p in Path().iterdir() if p.name != "p.dl")


def test_facts_and_output_folders(run: Run) -> None:
    Path("in").mkdir()
    Path("in/e.facts").write_text("b\t2\na\t1\n")
    assert run(COPY.format("", ""), "-F", "in", "-D", "out") == (0, "", "")
    assert Path("out/r.csv").read_text() == "a\t1\nb\t2\n"


def test_everything_to_stdout(run: Run) -> None:
    Path("e.facts").write_text("a\t1\n")
    code, out, _ = run(COPY.format("", '(IO=file, filename="x", delimiter=";")') + ".printsize r\n.decl f()\n.output f\nf().\n", "-D-")
    assert code == 0
    assert out == (
        "---------------\nr\na;b\n===============\na;1\n===============\nr\t1\n---------------\nf\n\n===============\n()\n===============\n"
    )
    assert files() == ["e.facts"]


@pytest.mark.parametrize(
    ("parameters", "name", "text"),
    [
        ("", "e.facts", "a\t1\n"),
        ('(filename="x.tsv")', "x.tsv", "a\t1\n"),
        ('(IO=file, filename="x.csv", delimiter=",")', "x.csv", "a,1\n"),
        ('(filename="x", delimiter="::")', "x", "a::1\n"),
        ("(headers=true)", "e.facts", "name\tnumber\na\t1\n"),
        ('(columns="2:0")', "e.facts", "1\tx\ta\n"),
        ("", "e.facts", "a\t1\tmore than is declared\n"),
        ('(rfc4180=true, filename="x.csv")', "x.csv", '"a",1\n'),
        ("(IO=jsonfile)", "e.json", '[["a", 1]]'),
        ("(IO=jsonfile)", "e.json", '[{"b": 1, "a": "a"}]'),
    ],
)
def test_inputs(run: Run, parameters: str, name: str, text: str) -> None:
    Path(name).write_text(text)
    assert run(COPY.format(parameters, "")) == (0, "", "")
    assert Path("r.csv").read_text() == "a\t1\n"


def test_compressed_input(run: Run) -> None:
    Path("e.facts").write_bytes(gzip.compress(b"a\t1\n"))
    assert run(COPY.format("", "(compress=true)"))[0] == 0
    assert gzip.decompress(Path("r.csv.gz").read_bytes()) == b"a\t1\n"


@pytest.mark.parametrize(("io_name", "text"), [("stdin", "a\t1\nb\t2\n"), ("json", '[["a", 1], ["b", 2]]')])
def test_standard_input(run: Run, monkeypatch: pytest.MonkeyPatch, io_name: str, text: str) -> None:
    monkeypatch.setattr(sys, "stdin", SimpleNamespace(buffer=io.BytesIO(text.encode())))
    assert run(COPY.format(f"(IO={io_name})", ""))[0] == 0
    assert Path("r.csv").read_text() == "a\t1\nb\t2\n"


RECORDS = """.type P = [x: number, rest: P]
.decl r(s: symbol, p: P, f: float)
r("q\\"t", [1, [2, nil]], 0.5).
r("ü", nil, -1).
"""


@pytest.mark.parametrize(
    ("parameters", "name", "text"),
    [
        ("", "r.csv", 'q"t\t[1, [2, nil]]\t0.5\nü\tnil\t-1\n'),
        ('(headers=true, delimiter=",")', "r.csv", 's,p,f\nq"t,[1, [2, nil]],0.5\nü,nil,-1\n'),
        ('(headers=true, attributeNames="A B C")', "r.csv", 'A B C\nq"t\t[1, [2, nil]]\t0.5\nü\tnil\t-1\n'),
        ("(rfc4180=true)", "r.csv", '"q""t","[1, [2, nil]]",0.5\n"ü","nil",-1\n'),
        ("(IO=jsonfile)", "r.json", '[["q\\"t", [1, [2, null]], 0.5],\n["ü", null, -1]]\n'),
        (
            '(IO=jsonfile, format="object")',
            "r.json",
            '[{"s": "q\\"t", "p": {"x": 1, "rest": {"x": 2, "rest": null}}, "f": 0.5},\n{"s": "ü", "p": null, "f": -1}]\n',
        ),
    ],
)
def test_outputs(run: Run, parameters: str, name: str, text: str) -> None:
    assert run(RECORDS + f".output r{parameters}\n") == (0, "", "")
    assert Path(name).read_text(encoding="utf-8") == text


def test_json_round_trip(run: Run) -> None:
    for format_name in ("list", "object"):
        run(RECORDS + f'.output r(IO=jsonfile, format="{format_name}")\n')
        source = ".type P = [x: number, rest: P]\n.decl r(s: symbol, p: P, f: float)\n.input r(IO=jsonfile)\n.output r\n"
        assert run(source) == (0, "", "")
        assert Path("r.csv").read_text() == 'q"t\t[1, [2, nil]]\t0.5\nü\tnil\t-1\n'
        assert len(json.loads(Path("r.json").read_text())) == 2


def test_sqlite(run: Run) -> None:
    Path("e.facts").write_text("a\t1\nb\t1\n")
    parameters = '(IO=sqlite, filename="x.sqlite")'
    assert run(COPY.format("", parameters)) == (0, "", "")
    with sqlite3.connect("x.sqlite") as database:
        assert database.execute("SELECT a, b FROM r ORDER BY a").fetchall() == [("a", 1), ("b", 1)]
        assert database.execute("SELECT symbol FROM __SymbolTable ORDER BY id").fetchall() == [("a",), ("b",)]
    assert run(f".decl r(a: symbol, b: number)\n.input r{parameters}\n.printsize r\n") == (0, "r\t2\n", "")


@pytest.mark.parametrize(
    ("data", "message"),
    [
        (b"a\t1\nb\n", "e.facts:2: expected 2 columns, found 1"),
        (b"a\tx\n", "e.facts:1: column 2 (`b`): `x` is not a number"),
        (b"a\t1\nb\xff\t2\n", "e.facts:2: not UTF-8 text: byte 0xff"),
        (b"x" * 70_000_000, "e.facts:1: a line of more than 64 MiB"),
        (None, "p.dl:2:8: no such file: `e.facts`\n    .input e\n           ^"),
        (b"\x1f\x8bnothing", "e.facts: cannot read: Compressed file ended before the end-of-stream marker was reached"),
    ],
)
def test_bad_facts_leave_nothing_behind(run: Run, data: bytes | None, message: str) -> None:
    if data is not None:
        Path("e.facts").write_bytes(data)
    assert run(COPY.format("", ""), "-D", "out") == (2, "", message + "\n")
    assert files() == ([] if data is None else ["e.facts"])


def test_a_failing_output_leaves_nothing_behind(run: Run) -> None:
    source = RECORDS + ".output r\n.decl s(p: P)\n.output s(IO=sqlite)\ns(nil).\n"
    assert run(source) == (2, "", "`s.p` is of type `P`, which SQLite cannot hold\n")
    assert files() == []


@pytest.mark.parametrize(
    ("text", "message"),
    [
        ("[[1, 2]]", "e.json: row 1: `1` is not a value of `symbol`"),
        ('[["a"]]', "e.json: row 1: expected 2 values, found 1"),
        ('[{"a": "a", "c": 1}]', "e.json: row 1: unknown attribute `c`"),
        ('[["a", 1]', "e.json:1:10: not JSON: Expecting ',' delimiter"),
        ("[" * 100_000, "e.json: JSON that is nested too deeply"),
    ],
)
def test_bad_json(run: Run, text: str, message: str) -> None:
    Path("e.json").write_text(text)
    assert run(COPY.format("(IO=jsonfile)", "")) == (2, "", message + "\n")


@pytest.mark.parametrize(
    ("source", "message"),
    [
        (
            COPY.format("(IO=fil)", ""),
            "p.dl:2:8: `fil` is not a way to read facts, did you mean `file`?\n    .input e(IO=fil)\n           ^",
        ),
        (
            ".decl r(a: number)\n.output r(IO=tape)\n",
            "p.dl:2:9: `tape` is not a way to write rows, expected one of file, json, jsonfile, sqlite, stdout, stdoutprintsize\n"
            "    .output r(IO=tape)\n            ^",
        ),
        (
            ".decl r(a: number)\n.output r\nr(1).\nr(x + 1) :- r(x).\n",
            "p.dl:4:1: evaluation stopped, `r`: more than 1000 rows\n    r(x + 1) :- r(x).\n    ^",
        ),
        (
            ".decl r(a: number)\n.output r\nr(1 / x) :- x = range(0, 2).\n",
            "p.dl:3:1: division by zero\n    r(1 / x) :- x = range(0, 2).\n    ^",
        ),
    ],
)
def test_errors_have_a_place(run: Run, source: str, message: str) -> None:
    Path("e.facts").write_text("")
    assert run(source, "--limit-rows", "1000") == (2, "", message + "\n")


def test_time_limit_names_the_rule(run: Run) -> None:
    code, _, err = run('.decl r(a: symbol)\n.output r\nr("").\nr(cat(x, "a")) :- r(x).\n', "--time-limit", "0.2")
    assert (code, err.splitlines()[0]) == (2, "p.dl:4:1: evaluation stopped, `r`: still running after 0.2 s")


@pytest.mark.parametrize("limit", [("--time-limit", "0.3"), ("--limit-rows", "1000")])
def test_limits_hold_within_one_rule(run: Run, limit: tuple[str, str]) -> None:
    code, _, err = run(".decl r(a: number)\n.output r\nr(x) :- x = range(0, 2000000000).\n", *limit)
    assert (code, err.splitlines()[0].split(":")[:3]) == (2, ["p.dl", "3", "1"])


def test_missing_files_are_empty_without_warnings(run: Run) -> None:
    assert run(COPY.format("", ""), "-w") == (0, "", "")
    assert Path("r.csv").read_text() == ""


def test_warnings_can_be_errors(run: Run) -> None:
    source = ".decl e(a: number)\ne(1).\n.decl r()\n.output r\nr() :- e(x).\n"
    text = "variable `x` occurs only once, write `_` or `_x`\n    r() :- e(x).\n             ^\n"
    assert run(source) == (0, "", f"p.dl:5:10: warning: {text}")
    assert run(source, "-w") == (0, "", "")
    Path("r.csv").unlink()
    assert run(source, "--werror") == (2, "", f"p.dl:5:10: {text}")
    assert files() == []


def test_profile(run: Run) -> None:
    Path("e.facts").write_text("a\t1\n")
    assert run(COPY.format("", ""), "-p", "times.txt") == (0, "", "")
    assert Path("times.txt").read_text().splitlines()[2].split() == ["ms", "rows", "calls", "relation", "rule"]
    assert Path("r.csv").read_text() == "a\t1\n"


def test_wide_numbers(run: Run) -> None:
    source = ".decl r(a: number, u: unsigned, f: float)\n.output r\nr(2147483647 + 1, 0 - 1, 1 / 3).\n"
    assert run(source)[0] == 0
    assert Path("r.csv").read_text() == "-2147483648\t4294967295\t0.333333343\n"
    assert run(source, "--bits", "64")[0] == 0
    assert Path("r.csv").read_text() == "2147483648\t18446744073709551615\t0.33333333333333331\n"


def test_macros_and_include_folders(run: Run) -> None:
    Path("lib").mkdir()
    Path("lib/a.dl").write_text("#define TWICE(x) r(x). r(x + N)\n")
    Path("lib/b.dl").write_text(".decl r(a: number)\n.output r\n")
    source = '#include "a.dl"\n.include "b.dl"\n#ifdef EXTRA\nTWICE(1).\n#endif\n'
    assert run(source, "-I", "lib", "-M", "EXTRA N=40")[0] == 0
    assert Path("r.csv").read_text() == "1\n41\n"


def test_functors_from_a_file(run: Run) -> None:
    Path("f.py").write_text("def twice(x):\n    return 2 * x\n")
    source = ".functor twice(x: number): number\n.decl r(a: number)\n.output r\nr(@twice(21)).\n"
    assert run(source, "-l", "f.py") == (0, "", "")
    assert Path("r.csv").read_text() == "42\n"
    hint = "give one with `functors=` or `-l FILE.py`"
    assert run(source) == (2, "", f"p.dl:4:3: functor `@twice` has no Python function, {hint}\n    r(@twice(21)).\n      ^\n")


@pytest.mark.parametrize("options", [["-c"], ["-o", "x"], ["-g", "x.cpp"], ["-t", "explain"], ["--show", "initial-ast"]])
def test_options_without_a_meaning_are_refused(run: Run, options: list[str]) -> None:
    with pytest.raises(SystemExit) as stopped:
        run(".decl r()\n", *options)
    assert stopped.value.code == 2


def test_start_up_leaves_out_what_a_cached_program_does_without(run: Run) -> None:
    run(".decl r(a: number)\n.output r\nr(1).\n")
    probe = (
        "import sys; from rosarch.datalog.__main__ import main; main(['p.dl']); print([m for m in ('lark', 'pcpp') if m in sys.modules])"
    )
    assert subprocess.run([sys.executable, "-c", probe], capture_output=True, text=True, check=True).stdout == "[]\n"
