"""Packages are found as rospkg finds them, and the crawl ends."""

from __future__ import annotations

import os
from pathlib import Path

from rosarch.extractor.launch import Files, PackagePath


def package(folder: Path, name: str, more: str = "") -> Path:
    folder.mkdir(parents=True, exist_ok=True)
    (folder / "package.xml").write_text(f"<package><name>{name}</name>{more}</package>")
    return folder


def test_first_folder_wins(tmp_path: Path) -> None:
    overlay = package(tmp_path / "overlay" / "a", "a")
    package(tmp_path / "underlay" / "a", "a")
    other = package(tmp_path / "underlay" / "b", "b")
    path = PackagePath([tmp_path / "overlay", tmp_path / "underlay", tmp_path / "missing"])
    assert (path.find("a"), path.find("b"), path.find("c")) == (str(overlay), str(other), None)


def test_first_name_wins_within_a_folder(tmp_path: Path) -> None:
    package(tmp_path / "z", "a")
    first = package(tmp_path / "deep" / "er", "a")
    assert PackagePath([tmp_path]).packages == {"a": str(first)}


def test_what_is_no_package(tmp_path: Path) -> None:
    package(tmp_path / "meta", "meta", "<export><metapackage/></export>")
    package(tmp_path / "commented", "commented", "<!-- <metapackage/> -->")
    package(tmp_path / "ignored", "ignored")
    (tmp_path / "ignored" / "CATKIN_IGNORE").touch()
    package(tmp_path / ".hidden", "hidden")
    package(tmp_path / "commented" / "inner", "inner")
    package(tmp_path / "commented" / "templates", "made")
    package(tmp_path / "commented" / "copy", "zone")
    package(tmp_path / "zone", "zone")
    package(tmp_path / "stop" / "below", "below")
    (tmp_path / "stop" / "rospack_nosubdirs").touch()
    (tmp_path / "nameless").mkdir()
    (tmp_path / "nameless" / "package.xml").write_text("<package/>")
    (tmp_path / "dry").mkdir()
    (tmp_path / "dry" / "manifest.xml").write_text("<package/>")
    (tmp_path / "colcon").mkdir()
    package(tmp_path / "colcon" / "kept", "kept")
    (tmp_path / "colcon" / "COLCON_IGNORE").touch()
    assert sorted(PackagePath([tmp_path]).packages) == ["commented", "dry", "inner", "kept", "zone"]
    assert PackagePath([tmp_path]).find("zone") == str(tmp_path / "zone")


def test_copies_that_are_built_or_installed_in_a_package_are_no_files_of_it(tmp_path: Path) -> None:
    folder = package(tmp_path / "a", "a")
    for name in ("launch/x.launch.py", "install/a/share/a/launch/x.launch.py", "install/COLCON_IGNORE", "build/y", "build/COLCON_IGNORE"):
        (folder / name).parent.mkdir(parents=True, exist_ok=True)
        (folder / name).touch()
    path = PackagePath([tmp_path])
    assert path.paths_in(str(folder)) == {"package.xml": [f"{folder}/package.xml"], "x.launch.py": [f"{folder}/launch/x.launch.py"]}


def test_links_and_special_files(tmp_path: Path) -> None:
    elsewhere = package(tmp_path / "elsewhere" / "linked", "linked")
    workspace = tmp_path / "workspace"
    workspace.mkdir()
    (workspace / "link").symlink_to(elsewhere)
    (workspace / "outside").symlink_to(package(tmp_path / "outside" / "hidden", "hidden"))
    (workspace / "loop").symlink_to(workspace)
    (workspace / "dangling").symlink_to(tmp_path / "none")
    (workspace / "fifo").mkdir()
    os.mkfifo(workspace / "fifo" / "package.xml")
    assert PackagePath([workspace]).packages == {}
    assert PackagePath([workspace, elsewhere.parent]).packages == {"linked": str(workspace / "link")}


def test_of_two_packages_of_one_name_the_nearest_one_is_meant(tmp_path: Path) -> None:
    first = package(tmp_path / "catkin_ws" / "racing", "racing")
    second = package(tmp_path / "colcon_ws" / "racing", "racing")
    other = package(tmp_path / "colcon_ws" / "track", "track")
    path = PackagePath([tmp_path])
    assert path.find("racing") == str(first)
    assert path.near(f"{other}/launch/x.launch.py").find("racing") == str(second)
    assert path.near(f"{first}/launch/x.launch") is path


def test_a_folder_that_a_program_of_the_package_makes(tmp_path: Path) -> None:
    folder = package(tmp_path / "robot", "robot")
    for name, text in {
        "config/one/robot.yaml": "",
        "scripts/make.py": "import os\nos.makedirs(os.path.join(top, 'config', 'temp'))\n",
    }.items():
        (folder / name).parent.mkdir(parents=True, exist_ok=True)
        (folder / name).write_text(text)
    path = PackagePath([tmp_path])
    made, absent = f"{folder}/config/temp/one/robot.yaml", f"{folder}/config/other/one/robot.yaml"
    assert (path.makes(made), path.makes(absent), path.makes(f"{folder}/config/temp.yaml")) == (True, False, False)
    files = Files(path)
    # not another file of the package that is called so
    assert (files.located(made), files.located(absent)) == (made, f"{folder}/config/one/robot.yaml")
