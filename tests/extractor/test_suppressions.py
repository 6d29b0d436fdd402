"""Suppression comments in every language that findings lie in: what they name, why, and the lines they are about."""

from __future__ import annotations

from collections.abc import Callable
from contextlib import AbstractContextManager
from pathlib import Path

import pytest

from rosarch.base.files import folder_reader
from rosarch.extractor.suppressions import Suppression, find_suppressions, has_suppressions, suppressions_in


def comments_in(path: str, text: str) -> list[tuple[tuple[str, ...], str, int, int]]:
    return [(each.checks, each.reason, each.first, each.last) for each in suppressions_in(path, text)]


@pytest.mark.parametrize(
    ("text", "expected"),
    [
        ("f();  // rosarch: ignore[a-b] why not", [(("a-b",), "why not", 1, 1)]),
        ("// rosarch: ignore[a] why\nf();", [(("a",), "why", 2, 2)]),
        ("f();\n\n  // rosarch: ignore[a] why\n\n\n  f();\n", [(("a",), "why", 6, 6)]),
        ("f(); /* rosarch: ignore[a] why */\n", [(("a",), "why", 1, 1)]),
        ("/* rosarch: ignore[a] why */ f();\n", [(("a",), "why", 1, 1)]),
        ("f(/* rosarch: ignore[a] why */ x);\n", [(("a",), "why", 1, 1)]),
        ("/*\n * rosarch: ignore[a] why\n * more\n */\nf();\n", [(("a",), "why", 5, 5)]),
        ("// rosarch: ignore[a] x\n// rosarch: ignore[b] y\nf();", [(("a",), "x", 3, 3), (("b",), "y", 3, 3)]),
        ("// rosarch: ignore[a] x\n// and more about it\nf();", [(("a",), "x", 3, 3)]),
        ("f();  // rosarch: ignore[a] x\n// rosarch: ignore[b] y\ng();", [(("a",), "x", 1, 1), (("b",), "y", 3, 3)]),
        ("f(); // NOLINT rosarch: ignore[a] x", [(("a",), "x", 1, 1)]),
        ("f(); //rosarch:ignore[a]x", [(("a",), "x", 1, 1)]),
        ("f(); // rosarch: ignore [ a , b,c  d,a ] - why", [(("a", "b", "c", "d"), "why", 1, 1)]),
        ("f(); // rosarch: ignore[a]: why", [(("a",), "why", 1, 1)]),
        ("f(); // rosarch: ignore[a]", [(("a",), "", 1, 1)]),
        ("f(); /* rosarch: ignore[a] */", [(("a",), "", 1, 1)]),
        ("f(); // rosarch: ignore[] why", [((), "why", 1, 1)]),
        ("f(); // rosarch: ignore", [((), "", 1, 1)]),
        ("f(); // rosarch: ignore everything", [((), "everything", 1, 1)]),
        ("f(); // rosarch: ignore[a", [((), "[a", 1, 1)]),
        ("f(); // rosarch: ignored[a] why", []),
        ("f(); // write `rosarch: ignore[a] why`", []),
        ("f(); // not-rosarch: ignore[a] why", []),
        ('f("// rosarch: ignore[a] why");', []),
        ('f("\\"// rosarch: ignore[a] why");', []),
        ("f('\"'); // rosarch: ignore[a] why", [(("a",), "why", 1, 1)]),
        ("int i = 1'000'000; // rosarch: ignore[a] it's", [(("a",), "it's", 1, 1)]),
        ('f(R"x(\n)" // rosarch: ignore[a] why\n)x"); // rosarch: ignore[b] why', [(("b",), "why", 3, 3)]),
        ("// a line that goes on \\\n rosarch: ignore[a] why\nf();", [(("a",), "why", 3, 3)]),
        ("f(); /* rosarch: ignore[a] never closed", [(("a",), "never closed", 1, 1)]),
        ("f();\n// rosarch: ignore[a] at the end", [(("a",), "at the end", 2, 2)]),
        ("# rosarch: ignore[a] no comment in C++", []),
    ],
)
def test_cpp(text: str, expected: list) -> None:
    assert comments_in("src/a.cpp", text) == expected


@pytest.mark.parametrize(
    ("text", "expected"),
    [
        ('<launch>\n<!-- rosarch: ignore[a] why -->\n<node\n  pkg="p"\n  type="t"/>\n</launch>', [(("a",), "why", 3, 5)]),
        ('<node\n pkg="p"/> <!-- rosarch: ignore[a] why -->\n<node/>', [(("a",), "why", 1, 2)]),
        ('<a v="1 > 0"\n  w=\'"\'/>\n<!-- rosarch: ignore[a] -->\n<b/>', [(("a",), "", 4, 4)]),
        ("<!-- rosarch: ignore[a] x -->\n<!-- rosarch: ignore[b]\n  y -->\n<b/>", [(("a",), "x", 4, 4), (("b",), "", 4, 4)]),
        ("<rosparam>\n<!-- rosarch: ignore[a] x -->\nrate: 3\nother: 4</rosparam>", [(("a",), "x", 3, 3)]),
        ("<a><![CDATA[<!-- rosarch: ignore[a] x -->]]></a>", []),
        ('<a v="<!-- rosarch: ignore[a] x -->"/>', []),
        ("<?x <!-- rosarch: ignore[a] x -->?><a/>", []),
        ("<a>\n</a> <!-- rosarch: ignore[a] x -->", [(("a",), "x", 2, 2)]),
        ("<a/>\n<!-- rosarch: ignore[a] x", [(("a",), "x", 2, 2)]),
    ],
)
def test_xml(text: str, expected: list) -> None:
    for path in ("launch/a.launch", "a.test", "package.xml", "urdf/a.urdf.xacro"):
        assert comments_in(path, text) == expected


