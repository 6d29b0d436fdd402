"""What expectations mean, where they stand, and what is refused."""

from __future__ import annotations

import pytest

from rosarch.evaluation.expectations.comments import Marked, marked
from rosarch.evaluation.expectations.grammar import Expectation, ExpectationError, parse


def written(text: str, *, sense: str = "", beside: bool = False) -> Marked:
    return Marked("a.cpp", 3, 4, text, 12, sense, 4, 4, beside)


def meaning(text: str) -> tuple[str | None, dict[str, str]]:
    found = parse(written(text))
    return found.kind.name if found.kind else None, dict(found.wanted)


@pytest.mark.parametrize(
    ("text", "kind", "wanted"),
    [
        ("publisher /cmd_vel", "publisher", {"name": "/cmd_vel"}),
        ("publisher /cmd_vel geometry_msgs/Twist queue=10 latched", "publisher", {"name": "/cmd_vel", "type": "geometry_msgs/Twist", "queue": "10", "latched": "true"}),
        ("publisher latched", "publisher", {"latched": "true"}),
        ("publisher x type=a/B latched=false", "publisher", {"name": "x", "type": "a/B", "latched": "false"}),
        ("service_server", "service_server", {}),
        ("param ~rate = 10.0 op=read", "param", {"name": "~rate", "default": "10.0", "op": "read"}),
        ("param ~name = \"a b\"", "param", {"name": "~name", "default": "a b"}),
        ("periodic /odom 10 Hz mechanism=timer", "periodic", {"output": "/odom", "hz": "10", "mechanism": "timer"}),
        ("periodic /odom * Hz", "periodic", {"output": "/odom", "hz": "*"}),
        ("publisher /odom queue=", "publisher", {"name": "/odom", "queue": ""}),
        ("state x = a[\"b\"]", "state", {"name": "x", "initial": 'a["b"]'}),
        ("periodic /odom 10Hz", "periodic", {"output": "/odom", "hz": "10"}),
        ("reactive /scan -> /cmd_vel must", "reactive", {"input": "/scan", "output": "/cmd_vel", "must": "true"}),
        ("reactive /scan -> /cmd_vel may if \"a && !b\"", "reactive", {"input": "/scan", "output": "/cmd_vel", "must": "false", "when": "a && !b"}),
        ("one_shot /go 0.5 s", "one_shot", {"output": "/go", "after": "0.5"}),
        ("deferred /scan -> /go variable=Node::last_", "deferred", {"input": "/scan", "output": "/go", "variable": "Node::last_"}),
        ("state Node::on_ = false type=bool", "state", {"name": "Node::on_", "initial": "false", "type": "bool"}),
        ("transition Node::on_ = true on /start if ready_", "transition", {"variable": "Node::on_", "value": "true", "trigger": "/start", "guard": "ready_"}),
        ("transition Node::text_ = \"\\\"a\\\"\"", "transition", {"variable": "Node::text_", "value": '"a"'}),
        ("finding topic-type-mismatch \"*battery*\" severity=error", "finding", {"check": "topic-type-mismatch", "message": "*battery*", "severity": "error"}),
        ("component driver kind=nodelet", "component", {"name": "driver", "kind": "nodelet"}),
    ],
)  # fmt: skip
def test_meaning(text: str, kind: str, wanted: dict[str, str]) -> None:
    assert meaning(text) == (kind, wanted)


@pytest.mark.parametrize(
    "text",
    [
        "port(_)",
        '!port([_, "publisher", _])',
        "Count = count : { port(_) }, Count > 1",
        "2 = count : { port(_) }",
        "own.relation(X), X != 1",
    ],
)
def test_queries(text: str) -> None:
    assert parse(written(text)) == Expectation(written(text), None, query=text)


