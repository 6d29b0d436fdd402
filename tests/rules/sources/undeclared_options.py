#!/usr/bin/env python3
# A node that allows parameters that nobody declares.
#
# expect-not: undeclared_read(_, _, _)
# expect: parameter_access(_, "read", "rate")
import rclpy
from rclpy.node import Node


class Driver(Node):
    def __init__(self):
        super().__init__("driver", allow_undeclared_parameters=True)
        self.rate = self.get_parameter("rate").value


rclpy.init()
rclpy.spin(Driver())
