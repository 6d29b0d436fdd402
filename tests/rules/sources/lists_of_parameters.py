#!/usr/bin/env python3
# Parameters whose default is a list.
#
# expect: param gains = "[1.0, -2.5]"
# expect: param joints = "[hip, knee]"
# expect: param nothing = "[]"
# expect: param wrapped = "[1, 2]"
# expect: param single = 3
# expect: 23 = count : { evaluable(_) }, 4 = count : { list_text(_, _, _) }
import rclpy
from rclpy.node import Node

LIMIT = 2.5


class Arm(Node):
    def __init__(self):
        super().__init__("arm")
        self.declare_parameter("gains", [1.0, -LIMIT])
        self.declare_parameter("joints", ["hip", "knee"])
        self.declare_parameter("nothing", [])
        self.ask("wrapped", [1, 2])
        self.declare_parameter("single", 3)

    def ask(self, name, default):
        return self.declare_parameter(name, default).value


rclpy.init()
rclpy.spin(Arm())
