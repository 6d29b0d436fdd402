"""Places: macros count where they are used, headers are files of their own."""

from __future__ import annotations


def places(facts, relation: str = "call") -> list[tuple[int, int]]:
    found = {entity: (line, column) for entity, _, line, column in facts["location"]}
    return sorted(found[row[0]] for row in facts[relation])


def test_line_and_column_count_from_one(facts_of) -> None:
    facts = facts_of("void d();\nvoid f() {\n  d();\n\td();\n}")
    assert places(facts) == [(3, 3), (4, 2)]


def test_windows_line_ends(facts_of) -> None:
    facts = facts_of("void d();\r\nvoid f() {\r\n  d();\r\n}\r\n")
    assert places(facts) == [(3, 3)]


def test_a_macro_is_where_it_is_used(facts_of) -> None:
    facts = facts_of(
        '#define CALL(x) d(x)\n#define NAME "n"\nvoid d(int); void s(const char*);\nvoid f() {\n  CALL(3);\n  s(NAME);\n  CALL(\n   4);\n}'
    )
    assert places(facts) == [(5, 3), (6, 3), (7, 3)]
    assert [(facts.show(a), facts.all("location", a)[0][1:]) for _, _, a in facts["call_argument"]] == [
        ("3", (5, 8)),
        ('"n"', (6, 5)),
        ("4", (8, 4)),
    ]
    assert dict(facts["expr_text"])["6:5:str"] == "NAME"


def test_two_calls_of_one_macro_are_two_nodes(facts_of) -> None:
    facts = facts_of("#define TWICE(x) d(x); d(x)\nvoid d(int);\nvoid f() {\n  TWICE(1);\n}")
    assert len(facts["call"]) == 2
    assert {row[1:] for row in facts["location"] if str(row[0]).partition("'")[0].endswith(":call")} == {("@", 4, 3)}


def test_arguments_of_a_logging_macro_are_read(facts_of) -> None:
    facts = facts_of('#include <ros/ros.h>\nint n();\nvoid f() {\n  ROS_INFO("%d", n());\n  ROS_WARN_STREAM("x" << n());\n}')
    assert [row for row in places(facts) if row in ((4, 18), (5, 26))] == [(4, 18), (5, 26)]
    assert facts.callees().count("n") == 2


def test_a_header_of_the_workspace_is_a_file(extract) -> None:
    facts = extract(
        '#include "inc/h.h"\nvoid f() { inline_one(); }',
        "src/n.cpp",
        {"src/inc/h.h": "#pragma once\nvoid g();\ninline void inline_one() {\n  g();\n}\n"},
    )
    assert sorted(path for _, path in facts.raw["source_file"]) == ["src/inc/h.h", "src/n.cpp"]
    ((call, file, line, column),) = [row for row in facts.raw["location"] if ":4:3:call" in str(row[0])]
    assert (str(file).partition("#")[0], line, column) == ("h.h", 4, 3)
    assert str(call) == f"{file}:4:3:call"


def test_what_lies_outside_the_workspace_has_no_place(facts_of) -> None:
    facts = facts_of("#include <ros/ros.h>\nvoid f(ros::NodeHandle nh) { nh.shutdown(); }")
    assert ("ros::NodeHandle::shutdown", "ros::NodeHandle::shutdown") in facts["function_name"]
    assert [path for _, path in facts["source_file"]] == ["n.cpp"]
    assert facts.all("location", "ros::NodeHandle::shutdown") == []


def test_files_of_one_name_have_two_keys(extract) -> None:
    one = extract("void f() {}", "a/n.cpp")
    two = extract("void f() {}", "b/n.cpp")
    assert one.raw["source_file"] != two.raw["source_file"]
    assert not one.raw["function"] & two.raw["function"]


def test_the_same_source_gives_the_same_rows(extract) -> None:
    source = '#include <ros/ros.h>\nvoid f(ros::NodeHandle nh) { auto l = [&] { nh.getParam("a", 1); }; if (undeclared) l(); }'
    assert extract(source).raw == extract(source).raw


def test_lines_that_conditional_compilation_leaves_out(extract) -> None:
    facts = extract("int a;\n#if 0\nint b;\n#else\nint c;\n#endif\n#ifdef GIVEN\nint d;\n#endif\n", definitions=("GIVEN",))
    assert facts["lines_skipped"] == [("@", 2, 4)]
    assert [name for _, name in facts["variable_name"]] == ["a", "c", "d"]


def test_what_no_file_says_is_not_in_the_current_folder(facts_of, tmp_path, monkeypatch) -> None:
    (tmp_path / "src").mkdir()
    monkeypatch.chdir(tmp_path / "src")
    assert [path for _, path in facts_of("void f(int = 0);\nvoid g() { f(); }")["source_file"]] == ["n.cpp"]
