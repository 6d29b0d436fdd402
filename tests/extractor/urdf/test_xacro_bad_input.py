from __future__ import annotations

import os
from collections.abc import Callable
from contextlib import AbstractContextManager
from pathlib import Path

import pytest
from xacro_builder import HEAD, expanded, inner, problems

from rosarch.extractor.urdf import IN_ORDER, TRADITIONAL

P, M = "xacro:property", "xacro:macro"


@pytest.mark.parametrize(
    ("content", "problem"),
    [
        ("<l>", "1:57: broken XML: mismatched tag"),
        ("<l/><l a=1/>", "1:61: broken XML: not well-formed (invalid token)"),
        ("\n<x:y/>", "2:1: broken XML: unbound prefix"),
        ("\n <xacro:unknown/>", "2:2: macro `unknown` is not defined"),
        ("<xacro:if/>", "1:52: <xacro:if> has no attribute `value`"),
        ('<xacro:if value="maybe"/>', "1:52: condition `maybe` is `maybe`, which is not a Boolean"),
        (f'<{P} name="a b" value="1"/>', "1:52: `a b` cannot name a property"),
        (f'<{P} name="a" value="1" default="2"/>', "1:52: property `a` must have only one of value, default and remove"),
        (f'<{P} name="a" value="1" scope="parent"/>', "1:52: property `a` is for a scope that is not there"),
        (f'<{P} name="a" value="${{b}}"/><{P} name="b" value="${{a}}"/>\n<l v="${{a}}"/>', "2:1: property `a` is defined by itself: a -> b -> a"),
        (f'<{M} name="call"/>', "1:52: `call` cannot name a macro"),
        (f'<{M} name="m" params="a"/>\n<xacro:m/>', "2:1: macro `m` needs parameter `a`"),
        (f'<{M} name="m"/>\n<xacro:m a="1"/>', "2:1: macro `m` has no parameter `a`"),
        (f'<{M} name="m"/>\n<xacro:m><l/></xacro:m>', "2:1: macro `m` takes no block <l>"),
        (f'<{M} name="m" params="*b"/>\n<xacro:m/>', "2:1: macro `m` needs a block for `*b`"),
        ('<xacro:insert_block name="b"/>', "1:52: block `b` is not defined"),
        ('<xacro:element xacro:name=""/>', "1:52: <xacro:element> has an empty name"),
        ('<xacro:attribute name="" value="1"/>', "1:52: <xacro:attribute> has an empty name"),
        ('<l v="${nothing}"/>', "1:52: ${nothing}: name 'nothing' is not defined"),
        ('<l v="${1 +}"/>', "1:52: ${1 +}: invalid syntax"),
        ('<l v="${1 / 0}"/>', "1:52: ${1 / 0}: ZeroDivisionError: division by zero"),
        ("<l v=\"${''.__class__}\"/>", "1:52: ${''.__class__}: `__class__` must not be used"),
        ("<l v=\"${__import__('os')}\"/>", "1:52: ${__import__('os')}: name '__import__' is not defined"),
        ("<l v=\"${open('/etc/passwd')}\"/>", "1:52: ${open('/etc/passwd')}: name 'open' is not defined"),
        ('<l v="${1"/>', "1:52: `${1` is not closed"),
        ('<l v="$(foo)"/>', "1:52: unknown substitution command $(foo), known are find, env, optenv, dirname, anon, arg"),
        ('<l v="$(arg a)"/>', "1:52: argument `a` is not defined"),
        ("<l v=\"${xacro.fatal('too', 1)}\"/>", "1:52: too 1"),
        ("<l v=\"${xacro.load_yaml('a.yaml')}\"/>", "1:52: invalid YAML at a.yaml:1:6: while parsing a flow sequence expected ',' or ']', but got '<stream end>'"),
        ("<l v=\"${load_yaml('none.yaml')}\"/>", "1:52: no such file: none.yaml"),
    ],
)  # fmt: skip
def test_one_line_each(tmp_path: Path, content: str, problem: str) -> None:
    found = problems(expanded(tmp_path, content, a_yaml="a: [1"), tmp_path)
    assert found[-1:] == [f"robot.xacro:{problem}"]


def test_a_broken_file_that_is_included(tmp_path: Path) -> None:
    assert (
        inner(tmp_path, '<xacro:include filename="a.xacro"/>', a_xacro="ROBOT\n <l></robot>") == "a.xacro:2:7: broken XML: mismatched tag"
    )
    assert (
        inner(tmp_path, '<xacro:include filename="a.xacro"/>', a_xacro="ROBOT\n <l v='${x}'/></robot>")
        == "a.xacro:2:2: ${x}: name 'x' is not defined"
    )


def test_not_utf8(tmp_path: Path) -> None:
    assert problems(expanded(tmp_path, b"<robot>\xff</robot>"), tmp_path) == [
        "robot.xacro:1:8: broken XML: not well-formed (invalid token)"
    ]


def test_entities_are_not_expanded(tmp_path: Path) -> None:
    bomb = b'<!DOCTYPE r [<!ENTITY a "aaaa"><!ENTITY b "&a;&a;">]><robot>&b;</robot>'
    assert problems(expanded(tmp_path, bomb), tmp_path) == ["robot.xacro:1:25: entity `a` is declared here; entities are not expanded"]


