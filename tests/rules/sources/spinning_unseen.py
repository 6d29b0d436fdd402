#!/usr/bin/env python3
# Code that was not seen has the node, and may spin it.
#
# expect-not: never_spun(_)
# expect: subscriber ready
import time

import kitchen
import rclpy
from std_msgs.msg import Bool

rclpy.init()
node = rclpy.create_node("cook")
sub = node.create_subscription(Bool, "ready", print, 10)
kitchen.serve(node)
while rclpy.ok():
    time.sleep(1.0)
