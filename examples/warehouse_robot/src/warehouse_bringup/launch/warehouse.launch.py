"""Start the robots of a warehouse, each in a namespace of its own."""

import os

from ament_index_python.packages import get_package_share_directory
from launch import LaunchDescription
from launch.actions import DeclareLaunchArgument, GroupAction, IncludeLaunchDescription, OpaqueFunction
from launch.conditions import IfCondition
from launch.launch_description_sources import AnyLaunchDescriptionSource
from launch.substitutions import LaunchConfiguration, PathJoinSubstitution
from launch_ros.actions import Node, PushRosNamespace
from launch_ros.substitutions import FindPackageShare
import yaml


def robots(context):
    """Start as many robots as are asked for."""
    share = get_package_share_directory('warehouse_bringup')
    with open(os.path.join(share, 'config', 'fleet.yaml')) as stream:
        names = yaml.safe_load(stream)['robots']
    count = int(LaunchConfiguration('count').perform(context))
    return [robot(name) for name in names[:count]]


def robot(name):
    """Start the nodes of one robot."""
    base = PathJoinSubstitution([FindPackageShare('warehouse_bringup'), 'launch', 'base.launch.xml'])
    return GroupAction([
        PushRosNamespace(name),
        IncludeLaunchDescription(
            AnyLaunchDescriptionSource(base),
            launch_arguments={'max_speed': LaunchConfiguration('max_speed')}.items(),
        ),
        Node(
            package='warehouse_nodes',
            executable='shelf_carrier',
            name='carrier',
            parameters=[{'lift_height': 0.25}],
            remappings=[('speed', 'base/speed')],
            condition=IfCondition(LaunchConfiguration('carry')),
        ),
    ])


def generate_launch_description():
    """Log what is started."""
    return LaunchDescription([
        DeclareLaunchArgument('count', default_value='2'),
        DeclareLaunchArgument('max_speed', default_value='1.2'),
        DeclareLaunchArgument('carry', default_value='true', choices=['true', 'false']),
        OpaqueFunction(function=robots),
    ])
