from launch import LaunchDescription
from launch_ros.actions import ComposableNodeContainer
from launch_ros.descriptions import ComposableNode


def generate_launch_description():
    return LaunchDescription([
        ComposableNodeContainer(
            package='rclcpp_components', executable='component_container_mt', name='container', namespace='', composable_node_descriptions=[
                ComposableNode(package='ros2_checks', plugin='ros2_checks::Relay', name='first'),
                ComposableNode(package='ros2_checks', plugin='checks::Relay', name='second'),  # expect: finding missing-component "the package ros2_checks registers no component checks::Relay"
                ComposableNode(package='image_proc', plugin='image_proc::Rectify', name='third'),
            ]),
    ])
