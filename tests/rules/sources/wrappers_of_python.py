#!/usr/bin/env python3
# Functions of Python that make ports for others: what the call gives belongs to the name that it gives.
#
# expect: publisher names std_msgs/String
# expect: publisher number std_msgs/Int32
# expect: publisher text std_msgs/String
# expect: publisher keyword std_msgs/Bool
# expect: publisher twice std_msgs/UInt8
# expect: subscriber level std_msgs/Float32 callback=Hub::on_level
# expect: subscriber count std_msgs/Int32 callback=Hub::on_count
# expect: subscriber bound std_msgs/Int32 callback=Hub::on_bound
# expect: subscriber lambda std_msgs/Int32
# expect: subscriber through std_msgs/UInt8 callback=Hub::on_through
# expect: publisher /rosout rcl_interfaces/Log
# expect: publisher /parameter_events rcl_interfaces/ParameterEvent
# expect-only: publisher
# expect-only: subscriber
# expect: reactive level -> names
# expect: reactive count -> number
# expect: reactive bound -> text
# expect-only: reactive
from functools import partial

import rclpy
from rclpy.node import Node
from std_msgs.msg import Bool, Float32, Int32, String, UInt8


class Hub(Node):
    def __init__(self):
        super().__init__("hub")
        self.names = self.out("names", String)
        self.number = self.out("number", Int32)
        self.text = self.named("text")
        self.keyword = self.out(kind=Bool, name="keyword")
        self.twice = self.out_twice("twice", UInt8)
        self.listen(Float32, "level", self.on_level)
        self.listen(Int32, "count", self.on_count)
        self.listen(Int32, "bound", partial(self.on_bound, 1))
        self.listen(Int32, "lambda", lambda message: None)
        self.listen_further(UInt8, "through", self.on_through)

    def out(self, name, kind):
        return self.create_publisher(kind, name, 10)

    def out_twice(self, name, kind):
        return self.out(name, kind)

    def named(self, name):
        return self.create_publisher(String, name, 3)

    def listen(self, kind, name, callback):
        self.create_subscription(kind, name, callback, 7)

    def listen_further(self, kind, name, callback):
        self.listen(kind, name, callback)

    def on_level(self, message):
        self.names.publish(String())

    def on_count(self, message):
        self.number.publish(Int32())

    def on_bound(self, number, message):
        self.text.publish(String())

    def on_through(self, message):
        pass


def main():
    rclpy.init()
    rclpy.spin(Hub())


main()
