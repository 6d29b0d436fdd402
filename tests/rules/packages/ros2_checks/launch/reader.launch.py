# Arguments that the file declares, that a file it includes declares, that it uses without a declaration.
# expect: component quality_reader package=ros2_checks
from launch import LaunchDescription
from launch.actions import DeclareLaunchArgument, IncludeLaunchDescription
from launch.substitutions import LaunchConfiguration, ThisLaunchFileDir
from launch_ros.actions import Node


def generate_launch_description():
    return LaunchDescription([
        DeclareLaunchArgument('quiet', default_value='false'),
        IncludeLaunchDescription([ThisLaunchFileDir(), '/nothing.launch.py']),
        Node(package='ros2_checks', executable='quality_reader.py', name='reader', arguments=[LaunchConfiguration('plain', default='')]),
    ])
