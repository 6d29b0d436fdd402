"""Python nodes of a workspace: which there are, how they begin, which modules they import."""

from __future__ import annotations

from pathlib import Path

from workspace_builder import manifest, messages, package, write

from rosarch.extractor.workspace import PYTHON_NODE, Component, components, discover
from rosarch.extractor.workspace.components import without_library

NODE = "#!/usr/bin/env python3\nimport rospy\nrospy.init_node('x')\n"
AMENT = "<build_type>ament_python</build_type>"


def nodes(root: Path, problems: list[str] | None = None) -> dict[str, Component]:
    """The Python nodes by name; `problems` gets what is said about them."""
    diagnostics = []  # type: ignore[var-annotated]
    workspace = discover(root)
    found = {one.name: one for one in components(workspace, diagnostics) if one.kind == PYTHON_NODE}
    if problems is not None:
        problems.extend(str(one).replace(f"{root}/", "") for one in diagnostics)
        problems.extend(messages(workspace, root))
    return found


def ament(root: Path, name: str, setup: str, files: dict[str, str]) -> None:
    """A package built with setuptools."""
    write(root / name, {"package.xml": manifest(name, export=AMENT), "setup.py": setup, **files})


def test_entry_points_of_setup_py(tmp_path: Path) -> None:
    setup = (
        "from setuptools import setup\npackage_name = 'demo'\n"
        "setup(name=package_name, packages=[package_name], entry_points={'console_scripts': [\n"
        "  'talk = demo.topics.talker:main',\n  f'listen = {package_name}.listener:run',\n  'plain = ' + package_name + '.plain:main',\n"
        "  'lost = demo.lost:main', unknown()]})\n"
    )
    files = {
        "demo/__init__.py": "",
        "demo/topics/__init__.py": "'''Topics.'''\n",
        "demo/topics/talker.py": "from rclpy.node import Node\nfrom .. import common\ndef main(): pass\n",
        "demo/common.py": "from demo import deeper\n",
        "demo/deeper.py": "VALUE = 1\n",
        "demo/listener.py": "import demo.common, rclpy\n",
        "demo/plain.py": "import os\n",
    }
    ament(tmp_path, "demo", setup, files)
    problems: list[str] = []
    found = nodes(tmp_path, problems)
    assert list(found) == ["listen", "talk"]
    assert found["talk"].executables == ("talk",)
    start = found["talk"].python
    assert start is not None
    assert (start.module, start.function, start.roots) == ("demo.topics.talker", "main", (tmp_path / "demo", tmp_path))
    assert dict(start.modules) == {
        "demo.topics.talker": tmp_path / "demo/demo/topics/talker.py",
        "demo.common": tmp_path / "demo/demo/common.py",
        "demo.deeper": tmp_path / "demo/demo/deeper.py",
    }
    assert found["listen"].sources == tuple(tmp_path / f"demo/demo/{name}.py" for name in ("listener", "common", "deeper"))
    assert problems == ["demo/setup.py:7:1: entry point lost: no module demo.lost in the package"]


def test_names_in_branches_that_are_given_one_value_are_known(tmp_path: Path) -> None:
    setup = (
        "import os\nif os.environ['ROS_VERSION'] == '1':\n  from distutils.core import setup\n  setup(packages=['demo'])\n"
        "else:\n  from setuptools import setup\n  name = 'demo'\n"
        "  setup(name=name, entry_points={'console_scripts': ['{}_node = {}.node:main'.format(name, name)]})\n"
    )
    ament(tmp_path, "demo", setup, {"demo/__init__.py": "", "demo/node.py": "import rclpy\ndef main(): rclpy.init()\n"})
    assert list(nodes(tmp_path)) == ["demo_node"]


