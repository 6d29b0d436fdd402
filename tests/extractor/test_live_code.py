"""What is a fact of a component: the code of functions that its start mentions."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path

import pytest
from workspace_builder import package, write

from rosarch.extractor.pipeline import extract
from rosarch.extractor.settings import Settings

Live = Callable[..., set[str]]

OBJECT = {"Child::Child", "Child::~Child", "Child::act", "Child::late", "Base::Base", "Base::act"}


@pytest.fixture
def live(tmp_path: Path) -> Live:
    """The names of the functions with code among the facts of a node of some sources."""

    def names(source: str, **more: str) -> set[str]:
        files = {"node.cpp": source, **{f"{name}.cpp": text for name, text in more.items()}}
        package(tmp_path, "demo", f"add_executable(node {' '.join(files)})\n", files)
        with extract(tmp_path, settings=Settings(jobs=1)) as extraction:
            (component,) = extraction.components
            rows = component.rows()
        bodies = {function for _, function in rows["block"]}
        assert {function for _, function in rows["expr_function"]} <= bodies
        return {str(name) for function, name in rows["function_name"] if function in bodies}

    return names


@pytest.mark.slow
@pytest.mark.parametrize(
    ("body", "used"),
    [
        ("first();", {"first", "second"}),
        ("auto f = [] { first(); };", {"first", "second", "lambda"}),
        ("void (*f)() = &second;", {"second"}),
        ("Child* child = nullptr;", {*OBJECT, "first", "second"}),
        ("Holder holder;", {*OBJECT, "first", "second"}),
        ("Base& base = make(); base.act();", {"make", *OBJECT, "first", "second"}),
        ("Only::helper();", {"Only::helper"}),
        ("wrap<Only>();", {"wrap", "Only::helper", "Only::unused"}),
        ("", set()),
    ],
)  # fmt: skip
def test_what_is_mentioned(live: Live, body: str, used: set[str]) -> None:
    code = """
        void second() {}
        void first() { second(); }
        struct Base { Base() {} virtual void act() {} };
        struct Child : Base { Child() {} ~Child() {} void act() override { late(); } void late() { first(); } };
        struct Holder { Child child; };
        struct Only { static void helper() {} static void unused() {} };
        template <class T> void wrap() { T::helper(); }
        Base& make() { static Base* base = nullptr; return *base; }
    """
    assert live(f"{code} int main() {{ {body} }}") == {"main", *used}


def test_what_another_source_defines(live: Live) -> None:
    assert live("void far(); int main() { far(); }", other="void near() {} void far() { near(); }\nvoid lost() {}") == {
        "main",
        "far",
        "near",
    }


def test_what_overrides_a_function_of_another_source(live: Live) -> None:
    header = "struct Base { virtual void act(); }; Base& make();\n"
    other = f"{header} void Base::act() {{}} struct Child : Base {{ void act() override {{}} void own() {{}} }}; Base& make() {{ static Child c; return c; }}"
    assert live(f"{header} int main() {{ make().act(); }}", other=other) == {"main", "make", "Base::act", "Child::act", "Child::own"}


def test_code_outside_of_functions_runs(live: Live) -> None:
    code = "struct Registry { Registry(int) { note(); } void note() {} }; int ask() { return 1; } static Registry registry(ask()); struct Lost { void lost() {} };"
    assert live(f"{code} int main() {{}}") == {"main", "Registry::Registry", "Registry::note", "ask"}


def test_a_library_makes_the_plugin(tmp_path: Path) -> None:
    source = """
        #include <nodelet/nodelet.h>
        #include <pluginlib/class_list_macros.h>
        void helper() {}
        void lost() {}
        struct Filter : nodelet::Nodelet { void onInit() override { helper(); } };
        PLUGINLIB_EXPORT_CLASS(Filter, nodelet::Nodelet)
    """
    plugins = '<library path="lib/libfilter"><class name="demo/filter" type="Filter" base_class_type="nodelet::Nodelet"/></library>'
    package(tmp_path, "demo", "add_library(filter filter.cpp)\n", {"filter.cpp": source, "nodelets.xml": plugins}, export='<nodelet plugin="${prefix}/nodelets.xml"/>')  # fmt: skip
    with extract(tmp_path, settings=Settings(jobs=1)) as extraction:
        (component,) = extraction.components
        rows = component.rows()
    bodies = {function for _, function in rows["block"]}
    assert {"Filter::onInit", "helper"} <= {name for function, name in rows["function_name"] if function in bodies}
    assert "lost" in {name for _, name in rows["function_name"]}
    assert "lost" not in {name for function, name in rows["function_name"] if function in bodies}


def test_python(tmp_path: Path) -> None:
    code = """
import rospy
def helper(): pass
def lost(): rospy.sleep(1)
class Base(object):
    def act(self): self.later()
class Child(Base):
    def later(self): helper()
class Other(object):
    def never(self): lost()
def main():
    Child().act()
if __name__ == '__main__':
    main()
"""
    package(tmp_path, "demo", "catkin_install_python(PROGRAMS scripts/node.py DESTINATION lib)\n")
    write(tmp_path, {"demo/scripts/node.py": "#!/usr/bin/env python\n" + code})
    (tmp_path / "demo/scripts/node.py").chmod(0o755)
    with extract(tmp_path, settings=Settings(jobs=1)) as extraction:
        (component,) = extraction.components
        rows = component.rows()
    bodies = {function for _, function in rows["block"]}
    found = {str(name).rpartition("::")[2] for function, name in rows["function_name"] if function in bodies}
    assert {"main", "act", "later", "helper"} <= found
    assert not found & {"lost", "never"}


def test_all_of_a_library_may_be_called(tmp_path: Path) -> None:
    source = "#include <ros/ros.h>\nclass Api {\n public:\n  void start() { inner(); }\n\n private:\n  void inner() { ros::spinOnce(); }\n};\nvoid use(Api& api) { api.start(); }"
    package(tmp_path, "demo", "add_library(api api.cpp)\n", {"api.cpp": source})
    with extract(tmp_path, settings=Settings(jobs=1)) as extraction:
        (component,) = extraction.components
        rows = component.rows()
    bodies = {function for _, function in rows["block"]}
    assert (
        component.kind,
        {"Api::start", "Api::inner", "use"} - {str(name) for function, name in rows["function_name"] if function in bodies},
    ) == (
        "library",
        set(),
    )
