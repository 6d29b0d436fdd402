#!/usr/bin/env python3
# Numbers that are calculated: of what is not known nothing is said, a part that is broken makes a broken number.
#
# expect: param width = 12 type=int
# expect: param share type=double
# expect: param angle
# expect-not: parameter_access_type(_, "angle", _)
import absent
import rclpy
from rclpy.node import Node


class Drive(Node):
    def __init__(self):
        super().__init__("drive")
        self.declare_parameter("width", 3 * 4)
        self.declare_parameter("share", 1.0 / 2)
        self.declare_parameter("angle", 110 * absent.pi / 180)


rclpy.init()
rclpy.spin(Drive())
