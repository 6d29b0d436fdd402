from __future__ import annotations

from pathlib import Path

import pytest
from workspace_builder import evaluated, messages, names, target

ABC = {"a.cpp": "", "b.cpp": "", "c.cpp": "", "sub/d.cpp": ""}


@pytest.mark.parametrize(
    ("cmake", "sources"),
    [
        ("set(S a.cpp b.cpp)\nadd_executable(x ${S})", ["a.cpp", "b.cpp"]),
        ("set(S a.cpp)\nlist(APPEND S b.cpp c.cpp)\nlist(REMOVE_ITEM S a.cpp)\nadd_executable(x ${S})", ["b.cpp", "c.cpp"]),
        ("set(S a)\nset(T S)\nadd_executable(x ${${T}}.cpp)", ["a.cpp"]),
        ("set(S a.cpp)\nunset(S)\nadd_executable(x ${S} b.cpp)", ["b.cpp"]),
        ("set(S a.cpp CACHE STRING d)\nset(S b.cpp CACHE STRING d)\nadd_executable(x ${S})", ["a.cpp"]),
        ("if(cxx_std_11 IN_LIST CMAKE_CXX_COMPILE_FEATURES)\nadd_executable(x a.cpp)\nendif()", ["a.cpp"]),
        ("if(NOT cxx_std_20 IN_LIST CMAKE_CXX_COMPILE_FEATURES)\nadd_executable(x a.cpp)\nendif()", ["a.cpp"]),
        ("file(GLOB S *.cpp)\nadd_executable(x ${S})", ["a.cpp", "b.cpp", "c.cpp"]),
        ("file(GLOB_RECURSE S RELATIVE ${CMAKE_CURRENT_SOURCE_DIR} *.cpp)\nadd_executable(x ${S})", ["a.cpp", "b.cpp", "c.cpp", "d.cpp"]),
        ("file(GLOB S s*/[a-d].cpp)\nadd_executable(x ${S})", ["d.cpp"]),
        ("foreach(n a b)\nlist(APPEND S ${n}.cpp)\nendforeach()\nadd_executable(x ${S})", ["a.cpp", "b.cpp"]),
        (
            "set(L a c)\nforeach(n IN LISTS L ITEMS b)\nlist(APPEND S ${n}.cpp)\nendforeach()\nadd_executable(x ${S})",
            ["a.cpp", "c.cpp", "b.cpp"],
        ),
        (
            "set(K a b)\nset(V cpp cpp)\nforeach(k v IN ZIP_LISTS K V)\nlist(APPEND S ${k}.${v})\nendforeach()\nadd_executable(x ${S})",
            ["a.cpp", "b.cpp"],
        ),
        ("foreach(n a b c)\nif(n STREQUAL b)\nbreak()\nendif()\nlist(APPEND S ${n}.cpp)\nendforeach()\nadd_executable(x ${S})", ["a.cpp"]),
        (
            "foreach(n a b c)\nif(n STREQUAL b)\ncontinue()\nendif()\nlist(APPEND S ${n}.cpp)\nendforeach()\nadd_executable(x ${S})",
            ["a.cpp", "c.cpp"],
        ),
        (
            "set(L a b)\nwhile(L)\nlist(GET L 0 n)\nlist(REMOVE_AT L 0)\nlist(APPEND S ${n}.cpp)\nendwhile()\nadd_executable(x ${S})",
            ["a.cpp", "b.cpp"],
        ),
        (
            "function(f n)\nset(${n} a.cpp ${ARGN} PARENT_SCOPE)\nset(S no.cpp)\nendfunction()\nf(S b.cpp)\nadd_executable(x ${S})",
            ["a.cpp", "b.cpp"],
        ),
        ("macro(m n)\nset(${n} ${ARGV1})\nendmacro()\nm(S b.cpp)\nadd_executable(x ${S})", ["b.cpp"]),
        (
            "function(f)\nset(S b.cpp PARENT_SCOPE)\nreturn()\nset(S c.cpp PARENT_SCOPE)\nendfunction()\nf()\nadd_executable(x ${S})",
            ["b.cpp"],
        ),
        ("string(TOLOWER A.CPP S)\nstring(REPLACE a b S ${S})\nadd_executable(x ${S})", ["b.cpp"]),
        ('string(REGEX REPLACE "^(.)x" "\\\\1." S axcpp)\nadd_executable(x ${S})', ["a.cpp"]),
        ("get_filename_component(N /q/a.b.c NAME_WE)\nadd_executable(x ${N}.cpp)", ["a.cpp"]),
        ("aux_source_directory(sub S)\nadd_executable(x ${S})", ["d.cpp"]),
        ("add_executable(x a.cpp)\ntarget_sources(x PRIVATE b.cpp)", ["a.cpp", "b.cpp"]),
        ('set(S a.cpp b.cpp)\nset(S "${S}" "c.cpp")\nadd_executable(x "${S}")', ["a.cpp", "b.cpp", "c.cpp"]),
        ("add_executable(x a)", ["a.cpp"]),
        ("cuda_add_executable(x a.cpp)", ["a.cpp"]),
    ],
)
def test_sources(tmp_path: Path, cmake: str, sources: list[str]) -> None:
    found, workspace = evaluated(tmp_path, cmake, ABC)
    assert names(target(found, "x")) == sources
    assert messages(workspace, tmp_path) == []


