"""What is assumed of the machine a workspace would be built on.

`kinetic` is the default ROS 1 distribution: most ROS 1 C++ code was written for it or still builds on it, and it has C++11, OpenCV 3
and PCL 1.7. Workspaces with ament packages get `humble`. Versions are those of the distribution's Ubuntu release (REP 3, REP 2000).
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field

from rosarch.base.limits import SOURCE_SECONDS

DEFAULT_DISTRO = "kinetic"
DEFAULT_AMENT_DISTRO = "humble"
ROS1_DISTROS = frozenset(("hydro", "indigo", "jade", "kinetic", "lunar", "melodic", "noetic"))
"""The distributions of ROS 1 with catkin; all others are of ROS 2."""

_COLUMNS = ("CMake", "GCC", "OpenCV", "PCL", "Eigen3", "Boost", "Qt5", "gazebo", "CUDA", "Python", "yaml-cpp")
_VERSIONS = {
    "indigo": ("2.8.12", "4.8.4", "2.4.8", "1.7.2", "3.2.0", "1.54.0", "5.2.1", "2.2.3", "7.5", "2.7", "0.5.1"),
    "kinetic": ("3.5.1", "5.4.0", "3.3.1", "1.7.2", "3.2.92", "1.58.0", "5.5.1", "7.0.0", "9.0", "2.7", "0.5.2"),
    "melodic": ("3.10.2", "7.5.0", "3.2.0", "1.8.1", "3.3.4", "1.65.1", "5.9.5", "9.0.0", "10.0", "2.7", "0.5.2"),
    "noetic": ("3.16.3", "9.4.0", "4.2.0", "1.10.0", "3.3.7", "1.71.0", "5.12.8", "11.0.0", "11.0", "3.8", "0.6.2"),
    "humble": ("3.22.1", "11.4.0", "4.5.4", "1.12.1", "3.4.0", "1.74.0", "5.15.3", "11.10.0", "11.8", "3.10", "0.7.0"),
    "jazzy": ("3.28.3", "13.2.0", "4.6.0", "1.14.0", "3.4.0", "1.83.0", "5.15.13", "11.14.0", "12.4", "3.12", "0.8.0"),
}

# the first major version of GCC that CMake takes to know a standard (its Modules/Compiler/GNU-CXX.cmake)
_STANDARDS = {"98": 4, "11": 4, "14": 4, "17": 5, "20": 8, "23": 11}


@dataclass(frozen=True)
class Options:
    """`defines` are cache variables (`-D`) and override what is assumed of `find_package`; `ros_distro` None means the default.

    `timeout` is the limit in seconds for the CMake code of one package.
    """

    ros_distro: str | None = None
    defines: Mapping[str, str] = field(default_factory=dict)
    environment: Mapping[str, str] = field(default_factory=dict)
    timeout: float = SOURCE_SECONDS


def versions(distro: str) -> dict[str, str]:
    """Versions of tools and libraries in a distribution; an unknown one is taken as the default."""
    return dict(zip(_COLUMNS, _VERSIONS.get(distro, _VERSIONS[DEFAULT_DISTRO]), strict=True))


def initial_variables(distro: str, build: str) -> dict[str, str]:
    """CMake's variables on Linux with GCC, in a shell where the distribution's setup file was sourced.

    Of ROS 1, with those that `catkin_make` and `catkin build` give on the command line, for the folder `build`.
    """
    known = versions(distro)
    major, minor, patch = known["CMake"].split(".")
    gcc = int(known["GCC"].partition(".")[0])
    return {
        "CMAKE_VERSION": known["CMake"],
        "CMAKE_MAJOR_VERSION": major,
        "CMAKE_MINOR_VERSION": minor,
        "CMAKE_PATCH_VERSION": patch,
        "CMAKE_SYSTEM_NAME": "Linux",
        "CMAKE_HOST_SYSTEM_NAME": "Linux",
        "CMAKE_SYSTEM": "Linux",
        "CMAKE_SYSTEM_PROCESSOR": "x86_64",
        "CMAKE_HOST_SYSTEM_PROCESSOR": "x86_64",
        "CMAKE_SIZEOF_VOID_P": "8",
        "CMAKE_GENERATOR": "Unix Makefiles",
        "CMAKE_COMMAND": "/usr/bin/cmake",
        "CMAKE_CXX_COMPILER": "/usr/bin/c++",
        "CMAKE_C_COMPILER": "/usr/bin/cc",
        "CMAKE_CXX_COMPILER_ID": "GNU",
        "CMAKE_C_COMPILER_ID": "GNU",
        "CMAKE_CXX_COMPILER_VERSION": known["GCC"],
        "CMAKE_C_COMPILER_VERSION": known["GCC"],
        "CMAKE_CXX_COMPILE_FEATURES": ";".join(f"cxx_std_{standard}" for standard, first in _STANDARDS.items() if gcc >= first),
        "CMAKE_CXX_COMPILER_LOADED": "1",
        "CMAKE_C_COMPILER_LOADED": "1",
        "CMAKE_COMPILER_IS_GNUCXX": "1",
        "CMAKE_COMPILER_IS_GNUCC": "1",
        "CMAKE_SHARED_LIBRARY_PREFIX": "lib",
        "CMAKE_SHARED_LIBRARY_SUFFIX": ".so",
        "CMAKE_STATIC_LIBRARY_PREFIX": "lib",
        "CMAKE_STATIC_LIBRARY_SUFFIX": ".a",
        "CMAKE_DL_LIBS": "dl",
        "CMAKE_ROOT": "/usr/share/cmake",
        "CMAKE_CFG_INTDIR": ".",
        "UNIX": "1",
        "LINUX": "1",
        "CATKIN_ENABLE_TESTING": "1",
        "BUILD_TESTING": "1",
        **({"CATKIN_DEVEL_PREFIX": f"{build}/devel"} if distro in ROS1_DISTROS else {}),
    }


def initial_cache(distro: str, defines: Mapping[str, str]) -> dict[str, str]:
    """The cache of CMake before `CMakeLists.txt` runs: what is passed to it by option, as the tools that build workspaces do."""
    return {"CMAKE_INSTALL_PREFIX": f"/opt/ros/{distro}", **defines}


def initial_environment(distro: str) -> dict[str, str]:
    """Environment variables of such a shell."""
    return {
        "ROS_DISTRO": distro,
        "ROS_VERSION": "1" if distro in ROS1_DISTROS else "2",
        "ROS_ROOT": f"/opt/ros/{distro}/share/ros",
        "HOME": "/home/user",
        "USER": "user",
    }
