# expect-not: finding argument-without-use "*argument quiet *"
# expect-not: finding argument-without-use "*argument inner *"
# expect-not: finding argument-without-use "*argument plain *"
from launch import LaunchDescription
from launch.actions import IncludeLaunchDescription
from launch.substitutions import ThisLaunchFileDir
from launch_ros.actions import Node


def generate_launch_description():
    given = {'quiet': 'true', 'inner': '1', 'plain': '2', 'loud': 'true'}
    return LaunchDescription([
        Node(package='ros2_checks', executable='quality_sender.py', name='sender'),
        # expect: finding argument-without-use "*/reader.launch.py neither declares nor uses the argument loud that is passed to it"
        IncludeLaunchDescription([ThisLaunchFileDir(), '/reader.launch.py'], launch_arguments=given.items()),
    ])
