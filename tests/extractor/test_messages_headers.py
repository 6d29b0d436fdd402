from __future__ import annotations

import shutil
import subprocess
from pathlib import Path

import pytest
from workspace_builder import package

from rosarch.extractor.messages import MessageStore, generate_headers, header_index, header_text, load_messages
from rosarch.extractor.workspace import discover

CFG = """#!/usr/bin/env python
PACKAGE = "demo"
from dynamic_reconfigure.parameter_generator_catkin import *
from shared_params import add_shared
gen = ParameterGenerator()
add_shared(gen)
modes = gen.enum([gen.const("Fast", int_t, 1, "x"), gen.const("Name", str_t, "a b", "x")], "d")
group = gen.add_group("g")
gen.add("mode", int_t, 0, "the " + "mode", 1, 0, 3, edit_method=modes)
group.add("rate", double_t, 0, "r", 10.0)
gen.add("on", bool_t, 0, "o", True)
gen.add("label", str_t, 0, "l", "x")
for i in range(2):
    gen.add("p%d" % i, double_t, 0, "p", i * 0.5)
exit(gen.generate(PACKAGE, "demo", "Demo"))
"""
SHARED = "def add_shared(gen):\n    gen.add('limit', double_t, 0, 'l', -1.5, -2, 2)\n"


