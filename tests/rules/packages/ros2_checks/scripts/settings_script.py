# Parameters of ROS 2 have one type, in Python as well.
# expect: 2 = count : { listed_parameter(_, _, _) }
# expect-not: parameter_of_any_type(_)
import rclpy
from rcl_interfaces.msg import ParameterDescriptor
from rclpy.node import Node
from rclpy.parameter import Parameter


class Settings(Node):
    def __init__(self):
        super().__init__('settings')
        self.declare_parameter('rate', 10.0)
        self.declare_parameter('size', 5)
        self.declare_parameter('gains', [1.0, 2.0])
        self.declare_parameter('name', 'settings')
        self.declare_parameter('verbose', False)
        self.declare_parameter('limit', Parameter.Type.DOUBLE)  # expect: param limit type=double op=declare
        self.declare_parameter('dynamic', 1, ParameterDescriptor(dynamic_typing=True))
        self.declare_parameter('any')
        self.declare_parameter('none', None)
        self.declare_parameters('', [('first', 1.0), ('second', 2)])
        self.rate = self.get_parameter('rate').value


def main():
    rclpy.init()
    rclpy.spin(Settings())


main()