@pytest.mark.parametrize(
    ("condition", "value"),
    [
        ("ON", True),
        ("NOT ON", False),
        ("UNKNOWN_VARIABLE", False),
        ("V", True),
        ("EMPTY", False),
        ('"V"', False),
        ("V STREQUAL yes", True),
        ('"${V}" STREQUAL "yes"', True),
        ("V MATCHES ^y.s$", True),
        ("V MATCHES ^y AND CMAKE_MATCH_0 STREQUAL y", True),
        ("1.10 VERSION_GREATER 1.9", True),
        ("NOT (PCL_VERSION VERSION_LESS 1.7.2)", True),
        ("OFF OR ON AND OFF", False),
        ("(OFF OR ON) AND ON", True),
        ("3 EQUAL 3.0 AND 2 LESS 10", True),
        ("DEFINED V AND NOT DEFINED W", True),
        ("DEFINED ENV{ROS_DISTRO}", True),
        ("yes IN_LIST L", True),
        ("TARGET y", True),
        ("COMMAND add_executable", True),
        ("EXISTS ${CMAKE_CURRENT_SOURCE_DIR}/a.cpp", True),
        ("EXISTS ${CMAKE_CURRENT_SOURCE_DIR}/none.cpp", False),
        ("EXISTS /opt/vendor/sdk", True),
        ("UNIX AND NOT WIN32 AND NOT APPLE", True),
        ('"$ENV{ROS_DISTRO}" MATCHES "(kinetic)"', True),
        ("OpenCV_FOUND AND OPENCV_FOUND", True),
        ("x-NOTFOUND", False),
        ("Radio_DIR AND Radio_Tuner_FOUND AND RADIO_INCLUDE_DIRS AND DEFINED Radio_VERSION", True),
        ("Radio_VERSION VERSION_LESS 3.1", False),
        ("TARGET Radio::tuner AND NOT TARGET Other::tuner", True),
        ("Radio_USE_STATIC OR Other_DIR", False),
        ("CMAKE_CUDA_COMPILER", True),
    ],
)
def test_conditions(tmp_path: Path, condition: str, value: bool) -> None:
    head = "find_package(OpenCV)\nfind_package(PCL)\nfind_package(Radio QUIET)\ncheck_language(CUDA)\nset(V yes)\nset(EMPTY)\nset(L no yes)\nadd_executable(y a.cpp)\n"
    found, _ = evaluated(tmp_path, f"{head}if({condition})\nadd_executable(x a.cpp)\nendif()", ABC)
    assert (found.target("x") is not None) == value