def test_cycles_end(tmp_path: Path) -> None:
    own = '<xacro:include filename="robot.xacro"/>'
    assert inner(tmp_path, own) == "robot.xacro:1:52: robot.xacro includes itself"
    assert inner(tmp_path, own, dialect=TRADITIONAL) == "robot.xacro:1:52: robot.xacro includes itself"
    macro = f'<{M} name="m"><xacro:m/></{M}><xacro:m/>'
    assert inner(tmp_path, macro) == "robot.xacro:1:74: elements, macros and includes nested more than 120 deep"
    blocks = f'<{P} name="b"><xacro:insert_block name="b"/></{P}><xacro:insert_block name="b"/>'
    assert inner(tmp_path, blocks).endswith("elements, macros and includes nested more than 120 deep")


def test_deep_documents(tmp_path: Path) -> None:
    deep = HEAD.encode() + b"<l>" * 1000 + b"</l>" * 1000 + b"</robot>"
    assert problems(expanded(tmp_path, deep), tmp_path) == ["robot.xacro:1:499: elements nested more than 150 deep"]


@pytest.mark.slow
@pytest.mark.parametrize(
    "content",
    [
        f'<{M} name="m" params="n"><xacro:if value="${{n > 0}}"><xacro:m n="${{n - 1}}"/><xacro:m n="${{n - 1}}"/></xacro:if></{M}><xacro:m n="40"/>',
        "".join(f'<{M} name="m{i}"><xacro:m{i + 1}/><xacro:m{i + 1}/></{M}>' for i in range(30)) + f'<{M} name="m30"><l/></{M}><xacro:m0/>',
        f'<{M} name="m" params="n"><l v="${{len([i for i in range(9999)])}}"/></{M}>' + '<xacro:m n="1"/>' * 5000,
    ],
)
def test_huge_expansions_are_refused_in_time(
    tmp_path: Path, content: str, at_most: Callable[[float], AbstractContextManager[None]]
) -> None:
    with at_most(20):
        expansion = expanded(tmp_path, content)
        assert expansion.document is None
        assert problems(expansion, tmp_path)[-1].endswith(": the document unfolds to too much")


def test_texts_that_double_each_other(tmp_path: Path) -> None:
    doubled = "".join(f'<{P} name="p{i + 1}" value="${{p{i}}}${{p{i}}}" lazy_eval="false"/>' for i in range(40))
    found = expanded(tmp_path, f'<{P} name="p0" value="x"/>{doubled}').problems
    assert [problem.message for problem in found] == [f"${{p{i}}} stays unknown: the value is too large" for i in (18, 36)]


@pytest.mark.parametrize(
    ("expression", "reason"),
    [
        ("'a' * 10**9", "the text is too large"),
        ("9 ** 9 ** 9", "the number is too large"),
        ("[0] * 10**9", "the text is too large"),
        ("range(10**9)", "the argument is too large"),
        ("+".join(["1"] * 6000), "more than 10000 characters"),
        ("-" * 5000 + "1", "nested too deeply"),
        ("lambda: 1", "Lambda is not evaluated"),
    ],
)
def test_large_expressions_stay_unknown(tmp_path: Path, expression: str, reason: str) -> None:
    expansion = expanded(tmp_path, f'<l v="${{{expression}}}"/><m v="${{1}}"/>')
    assert [(problem.fatal, problem.message.rpartition(": ")[2]) for problem in expansion.problems] == [(False, reason)]
    assert inner(tmp_path, f'<l v="${{{expression}}}"/><m v="${{1}}"/>') == f'<l v="${{{expression}}}"/><m v="1"/>'


@pytest.mark.parametrize("path", ["/etc/passwd", "../" * 12 + "etc/passwd", "/etc/*.conf", "*/../../*/../../etc/passw?"])
def test_nothing_outside_the_packages_is_read(tmp_path: Path, path: str) -> None:
    assert inner(tmp_path, f'<xacro:include filename="{path}"/><l/>') == "<l/>"
    found = expanded(tmp_path, f'<xacro:include filename="{path}"/><l/>')
    assert [problem.kind for problem in found.problems] == ["outside"]
    assert inner(tmp_path, f"<l v=\"${{load_yaml('{path.replace('*', 'x')}')}}\"/>").startswith("robot.xacro:1:52: ")


def test_a_link_out_of_the_packages_is_not_followed(tmp_path: Path) -> None:
    (tmp_path / "here").mkdir()
    os.symlink("/etc/passwd", tmp_path / "here" / "a.xacro")
    assert [problem.kind for problem in expanded(tmp_path, '<xacro:include filename="a.xacro"/>').problems] == ["outside"]


def test_texts_cannot_pose_as_unknowns(tmp_path: Path) -> None:
    content = f'<{P} name="a" value="\'\\U00100000\'"/><l v="${{a}} \U00100001 ${{\'\\U00100002\'}}"/>'
    assert "\ufffd" in inner(tmp_path, content, dialect=IN_ORDER)
    assert "\U00100000" not in inner(tmp_path, content, dialect=IN_ORDER)
    assert inner(tmp_path, '<l v="${chr(1)}"/>') == "robot.xacro:1:52: ${chr(1)}: name 'chr' is not defined"
