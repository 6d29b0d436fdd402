"""What the build files of packages of ROS 2 install, and where they are not understood."""

from __future__ import annotations

from pathlib import Path

import pytest
from workspace_builder import manifest, write

from rosarch.extractor.workspace import discover
from rosarch.extractor.workspace.built import Built, builds, package_of

HEAD = "cmake_minimum_required(VERSION 3.8)\nproject(demo)\nfind_package(ament_cmake REQUIRED)\n"
FILES = {
    "launch/a.launch.py": "",
    "launch/old/b.launch.py": "",
    "config/a.yaml": "",
    "config/a.txt": "",
    "node.cpp": "int main() {}\n",
    "tool.py": "#!x",
}


def cmake(root: Path, text: str, files: dict[str, str] | None = None) -> Built:
    """The build of a package with these commands."""
    export = "<build_type>ament_cmake</build_type>"
    content = {
        "package.xml": manifest("demo", export=export),
        "CMakeLists.txt": HEAD + text + "\nament_package()\n",
        **FILES,
        **(files or {}),
    }
    write(root / "demo", content)
    (found,) = builds(discover(root))
    return found


def python(root: Path, setup: str, files: dict[str, str] | None = None) -> Built:
    """The build of a package with this `setup.py`."""
    export = "<build_type>ament_python</build_type>"
    write(root / "demo", {"package.xml": manifest("demo", export=export), "setup.py": setup, **FILES, **(files or {})})
    (found,) = builds(discover(root))
    return found


SHARED = [
    ("install(DIRECTORY launch config DESTINATION share/${PROJECT_NAME})", {"launch/a.launch.py", "launch/old/b.launch.py", "config/a.yaml", "config/a.txt"}),
    ("install(DIRECTORY launch/ DESTINATION ${CMAKE_INSTALL_PREFIX}/share/demo/launch)", {"launch/a.launch.py", "launch/old/b.launch.py"}),
    ("install(DIRECTORY launch DESTINATION share/demo PATTERN old EXCLUDE)", {"launch/a.launch.py"}),
    ("install(DIRECTORY config DESTINATION share/demo FILES_MATCHING PATTERN *.yaml)", {"config/a.yaml"}),
    ("install(DIRECTORY config DESTINATION share/demo FILES_MATCHING REGEX [.]txt)", {"config/a.yaml", "config/a.txt"}),
    ("install(DIRECTORY . DESTINATION share/demo PATTERN launch EXCLUDE)", {"config/a.yaml", "config/a.txt"}),
    ("install(FILES config/a.yaml DESTINATION share/demo/config)", {"config/a.yaml"}),
    ("install(FILES config/a.txt DESTINATION share/demo/config RENAME a.yaml)", {"config/a.yaml"}),
    ("install(DIRECTORY config DESTINATION share/other)", set()),
    ("foreach(dir launch config)\ninstall(DIRECTORY ${dir} DESTINATION share/demo)\nendforeach()", {"launch/a.launch.py", "launch/old/b.launch.py", "config/a.yaml", "config/a.txt"}),
    ("find_package(ament_cmake_auto)\nament_auto_package(INSTALL_TO_SHARE config)", {"config/a.yaml", "config/a.txt"}),
    ("include(GNUInstallDirs)\ninstall(DIRECTORY config DESTINATION ${CMAKE_INSTALL_DATADIR}/demo)", {"config/a.yaml", "config/a.txt"}),
    ("if(UNIX)\nelseif(BUILD_TESTING)\nadd_subdirectory(test)\nendif()", set()),
    ("pluginlib_export_plugin_description_file(base config/a.txt)", set()),
    ("set(CMAKE_INSTALL_PREFIX out CACHE PATH text)\ninstall(DIRECTORY config DESTINATION ${CMAKE_INSTALL_PREFIX}/share/demo)", {"config/a.yaml", "config/a.txt"}),
]  # fmt: skip


@pytest.mark.parametrize(("text", "expected"), SHARED)
def test_files_in_the_share_folder(tmp_path: Path, text: str, expected: set[str]) -> None:
    found = cmake(tmp_path, text)
    assert found.unsure == ()
    asked = ("launch/a.launch.py", "launch/old/b.launch.py", "config/a.yaml", "config/a.txt")
    assert {path for path in asked if found.brings(f"share/demo/{path}")} == expected
    assert found.brings("share/demo/package.xml")
    assert found.brings("share/demo/a.txt") == ("pluginlib" in text)


