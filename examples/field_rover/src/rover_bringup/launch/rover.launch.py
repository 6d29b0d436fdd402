from launch import LaunchDescription
from launch.actions import DeclareLaunchArgument, IncludeLaunchDescription
from launch.conditions import IfCondition, UnlessCondition
from launch.substitutions import Command, LaunchConfiguration, PathJoinSubstitution
from launch_ros.actions import Node
from launch_ros.parameter_descriptions import ParameterValue
from launch_ros.substitutions import FindPackageShare


def in_package(*parts):
    return PathJoinSubstitution([FindPackageShare("rover_bringup"), *parts])


def generate_launch_description():
    simulation = LaunchConfiguration("simulation")
    description = Command(["xacro ", in_package("urdf", "rover.urdf.xacro"), " simulation:=", simulation])
    robot = {"robot_description": ParameterValue(description, value_type=str)}
    clock = {"use_sim_time": simulation}

    def spawn(*controllers):
        return Node(package="controller_manager", executable="spawner", arguments=[*controllers])

    return LaunchDescription([
        DeclareLaunchArgument("simulation", default_value="true", choices=["true", "false"]),
        Node(package="robot_state_publisher", executable="robot_state_publisher", parameters=[robot, clock]),
        # The simulator has the controller manager, the real rover starts its own.
        Node(
            package="controller_manager",
            executable="ros2_control_node",
            parameters=[robot, in_package("config", "controllers.yaml")],
            condition=UnlessCondition(simulation),
        ),
        Node(
            package="ros_gz_sim",
            executable="create",
            arguments=["-world", "field", "-topic", "robot_description", "-name", "rover"],
            condition=IfCondition(simulation),
        ),
        Node(
            package="ros_gz_bridge",
            executable="parameter_bridge",
            name="bridge",
            parameters=[{"config_file": in_package("config", "bridge.yaml")}],
            condition=IfCondition(simulation),
        ),
        spawn("wheels", "joints"),
        Node(
            package="twist_mux",
            executable="twist_mux",
            name="commands",
            parameters=[in_package("config", "commands.yaml"), clock],
            remappings=[("cmd_vel_out", "wheels/cmd_vel_unstamped")],
        ),
        Node(
            package="robot_localization",
            executable="ekf_node",
            name="filter",
            parameters=[in_package("config", "filter.yaml"), clock],
        ),
        Node(package="rover_nodes", executable="keeper", parameters=[clock]),
        IncludeLaunchDescription(
            PathJoinSubstitution([FindPackageShare("nav2_bringup"), "launch", "navigation_launch.py"]),
            launch_arguments={"use_sim_time": simulation}.items(),
        ),
    ])
