"""Bad and hostile launch files: one clear line each, nothing read that must not be, and nothing lost of the rest."""

from __future__ import annotations

import os
from collections.abc import Callable
from contextlib import AbstractContextManager
from pathlib import Path
from xml.sax.saxutils import escape

import pytest
from launch_builder import composed, params, problems

KEPT = '\n<node pkg="p" type="t" name="kept"/>'


def only_problem(folder: Path, content: str, **others: str | bytes) -> str:
    """The one problem of a file, whose other node is kept."""
    found = composed(folder, content + KEPT, **others)
    assert "kept" in [node.name for node in found.nodes]
    (problem,) = problems(found, folder)
    return problem


@pytest.mark.parametrize(
    ("content", "message"),
    [
        ('<node pkg="p" type="t"/>', "<node> has no attribute `name`"),
        ('<node pkg="p" type="t" name="n" respawn="yes"/>', "`yes` is not true or false, which `respawn` must be"),
        ('<node pkg="p" type="t" name="a/b"/>', "the name `a/b` of a node must not have a namespace; use `ns`"),
        ('<node pkg="p" type="t" name="kept"/>', "second"),
        ('<param name="p" value="1" type="float"/>', "unknown type `float`"),
        ('<param name="p" value="x" type="int"/>', "`x` is not an int"),
        ('<param name="p"/>', "<param> must have exactly one of value, textfile, binfile and command"),
        ('<param name="p" textfile="none.txt"/>', "no such file: none.txt"),
        ('<param name="p" command="echo \'a"/>', "command `echo 'a`: no closing quotation"),
        ('<param name="p" command="convert a"/>', "command `convert` is not run, what it prints is unknown"),
        ('<param name="p" command="xacro a"/>', "command `xacro` would fail: no such file: a"),
        ('<rosparam file="none.yaml"/>', "no such file: none.yaml"),
        ('<rosparam>\n a: [1\n b</rosparam>', "invalid YAML at main.launch:4:3: while parsing a flow sequence expected ',' or ']', but got '<stream end>'"),
        ('<rosparam>a: !x 1</rosparam>', "invalid YAML at main.launch:2:4: could not determine a constructor for the tag '!x'"),
        ('<rosparam>1</rosparam>', "YAML that is not a map needs an attribute `param`"),
        ('<rosparam>{1: 2}</rosparam>', "the key `1` in YAML is not a text, which a parameter's name must be"),
        ('<rosparam command="store"/>', "<rosparam> has no command `store`; it is load, dump or delete"),
        ('<remap from="a b" to="c"/>', "`a b` is no legal name to remap from"),
        ('<remap from="a" to=""/>', "from and to of a remapping must not be empty"),
        ('<group if="1" unless="1"/>', "<group> has both `if` and `unless`"),
        ('<group if="maybe"/>', "if: `maybe` is not a Boolean"),
        ('<group ns=""/>', "<group> has an empty `ns`"),
        ('<group ns="~a"/>', "cannot turn `~a` into a global name"),
        ('<arg name="a" default="1" value="2"/>', "argument `a` has both a value and a default"),
        ('<arg name="a" default="1"/><arg name="a" default="2"/>', "argument `a` has already been declared"),
        ('<param name="p" value="$(arg a)"/>', "argument `a` is not defined"),
        ('<param name="p" value="$(foo a)"/>', "unknown substitution command $(foo a), known are find, env, optenv, dirname, anon, arg"),
        ('<param name="p" value="$(arg $(arg a))"/>', "`$` within a substitution argument: $(arg $(arg a))"),
        ('<param name="p" value="$(eval 1 +)"/>', "$(eval 1 +): invalid syntax"),
        ('<param name="p" value="$(eval nothing)"/>', "$(eval nothing): name 'nothing' is not defined"),
        ('<param name="p" value="$(eval 1/0)"/>', "$(eval 1/0): ZeroDivisionError: division by zero"),
        ('<unknown/>', "<unknown> in <launch> is ignored"),
        ('<rename from="a" to="b"/>', "<rename> in <launch> is ignored"),
        ('<arg name="a" default="1"/><rosparam>p: $(arg a)</rosparam>', '`$(arg a)` is taken as it is written: <rosparam> has no subst_value="true"'),
        ('<node pkg="p" type="t" name="n" typ="x"/>', "<node> has no attribute `typ`, it is ignored"),
        ('<include file="none.launch"/>', "no such file: none.launch"),
        ('<machine name="m" address="a" ssh-port="x"/>', "`x` is not a port number"),
    ],
)  # fmt: skip
def test_one_line_each(tmp_path: Path, content: str, message: str) -> None:
    if message == "second":
        found = composed(tmp_path, content + KEPT)
        assert problems(found, tmp_path) == ["main.launch:3:1: a second node `/kept`, the first is at main.launch:2"]
        return
    place, _, text = only_problem(tmp_path, content).partition(": ")
    assert (place.split(":")[:2], text) == (["main.launch", "2"], message)


