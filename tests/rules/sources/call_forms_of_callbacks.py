#!/usr/bin/env python3
# Services that return an answer or not, callbacks that are called where they should be given, and look-ups by a library that refuses slashes.
#
# expect: 2 = count : { answers_nothing(_, _) }
# expect: answers_nothing([_, "service_server", "go"], F), method_name(F, "go")
# expect: answers_nothing([_, "service_server", "marked"], F), method_name(F, "marked")
# expect: 1 = count : { callback_called(_) }
# expect: callback_called(C), call(C, "tick")
# expect: 1 = count : { refuses_slash(_) }
import functools

import rclpy
from rclpy.node import Node
from std_srvs.srv import Trigger
from tf2_ros import Buffer


def answering(function):
    @functools.wraps(function)
    def wrapper(self, request, response):
        function(self, request, response)
        return response

    return wrapper


class Demo(Node):
    def __init__(self):
        super().__init__("demo")
        self.create_service(Trigger, "go", self.go)
        self.create_service(Trigger, "stay", self.stay)
        self.create_service(Trigger, "short", lambda request, response: response)
        self.create_service(Trigger, "wrapped", self.wrapped)
        self.create_service(Trigger, "marked", self.marked)
        self.create_timer(1.0, self.tick())
        self.create_timer(1.0, self.tick)
        self.create_timer(1.0, self.made("x"))
        self.create_timer(1.0, self.later())
        self.buffer = Buffer()

    def go(self, request, response):
        response.success = True

    def stay(self, request, response):
        if request is None:
            return None
        return response

    @answering
    def wrapped(self, request, response):
        response.success = True

    @staticmethod
    def marked(request, response):
        response.success = True

    def tick(self):
        self.buffer.lookup_transform("/map", "odom", rclpy.time.Time())
        if self.buffer.can_transform("map", "odom", rclpy.time.Time()):
            return

    def made(self, name):
        return lambda: print(name)

    async def later(self):
        print("later")


rclpy.init()
rclpy.spin(Demo())
