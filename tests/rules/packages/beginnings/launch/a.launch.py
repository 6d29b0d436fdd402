# Programs that do what comes first too late, or not at all, and one that does not.
from launch import LaunchDescription
from launch_ros.actions import Node
def generate_launch_description():
    # expect: component good1 package=beginnings
    return LaunchDescription([Node(package='beginnings', executable=n) for n in ['bad1', 'bad2', 'bad3', 'good1', 'noinit.py', 'nosuper.py', 'late.py', 'spin2.py', 'good.py', 'placed_in_cpp', 'placed.py']] + [
       Node(package='tf2_ros', executable='static_transform_publisher', arguments=['0', '0', '0', '0', '0', '0', 'base', 'base']),  # expect: finding frame-of-itself "*from the frame base to itself, which tf ignores"
       Node(package='tf2_ros', executable='static_transform_publisher', arguments=['--frame-id', 'base', '--child-frame-id', 'base']),  # expect: finding frame-of-itself "*the frame base to itself*"
       Node(package='tf2_ros', executable='static_transform_publisher', arguments=['--frame-id', 'base', '--child-frame-id', 'base2']),
    ])
