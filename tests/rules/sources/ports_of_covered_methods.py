#!/usr/bin/env python3
# An attribute that is given the name of an inherited method takes its place when it is set: what is called before is the method.
#
# expect: subscriber in
# expect: publisher out
import rclpy
from rclpy.node import Node
from std_msgs.msg import Float32


class Meter(Node):
    def __init__(self):
        super().__init__("meter")
        self.total = 0.0
        self.sub = self.create_subscription(Float32, "in", self.on, 10)
        self.pub = self.create_subscription = self.create_publisher(Float32, "out", 10)
        self.timer = self.create_timer(1, self.tick)

    def on(self, msg):
        self.total = msg.data

    def tick(self):
        self.pub.publish(Float32(data=self.total))


rclpy.init()
rclpy.spin(Meter())