@pytest.mark.parametrize(
    ("text", "reason"),
    [
        ("if(UNKNOWN)\ninstall(DIRECTORY config DESTINATION share/demo)\nendif()", "install() under a condition"),
        ("if(UNIX)\nelse()\nforeach(x a)\ninstall(FILES ${x} DESTINATION b)\nendforeach()\nendif()", "install() under a condition"),
        ("foreach(dir ${FOLDERS})\ninstall(DIRECTORY ${dir} DESTINATION share/demo)\nendforeach()", "install() under a condition"),
        ("install(DIRECTORY ${FOLDERS} DESTINATION share/demo)", "install() with something that is not known"),
        ('install(CODE "file(COPY x DESTINATION y)")', "install() with something that is not known"),
        ("install(FILES x TYPE DATA)", "install() with something that is not known"),
        ("install_all(config)", "unknown command install_all"),
        ("autoware_ament_auto_package()", "autoware_ament_auto_package()"),
        ("ament_python_install_package(demo SCRIPTS_DESTINATION lib/demo)", "scripts of a Python package"),
        ("ament_auto_package(INSTALL_TO_SHARE ${FOLDERS})", "ament_auto_package() with something that is not known"),
        ("add_executable(node node.cpp)\nreturn()", "return() before the end"),
        ("set(CMAKE_INSTALL_PREFIX ${CMAKE_SOURCE_DIR}/out)\ninstall(FILES a DESTINATION bin)", "CMAKE_INSTALL_PREFIX is set"),
        ("install(FILES a DESTINATION bin)\nset(CMAKE_INSTALL_PREFIX out CACHE PATH text FORCE)", "CMAKE_INSTALL_PREFIX is set"),
    ],
)
def test_what_is_not_understood(tmp_path: Path, text: str, reason: str) -> None:
    assert [unsure.reason for unsure in cmake(tmp_path, text).unsure] == [reason]


def test_programs_of_cmake(tmp_path: Path) -> None:
    text = (
        "add_executable(node node.cpp)\nadd_executable(other node.cpp)\nadd_executable(lost node.cpp)\nset_target_properties(node PROPERTIES OUTPUT_NAME named)\n"
        "install(TARGETS node other ARCHIVE DESTINATION lib RUNTIME DESTINATION lib/${PROJECT_NAME})\ninstall(TARGETS lost DESTINATION bin)\n"
        "install(PROGRAMS tool.py DESTINATION lib/demo RENAME tool)\nadd_library(part SHARED node.cpp)\n"
        'rclcpp_components_register_node(part PLUGIN "demo::Part" EXECUTABLE part_node)\n'
        "find_package(ament_cmake_auto)\nament_auto_add_executable(auto node.cpp)\nament_auto_package()\n"
    )
    found = cmake(tmp_path, text)
    assert found.programs == {"named", "other", "tool", "part_node", "auto"}
    assert found.unsure == ()


@pytest.mark.parametrize(
    ("text", "plain"),
    [
        ("install(FILES tool.py DESTINATION lib/demo)", True),
        ("install(DIRECTORY scripts/ DESTINATION lib/demo)", True),
        ("install(DIRECTORY scripts DESTINATION lib/demo PATTERN *.txt EXCLUDE)", True),
        ("install(DIRECTORY scripts/ DESTINATION lib/demo USE_SOURCE_PERMISSIONS)", False),
        ("install(FILES tool.py DESTINATION lib/demo PERMISSIONS OWNER_READ OWNER_EXECUTE)", False),
        ("install(DIRECTORY scripts/ DESTINATION lib/demo DIRECTORY_PERMISSIONS OWNER_EXECUTE)", True),
        ("install(PROGRAMS tool.py DESTINATION lib/demo)\ninstall(FILES tool.py DESTINATION share/demo)", False),
        ("install(FILES tool.py DESTINATION share/demo)", False),  # a program of ROS 2 is not looked for there
        ("install(FILES other.py DESTINATION lib/demo)", False),
    ],
)
def test_programs_that_are_copied_as_files(tmp_path: Path, text: str, plain: bool) -> None:
    found = cmake(tmp_path, text, {"scripts/tool.py": "#!/usr/bin/env python3", "scripts/a.txt": ""})
    assert any(found.copied_plainly("tool.py")) == plain


def test_programs_of_ros_1_below_the_share_folder(tmp_path: Path) -> None:
    text = "cmake_minimum_required(VERSION 3.5)\nproject(demo)\nfind_package(catkin REQUIRED)\ncatkin_package()\n{}(FILES tool.py DESTINATION ${{CATKIN_PACKAGE_SHARE_DESTINATION}})"
    write(tmp_path / "demo", {"package.xml": manifest("demo"), "CMakeLists.txt": text.format("install")})
    (found,) = builds(discover(tmp_path))
    assert [line for _, line in found.copied_plainly("tool.py")] == [5]


SETUP = """from setuptools import setup
from glob import glob
import os
package_name = 'demo'
files = [('share/' + package_name, ['package.xml'])]
setup(name=package_name, data_files=[('share/' + package_name, ['package.xml']), (os.path.join('share', package_name, 'launch'), glob('launch/*.py')),
      ('lib/demo', ['tool.py']), {more}], {other} entry_points={{'console_scripts': ['cook = demo.cook:main']}})
"""


def test_data_files(tmp_path: Path) -> None:
    found = python(tmp_path, SETUP.format(more="('share/demo/x', ['config/a.yaml'] + [])", other=""))
    asked = ("package.xml", "launch/a.launch.py", "launch/old/b.launch.py", "config/a.yaml", "x/a.yaml")
    assert {path for path in asked if found.brings(f"share/demo/{path}")} == {"package.xml", "launch/a.launch.py", "x/a.yaml"}
    assert found.programs == {"cook", "tool.py"}
    assert found.unsure == ()


