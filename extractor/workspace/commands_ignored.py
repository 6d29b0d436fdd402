"""Commands that are known and have no meaning for what is compiled into what: installation, packaging, linters, test runners, rosbuild."""

from __future__ import annotations

from rosarch.extractor.workspace.cmake_state import Call
from rosarch.extractor.workspace.evaluator import Evaluator, command

_NAMES = """
cmake_minimum_required cmake_policy enable_testing include_guard include_regular_expression export mark_as_advanced
source_group variable_watch site_name build_command add_test set_tests_properties add_custom_target add_link_options link_directories
target_link_directories target_link_options target_compile_features target_precompile_headers define_property include_external_msproject
ctest_start fltk_wrap_ui load_cache find_package_message feature_summary set_package_properties
make_directory write_file
catkin_python_setup catkin_metapackage catkin_add_nosetests catkin_add_env_hooks catkin_download_test_data
catkin_download catkin_workspace catkin_run_tests_target catkin_add_custom_target catkin_generate_environment catkin_stack
catkin_package_xml catkin_destinations cs_add_targets_to_package
generate_messages add_rostest roslaunch_add_file_check roslint_cpp roslint_python roslint_custom roslint_add_test rosdoc_lite
ament_export_definitions ament_export_link_flags
ament_lint_auto_find_test_dependencies
ament_add_test ament_add_pytest_test ament_python_install_module ament_environment_hooks ament_uncrustify
ament_cpplint ament_cppcheck ament_copyright ament_flake8 ament_pep257 ament_lint_cmake ament_xmllint ament_index_register_resource
ament_index_get_resource ament_register_extension rosidl_target_interfaces rosidl_get_typesupport_target add_launch_test add_ros_test
add_ros_isolated_launch_test
rosbuild_init rosbuild_genmsg rosbuild_gensrv rosbuild_add_boost_directories rosbuild_link_boost rosbuild_add_rostest rosbuild_add_pyunit
rosbuild_add_compile_flags rosbuild_add_link_flags rosbuild_add_openmp_flags rosbuild_add_gtest_build_flags rosbuild_check_for_sse
rosbuild_find_ros_package
cuda_include_directories cuda_add_cublas_to_target cuda_add_cufft_to_target cuda_select_nvcc_arch_flags cuda_build_clean_target
doxygen_add_docs git_describe set_and_check gtest_discover_tests gtest_add_tests write_basic_package_version_file
configure_package_config_file generate_export_header check_required_components processorcount
fetchcontent_declare
"""


@command(*_NAMES.split())
def _no_effect(_run: Evaluator, _call: Call) -> None:
    """Nothing to record."""


@command("install_files", "install_programs", "install_targets", "cs_install", "autoware_ament_auto_package", "externalproject_add",
         "fetchcontent_makeavailable")  # fmt: skip
def _installs(run: Evaluator, call: Call) -> None:
    """What these install is not followed."""
    run.unsure(f"{call.command.written}()", call.command.line)
