"""Headers that generate_parameter_library would make of YAML files."""

from __future__ import annotations

from pathlib import Path

from rosarch.extractor.messages.parameter_library import ParameterHeaders, made_from
from rosarch.extractor.workspace import Package


def headers_of(root: Path, text: str | bytes) -> ParameterHeaders:
    path = root / "demo" / "config" / "demo.yaml"
    path.parent.mkdir(parents=True)
    path.write_bytes(text.encode() if isinstance(text, str) else text)
    return ParameterHeaders.of([Package("demo", root / "demo", root / "demo/package.xml", parameter_files=(("made", path),))], root)


def shown(headers: ParameterHeaders, root: Path) -> list[str]:
    return [str(diagnostic).replace(f"{root}/", "") for diagnostic in headers.diagnostics]


def test_each_parameter_is_declared_where_the_file_has_it(tmp_path: Path) -> None:
    found = headers_of(tmp_path, "# first\nspace:\n  a: {type: int, default_value: 3}\n  b:\n    c: {type: string}\n")
    assert sorted(found.texts) == ["demo/made.hpp", "made.hpp", "rosarch_parameters/demo/made.hpp"]
    text = found.texts["rosarch_parameters/demo/made.hpp"]
    assert made_from(text.encode()) == "demo/config/demo.yaml"
    assert text.split("\n")[1:] == [
        " params_->a =",
        '  node->declare_parameter<int>(prefix + "a", 3);',
        " params_->b.c =",
        '    node->declare_parameter<std::string>(prefix + "b.c");',
        "} }; }",
        "",
    ]
    assert "namespace space { struct Params { int64_t a; struct B { std::string c; } b; };" in text
    assert found.diagnostics == ()


def test_defaults_that_are_none_of_their_type_are_left_out(tmp_path: Path) -> None:
    text = headers_of(
        tmp_path,
        "space:\n  a: {type: double, default_value: x}\n  b: {type: bool, default_value: True}\n"
        '  c: {type: double_array, default_value: [1, 2.5]}\n  d: {type: string, default_value: "a\\"b"}\n',
    ).texts["rosarch_parameters/demo/made.hpp"]
    calls = [line for line in text.split("\n")[1:] if line.startswith("  node->")]
    assert [line.partition("(prefix + ")[2].partition(" params_->")[0] for line in calls] == [
        '"a");',
        '"b", true);',
        '"c", std::vector<double>({1, 2.5}));',
        r'"d", "a\"b");',
    ]


def test_values_that_validators_refuse(tmp_path: Path) -> None:
    """Those of elements, of entries of maps and of own validators are not told."""
    found = headers_of(
        tmp_path,
        "space:\n  a: {type: double, validation: {bounds<>: [0.0, 5.0]}}\n  b: {type: int, validation: {gt<>: 0, lt_eq<>: [8]}}\n"
        "  c: {type: string, validation: {one_of<>: [[x, y]]}}\n  d: {type: int_array, validation: {fixed_size<>: 2, bounds<>: [0, 1]}}\n"
        "  e: {type: string_array, validation: {not_empty<>: null, size_lt<>: [n]}}\n  f: {type: string, validation: {own<>: null, not_empty<>: []}}\n"
        "  g: {type: string_array}\n  h:\n    __map_g:\n      i: {type: int, validation: {gt<>: 0}}\n",
    )
    lines = found.texts["rosarch_parameters/demo/made.hpp"].split("\n")
    assert [line.partition("params_->")[2].partition(" = given;")[2] for line in lines if "declare_parameter<" in line] == [
        ' if (given < 0.0) throw std::invalid_argument(""); if (given > 5.0) throw std::invalid_argument(""); } { const int64_t given =',
        ' if (given <= 0) throw std::invalid_argument(""); if (given > 8) throw std::invalid_argument(""); } { const std::string given =',
        ' if (given != "x" && given != "y") throw std::invalid_argument(""); } { const std::vector<int64_t> given =',
        ' if (given.size() != 2) throw std::invalid_argument(""); } { const std::vector<std::string> given =',
        ' if (given.size() == 0) throw std::invalid_argument(""); } params_->f =',
        "",
        "",
        "",
    ]
    assert lines[1].startswith('  node->declare_parameter<double>(prefix + "a"); params_->a = given;')


def test_several_in_a_line(tmp_path: Path) -> None:
    found = headers_of(tmp_path, "space: {a: {type: int}, b: {type: bool}}\n")
    text = found.texts["rosarch_parameters/demo/made.hpp"]
    assert 'params_->a = node->declare_parameter<int>(prefix + "a"); params_->b = node->declare_parameter<bool>(prefix + "b");' in text


def test_what_is_wrong_costs_what_it_is_wrong_with(tmp_path: Path) -> None:
    found = headers_of(tmp_path, "space:\n  a: {type: quaternion}\n  1b: {type: int}\n  2c: {d: {type: int}}\n  e: {type: bool}\n")
    assert shown(found, tmp_path) == [
        "demo/config/demo.yaml:2:3: unknown type quaternion",
        "demo/config/demo.yaml:3:3: `1b` is no name",
        "demo/config/demo.yaml:4:7: `2c` is no name of a parameter",
    ]
    assert "struct Params { bool e; };" in found.texts["rosarch_parameters/demo/made.hpp"]


def test_files_that_make_no_header(tmp_path: Path) -> None:
    cases = {
        "a: [": "1:5: expected the node content, but found '<stream end>'",
        "a: {}\nb: {}\n": "1:1: not a map of one name, the namespace, to parameters",
        "": "1:1: not a map of one name, the namespace, to parameters",
        b"a: \xff": "1:1: not UTF-8",
    }
    for number, (text, message) in enumerate(cases.items()):
        root = tmp_path / str(number)
        found = headers_of(root, text)
        assert found.texts == {}
        assert shown(found, root) == [f"demo/config/demo.yaml:{message}"]