def test_files_that_are_not_known_may_be_any_of_their_folder(tmp_path: Path) -> None:
    found = python(tmp_path, SETUP.format(more="('share/demo/config', find('config'))", other=""))
    assert found.brings("share/demo/config/a.yaml")
    assert not found.brings("share/demo/maps/a.yaml")
    assert found.unsure == ()


@pytest.mark.parametrize(
    ("setup", "reason"),
    [
        (SETUP.format(more="*find('config')", other=""), "data_files that are not known"),
        (SETUP.format(more="entry('config')", other=""), "data_files that are not known"),
        (SETUP.format(more="(share(), ['config/a.yaml'])", other=""), "data_files of a folder that is not known"),
        (SETUP.format(more="", other="**more,"), "what is given to setup() in another way"),
        (SETUP.format(more="", other="cmdclass={'install': Install},"), "what is given to setup() in another way"),
        (SETUP.format(more="", other="scripts=find('bin'),"), "scripts that are not known"),
        ("from setuptools import setup\nfiles = []\nfiles += find()\nsetup(data_files=files)\n", "what is given to setup() in another way"),
        (
            "from setuptools import setup\nsetup(entry_points={'console_scripts': ['a = b:c', *find()]})\n",
            "entry points that are not known",
        ),
        ("from setuptools import setup\nif x:\n    setup()\nelse:\n    setup(name='demo')\n", "not one call of setup()"),
        ("(", "not read: '(' was never closed"),
    ],
)
def test_setups_that_are_not_understood(tmp_path: Path, setup: str, reason: str) -> None:
    assert reason in {unsure.reason for unsure in python(tmp_path, setup).unsure}


def test_other_files_may_say_what_is_installed(tmp_path: Path) -> None:
    found = python(tmp_path, SETUP.format(more="", other=""), {"setup.cfg": "[options.data_files]\nshare/demo = a\n"})
    assert [unsure.reason for unsure in found.unsure] == ["options.data_files in setup.cfg"]
    assert package_of(f"{tmp_path}/demo/config/a.yaml", [found]) is found
    assert package_of(f"{tmp_path}/demolished", [found]) is None


POINTS = """from setuptools import {find}setup
setup(name='demo', packages={packages}, entry_points={{'console_scripts': ['a = {target}']}})
"""
MODULES = {
    "demo/__init__.py": "",
    "demo/a.py": "from demo.b import run\nif x:\n    def main(): pass\nelse:\n    other = 1\nclass Node:\n    pass\n",
    "demo/star.py": "from demo.a import *\n",
    "demo/made.py": "globals()['main'] = 1\n",
    "demo/fast.cpython.so": "",
    "demo/inner/part.py": "def main(): pass\n",
    "demo/full/__init__.py": "def main(): pass\n",
}


@pytest.mark.parametrize(
    ("target", "packages", "expected"),
    [
        *((target, "['demo']", []) for target in ("demo.a:main", "demo.a:other", "demo.a:run", "demo.a:Node.start", "demo.star:main")),
        *((target, "['demo']", []) for target in ("demo.made:main", "demo.fast:main", "elsewhere.a:main", "single:main")),
        ("demo.b:main", "['demo']", ["module"]),
        ("demo.a:man", "['demo']", ["function"]),
        ("demo.inner.part:main", "['demo']", ["left-out"]),
        ("demo.inner.part:main", "['demo', 'demo.inner']", []),
        ("demo.inner.part:main", "find_packages(exclude=['test'])", ["left-out"]),
        ("demo.full:main", "find_packages()", []),
        ("demo.inner.part:main", "find_packages('demo')", []),
        ("demo.inner.part:main", "listed()", []),
    ],
)
def test_entry_points_without_code(tmp_path: Path, target: str, packages: str, expected: list[str]) -> None:
    found = python(tmp_path, POINTS.format(find="find_packages, ", packages=packages, target=target), MODULES)
    assert [lack.what for lack in found.lacks] == expected


def test_of_setups_that_are_not_understood_no_entry_point_is_told(tmp_path: Path) -> None:
    setup = POINTS.format(find="", packages="['demo']", target="demo.b:main").replace("name='demo'", "**more")
    assert python(tmp_path, setup, MODULES).lacks == ()
    (tmp_path / "demo" / "setup.py").write_text(setup.replace("**more", "name='demo'"))
    (tmp_path / "demo" / "demo" / "__init__.py").write_text("__path__ = __import__('pkgutil').extend_path(__path__, __name__)\n")
    assert [one.lacks for one in builds(discover(tmp_path))] == [()]


def test_a_checkout_may_be_without_what_is_no_text(tmp_path: Path) -> None:
    found = python(tmp_path, SETUP.format(more="('share/demo', ['config/gone.yaml', 'config/arm.stl', 'config/eye.png'])", other=""))
    assert [(one.kind, one.about) for one in found.obstacles] == [("install source", "config/gone.yaml")]
