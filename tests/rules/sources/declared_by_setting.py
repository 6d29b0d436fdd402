# A parameter that the options of a node declare when it is set, and its constructor declares again.
#
# expect: 1 = count : { declared_by_setting(_, _) }
# expect: declared_by_setting(_, "gain")
import rclpy
from rclpy.node import Node


class Gain(Node):
    def __init__(self):
        super().__init__("gain", allow_undeclared_parameters=True, automatically_declare_parameters_from_overrides=True)
        self.declare_parameter("gain", 1.0)
        if not self.has_parameter("offset"):
            self.declare_parameter("offset", 0.0)


rclpy.init()
rclpy.spin(Gain())
