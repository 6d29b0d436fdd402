"""The macros of catkin, ament, genmsg, rosidl, dynamic_reconfigure, gtest, Qt.

Sources: https://docs.ros.org/en/kinetic/api/catkin/html/dev_guide/generated_cmake_api.html, ament_cmake user documentation,
https://wiki.ros.org/dynamic_reconfigure, cmake-qt(7).
"""

from __future__ import annotations

import os
from functools import partial

from rosarch.extractor.workspace.cmake_glob import glob
from rosarch.extractor.workspace.cmake_state import Call
from rosarch.extractor.workspace.commands_find import exported, find_one
from rosarch.extractor.workspace.commands_targets import add_target, find_target
from rosarch.extractor.workspace.commands_values import parse_keywords
from rosarch.extractor.workspace.evaluator import Evaluator, command
from rosarch.extractor.workspace.installs import copied, installing
from rosarch.extractor.workspace.model import EXECUTABLE, INTERFACE, SCOPES, TEST


@command("catkin_package")
def export_package(run: Evaluator, call: Call) -> None:
    """What a catkin package passes on to those that find it."""
    lists = ["INCLUDE_DIRS", "LIBRARIES", "CATKIN_DEPENDS", "DEPENDS", "CFG_EXTRAS", "EXPORTED_TARGETS"]
    words, _rest = parse_keywords(call.args, ["SKIP_CMAKE_CONFIG_GENERATION", "SKIP_PKG_CONFIG_GENERATION"], [], lists)
    draft = run.draft
    draft.include_dirs.extend(run.source_path(folder) for folder in words.get("INCLUDE_DIRS", []))
    draft.libraries.extend(words.get("LIBRARIES", []))
    draft.depends.extend(words.get("CATKIN_DEPENDS", []))
    draft.depends.extend(name for name in words.get("DEPENDS", []) if run.world.find(name) is not None)
    draft.cfg_extras.extend(words.get("CFG_EXTRAS", []))
    run.set(f"{run.project}_EXPORTED_TARGETS", f"{run.project}_EXPORTED_TARGETS")


_INTERFACES = {"msg": "message_files", "srv": "service_files", "action": "action_files"}
_COMMANDS = {"add_message_files": "msg", "add_service_files": "srv", "add_action_files": "action"}


@command(*_COMMANDS)
def _add_interface_files(run: Evaluator, call: Call) -> None:
    extension = _COMMANDS[call.name]
    words, unparsed = parse_keywords(call.args, ["NOINSTALL"], ["DIRECTORY", "BASE_DIR"], ["FILES"])
    folder = run.source_path((words.get("DIRECTORY") or [extension])[0])
    add_interface_files(run, call, extension, folder, [*words.get("FILES", []), *unparsed])


def add_interface_files(run: Evaluator, call: Call, extension: str, folder: str, names: list[str]) -> None:
    """Definitions of messages, services or actions in a folder; without names, all of them."""
    unreadable = partial(run.cannot_read, call.command)
    paths = [os.path.join(folder, name) for name in names] if names else glob(f"{folder}/*.{extension}", False, False, unreadable)
    for path in paths:
        if os.path.isfile(path):
            getattr(run.draft, _INTERFACES[extension]).append(path)
        else:
            run.complain(call.command, "missing-interface", f"no file {os.path.basename(path)} in {os.path.relpath(folder, run.folder)}")


@command("rosidl_generate_interfaces")
def _rosidl_generate_interfaces(run: Evaluator, call: Call) -> None:
    for word in call.args[1:]:
        path = run.source_path(word)
        for extension, attribute in _INTERFACES.items():
            if path.endswith(f".{extension}") and os.path.isfile(path):
                getattr(run.draft, attribute).append(path)


@command("generate_dynamic_reconfigure_options")
def _generate_dynamic_reconfigure_options(run: Evaluator, call: Call) -> None:
    for name in call.args:
        path = run.source_path(name)
        if os.path.isfile(path):
            run.draft.cfg_files.append(path)
        else:
            run.complain(call.command, "missing-interface", f"no file {name}")


