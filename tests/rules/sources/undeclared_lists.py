#!/usr/bin/env python3
# Names that are declared and not known may be any.
#
# expect-not: undeclared_read(_, _, _)
# expect: parameter_access(_, "read", "rate")
import sys

import rclpy
from rclpy.node import Node


class Driver(Node):
    def __init__(self):
        super().__init__("driver")
        for name in sys.argv[1:]:
            self.declare_parameter(name, 1.0)
        self.rate = self.get_parameter("rate").value


rclpy.init()
rclpy.spin(Driver())
