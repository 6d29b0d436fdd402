#!/usr/bin/env python3
# A thread spins, though nothing calls what it runs by name.
#
# expect-not: never_spun(_)
# expect: subscriber ready
import threading
import time

import rclpy
from std_msgs.msg import Bool

rclpy.init()
node = rclpy.create_node("cook")
sub = node.create_subscription(Bool, "ready", print, 10)
threading.Thread(target=rclpy.spin, args=(node,)).start()
while rclpy.ok():
    time.sleep(1.0)