def test_entry_points_of_setup_cfg_and_text(tmp_path: Path) -> None:
    cfg = "[develop]\nscript_dir=$base/lib/demo\n[options.entry_points]\nconsole_scripts =\n    talk = demo.talker:main\n"
    ament(tmp_path, "demo", "import setuptools\nsetuptools.setup()\n", {"setup.cfg": cfg, "demo/talker.py": "import rclpy\n"})
    text = "[console_scripts]\nhear = other.ear:Ear.main [x]\n[more]\nno = other.ear:main\n"
    ament(tmp_path, "other", f"from setuptools import setup\nsetup(entry_points={text!r})\n", {"other/ear.py": "import demo.talker\n"})
    problems: list[str] = []
    found = nodes(tmp_path, problems)
    assert list(found) == ["talk", "hear"]
    assert problems == []
    hear = found["hear"]
    assert hear.python is not None and hear.python.function == "Ear.main"
    assert hear.sources == (tmp_path / "other/other/ear.py",)
    assert hear.library_sources == (tmp_path / "demo/demo/talker.py",)


def test_entry_points_in_lists_of_lists_and_of_other_groups(tmp_path: Path) -> None:
    setup = (
        "setup(entry_points={'console_scripts': ['one = demo.a:main', ('two = demo.a:main', *['three = demo.a:main'])],\n"
        "  'gui_scripts': 'four = demo.a:main\\nfive = demo.a:main', 'robot.behaviours': ['wave = demo.a:Wave', 'none = demo.plain:No']})\n"
    )
    ament(tmp_path, "demo", setup, {"demo/a.py": "import rclpy\nclass Wave: pass\n", "demo/plain.py": "class No: pass\n"})
    assert sorted(nodes(tmp_path)) == ["five", "four", "one", "three", "two"]
    plugins = [one for one in components(discover(tmp_path)) if one.kind == "plugin"]
    assert [(one.name, one.entry_class, one.base_class, one.plugin_name) for one in plugins] == [
        ("Wave", "demo.a::Wave", "robot.behaviours", "wave")
    ]


def test_classes_that_descriptions_of_plugins_and_robots_name(tmp_path: Path) -> None:
    xml = '<library path="src"><class name="Dial" type="dials.dial.Dial" base_class_type="rqt_gui_py::Plugin"/></library>'
    robot = '<robot><!-- <plugin type="dials.dial.Old"/> -->\n<webots><plugin type="dials.driver.Driver"/><plugin type="other::Cxx"/></webots></robot>'
    package(
        tmp_path,
        "demo",
        "",
        {
            "plugin.xml": xml,
            "urdf/robot.urdf": robot,
            "src/dials/__init__.py": "",
            "src/dials/dial.py": "from .help import Helper\nclass Dial: pass\nclass Old: pass\n",
            "src/dials/help.py": "class Helper: pass\n",
            "src/dials/driver.py": "class Driver: pass\n",
        },
        export='<rqt_gui plugin="${prefix}/plugin.xml"/>',
    )
    workspace = discover(tmp_path)
    found = {one.name: one for one in components(workspace)}
    assert {name: (one.kind, one.entry_class, one.base_class) for name, one in found.items()} == {
        "Dial": ("plugin", "dials.dial::Dial", "rqt_gui_py::Plugin"),
        "Driver": ("plugin", "dials.driver::Driver", None),
    }
    assert [path.name for path in found["Dial"].sources] == ["dial.py", "help.py"]
    assert without_library(workspace) == ()


def test_scripts_that_cmake_installs(tmp_path: Path) -> None:
    cmake = (
        "catkin_install_python(PROGRAMS nodes/one.py nodes/defines.py DESTINATION x)\n"
        "install(PROGRAMS two.py shell DESTINATION lib/demo RENAME second)\n"
        "if(CATKIN_ENABLE_TESTING)\ncatkin_install_python(PROGRAMS test/three.py DESTINATION x)\nendif()\n"
    )
    files = {
        "nodes/one.py": NODE,
        "nodes/defines.py": "#!/usr/bin/env python\nimport rospy\ndef f(): pass\n",
        "two.py": NODE,
        "shell": "#!/bin/sh\n",
    }
    package(tmp_path, "demo", cmake, {**files, "test/three.py": NODE})
    found = nodes(tmp_path)
    assert {name: one.executables for name, one in found.items()} == {"one": ("one.py",), "second": ("second",)}
    start = found["one"].python
    assert start is not None and (start.file, start.module, start.function) == (tmp_path / "demo/nodes/one.py", "__main__", None)


