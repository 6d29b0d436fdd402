# expect: component filler package=python_calls
from launch import LaunchDescription
from launch_ros.actions import Node


def generate_launch_description():
    return LaunchDescription([
        Node(package='python_calls', executable='filler.py', name='filler'),
        Node(package='python_calls', executable='sound.py', name='sound'),
    ])