@pytest.mark.parametrize(
    ("path", "text", "expected"),
    [
        ("a.yaml", "rate: 3  # rosarch: ignore[a] why\n", [(("a",), "why", 1, 1)]),
        ("a.yml", "# rosarch: ignore[a] why\n\nrate: 3\n", [(("a",), "why", 3, 3)]),
        ("a.yaml", "a: \"# rosarch: ignore[a] why\"\nb: '# rosarch: ignore[a] why'\nc: ['x', \"# rosarch: ignore[a]\"]", []),
        ("a.yaml", "a: b# rosarch: ignore[a] why\n", []),
        ("a.yaml", "a: it's\nb: 1 # rosarch: ignore[a] it's\n", [(("a",), "it's", 2, 2)]),
        ("a.py", "f() # rosarch: ignore[a] why\n", [(("a",), "why", 1, 1)]),
        ("a.py", '"""\n# rosarch: ignore[a] why\n"""\nf("# rosarch: ignore[b]") # rosarch: ignore[c] y', [(("c",), "y", 4, 4)]),
        ("cfg/a.cfg", "# rosarch: ignore[a] why\ngen.add()\n", [(("a",), "why", 2, 2)]),
        ("CMakeLists.txt", "add_executable(a a.cpp) # rosarch: ignore[a] why\n", [(("a",), "why", 1, 1)]),
        ("cmake/a.cmake", "#[[\nrosarch: ignore[a] why\n]]\nset(X [=[\n# rosarch: ignore[b]\n]=])\n", [(("a",), "why", 4, 4)]),
        ("p/CMakeLists.txt", 'set(X "\n# rosarch: ignore[b]") # rosarch: ignore[c] y', [(("c",), "y", 2, 2)]),
        ("p/CMakeLists.txt", 'set(X \\" # rosarch: ignore[c] y\n)', [(("c",), "y", 1, 1)]),
        ("msg/A.msg", "int32 x # rosarch: ignore[a] why\n", [(("a",), "why", 1, 1)]),
        ("README.md", "# rosarch: ignore[a] why\n", []),
        ("CMakeCache.txt", "# rosarch: ignore[a] why\n", []),
    ],
)
def test_hash_comments(path: str, text: str, expected: list) -> None:
    assert comments_in(path, text) == expected


def test_place_of_the_comment() -> None:
    assert suppressions_in("a.hpp", "f();\ng();  /* ü rosarch: ignore[a] x */") == [Suppression("a.hpp", 2, 12, ("a",), "x", 2, 2)]


@pytest.mark.parametrize("path", ["a.CPP", "a.cc", "a.h", "a.hpp", "a.launch", "a.xml", "a.yaml", "x/CMakeLists.txt", "a.py"])
def test_kinds_of_files(path: str) -> None:
    assert has_suppressions(path)
    assert not has_suppressions(f"{path}.orig")


def test_files_are_read_once_in_order_and_whatever_they_hold(tmp_path: Path) -> None:
    (tmp_path / "b.cpp").write_bytes(b"f(); // \xff\xfe rosarch: ignore[a] caf\xe9\r\ng(); // rosarch: ignore[b] x\r\n")
    (tmp_path / "a.launch").write_text("<launch/> <!-- rosarch: ignore[c] y -->\n")
    (tmp_path / "folder.cpp").mkdir()
    paths = ["b.cpp", "a.launch", "b.cpp", "missing.cpp", "folder.cpp", "a\0.cpp", "README"]
    reader, asked = folder_reader(tmp_path), []

    def read(path: str) -> str | None:
        asked.append(path)
        return reader(path)

    assert [(each.path, each.checks, each.reason, each.first) for each in find_suppressions(paths, read)] == [
        ("a.launch", ("c",), "y", 1),
        ("b.cpp", ("a",), "caf�", 1),
        ("b.cpp", ("b",), "x", 2),
    ]
    assert asked == ["a\0.cpp", "a.launch", "b.cpp", "folder.cpp", "missing.cpp"]


@pytest.mark.parametrize("path", ["a.cpp", "a.launch", "a.py", "a.yaml", "CMakeLists.txt"])
@pytest.mark.parametrize(
    "unit", ['R"(', "/*", '"', "'", "<a '", "<!--", "<![CDATA[", '"""', "#[[", "[==[", "\\", "1'", "// rosarch: ignore[", "<a b="]
)
def test_hostile_texts_cost_little(path: str, unit: str, at_most: Callable[[float], AbstractContextManager[None]]) -> None:
    text = "rosarch " + unit * 30_000
    with at_most(2):
        suppressions_in(path, text)
        suppressions_in(path, "\n".join([text[:1000]] * 100))


def test_many_comments_cost_little(at_most: Callable[[float], AbstractContextManager[None]]) -> None:
    text = "".join(f"f{number}();\n// rosarch: ignore[a] x\n" for number in range(10_000))
    with at_most(3):
        assert len(suppressions_in("a.cpp", text)) == 10_000
        xml = "".join(f"<a{number}/>\n<!-- rosarch: ignore[a] x -->\n" for number in range(5_000))
        assert len(suppressions_in("a.xml", xml)) == 5_000
        assert len(suppressions_in("a.cpp", "/* rosarch: ignore[a] x */" * 10_000)) == 10_000