@pytest.mark.parametrize(
    ("cmake", "targets"),
    [
        ("if(NOT WITH_RADIO)\nfind_package(catkin)\ncatkin_package()\nreturn()\nendif()\nadd_executable(x a.cpp)", ["x"]),
        ("if(WITH_RADIO)\nelse()\nreturn()\nendif()\nadd_executable(x a.cpp)", ["x"]),
        ("add_subdirectory(inner)\nadd_executable(x a.cpp)", ["y", "x"]),
        ("if(ON)\nadd_executable(y b.cpp)\nreturn()\nendif()\nadd_executable(x a.cpp)", ["y"]),
        ("return()\nadd_executable(x a.cpp)", []),
        ("function(f)\nif(ON)\nreturn()\nendif()\nadd_executable(x a.cpp)\nendfunction()\nf()", []),
        ("include(guard.cmake)\nadd_executable(x a.cpp)", ["x"]),
        ("if(ON)\nproject(SUPERBUILD NONE)\nreturn()\nelse()\nproject(demo)\nendif()\nadd_executable(${PROJECT_NAME}_x a.cpp)", ["demo_x"]),
    ],
)
def test_a_package_that_leaves_before_it_makes_a_target_is_read_on(tmp_path: Path, cmake: str, targets: list[str]) -> None:
    inner = "if(NOT WITH_RADIO)\nreturn()\nendif()\nadd_executable(y ../b.cpp)"
    guard = "if(ON)\nreturn()\nendif()\nadd_executable(z a.cpp)"
    found, _ = evaluated(tmp_path, cmake, {**ABC, "inner/CMakeLists.txt": inner, "guard.cmake": guard})
    assert [one.name for one in found.targets] == targets


def test_defines_override_what_is_found(tmp_path: Path) -> None:
    cmake = "find_package(CUDA)\nif(CUDA_FOUND)\nadd_executable(gpu a.cpp)\nelse()\nadd_executable(cpu b.cpp)\nendif()"
    found, _ = evaluated(tmp_path, cmake, ABC)
    assert [one.name for one in found.targets] == ["gpu"]
    found, _ = evaluated(tmp_path, cmake, ABC, defines={"CUDA_FOUND": "0"})
    assert [one.name for one in found.targets] == ["cpu"]


@pytest.mark.parametrize(("distro", "name"), [(None, "new"), ("indigo", "old")])
def test_distribution(tmp_path: Path, distro: str | None, name: str) -> None:
    ask = "execute_process(COMMAND rosversion -d OUTPUT_VARIABLE D OUTPUT_STRIP_TRAILING_WHITESPACE)\n"
    cmake = ask + "if(D STREQUAL indigo)\nadd_executable(old a.cpp)\nelse()\nadd_executable(new a.cpp)\nendif()"
    found, _ = evaluated(tmp_path, cmake, ABC, ros_distro=distro)
    assert [one.name for one in found.targets] == [name]


@pytest.mark.parametrize(("distro", "name"), [("noetic", "made"), ("iron", "other")])
def test_what_the_tools_of_catkin_give_is_known_before_catkin_is_found(tmp_path: Path, distro: str, name: str) -> None:
    cmake = "if(DEFINED CATKIN_DEVEL_PREFIX)\nadd_executable(made a.cpp)\nelse()\nadd_executable(other a.cpp)\nendif()"
    found, _ = evaluated(tmp_path, cmake, ABC, ros_distro=distro)
    assert [one.name for one in found.targets] == [name]


