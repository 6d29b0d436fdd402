# Values outside of the ranges of descriptors, and at their ends.
# expect-not: finding parameter-out-of-range "/ok*"
# expect-not: finding parameter-out-of-range "/cok*"
from launch import LaunchDescription
from launch_ros.actions import Node
def generate_launch_description():
    return LaunchDescription([
        # expect: finding parameter-out-of-range "/n/d3 is set to 2, but /n declares it with a range from -1 to 1"
        # expect: finding parameter-out-of-range "/n/speed is*from 0.0 to 5.0"
        # expect: finding parameter-out-of-range "/n/turn is*from 0 to 5"
        Node(package='parameter_ranges', executable='n.py', parameters=[{'speed': 7.0, 'turn': 9, 'd3': 2}]),
        # expect: finding parameter-out-of-range "/c/d3 is*"
        # expect: finding parameter-out-of-range "/c/speed is*"
        # expect: finding parameter-out-of-range "/c/turn is set to -3*from -2 to 2"
        Node(package='parameter_ranges', executable='c', parameters=[{'speed': 7.0, 'turn': -3, 'd3': 6.0}]),
        Node(package='parameter_ranges', executable='n.py', name='ok', parameters=[{'speed': 5.0, 'turn': 0, 'd3': -1}]),
        Node(package='parameter_ranges', executable='c', name='cok', parameters=[{'speed': 0.0, 'turn': -2, 'd3': 3.0}]),
    ])