def test_scripts_in_folders_that_cmake_installs(tmp_path: Path) -> None:
    cmake = (
        "project(demo)\ninstall(DIRECTORY scripts/ USE_SOURCE_PERMISSIONS DESTINATION lib/${PROJECT_NAME})\n"
        "install(DIRECTORY launch python DESTINATION share/demo)\n"
    )
    node = NODE.replace("rospy", "rclpy")
    files = {
        "scripts/a.py": node,
        "scripts/more/b": node,
        "scripts/module.py": "import rclpy\n",
        "scripts/c.sh": "#!/bin/sh\n",
        "launch/d.py": node,
    }
    write(
        tmp_path / "demo",
        {"package.xml": manifest("demo", export="<build_type>ament_cmake</build_type>"), "CMakeLists.txt": cmake, **files},
    )
    assert {name: one.executables for name, one in nodes(tmp_path).items()} == {"a": ("a.py",), "b": ("b",)}


def test_scripts_that_are_started_by_hand(tmp_path: Path) -> None:
    files = {
        "scripts/probe.py": "import rclpy\nfrom tools import X\nrclpy.init()\n",
        "scripts/tools.py": "import rclpy\nX = 1\n",
        "scripts/unused.py": "import rclpy\n",
        "test/tested.py": "import rclpy\nrclpy.init()\n",
    }
    ros2 = manifest("demo", export="<build_type>ament_cmake</build_type>")
    write(tmp_path / "demo", {"package.xml": ros2, "CMakeLists.txt": "project(demo)\n", **files})
    found = nodes(tmp_path)
    assert {name: one.executables for name, one in found.items()} == {"probe": ()}
    assert [path.name for path in found["probe"].sources] == ["probe.py", "tools.py"]


def test_modules_in_a_folder_that_packages_lie_in(tmp_path: Path) -> None:
    setup = "from setuptools import setup\nsetup(packages=['demo'], entry_points={'console_scripts': ['run = demo.run:main']})\n"
    ament(
        tmp_path / "src",
        "demo",
        setup,
        {"demo/run.py": "import rclpy\nfrom lib.motors.wheel import Wheel\nimport absent.wheel\ndef main(): pass\n"},
    )
    write(tmp_path, {"src/lib/motors/wheel.py": "class Wheel: pass\n", "absent/__init__.txt": ""})
    (found,) = nodes(tmp_path).values()
    assert [path.name for path in (*found.sources, *found.library_sources)] == ["run.py", "wheel.py"]


def test_scripts_that_rosrun_finds(tmp_path: Path) -> None:
    package(
        tmp_path,
        "demo",
        "catkin_python_setup()",
        {
            "setup.py": "d = generate_distutils_setup(packages=['lib'], package_dir={'': 'src'})\nsetup(**d)\n",
            "scripts/run.py": "#!/usr/bin/python\nfrom lib.core import *\nimport beside\nif __name__ == '__main__':\n    main()\n",
            "scripts/beside.py": "X = 1\n",
            "scripts/bare": NODE,
            "scripts/no_ros.py": "#!/usr/bin/env python\nprint(1)\n",
            "scripts/no_first_line.py": "import rospy\nrospy.init_node('x')\n",
            "src/lib/__init__.py": "",
            "src/lib/core.py": "import rospy\n",
            "test/tested.py": NODE,
            "old.py": "#!/usr/bin/env python2\nimport rospy, os\nfrom beside import (X,\n Y)\nif __name__ == '__main__':\n    print 'x'\n",
        },
    )
    (tmp_path / "demo/scripts/linked").symlink_to("bare")
    found = nodes(tmp_path)
    by_hand = {"no_first_line": ()}  # no program of the package, but `python no_first_line.py` runs it
    started = {"bare": ("bare", "linked"), "old": ("old.py",), "run": ("run.py",)}
    assert {name: one.executables for name, one in found.items()} == {**started, **by_hand}
    assert [path.name for path in found["run"].sources] == ["run.py", "core.py", "beside.py"]