def test_target_properties(tmp_path: Path) -> None:
    cmake = """
add_definitions(-DALL -Wall)
include_directories(BEFORE inc)
add_library(lib STATIC a.cpp include/lib.h)
set_target_properties(lib PROPERTIES OUTPUT_NAME better COMPILE_DEFINITIONS "ONE;TWO=2")
target_include_directories(lib PUBLIC $<BUILD_INTERFACE:${CMAKE_CURRENT_SOURCE_DIR}/include> PRIVATE private $<INSTALL_INTERFACE:include>)
target_compile_definitions(lib PUBLIC -DPUB INTERFACE USERS)
add_library(alias::lib ALIAS lib)
add_library(objects OBJECT b.cpp)
add_library(headers INTERFACE)
add_library(given SHARED IMPORTED)
target_link_libraries(lib debug slow optimized fast PUBLIC headers)
"""
    files = {**ABC, "include/lib.h": "", "inc/x.h": "", "private/p.h": ""}
    found, workspace = evaluated(tmp_path, cmake, files)
    lib = target(found, "lib")
    folder = tmp_path / "demo"
    assert (lib.kind, lib.output_name, names(lib)) == ("static", "better", ["a.cpp"])
    assert [path.name for path in lib.headers] == ["lib.h"]
    assert lib.definitions == ("ALL", "ONE", "TWO=2", "PUB")
    assert lib.interface_definitions == ("PUB", "USERS")
    assert lib.include_dirs == (folder / "inc", folder / "include", folder / "private")
    assert lib.interface_include_dirs == (folder / "include",)
    assert lib.links == ("fast", "headers")
    assert found.target("alias::lib") == lib
    assert [target(found, name).kind for name in ("objects", "headers", "given")] == ["object", "interface", "imported"]
    assert (lib.line, lib.cmake_file) == (7, folder / "CMakeLists.txt")
    assert messages(workspace, tmp_path) == []


def test_subdirectory_include_and_module(tmp_path: Path) -> None:
    files = {
        **ABC,
        "cmake/more.cmake": "set(FROM_MODULE a.cpp)\n",
        "other.cmake": "set(FROM_FILE b.cpp)\n",
        "sub/CMakeLists.txt": "set(UP d.cpp PARENT_SCOPE)\nadd_library(inner d.cpp)\n",
    }
    cmake = (
        "set(CMAKE_MODULE_PATH ${PROJECT_SOURCE_DIR}/cmake)\ninclude(more)\ninclude(other.cmake)\ninclude(CTest)\n"
        "add_subdirectory(sub)\nadd_executable(x ${FROM_MODULE} ${FROM_FILE} sub/${UP})"
    )
    found, workspace = evaluated(tmp_path, cmake, files)
    assert names(target(found, "x")) == ["a.cpp", "b.cpp", "d.cpp"]
    assert names(target(found, "inner")) == ["d.cpp"]
    assert messages(workspace, tmp_path) == []


def test_parse_arguments(tmp_path: Path) -> None:
    cmake = """
function(make name)
  cmake_parse_arguments(P "FAST" "KIND" "SOURCES;LIBS" ${ARGN})
  if(P_FAST AND P_KIND STREQUAL exe)
    add_executable(${name} ${P_SOURCES})
    target_link_libraries(${name} ${P_LIBS})
  endif()
endfunction()
make(x FAST KIND exe SOURCES a.cpp b.cpp LIBS m)
"""
    found, _ = evaluated(tmp_path, cmake, ABC)
    assert (names(target(found, "x")), target(found, "x").links) == (["a.cpp", "b.cpp"], ("m",))


@pytest.mark.parametrize(
    "cmake",
    [
        "catkin_add_gtest(x a.cpp)",
        "add_rostest_gtest(x test/a.test a.cpp)",
        "if(CATKIN_ENABLE_TESTING)\nadd_executable(x a.cpp)\nendif()",
        "add_executable(x EXCLUDE_FROM_ALL a.cpp)\ntarget_link_libraries(x ${GTEST_LIBRARIES} gtest)",
        "add_executable(x a.cpp)\nadd_dependencies(tests x)",
    ],
)
def test_tests_are_no_executables(tmp_path: Path, cmake: str) -> None:
    found, _ = evaluated(tmp_path, cmake, ABC)
    assert (target(found, "x").kind, names(target(found, "x"))) == ("test", ["a.cpp"])