def test_yaml_file_error_has_its_position(tmp_path: Path) -> None:
    found = only_problem(tmp_path, '<rosparam file="$(find here)/p.yaml"/>', p_yaml="a: 1\nb:\n\t- 2\n")
    assert (
        found
        == "main.launch:2:1: invalid YAML at p.yaml:3:1: while scanning for the next token found character '\\t' that cannot start any token"
    )


def test_malformed_include_has_its_position(tmp_path: Path) -> None:
    found = only_problem(tmp_path, '<include file="$(find here)/o.launch"/>', o_launch='<launch>\n  <node pkg="a"\n</launch>')
    assert found == "o.launch:3:1: broken XML: not well-formed (invalid token)"


@pytest.mark.parametrize(
    ("document", "message"),
    [
        (b"", "main.launch:1:1: broken XML: no element found"),
        (b"<launch>\n<a>\n</launch>", "main.launch:3:3: broken XML: mismatched tag"),
        (b"<robot/>", "main.launch:1:1: root element is <robot>, not <launch>"),
        (b"<launch>\n <launch/></launch>", "main.launch:2:2: a second <launch> in this file"),
        (b'<launch><param name="\xff" value="1"/></launch>', "main.launch:1:22: broken XML: not well-formed (invalid token)"),
        (b'<?xml version="1.0" encoding="no-such"?><launch/>', "main.launch:1:1: broken XML: unknown encoding: no-such"),
        (b"<launch>" + b"<group>" * 200 + b"</group>" * 200 + b"</launch>", "main.launch:1:1052: elements nested more than 150 deep"),
        (b'<!DOCTYPE l [\n<!ENTITY a "aaaa">\n<!ENTITY b "&a;&a;">]><launch>&b;</launch>', "main.launch:2:12: entity `a` is declared here; entities are not expanded"),
        (b'<!DOCTYPE l [<!ENTITY x SYSTEM "file:///etc/passwd">]><launch>&x;</launch>', "main.launch:1:52: entity `x` is declared here; entities are not expanded"),
    ],
)  # fmt: skip
def test_documents_that_are_none(tmp_path: Path, document: bytes, message: str) -> None:
    found = composed(tmp_path, document)
    assert (found.nodes, problems(found, tmp_path)) == ((), [message])


def test_files_outside_the_package_path_are_not_read(tmp_path: Path) -> None:
    secret = tmp_path / "secret.txt"
    secret.write_text("secret")
    workspace = tmp_path / "workspace"
    workspace.mkdir()
    (workspace / "link").symlink_to(secret)
    found = composed(
        workspace,
        f"""<param name="a" textfile="{secret}"/><param name="b" textfile="$(find here)/../../secret.txt"/><param name="c" textfile="link"/>
        <param name="d" binfile="{secret}"/><param name="e" command="cat {secret}"/><rosparam param="f" file="{secret}"/><include file="{secret}"/>""",
    )
    assert "secret" not in [setting.value for setting in found.params]
    assert sorted(params(found)) == ["/a", "/b", "/c", "/d", "/e"]
    assert {problem.kind for problem in found.problems} == {"outside", "command"}
    assert found.refusal is None


def test_special_files_are_not_read(tmp_path: Path) -> None:
    (tmp_path / "here").mkdir()
    os.mkfifo(tmp_path / "here" / "fifo")
    found = only_problem(tmp_path, '<param name="a" textfile="$(find here)/fifo"/>')
    assert found == "main.launch:2:1: fifo is not a regular file"


@pytest.mark.parametrize(
    "expression",
    [
        "9**9**9", "'a'*10**9", "[0]*10**9", "1<<10**9", "factorial(10**7)", "'%999999999d' % 1", "'{:999999999}'.format('a')",
        "'{0.real}'.format(1)", "'{0[0]}'.format('a')", "[x for x in range(10**9)]", "'a'.ljust(10**9)", "open('/etc/passwd').read()",
        "(lambda: 1)()", "[1 for x in range(10000) for y in range(10000)]", "comb(10**6, 10**5)", "exec('1')", "getattr(1, 'real')",
        "'%*d' % (10**9, 1)", "('a'*100000).replace('a', 'b'*100000)", "-" * 5000 + "1", "' '.join(['a'*100000]*100000)", "eval('1')",
        "print(1)", "str.mro()", "(1).real",
    ],
)  # fmt: skip
def test_evaluations_that_are_not_made(tmp_path: Path, expression: str, at_most: Callable[[float], AbstractContextManager[None]]) -> None:
    with at_most(5):
        found = composed(tmp_path, f'<param name="p" value="$(eval {escape(expression)})"/>' + KEPT)
        assert params(found) == {"/p": f"$(eval {expression})"}
        assert [problem.kind for problem in found.problems] == ["eval-unsupported"]


