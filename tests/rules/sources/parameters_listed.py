#!/usr/bin/env python3
# Parameters that are declared, or asked for, several at once.
#
# expect: param speed = 0.5 op=declare
# expect: param frame = base op=declare
# expect: param gains = "[1.0, 2.0]" op=declare
# expect: param bare op=declare
# expect: param held = 3 op=declare
# expect: param out.rate = 5 op=declare
# expect: param out.label op=declare
# expect: param speed op=read
# expect: param frame op=read
# expect-only: param
# expect: publisher base
# expect: 5 = count : { listed_parameter(_, _, _) }
import rclpy
from rclpy.node import Node
from std_msgs.msg import String

HELD = [("held", 3)]


class Arm(Node):
    def __init__(self):
        super().__init__("arm")
        self.declare_parameters("", [("speed", 0.5), ("frame", "base"), ("gains", [1.0, 2.0]), ("bare",)])
        self.declare_parameters(namespace="", parameters=HELD)
        self.declare_parameters("out", [("rate", 5), ("label",)])
        self.limits = self.get_parameters(["speed", "frame"])
        self.create_publisher(String, "base", 1)


rclpy.init()
rclpy.spin(Arm())
