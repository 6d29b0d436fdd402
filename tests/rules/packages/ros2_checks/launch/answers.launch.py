# expect: component asker_in_threads package=ros2_checks
from launch import LaunchDescription
from launch_ros.actions import ComposableNodeContainer, Node
from launch_ros.descriptions import ComposableNode


def container(name, executable):
    part = ComposableNode(package='ros2_checks', plugin='ros2_checks::Relay', name=name + '_relay')
    return ComposableNodeContainer(
        package='rclcpp_components', executable=executable, name=name, namespace='', composable_node_descriptions=[part])


def generate_launch_description():
    return LaunchDescription([
        Node(package='ros2_checks', executable='asker', name='asker'),
        Node(package='ros2_checks', executable='asker_in_threads', name='asker_in_threads'),
        Node(package='ros2_checks', executable='asking_script.py', name='script'),
        Node(package='ros2_checks', executable='slow', name='slow'),
        Node(package='ros2_checks', executable='slow_script.py', name='slow_script'),
        Node(package='ros2_checks', executable='managed', name='managed'),
        Node(package='ros2_checks', executable='managed_alone', name='managed_alone'),
        Node(package='ros2_checks', executable='managed_script.py', name='managed_script'),
        container('one', 'component_container'),
        container('many', 'component_container_mt'),
    ])