BOMB = "a0: &a0 [x,x,x,x,x,x,x,x,x,x]\n" + "".join(f"a{i}: &a{i} [{','.join([f'*a{i - 1}'] * 10)}]\n" for i in range(1, 10))
MERGES = "a0: &a0 {x: 1}\n" + "".join(f"a{i}: &a{i} {{<<: [{','.join([f'*a{i - 1}'] * 10)}]}}\n" for i in range(1, 12))
MERGE_CHAIN = "a0: &a0 {x0: 1}\n" + "".join(f"a{i}: &a{i} {{<<: *a{i - 1}, x{i}: 1}}\n" for i in range(1, 2000))


@pytest.mark.parametrize(
    ("text", "message"),
    [
        (BOMB, "more than 1000000 values when aliases are unfolded"),
        (MERGE_CHAIN, "more than 100000 merged keys"),
        ("a: &a [*a]", "a value that contains itself"),
        ("a: &a {b: *a}", "a value that contains itself"),
        ("a: " + "[" * 20_000, "brackets nested more than 200 deep"),
        ("- " * 20_000, "nested too deeply"),
        ("a: !!python/object/apply:os.system [x]", "could not determine a constructor for the tag 'tag:yaml.org,2002:python/object/apply:os.system'"),
        ("a: rad(__import__)", "invalid radian expression: rad(__import__)"),
        (f"a: rad(1{'0' * 400})", f"invalid radian expression: rad(1{'0' * 400})"),
        ("a: !radians open('x')", "invalid radian expression: open('x')"),
    ],
    ids=range(10),
)  # fmt: skip
def test_yaml_bombs(tmp_path: Path, text: str, message: str, at_most: Callable[[float], AbstractContextManager[None]]) -> None:
    with at_most(20):
        assert only_problem(tmp_path, '<rosparam file="$(find here)/p.yaml"/>', p_yaml=text).endswith(f": {message}")


def test_merges_of_the_same_keys(tmp_path: Path, at_most: Callable[[float], AbstractContextManager[None]]) -> None:
    """PyYAML before 6.0.4 takes every mention of a key for one more: such a file is refused. Later ones take it once."""
    with at_most(20):
        found = composed(tmp_path, '<rosparam file="$(find here)/p.yaml"/>' + KEPT, p_yaml=MERGES)
    assert [node.name for node in found.nodes] == ["kept"]
    if found.problems:
        assert problems(found, tmp_path)[0].endswith(": more than 100000 merged keys")
    else:
        assert params(found)["/a11/x"] == 1


def test_file_that_includes_itself(tmp_path: Path) -> None:
    assert only_problem(tmp_path, '<include file="$(find here)/main.launch"/>') == "main.launch:2:1: main.launch includes itself"


@pytest.mark.slow
def test_includes_without_end(tmp_path: Path, at_most: Callable[[float], AbstractContextManager[None]]) -> None:
    twice = '<include file="$(find here)/main.launch"><arg name="n" value="$(eval n + 1)"/></include>' * 2
    with at_most(60):
        found = composed(tmp_path, '<arg name="n" default="0"/>' + twice)
        assert {problem.message for problem in found.problems} == {
            "includes nested more than 60 deep",
            "more than 20000 includes, the rest is left out",
        }


@pytest.mark.slow
def test_texts_that_double(tmp_path: Path) -> None:
    doubled = "".join(f'<arg name="a{i}" default="$(arg a{i - 1})$(arg a{i - 1})"/>\n' for i in range(1, 40))
    found = composed(tmp_path, '<arg name="a0" default="0123456789"/>\n' + doubled + KEPT)
    assert [node.name for node in found.nodes] == ["kept"]
    assert found.problems[0].message == "a text of more than 8 Mi characters after substitution"


@pytest.mark.slow
def test_ten_thousand_nodes(tmp_path: Path, at_most: Callable[[float], AbstractContextManager[None]]) -> None:
    lines = "".join(
        f'<node pkg="p" type="t" name="n{i}"><param name="a" value="{i}"/><remap from="x" to="y{i}"/></node>\n' for i in range(10_000)
    )
    with at_most(30):
        found = composed(tmp_path, lines)
        assert (len(found.nodes), len(found.params), found.problems) == (10_000, 10_000, ())
        assert found.nodes[-1].remaps[0].target == "y9999"


def test_elements_that_were_meant_to_be_others(tmp_path: Path) -> None:
    content = """<doc>x</doc>
<node pkg="p" type="t" name="n"><parm name="a" value="b"/><rosparam subst_value="true">p: $(arg a)</rosparam><rosparam># $(arg a)
p: 1</rosparam></node>
<include file="$(find here)/main.launch" if="0"><remap from="a" to="b"/></include><arg name="a" default="1"/>"""
    kinds = [problem.kind for problem in composed(tmp_path, '<arg name="b"/>' + content.replace("$(arg a)", "$(anon a)")).problems]
    assert kinds == ["unknown-element", "mistaken-element"]