@pytest.fixture
def store(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> MessageStore:
    monkeypatch.setenv("ROSARCH_CACHE_DIR", str(tmp_path / "cache"))
    files = {
        "msg/Level.msg": "int8 LOW=-1\nuint64 BIG=0xFFFFFFFFFF\nstring NAME=x\nfloat32 PI=3.14\nHeader header\nfloat64[3] Level\nOther[] others\n",
        "msg/Other.msg": "time stamp\nnone_msgs/No lost\n",
        "srv/Ask.srv": "---\n",
        "action/Go.action": "---\n---\n",
        "cfg/Demo.cfg": CFG,
        "src/shared_params/__init__.py": SHARED,
    }
    package(tmp_path / "ws", "demo", "generate_dynamic_reconfigure_options(cfg/Demo.cfg)", files)
    return load_messages(discover(tmp_path / "ws").packages)


def test_message_header(store: MessageStore) -> None:
    assert header_text(store, "demo/Level.h") == (
        "#pragma once\n"
        "#include <ros/message_prelude.h>\n"
        "#include <std_msgs/Header.h>\n"
        "#include <demo/Other.h>\n"
        "\n"
        "namespace demo {\n"
        "struct Level_ {\n"
        "  typedef Level_ Type;\n"
        "  typedef boost::shared_ptr<Level_> Ptr;\n"
        "  typedef boost::shared_ptr<Level_ const> ConstPtr;\n"
        "  enum { LOW = -1 };\n"
        "  enum { BIG = 1099511627775u };\n"
        "  static const std::string NAME;\n"
        "  static const float PI;\n"
        "  typedef ::std_msgs::Header_ _header_type;\n"
        "  _header_type header;\n"
        "  typedef boost::array<double, 3> _Level_type;\n"
        "  _Level_type Level;\n"
        "  typedef std::vector<::demo::Other_> _others_type;\n"
        "  _others_type others;\n"
        "};\n"
        "typedef Level_ Level;\n"
        "typedef boost::shared_ptr<Level_> LevelPtr;\n"
        "typedef boost::shared_ptr<Level_ const> LevelConstPtr;\n"
        "}  // namespace demo\n"
    )


def test_unknown_field_is_a_comment(store: MessageStore) -> None:
    assert "  // lost: unknown type none_msgs/No\n" in (header_text(store, "demo/Other.h") or "")


def test_service_header(store: MessageStore) -> None:
    assert header_text(store, "demo/Ask.h") == (
        "#pragma once\n"
        "#include <ros/message_prelude.h>\n"
        "#include <demo/AskRequest.h>\n"
        "#include <demo/AskResponse.h>\n"
        "\n"
        "namespace demo {\n"
        "struct Ask {\n"
        "  typedef AskRequest Request;\n"
        "  typedef AskResponse Response;\n"
        "  typedef Request RequestType;\n"
        "  typedef Response ResponseType;\n"
        "  Request request;\n"
        "  Response response;\n"
        "};\n"
        "}  // namespace demo\n"
    )


def test_action_headers(store: MessageStore) -> None:
    text = header_text(store, "demo/GoAction.h") or ""
    for part in ("goal", "result", "feedback"):
        assert f"  typedef ::demo::GoAction{part.title()}_ _action_{part}_type;\n" in text
    assert "typedef ::demo::GoGoal_ _goal_type;" in (header_text(store, "demo/GoActionGoal.h") or "")


def test_config_header(store: MessageStore) -> None:
    text = header_text(store, "demo/DemoConfig.h") or ""
    fields = "  double limit;\n  int mode;\n  double rate;\n  bool on;\n  std::string label;\n  double p0;\n  double p1;\n"
    assert f"class DemoConfig {{\npublic:\n{fields}" in text
    assert 'const int Demo_Fast = 1;\nconst char* const Demo_Name = "a b";\n' in text
    parameters = {one.name: (one.type, one.default, one.minimum, one.maximum) for one in store.configs["demo/Demo"].parameters}
    assert parameters["limit"] == ("double", "-1.5", "-2", "2")
    assert parameters["mode"] == ("int", "1", "0", "3")
    assert parameters["p1"] == ("double", "0.5", None, None)


def test_python2_config_is_read_by_pattern(tmp_path: Path) -> None:
    text = 'print "x"\ngen.add("rate", double_t, 0, "r, (hz)", 10.0, 0, 100)\nexit(gen.generate(PACKAGE, "n", "Old"))\n'
    package(tmp_path, "demo", "generate_dynamic_reconfigure_options(cfg/Old.cfg)", {"cfg/Old.cfg": text})
    store = load_messages(discover(tmp_path).packages, with_common=False)
    (parameter,) = store.configs["demo/Old"].parameters
    assert (parameter.name, parameter.default, parameter.minimum, parameter.maximum, parameter.line) == ("rate", "10.0", "0", "100", 2)
    assert [diagnostic.message for diagnostic in store.diagnostics] == ["not Python 3, read by pattern"]


def test_no_such_header(store: MessageStore) -> None:
    assert header_text(store, "demo/None.h") is None
    assert header_text(store, "demo/Level") is None
    assert header_text(store, "ros/ros.h") is None


def test_index_names_every_header(store: MessageStore) -> None:
    index = header_index(store)
    assert index["demo/Ask.h"] == "demo/Ask"
    assert index["demo/DemoConfig.h"] == "demo/Demo"
    assert all(header_text(store, header) for header in index)


def test_generate_headers(store: MessageStore, tmp_path: Path) -> None:
    written = generate_headers(store, tmp_path / "out", ["demo"])
    assert (tmp_path / "out/demo/Level.h").read_text() == header_text(store, "demo/Level.h")
    assert {path.parent.name for path in written} == {"demo"}
    before = (tmp_path / "out/demo/Level.h").stat().st_mtime_ns
    generate_headers(store, tmp_path / "out", ["demo"])
    assert (tmp_path / "out/demo/Level.h").stat().st_mtime_ns == before


PRELUDE = """#pragma once
#include <array>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>
namespace boost { template <class T> using shared_ptr = std::shared_ptr<T>; template <class T, std::size_t N> using array = std::array<T, N>; }
namespace ros { struct Time {}; struct Duration {}; }
"""


@pytest.mark.skipif(shutil.which("g++") is None, reason="no C++ compiler")
def test_every_header_compiles(store: MessageStore, tmp_path: Path) -> None:
    out = tmp_path / "out"
    generate_headers(store, out)
    (out / "ros").mkdir()
    (out / "ros/message_prelude.h").write_text(PRELUDE)
    (out / "all.cpp").write_text("".join(f"#include <{name}>\n" for name in header_index(store)))
    result = subprocess.run(["g++", "-std=c++11", "-fsyntax-only", "-I", out, out / "all.cpp"], capture_output=True, text=True, check=False)
    assert result.stderr == ""
