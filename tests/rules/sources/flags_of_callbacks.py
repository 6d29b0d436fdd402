#!/usr/bin/env python3
# Callbacks that loop until another callback has run, in one thread. Others look at the clock, spin meanwhile, or change the variable themselves; coroutines give way.
#
# expect: loops_for_callback(_, "ready")
# expect: loops_for_callback(_, "messages")
# expect: 2 = count : { loops_for_callback(_, _) }
import time

import rclpy
from rclpy.node import Node
from std_msgs.msg import Bool
from std_srvs.srv import Trigger


class Cook(Node):
    def __init__(self):
        super().__init__("cook")
        self.ready = False
        self.limited = False
        self.seen = False
        self.rounds = 0
        self.awaited = False
        self.messages = []
        self.sub = self.create_subscription(Bool, "ready", self.on_ready, 10)
        self.service = self.create_service(Trigger, "serve", self.on_serve)
        self.other = self.create_service(Trigger, "limited", self.on_limited)
        self.third = self.create_service(Trigger, "coroutine", self.on_coroutine)

    def on_ready(self, msg):
        self.ready = msg.data
        self.limited = True
        self.seen = True
        self.rounds = 0
        self.awaited = True
        self.messages = [msg]

    def on_serve(self, _request, response):
        self.ready = False
        while not self.ready and rclpy.ok():
            time.sleep(0.05)
        self.gather()
        return response

    def gather(self):
        while len(self.messages) == 0:
            self.get_logger().info("waiting")

    def on_limited(self, _request, response):
        end = time.time() + 1.0
        while not self.limited and time.time() < end:
            time.sleep(0.05)
        while not self.seen:
            if time.time() > end:
                break
        while self.rounds < 3:
            self.count()
        return response

    def count(self):
        self.rounds += 1

    async def on_coroutine(self, _request, response):
        while not self.awaited:
            time.sleep(0.05)
        return response


rclpy.init()
rclpy.spin(Cook())