def test_generated_sources_are_not_missing(tmp_path: Path) -> None:
    cmake = (
        "qt5_wrap_cpp(MOC include/w.h)\nconfigure_file(c.in ${CMAKE_CURRENT_BINARY_DIR}/c.cpp)\n"
        "add_custom_command(OUTPUT made.cpp COMMAND x DEPENDS y)\nadd_executable(x a.cpp ${MOC} made.cpp ${CMAKE_CURRENT_BINARY_DIR}/c.cpp)"
    )
    found, workspace = evaluated(tmp_path, cmake, {**ABC, "include/w.h": "", "c.in": ""})
    assert names(target(found, "x")) == ["a.cpp"]
    assert messages(workspace, tmp_path) == []
    assert [one.output.name for one in found.configured] == ["c.cpp"]


@pytest.mark.parametrize(
    ("cmake", "message"),
    [
        ("foo(a)", "demo/CMakeLists.txt:4:1: unknown command foo"),
        ("add_executable(x a.cpp gone.cpp)", "demo/CMakeLists.txt:4:1: source of x does not exist: gone.cpp"),
        ("add_executable(x a.cpp .)", "demo/CMakeLists.txt:4:1: source of x is not a file: ."),
        ("if(AND)\nendif()\nif(a b)\nendif()", "demo/CMakeLists.txt:6:1: unexpected `b` in condition"),
        ("target_link_libraries(y m)", "demo/CMakeLists.txt:4:1: target_link_libraries: no target y"),
        ("add_subdirectory(none)", "demo/CMakeLists.txt:4:1: no CMakeLists.txt in sub-directory none"),
        ("include(none.cmake)", "demo/CMakeLists.txt:4:1: include file not found: none.cmake"),
        ("message(FATAL_ERROR no)", "demo/CMakeLists.txt:4:1: message(FATAL_ERROR): no"),
        ("while(ON)\nendwhile()", "demo/CMakeLists.txt:4:1: `while` left after 10000 rounds"),
        ("macro(m)\nm()\nendmacro()\nm()", "demo/CMakeLists.txt:5:1: CMake code nests too deeply, evaluation stopped"),
        ("include(CMakeLists.txt)", "demo/CMakeLists.txt:4:1: CMake code nests too deeply, evaluation stopped"),
        ('math(EXPR x "1 / 0")', "demo/CMakeLists.txt:4:1: math: cannot evaluate `1 / 0`"),
        ("add_message_files(FILES No.msg)", "demo/CMakeLists.txt:4:1: no file No.msg in msg"),
        ("string(ASCII 97 0 x)", "demo/CMakeLists.txt:4:1: string(ASCII): character with code 0 does not exist"),
        ("list(GET L 3 x)", "demo/CMakeLists.txt:4:1: list(GET): list index out of range"),
        (
            'string(REGEX MATCH "(" x y)',
            "demo/CMakeLists.txt:4:1: string(REGEX MATCH): bad regular expression `(`: missing )",
        ),
    ],
)
def test_trouble_is_reported_and_passed(tmp_path: Path, cmake: str, message: str) -> None:
    _, workspace = evaluated(tmp_path, cmake, ABC)
    assert messages(workspace, tmp_path)[-1] == message


@pytest.mark.parametrize(
    ("cmake", "column"),
    [
        ('add_executable(x a.cpp "b\0")', 26),
        ('aux_source_directory("b\0" x)', 24),
        ('file(GLOB x "b\0/*")', 15),
        ('file(READ "b\0" x)', 13),
        ('add_message_files(DIRECTORY "b\0")', 31),
        ('pluginlib_export_plugin_description_file(x "b\0.xml")', 46),
    ],
)
def test_zero_bytes_are_in_no_name(tmp_path: Path, cmake: str, column: int) -> None:
    found, workspace = evaluated(tmp_path, cmake + "\nadd_executable(kept a.cpp)", ABC)
    assert f"demo/CMakeLists.txt:4:{column}: a zero byte" in messages(workspace, tmp_path)
    assert names(target(found, "kept")) == ["a.cpp"]