@pytest.mark.parametrize(
    ("text", "error"),
    [
        ("publsher x", "3:12: unknown kind of element `publsher`, did you mean `publisher`?"),
        ("reactive /scan", "3:26: reactive is written `reactive INPUT -> OUTPUT`"),
        ("reactive /scan /cmd_vel", "3:35: reactive is written `reactive INPUT -> OUTPUT`"),
        ("state x =", "3:21: state is written `state NAME = INITIAL`"),
        ("publisher x colour=red", "3:24: publisher has no `colour`, there are name, type, queue, latched, callback, via, from_param, conditional, implicit, unknown"),
        ("publisher x a/B latchd", "3:28: `latchd` is not understood here, did you mean `latched`?; publisher is written `publisher NAME TYPE`"),
        ("transition x = 1 on", "3:29: nothing after `on`"),
        ("publisher \"/cmd_vel queue=10", "3:22: a quote that is not closed"),
        ("transition x = 1 if \"a && b", "3:32: a quote that is not closed"),
        ("state x = a[\"b", "3:24: a quote that is not closed"),
        ("param ~name = \"a\"b", "3:29: `b` right behind a quote"),
        ("periodic x y Hz", "3:23: `hz` is a number, not `y`"),
        ("periodic x hz=fast", "3:26: `hz` is a number, not `fast`"),
        ("publisher x queue=ten", "3:30: `queue` is a number, not `ten`"),
        ("publisher x latched=maybe", "3:32: `latched` is true or false, not `maybe`"),
        ("publisher x queue=1 queue=2", "3:38: `queue` is given twice"),
        ("reactive a -> b must may", "3:33: `must` is given twice"),
        ("", "3:4: nothing is expected here"),
    ],
)  # fmt: skip
def test_what_is_refused(text: str, error: str) -> None:
    with pytest.raises(ExpectationError) as caught:
        parse(written(text))
    assert str(caught.value) == f"a.cpp:{error}"


def test_what_only_one_sense_has() -> None:
    only = parse(written("*", sense="only")).kind
    assert only is not None and only.name == "*"
    with pytest.raises(ExpectationError, match=r"a\.cpp:3:12: unknown kind of element `\*`"):
        parse(written("*"))
    with pytest.raises(
        ExpectationError, match=r"a\.cpp:3:12: of rows, expect how many there are, `N = count : \{ \.\.\. \}, N = 2`, or behind code"
    ):
        parse(written("port(_)", sense="only"))


def test_where_they_stand() -> None:
    source = """// expect: publisher a
int x;  // expect: publisher b
/* expect: publisher c
 * expect-not: publisher d
 * expect-only: publisher */
char text[] = "// expect: publisher e";
// as they expect: nothing
// expect: finding x-y

int y;
"""
    found = [(each.line, each.column, each.text, each.text_column, each.sense, each.first, each.beside) for each in marked("a.cpp", source)]
    assert found == [
        (1, 4, "publisher a", 12, "", 2, False),
        (2, 12, "publisher b", 20, "", 2, True),
        (3, 4, "publisher c", 12, "", 6, False),
        (4, 4, "publisher d", 16, "not", 6, False),
        (5, 4, "publisher", 17, "only", 6, False),
        (8, 4, "finding x-y", 12, "", 10, False),
    ]


@pytest.mark.parametrize(
    ("path", "text"),
    [
        ("a.launch", '<launch>\n  <node pkg="a"\n    type="b"/>  <!-- expect: finding c -->\n</launch>\n'),
        ("a.yaml", "b:\n  - 1\n  - 2  # expect: finding c\n"),
        ("CMakeLists.txt", "\n\nproject(a)  # expect: finding c\n"),
        ("a.py", '\n"""# expect: no comment"""\nx = 1  # expect: finding c\n'),
    ],
)
def test_other_kinds_of_files(path: str, text: str) -> None:
    (found,) = marked(path, text)
    assert (found.text, found.last, found.beside) == ("finding c", 3, True)
    assert list(marked("notes.md", text)) == []
