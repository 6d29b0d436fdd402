#!/usr/bin/env python3
# A program that only sleeps: none of its callbacks runs.
#
# expect: 3 = count : { never_spun(_) }
import time

import rclpy
from rclpy.node import Node
from std_msgs.msg import Bool
from std_srvs.srv import Trigger


class Cook(Node):
    def __init__(self):
        super().__init__("cook")
        self.sub = self.create_subscription(Bool, "ready", self.on_ready, 10)
        self.service = self.create_service(Trigger, "serve", self.on_serve)
        self.timer = self.create_timer(1.0, self.on_timer)
        self.pub = self.create_publisher(Bool, "served", 10)

    def on_ready(self, msg):
        self.pub.publish(msg)

    def on_serve(self, _request, response):
        return response

    def on_timer(self):
        pass


rclpy.init()
node = Cook()
while rclpy.ok():
    time.sleep(1.0)