@command("generate_parameter_library")
def _generate_parameter_library(run: Evaluator, call: Call) -> None:
    """A library of a header alone, made of a YAML file."""
    if len(call.args) < 2:
        return
    path = run.source_path(call.args[1])
    if os.path.isfile(path):
        run.draft.parameter_files.append((call.args[0], path))
    else:
        run.complain(call.command, "missing-interface", f"no file {call.args[1]}")
    add_target(run, call, call.args[0], INTERFACE, [])


@command("catkin_add_gtest", "catkin_add_gmock", "catkin_add_executable_with_gtest", "catkin_add_executable_with_gmock",
         "add_rostest_gtest", "add_rostest_gmock", "rosbuild_add_gtest", "ament_add_gtest", "ament_add_gmock",
         "ament_add_gtest_executable", "ament_auto_add_gtest", "ament_add_ros_isolated_gtest", "cuda_add_test")  # fmt: skip
def _add_gtest(run: Evaluator, call: Call) -> None:
    options = ["EXCLUDE_FROM_ALL", "SKIP_TEST", "SKIP_LINKING_MAIN_LIBRARIES"]
    words, sources = parse_keywords(
        call.args[1:], options, ["TIMEOUT", "WORKING_DIRECTORY", "RUNNER", "RESULT_FILE"], ["ENV", "APPEND_ENV"]
    )
    if not call.args or ("WORKING_DIRECTORY" in words and not sources):
        return
    sources = [name for name in sources if not name.endswith((".test", ".launch"))]
    add_target(run, call, call.args[0], TEST, sources)


@command("qt4_wrap_cpp", "qt5_wrap_cpp", "qt6_wrap_cpp", "qt_wrap_cpp", "qt4_wrap_ui", "qt5_wrap_ui", "qt6_wrap_ui", "qt_wrap_ui",
         "qt4_add_resources", "qt5_add_resources", "qt4_generate_moc", "qt5_generate_moc")  # fmt: skip
def _qt_wrap(run: Evaluator, call: Call) -> None:
    """The generated files have no source to read; only their names exist."""
    if not call.args:
        return
    outputs: list[str] = []
    for word in call.args[1:]:
        if word in ("OPTIONS", "TARGET"):
            break
        stem = os.path.splitext(os.path.basename(word))[0]
        outputs.append(run.binary_path(f"ui_{stem}.h" if call.name.endswith("ui") else f"moc_{stem}.cpp"))
    run.generated.update(outputs)
    run.set_list(call.args[0], [*run.elements(call.args[0]), *outputs])


# -- ament --------------------------------------------------------------------------------------------------------------------


@command("ament_target_dependencies")
def _ament_target_dependencies(run: Evaluator, call: Call) -> None:
    target = find_target(run, call)
    if target is None:
        return
    names = [word for word in call.args[1:] if word not in SCOPES]
    use_packages(run, call, names)
    target.uses_packages.extend(names)
    target.given_line = call.command.line


def use_packages(run: Evaluator, call: Call, names: list[str]) -> None:
    """Link a target with what packages export."""
    target = run.targets[run.aliases.get(call.args[0], call.args[0])]
    folders, libraries = exported(run, names)
    target.extend("INCLUDE_DIRECTORIES", folders)
    target.extend("LINK_LIBRARIES", libraries)


@command("ament_export_include_directories")
def _ament_export_include_directories(run: Evaluator, call: Call) -> None:
    run.draft.include_dirs.extend(run.source_path(folder) for folder in call.args if not folder.startswith("include/"))
    if os.path.isdir(f"{run.folder}/include") and f"{run.folder}/include" not in run.draft.include_dirs:
        run.draft.include_dirs.append(f"{run.folder}/include")


@command("ament_export_libraries")
def _ament_export_libraries(run: Evaluator, call: Call) -> None:
    run.draft.libraries.extend(call.args)


