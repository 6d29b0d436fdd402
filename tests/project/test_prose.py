"""The words that users read follow the list of `docs/style.md`, which is read here: a word of its second column must not occur.

Scope: README, CONTRIBUTING, the documentation, the README files of examples, rules and benchmarks, all that is written for users at the head
of a check or in the help of a command, and the docstrings and comments of the sources but for tests. Code, quoted output and what is in
quotation marks are no prose.
"""

from __future__ import annotations

import io
import re
import tokenize
from collections import defaultdict
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import pytest
import typer

from rosarch.cli.main import app

ROOT = Path(__file__).resolve().parents[2]
STYLE = (ROOT / "docs/style.md").read_text(encoding="utf-8")
PAGES = [
    ROOT / "README.md",
    ROOT / "CONTRIBUTING.md",
    ROOT / "examples/README.md",
    ROOT / "rules/README.md",
    ROOT / "benchmarks/README.md",
    *(path for path in sorted((ROOT / "docs").glob("*.md")) if path.name != "check-reference.md"),  # made of the heads of checks
]
CHECKS = sorted((ROOT / "rules/checks").glob("*.dl"))
EXEMPT = {"tests", "build", "stubs", "known"}  # folders; stubs and known functions follow the texts of the libraries that they describe
MODULES = [path for path in ROOT.glob("[!.]*/**/*.py") if EXEMPT.isdisjoint(path.relative_to(ROOT).parts)]
RULES = sorted((ROOT / "rules").glob("**/*.dl"))
HEAD = re.compile(r"\A(?://.*\n)+")
COMMENT = re.compile(r"^(?:[^\"/\n]|\"(?:[^\"\\\n]|\\.)*\"|/(?!/))*//+(.*)")
CODE = re.compile(r"^ *```.*?^ *```$|`[^`\n]*`|\"[^\"\n]*\"|<[^>\n]*>|\]\([^)]*\)", re.MULTILINE | re.DOTALL)
FIELD = re.compile(r"^// (title|help|description|recommendation|message):((?:.*)(?:\n// \|.*)*)", re.MULTILINE)
LINK = re.compile(r"https?://\S+")


def words() -> list[tuple[str, re.Pattern[str]]]:
    """What to write, and what not: the rows of the word list."""
    table = STYLE.partition("## Word list")[2]
    rows = re.findall(r"^\| (.*?) \| ((?:`[^`]+`(?:, )?)+) \| .* \|$", table, re.MULTILINE)
    return [
        (better, re.compile(rf"\b(?:{each})(?!\w)".replace(r"\|", "|"), re.IGNORECASE))
        for better, worse in rows
        for each in re.findall(r"`([^`]+)`", worse)
    ]


WORDS = words()


def lapses(text: str) -> list[str]:
    """What of a text is on the list, with what to write instead."""
    prose = LINK.sub("", CODE.sub(lambda code: "\n" * code[0].count("\n"), text))
    return [
        f"line {prose.count(chr(10), 0, found.start()) + 1}: `{found[0]}`, better: {better}"
        for better, worse in WORDS
        for found in worse.finditer(prose)
    ]


def written_in_module(text: str) -> str:
    """The comments and docstrings of a module, each line where it is in the module."""
    lines: dict[int, str] = defaultdict(str)
    begins = True
    for token in tokenize.generate_tokens(io.StringIO(text).readline):
        if token.type == tokenize.COMMENT:
            lines[token.start[0]] = token.string[1:]
        elif token.type == tokenize.STRING and begins:
            lines.update(enumerate(token.string.replace('"""', "").split("\n"), token.start[0]))
        if token.type not in (tokenize.COMMENT, tokenize.NL):
            begins = token.type in (tokenize.NEWLINE, tokenize.INDENT, tokenize.DEDENT)
    return "\n".join(lines[number] for number in range(1, max(lines, default=0) + 1))


def written_in_rules(text: str) -> str:
    """The comments of a file of rules, each line where it is in the file."""
    return "\n".join(found[1] if (found := COMMENT.match(line)) else "" for line in text.split("\n"))


def helps(command: Any, name: str) -> Iterator[tuple[str, str]]:
    """The help of a command, its options and its sub-commands."""
    yield name, command.help or ""
    for each in command.params:
        yield f"{name} {each.name}", getattr(each, "help", None) or ""
    if hasattr(command, "list_commands"):
        for inner in command.list_commands(None):
            yield f"{name} {inner}", command.summary(inner)
            yield from helps(command.get_command(None, inner), f"{name} {inner}")


def test_the_list_is_read() -> None:
    assert len(WORDS) > 30
    assert lapses("This page tells of it; nodes wait for ever.") == [
        "line 1: `tells`, better: reports, shows, lists, says, explains",
        "line 1: `for ever`, better: forever",
    ]
    assert lapses('`tells` is code, and "told" is quoted.') == []


@pytest.mark.parametrize("path", PAGES, ids=lambda path: path.relative_to(ROOT).as_posix())
def test_pages(path: Path) -> None:
    text = path.read_text(encoding="utf-8")
    assert lapses(text.partition("## Word list")[0] if path.name == "style.md" else text) == []


@pytest.mark.parametrize("path", CHECKS, ids=lambda path: path.stem)
def test_heads_of_checks(path: Path) -> None:
    for name, text in FIELD.findall(path.read_text(encoding="utf-8")):
        assert lapses(text.replace("\n// |", "")) == [], name


@pytest.mark.parametrize("path", CHECKS, ids=lambda path: path.stem)
def test_titles_are_short_phrases(path: Path) -> None:
    fields = dict(FIELD.findall(path.read_text(encoding="utf-8")))
    title = fields["title"].strip()
    assert len(title) <= 80
    assert not title.endswith(".")
    assert not re.match(r"(A|An|The|Something) ", title), title


def test_help_of_commands() -> None:
    found = {name: lapses(text) for name, text in helps(typer.main.get_command(app), "rosarch")}
    assert {name: each for name, each in found.items() if each} == {}


def test_what_is_written_in_a_module() -> None:
    text = '"""It tells\nall."""\n\nNAME = "told"  # told\n\n\ndef f(each=("a",\n    "told")) -> None:\n    # one\n    """Tells."""\n'
    assert written_in_module(text) == "It tells\nall.\n\n told\n\n\n\n\n one\nTells."


def test_what_is_written_in_rules() -> None:
    assert written_in_rules('/// Told.\na("//told"). // tells\nb(4 / 2).') == " Told.\n tells\n"


def test_comments_of_modules() -> None:
    assert len(MODULES) > 400
    found = {path.relative_to(ROOT).as_posix(): lapses(written_in_module(path.read_text(encoding="utf-8"))) for path in MODULES}
    assert {name: each for name, each in found.items() if each} == {}


def test_comments_of_rules() -> None:
    assert len(RULES) > 300
    found = {}
    for path in RULES:
        text = path.read_text(encoding="utf-8")
        if path in CHECKS:  # their heads have fields, see above
            text = HEAD.sub(lambda head: "\n" * head[0].count("\n"), text)
        found[path.relative_to(ROOT).as_posix()] = lapses(written_in_rules(text))
    assert {name: each for name, each in found.items() if each} == {}
