# expect-not: finding parameter-type "*/other*"
# expect-not: finding parameter-type "*/any*"
# expect-not: finding parameter-type "*/dynamic*"
from launch import LaunchDescription
from launch_ros.actions import Node


def generate_launch_description():
    wrong = {'rate': 10, 'size': 5.0, 'gains': [1, 2], 'name': 7, 'frame': True, 'verbose': 1, 'limit': 5, 'step': 2}
    right = {'any': 2.0, 'dynamic': 2.0, 'other': 5}
    return LaunchDescription([
        # expect: finding parameter-type "the parameter /settings/rate is the int 10, but /settings reads a double"
        # expect: finding parameter-type "*/settings/size is the double 5.0*reads a int"
        # expect: finding parameter-type "*/settings/gains is the list *, but *reads a std::vector<double>"
        # expect: finding parameter-type "*/settings/name is the int 7*reads a string"
        # expect: finding parameter-type "*/settings/frame is the bool true*reads a string"
        # expect: finding parameter-type "*/settings/verbose is the int 1*reads a bool"
        # expect: finding parameter-type "*/settings/limit is the int 5*reads a double"
        # expect: finding parameter-type "*/settings/step is the int 2*reads a double"
        Node(package='ros2_checks', executable='settings', name='settings', parameters=[wrong, right]),
        Node(package='ros2_checks', executable='pair', parameters=[{'side': 'inner'}]),
        # expect: finding parameter-type "*/script/rate*reads a double"
        # expect: finding parameter-type "*/script/size*reads a int"
        # expect: finding parameter-type "*/script/name*reads a string"
        # expect: finding parameter-type "*/script/verbose*reads a bool"
        # expect: finding parameter-type "*/script/limit*reads a double"
        Node(package='ros2_checks', executable='settings_script.py', name='script', parameters=[wrong, right]),
    ])