@command("ament_export_targets", "ament_export_interfaces")
def _ament_export_targets(run: Evaluator, call: Call) -> None:
    """The targets of export sets, which `install` may fill afterwards."""
    run.draft.exported_sets.extend(word for word in call.args if word != "HAS_LIBRARY_TARGET")


@command("ament_export_dependencies")
def _ament_export_dependencies(run: Evaluator, call: Call) -> None:
    run.draft.depends.extend(call.args)


@command("ament_auto_package")
def _ament_auto_package(run: Evaluator, call: Call) -> None:
    run.draft.depends.extend(run.manifest_depends)
    share = f"share/{run.project}"
    words, _rest = parse_keywords(call.args, ["USE_SCOPED_HEADER_INSTALL_DIR"], [], ["INSTALL_TO_PATH", "INSTALL_TO_SHARE"])
    copies = [(share, words.get("INSTALL_TO_SHARE", [])), (".", words.get("INSTALL_TO_PATH", []))]
    for destination, names in copies:
        run.draft.installs.extend(copied(installing(["DIRECTORY", *names, "DESTINATION", destination]), "/", run.directory.source))
    run.draft.installed_targets.extend((name, f"lib/{run.project}", None) for name in run.draft.auto_targets)
    if run.has_unset(call.command):
        run.unsure(f"{call.command.written}() with something that is not known", call.command.line)
    _ament_package(run, call)


@command("ament_package")
def _ament_package(run: Evaluator, call: Call) -> None:
    words, _rest = parse_keywords(call.args, [], ["CONFIG_EXTRAS_POST"], ["CONFIG_EXTRAS"])
    run.draft.cfg_extras.extend(words.get("CONFIG_EXTRAS", []))


def finish_ament(run: Evaluator) -> None:
    """What `ament_package` reads from variables, though a macro of another package may have called it; what export sets hold in the end."""
    exported = (name for set_ in run.draft.exported_sets for name in run.draft.export_sets.get(set_, ()))
    run.draft.libraries.extend(name for name in dict.fromkeys(exported) if name not in run.draft.libraries)
    run.draft.cfg_extras.extend(run.elements(f"{run.project}_CONFIG_EXTRAS"))


@command("rclcpp_components_register_node", "rclcpp_components_register_nodes")
def register_components(run: Evaluator, call: Call) -> None:
    """The classes that a library registers as components, with the program that is made of one."""
    words, rest = parse_keywords(call.args[1:], [], ["PLUGIN", "EXECUTABLE", "EXECUTOR", "RESOURCE_INDEX"], [])
    executable = (words.get("EXECUTABLE") or [""])[0]
    for plugin in [*words.get("PLUGIN", []), *(rest if call.name.endswith("s") else [])]:
        run.draft.component_nodes.append((call.args[0], plugin, executable, call.command.line))
    if executable:
        target = add_target(run, call, executable, EXECUTABLE, [])
        target.extend("LINK_LIBRARIES", [call.args[0]])
        run.draft.installed_targets.append((executable, f"lib/{run.project}", None))


@command("pluginlib_export_plugin_description_file")
def _export_plugins(run: Evaluator, call: Call) -> None:
    if len(call.args) > 1:
        run.draft.plugin_exports.append((call.args[0], run.source_path(call.args[1])))
        run.draft.installs.extend(
            copied(installing(["FILES", call.args[1], "DESTINATION", f"share/{run.project}"]), "/", run.directory.source)
        )


@command("find_dependency")
def _find_dependency(run: Evaluator, call: Call) -> None:
    if call.args:
        find_one(run, call.args[0])


@command("separate_arguments")
def _separate_arguments(run: Evaluator, call: Call) -> None:
    if len(call.args) == 1:
        run.set_list(call.args[0], (run.get(call.args[0]) or "").split())
    elif call.args:
        run.set_list(call.args[0], " ".join(word for word in call.args[1:] if not word.endswith("_COMMAND")).split())
