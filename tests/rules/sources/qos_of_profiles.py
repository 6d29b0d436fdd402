#!/usr/bin/env python3
# Times in qualities of service of rclpy, and depths that are set later.
#
# expect: port_quality([_, _, "profile"], "deadline", "(0.5)/(1.0)")
# expect: port_quality([_, _, "profile"], "lease_duration", "(250000000)/(1000000000.0)")
# expect: port_quality([_, _, "changed"], "lifespan", "(3)/(1.0)")
# expect: port_quality([_, _, "asked"], "deadline", "unknown")
# expect: publisher changed queue=7
# expect: N = count : { port_quality(_, Policy, _), match("deadline|lifespan|lease_duration", Policy) }, N = 4
import sys

import rclpy
from rclpy.duration import Duration
from rclpy.node import Node
from rclpy.qos import QoSProfile
from std_msgs.msg import Bool

DEPTH = 7


class Talker(Node):
    def __init__(self, limit):
        super().__init__("talker")
        profile = QoSProfile(depth=1, deadline=Duration(seconds=0.5), liveliness_lease_duration=Duration(nanoseconds=250000000))
        self.profile = self.create_publisher(Bool, "profile", profile)
        changed = QoSProfile(depth=5)
        changed.depth = DEPTH
        changed.lifespan = Duration(seconds=3)
        self.changed = self.create_publisher(Bool, "changed", changed)
        self.asked = self.create_publisher(Bool, "asked", QoSProfile(depth=2, deadline=Duration(seconds=limit)))
        self.none = self.create_publisher(Bool, "none", 3)


def main():
    rclpy.init()
    rclpy.spin(Talker(float(sys.argv[1])))


if __name__ == "__main__":
    main()