def test_what_follows_trouble_still_counts(tmp_path: Path) -> None:
    cmake = "foo(a)\nif(a b)\nendif()\nmessage(FATAL_ERROR no)\nadd_executable(x a.cpp)\nadd_executable(y"
    found, workspace = evaluated(tmp_path, cmake, ABC)
    assert [one.name for one in found.targets] == ["x"]
    assert messages(workspace, tmp_path) == [
        "demo/CMakeLists.txt:4:1: unknown command foo",
        "demo/CMakeLists.txt:5:1: unexpected `b` in condition",
        "demo/CMakeLists.txt:7:1: message(FATAL_ERROR): no",
        "demo/CMakeLists.txt:9:17: syntax error: unexpected end of file, is a `)` missing?",
    ]


def test_not_utf8(tmp_path: Path) -> None:
    found, workspace = evaluated(tmp_path, "", {**ABC, "CMakeLists.txt": b"project(demo) # \xe9t\xe9\nadd_executable(x a.cpp)\n"})
    assert names(target(found, "x")) == ["a.cpp"]
    assert messages(workspace, tmp_path) == ["demo/CMakeLists.txt:1:17: not UTF-8"]


@pytest.mark.parametrize(
    ("expression", "value"), [("1 + 2 * 3", "7"), ("(1+2)*3", "9"), ("-7 / 2", "-3"), ("7 % 4", "3"), ("1 << 4 | 1", "17"), ("0x10", "16")]
)
def test_math(tmp_path: Path, expression: str, value: str) -> None:
    found, _ = evaluated(tmp_path, f'math(EXPR n "{expression}")\nadd_executable(x{value} a.cpp)\nadd_executable(y${{n}} a.cpp)', ABC)
    assert found.target(f"y{value}") is not None


@pytest.mark.parametrize(
    ("cmake", "programs", "said"),
    [
        ("add_library(core a.cpp)\ntool_binary(x SRCS b.cpp b.h)", ["x"], "unknown command tool_binary, taken for add_executable"),
        ("tool_binary(x SRCS absent.cpp)", [], "unknown command tool_binary"),
        ("tool_binary(x DEPENDS a)", [], "unknown command tool_binary"),
        ("tool_test_executable(x a.cpp)", [], "unknown command tool_test_executable"),
        ("add_executable(x a.cpp)\nadd_node(x b.cpp)", ["x"], "unknown command add_node"),
        ("describe(x a.cpp)", [], "unknown command describe"),
    ],
)
def test_a_command_of_an_absent_file_may_make_a_program(tmp_path: Path, cmake: str, programs: list[str], said: str) -> None:
    found, workspace = evaluated(tmp_path, cmake, {**ABC, "b.h": ""})
    assert [one.name for one in found.targets if one.kind == "executable"] == programs
    assert [text.partition(": ")[2] for text in messages(workspace, tmp_path)] == [said]


def test_a_program_of_an_unknown_command_may_use_the_libraries_of_its_package(tmp_path: Path) -> None:
    found, workspace = evaluated(tmp_path, "add_library(core a.cpp)\ntool_library(more SRCS c.cpp)\ntool_binary(x SRCS b.cpp)", ABC)
    assert names(target(found, "x")) == ["b.cpp"]
    assert target(found, "x").links == ("core", "more")
    assert [text.partition(": ")[2] for text in messages(workspace, tmp_path)] == [
        "unknown command tool_library, taken for add_library",
        "unknown command tool_binary, taken for add_executable",
    ]