def test_what_is_put_into_the_dictionary_of_a_setup_file(tmp_path: Path) -> None:
    package(
        tmp_path,
        "demo",
        "catkin_python_setup()",
        {
            "setup.py": "d = generate_distutils_setup()\nd['packages'] = ['lib']\nd['package_dir'] = {'': 'src'}\nsetup(**d)\n",
            "nodes/run.py": f"{NODE}import lib.core\n",
            "src/lib/__init__.py": "",
            "src/lib/core.py": "import rospy\n",
        },
    )
    assert [path.name for path in nodes(tmp_path)["run"].sources] == ["run.py", "core.py"]


def test_scripts_among_the_data_files_of_a_setup_file(tmp_path: Path) -> None:
    setup = (
        "import os, xml.etree.ElementTree as ET\nfrom glob import glob\npackage = ET.parse('package.xml').getroot()\n"
        "name = package.find('name').text\n"
        "setup(name=name, data_files=[(f'lib/{name}', glob('scripts/*.py')), (os.path.join('lib', name), ['tools/panel']),\n"
        "  (f'share/{name}/launch', glob('launch/*.py')), *more()])\n"
    )
    script = NODE.replace("rospy", "rclpy")
    ament(tmp_path, "demo", setup, {"scripts/a.py": script, "tools/panel": script, "tools/b.py": script, "launch/c.py": script})
    assert {name: one.executables for name, one in nodes(tmp_path).items()} == {"a": ("a.py",), "panel": ("panel",)}


def test_nothing_is_run_without_being_installed_in_ros_2(tmp_path: Path) -> None:
    files = {"scripts/a.py": NODE.replace("rospy", "rclpy"), "scripts/b.py": NODE.replace("rospy", "rclpy")}
    cmake = "project(demo)\nament_python_install_package(lib PACKAGE_DIR python/lib)\ninstall(PROGRAMS scripts/a.py DESTINATION lib/demo)\n"
    write(
        tmp_path / "demo",
        {"package.xml": manifest("demo", export="<build_type>ament_cmake</build_type>"), "CMakeLists.txt": cmake, **files},
    )
    found = nodes(tmp_path)
    assert list(found) == ["a"]
    assert found["a"].python is not None
    assert found["a"].python.roots == (tmp_path / "demo/scripts", tmp_path / "demo/python", tmp_path)


def test_a_node_and_a_script_of_one_name(tmp_path: Path) -> None:
    package(tmp_path, "demo", "add_executable(talk talk.cpp)", {"talk.cpp": "int main() {}\n", "scripts/talk.py": NODE})
    problems: list[str] = []
    found = nodes(tmp_path, problems)
    assert {name: one.executables for name, one in found.items()} == {"talk_2": ("talk.py",)}
    assert problems == ["demo/package.xml:1:1: demo has another component talk; that of python_node is called talk_2"]


def test_broken_setup_files(tmp_path: Path) -> None:
    ament(tmp_path, "a", "setup(entry_points=\n", {"setup.cfg": "no section\n"})
    ament(tmp_path, "b", "setup(entry_points={'console_scripts': 3, **more}, package_dir=3, scripts=['none'])\n", {})
    problems: list[str] = []
    assert nodes(tmp_path, problems) == {}
    assert problems == ["a/setup.cfg:1:1: not read: no section or key and value", "a/setup.py:1:6: not read: '(' was never closed"]


def test_a_package_deeper_than_its_folder(tmp_path: Path) -> None:
    """Nothing lies above the root of the file system."""
    setup = f"package_dir={{'{'a.' * 300}inner': 'inner', '': 'src'}}, entry_points={{'console_scripts': ['talk = lib.talk:main']}}"
    ament(tmp_path, "deep", f"setup({setup})\n", {"src/lib/__init__.py": "", "src/lib/talk.py": f"def main():\n    pass\n\n\n{NODE}"})
    problems: list[str] = []
    assert list(nodes(tmp_path, problems)) == ["talk"]
    assert problems == []
