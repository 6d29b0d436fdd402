"""Launch files: what roslaunch would start and set, without running anything.

`compose` reads a launch file as roslaunch's loader does and gives the nodes it would start, the parameters it would set and
everything that it would reject or that cannot be known, with the launch lines of each. What cannot be known (an environment variable that
is not set, a package that is not there) stays in the texts as the `$(...)` that was not resolved.

Those of ROS 2 are read by `rosarch.extractor.launch_ros2`, and come to the same.

Sources: the roslaunch XML format (wiki.ros.org/roslaunch/XML) and the behaviour of roslaunch 1.15.
"""

from rosarch.extractor.launch.files import Files
from rosarch.extractor.launch.model import Composition, Condition, NodeStart, ParamSetting, Place, Problem, Remap
from rosarch.extractor.launch.packages import PackagePath
from rosarch.extractor.launch.record import record
from rosarch.extractor.launch.top_level import launch_files, top_level
from rosarch.extractor.launch.versions import compose, ros_version

__all__ = [
    "Composition",
    "Condition",
    "Files",
    "NodeStart",
    "PackagePath",
    "ParamSetting",
    "Place",
    "Problem",
    "Remap",
    "compose",
    "launch_files",
    "record",
    "ros_version",
    "top_level",
]
